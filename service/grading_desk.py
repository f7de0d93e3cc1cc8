"""Where answers are judged: in threads, so many at a time; a long search for repairs stalls no one."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import anyio
import anyio.to_thread
from starlette.requests import Request

from kinematics.errors import Fault
from service.errors import BusyError

RETRY_SECONDS = 2

_Result = TypeVar("_Result")


class GradingDesk:
    """Lets so many answers be judged at a time, and so many wait."""

    def __init__(self, threads: int, waiting: int) -> None:
        self._limiter = anyio.CapacityLimiter(threads)
        self._places = threads + waiting
        self._taken = 0

    async def judge(self, work: Callable[[], _Result]) -> _Result:
        """Do the work in a thread, in turn.

        Raises:
            BusyError: as many answers as may wait are waiting.
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
        try:
            return await anyio.to_thread.run_sync(work, limiter=self._limiter)
        finally:
            self._taken -= 1


def desk_of(request: Request) -> GradingDesk:
    """The desk of the application that serves a request."""
    desk: GradingDesk = request.scope["app"].state.grading_desk
    return desk
