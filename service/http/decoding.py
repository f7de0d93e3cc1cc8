"""JSON bodies, read strictly: UTF-8, finite numbers, no key twice.

Of two equal keys the quick reader keeps the last, so the value it returns needs fewer quotation marks than
the text has. Only then is the slow reader asked where.
"""

from dataclasses import dataclass, replace
from itertools import chain
from typing import Any

import orjson

from kinematics.errors import Fault
from service.http.json_faults import duplicate_faults, syntax_faults, too_deep
from service.http.long_lists import AT_ONCE, PIECE, blank, first_list, items, list_of_numbers, numbers
from service.http.problems import BodyError, BodySizeError

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"
DEEPEST = 1024  # How deeply orjson nests lists and objects.
LONGEST_REST = 1024 * 1024
"""Bytes beside the list in a body that is too long to be read at once: as many as other calls read."""
_SHALLOW = 16  # How deeply the bodies nest that calls understand.
_NO_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))
_FEW = 64
"""Items of a list that is searched for objects: for those of a longer one it is quicker to write it."""


@dataclass(frozen=True, kw_only=True)
class JsonLimits:
    """How much a document may hold, whatever it means.

    Attributes:
        objects: most objects.
        lists: most lists.
        values: most values that stand behind a comma.
        fields: most fields of one object.
        colons: most colons, one of which stands in each field of any object.
        quotes: most quotation marks, two of which stand around each key and each text.
        long: names of the fields at the top that may hold long lists of numbers.
    """

    objects: int = 40_000
    lists: int = 40_000
    values: int = 200_000
    fields: int = 512
    colons: int = 64_000
    quotes: int = 600_000
    long: frozenset[str] = frozenset()


def decode_json(body: bytes, limits: JsonLimits = JsonLimits()) -> Any:
    """Return the value of a JSON document.

    A byte order mark is ignored, as RFC 8259 §8.1 allows.

    Raises:
        BodySizeError: it holds more than the limits allow; found before any of it is looked at.
        BodyError: the document is empty, not UTF-8, not JSON, too deep, holds NaN or an infinite number, or
            names a key twice in one object.
    """
    _refuse_many(body, limits)
    value = _read_in_pieces(body, limits)
    if value is not None:
        return value
    try:
        value = orjson.loads(body)
    except orjson.JSONDecodeError as error:
        if body.startswith(_BYTE_ORDER_MARK):
            return decode_json(body[len(_BYTE_ORDER_MARK) :], limits)
        raise BodyError(syntax_faults(body, error)) from None
    if not _is_plain(body, value):
        try:
            quotes = _expected_quotes(value, limits)
        # What is read may be too deep to be walked again.
        except (RecursionError, orjson.JSONEncodeError):
            raise BodyError(too_deep()) from None
        if _unescaped_quotes(body) != quotes:
            raise BodyError(duplicate_faults(body))
    if body.count(b":") > limits.fields:  # each field has one: where there are few, no object is wide
        _refuse_wide(value, limits)
    return value


def _read_in_pieces(body: bytes, limits: JsonLimits) -> Any:
    """The value of a body with a long list of numbers; None where it has none, or where anything is wrong.

    Raises:
        BodySizeError: it is longer than what is read at once, and without the list it still is.
        BodyError: it is as long, and anything is wrong.
    """
    for name in limits.long if len(body) > PIECE else ():
        key = b'"%b"' % name.encode()
        if body.count(key) == 1 and (where := list_of_numbers(body, body.find(key) + len(key))):
            start, stop = where
            try:
                value = decode_json(body[:start] + b"0" + body[stop:], replace(limits, long=frozenset()))
                if type(value) is dict and name in value:
                    value[name] = numbers(body, start, stop)
                    return value
            except (BodyError, orjson.JSONDecodeError):
                break  # what is wrong is found, with its place, where all is read at once
    return _read_large(body, limits) if limits.long and len(body) > AT_ONCE else None


