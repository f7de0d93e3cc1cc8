"""Worker processes: for work whose cost no one can promise, under a hard time-out and a memory limit.

Two lanes, so that what is hostile or merely large never stands before what is ordinary: the quick lane takes
work that is known to be small, the slow lane everything else. Each lane has processes and a queue of its own;
a full queue is refused at once. A process whose task runs out of time is killed, its neighbours are unharmed.

A worker imports what its tasks need and never the web framework. Functions and arguments must be picklable.
"""

from __future__ import annotations

import asyncio
import gc
import math
import os
import resource
import signal
import threading
from collections.abc import Callable
from concurrent.futures.process import BrokenProcessPool
from enum import StrEnum
from typing import Any, TypeVar

from pebble import ProcessExpired, ProcessPool

from kinematics.errors import Fault
from service.http.problems import RequestError, busy
from service.settings import Settings
from service.work.processes import process_context

START_SECONDS = 20.0
"""What the first task of a lane may take longer, while its process starts."""
SLOW_NICENESS = 10
"""The server, and the quick lane, come before the slow lane where there are fewer cores than processes."""

_Result = TypeVar("_Result")


class Lane(StrEnum):
    """Which processes a task goes to."""

    QUICK = "quick"
    SLOW = "slow"


class Workers:
    """The worker processes of one server process. They start with the first task of their lane.

    Attributes:
        preparation: held while a request is made a task. A table of 64 rows takes some milliseconds to read;
            with one at a time, what else has arrived is answered between two of them.
    """

    def __init__(self, settings: Settings) -> None:
        self.preparation = asyncio.Lock()
        memory, seconds = settings.symbolic_memory, settings.symbolic_seconds
        self._lanes = {
            Lane.QUICK: _Processes(
                processes=1, queue=8 * settings.symbolic_queue, seconds=seconds, memory=memory, niceness=0
            ),
            Lane.SLOW: _Processes(
                processes=settings.symbolic_workers,
                queue=settings.symbolic_queue,
                seconds=seconds,
                memory=memory,
                niceness=SLOW_NICENESS,
            ),
        }

    async def run(self, lane: Lane, function: Callable[..., _Result], *arguments: Any) -> _Result:
        """What the function gives, computed in a worker process.

        Raises:
            BusyError: the lane's queue is full, or the task's turn did not come in time.
            RequestError: the task ran out of time or memory.
            Exception: whatever the function raises.
        """
        return await self._lanes[lane].run(function, *arguments)

    def warm(self) -> None:
        """Start the processes, so that the first request does not wait for them."""
        for lane in self._lanes.values():
            lane.warm()

    def close(self) -> None:
        """End the processes, whatever they are doing."""
        for lane in self._lanes.values():
            lane.close()


class _Processes:
    """The processes of one lane."""

    def __init__(self, *, processes: int, queue: int, seconds: float, memory: int, niceness: int) -> None:
        self._processes = processes
        self._places = processes + queue
        self._seconds = seconds
        self._memory = memory
        self._niceness = niceness
        self._taken = 0
        self._pool: ProcessPool | None = None
        self._started = threading.Event()

    async def run(self, function: Callable[..., _Result], *arguments: Any) -> _Result:
        if self._taken >= self._places:
            raise busy()
        waits = self._taken >= self._processes
        self._taken += 1
        try:
            future = self._schedule(function, *arguments)
            deadline = self._seconds if self._started.is_set() else self._seconds + START_SECONDS
            return await asyncio.wait_for(asyncio.wrap_future(future), deadline)
        except TimeoutError:
            # The deadline is for waiting and running together; pebble kills the process of a running task.
            raise busy() if waits else _out_of_time(self._seconds) from None
        except MemoryError:
            raise _out_of_memory(self._memory) from None
        except ProcessExpired:
            raise _aborted() from None
        except BrokenProcessPool:
            await asyncio.to_thread(self.close)  # the next task makes a new one
            raise _aborted() from None
        finally:
            self._taken -= 1

    def warm(self) -> None:
        self._schedule(_nothing)

    def close(self) -> None:
        if self._pool is not None:
            pool: Any = self._pool
            self._pool = None
            self._started = threading.Event()
            pool.stop()
            pool.join()

    def _schedule(self, function: Callable[..., Any], *arguments: Any) -> Any:
        if self._pool is None:
            self._pool = ProcessPool(
                max_workers=self._processes,
                initializer=_confine,
                initargs=(self._memory, self._niceness),
                context=process_context(),
            )
            started = self._started
            self._pool.schedule(_nothing).add_done_callback(lambda _: started.set())
        return self._pool.schedule(function, args=arguments, timeout=self._seconds)


def _confine(memory: int, niceness: int) -> None:
    """In a worker: leave Ctrl-C to the parent, bound the address space [byte], and stand back."""
    os.nice(niceness)
    gc.freeze()  # modules that were imported before are no garbage, and need not be looked through
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    limit = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))


def _nothing() -> None:
    """The task that starts a process."""


def _out_of_time(seconds: float) -> RequestError:
    return RequestError(
        Fault(
            code="computation_out_of_time",
            params={"seconds": int(seconds) if seconds == math.floor(seconds) else seconds},
        )
    )


def _aborted() -> RequestError:
    return RequestError(Fault(code="computation_aborted"))


def _out_of_memory(limit: int) -> RequestError:
    megabytes = limit // 1024**2
    return RequestError(
        Fault(
            code="computation_out_of_memory",
            params={"megabytes": megabytes},
        )
    )
