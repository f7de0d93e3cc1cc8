"""Long lists of numbers in a JSON document, read a piece at a time."""

from collections.abc import Iterable
from typing import Any

import orjson

from kinematics.errors import Fault
from service.http.problems import BodySizeError

PIECE = 128 * 1024
"""Bytes of a long list of numbers that are read at a time, in a millisecond: the parser lets no other thread
run until it is done."""
_LONGEST_PIECE, _CUTS = 8 * PIECE, 300
"""Bytes of a piece, and places where it may be cut, if an item is no number: a text, or a long row."""
AT_ONCE = 4 * 1024 * 1024
"""Longest body [byte] that is read at once where it cannot be read in pieces, in some 20 ms."""
_BEHIND = "unexpected content after document"  # What orjson says of a document that goes on behind its value.


def list_of_numbers(body: bytes, behind: int) -> tuple[int, int] | None:
    """Where the list behind a key begins and ends, if it holds no text and no object."""
    start = body.find(b"[", behind)
    if start < 0 or body[behind:start].strip() != b":":
        return None
    ends = [body.find(sign, start) for sign in (b'"', b"{", b"}")]
    stop = body.rfind(b"]", start, min((end for end in ends if end >= 0), default=len(body))) + 1
    return (start, stop) if stop else None


def numbers(body: bytes, start: int, stop: int) -> list[Any]:
    """A list of numbers, or of lists of them, read between two places: each piece is a list by itself.

    Raises:
        orjson.JSONDecodeError: it is no such list, or holds a list that is longer than a piece.
    """
    found: list[Any] = []
    sign = b"]," if body.find(b"[", start + 1, stop) >= 0 else b","
    begun, last = start + 1, stop - 1
    while begun <= last:
        cut = body.find(sign, begun + PIECE, last)
        end = last if cut < 0 else cut + len(sign) - 1
        long = end - begun > 2 * PIECE and len(sign) > 1
        piece = _ending_in_a_long_row(body, begun, end) if long else orjson.loads(b"[%b]" % body[begun:end])
        if not piece and (found or end < last):
            raise orjson.JSONDecodeError("a comma too many", "", begun)
        found += piece
        begun = end + 1
    return found


def _ending_in_a_long_row(body: bytes, begun: int, end: int) -> list[Any]:
    """The rows between two places, of which the last is longer than a piece and is read in pieces, too.

    Raises:
        orjson.JSONDecodeError: they are no rows of numbers.
    """
    row = body.rfind(b"[", begun, end)
    stop = body.find(b"]", row, end) + 1
    before = body[begun:row].rstrip()
    rows = orjson.loads(b"[%b]" % before[:-1])
    if row < 0 or not stop or body[stop:end].strip() or (before and not (rows and before.endswith(b","))):
        raise orjson.JSONDecodeError("no rows of numbers", "", begun)
    return [*rows, numbers(body, row, stop)]


def first_list(body: bytes, names: Iterable[str]) -> tuple[str, int]:
    """Return the first name under which a list stands, and where the list begins.

    Raises:
        BodySizeError: there is none.
    """
    for name in names:
        key = b'"%b"' % name.encode()
        behind = 0
        while (behind := body.find(key, behind) + len(key)) >= len(key):
            start = body.find(b"[", behind)
            if start >= 0 and body[behind:start].strip() == b":":
                return name, start
    raise BodySizeError(Fault.at("body_too_large", limit=AT_ONCE))


def items(body: bytes, start: int) -> tuple[list[Any], int]:
    """Return what a list holds, whatever that is, and where it ends.

    Raises:
        orjson.JSONDecodeError: it is no list; the place is that in the whole body.
        BodySizeError: an item is longer than a piece may be.
    """
    found: list[Any] = []
    sign = b"]," if body[start + 1 : start + 64].lstrip().startswith(b"[") else b","
    begun, ended = start + 1, False
    while not ended:
        piece, stop, ended = _piece(body, begun, sign)
        if not piece and (found or not ended):
            raise _comma_too_many(body, begun)
        found += piece
        begun = stop + 1
    return found, stop


def _piece(body: bytes, begun: int, sign: bytes) -> tuple[list[Any], int, bool]:
    """The items from a place on, where they end, and whether the list does.

    A cut within a text, or within a list, leaves a piece that does not end: then the next one is tried.
    """
    cut = begun + PIECE
    for _ in range(_CUTS):
        cut = body.find(sign, cut, begun + _LONGEST_PIECE)
        if cut < 0 and len(body) - begun > _LONGEST_PIECE:
            break
        end = len(body) if cut < 0 else cut + len(sign) - 1
        try:
            return orjson.loads(b"[%b]" % body[begun:end]), end, False
        except orjson.JSONDecodeError as error:
            place = begun - 1 + len(error.doc[: error.pos].encode())
            if error.msg == _BEHIND:
                return orjson.loads(b"[%b" % body[begun:place]), place, True
            if cut < 0 or error.pos < len(error.doc) - 1:
                raise _error_at(body, place, error.msg) from None
        cut += 1
    raise BodySizeError(Fault.at("body_too_large", limit=AT_ONCE))


def blank(body: bytes, start: int, stop: int) -> bytes:
    """Return an empty list that ends in the line and column in which that between two places does."""
    lines = body.count(b"\n", start, stop)
    last = max(start, body.rfind(b"\n", start, stop) + 1)
    width = len(body[last:stop].decode(errors="replace"))
    return b"[" + b"\n" * lines + b" " * (width - (1 if lines else 2)) + b"]"


def _comma_too_many(body: bytes, place: int) -> orjson.JSONDecodeError:
    """What is wrong where no item stands behind a comma, or a list does not end."""
    try:
        orjson.loads(b"[0,%b" % body[place : place + 64])
    except orjson.JSONDecodeError as error:
        return _error_at(body, place - 3 + len(error.doc[: error.pos].encode()), error.msg)
    return _error_at(body, place, "")


def _error_at(body: bytes, place: int, message: str) -> orjson.JSONDecodeError:
    """An error at a place of the whole body."""
    before = body[:place].decode(errors="replace")
    return orjson.JSONDecodeError(
        message, before + body[place : place + 9].decode(errors="replace"), len(before)
    )
