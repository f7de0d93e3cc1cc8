"""Slots for work, shared fairly: of those who wait, the client that used the least lately comes first.

A queue that is first come, first served gives everything to whoever asks most. Here a client has its turn
after at most one task of every other client, however many requests those have waiting. A client is who has
proved who they are, wherever they ask from: a class behind one address are as many clients as they are
people. All others at an address are one. Use is counted by client first and by connection second.

Who begins to ask counts as having used little less than those who are being served, as in start-time fair
queueing (Goyal, Vin and Cheng, 1997): otherwise whoever worked while nobody waited would stand still until
a stranger had used as much.
"""

import asyncio
import math
import time
from collections import OrderedDict
from collections.abc import Callable
from contextvars import ContextVar
from dataclasses import dataclass, field
from functools import partial
from heapq import heappop, heappush, heapreplace
from typing import Literal, TypeAlias, TypeVar

from service.http.problems import busy


@dataclass(frozen=True, slots=True)
class Proven:
    """Who has proved who they are: a person by a session, however many they have, or a program by its key.

    What a person hands in counts by itself: it does not wait behind what they have looked at and typed, nor,
    unless it is much, behind what others do.
    """

    kind: Literal["person", "hand-in", "key"]
    id: int | str


Name: TypeAlias = str | Proven
"""Whom use is counted for: who has proved who they are, else the address that a request comes from."""
Client: TypeAlias = tuple[Name, int]  # Who asks, and the port of their connection.

HALF_LIFE = 10.0  # Seconds after which use counts half: long beside one task, short beside a lecture.
AHEAD = 0.02
"""Seconds of use by which a newcomer is ahead of those who are being served: the cost of some answers."""
FIRST = 0.1
"""Seconds of use up to which what a person hands in goes before what all look at and type: some answers."""
CLIENTS = 4096  # Clients whose use is stored; the one that was idle longest is dropped first.

ROUND = 0.001
"""Seconds for which the event loop goes from one request to the next without a look at its connections."""

current_client: ContextVar[Client] = ContextVar("current_client", default=("", 0))
"""The client for whom work is being done; set for each request by the outer middleware."""


def proven(who: Proven) -> None:
    """Have what follows in this request count for who has proved who they are, not for their address."""
    current_client.set((who, current_client.get()[1]))


@dataclass(eq=False, slots=True)
class _Waiting:
    client: Client
    loop: asyncio.AbstractEventLoop
    granted: asyncio.Future[bool] = field(init=False)
    left: bool = False

    def __post_init__(self) -> None:
        self.granted = self.loop.create_future()

    def grant(self) -> None:
        if self.loop is asyncio.get_running_loop():
            self.answer(granted=True)
        else:
            self.loop.call_soon_threadsafe(partial(self.answer, granted=True))

    def answer(self, *, granted: bool) -> None:
        if not self.granted.done():
            self.granted.set_result(granted)


class FairQueue:
    """Hands out slots.

    Attributes:
        waiting: how many requests wait for a slot.
        running: how many slots are taken.
    """

    def __init__(self, *, slots: int, capacity: int, timeout: float) -> None:
        """Make a queue.

        Each waits for at most `timeout` seconds.
        """
        self._slots = self._most = slots
        self._capacity, self._timeout = capacity, timeout
        self._line = _Line(self._use)
        self._used: OrderedDict[Name | Client, float] = OrderedDict()
        self._served: OrderedDict[Name | None, float] = OrderedDict()
        self.running = 0

    @property
    def waiting(self) -> int:
        """Return how many requests wait for a slot."""
        return len(self._line)

    async def acquire(self) -> "Slot":
        """Wait for a slot, and take it until it is released.

        Raises:
            BusyError: as many as may wait are waiting, or the slot did not come in time.
        """
        client = current_client.get()
        if self.running < self._slots:
            self.running += 1
            self._serve(client)
            return Slot(self, client)
        if len(self._line) >= self._capacity:
            raise busy()
        waiting = _Waiting(client, asyncio.get_running_loop())
        self._catch_up(client)
        self._line.join(waiting)
        patience = waiting.loop.call_later(self._timeout, partial(waiting.answer, granted=False))
        granted = False
        try:
            granted = await waiting.granted
        finally:
            patience.cancel()
            if not granted and not self._line.leave(waiting):
                self.release(client, 0.0)  # it was granted in the very moment in which it was given up
        if not granted:
            raise busy()
        return Slot(self, client)

    async def turn(self) -> None:
        """Wait for a slot and keep it for what follows at once, until the next wait for anything.

        Requests whose bodies have come go on in the order of their clients' use, a few between two looks of
        the event loop at its connections, or one once they have taken longer than `ROUND`: whoever sends
        many waits behind whoever sends one.

        Raises:
            BusyError: as in `acquire`.
        """
        slot = await self.acquire()
        asyncio.get_running_loop().call_soon(self._end_turn, slot)

    def _end_turn(self, slot: "Slot") -> None:
        self._slots = 1 if slot.seconds > ROUND else min(self._slots + 1, self._most)
        slot.release()

    def release(self, client: Client, seconds: float) -> None:
        """Give a slot back that the client used for so long, and hand it to the next."""
        used = math.log2(seconds) + time.monotonic() / HALF_LIFE if seconds > 0.0 else -math.inf
        for key in (client[0], client):
            _store(self._used, key, _sum_of_powers(self._use(key), used))
        self.running -= 1
        while self.running < self._slots and (following := self._line.next()) is not None:
            self.running += 1
            self._serve(following.client)
            following.grant()

    def _serve(self, client: Client) -> None:
        """Note how much was used by who is served next: of all names, and of the connections of one."""
        for among, key in _levels(client):
            _store(self._served, among, max(self._served.get(among, -math.inf), self._use(key)))

    def _catch_up(self, client: Client) -> None:
        """Count a newcomer's use as at most `AHEAD` less than that of those who are being served.

        Not that of who hands something in: it goes first, until they have handed in much.
        """
        passed = time.monotonic() / HALF_LIFE
        who, ahead = client[0], math.log2(AHEAD) + passed
        if isinstance(who, Proven) and who.kind == "hand-in" and self._use(who) < math.log2(FIRST) + passed:
            return
        for among, key in _levels(client):
            served = self._served.get(among, -math.inf)
            if served > ahead:
                least = served + math.log2(-math.expm1((ahead - served) * math.log(2.0)))
                _store(self._used, key, max(self._use(key), least))

    def _use(self, key: Name | Client) -> float:
        """How much a client has used, log2 of seconds as they would count at time 0.

        All use fades alike, so who has used less is the same at every time, and these numbers only grow.
        """
        return self._used.get(key, -math.inf)


