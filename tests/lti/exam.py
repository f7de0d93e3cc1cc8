"""An exam begins: so many students open the PUMA 560 within one second, and hand in for the first time.

`python -m tests.lti.exam --students 2000` starts a service of two workers, signs students in, and measures
openings (page, session, exercise, figure), all begun within a second; then submissions, due evenly over some
seconds: two in five right, two in five with one mistake, one in five with two, no two alike, all stored. With
`--variants` they share so many sets of values, prepared by `framewise warm`; without it each has their own.
"""

import argparse
import asyncio
import gzip
import json
import os
import random
import re
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast

import sqlalchemy as sa
import uvloop

from courses.model import LinkSettings, Role
from courses.people.enrolment import Arrival, arrive
from courses.storage import records
from courses.storage.database import Store, open_store
from courses.teaching.link_changes import change_settings
from service.course_resources import now
from tests.courses.classroom import platform
from tests.lti.test_killed import killed
from tests.web.driving import PUMA

WORKERS = 2
OPENED_WITHIN = 1.0
HANDED_IN_WITHIN, HANDED_IN_WITHIN_OF_VARIANTS = 6.0, 2.0
"""Seconds over which the openings, and the submissions, of a class are spread: of one that shares its values,
fewer, for all is to be answered before the last of the others have handed in."""
ALL_ANSWERED, ALL_ANSWERED_OF_VARIANTS, VERDICT = 10.0, 5.0, 2.0
"""What is promised of two thousand students on two quiet cores: seconds until all is answered, and the 99th
percentile of a verdict."""
LOOK, AT_REST = 3.0, 0.05
"""A service is at rest that has used so little of a processor [s/s] for so long [s]."""
PATIENCE = 120.0
"""How long a client waits for an answer [s]: on a busy machine nothing is an error that comes late."""
MISTAKES = (
    (1, "a", "a2"), (2, "a", "a3"), (2, "d", "d4"), (3, "alpha", "0"), (3, "a", "-a3"),
    (3, "d", "d3"), (4, "alpha", "0"), (4, "a", "a3"), (4, "d", "d4"), (5, "alpha", "0"),
)  # fmt: skip
"""Cells of which every one, and every two, make another robot."""
COURSE = "Exam"
LENGTH = re.compile(rb"\r\ncontent-length: *(\d+)\r\n")


@dataclass
class Answer:
    """What came back, and how long it took."""

    status: int
    sent: bytes
    seconds: float
    is_gzip: bool = False

    @property
    def body(self) -> bytes:
        """What was sent, unpacked: the client has the same processors, and reads only what it needs."""
        return gzip.decompress(self.sent) if self.is_gzip else self.sent


@dataclass
class Outcome:
    """What a run found.

    Attributes:
        answers: statuses of all answers, with how many there were of each.
        openings, verdicts: seconds that each took.
        right: how many submissions were found right; as many as were.
        expected: how many of them were.
        lost: how many acknowledged submissions are not stored, or stored twice.
        opened_after, answered_after: seconds from the first request to the last opening, to the last verdict.
        opening_cost, verdict_cost: processor time of the service for each [s].
        client_cost: processor time of the client for one student, who opens and hands in [s].
    """

    answers: Counter[int] = field(default_factory=Counter)
    openings: list[float] = field(default_factory=list)
    verdicts: list[float] = field(default_factory=list)
    right: int = 0
    expected: int = 0
    lost: int = 0
    opened_after: float = 0.0
    answered_after: float = 0.0
    opening_cost: float = 0.0
    verdict_cost: float = 0.0
    client_cost: float = 0.0

    @property
    def errors(self) -> int:
        """Answers that were none."""
        return sum(count for status, count in self.answers.items() if status != 200)


