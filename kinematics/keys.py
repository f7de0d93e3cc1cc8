"""Keys of a TOML file: every fault is kept, with the path of its key, and reported at once."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from typing import Any, ClassVar, Self, TypeVar

from kinematics.errors import Fault, KinematicsError, ParamValue

Choice = TypeVar("Choice", bound=StrEnum)
Read = TypeVar("Read")

MISSING: Any = object()  # Stands for no default: the key must be given.
LARGEST = 10**15  # Most that a number may be in size, as in cells: what is computed of it is finite.


class ValueKind(StrEnum):
    """What the value of a key has to be."""

    TEXT = "text"
    TEXTS = "texts"
    NUMBER = "number"
    INTEGER = "integer"
    COUNT = "count"
    FLAG = "flag"
    NUMBERS = "numbers"
    CELL = "cell"
    CELLS = "cells"
    ROWS = "rows"
    TABLE = "table"
    TABLES = "tables"
    CHOICE = "choice"
    DIRECTION = "direction"
    POINT_NAMES = "point_names"
    POINT_CHAINS = "point_chains"
    HELP_LEVELS = "help_levels"


@dataclass(frozen=True)
class KeyFaults:
    """Codes of what can be wrong with a key in one kind of file."""

    missing: str
    unknown: str
    mistyped: str
    unlisted: str


class KeyReader:
    """A table of keys and where it stands; keys that nobody asks for are faults.

    Attributes:
        where: file and path of the table.
        faults: what was found wrong, shared with the readers of inner tables.
    """

    codes: ClassVar[KeyFaults]

    def __init__(self, values: Mapping[str, Any], where: tuple[str | int, ...], faults: list[Fault]) -> None:
        self.values, self.where, self.faults = values, where, faults
        self._asked: set[str] = set()

    def fault(self, code: str, /, *where: str | int, **params: ParamValue) -> None:
        """Keep a fault at a place inside this table."""
        self.faults.append(Fault.at(code, *self.where, *where, **params))

    def mistyped(self, expected: ValueKind, /, *where: str | int, **params: ParamValue) -> None:
        """Keep the fault of a value that is something else than `expected`; a count of 0 means any."""
        self.fault(
            self.codes.mistyped,
            *where,
            key=self._name(where),
            expected=expected.value,
            **{"count": 0, **params},
        )

    def missing(self, key: str) -> None:
        """Keep the fault of a key that is not there."""
        self.fault(self.codes.missing, key, key=key)

    def given(self, key: str) -> bool:
        """Return whether a key is in the table; it counts as asked for."""
        self._asked.add(key)
        return key in self.values

    def finish(self) -> None:
        """Report the keys that mean nothing here."""
        known = ", ".join(sorted(self._asked))
        for key in self.values:
            if key not in self._asked:
                self.fault(self.codes.unknown, key, key=key, known=known)

    def table(self, key: str, *, needed: bool = False) -> Self:
        """Return the reader of an inner table.

        An empty one where there is none, which reports nothing more.
        """
        value = self.value(key, dict, ValueKind.TABLE, MISSING if needed else {})
        faults = self.faults if isinstance(value, dict) else []
        return type(self)(value if isinstance(value, dict) else {}, (*self.where, key), faults)

    def tables(self, key: str) -> Iterator[tuple[str, Self]]:
        """Yield the readers of the tables inside a table, with their names."""
        inner = self.table(key)
        for name in inner.values:
            yield name, inner.table(name)

    def entries(self, key: str, *, needed: bool = False) -> Iterator[Self]:
        """Yield the readers of a list of tables."""
        value = self.value(key, list, ValueKind.TABLES, MISSING if needed else [])
        for i, entry in enumerate(value if isinstance(value, list) else []):
            if isinstance(entry, dict):
                yield type(self)(entry, (*self.where, key, i), self.faults)
            else:
                self.mistyped(ValueKind.TABLE, key, i)

    def text(self, key: str, default: Any = MISSING) -> str:
        """Return a text; one that must be given is not empty."""
        value = self.value(key, str, ValueKind.TEXT, default)
        if default is MISSING and isinstance(value, str) and not value.strip():
            self.mistyped(ValueKind.TEXT, key)
        return value if isinstance(value, str) else ""

    def texts(self, key: str, *, default: Any = MISSING) -> tuple[str, ...]:
        """Return a list of texts."""
        value = self.value(key, list, ValueKind.TEXTS, default)
        return self._each(key, value, ValueKind.TEXT, lambda entry: isinstance(entry, str))

    def integer(self, key: str) -> int:
        """Return a whole number of at most `LARGEST` in size."""
        value = self.value(key, int, ValueKind.INTEGER, MISSING)
        if isinstance(value, int) and abs(value) > LARGEST:
            self.mistyped(ValueKind.NUMBER, key)
        return value if isinstance(value, int) else 0

    def exact(self, key: str, default: Any = MISSING) -> Fraction:
        """Return a number, as it is written: 0.1 is a tenth."""
        return self._fraction(self.value(key, (int, float, Fraction), ValueKind.NUMBER, default), key)

    def exacts(self, key: str, default: Any = MISSING) -> tuple[Fraction, ...]:
        """Return a list of numbers, as they are written."""
        value = self.value(key, list, ValueKind.NUMBERS, default)
        entries = self._each(key, value, ValueKind.NUMBER, is_number)
        return tuple(self._fraction(entry, key, i) for i, entry in enumerate(entries))

    def cell(self, key: str) -> Any:
        """Return a value whose meaning is read elsewhere; 0 with a fault where there is none."""
        if self.given(key):
            return self.values[key]
        self.missing(key)
        return 0

    def number(self, key: str, default: Any = MISSING) -> float:
        """Return a number of at most `LARGEST` in size."""
        return float(self.exact(key, default))

    def numbers(self, key: str, length: int) -> tuple[float, ...]:
        """Return a list of `length` finite numbers; zeros where it is something else."""
        value = self.value(key, list, ValueKind.NUMBERS, MISSING, count=length)
        if are_numbers(value, length):
            return tuple(map(float, value))
        if value is not None:
            self.mistyped(ValueKind.NUMBERS, key, count=length)
        return (0.0,) * length

    def rows(self, key: str, length: int | None, width: int) -> list[list[Any]]:
        """Return a list of lists of `width` entries each, `length` of them where that is given."""
        params: dict[str, ParamValue] = {"width": width, "count": length or 0}
        value = self.value(key, list, ValueKind.ROWS, MISSING, **params)
        if not isinstance(value, list):
            return []
        if all(isinstance(row, list) and len(row) == width for row in value) and length in {None, len(value)}:
            return value
        self.mistyped(ValueKind.ROWS, key, **params)
        return []

    def choice(self, key: str, kind: type[Choice], default: Choice | None = None) -> Choice:
        """Return one of the values of an enumeration."""
        value = self.value(key, str, ValueKind.TEXT, MISSING if default is None else default.value)
        if value is None:
            return default if default is not None else next(iter(kind))
        try:
            return kind(str(value))
        except ValueError:
            self.not_among(kind, key)
            return default if default is not None else next(iter(kind))

    def choices(self, key: str, kind: type[Choice], default: Any = MISSING) -> tuple[Choice, ...]:
        """Return a list of values of an enumeration."""
        found = []
        for i, text in enumerate(self.texts(key, default=default)):
            if text in set(kind):
                found.append(kind(text))
            else:
                self.not_among(kind, key, i)
        return tuple(found)

    def not_among(self, kind: type[StrEnum], /, *where: str | int) -> None:
        """Keep the fault of a text that is no value of an enumeration."""
        known = ", ".join(kind)
        self.fault(
            self.codes.unlisted, *where, key=self._name(where), expected=ValueKind.CHOICE.value, known=known
        )

    def _name(self, where: tuple[str | int, ...]) -> str:
        return next((step for step in reversed((*self.where, *where)) if isinstance(step, str)), "")

    def guarded(self, read: Callable[[], Read], *where: str | int) -> Read | None:
        """Return what a function of the domain returns; its faults are kept, seen from here."""
        try:
            return read()
        except KinematicsError as error:
            self.faults.extend(fault.within(*self.where, *where) for fault in error.faults)
            return None

    def value(
        self,
        key: str,
        kind: type | tuple[type, ...],
        expected: ValueKind,
        default: Any = MISSING,
        **params: ParamValue,
    ) -> Any:
        """Return a value of the types `kind`.

        The default, or None with a fault, where it is something else.
        """
        absent = None if default is MISSING else default
        if not self.given(key):
            if default is MISSING:
                self.missing(key)
            return absent
        value = self.values[key]
        if not isinstance(value, kind) or (isinstance(value, bool) and kind is not bool):
            self.mistyped(expected, key, **params)
            return absent
        return value

    def _each(
        self, key: str, value: object, expected: ValueKind, fits: Callable[[object], bool]
    ) -> tuple[Any, ...]:
        entries = value if isinstance(value, list | tuple) else ()
        for i, entry in enumerate(entries):
            if not fits(entry):
                self.mistyped(expected, key, i)
        return tuple(entry for entry in entries if fits(entry))

    def _fraction(self, value: object, *where: str | int) -> Fraction:
        if not isinstance(value, int | float | Fraction):
            return Fraction(0)
        if not -LARGEST <= value <= LARGEST:
            self.mistyped(ValueKind.NUMBER, *where)
            return Fraction(0)
        return Fraction(repr(value)) if isinstance(value, float) else Fraction(value)


def is_number(value: object) -> bool:
    """Return whether a value is a number; neither true nor false is one."""
    return isinstance(value, int | float | Fraction) and not isinstance(value, bool)


def are_numbers(value: object, length: int) -> bool:
    """Return whether a value is a list of `length` numbers of a size that is read."""
    return (
        isinstance(value, list)
        and len(value) == length
        and all(is_number(entry) and abs(entry) <= LARGEST for entry in value)
    )