_Key = TypeVar("_Key")


def _store(values: OrderedDict[_Key, float], key: _Key, value: float) -> None:
    """Keep a value by its key, and forget what was not touched for longest."""
    values[key] = value
    values.move_to_end(key)
    if len(values) > CLIENTS:
        values.popitem(last=False)


def _levels(client: Client) -> tuple[tuple[None, Name], tuple[Name, Client]]:
    """Return among whom use is compared, and whose: a name among all names, a connection among its name's."""
    return (None, client[0]), (client[0], client)


def _sum_of_powers(a: float, b: float) -> float:
    """log2(2^a + 2^b)."""
    low, high = sorted((a, b))
    return high if low == -math.inf else high + math.log2(1.0 + math.exp2(low - high))


_Place: TypeAlias = tuple[float, float, int, Name]
"""What was used under a name, what by its first connection, and since when that one waits."""


class _Line:
    """Those who wait, in the order of their use: by name, and for each its connections, as heaps.

    What somebody has used may have grown since they joined; a heap finds that out when their turn comes.
    """

    def __init__(self, use: Callable[[Name | Client], float]) -> None:
        self._use = use
        self._names: list[_Place] = []
        self._places: dict[Name, _Place] = {}
        self._connections: dict[Name, list[tuple[float, int, _Waiting]]] = {}
        self._joined = 0
        self._length = 0

    def __len__(self) -> int:
        return self._length

    def join(self, waiting: _Waiting) -> None:
        """Wait, behind all who have used as little."""
        name = waiting.client[0]
        self._joined += 1
        self._length += 1
        connections = self._connections.setdefault(name, [])
        heappush(connections, (self._use(waiting.client), self._joined, waiting))
        if connections[0][2] is waiting:
            place = self._key(name)
            if name not in self._places or place[:-1] < self._places[name][:-1]:
                self._places[name] = place
                heappush(self._names, place)

    def leave(self, waiting: _Waiting) -> bool:
        """Wait no more; return whether it was still waiting."""
        if waiting.left:
            return False
        waiting.left = True
        self._length -= 1
        return True

    def next(self) -> _Waiting | None:
        """Take out whose turn it is; None if nobody waits."""
        while self._names:
            known = self._names[0]
            name = known[-1]
            if self._places.get(name) is not known:  # it has moved forward since
                heappop(self._names)
            elif not self._tidied(name):
                heappop(self._names)
                del self._places[name]
            elif (now := self._key(name))[:-1] > known[:-1]:
                self._places[name] = now
                heapreplace(self._names, now)
            else:
                waiting = heappop(self._connections[name])[2]
                self.leave(waiting)
                return waiting
        return None

    def _key(self, name: Name) -> _Place:
        """What was used under a name, what by its first connection, and since when that one waits."""
        used, joined, _ = self._connections[name][0]
        return self._use(name), used, joined, name

    def _tidied(self, name: Name) -> bool:
        """Put the connection of least use at the head of its name; return whether there is any."""
        connections = self._connections.get(name)
        while connections:
            used, joined, waiting = connections[0]
            if waiting.left:
                heappop(connections)
            elif self._use(waiting.client) > used:
                heapreplace(connections, (self._use(waiting.client), joined, waiting))
            else:
                return True
        self._connections.pop(name, None)
        return False


class Slot:
    """The right to have work done."""

    def __init__(self, queue: FairQueue, client: Client) -> None:
        self._queue: FairQueue | None = queue
        self._client = client
        self._since = time.monotonic()

    @property
    def seconds(self) -> float:
        """How long it has been held [s]."""
        return time.monotonic() - self._since

    @property
    def held(self) -> bool:
        """Whether it has not been given back."""
        return self._queue is not None

    def release(self) -> None:
        """Give the slot back; once is enough, twice does no harm."""
        if self._queue is not None:
            queue, self._queue = self._queue, None
            queue.release(self._client, self.seconds)
