"""Reading a definition's keys: every fault is kept, with the path of its key, and reported at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from enum import StrEnum
from fractions import Fraction
from typing import Any, TypeVar

from kinematics.cells import AngleUnit, Cell, ParameterKind, canonical_name, read_cell
from kinematics.errors import Fault, KinematicsError, ParamValue
from kinematics.expressions import ZERO, Expression

Choice = TypeVar("Choice", bound=StrEnum)
Read = TypeVar("Read")

_MISSING = object()


class Reader:
    """A table of keys, and where it stands in the file; keys that nobody asks for are faults.

    Attributes:
        values: the table.
        where: file and path of the table.
        faults: what was found wrong, shared with the readers of inner tables.
    """

    def __init__(self, values: Mapping[str, Any], where: tuple[str | int, ...], faults: list[Fault]) -> None:
        self.values, self.where, self.faults = values, where, faults
        self.asked: set[str] = set()

    def fault(self, code: str, /, *where: str | int, **params: ParamValue) -> None:
        """Keep a fault at a place inside this table."""
        self.faults.append(Fault(code=code, where=(*self.where, *where), params=params))

    def given(self, key: str) -> bool:
        """Whether a key stands in the table; it counts as asked for."""
        self.asked.add(key)
        return key in self.values

    def finish(self) -> None:
        """Report the keys that mean nothing here."""
        for key in self.values:
            if key not in self.asked:
                ", ".join(sorted(self.asked))
                self.fault("exercise_key_unknown", key, key=key)

    def table(self, key: str, *, needed: bool = False) -> Reader:
        """The reader of an inner table, empty if there is none."""
        value = self._value(key, dict, "a table", {} if not needed else _MISSING)
        return Reader(value if isinstance(value, dict) else {}, (*self.where, key), self.faults)

    def tables(self, key: str) -> Iterator[tuple[str, Reader]]:
        """The readers of the tables inside a table, with their names."""
        inner = self.table(key)
        for name in inner.values:
            yield name, inner.table(name)

    def entries(self, key: str) -> Iterator[Reader]:
        """The readers of a list of tables."""
        value = self._value(key, list, "a list of tables", [])
        for i, entry in enumerate(value if isinstance(value, list) else []):
            where = (*self.where, key, i)
            if isinstance(entry, dict):
                yield Reader(entry, where, self.faults)
            else:
                self.faults.append(Fault(code="exercise_value_type", where=where))

    def text(self, key: str, default: Any = _MISSING) -> str:
        """A text."""
        value = self._value(key, str, "a text", default)
        return value if isinstance(value, str) else ""

    def texts(self, key: str, *, default: Any = _MISSING) -> tuple[str, ...]:
        """A list of texts."""
        value = self._value(key, list, "a list of texts", default)
        return self._each(key, value, lambda entry: isinstance(entry, str), "a text")

    def integer(self, key: str, default: Any = _MISSING) -> int:
        """A whole number."""
        value = self._value(key, int, "a whole number", default)
        return value if isinstance(value, int) else 0

    def number(self, key: str, default: Any = _MISSING) -> float:
        """A number."""
        return float(self.exact(key, default))

    def exact(self, key: str, default: Any = _MISSING) -> Fraction:
        """A number, as it is written: 0.1 is a tenth."""
        value = self._value(key, (int, float, Fraction), "a number", default)
        return self._fraction(value, key)

    def exacts(self, key: str, default: Any = _MISSING) -> tuple[Fraction, ...]:
        """A list of numbers."""
        value = self._value(key, list, "a list of numbers", default)
        entries = self._each(key, value, _is_number, "a number")
        return tuple(self._fraction(entry, key, i) for i, entry in enumerate(entries))

    def choice(self, key: str, kind: type[Choice], default: Choice | None = None) -> Choice:
        """One of the values of an enumeration."""
        value = self._value(key, str, "a text", _MISSING if default is None else default.value)
        try:
            return kind(str(value))
        except ValueError:
            known = ", ".join(kind)
            self.fault("exercise_value_unknown", key, key=key, known=known)
            return default if default is not None else next(iter(kind))

    def length(self, key: str, default: Cell | None = None) -> Expression:
        """A length: a number or an expression in the exercise's dimensions."""
        return self._cell(self.values.get(key, default), key) if self._known(key, default) else ZERO

    def lengths(
        self, key: str, default: Sequence[Cell] | None = None
    ) -> tuple[Expression, Expression, Expression]:
        """Three lengths."""
        value = self.values.get(key, default) if self._known(key, default) else (0, 0, 0)
        if not isinstance(value, list | tuple) or len(value) != 3:
            self.fault("exercise_value_type", key, key=key)
            return ZERO, ZERO, ZERO
        x, y, z = (self._cell(entry, key, i) for i, entry in enumerate(value))
        return x, y, z

    def direction(
        self, key: str, default: tuple[float, float, float] | None
    ) -> tuple[float, float, float] | None:
        """Three numbers, not all zero; the default where the key is missing."""
        if not self.given(key):
            return default
        entries = self.exacts(key)
        if len(entries) != 3 or not any(entries):
            self.fault("exercise_value_type", key, key=key)
            return default
        x, y, z = (float(entry) for entry in entries)
        return x, y, z

    def name(self, text: str, *where: str | int) -> str:
        """A dimension's name in its one spelling."""
        name = canonical_name(text)
        if name is None:
            self.fault("name_invalid", *where, name=text)
        return name or text

    def guarded(self, read: Callable[[], Read], *where: str | int) -> Read | None:
        """What a function of the domain returns; its faults are kept, seen from here."""
        try:
            return read()
        except KinematicsError as error:
            self.faults.extend(fault.within(*self.where, *where) for fault in error.faults)
            return None

    def _known(self, key: str, default: object) -> bool:
        if self.given(key) or default is not None:
            return True
        self.fault("exercise_key_missing", key, key=key)
        return False

    def _cell(self, value: object, *where: str | int) -> Expression:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            self.fault("exercise_value_type", *where)
            return ZERO
        cell: Cell = value
        found = self.guarded(lambda: read_cell(cell, ParameterKind.LENGTH, angle_unit=AngleUnit.RAD), *where)
        return found if found is not None else ZERO

    def _value(self, key: str, kind: type | tuple[type, ...], words: str, default: object) -> object:
        if not self.given(key):
            if default is _MISSING:
                self.fault("exercise_key_missing", key, key=key)
            return default if default is not _MISSING else None
        value = self.values[key]
        if not isinstance(value, kind) or isinstance(value, bool):
            self.fault("exercise_value_type", key, key=key)
            return default if default is not _MISSING else None
        return value

    def _each(self, key: str, value: object, fits: Callable[[object], bool], words: str) -> tuple[Any, ...]:
        entries = value if isinstance(value, list | tuple) else ()
        for i, entry in enumerate(entries):
            if not fits(entry):
                self.fault("exercise_value_type", key, i, key=key)
        return tuple(entry for entry in entries if fits(entry))

    def _fraction(self, value: object, *where: str | int) -> Fraction:
        if isinstance(value, float) and not math.isfinite(value):
            self.fault("exercise_value_type", *where)
            return Fraction(0)
        if isinstance(value, float):
            return Fraction(repr(value))
        return Fraction(value) if isinstance(value, int | Fraction) else Fraction(0)


def _is_number(entry: object) -> bool:
    return isinstance(entry, int | float | Fraction) and not isinstance(entry, bool)
