"""A university on the evening of a deadline: 100 000 students, and what saturates first.

`make university` measures what one opening, one reading of a table, one saved draft and one submission cost
the service and PostgreSQL of processor time, on a real server and a real database; draws an evening of such
requests at random; and follows, second by second, how much work waits for how many cores. It writes a section
of docs/performance.md. What students do is an assumption (`Habits`), what it costs is measured.
"""

import argparse
import asyncio
import json
import os
import random
import tempfile
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import sqlalchemy as sa
from numpy.typing import NDArray

from bench.report import write
from courses.model import LinkSettings
from courses.storage.database import open_store
from service.work.score_sender import SIMULTANEOUS
from tests.databases import new_database, postgresql_server
from tests.lti.exam import Browser, Outcome, cpu_of, enrolled, handed_in, opened, submission, table
from tests.lti.test_killed import killed

Array = NDArray[np.float64]

EVENING = 6 * 3600
"""Seconds from six o'clock to the deadline at midnight."""
MARKS_A_SECOND = SIMULTANEOUS / 0.2
"""Marks that a process of the service delivers to a platform that takes 0.2 s for each."""
CORES = (2, 4, 8, 16, 32)


@dataclass(frozen=True)
class Habits:
    """What students do.

    Attributes:
        late: share of them who come before the deadline, the more the nearer it is; the others at any time.
        rush: mean time before the deadline at which those come [s].
        success: chance that an attempt is right; who fails tries again.
        attempts: at most so many.
        thinking: time between two attempts [s], on average.
        readings, drafts: tables read while they are typed, and drafts saved, for the first attempt; a fifth
            of that for each of the others.
    """

    late: float = 0.5
    rush: float = 2400.0
    success: float = 0.4
    attempts: int = 6
    thinking: float = 300.0
    readings: int = 60
    drafts: int = 25


@dataclass(frozen=True)
class Cost:
    """Processor time of the service and of PostgreSQL for one request [s]."""

    service: float
    database: float


@dataclass(frozen=True)
class Costs:
    """What each kind of request costs."""

    opening: Cost
    reading: Cost
    draft: Cost
    submission: Cost


def measured(students: int) -> Costs:
    """Measure a class of so many on one worker and PostgreSQL."""
    with postgresql_server() as server, new_database(server) as url, tempfile.TemporaryDirectory() as folder:
        store = open_store(url, Path(folder))
        settings = LinkSettings(exercise_id="puma560", per_student=True, language="en")
        tokens = enrolled(store, students, settings)
        store.close()
        with killed(url, Path(folder)) as (origin, process):
            port = int(origin.rpartition(":")[2])
            return asyncio.run(_measured(port, tokens, process.pid, _postmaster(url)))


async def _measured(port: int, tokens: list[str], service: int, postmaster: int) -> Costs:
    browsers = [Browser(port, token) for token in tokens]
    outcome = Outcome()
    typed = json.dumps({"table": table(1, 0, random.Random(1)), "exercise": "puma560"}).encode()
    draft = json.dumps({"draft": {"table": table(1, 0, random.Random(1))}}).encode()

    async def cost(act: Callable[[int, Browser], Awaitable[object]]) -> Cost:
        before = cpu_of(service), _cpu_of_children(postmaster)
        for n, browser in enumerate(browsers):
            await act(n, browser)
        after = cpu_of(service), _cpu_of_children(postmaster)
        return Cost(*((b - a) / len(browsers) for a, b in zip(before, after, strict=True)))

    async def sent(browser: Browser, method: str, path: str, body: bytes) -> None:
        answer = await browser.ask(method, path, body, Content_Type="application/json")
        assert answer.status < 300, answer.body

    async def submitted(n: int, browser: Browser) -> object:
        return await handed_in(browser, outcome, 0.0, n, submission(n))

    found = Costs(
        opening=await cost(lambda _, browser: opened(browser, outcome, 0.0)),
        reading=await cost(lambda _, browser: sent(browser, "POST", "/api/v1/understand", typed)),
        draft=await cost(lambda _, browser: sent(browser, "PUT", "/api/v1/session/draft", draft)),
        submission=await cost(submitted),
    )
    for browser in browsers:
        browser.close()
    assert outcome.errors == 0, outcome.answers
    return found


def _postmaster(url: str) -> int:
    """Process id of the server behind a URL with a socket's folder in it."""
    folder = Path(str(sa.make_url(url).query["host"]))
    return int((folder / "postmaster.pid").read_text().split()[0])


def _cpu_of_children(parent: int) -> float:
    """Processor time of a process's children so far, of those that ended as well [s]."""
    ticks = 0
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            name, _, rest = path.read_text().rpartition(")")
        except OSError:  # ended meanwhile
            continue
        fields = rest.split()
        if int(fields[1]) == parent:
            ticks += int(fields[11]) + int(fields[12])
        elif int(name.split()[0]) == parent:
            ticks += int(fields[13]) + int(fields[14])
    return ticks / os.sysconf("SC_CLK_TCK")


@dataclass(frozen=True)
class Evening:
    """Requests by second of the evening, (EVENING,) each."""

    openings: Array
    readings: Array
    drafts: Array
    submissions: Array

    def demand(self, costs: Costs, where: str) -> Array:
        """Processor time that is asked for in each second [s]."""
        pairs = (
            (self.openings, costs.opening),
            (self.readings, costs.reading),
            (self.drafts, costs.draft),
            (self.submissions, costs.submission),
        )
        total: Array = np.sum([count * getattr(cost, where) for count, cost in pairs], axis=0)
        return total


