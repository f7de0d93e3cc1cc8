"""An honest client beside 1, 4 and 8 clients of each attack: `make attacks`.

Starts a service of one worker. For each attack of the corpus so many clients send it as fast as it is
answered, for a second, while an honest one from another address asks for a forward kinematics and for a mark
in turn. Told are the honest client's p50 beside its p50 without attackers, its p99, what it was refused, and
the most memory that any process of the service held. The attackers run in a process of their own that yields
to all others, so that what is measured is the service and not the load on the machine.
"""

import argparse
import asyncio
import contextlib
import gc
import json
import multiprocessing
import os
import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from multiprocessing.synchronize import Event
from pathlib import Path
from typing import Any

from tests.lti.test_killed import killed
from tests.service.attacks.corpus import Attack, attacks

CLIENTS = (1, 4, 8)
SLOWER, LONGEST = 5.0, 0.050
"""Bars: p50 beside attackers to p50 without, and p99 [s]."""
MEMORY = 512 * 1024 * 1024
LARGEST = 4 * 1024 * 1024
EVERY = 0.004
"""Seconds between two requests of the honest client."""
PATIENCE = 60.0
HONEST, HOSTILE = "127.0.0.2", "127.0.0.3"


@dataclass
class Beside:
    """What the honest client saw beside so many clients of an attack."""

    attack: str
    clients: int
    seconds: list[float] = field(default_factory=list)
    answers: Counter[int] = field(default_factory=Counter)

    def at(self, share: float) -> float:
        """A quantile of its waiting times [s]."""
        return sorted(self.seconds)[min(len(self.seconds) - 1, int(share * len(self.seconds)))]


class Connection:
    """One connection that is kept open, from a chosen address."""

    def __init__(self, port: int, address: str) -> None:
        self.port, self.address = port, address
        self._streams: tuple[asyncio.StreamReader, asyncio.StreamWriter] | None = None

    async def post(self, path: str, body: bytes) -> int:
        """Send a request; returns the status, 0 where the connection was closed without one."""
        try:
            async with asyncio.timeout(PATIENCE):
                return await self._posted(path, body)
        except (OSError, asyncio.IncompleteReadError, TimeoutError):
            self.close()
            return 0

    async def _posted(self, path: str, body: bytes) -> int:
        if self._streams is None:
            self._streams = await asyncio.open_connection(
                "127.0.0.1", self.port, local_addr=(self.address, 0)
            )
        reader, writer = self._streams
        head = (
            f"POST {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nContent-Type: application/json\r\n"
            f"Content-Length: {len(body)}\r\n\r\n"
        )
        with contextlib.suppress(ConnectionError):  # refused before all of it was read: the answer is there
            writer.write(head.encode() + body)
        lines = (await reader.readuntil(b"\r\n\r\n")).decode("latin-1").lower().split("\r\n")
        told = {name: value.strip() for name, _, value in (line.partition(":") for line in lines[1:])}
        if told.get("transfer-encoding") == "chunked":
            while size := int(await reader.readuntil(b"\r\n"), 16):
                await reader.readexactly(size + 2)
            await reader.readexactly(2)
        else:
            await reader.readexactly(int(told.get("content-length", "0")))
        if told.get("connection") == "close":
            self.close()
        return int(lines[0].split()[1])

    def close(self) -> None:
        """End the connection."""
        if self._streams is not None:
            self._streams[1].close()
            self._streams = None


def honest_bodies() -> Iterator[tuple[str, bytes]]:
    """Yield without end what the honest client asks, no two of them alike."""
    chance = random.Random(1)
    while True:
        joints = [round(chance.uniform(-3, 3), 6) for _ in range(6)]
        yield "/api/v1/forward-kinematics", json.dumps({"robot": "puma560", "joints": joints}).encode()
        offset = round(chance.uniform(-1, 1), 6)
        rows = [
            {"theta": "q1", "d": 0, "a": "L1", "alpha": 0},
            {"theta": "q2", "d": offset, "a": "L2", "alpha": 0},
        ]
        table = {"convention": "standard", "rows": rows}
        yield "/api/v1/grade", json.dumps({"submission": table, "reference": table}).encode()


async def honest(port: int, seconds: float, bodies: Iterator[tuple[str, bytes]], seen: Beside) -> None:
    """Ask every few milliseconds; one question waits for the one before it."""
    connection = Connection(port, HONEST)
    until = due = time.monotonic()
    until += seconds
    while (begun := time.monotonic()) < until or not seen.seconds:
        seen.answers[await connection.post(*next(bodies))] += 1
        seen.seconds.append(time.monotonic() - begun)
        due = max(due + EVERY, time.monotonic())
        await asyncio.sleep(due - time.monotonic())
    connection.close()


