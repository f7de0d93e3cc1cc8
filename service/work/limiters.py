"""Work in threads: so many tasks at a time, so many waiting, and the next is told to come back."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import TypeVar

import anyio
import anyio.to_thread

from service.http.problems import busy
from service.settings import Settings

_Result = TypeVar("_Result")


class WorkKind(StrEnum):
    """What is done in threads; each kind has a limiter of its own, so that none waits behind another."""

    BATCH = "batch"
    GRADING = "grading"
    DRAWING = "drawing"


class Limiter:
    """Lets so many tasks run at a time, and so many wait."""

    def __init__(self, threads: int, waiting: int) -> None:
        self._threads = anyio.CapacityLimiter(threads)
        self._slots = threads + waiting
        self._taken = 0

    def acquire(self) -> Slot:
        """Take a slot until it is released.

        Raises:
            BusyError: as many as may wait are waiting.
        """
        if self._taken >= self._slots:
            raise busy()
        self._taken += 1
        return Slot(self, self._threads)

    def release(self) -> None:
        """Give a slot back."""
        self._taken -= 1

    async def run(self, work: Callable[[], _Result]) -> _Result:
        """Do the work in a thread, in turn.

        Raises:
            BusyError: as many as may wait are waiting.
        """
        slot = self.acquire()
        try:
            return await slot.run(work)
        finally:
            slot.release()


class Slot:
    """The right to have work done."""

    def __init__(self, limiter: Limiter, threads: anyio.CapacityLimiter) -> None:
        self._limiter: Limiter | None = limiter
        self._threads = threads

    async def run(self, work: Callable[[], _Result]) -> _Result:
        """Do a part of the work in a thread."""
        return await anyio.to_thread.run_sync(work, limiter=self._threads)

    def release(self) -> None:
        """Give the slot back; once is enough, twice does no harm."""
        if self._limiter is not None:
            self._limiter.release()
            self._limiter = None


def limiters(settings: Settings) -> dict[WorkKind, Limiter]:
    """The limiters of an application."""
    return {
        WorkKind.BATCH: Limiter(settings.batch_threads, settings.batch_queue),
        WorkKind.GRADING: Limiter(settings.grading_threads, settings.grading_queue),
        WorkKind.DRAWING: Limiter(1, settings.grading_queue),
    }
