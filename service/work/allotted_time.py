"""A list of tasks within a processor time: what is done by then is kept."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterable
from typing import NoReturn, TypeVar

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


class _AllottedTimeOverError(Exception):
    """Raised wherever a task is when the time is over."""


def each_in_time(
    function: Callable[[_Item], _Result], items: Iterable[_Item], seconds: float
) -> list[_Result]:
    """Return results of a function for the first items, as many as the time allows.

    It is for the main thread of a worker process, which has no other use for the timer.

    Args:
        function: what is done with each item; it may be left anywhere, so it must not hold a lock.
        items: the items.
        seconds: processor time of this process [s].
    """

    def leave(*_: object) -> NoReturn:
        raise _AllottedTimeOverError

    results: list[_Result] = []
    before = signal.signal(signal.SIGVTALRM, leave)
    try:
        signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
        for item in items:
            results.append(function(item))  # noqa: PERF401  what is done so far is kept
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
    except _AllottedTimeOverError:
        pass
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)
    return results
