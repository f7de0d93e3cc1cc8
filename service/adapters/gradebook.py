"""Marks as the gradebooks of Moodle and Canvas import them, and as a plain CSV file."""

import csv
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import TextIO

_FORMULA = re.compile(r"^(?=[\t\r\n])|(?:^|(?<=[;\t\r\n]))(?=[ \xa0]{0,9}[=+\-@＝＋－＠])")
"""Where a spreadsheet would begin a formula: at the beginning of a cell, also of one that it makes of a text
because it takes a semicolon or a tab for the end of a cell."""


_PLAIN = ("student", "exercise", "correct", "points", "max_points", "score", "codes", "feedback", "source")


class GradebookFormat(StrEnum):
    """Formats of a gradebook file."""

    CSV = "csv"
    MOODLE = "moodle"
    CANVAS = "canvas"


@dataclass(frozen=True, kw_only=True, slots=True)
class Mark:
    """What one student earned.

    Attributes:
        student: the name or id that the hand-in bears.
        points: what was earned; None where nothing could be graded.
        correct: everything that was handed in is right.
        codes: what was found, as stable codes.
        feedback: the same in sentences.
        source: the file or receipt that it stems from.
        identifier: what the LMS calls the student, where it is known.
    """

    student: str
    exercise: str
    points: float | None = None
    max_points: float | None = None
    correct: bool = False
    codes: tuple[str, ...] = ()
    feedback: str = ""
    source: str
    identifier: str | None = None

    @property
    def score(self) -> float | None:
        """The points as a part of 1."""
        return None if self.points is None or not self.max_points else self.points / self.max_points


def write_marks(marks: Iterable[Mark], stream: TextIO, form: GradebookFormat = GradebookFormat.CSV) -> None:
    """Write marks as they come; cells that a spreadsheet would take for a formula are written as text."""
    writer = csv.writer(stream, lineterminator="\n")
    match form:
        case GradebookFormat.CSV:
            writer.writerow(_PLAIN)
            writer.writerows(map(_plain_row, marks))
        case GradebookFormat.MOODLE:
            # Site administration calls the columns what it likes; these are the grade import's own names.
            writer.writerow(("Identifier", "Full name", "Grade", "Maximum Grade", "Feedback comments"))
            for mark in _of_students(marks):
                writer.writerow(
                    (safe(mark.identifier or mark.student), safe(mark.student), _number(mark.points),
                     _number(mark.max_points), safe(mark.feedback))
                )  # fmt: skip
        case GradebookFormat.CANVAS:
            _write_canvas(_of_students(marks), writer)


def _of_students(marks: Iterable[Mark]) -> Iterator[Mark]:
    """Leave out what belongs to nobody, such as a forged receipt: a gradebook has no line for it."""
    return (mark for mark in marks if mark.student and mark.exercise)


def safe(text: str) -> str:
    """Return the text as no spreadsheet takes it for a formula."""
    return _FORMULA.sub("'", text)


def _write_canvas(marks: Iterable[Mark], writer: "csv._writer") -> None:  # type: ignore[name-defined]
    """Canvas wants one column for an assignment and a second row with what it is worth."""
    marks = list(marks)
    exercises: dict[str, float | None] = {}
    for mark in marks:
        worth = exercises.get(mark.exercise)
        exercises[mark.exercise] = mark.max_points if worth is None else worth
    writer.writerow(("Student", "ID", "SIS Login ID", "Section", *exercises))
    writer.writerow(("    Points Possible", "", "", "", *map(_number, exercises.values())))
    students: dict[tuple[str, str], dict[str, float | None]] = {}
    for mark in marks:
        students.setdefault((mark.student, mark.identifier or ""), {})[mark.exercise] = mark.points
    for (student, identifier), points in students.items():
        given = (_number(points.get(name)) for name in exercises)
        writer.writerow((safe(student), safe(identifier), "" if identifier else safe(student), "", *given))


def _plain_row(mark: Mark) -> tuple[str, ...]:
    return (
        safe(mark.student),
        safe(mark.exercise),
        "" if mark.points is None else str(mark.correct).lower(),
        _number(mark.points),
        _number(mark.max_points),
        _number(mark.score),
        " ".join(mark.codes),
        safe(mark.feedback),
        safe(mark.source),
    )


def _number(value: float | None) -> str:
    return "" if value is None else format(value, ".6g")
