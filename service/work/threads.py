"""Calls in threads, of which nothing stays when they fail, and threads that run until the process ends."""

from __future__ import annotations

import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
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


_LONGEST_END = 5.0
"""Time that what is under way has to come to its end [s]. What takes longer waits for a platform or for the
database, and is done again by whoever looks next."""


class BackgroundThread(ABC):
    """Something that goes on beside the requests.

    Attributes:
        stopping: set when it is to end; to be waited for between two turns.
    """

    def __init__(self, name: str) -> None:
        self.stopping = threading.Event()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def stop(self) -> None:
        """Finish what is under way, and end."""
        stop_all([self])

    def wait(self, seconds: float) -> None:
        """Wait for the end, but not longer than so many seconds."""
        if self._thread.is_alive():
            self._thread.join(timeout=max(0.0, seconds))

    @abstractmethod
    def _run(self) -> None:
        """Go on until `stopping` is set."""


def call_briefly(function: Callable[[], None]) -> None:
    """Call what ends things, and leave it to itself if it takes too long: the process is about to end."""
    thread = threading.Thread(target=function, daemon=True)
    thread.start()
    thread.join(timeout=_LONGEST_END)


def stop_all(threads: Sequence[BackgroundThread]) -> None:
    """Have threads finish what is under way, all at the same time, and end."""
    for thread in threads:
        thread.stopping.set()
    end = time.monotonic() + _LONGEST_END
    for thread in threads:
        thread.wait(end - time.monotonic())