class Browser(asyncio.Protocol):
    """A student's connection: kept open, one request after another.

    It has the service's processors, so it does no more than it must.
    """

    def __init__(self, port: int, token: str) -> None:
        self.port, self.token = port, token
        self._transport: asyncio.Transport | None = None
        self._came = b""
        self._answered: asyncio.Future[tuple[int, bytes, bool]] | None = None

    async def ask(self, method: str, path: str, body: bytes = b"", **headers: str) -> Answer:
        """One request; a connection that was closed meanwhile is opened again, as browsers do."""
        begun = time.monotonic()
        loop = asyncio.get_running_loop()
        for _ in range(3):
            self._answered = loop.create_future()
            patience = loop.call_later(PATIENCE, self._give_up, TimeoutError())
            try:
                if self._transport is None:
                    await loop.create_connection(lambda: self, "127.0.0.1", self.port)
                assert self._transport is not None
                self._transport.write(self._request(method, path, body, headers))
                status, found, is_gzip = await self._answered
                return Answer(status, found, time.monotonic() - begun, is_gzip)
            except OSError:
                self.close()
            finally:
                patience.cancel()
        return Answer(0, b"", time.monotonic() - begun)

    def _request(self, method: str, path: str, body: bytes, headers: dict[str, str]) -> bytes:
        sent = {
            "Host": f"127.0.0.1:{self.port}",
            "Authorization": f"Bearer {self.token}",
            "Accept-Encoding": "gzip",
            "Content-Length": str(len(body)),
            **{name.replace("_", "-"): value for name, value in headers.items()},
        }
        head = "".join(f"{name}: {value}\r\n" for name, value in sent.items())
        return f"{method} {path} HTTP/1.1\r\n{head}\r\n".encode() + body

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Keep what is written to."""
        self._transport, self._came = cast(asyncio.Transport, transport), b""

    def data_received(self, data: bytes) -> None:
        """Answer once all that was announced is there."""
        self._came = came = self._came + data
        end = came.find(b"\r\n\r\n") + 4
        if end < 4 or self._answered is None or self._answered.done():
            return
        head = came[:end].lower()
        length = LENGTH.search(head)
        if len(came) < end + (int(length[1]) if length else 0):
            return
        self._came = b""
        if b"\r\nconnection: close\r\n" in head:
            self.close()
        self._answered.set_result((int(head[9:12]), came[end:], b"\r\ncontent-encoding: gzip\r\n" in head))

    def connection_lost(self, error: Exception | None) -> None:
        """Let who waits try again."""
        self._transport = None
        self._give_up(error or ConnectionResetError())

    def _give_up(self, error: Exception) -> None:
        if self._answered is not None and not self._answered.done():
            self._answered.set_exception(error)

    def close(self) -> None:
        """End the connection."""
        if self._transport is not None:
            self._transport.close()
            self._transport = None


def table(number: int, mistakes: int, chance: random.Random) -> dict[str, Any]:
    """A student's table: the first frame anywhere along its axis, so that no two are alike; and mistakes."""
    rows = [dict(row) for row in PUMA["rows"]]
    rows[0]["d"] = f"{0.1 + number / 100_000:.5f}"
    for row, cell, value in chance.sample(MISTAKES, mistakes):
        rows[row][cell] = value
    return {**PUMA, "angle_unit": "deg", "length_unit": "m", "rows": rows}


def mistakes_of(number: int) -> int:
    """How many mistakes a student makes: of five two none, two one, one two."""
    return (0, 1, 0, 1, 2)[number % 5]


def submission(number: int) -> bytes:
    """What a student hands in, as it is sent."""
    return json.dumps({"table": table(number, mistakes_of(number), random.Random(number))}).encode()


def enrolled(store: Store, students: int, settings: LinkSettings, course: str = COURSE) -> list[str]:
    """Sessions of a class, whose link has these settings."""
    known, tokens, link = platform(store), [], 0
    for number in range(students):
        told = {"deployment": "1", "context": course, "resource": course, "course_title": course}
        arrival = Arrival(platform=known, subject=f"{course} {number}", role=Role.LEARNER, **told)
        token, link = arrive(store, arrival, now())
        tokens.append(token)
    change_settings(store, link, settings, now())
    return tokens


