"""Long answers as JSON in chunks, none so long that the writing of it holds others up.

What writes JSON doesn't let other threads run meanwhile: a list of a million numbers, written at once, would
keep every other request waiting for a good part of a second.
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import orjson
from numpy.typing import NDArray

ROWS = 4096  # Rows that are written together, so that a long answer is never in memory as a whole.


def blocks(count: int, size: int) -> Iterator[tuple[int, int]]:
    """Return the bounds of blocks of so many of `count` things."""
    return ((start, min(start + size, count)) for start in range(0, count, size))


def written(value: object) -> bytes:
    """Return the value as JSON, all at once; what is not finite becomes null."""
    if isinstance(value, np.ndarray):
        value = np.ascontiguousarray(value) if value.ndim else value.item()
    return orjson.dumps(value, option=orjson.OPT_SERIALIZE_NUMPY)


def plain_lists(array: NDArray[np.float64]) -> list[Any]:
    """Return the array as nested lists of numbers, none of them -0.0."""
    lists: list[Any] = (array + 0.0).tolist()
    return lists


def list_chunks(array: NDArray[Any]) -> Iterator[bytes]:
    """Yield an array of one axis or more as a JSON list."""
    yield b"["
    for start, stop in blocks(len(array), ROWS):
        yield (b"," if start else b"") + written(array[start:stop])[1:-1]
    yield b"]"


def member_chunks(value: Mapping[str, Any]) -> Iterator[bytes]:
    """Yield the members of a JSON object, which may be objects or arrays.

    The braces are left to the caller.
    """
    for place, (name, member) in enumerate(value.items()):
        yield (b"," if place else b"") + written(name) + b":"
        if isinstance(member, Mapping):
            yield b"{"
            yield from member_chunks(member)
            yield b"}"
        elif isinstance(member, np.ndarray) and member.ndim:
            yield from list_chunks(member)
        else:
            yield written(member)
