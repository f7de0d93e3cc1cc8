"""Records as plain data and back: how a verdict or a report is stored, to be shown again later.

A record is a frozen dataclass of strings, numbers, enumerations, tuples, mappings and records. Its fields
and their types are the only description: `plain` writes by them, `restored` reads by them. What is stored
holds codes and values, no sentences, so it can be shown in any language.
"""

from __future__ import annotations

import types
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from typing import Annotated, Any, TypeVar, Union, cast, get_args, get_origin, get_type_hints

Record = TypeVar("Record")


def plain(value: Any) -> Any:
    """Return a record as dictionaries, lists, strings and numbers: what a JSON writer takes."""
    if is_dataclass(value):
        return {entry.name: plain(getattr(value, entry.name)) for entry in fields(value)}
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, Mapping):
        return {str(name): plain(entry) for name, entry in value.items()}
    if isinstance(value, tuple | list):
        return [plain(entry) for entry in value]
    return value


def restored(kind: type[Record], value: Any) -> Record:
    """Return the record that `plain` wrote.

    A key that the record does not know is ignored, and one that is missing takes the field's default: what
    was stored by another version can still be shown.

    Raises:
        ValueError: the data does not fit the record.
    """
    try:
        return cast(Record, _read(kind, value))
    except (TypeError, KeyError, AttributeError) as error:
        raise ValueError(f"no {kind.__name__}: {error}") from error


def _read(kind: Any, value: Any) -> Any:
    origin, arguments = get_origin(kind), get_args(kind)
    if is_dataclass(kind):
        hints = _hints(cast(type, kind))
        return cast(Any, kind)(
            **{name: _read(hints[name], entry) for name, entry in value.items() if name in hints}
        )
    if origin is Annotated:
        return _read(arguments[0], value)
    if origin in (Union, types.UnionType):
        return _read_one_of(arguments, value)
    if origin is tuple:
        return _read_tuple(arguments, value)
    if origin is not None and issubclass(origin, Mapping):
        return {name: _read(arguments[1], entry) for name, entry in value.items()}
    if isinstance(kind, type) and issubclass(kind, Enum):
        return kind(value)
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if not isinstance(value, kind) or (isinstance(value, bool) and kind is not bool):
        raise TypeError(f"{value!r} is no {kind.__name__}")
    return value


def _read_tuple(arguments: tuple[Any, ...], value: Any) -> tuple[Any, ...]:
    if not isinstance(value, list | tuple):
        raise TypeError(f"{value!r} is no list")
    if len(arguments) == 2 and arguments[1] is Ellipsis:
        return tuple(_read(arguments[0], entry) for entry in value)
    return tuple(_read(kind, entry) for kind, entry in zip(arguments, value, strict=True))


def _read_one_of(kinds: tuple[Any, ...], value: Any) -> Any:
    """Return the value as the first kind that it fits exactly."""
    if value is None and type(None) in kinds:
        return None
    for kind in sorted(kinds, key=lambda kind: kind is float):  # 1 is a whole number before it is 1.0
        try:
            return _read(kind, value)
        except (TypeError, ValueError, AttributeError):
            continue
    raise TypeError(f"{value!r} fits none of {kinds}")


@cache
def _hints(record: type) -> Mapping[str, Any]:
    return get_type_hints(record, include_extras=True)
