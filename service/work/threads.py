"""Calls in threads, of which nothing stays when they fail, and threads that run until the process ends."""

import asyncio
import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from contextvars import copy_context
from typing import Any, TypeVar, TypeVarTuple, cast

_Result = TypeVar("_Result")
_Arguments = TypeVarTuple("_Arguments")
_FEW = ThreadPoolExecutor(4, thread_name_prefix="few")
"""For what has no threads of its own: more of them would only wait for each other."""


async def in_thread(
    function: Callable[[*_Arguments], _Result], *arguments: *_Arguments, threads: ThreadPoolExecutor = _FEW
) -> _Result:
    """Return what a function gives in a thread, or raise what it raises.

    An exception that a future raises refers through its traceback to the frames that know the future, and so
    to itself: the cycle would keep a request and its body until the next garbage collection. Here it comes in
    a list, which is emptied.

    Raises:
        BaseException: whatever the function raises.
    """
    done: asyncio.Future[None] = asyncio.get_running_loop().create_future()
    found: list[tuple[Any, BaseException | None]] = []
    threads.submit(copy_context().run, _work, found, done, function, arguments)
    await done
    result, error = found.pop()
    if error is None:
        return cast(_Result, result)
    try:
        raise error
    finally:
        del error


def _work(
    found: list[tuple[Any, BaseException | None]],
    done: asyncio.Future[None],
    function: Callable[[*_Arguments], Any],
    arguments: tuple[*_Arguments],
) -> None:
    try:
        found.append((function(*arguments), None))
    except BaseException as error:  # whoever waits would wait for ever
        found.append((None, error))
    with suppress(RuntimeError):  # the loop has been closed: nobody waits
        done.get_loop().call_soon_threadsafe(_tell, done)


def _tell(done: asyncio.Future[None]) -> None:
    if not done.done():  # else whoever waited has gone
        done.set_result(None)


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
