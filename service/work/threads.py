"""Calls in threads, of which nothing stays when they fail."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, TypeVarTuple, cast

import anyio
from anyio.to_thread import run_sync

_Result = TypeVar("_Result")
_Arguments = TypeVarTuple("_Arguments")


async def in_thread(
    function: Callable[[*_Arguments], _Result],
    *arguments: *_Arguments,
    limiter: anyio.CapacityLimiter | None = None,
) -> _Result:
    """Return what a function gives in a thread, or raise what it raises.

    An exception that a future raises refers through its traceback to the frame that awaits the future, and so
    to itself: the cycle would keep a request and its body until the next garbage collection. Here it is
    returned as a result.

    Args:
        function: what is called.
        arguments: what it is called with.
        limiter: bounds how many such calls run at a time; None: as anyio does for all.

    Raises:
        Exception: whatever the function raises.
    """
    result, error = await run_sync(_outcome, function, arguments, limiter=limiter)
    if error is None:
        return cast(_Result, result)
    try:
        raise error
    finally:
        del error


def _outcome(
    function: Callable[[*_Arguments], _Result], arguments: tuple[*_Arguments]
) -> tuple[_Result | None, Exception | None]:
    try:
        return function(*arguments), None
    except Exception as error:
        return None, error
