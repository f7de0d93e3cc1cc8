"""Reading a definition's keys: lengths, directions and names beside what every file of keys holds.

A reader notes what the keys may hold that it is asked for: these a page offers on which exercises are made.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum, auto
from fractions import Fraction
from typing import Any, ClassVar

from kinematics.cells import AngleUnit, Cell, ParameterKind, canonical_name, read_cell
from kinematics.errors import Fault
from kinematics.expressions import ZERO, Expression, joint_variables_in
from kinematics.keys import LARGEST, MISSING, Choice, KeyFaults, KeyReader, ValueKind, is_number
from kinematics.se3 import triple

LONGEST_ECHO = 80  # Characters of a text that its fault repeats.
LARGEST_TOLERANCE = 0.1
"""With more, a tenth of a robot's size or 6° off, an answer would pass that nobody calls right."""


class KeyShape(StrEnum):
    """What the value of a key looks like.

    NUMBER: a number. TEXT: a text. CHOICE: one of some words. CHOICES: some of them. NUMBERS: a number for
    each label. CELLS: a number or a name for each label. DRAW: from where a student's own value is drawn.
    POINT: the name of a point of the figure. FRAMES: from a frame to another. FRAME_PAIRS: several of these.
    RANGES: for each label the least and the greatest value, or none; or the word `catalogue`.
    BODIES: for each row mass, centre and moments of what moves with it. QUANTITIES: by name a value, and from
    where a student's own is drawn.
    """

    NUMBER = auto()
    TEXT = auto()
    CHOICE = auto()
    CHOICES = auto()
    NUMBERS = auto()
    CELLS = auto()
    DRAW = auto()
    POINT = auto()
    FRAMES = auto()
    FRAME_PAIRS = auto()
    RANGES = auto()
    BODIES = auto()
    QUANTITIES = auto()


@dataclass(frozen=True, kw_only=True, slots=True)
class DefinitionKey:
    """A key of a part's definition.

    Attributes:
        name: it; what it is called is the message `key-<name>`.
        shape: what its value looks like.
        labels: what the entries of a list are called.
        options: what may be chosen; their names are the messages `choice-<option>`.
    """

    name: str
    shape: KeyShape
    labels: tuple[str, ...] = ()
    options: tuple[str, ...] = ()


class Reader(KeyReader):
    """A table of keys of an exercise's definition; keys that nobody asks for are faults.

    Attributes:
        noted: what the keys may hold that were asked for, as far as it was noted.
    """

    codes: ClassVar[KeyFaults] = KeyFaults(
        missing="exercise_key_missing",
        unknown="exercise_key_unknown",
        mistyped="exercise_value_type",
        unlisted="exercise_value_unknown",
    )

    def __init__(self, values: Mapping[str, Any], where: tuple[str | int, ...], faults: list[Fault]) -> None:
        super().__init__(values, where, faults)
        self.noted: dict[str, DefinitionKey] = {}

    def note(
        self, key: str, shape: KeyShape, labels: Iterable[str] = (), options: Iterable[str] = ()
    ) -> None:
        """Note what a key may hold; what was noted of it before stands."""
        found = DefinitionKey(name=key, shape=shape, labels=tuple(labels), options=tuple(options))
        self.noted.setdefault(key, found)

    def choice(self, key: str, kind: type[Choice], default: Choice | None = None) -> Choice:
        """Return one of the values of an enumeration."""
        self.note(key, KeyShape.CHOICE, options=kind)
        return super().choice(key, kind, default)

    def choices(self, key: str, kind: type[Choice], default: Any = MISSING) -> tuple[Choice, ...]:
        """Return a list of values of an enumeration."""
        self.note(key, KeyShape.CHOICES, options=kind)
        return super().choices(key, kind, default)

    def count(self, key: str) -> int:
        """Return a whole number from 1 on; 1 with a fault where it is something else."""
        value = self.value(key, int, ValueKind.COUNT)
        if value is not None and value < 1:
            self.mistyped(ValueKind.COUNT, key)
        elif value is not None and value > LARGEST:
            self.mistyped(ValueKind.NUMBER, key)
        else:
            return value or 1
        return 1

    def tolerance(self, key: str, usual: float) -> float:
        """Return a tolerance, above 0 and at most 0.1; the usual one where it is missing or none."""
        self.note(key, KeyShape.NUMBER)
        value = self.number(key, usual)
        if 0.0 < value <= LARGEST_TOLERANCE:
            return value
        if is_number(self.values.get(key)):  # else that is told
            self.fault("tolerance_out_of_range", key, name=key)
        return usual

    def per_joint(self, key: str, joints: int, usual: Sequence[int] | None = None) -> tuple[Fraction, ...]:
        """Return a list with one number for each joint; zeros with a fault where it is something else."""
        values = self.exacts(key) if usual is None else self.exacts(key, list(usual))
        written = self.values.get(key)
        if isinstance(written, list) and len(written) != joints:
            self.fault("joints_wrong_length", key, expected=joints, given=len(written))
        return values if len(values) == joints else (Fraction(0),) * joints

    def length(self, key: str, default: Cell | None = None) -> Expression:
        """Return a length: a number or an expression in the exercise's dimensions."""
        return self._cell(self.values.get(key, default), key) if self._known(key, default) else ZERO

    def lengths(
        self, key: str, default: Sequence[Cell] | None = None
    ) -> tuple[Expression, Expression, Expression]:
        """Return three lengths."""
        value = self.values.get(key, default) if self._known(key, default) else (0, 0, 0)
        if not isinstance(value, list | tuple) or len(value) != 3:
            self.mistyped(ValueKind.CELLS, key, count=3)
            return ZERO, ZERO, ZERO
        return triple(self._cell(entry, key, i) for i, entry in enumerate(value))

    def direction(
        self, key: str, default: tuple[float, float, float] | None
    ) -> tuple[float, float, float] | None:
        """Return three numbers, not all zero; the default where the key is missing."""
        if not self.given(key):
            return default
        entries = self.exacts(key)
        if len(entries) != 3 or not any(entries):
            self.mistyped(ValueKind.DIRECTION, key)
            return default
        return triple(map(float, entries))

    def named_numbers(self) -> dict[str, float]:
        """Return a number for each key, which is the name of a dimension."""
        return {self.name(name): self.number(name) for name in self.values}

    def name(self, text: str, *where: str | int) -> str:
        """Return a dimension's name in its one spelling."""
        name = canonical_name(text)
        if name is None:
            self.fault("name_invalid", *where, name=text[:LONGEST_ECHO])
        return name or text

    def _known(self, key: str, default: object) -> bool:
        if self.given(key) or default is not None:
            return True
        self.missing(key)
        return False

    def _cell(self, value: object, *where: str | int) -> Expression:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            self.mistyped(ValueKind.CELL, *where)
            return ZERO
        cell: Cell = value
        found = self.guarded(lambda: read_cell(cell, ParameterKind.LENGTH, angle_unit=AngleUnit.RAD), *where)
        variables = () if found is None else sorted(joint_variables_in(found))
        for index in variables:
            self.fault("joint_variable_in_number", *where, name=f"q{index}")
        return ZERO if found is None or variables else found


class _EveryKey(dict[str, Any]):
    """A definition that gives every key, and nothing in any."""

    def __contains__(self, key: object) -> bool:
        return True

    def __missing__(self, key: str) -> None:
        return None


def keys_read(read: Callable[[Reader], object]) -> tuple[DefinitionKey, ...]:
    """Return the keys that a function asks a reader for, with what each may hold."""
    reader = Reader(_EveryKey(), (), [])
    read(reader)
    return tuple(reader.noted.values())