async def opened(browser: Browser, outcome: Outcome, due: float) -> None:
    """Page, session, exercise and figure, as the page asks for them."""
    await asyncio.sleep(max(0.0, due - time.monotonic()))
    begun = time.monotonic()
    session = await browser.ask("GET", "/api/v1/session")
    seed = json.loads(session.body or b"{}").get("seed", "")
    query = f"?seed={seed}&lang=en"
    page = await browser.ask("GET", f"/exercises/puma560{query}")
    exercise = await browser.ask("GET", f"/api/v1/exercises/puma560{query}")
    named = re.search(rb'"file":"([^"]+)"', exercise.body)
    figure = await browser.ask("GET", f"/api/v1/{named[1].decode() if named else 'missing'}")
    outcome.answers.update(answer.status for answer in (session, page, exercise, figure))
    outcome.openings.append(time.monotonic() - begun)


async def handed_in(browser: Browser, outcome: Outcome, due: float, number: int, body: bytes) -> str | None:
    """The first submission; its key, where it was acknowledged."""
    await asyncio.sleep(max(0.0, due - time.monotonic()))
    key = f"exam-{number}"
    headers = {"Content_Type": "application/json", "Idempotency_Key": key}
    answer = await browser.ask("POST", "/api/v1/session/attempts", body, **headers)
    outcome.answers[answer.status] += 1
    outcome.verdicts.append(answer.seconds)
    if answer.status != 200:
        return None
    outcome.right += json.loads(answer.body)["correct"]
    return key


async def sat(
    port: int, tokens: list[str], service: int, within: tuple[float, float]
) -> tuple[Outcome, set[str]]:
    """The exam, from the first opening to the last verdict; and the keys of what was acknowledged."""
    outcome = Outcome()
    browsers = [Browser(port, token) for token in tokens]
    bodies = [submission(number) for number in range(len(browsers))]
    outcome.expected = sum(mistakes_of(number) == 0 for number in range(len(browsers)))
    count, spent = len(browsers), cpu_of(service)
    begun, own = time.monotonic(), time.process_time()
    due = [begun + within[0] * n / count for n in range(count)]
    await asyncio.gather(*(opened(b, outcome, at) for b, at in zip(browsers, due, strict=True)))
    outcome.opened_after = time.monotonic() - begun
    outcome.opening_cost = (cpu_of(service) - spent) / count
    spent, since = cpu_of(service), time.monotonic()
    due = [since + within[1] * n / count for n in range(count)]
    submissions = [
        handed_in(browser, outcome, at, number, body)
        for number, (browser, at, body) in enumerate(zip(browsers, due, bodies, strict=True))
    ]
    keys = await asyncio.gather(*submissions)
    outcome.answered_after = time.monotonic() - begun
    outcome.verdict_cost = (cpu_of(service) - spent) / count
    outcome.client_cost = (time.process_time() - own) / count
    for browser in browsers:
        browser.close()
    return outcome, {key for key in keys if key is not None}


def cpu_of(group: int) -> float:
    """Processor time of all processes of a group so far [s]."""
    ticks = sum(int(fields[11]) + int(fields[12]) for fields in _processes(group))
    return ticks / os.sysconf("SC_CLK_TCK")


def _processes(group: int) -> Iterator[list[str]]:
    """What `/proc/PID/stat` says of every process of a group, from its state on."""
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text().rpartition(")")[2].split()
        except OSError:  # ended meanwhile
            continue
        if int(fields[2]) == group:
            yield fields


def run(
    students: int,
    variants: Sequence[int | None],
    folder: Path,
    database: str = "",
    within: tuple[float, float] | None = None,
    settling: float = 0.0,
) -> Outcome:
    """Sit an exam.

    Args:
        students: how many there are in each class.
        variants: for each class how many sets of values its students share; None: each has their own.
        folder: of the SQLite file.
        database: URL of PostgreSQL instead.
        within: seconds over which the openings, and the submissions, are spread; None: the usual ones.
        settling: how long the service may take at the most to be done with its start [s].
    """
    if within is None:
        within = OPENED_WITHIN, HANDED_IN_WITHIN if None in variants else HANDED_IN_WITHIN_OF_VARIANTS
    descriptors = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (descriptors[1], descriptors[1]))
    store = open_store(database, folder)
    tokens = []
    for place, count in enumerate(variants, 1):
        settings = LinkSettings(exercise_id="puma560", per_student=True, variants=count, language="en")
        course = f"{COURSE} {place}"
        tokens += enrolled(store, students, settings, course)
        if count is not None:
            where = {
                "FRAMEWISE_STORAGE": "on",
                "FRAMEWISE_DATA_FOLDER": str(folder),
                "FRAMEWISE_DATABASE_URL": database,
            }
            warm = [sys.executable, "-m", "service", "warm", course]
            subprocess.run(warm, env={**os.environ, **where}, check=True)
    told = {"FRAMEWISE_WORKERS": str(WORKERS)}
    with killed(database, folder, told) as (origin, process):
        port = int(origin.rpartition(":")[2])
        asyncio.run(ready(port))
        _settle(process.pid, settling)
        outcome, acknowledged = uvloop.run(sat(port, tokens, process.pid, within))
    with store.reading() as connection:
        stored = Counter(connection.scalars(sa.select(records.attempt.c.key)))
    store.close()
    outcome.lost = len(acknowledged - set(stored)) + sum(count - 1 for count in stored.values())
    return outcome


