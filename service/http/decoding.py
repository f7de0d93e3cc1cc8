"""JSON bodies, read strictly: UTF-8, finite numbers, no key twice."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import orjson

from kinematics.errors import Fault
from service.http.problems import BodyError

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"
_NOT_FINITE = ("NaN", "Infinity", "-Infinity", "inf", "nan", "-inf")
_MOST_FAULTS = 50
_DEPTH_MESSAGE = "depth limit"
_INFINITE_MESSAGE = "infinity"
_UTF8_MESSAGE = "UTF-8"


def decode_json(body: bytes) -> Any:
    """The value of a JSON document.

    A byte order mark is ignored, as RFC 8259 §8.1 allows.

    Raises:
        BodyError: the document is empty, not UTF-8, not JSON, too deep, holds NaN or an infinite number, or
            names a key twice in one object.
    """
    try:
        value = orjson.loads(body)
    except orjson.JSONDecodeError as error:
        if body.startswith(_BYTE_ORDER_MARK):
            return decode_json(body[len(_BYTE_ORDER_MARK) :])
        raise BodyError(_syntax_faults(body, error)) from None
    try:
        quotes = _quotes_written(value, body)
    except (RecursionError, orjson.JSONEncodeError):  # what can be read may be too deep to be walked again
        raise BodyError(_too_deep()) from None
    if body.count(b'"') != quotes:
        raise BodyError(
            Fault(
                code="json_duplicate_key",
                where=where,
                params={"key": str(where[-1])},
            )
            for where in _duplicates(body)
        )
    return value


def _quotes_written(value: Any, body: bytes) -> int:
    """How many quotation marks the value needs: fewer than the body has when a key was overwritten."""
    written = orjson.dumps(value)
    if b"\\" in body:
        return body.count(b'"') if next(_duplicates(body), None) is None else -1
    return written.count(b'"')


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

    stack: list[tuple[tuple[str | int, ...], Any]] = [((), json.loads(body, object_pairs_hook=keep))]
    while stack:
        where, node = stack.pop()
        if isinstance(node, dict):
            yield from ((*where, key) for key in repeated.get(id(node), ()))
            stack.extend(((*where, key), item) for key, item in node.items())
        elif isinstance(node, list):
            stack.extend(((*where, index), item) for index, item in enumerate(node))


def _syntax_faults(body: bytes, error: orjson.JSONDecodeError) -> Iterator[Fault]:
    place = {"line": error.lineno, "column": error.colno}
    rest = error.doc[error.pos : error.pos + 9]
    if not rest.startswith(_NOT_FINITE) and _INFINITE_MESSAGE not in error.msg:
        yield _syntax_fault(body, error)
        return
    for where in _not_finite(body) or [()]:
        yield Fault(
            code="json_not_finite",
            where=where,
            params=place,
        )


def _not_finite(body: bytes) -> list[tuple[str | int, ...]]:
    """Where NaN and infinite numbers stand, as far as Python's lenient reader can tell."""
    try:
        stack: list[tuple[tuple[str | int, ...], Any]] = [((), json.loads(body))]
    except (ValueError, RecursionError):
        return []
    found: list[tuple[str | int, ...]] = []
    while stack and len(found) < _MOST_FAULTS:
        where, node = stack.pop()
        if isinstance(node, float) and not math.isfinite(node):
            found.append(where)
        elif isinstance(node, dict):
            stack.extend(reversed([((*where, key), item) for key, item in node.items()]))
        elif isinstance(node, list):
            stack.extend(reversed([((*where, index), item) for index, item in enumerate(node)]))
    return found


def _syntax_fault(body: bytes, error: orjson.JSONDecodeError) -> Fault:
    if not body.strip():
        return Fault(code="body_missing")
    if _UTF8_MESSAGE in error.msg:
        return Fault(code="json_not_utf8")
    if _DEPTH_MESSAGE in error.msg:
        return _too_deep()
    return Fault(
        code="json_invalid",
        params={"line": error.lineno, "column": error.colno, "reason": error.msg},
    )


def _too_deep() -> Fault:
    return Fault(code="json_too_deep")
