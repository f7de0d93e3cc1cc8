"""A list of tasks within a processor time: what is done by then is kept."""

import signal
from collections.abc import Callable, Iterable
from typing import NoReturn, TypeVar

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


AGAIN = 0.05  # Processor time [s] after which a task that did not end is left once more.


class _AllottedTimeOver(BaseException):
    """Raised wherever a task is when the time is over.

    Not an `Exception`: libraries catch those, to try another way or to raise an error of their own.
    """


def each_in_time(
    function: Callable[[_Item], _Result], items: Iterable[_Item], seconds: float
) -> list[_Result]:
    """Return results of a function for the first items, as many as the time allows.

    What an item comes to after the time is over, a result or an error, is dropped: code that was left and
    went on all the same may have gone wrong. It is for the main thread of a worker process, which has no
    other use for the timer.

    Args:
        function: what is done with each item; it may be left anywhere, so it must not hold a lock.
        seconds: processor time of this process [s].
    """
    over = False

    def leave(*_: object) -> NoReturn:
        nonlocal over
        over = True
        raise _AllottedTimeOver

    results: list[_Result] = []
    before = signal.signal(signal.SIGVTALRM, leave)
    try:
        signal.setitimer(signal.ITIMER_VIRTUAL, seconds, AGAIN)
        for item in items:
            result = function(item)
            if over:
                break
            results.append(result)
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
    except (Exception, _AllottedTimeOver):
        if not over:
            raise
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)
    return results
