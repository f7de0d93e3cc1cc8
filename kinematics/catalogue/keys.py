"""Keys of a catalogue file: every fault is kept, with the path of its key, and reported at once."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from typing import Any, TypeVar

from kinematics.errors import Fault, ParamValue

Choice = TypeVar("Choice", bound=StrEnum)
_MISSING = object()


def fault(code: str, *where: str | int, **params: ParamValue) -> Fault:
    """Return a fault of a catalogue file."""
    return Fault(code=code, where=where, params=params)


class FileKeys:
    """A table of keys and where it stands; keys that nobody asks for are faults.

    Attributes:
        values: the table.
        where: path of the table in the file.
        faults: what was found wrong, shared with the readers of inner tables.
    """

    def __init__(self, values: Mapping[str, Any], where: tuple[str | int, ...], faults: list[Fault]) -> None:
        self.values, self.where, self.faults = values, where, faults
        self._asked: set[str] = set()

    def finish(self) -> None:
        """Report the keys that nobody asked for."""
        known = ", ".join(sorted(self._asked))
        for key in self.values:
            if key not in self._asked:
                self._refuse("catalogue_key_unknown", key, key=key, known=known)

    def holds(self, key: str) -> bool:
        """Whether the key is there."""
        self._asked.add(key)
        return key in self.values

    def text(self, key: str) -> str:
        """A text that is not empty."""
        value = self._value(key)
        if isinstance(value, str) and value.strip():
            return value
        self._mistyped(key, value, "a text")
        return ""

    def choice(self, key: str, kind: type[Choice]) -> Choice:
        """One of an enumeration's values."""
        value = self._value(key)
        if isinstance(value, str) and value in set(kind):
            return kind(value)
        self._mistyped(key, value, " or ".join(kind))
        return next(iter(kind))

    def cell(self, key: str) -> Any:
        """A number or a text, whose meaning is read elsewhere."""
        value = self._value(key)
        return 0 if value is _MISSING else value

    def numbers(self, key: str, length: int) -> tuple[float, ...]:
        """A list of so many finite numbers."""
        value = self._value(key)
        if is_numbers(value, length):
            return tuple(float(entry) for entry in value)
        self._mistyped(key, value, f"a list of {length} finite numbers")
        return (0.0,) * length

    def lists(self, key: str, length: int | None, width: int) -> list[list[Any]]:
        """A list of lists of so many entries each."""
        value = self._value(key)
        sound = isinstance(value, list) and all(isinstance(row, list) and len(row) == width for row in value)
        if sound and length in {None, len(value)}:
            return list(value)
        many = "" if length is None else f"{length} "
        self._mistyped(key, value, f"a list of {many}lists of {width} entries")
        return []

    def table(self, key: str) -> FileKeys:
        """An inner table."""
        value = self._value(key)
        if not isinstance(value, Mapping):
            self._mistyped(key, value, "a table")
            return FileKeys({}, (*self.where, key), [])
        return FileKeys(value, (*self.where, key), self.faults)

    def tables(self, key: str) -> Iterator[FileKeys]:
        """The tables of a list of tables."""
        value = self._value(key)
        if not isinstance(value, list) or not all(isinstance(entry, Mapping) for entry in value):
            self._mistyped(key, value, "a list of tables")
            return
        for i, entry in enumerate(value):
            yield FileKeys(entry, (*self.where, key, i), self.faults)

    def _value(self, key: str) -> Any:
        self._asked.add(key)
        return self.values.get(key, _MISSING)

    def _mistyped(self, key: str, value: object, expected: str) -> None:
        if value is _MISSING:
            self._refuse("catalogue_key_missing", key, key=key)
        else:
            self._refuse("catalogue_value_type", key, key=key, expected=expected)

    def _refuse(self, code: str, *where: str | int, **params: ParamValue) -> None:
        self.faults.append(fault(code, *self.where, *where, **params))


def is_numbers(value: object, length: int) -> bool:
    """Whether a value is a list of so many finite numbers."""
    return isinstance(value, Sequence) and len(value) == length and all(map(is_number, value))


def is_number(value: object) -> bool:
    """Whether a value is a finite number."""
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