async def ready(port: int) -> None:
    """Wait until every worker answers: connections are shared out among them."""
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        browsers = [Browser(port, "") for _ in range(4 * WORKERS)]
        found = await asyncio.gather(*(browser.ask("GET", "/readyz") for browser in browsers))
        for browser in browsers:
            browser.close()
        if all(answer.status == 200 for answer in found):
            return
        await asyncio.sleep(0.1)
    raise AssertionError("the service is not ready")


def _settle(group: int, most: float) -> None:
    """Wait until all threads of the service wait: exams begin at services that run.

    The processes for symbolic work import for seconds, when the first request has long been answered; and
    each process draws what the links of the newest courses will show.
    """
    until = time.monotonic() + most
    while time.monotonic() < until:
        spent = cpu_of(group)
        time.sleep(LOOK)
        if cpu_of(group) - spent <= AT_REST * LOOK:
            return


def told(outcome: Outcome, all_answered: float) -> str:
    """What a run found, in lines, beside the seconds in which all should be answered."""
    openings, verdicts = sorted(outcome.openings), sorted(outcome.verdicts)
    return "\n".join(
        (
            f"all opened after {outcome.opened_after:.1f} s, answered after {outcome.answered_after:.1f} s "
            f"(bar of 2000 students on two quiet cores: {all_answered:.0f} s)",
            f"an opening: p50 {_at(openings, 0.5):.2f} s, p99 {_at(openings, 0.99):.2f} s",
            f"a verdict: p50 {_at(verdicts, 0.5):.2f} s, p99 {_at(verdicts, 0.99):.2f} s "
            f"(bar: {VERDICT:.0f} s)",
            f"right {outcome.right} of {outcome.expected}, errors {outcome.errors}, lost {outcome.lost} "
            f"({dict(outcome.answers)})",
            f"processor time: {outcome.opening_cost * 1e3:.1f} ms an opening, "
            f"{outcome.verdict_cost * 1e3:.1f} ms a submission; of the client, "
            f"{outcome.client_cost * 1e3:.1f} ms a student",
        )
    )


def _at(values: list[float], share: float) -> float:
    return values[min(len(values) - 1, int(share * len(values)))]


def main() -> None:
    """Sit an exam, and say how it went; exit with 1 if anything was lost or refused."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=2000)
    parser.add_argument(
        "--variants", type=int, help="sets of values, prepared before; left out: one for each"
    )
    parser.add_argument("--database", default="", help="URL of PostgreSQL; left out: SQLite")
    parser.add_argument(
        "--within",
        type=float,
        nargs=2,
        metavar=("OPENED", "HANDED_IN"),
        help="seconds over which openings and submissions are spread; left out: "
        f"{OPENED_WITHIN:.0f} and {HANDED_IN_WITHIN:.0f}, with variants {HANDED_IN_WITHIN_OF_VARIANTS:.0f}",
    )
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        outcome = run(
            options.students,
            [options.variants],
            Path(folder),
            options.database,
            tuple(options.within) if options.within else None,
            settling=PATIENCE,
        )
    print(told(outcome, ALL_ANSWERED if options.variants is None else ALL_ANSWERED_OF_VARIANTS))
    sys.exit(bool(outcome.errors or outcome.lost or outcome.right != outcome.expected))


if __name__ == "__main__":
    main()
