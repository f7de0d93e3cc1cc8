"""Work in threads: so many pieces at a time, so many waiting, and the next is told to come back."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import TypeVar

import anyio
import anyio.to_thread
from starlette.requests import Request

from service.http.problems import busy
from service.settings import Settings

_Result = TypeVar("_Result")


class Work(StrEnum):
    """What is done in threads; each kind has a gate of its own, so that none waits behind another."""

    BATCH = "batch"
    GRADING = "grading"
    DRAWING = "drawing"


class Gate:
    """Lets so many pieces of work be done at a time, and so many wait."""

    def __init__(self, threads: int, waiting: int) -> None:
        self._limiter = anyio.CapacityLimiter(threads)
        self._places = threads + waiting
        self._taken = 0

    def enter(self) -> Place:
        """Take a place until it is left.

        Raises:
            BusyError: as many as may wait are waiting.
        """
        if self._taken >= self._places:
            raise busy()
        self._taken += 1
        return Place(self, self._limiter)

    def leave(self) -> None:
        """Give a place back."""
        self._taken -= 1

    async def run(self, work: Callable[[], _Result]) -> _Result:
        """Do the work in a thread, in turn.

        Raises:
            BusyError: as many as may wait are waiting.
        """
        place = self.enter()
        try:
            return await place.run(work)
        finally:
            place.leave()


class Place:
    """The right to have work done."""

    def __init__(self, gate: Gate, limiter: anyio.CapacityLimiter) -> None:
        self._gate: Gate | None = gate
        self._limiter = limiter

    async def run(self, work: Callable[[], _Result]) -> _Result:
        """Do a piece of the work in a thread."""
        return await anyio.to_thread.run_sync(work, limiter=self._limiter)

    def leave(self) -> None:
        """Give the place back; once is enough, twice does no harm."""
        if self._gate is not None:
            self._gate.leave()
            self._gate = None


def gates(settings: Settings) -> dict[Work, Gate]:
    """The gates of an application."""
    return {
        Work.BATCH: Gate(settings.batch_threads, settings.batch_queue),
        Work.GRADING: Gate(settings.grading_threads, settings.grading_queue),
        Work.DRAWING: Gate(1, settings.grading_queue),
    }


def gate_for(work: Work, request: Request) -> Gate:
    """The gate of the application that serves a request."""
    found: dict[Work, Gate] = request.scope["app"].state.gates
    return found[work]
