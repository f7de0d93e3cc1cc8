"""What is wrong with a JSON body that cannot be read, and where."""

import json
import math
from collections.abc import Iterator
from itertools import islice
from typing import Any

import orjson

from kinematics.errors import Fault

_NOT_FINITE = ("NaN", "Infinity", "-Infinity", "inf", "nan", "-inf")
_MOST_FAULTS = 50  # Faults that an answer lists.
LONGEST_SEARCHED = 64 * 1024
"""In a longer body [byte] the place of such a fault is not looked for: so much takes up to 20 ms."""
_DEPTH_MESSAGE = "depth limit"
_INFINITE_MESSAGE = "infinity"
_UTF8_MESSAGE = "UTF-8"


def duplicate_faults(body: bytes) -> Iterator[Fault]:
    """Yield the places at which a key stands for the second time."""
    try:
        found = [*islice(_duplicates(body), _MOST_FAULTS)] if len(body) <= LONGEST_SEARCHED else []
    except RecursionError:  # Python's reader goes less deep than the one that took the body
        found = []
    for where in found:
        yield Fault.at("json_duplicate_key", *where, key=str(where[-1]))
    if not found:
        yield Fault.at("json_duplicate_key", key="…")


def _duplicates(body: bytes) -> Iterator[tuple[str | int, ...]]:
    """Where a key stands for the second time."""
    repeated: dict[int, list[str]] = {}
    objects: list[dict[str, Any]] = []

    def keep(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for key, item in pairs:
            if key in found:
                repeated.setdefault(id(found), []).append(key)
            found[key] = item
        objects.append(found)
        return found

    for place, node in _nodes(json.loads(body, object_pairs_hook=keep)):
        yield from ((*_steps(place), key) for key in repeated.get(id(node), ()))


_Place = tuple[Any, str | int] | None
"""The place of what holds a value, and its key there: whole places, written out, are long in a deep body."""


def _nodes(value: Any) -> Iterator[tuple[_Place, Any]]:
    """Yield every object, list and number that is not finite, in the order that they are written in."""
    stack: list[tuple[_Place, Any]] = [(None, value)]
    while stack:
        place, node = stack.pop()
        yield place, node
        if type(node) is not float:
            pairs = node.items() if type(node) is dict else enumerate(node) if type(node) is list else ()
            stack.extend(reversed([((place, key), item) for key, item in pairs if _is_followed(item)]))


def _is_followed(item: Any) -> bool:
    return type(item) in (dict, list) or (type(item) is float and not math.isfinite(item))


def _steps(place: _Place) -> tuple[str | int, ...]:
    steps = []
    while place is not None:
        place, key = place
        steps.append(key)
    return tuple(reversed(steps))


def syntax_faults(body: bytes, error: orjson.JSONDecodeError) -> Iterator[Fault]:
    """Yield what keeps a body from being read: numbers that are not finite, or what the parser says."""
    place = {"line": error.lineno, "column": error.colno}
    rest = error.doc[error.pos : error.pos + 9]
    if not rest.startswith(_NOT_FINITE) and _INFINITE_MESSAGE not in error.msg:
        yield _syntax_fault(body, error)
        return
    for where in _not_finite(body) or [()]:
        yield Fault.at("json_not_finite", *where, **place)


def _not_finite(body: bytes) -> list[tuple[str | int, ...]]:
    """Where NaN and infinite numbers stand, as far as Python's lenient reader can tell."""
    if len(body) > LONGEST_SEARCHED:
        return []
    try:
        walked = _nodes(json.loads(body, parse_int=float))  # an int is never infinite
    except (ValueError, RecursionError):
        return []
    found = (_steps(place) for place, node in walked if type(node) is float)
    return list(islice(found, _MOST_FAULTS))


def _syntax_fault(body: bytes, error: orjson.JSONDecodeError) -> Fault:
    if not body.strip():
        return Fault.at("body_missing")
    if _UTF8_MESSAGE in error.msg:
        return Fault.at("json_not_utf8")
    if _DEPTH_MESSAGE in error.msg:
        return too_deep()
    return Fault.at("json_invalid", line=error.lineno, column=error.colno, reason=error.msg)


def too_deep() -> Fault:
    """Return what is wrong with a body that nests too much."""
    return Fault.at("json_too_deep")