def _read_large(body: bytes, limits: JsonLimits) -> Any:
    """The value of a body that is too long to be read at once, whatever stands in its long list."""
    if body.startswith(_BYTE_ORDER_MARK):
        return decode_json(body[len(_BYTE_ORDER_MARK) :], limits)
    name, start = first_list(body, limits.long)
    try:
        found, stop = items(body, start)
    except orjson.JSONDecodeError as error:
        raise BodyError(syntax_faults(body, error)) from None
    rest = replace(limits, long=frozenset())
    if len(body) - (stop - start) > LONGEST_REST:
        raise BodySizeError(Fault.at("body_too_large", limit=AT_ONCE))
    try:
        value = decode_json(body[:start] + b"[]" + body[stop:], rest)
    except BodyError:  # once more, with as much room in the place of the list: what is wrong has its line
        decode_json(body[:start] + blank(body, start, stop) + body[stop:], rest)
        raise
    if type(value) is not dict or value.get(name) != []:
        raise BodySizeError(Fault.at("body_too_large", limit=AT_ONCE))
    value[name] = found
    return value


def _is_plain(body: bytes, value: Any) -> bool:
    """Whether a body is shallow, and as many fields were found as it has colons: so no key stood twice."""
    missing = body.count(b":")
    level = [value]
    while level:
        missing -= sum(len(node) for node in level if type(node) is dict)
        if not missing:
            break
        inner = chain.from_iterable(
            node.values() if type(node) is dict else node
            for node in level
            if type(node) is dict or (type(node) is list and len(node) <= _FEW)
        )
        level = [item for item in inner if type(item) is dict or type(item) is list]
    if missing:
        return False
    brackets = body.translate(None, _NO_BRACKETS)
    for _ in range(_SHALLOW):
        brackets = brackets.replace(b"[]", b"").replace(b"{}", b"")
    return not brackets


def _expected_quotes(value: Any, limits: JsonLimits) -> int:
    """How many quotation marks the value needs: fewer than the body has when a key was overwritten."""
    if type(value) is not dict or limits.long.isdisjoint(value):
        return _unescaped_quotes(orjson.dumps(value))
    short = {name: None if name in limits.long else item for name, item in value.items()}
    long = [value[name] for name in limits.long if name in value]
    return _unescaped_quotes(orjson.dumps(short)) + 2 * sum(map(_texts, long))


def _texts(value: Any) -> int:
    """How many texts and keys a list of numbers holds after all."""
    found = 0
    stack = [value]
    while stack:
        node = stack.pop()
        if type(node) is list:
            if not set(map(type, node)).isdisjoint((str, list, dict)):
                stack.extend(item for item in node if type(item) in (str, list, dict))
        elif type(node) is dict:
            found += len(node)
            stack.extend(node.values())
        elif type(node) is str:
            found += 1
    return found


def _unescaped_quotes(document: bytes) -> int:
    """How many quotation marks begin or end a string: all but the escaped ones."""
    if b"\\" in document:  # the pairs first: what is left of a run of backslashes escapes what follows it
        document = document.replace(b"\\\\", b"").replace(b'\\"', b"")
    return document.count(b'"')


def _refuse_many(body: bytes, limits: JsonLimits) -> None:
    """Count what begins an object, a list or a further value, within strings too, before it is read."""
    counted = (
        (b"{", limits.objects),
        (b"[", limits.lists),
        (b",", limits.values),
        (b":", limits.colons),
        (b'"', limits.quotes),
    )
    for sign, limit in counted:
        if len(body) > limit and body.count(sign) > limit:
            if _is_deep(body):
                raise BodyError(too_deep())
            raise BodySizeError(Fault.at("json_too_many_values", limit=limit))


def _is_deep(body: bytes) -> bool:
    """Whether more is begun than the parser nests, before anything is ended."""
    ends = [body.find(sign) for sign in (b"]", b"}")]
    begun = body[: min((end for end in ends if end >= 0), default=len(body))]
    return begun.count(b"[") + begun.count(b"{") > DEEPEST


def _refuse_wide(value: Any, limits: JsonLimits) -> None:
    """Find an object of more fields than any call knows, without looking into the long lists."""
    level = [value]
    while level:
        objects = [node for node in level if type(node) is dict]
        widest = max(map(len, objects), default=0)
        if widest > limits.fields:
            raise BodySizeError(Fault.at("json_too_many_fields", given=widest, limit=limits.fields))
        if objects and objects[0] is value:
            inner = [item for name, item in value.items() if name not in limits.long]
        else:
            inner = [*chain.from_iterable(map(dict.values, objects))]
            inner.extend(chain.from_iterable(node for node in level if type(node) is list))
        level = [item for item in inner if type(item) is dict or type(item) is list]
