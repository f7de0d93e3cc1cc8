"""Slots for work, shared fairly: of those who wait, the client that used the least lately comes first.

A queue that is first come, first served gives everything to whoever asks most. Here a client has its turn
after at most one task of every other client, however many requests those have waiting. Use is counted by
address first and by connection second, so that students behind one address are fair to each other as well.
"""

from __future__ import annotations

import asyncio
import math
import time
from collections import OrderedDict
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import TypeAlias

from service.http.problems import busy

Client: TypeAlias = tuple[str, int]
"""Address and port that a request comes from."""

HALF_LIFE = 10.0
"""Seconds after which use counts half: long beside one task, short beside a lecture."""
CLIENTS = 4096
"""Clients whose use is remembered; the one that was idle longest is forgotten first."""

current_client: ContextVar[Client] = ContextVar("current_client", default=("", 0))
"""The client for whom work is being done; set for each request by the outer middleware."""


@dataclass(eq=False, slots=True)
class _Waiting:
    client: Client
    loop: asyncio.AbstractEventLoop
    granted: asyncio.Future[None] = field(init=False)

    def __post_init__(self) -> None:
        self.granted = self.loop.create_future()

    def grant(self) -> None:
        if self.loop is asyncio.get_running_loop():
            self._set()
        else:
            self.loop.call_soon_threadsafe(self._set)

    def _set(self) -> None:
        if not self.granted.done():
            self.granted.set_result(None)


class FairQueue:
    """Hands out slots.

    Attributes:
        waiting: how many requests wait for a slot.
        running: how many slots are taken.
    """

    def __init__(self, *, slots: int, capacity: int, timeout: float) -> None:
        """Make a queue.

        Args:
            slots: how many tasks run at a time.
            capacity: how many may wait.
            timeout: how long each of them may wait [s].
        """
        self._slots = slots
        self._capacity = capacity
        self._timeout = timeout
        self._waiting: list[_Waiting] = []
        self._used: OrderedDict[str | Client, tuple[float, float]] = OrderedDict()
        self.running = 0

    @property
    def waiting(self) -> int:
        """Return how many requests wait for a slot."""
        return len(self._waiting)

    async def acquire(self) -> Slot:
        """Wait for a slot, and take it until it is released.

        Raises:
            BusyError: as many as may wait are waiting, or the slot did not come in time.
        """
        client = current_client.get()
        if self.running < self._slots:
            self.running += 1
            return Slot(self, client)
        if len(self._waiting) >= self._capacity:
            raise busy()
        waiting = _Waiting(client, asyncio.get_running_loop())
        self._waiting.append(waiting)
        try:
            async with asyncio.timeout(self._timeout):
                await asyncio.shield(waiting.granted)
        except BaseException as error:
            if waiting in self._waiting:
                self._waiting.remove(waiting)
            else:  # granted in the very moment in which it was given up
                self.release(client, 0.0)
            if isinstance(error, TimeoutError):
                raise busy() from None
            raise
        return Slot(self, client)

    def release(self, client: Client, seconds: float) -> None:
        """Give a slot back that the client used for so long, and hand it to the next."""
        for key in (client[0], client):
            self._used[key] = (self._use(key) + seconds, time.monotonic())
            self._used.move_to_end(key)
        while len(self._used) > CLIENTS:
            self._used.popitem(last=False)
        if self._waiting:
            following = min(self._waiting, key=lambda one: (self._use(one.client[0]), self._use(one.client)))
            self._waiting.remove(following)
            following.grant()
        else:
            self.running -= 1

    def _use(self, key: str | Client) -> float:
        seconds, when = self._used.get(key, (0.0, 0.0))
        return seconds * math.exp2((when - time.monotonic()) / HALF_LIFE)


class Slot:
    """The right to have work done."""

    def __init__(self, queue: FairQueue, client: Client) -> None:
        self._queue: FairQueue | None = queue
        self._client = client
        self._since = time.monotonic()

    def release(self) -> None:
        """Give the slot back; once is enough, twice does no harm."""
        if self._queue is not None:
            queue, self._queue = self._queue, None
            queue.release(self._client, time.monotonic() - self._since)
