"""Students at 80 % of what the service can take, and hostile clients among them: `make mixed MINUTES=10`.

The mix: for each submission (two in five right, two in five with one mistake, one in five with two) one
opening of the page, ten tables read while they are typed and four drafts saved, each by any student of the
class; and of all draws one in twenty is one of tests/service/attacks, from another address. First the idle
service is asked for verdicts one after another. Then its ceiling for the mix is found by clients that wait
for nothing but answers: draws a second of which every honest one is answered as it should be; a refusal does
not count. Then requests come at 80 % of that rate, whenever they are due, for so many minutes. Told are the
verdicts' p99 beside that of the idle service, what honest clients were refused, how many requests were under
way (a queue that grows is a service that does not keep up), and the memory of the service's processes.
"""

import argparse
import asyncio
import json
import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from courses.model import LinkSettings
from courses.storage.database import open_store
from service.work.heaps import SWITCH_SECONDS
from tests.lti.exam import WORKERS, Browser, Outcome, enrolled, opened, ready, table
from tests.lti.test_killed import killed
from tests.service.attacks.beside import HOSTILE, Connection
from tests.service.attacks.corpus import Attack, attacks

READINGS, DRAFTS = 10, 4
HOSTILE_SHARE = 0.05
LOAD = 0.8
SLOWER = 5.0
"""Bar: p99 of a verdict under load to that of the idle service."""
GROWTH = 1.05
"""Bar: memory at the end to memory at half time."""
CLOSED = 64
"""Clients that look for the ceiling: fewer wait for transactions and leave the processors idle."""
LARGEST = 1024 * 1024
JSON = {"Content_Type": "application/json"}


@dataclass
class Seen:
    """What honest clients saw."""

    verdicts: list[float] = field(default_factory=list)
    answers: Counter[str] = field(default_factory=Counter)
    wrong: int = 0
    requests: int = 0
    memory: list[int] = field(default_factory=list)
    under_way: list[int] = field(default_factory=list)

    def note(self, kind: str, status: int) -> None:
        """Count an answer, and whether it is one."""
        self.requests += 1
        self.answers[f"{kind} {status}"] += 1
        self.wrong += not 200 <= status < 300

    def p99(self) -> float:
        """Of the verdicts [s]."""
        return sorted(self.verdicts)[int(0.99 * len(self.verdicts))]


class Mix:
    """Draws requests and carries them out."""

    def __init__(self, port: int, tokens: Sequence[str], seed: int = 1) -> None:
        self.port = port
        self.browsers = [Browser(port, token) for token in tokens]
        self.free = list(self.browsers)
        self.chance = random.Random(seed)
        self.hostile: list[Connection] = []
        self.corpus: list[Attack] = [attack for attack in attacks() if len(attack.body) < LARGEST]
        self.number = 0

    async def one(self, seen: Seen) -> None:
        """One request of the mix, drawn at random, of any student who waits for nothing."""
        if self.chance.random() < HOSTILE_SHARE:
            await self.attack()
            return
        if not self.free:
            self.free.append(Browser(self.port, self.chance.choice(self.browsers).token))
        chosen = self.chance.randrange(len(self.free))
        self.free[chosen], self.free[-1] = self.free[-1], self.free[chosen]
        browser = self.free.pop()
        try:
            await self.honest(browser, seen)
        finally:
            self.free.append(browser)

    async def attack(self) -> None:
        """Something of the corpus; whatever is answered is no error."""
        connection = self.hostile.pop() if self.hostile else Connection(self.port, HOSTILE)
        chosen = self.chance.choice(self.corpus)
        await connection.post(chosen.path, chosen.body)
        self.hostile.append(connection)

    async def honest(self, browser: Browser, seen: Seen) -> None:
        """An opening (four requests), a reading, a draft or a submission."""
        drawn = self.chance.randrange(READINGS + DRAFTS + 2)
        if drawn == 0:
            outcome = Outcome()
            await opened(browser, outcome, 0.0)
            for status, count in outcome.answers.items():
                for _ in range(count):
                    seen.note("opening", status)
        elif drawn == 1:
            await self.submit(browser, seen)
        elif drawn < 2 + READINGS:
            typed = {"table": self.table(0), "exercise": "puma560"}
            answer = await browser.ask("POST", "/api/v1/understand", json.dumps(typed).encode(), **JSON)
            seen.note("reading", answer.status)
        else:
            draft = json.dumps({"draft": {"table": self.table(0)}}).encode()
            seen.note("draft", (await browser.ask("PUT", "/api/v1/session/draft", draft, **JSON)).status)

    async def submit(self, browser: Browser, seen: Seen) -> None:
        """A submission that nobody made before."""
        body = json.dumps({"table": self.table(self.chance.choice((0, 0, 1, 1, 2)))}).encode()
        key = {"Idempotency_Key": f"mixed-{self.number}"}
        answer = await browser.ask("POST", "/api/v1/session/attempts", body, **JSON, **key)
        seen.note("submission", answer.status)
        seen.verdicts.append(answer.seconds)

    def table(self, mistakes: int) -> dict[str, object]:
        """A table that nobody made before."""
        self.number += 1
        return table(self.number, mistakes, self.chance)

    def close(self) -> None:
        """End all connections."""
        for connection in (*self.browsers, *self.free, *self.hostile):
            connection.close()

    async def ceiling(self, seconds: float) -> float:
        """Draws a second that clients get done who wait for nothing but answers [1/s].

        Honest draws that were answered as they should be, and as many hostile ones as belong to them.
        """
        until, right = time.monotonic() + seconds, 0

        async def client() -> None:
            nonlocal right
            while time.monotonic() < until:
                seen = Seen()
                await self.one(seen)
                right += seen.requests > 0 and not seen.wrong

        begun = time.monotonic()
        await asyncio.gather(*(client() for _ in range(CLOSED)))
        return right / (1 - HOSTILE_SHARE) / (time.monotonic() - begun)

    async def load(self, rate: float, seconds: float, seen: Seen, service: int) -> None:
        """Requests whenever they are due, whatever has been answered."""
        begun, under_way = time.monotonic(), set()
        weighing = asyncio.create_task(self.weigh(max(1.0, seconds / 100), seen, under_way, service))
        due = begun
        while time.monotonic() < begun + seconds:
            due += self.chance.expovariate(rate)
            await asyncio.sleep(max(0.0, due - time.monotonic()))
            task = asyncio.create_task(self.one(seen))
            under_way.add(task)
            task.add_done_callback(under_way.discard)
        weighing.cancel()
        await asyncio.gather(*under_way)
        if not seen.verdicts:  # one draw in sixteen is a submission, and a busy machine makes few in a moment
            await self.submit(self.browsers[0], seen)

    async def weigh(self, pause: float, seen: Seen, under_way: set[Any], service: int) -> None:
        """Note the service's memory and what is under way, again and again.

        In a thread: requests that fell due while this took the loop's time would all be sent at once.
        """
        while True:
            seen.memory.append(await asyncio.to_thread(memory_of, service))
            seen.under_way.append(len(under_way))
            await asyncio.sleep(pause)


