"""Work in threads: so many tasks at a time, shared fairly between clients; long waits are refused."""

import time
from collections import OrderedDict
from collections.abc import Callable, Hashable
from concurrent.futures import ThreadPoolExecutor
from enum import StrEnum
from typing import TypeVar

from service.settings import Settings
from service.work.fair_queue import FairQueue, Slot
from service.work.threads import in_thread

COURSE_THREADS = 16  # Requests that wait for the database, or for a platform, at the same time.
DONE = 512  # Questions that count as answered before; fewer than what they follow from is kept for.
LIGHT = 0.004
"""Work of a kind that takes no longer [s] is done in the event loop: a thread costs half a millisecond."""
TRIED = 3  # So many times work of a kind is done in a thread before it is known how long it takes.
FADING = 0.9  # What a kind of work took at the most counts so much less each time.
DRAWN_WITHIN = 300.0
"""Time that a request may wait for a drawing [s]: about as long as browsers do, which do not ask again for a
picture that was refused."""
_Result = TypeVar("_Result")


class WorkKind(StrEnum):
    """What is done in threads; each kind has a limiter of its own, so that none waits behind another."""

    BATCH = "batch"
    GRADING = "grading"
    DRAWING = "drawing"
    READING = "reading"
    COURSES = "courses"


class Limiter:
    """Lets so many tasks run at a time, and so many wait; what is light takes its turn in the event loop."""

    def __init__(
        self, *, threads: int, capacity: int, timeout: float, turns: FairQueue | None = None
    ) -> None:
        self._threads = ThreadPoolExecutor(threads, thread_name_prefix="limited")
        self._done: OrderedDict[Hashable, None] = OrderedDict()
        self._kinds: OrderedDict[Hashable, tuple[int, float]] = OrderedDict()
        self.queue = FairQueue(slots=threads, capacity=capacity, timeout=timeout)
        self._turns = turns or self.queue

    async def acquire(self) -> "ThreadSlot":
        """Wait for a slot, and take it until it is released.

        Raises:
            BusyError: as many as may wait are waiting, or the slot did not come in time.
        """
        return ThreadSlot(await self.queue.acquire(), self.queue, self._threads)

    async def run(self, work: Callable[[], _Result]) -> _Result:
        """Do the work in a thread, in turn.

        Raises:
            BusyError: as many as may wait are waiting, or the slot did not come in time.
        """
        slot = await self.acquire()
        try:
            return await slot.run(work)
        finally:
            slot.release()

    async def run_first(self, question: Hashable, work: Callable[[], _Result], kind: Hashable) -> _Result:
        """Do work in a thread the first time, and at once afterwards: what took long has been kept.

        Args:
            question: what the work follows from.
            work: what is to be done; it waits for nothing but the processor.
            kind: of work that takes about as long whatever it follows from; once it has been seen to take
                little, it is done at once the first time too, in turn with other requests in the event loop.

        Raises:
            BusyError: as in `run`.
        """
        if question in self._done:
            self._done.move_to_end(question)
            return work()
        result = await self._run_of(kind, work)
        self._done[question] = None
        while len(self._done) > DONE:
            self._done.popitem(last=False)
        return result

    async def _run_of(self, kind: Hashable, work: Callable[[], _Result]) -> _Result:
        times, most = self._kinds.get(kind, (0, 0.0))
        if times < TRIED or most > LIGHT:
            result, seconds = await self.run(lambda: _timed(work))
        else:
            await self._turns.turn()
            result, seconds = _timed(work)
        times, most = self._kinds.pop(kind, (0, 0.0))
        self._kinds[kind] = times + 1, max(seconds, FADING * most)
        while len(self._kinds) > DONE:
            self._kinds.popitem(last=False)
        return result


def _timed(work: Callable[[], _Result]) -> tuple[_Result, float]:
    """The result of work, and the time of the processor that it took [s]."""
    begun = time.thread_time()
    return work(), time.thread_time() - begun


class ThreadSlot:
    """The right to have work done in a thread."""

    def __init__(self, slot: Slot, queue: FairQueue, threads: ThreadPoolExecutor) -> None:
        self._slot, self._queue, self._threads = slot, queue, threads

    async def run(self, work: Callable[[], _Result]) -> _Result:
        """Do a part of the work in a thread."""
        return await in_thread(work, threads=self._threads)

    async def regain(self) -> None:
        """Wait for a slot again, if it was released.

        Raises:
            BusyError: as in `Limiter.acquire`.
        """
        if not self._slot.held:
            self._slot = await self._queue.acquire()

    def release(self) -> None:
        """Give the slot back; once is enough, twice does no harm."""
        self._slot.release()


def limiters(settings: Settings, turns: FairQueue | None = None) -> dict[WorkKind, Limiter]:
    """Return the limiters of an application, whose event loop does light work in such turns."""
    queue, wait = settings.grading_queue, settings.queue_seconds
    return {
        WorkKind.BATCH: Limiter(threads=settings.batch_threads, capacity=settings.batch_queue, timeout=wait),
        WorkKind.GRADING: Limiter(threads=settings.grading_threads, capacity=queue, timeout=wait),
        WorkKind.DRAWING: Limiter(threads=1, capacity=queue, timeout=max(wait, DRAWN_WITHIN), turns=turns),
        WorkKind.READING: Limiter(threads=1, capacity=queue, timeout=wait),
        WorkKind.COURSES: Limiter(threads=COURSE_THREADS, capacity=queue, timeout=wait),
    }
