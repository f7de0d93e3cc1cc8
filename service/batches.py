"""Batches: computed block by block in a thread, sent while they are computed, so many at a time."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Iterator, Mapping
from typing import TypeVar

import anyio
import anyio.to_thread
from starlette.responses import StreamingResponse
from starlette.types import Receive, Scope, Send

from kinematics.errors import Fault
from service.errors import BusyError
from service.settings import Settings

RETRY_SECONDS = 2

_Result = TypeVar("_Result")


class Gate:
    """Lets so many batches be computed at a time, and so many wait."""

    def __init__(self, settings: Settings) -> None:
        self._limiter = anyio.CapacityLimiter(settings.batch_threads)
        self._places = settings.batch_threads + settings.batch_queue
        self._taken = 0

    def enter(self) -> Place:
        """Take a place until it is left.

        Raises:
            BusyError: as many batches as may wait are waiting.
        """
        if self._taken >= self._places:
            raise BusyError(
                Fault(
                    code="busy",
                    message=f"all places are taken; try again in {RETRY_SECONDS} s",
                    params={"seconds": RETRY_SECONDS},
                ),
                headers={"Retry-After": str(RETRY_SECONDS)},
            )
        self._taken += 1
        return Place(self, self._limiter)

    def leave(self) -> None:
        """Give a place back."""
        self._taken -= 1


class Place:
    """A batch's right to be computed."""

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


class BatchResponse(StreamingResponse):
    """Sends blocks as they are computed; the place is left when all is sent, or the caller has gone."""

    def __init__(
        self,
        blocks: Iterator[bytes | memoryview],
        place: Place,
        media_type: str,
        headers: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(_computed(blocks, place), media_type=media_type, headers=headers)
        self._place = place

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send."""
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._place.leave()


async def _computed(blocks: Iterator[bytes | memoryview], place: Place) -> AsyncIterator[bytes | memoryview]:
    while True:
        block = await place.run(lambda: next(blocks, None))
        if block is None:
            return
        yield block