def evening(students: int, habits: Habits, seed: int = 1) -> Evening:
    """Draw an evening at random."""
    rng = np.random.default_rng(seed)
    late = rng.random(students) < habits.late
    start = np.where(late, EVENING - rng.exponential(habits.rush, students), rng.random(students) * EVENING)
    start = np.clip(start, 0.0, EVENING - 1.0)
    openings = _by_second(start)
    readings, drafts, submissions = (np.zeros(EVENING) for _ in range(3))
    at = start
    for attempt in range(habits.attempts):
        share = 1.0 if attempt == 0 else 0.2
        begun, at = at, at + rng.exponential(habits.thinking, len(at))
        if attempt == 0:  # who has begun hands in before the deadline
            at = np.where(at < EVENING, at, begun + rng.random(len(at)) * (EVENING - begun))
        begun, at = begun[at < EVENING], at[at < EVENING]
        for counts, many in ((readings, habits.readings), (drafts, habits.drafts)):
            when = rng.random((len(at), round(many * share)))
            counts += _by_second((begun[:, None] + when * (at - begun)[:, None]).ravel())
        submissions += _by_second(at)
        at = at[rng.random(len(at)) > habits.success]
    return Evening(openings, readings, drafts, submissions)


def _by_second(times: Array) -> Array:
    found: Array = np.bincount(times.astype(np.intp), minlength=EVENING).astype(np.float64)
    return found


def waiting(demand: Array, served: float) -> Array:
    """Work that is left over at the end of each second, where `served` of it can be done in one.

    The queue is b_t = max(0, b_{t−1} + demand_t − served) (Lindley, 1952).
    """
    total = np.cumsum(demand - served)
    left: Array = total - np.minimum(np.minimum.accumulate(total), 0.0)
    return left


def report(students: int, habits: Habits, costs: Costs) -> str:
    """The section of docs/performance.md."""
    drawn = evening(students, habits)
    service, database = drawn.demand(costs, "service"), drawn.demand(costs, "database")
    peak = [float(_smooth(counts).max()) for counts in (service, database, drawn.submissions)]
    requests = float(sum(map(np.sum, (4 * drawn.openings, drawn.readings, drawn.drafts, drawn.submissions))))
    lines = [
        "<!-- bench:university -->",
        "## A university on the evening of a deadline",
        "",
        f"`make university`: {students:,} students, six hours, {requests:,.0f} requests,",
        f"{drawn.submissions.sum():,.0f} submissions among them. What students do is assumed:",
        f"{habits.late:.0%} come in the rush before the deadline, on average {habits.rush / 60:.0f} minutes",
        f"before it, the others at any time; {habits.success:.0%} of the attempts are right, and",
        f"{habits.readings} keystrokes are read for the first table.",
        "What a request costs of processor time was measured, on one worker and PostgreSQL:",
        "",
        "| request | service | PostgreSQL |",
        "|---|--:|--:|",
    ]
    lines += [
        f"| one {name} | {cost.service * 1e3:.2f} ms | {cost.database * 1e3:.2f} ms |"
        for name, cost in vars(costs).items()
    ]
    lines += [
        "",
        f"In the busiest minute {peak[2]:.0f} submissions come a second; the service then needs",
        f"{peak[0]:.1f} cores, PostgreSQL {peak[1]:.1f}.",
        "",
        "| cores of the service | in use in the busiest minute | longest wait | wait at the deadline"
        " | last score after the deadline |",
        "|--:|--:|--:|--:|--:|",
    ]
    for cores in CORES:
        left = waiting(service, cores)
        posts = waiting(drawn.submissions, cores * MARKS_A_SECOND)
        lines.append(
            f"| {cores} | {min(1.0, peak[0] / cores):.0%} | {_time(left.max() / cores)} | "
            f"{_time(left[-1] / cores)} | {_time(posts[-1] / (cores * MARKS_A_SECOND))} |"
        )
    return "\n".join([*lines, "", *_first(peak), "", "<!-- /bench:university -->"])


def _smooth(counts: Array) -> Array:
    """Means over a minute."""
    return np.convolve(counts, np.full(60, 1.0 / 60.0), mode="valid")


def _time(seconds: float) -> str:
    return f"{seconds:.1f} s" if seconds < 100.0 else f"{seconds / 60.0:.0f} min"


def _first(peak: list[float]) -> list[str]:
    """What saturates first, with one core each."""
    service, database, submissions = peak
    needed = {
        "the service's processors": service,
        "PostgreSQL's processor": database,
        "the delivery of scores": submissions / MARKS_A_SECOND,
    }
    first, second, third = sorted(needed, key=lambda name: -needed[name])
    return [
        f"What saturates first is {first} ({needed[first]:.1f} cores or processes in the",
        f"busiest minute), then {second} ({needed[second]:.1f}), then {third}",
        f"({needed[third]:.1f}). Each process sends {SIMULTANEOUS} scores at a time,",
        f"{MARKS_A_SECOND:.0f} a second to a platform that takes 0.2 s for one; what waits is not lost.",
    ]


def main() -> None:
    """Measure, draw the evening, print, and write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=100_000)
    parser.add_argument("--measured", type=int, default=300, help="students whose requests are measured")
    options = parser.parse_args()
    section = report(options.students, Habits(), measured(options.measured))
    print(section)
    write("university", section)


if __name__ == "__main__":
    main()
