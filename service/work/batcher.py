"""Batches concurrent calls: what arrives while one batch is processed forms the next.

Under little load nobody waits for a batch to fill: a batch is one item. Under much load it grows by itself,
and may be given a moment to grow: what a transaction costs (statements, round trips, the flush of its commit)
is shared by all that wait for it.
"""

import asyncio
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import Generic, TypeVar

from service.http.problems import busy

MOST = 64  # Items in a batch: beyond some dozens each costs no less, and all wait for the last.

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


class Batcher(Generic[_Item, _Result]):
    """Collects items into batches, processed in a thread one after another."""

    def __init__(
        self,
        work: Callable[[Sequence[_Item]], Sequence[_Result | Exception]],
        *,
        capacity: int,
        gives_up: Callable[[Exception], bool] = lambda _: False,
        pause: Callable[[], float] = lambda: 0.0,
    ) -> None:
        """Make a batcher.

        Args:
            work: returns for each item its result, or what is to be raised for it.
            capacity: how many items may wait.
            gives_up: whether a batch that failed so would fail item by item, too.
            pause: how long a batch that is not full may grow before it is worked on [s].
        """
        self._work, self._gives_up, self._pause, self._capacity = work, gives_up, pause, capacity
        self._waiting: deque[tuple[_Item, asyncio.Future[_Result]]] = deque()
        self._is_running = False
        self._lock = threading.Lock()
        self._threads = ThreadPoolExecutor(max_workers=1, thread_name_prefix="batcher")

    async def __call__(self, item: _Item) -> _Result:
        """Process an item in the next batch, and return its result.

        Raises:
            BusyError: as many as may wait are waiting.
        """
        future: asyncio.Future[_Result] = asyncio.get_running_loop().create_future()
        with self._lock:
            if len(self._waiting) >= self._capacity:
                raise busy()
            self._waiting.append((item, future))
            starts, self._is_running = not self._is_running, True
        if starts:
            self._threads.submit(self._run)
        try:
            return await future
        finally:
            del future  # or an error would know itself by this frame

    def close(self) -> None:
        """Finish what waits, and end the threads."""
        self._threads.shutdown(wait=True)

    def _run(self) -> None:
        while batch := self._next():
            self._answer([future for _, future in batch], self._found([item for item, _ in batch]))
            del batch  # or an error would know itself by this frame

    def _answer(
        self, futures: Sequence[asyncio.Future[_Result]], found: Sequence[_Result | Exception]
    ) -> None:
        answered = list(zip(futures, found, strict=True))
        for loop in {future.get_loop() for future in futures}:
            mine = [each for each in answered if each[0].get_loop() is loop]
            with suppress(RuntimeError):  # the loop has been closed: nobody waits
                loop.call_soon_threadsafe(_deliver, mine)

    def _next(self) -> list[tuple[_Item, asyncio.Future[_Result]]]:
        if 0 < len(self._waiting) < MOST and (seconds := self._pause()) > 0.0:
            time.sleep(seconds)
        with self._lock:
            batch = [self._waiting.popleft() for _ in range(min(MOST, len(self._waiting)))]
            self._is_running = bool(batch)
            return batch

    def _found(self, items: list[_Item]) -> Sequence[_Result | Exception]:
        """The results of a batch; where it fails as a whole, those of its items one by one."""
        try:
            return self._work(items)
        except Exception as error:
            if len(items) == 1 or self._gives_up(error):
                return [error] * len(items)
            return [result for item in items for result in self._found([item])]


def _deliver(answered: Sequence[tuple[asyncio.Future[_Result], _Result | Exception]]) -> None:
    """Give results to those who wait; whoever has gone gets none, and what was done stays done."""
    for future, result in answered:
        if future.done():
            continue
        if isinstance(result, Exception):
            future.set_exception(result)
        else:
            future.set_result(result)
