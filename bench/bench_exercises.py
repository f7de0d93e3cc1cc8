"""Grading over HTTP beside an empty endpoint of the same application."""

import json
import shutil
import statistics
import tempfile
import time
from pathlib import Path

from bench import Better, Outcome, Skipped, measured, race
from bench.bench_service import ROUNDS, SECONDS, _serving, _wrk

TITLE = "Grading over HTTP"
ABOUT = """
One worker, 32 connections kept open, `wrk` on the same machine, rounds in turns, medians; the *empty
endpoint* is `async def empty(): return {}` of the same application, sent the same bodies. Every answer is a
right table of the PUMA 560 in Craig's modified form against a key in standard form. *The same answer* is
one table again and again, as a class hands in what stands in the book; *new answers* differ from one
another in a number, so that each is decided, verified and proved anew (of its rows, those that nobody has
handed in before are read anew). The bar for right answers is 800 requests/s or a quarter of the empty
endpoint's rate; it is stated here as that quarter.

A request costs more than it did: on the machine of 2026-11-29, the code of 2026-11-21 served 5,000 to 6,200
empty requests/s, 4,280 with the same answer (a ratio of 0.7), 648 with new ones in numbers (0.12) and 454 in
names (0.09), in an hour in which today's served 3,300, 2,080, 361 and 310.

The last rows are in process: the figure of an exercise, drawn and laid out, beside grading one new right
answer.
"""

PATH = "/api/v1/grade"
KEY = {
    "convention": "standard",
    "angle_unit": "deg",
    "rows": [
        {"alpha": 90, "a": 0, "d": 0, "theta": "q1"},
        {"alpha": 0, "a": "a2", "d": 0, "theta": "q2"},
        {"alpha": -90, "a": "a3", "d": "d3", "theta": "q3"},
        {"alpha": 90, "a": 0, "d": "d4", "theta": "q4"},
        {"alpha": -90, "a": 0, "d": 0, "theta": "q5"},
        {"alpha": 0, "a": 0, "d": 0, "theta": "q6"},
    ],
}
VALUES = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
CRAIG = [
    (0, 0, "@", "q1"),
    (-90, 0, 0, "q2"),
    (0, "a2", "d3", "q3"),
    (-90, "a3", "d4", "q4"),
    (90, 0, 0, "q5"),
]


def rows() -> list[Outcome]:
    """Measure."""
    return [*_over_http(), *_in_process()]


def _body(*, in_numbers: bool) -> str:
    """A request whose first offset is @, to be filled with any number: frame 0 may lie anywhere."""
    cells = [*CRAIG, (-90, 0, 0, "q6")]
    values = VALUES if in_numbers else {}
    submission = [
        {name: values.get(cell, cell) for name, cell in zip(("alpha", "a", "d", "theta"), row, strict=True)}
        for row in cells
    ]
    table = {"convention": "modified", "angle_unit": "deg", "rows": submission}
    text = json.dumps(
        {"reference": KEY, "submission": table, "parameters": VALUES, "policy": {"tool": "axis"}}
    )
    return text.replace('"@"', "@")


def _over_http() -> list[Outcome]:
    works = {
        "right 6-joint table, the same answer": (_body(in_numbers=True), "0.5"),
        "right 6-joint table in numbers, new answers": (_body(in_numbers=True), None),
        "right 6-joint table in names, new answers": (_body(in_numbers=False), None),
    }
    if shutil.which("wrk") is None:
        return [Skipped(work=work, reason="needs wrk (Debian: the package wrk)") for work in works]
    found: list[Outcome] = []
    with _serving() as port, tempfile.TemporaryDirectory() as folder:
        for work, (body, number) in works.items():
            script = Path(folder) / "post.lua"
            script.write_text(_script(body, number))
            rates: dict[str, list[float]] = {PATH: [], "/empty": []}
            for path in rates:
                _wrk(port, path, script, 1)
            for _ in range(ROUNDS):
                for path, measured_rates in rates.items():
                    measured_rates.append(_wrk(port, path, script, SECONDS))
            ours, empty = (statistics.median(rate) for rate in rates.values())
            found.append(
                measured(
                    f"`POST /grade`, {work}",
                    peer="an empty endpoint of the same application",
                    ours=ours,
                    theirs=empty,
                    unit="requests/s",
                    better=Better.MORE,
                    bar=0.25 if number else min(0.25, 800 / empty),
                )
            )
    return found


def _script(body: str, number: str | None) -> str:
    """A script of wrk that fills in one number, or a new one each time."""
    fill = json.dumps(number) if number else "string.format('%.6f', math.random())"
    before, after = body.split("@")
    return (
        f"math.randomseed({time.time_ns() % 1_000_000})\n"
        "wrk.method = 'POST'\nwrk.headers['Content-Type'] = 'application/json'\n"
        f"local before, after = {json.dumps(before)}, {json.dumps(after)}\n"
        f"request = function() return wrk.format(nil, nil, nil, before .. {fill} .. after) end\n"
    )


def _in_process() -> list[Outcome]:
    from exercises.drawings import figure_drawing
    from exercises.figures.svg import document
    from exercises.grading import accept
    from exercises.instance import generate
    from exercises.library import packaged
    from kinematics.cells import AngleUnit, RawRow, RawTable, read_table
    from kinematics.table import Convention

    found = packaged().exercise("puma560")
    instance = generate(found)
    count = iter(range(10**9))

    def graded() -> object:
        cells = [(*row[:2], f"{next(count)}/7919" if row[2] == "@" else row[2], row[3]) for row in CRAIG]
        names = ("alpha", "a", "d", "theta")
        rows = [RawRow(**dict(zip(names, row, strict=True))) for row in [*cells, (-90, 0, 0, "q6")]]
        raw = RawTable(convention=Convention.MODIFIED, rows=tuple(rows), angle_unit=AngleUnit.DEG)
        verdict = accept(found.reference, read_table(raw), found.policy, instance.parameters)
        assert verdict is not None
        return verdict

    def drawn() -> object:
        return document(figure_drawing(instance), title="PUMA 560", description="", language="en")

    return race(
        "one figure of the PUMA 560, in process", drawn, {"reading and grading one new right answer": graded}
    )
