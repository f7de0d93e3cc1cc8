"""Matrices with a planted mistake, and what students make of them, written by the textbook's formulas."""

import random
from collections.abc import Iterator
from dataclasses import dataclass

from exercises.instance import Instance, generate
from exercises.parts.cells.short_forms import CELL_LIMITS
from exercises.parts.context import Context
from exercises.parts.mistakes.matrix_mistake import PART, FoundMatrixMistakeCells, MatrixMistakePart
from exercises.parts.mistakes.planted_matrices import PlantedMatrix
from exercises.parts.protocol import Answer, RawAnswer, Reading
from exercises.parts.report import PartReport
from exercises.written_table import written_table
from kinematics.table import Convention
from tests.exercises.packaged import exercise

EXERCISES = ("puma560-matrix-mistake", "stanford-matrix-mistake", "twolink-matrix-mistake")
Rows = list[list[str]]


def link(instance: Instance, row: int) -> Rows:
    """Return the matrix of a row by the formula that stands in every textbook."""
    reference = instance.exercise.reference
    cells = written_table(reference).rows[row]
    t, d, a, w = (f"({getattr(cells, cell)})" for cell in ("theta", "d", "a", "alpha"))
    c, s, ca, sa = f"cos{t}", f"sin{t}", f"cos{w}", f"sin{w}"
    last = ["0", "0", "0", "1"]
    if reference.table.convention is Convention.STANDARD:
        return [
            [c, f"-{s}*{ca}", f"{s}*{sa}", f"{a}*{c}"],
            [s, f"{c}*{ca}", f"-{c}*{sa}", f"{a}*{s}"],
            ["0", sa, ca, d],
            last,
        ]
    return [
        [c, f"-{s}", "0", a],
        [f"{s}*{ca}", f"{c}*{ca}", f"-{sa}", f"-{d}*{sa}"],
        [f"{s}*{sa}", f"{c}*{sa}", ca, f"{d}*{ca}"],
        last,
    ]


def product(first: Rows, second: Rows) -> Rows:
    """Return a product, written out."""
    return [
        [
            "+".join(f"({first[i][k]})*({second[k][j]})" for k in range(4) if first[i][k] != "0") or "0"
            for j in range(4)
        ]
        for i in range(4)
    ]


def wanted(instance: Instance) -> Rows:
    """Return the matrix that is asked, by the formulas."""
    found: PlantedMatrix = instance.drawn[PART.kind]
    if found.link is not None:
        return link(instance, found.link)
    rows = [link(instance, i) for i in range(len(instance.exercise.reference.table.rows))]
    whole = rows[0]
    for following in rows[1:]:
        whole = product(whole, following)
    return whole


@dataclass(frozen=True, kw_only=True)
class Student:
    """Somebody with a matrix of their own."""

    part: MatrixMistakePart
    instance: Instance
    context: Context

    def judged(self, raw: FoundMatrixMistakeCells) -> PartReport:
        """Return what is said of an answer."""
        reading = Reading(instance=self.instance, raw=RawAnswer(), table=None, limits=CELL_LIMITS)
        answer = PART.read(raw, reading)
        assert answer is not None, (raw, reading.faults)
        return PART.grade(self.part, answer, self.context)


def student(exercise_id: str, seed: int) -> Student:
    """Return a student of an exercise."""
    found = exercise(exercise_id)
    instance = generate(found, seed)
    answer = Answer(parts={}, angle_unit=found.angle_unit, length_unit=found.length_unit)
    (part,) = found.parts
    assert isinstance(part, MatrixMistakePart)
    return Student(
        part=part, instance=instance, context=Context(instance=instance, answer=answer, verdict=None)
    )


def mended(instance: Instance, rng: random.Random) -> Rows:
    """Return the right matrix, some of it written otherwise."""
    rows = wanted(instance)
    for _ in range(4):
        r, c = rng.randrange(3), rng.randrange(4)
        cell = rows[r][c]
        values = instance.parameters
        match rng.randrange(5):
            case 0:
                rows[r][c] = f"({cell})*(sin(q1)^2 + cos(q1)^2)"
            case 1 if len(cell) < CELL_LIMITS.cell_characters // 3:
                rows[r][c] = f"2*({cell}) - ({cell})"
            case 2:
                rows[r][c] = cell.replace("cos(q", "sin(90° + q")
            case 3:
                for name in sorted(values, key=len, reverse=True):
                    cell = cell.replace(f"({name})", f"({values[name]:g})")
                rows[r][c] = cell
            case _:
                rows[r][c] = cell.replace("cos(q", "c(q").replace("sin(q", "s(q")
    return rows


def cases(count: int, seed: int) -> Iterator[tuple[Student, Rows, bool]]:
    """Yield repairs, and whether they are right: every other one is the matrix as it was shown, or spoilt."""
    rng = random.Random(seed)
    students = [student(exercise_id, k) for exercise_id in EXERCISES for k in range(40)]
    for k in range(count):
        found = rng.choice(students)
        rows = mended(found.instance, rng)
        if k % 2 and rng.random() < 0.3:
            task = PART.task(found.part, found.instance)
            rows = [[str(cell) for cell in row] for row in task.numbers[-1].rows]
        elif k % 2:
            r, c = rng.randrange(4), rng.randrange(4)
            spoilt = [f"{rows[r][c]} + 0.05", f"{rows[r][c]} - sin(q1)/9", f"1.2*({rows[r][c]}) + 1/7"]
            rows[r][c] = rng.choice(spoilt)
        yield found, rows, not k % 2
