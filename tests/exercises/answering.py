"""Answers, made and judged in one line."""

from typing import Any

from exercises.answers import RawAnswer, parse
from exercises.grader import Report, grade
from exercises.grading import HelpLevel
from exercises.instance import generate
from exercises.parts.report import PartReport
from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable
from kinematics.table import Convention
from tests.exercises.packaged import exercise


def table(
    convention: str, *rows: tuple[Any, Any, Any, Any], angle: str = "deg", length: str = "m"
) -> RawTable:
    """A table from rows (alpha, a, d, theta)."""
    return RawTable(
        convention=Convention(convention),
        rows=tuple(RawRow(alpha=alpha, a=a, d=d, theta=theta) for alpha, a, d, theta in rows),
        angle_unit=AngleUnit(angle),
        length_unit=LengthUnit(length),
    )


SCARA = table("standard", (0, "a2", 0, "q1"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4"))
SCARA_MATRICES = (
    [["c1", "-s1", 0, "a2*c1"], ["s1", "c1", 0, "a2*s1"], [0, 0, 1, 0], [0, 0, 0, 1]],
    [["cθ2", "sθ2", 0, "a3 cθ2"], ["s2", "-c2", 0, "a3*sin(q2)"], [0, 0, -1, 0], [0, 0, 0, 1]],
    [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, "d3"], [0, 0, 0, 1]],
    [["C(θ4)", "-S(θ4)", 0, 0], ["S(θ4)", "C(θ4)", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
)
SCARA_TRANSFORM = [
    ["cos(q1 + q2 - q4)", "sin(q1 + q2 - q4)", 0, "a2*c1 + a3*c12"],
    ["sin(q1 + q2 - q4)", "-cos(q1 + q2 - q4)", 0, "a2*s1 + a3*s12"],
    [0, 0, -1, "-q3"],
    [0, 0, 0, 1],
]


def judged(
    exercise_id: str, *, seed: str | None = None, help_level: HelpLevel | None = None, **parts: Any
) -> Report:
    """What is said of an answer."""
    instance = generate(exercise(exercise_id), seed)
    return grade(instance, parse(instance, RawAnswer(**parts)), help_level)


def part(report: Report, kind: str) -> PartReport:
    """What is said of one part."""
    return next(found for found in report.parts if found.kind == kind)


def codes(report: PartReport) -> list[str]:
    """The codes of its feedback."""
    return [entry.code for entry in report.feedback]


def edited(matrix: Any, row: int, column: int, cell: Any) -> list[list[Any]]:
    """A matrix with one cell changed."""
    copy = [list(cells) for cells in matrix]
    copy[row][column] = cell
    return copy
