"""What storing an attempt costs: right answers that nobody has handed in before, stored and not stored.

`python -m tests.lti.storage_price` needs wrk, and writes its section of docs/performance.md.
"""

import json
import os
import statistics
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from bench.bench_service import ROUNDS, SECONDS, _wrk
from bench.measure import Better, Outcome, Row
from bench.report import section, terminal, write
from courses.model import Role
from courses.people.enrolment import Arrival, arrive
from courses.storage.database import open_store
from service.course_resources import now
from tests.courses.classroom import platform
from tests.databases import new_database, postgresql_server
from tests.lti.test_killed import killed
from tests.web.driving import PUMA

TITLE = "Storing attempts"
ABOUT = """
One process of the service, 32 connections, `wrk` and the database on the same two cores, rounds in turns,
medians. Each answer is a right table of the PUMA 560 that nobody has handed in before, from one of 500
students: signed in, judged, stored with
its verdict and counted, every commit flushed to the disk. Beside it `POST /exercises/puma560/grade`, sent the
same bodies. Submissions that wait at the same time share a transaction.
"""
STUDENTS = 500
STORED, UNSTORED = "/api/v1/session/attempts", "/api/v1/exercises/puma560/grade"


def body() -> str:
    """A right table whose first offset is @, to be filled with any number: frame 0 may lie anywhere."""
    first, *others = PUMA["rows"]
    table = {"convention": "modified", "angle_unit": "deg", "length_unit": "m"}
    return json.dumps({"table": {**table, "rows": [{**first, "d": "@"}, *others]}})


def script(tokens: list[str]) -> str:
    """A script of wrk: another student, another number, another key each time."""
    before, after = body().split("@")
    return (
        "math.randomseed(tonumber(io.open('/dev/urandom', 'rb'):read(1):byte()) * 1000003 + os.time())\n"
        f"local tokens = {{{', '.join(json.dumps(token) for token in tokens)}}}\n"
        f"local before, after = {json.dumps(before)}, {json.dumps(after)}\n"
        "local count = 0\n"
        "request = function()\n"
        "  count = count + 1\n"
        "  local headers = {['Content-Type'] = 'application/json',\n"
        "    ['Authorization'] = 'Bearer ' .. tokens[math.random(#tokens)],\n"
        "    ['Idempotency-Key'] = string.format('%d-%.14f', count, math.random())}\n"
        "  return wrk.format('POST', nil, headers, before .. string.format('%.9f', math.random()) .. after)\n"
        "end\n"
    )


@dataclass
class Price:
    """Requests a second, and what each costs of the service's own processor time [s]."""

    rates: list[float] = field(default_factory=list)
    costs: list[float] = field(default_factory=list)


def measure(database: str, folder: Path) -> dict[str, Price]:
    """Stored and not stored, in turns."""
    folder.mkdir()
    store = open_store(database, folder)
    tokens = []
    for n in range(STUDENTS):
        told = Arrival(
            platform=platform(store),
            subject=f"s{n}",
            role=Role.LEARNER,
            deployment="1",
            context="c",
            resource="r",
            exercise_id="puma560",
        )
        tokens.append(arrive(store, told, now())[0])
    store.close()
    lua = folder / "post.lua"
    lua.write_text(script(tokens))
    found = {STORED: Price(), UNSTORED: Price()}
    with killed(database, folder) as (origin, process):
        port = int(origin.rpartition(":")[2])
        for path in found:
            _wrk(port, path, lua, 1)
        for _ in range(ROUNDS):
            for path, price in found.items():
                before = _spent(process.pid)
                rate = _wrk(port, path, lua, SECONDS)
                price.rates.append(rate)
                price.costs.append((_spent(process.pid) - before) / (rate * SECONDS))
    return found


def _spent(process: int) -> float:
    """Processor time of a process so far [s]."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def rows(name: str, found: dict[str, Price]) -> list[Row]:
    """The rate of what is stored beside what is not, and the cost of one beside the other."""
    stored, unstored = found[STORED], found[UNSTORED]
    work = f"right answers, ever new, stored on {name}"
    peer = "the same, not stored"
    bar = 0.5 if name == "PostgreSQL" else None
    return [
        Row(
            work=work,
            peer=peer,
            ours=statistics.median(stored.rates),
            theirs=statistics.median(unstored.rates),
            unit="requests/s",
            better=Better.MORE,
            bar=bar,
        ),
        Row(
            work=f"{work}: processor time of the service for one",
            peer=peer,
            ours=statistics.median(stored.costs),
            theirs=statistics.median(unstored.costs),
        ),
    ]


def main() -> None:
    """Measure, print, and write the page."""
    found: list[Outcome] = []
    with tempfile.TemporaryDirectory() as folder, postgresql_server() as server:
        with new_database(server) as url:
            found += rows("PostgreSQL", measure(url, Path(folder) / "postgresql"))
        found += rows("SQLite", measure("", Path(folder) / "sqlite"))
    print(terminal(found))
    write("storage", section("storage", TITLE, ABOUT, found))


if __name__ == "__main__":
    main()
