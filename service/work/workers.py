"""Worker processes: for work whose cost no one can promise, under limits on processor time and memory.

Two lanes, so that what is hostile or merely large never stands before what is ordinary: the quick lane takes
work that is known to be small, the slow lane everything else. In each, clients take turns. A question that
is being answered is not computed a second time. A process that dies is replaced, and its task done again;
only a task that itself uses up its limits is refused.

Functions and arguments must be picklable, and what they import must not import the web framework.
"""

import asyncio
import hashlib
import math
import pickle
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from enum import StrEnum
from typing import Any, TypeVar

from kinematics.errors import Fault
from service.http.problems import RequestError, UnavailableError, busy
from service.settings import Settings
from service.work.fair_queue import FairQueue
from service.work.processes import Confinement, ProcessDiedError, UnansweredError, WorkerProcess
from service.work.worker_process import WorkOutcome

QUICK_CAPACITY = 8
"""The quick lane is so many times as fast as the slow one, or more: as many times as many may wait."""
SLOW_NICENESS = 10
"""The server, and the quick lane, come before the slow lane where there are fewer cores than processes."""
ATTEMPTS = 3
"""How often a task is given to a process that then dies: twice for bad luck, then the task is suspected."""
OVERLOAD = 6.0
"""A process that has not used up its processor time after so many times as long gets next to no processor."""
START_SECONDS = 20.0
"""What the first task of a process may take longer, while the process starts on a busy machine."""

_Result = TypeVar("_Result")


class Lane(StrEnum):
    """Which processes a task goes to."""

    QUICK = "quick"
    SLOW = "slow"


class Workers:
    """The worker processes of one server process. They start with the first task of their lane."""

    def __init__(self, settings: Settings) -> None:
        self.lanes = {
            Lane.QUICK: LaneProcesses(
                settings, processes=1, capacity=QUICK_CAPACITY * settings.symbolic_queue, niceness=0
            ),
            Lane.SLOW: LaneProcesses(
                settings,
                processes=settings.symbolic_workers,
                capacity=settings.symbolic_queue,
                niceness=SLOW_NICENESS,
            ),
        }

    async def run(self, lane: Lane, function: Callable[..., _Result], *arguments: Any) -> _Result:
        """Compute what the function gives, in a worker process.

        Raises:
            BusyError: the lane's queue is full, or the task's turn did not come in time.
            RequestError: the task ran out of processor time or memory.
            UnavailableError: the processes die.
            Exception: whatever the function raises.
        """
        result: _Result = await self.lanes[lane].run(function, *arguments)
        return result

    def warm(self) -> None:
        """Start the processes, so that the first request does not wait for them."""
        for lane in self.lanes.values():
            lane.heal()

    def close(self) -> None:
        """End the processes, whatever they are doing."""
        for lane in self.lanes.values():
            lane.close()


class LaneProcesses:
    """The processes of one lane, and those who wait for them.

    Attributes:
        queue: hands out the processes.
    """

    def __init__(self, settings: Settings, *, processes: int, capacity: int, niceness: int) -> None:
        self._seconds = settings.symbolic_seconds
        self._confinement = Confinement(
            memory=settings.symbolic_memory, seconds=settings.symbolic_seconds, niceness=niceness
        )
        self._count = processes
        self.queue = FairQueue(slots=processes, capacity=capacity, timeout=settings.queue_seconds)
        self._idle: list[WorkerProcess] = []
        self._busy: set[WorkerProcess] = set()
        self._threads = ThreadPoolExecutor(processes, thread_name_prefix="worker-process")
        self._closed = False
        self._answering: dict[tuple[int, bytes], _Shared] = {}

    async def run(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Do a task, or wait for the outcome of the same one."""
        task = pickle.dumps((function, arguments), pickle.HIGHEST_PROTOCOL)
        key = (id(asyncio.get_running_loop()), hashlib.blake2b(task).digest())
        shared = self._answering.get(key)
        if shared is None:
            shared = self._answering[key] = _Shared(asyncio.ensure_future(self._performed(task)))
            shared.task.add_done_callback(lambda _: self._answering.pop(key, None))
        try:
            reply = await shared.wait()
        finally:
            del shared  # or an error would know itself by this frame
        outcome, value = pickle.loads(reply)  # noqa: S301  from our own process
        if outcome == WorkOutcome.OUT_OF_MEMORY:
            megabytes = self._confinement.memory // 1024**2
            raise RequestError(Fault.at("computation_out_of_memory", megabytes=megabytes))
        if outcome == WorkOutcome.ERROR:
            raise value
        return value

    def heal(self) -> bool:
        """Replace the idle processes that have died; return whether none had, and all are there."""
        if self._closed:
            return False
        alive = [process for process in self._idle if process.is_alive]
        for process in set(self._idle) - set(alive):
            process.close()
        missing = self._count - len(alive) - len(self._busy)
        self._idle = alive + [WorkerProcess(self._confinement) for _ in range(missing)]
        return missing <= 0

    def close(self) -> None:
        """End the processes, whatever they are doing; there will be no others."""
        self._closed = True
        processes = {*self._idle, *self._busy}
        for process in processes:
            process.kill()
        self._threads.shutdown()
        for process in processes:
            process.close()
        self._idle.clear()

    async def _performed(self, task: bytes) -> bytes:
        slot = await self.queue.acquire()
        try:
            for _ in range(ATTEMPTS):
                try:
                    return await self._performed_once(task)
                except ProcessDiedError as died:
                    if died.ran_out_of_time:
                        raise _out_of_time(self._seconds) from None
            raise _aborted()
        except UnansweredError:
            raise busy() from None
        finally:
            slot.release()

    async def _performed_once(self, task: bytes) -> bytes:
        self.heal()
        if not self._idle:
            raise _aborted()  # the server is ending
        process = self._idle.pop()
        self._busy.add(process)
        timeout = OVERLOAD * self._seconds + START_SECONDS
        doing = self._threads.submit(process.perform, task, timeout)
        try:
            reply = await asyncio.wrap_future(doing)
        except BaseException:
            self._busy.discard(process)
            process.kill()
            # Its thread may still hold the connection: closed now, its number would go to the next process's.
            doing.add_done_callback(lambda _: process.close())
            self.heal()
            raise
        finally:
            del doing  # as `shared` above
        self._busy.discard(process)
        self._idle.append(process)
        return reply


class _Shared:
    """A task that several requests wait for; it is cancelled when the last of them has gone."""

    def __init__(self, task: asyncio.Future[bytes]) -> None:
        self.task = task
        self._waiting = 0

    async def wait(self) -> bytes:
        self._waiting += 1
        try:
            return await asyncio.shield(self.task)
        finally:
            self._waiting -= 1
            if self._waiting == 0 and not self.task.done():
                self.task.cancel()
            del self  # as `shared` above


def _out_of_time(seconds: float) -> RequestError:
    whole = int(seconds) if seconds == math.floor(seconds) else seconds
    return RequestError(Fault.at("computation_out_of_time", seconds=whole))


def _aborted() -> UnavailableError:
    return UnavailableError(Fault.at("computation_aborted"))
