"""A class graded from its files, without a server: time, and memory that does not grow with the class."""

import random
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from bench import Better, Outcome, measured

TITLE = "Grading a class from files"
ABOUT = """
`framewise grade` with two processes on a folder of 1 000 CSV files, one for each student: tables of the
PUMA 560 in six rows, no two alike, 40 % made right, 40 % with one mistake, 20 % with two (a sign, a twist,
two cells exchanged, a length of another link, a length that is doubled). Start and end of the processes are
part of it. The first row's peer is the bar of 10 s; the second row compares the largest process of that run
with that of a run over a fifth of the files.
"""

TABLES = 1000
SMALL = 200
SECONDS = 10.0
"""The bar: a class while its lecturer waits."""
ROWS = (
    ("0", "0", "0", "q1"),
    ("-90", "0", "0", "q2"),
    ("0", "a2", "d3", "q3"),
    ("-90", "a3", "d4", "q4"),
    ("90", "0", "0", "q5"),
    ("-90", "0", "0", "q6"),
)


def rows() -> list[Outcome]:
    """Measure."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for count in (SMALL, TABLES):
            written(folder / str(count), count)
        _, few = graded(folder / str(SMALL))
        seconds, many = graded(folder / str(TABLES))
    own = f"1 000 tables of six joints, {processor_seconds():.1f} s of processor time with the smaller run"
    memory = "largest process, 1 000 tables"
    return [
        measured(own, peer="bar", ours=seconds, theirs=SECONDS, unit="s", better=Better.LESS, bar=1.0),
        measured(memory, peer="200 tables", ours=many, theirs=few, unit="MB", better=Better.LESS, bar=0.9),
    ]


def written(folder: Path, count: int) -> None:
    """Write the files of a class."""
    folder.mkdir()
    chance = random.Random(7)
    for number in range(count):
        table = [list(row) for row in ROWS]
        mistakes = (0, 0, 1, 1, 2)[number % 5]
        for row in chance.sample(range(1, len(table)), mistakes):
            mistaken(table[row], chance)
        shifted = chance.randrange(len(table))
        table[shifted][3] += f" + {chance.uniform(1.0, 170.0):.4f}"
        lines = [",".join(row) for row in (("alpha", "a", "d", "theta"), *table)]
        (folder / f"student-{number:04}.csv").write_text("\n".join(lines) + "\n")


def mistaken(row: list[str], chance: random.Random) -> None:
    """Make one mistake in a row."""
    kind = chance.randrange(5)
    cell = chance.randrange(3)
    if kind == 0 and row[cell] != "0":
        row[cell] = row[cell][1:] if row[cell].startswith("-") else f"-{row[cell]}"
    elif kind == 1:
        row[0] = "90" if row[0] == "0" else "0"
    elif kind == 2 and row[1] != row[2]:
        row[1], row[2] = row[2], row[1]
    elif kind == 3:
        row[1] = "a3" if row[1] == "a2" else "a2"
    else:
        row[1] = "0.1" if row[1] == "0" else f"2*{row[1]}"


def graded(folder: Path) -> tuple[float, float]:
    """Grade a folder; return the time [s] and the size of the largest process so far [MB]."""
    command = [sys.executable, "-m", "service", "grade", str(folder), "--exercise", "puma560"]
    options = ["--convention", "modified", "--angle-unit", "deg", "--jobs", "2"]
    grades = folder.with_suffix(".csv")
    start = time.perf_counter()
    subprocess.run([*command, *options, "--output", str(grades)], check=True, capture_output=True)
    seconds = time.perf_counter() - start
    lines = grades.read_text().splitlines()[1:]
    right = sum(",true," in line for line in lines)
    assert len(lines) == len(list(folder.iterdir())), lines[:3]
    assert 0.4 * len(lines) <= right < 0.6 * len(lines), right
    return seconds, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def processor_seconds() -> float:
    """Return what all processes have taken [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