def memory_of(group: int) -> int:
    """Memory of all processes of a group, what they share in parts [byte]."""
    total = 0
    for path in Path("/proc").glob("[0-9]*"):
        try:
            if int((path / "stat").read_text().rpartition(")")[2].split()[2]) == group:
                told = (path / "smaps_rollup").read_text()
                total += 1024 * int(told.split("\nPss:")[1].split()[0])
        except (OSError, IndexError):
            continue  # ended meanwhile
    return total


async def measured(port: int, tokens: Sequence[str], service: int, minutes: float, seek: float) -> Seen:
    """Idle, ceiling, load; told as they go."""
    sys.setswitchinterval(SWITCH_SECONDS)
    mix, idle, seen = Mix(port, tokens), Seen(), Seen()
    await mix.ceiling(seek / 4)  # caches and worker processes are warm
    until = time.monotonic() + seek
    while time.monotonic() < until or len(idle.verdicts) < 20:
        await mix.submit(mix.browsers[len(idle.verdicts) % len(mix.browsers)], idle)
    print(f"idle: p99 of {len(idle.verdicts)} verdicts {idle.p99() * 1e3:.1f} ms")
    ceiling = await mix.ceiling(seek)
    print(f"ceiling of the mix: {ceiling:.0f} draws a second")
    await mix.load(LOAD * ceiling, 60 * minutes, seen, service)
    mix.close()
    await asyncio.sleep(0)
    half, last = _mean(seen.memory[len(seen.memory) // 2 :][:5]), _mean(seen.memory[-5:])
    fifth = max(1, len(seen.under_way) // 5)
    queues = [seen.under_way[i : i + fifth] for i in range(0, len(seen.under_way), fifth)]
    ratio, grown = seen.p99() / idle.p99(), last / half
    print(
        f"{minutes:g} minutes at {LOAD:.0%}: {seen.requests} honest requests, {seen.wrong} errors\n"
        f"p99 of {len(seen.verdicts)} verdicts {seen.p99() * 1e3:.1f} ms, {ratio:.1f} times idle\n"
        f"memory {seen.memory[0] / 1e6:.0f} MB, at half time {half / 1e6:.0f}, at last {last / 1e6:.0f}\n"
        f"requests under way, mean of each fifth: {', '.join(f'{_mean(part):.1f}' for part in queues)}\n"
        f"{dict(seen.answers)}"
    )
    if ratio > SLOWER:
        print(f"over the bar: {ratio:.1f} > {SLOWER}")
    if grown > GROWTH:
        print(f"over the bar: memory grew by {grown - 1:.0%}")
    seen.wrong += idle.wrong + (ratio > SLOWER) + (grown > GROWTH)
    return seen


def _mean(values: Sequence[int]) -> float:
    return sum(values) / len(values)


def run(minutes: float, seek: float, students: int, database: str = "") -> Seen:
    """Start a service with a class, and measure it."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        store = open_store(database, folder)
        settings = LinkSettings(exercise_id="puma560", per_student=True, language="en")
        tokens = enrolled(store, students, settings)
        store.close()
        told = {"FRAMEWISE_WORKERS": str(WORKERS)}
        with killed(database, folder, told) as (origin, process):
            port = int(origin.rpartition(":")[2])
            asyncio.run(ready(port))
            return asyncio.run(measured(port, tokens, process.pid, minutes, seek))


def main() -> None:
    """Measure; exit with 1 if a bar was missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seek", type=float, default=20.0, help="seconds for the ceiling, and for idle")
    parser.add_argument("--students", type=int, default=200)
    parser.add_argument("--database", default="", help="URL of PostgreSQL; left out: SQLite")
    options = parser.parse_args()
    sys.exit(bool(run(options.minutes, options.seek, options.students, options.database).wrong))


if __name__ == "__main__":
    main()