def _attack(port: int, attack: Attack, clients: int, stop: Event, ready: Event) -> None:
    os.nice(19)

    async def one() -> None:
        connection = Connection(port, HOSTILE)
        while not stop.is_set():
            if await connection.post(attack.path, attack.body) == 0:
                await asyncio.sleep(0.01)
            ready.set()

    async def all_of_them() -> None:
        tasks = [asyncio.create_task(one()) for _ in range(clients)]
        while not stop.is_set():
            await asyncio.sleep(0.02)
        for task in tasks:
            task.cancel()

    asyncio.run(all_of_them())


def beside(
    port: int, attack: Attack, clients: int, seconds: float, bodies: Iterator[tuple[str, bytes]]
) -> Beside:
    """Measure one attack."""
    context = multiprocessing.get_context("fork")
    stop, ready = context.Event(), context.Event()
    process = context.Process(target=_attack, args=(port, attack, clients, stop, ready), daemon=True)
    process.start()
    ready.wait(PATIENCE)
    seen = Beside(attack.name, clients)
    try:
        asyncio.run(honest(port, seconds, bodies, seen))
    finally:
        stop.set()
        process.join(PATIENCE)
    return seen


def largest_of(group: int) -> int:
    """The most memory that any process of a group has held so far [byte]."""
    most = 0
    for path in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError, IndexError):
            if int((path / "stat").read_text().rpartition(")")[2].split()[2]) == group:
                line = next(s for s in (path / "status").read_text().splitlines() if s.startswith("VmHWM"))
                most = max(most, int(line.split()[1]) * 1024)
    return most


def over(seen: Beside, alone: Beside) -> str:
    """What bar was missed; nothing, where none was."""
    missed = []
    if seen.at(0.5) > SLOWER * alone.at(0.5):
        missed.append(f"p50 {seen.at(0.5) * 1e3:.1f} ms, {seen.at(0.5) / alone.at(0.5):.1f} times that alone")
    if seen.at(0.99) > LONGEST:
        missed.append(f"p99 {seen.at(0.99) * 1e3:.0f} ms")
    if set(seen.answers) != {200}:
        missed.append(f"answers {dict(seen.answers)}")
    return ", ".join(missed)


def run(
    chosen: Sequence[Attack], counts: Sequence[int], seconds: float, say: Any = print
) -> tuple[list[str], list[Beside], int]:
    """Measure attacks, told as they go; returns what missed a bar, all of it, and the most memory [byte]."""
    bodies = honest_bodies()
    missed, found = [], []
    gc.disable()  # a collection in this process would count as the service's delay
    with tempfile.TemporaryDirectory() as folder, killed("", Path(folder)) as (origin, process):
        port = int(origin.rpartition(":")[2])
        alone = Beside("nobody", 0)
        asyncio.run(honest(port, 1.0, bodies, Beside("nobody, to begin with", 0)))
        asyncio.run(honest(port, 3.0, bodies, alone))
        say(f"alone: p50 {alone.at(0.5) * 1e3:.2f} ms, p99 {alone.at(0.99) * 1e3:.2f} ms")
        for attack in chosen:
            for clients in counts:
                seen = beside(port, attack, clients, seconds, bodies)
                found.append(seen)
                if wrong := over(seen, alone):
                    missed.append(f"{attack.name}, {clients} clients: {wrong}")
                    say(missed[-1])
                if process.poll() is not None:
                    raise AssertionError(f"{attack.name} ended the service")
        memory = largest_of(process.pid)
    return missed, found, memory


def main() -> None:
    """Measure all attacks; exit with 1 if a bar was missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=1.0, help="for each attack and number of clients")
    parser.add_argument("--clients", type=int, nargs="*", default=list(CLIENTS))
    parser.add_argument("--only", default="", help="attacks with this in their names")
    parser.add_argument("--every", type=int, default=1, help="only every so manieth attack")
    options = parser.parse_args()
    chosen = [attack for attack in attacks() if len(attack.body) < LARGEST and options.only in attack.name]
    missed, found, memory = run(chosen[:: options.every], options.clients, options.seconds)
    halves = sorted(seen.at(0.5) for seen in found)
    tails = sorted(seen.at(0.99) for seen in found)
    print(
        f"{len(found)} measurements of {len(chosen[:: options.every])} attacks, {len(missed)} over a bar; "
        f"p50 at most {halves[-1] * 1e3:.1f} ms, p99 at most {tails[-1] * 1e3:.0f} ms "
        f"(half of them below {tails[len(tails) // 2] * 1e3:.1f} ms); "
        f"largest process {memory / 2**20:.0f} MiB"
    )
    sys.exit(bool(missed or memory > MEMORY))


if __name__ == "__main__":
    main()
