"""What students earned, as the gradebooks of Moodle and Canvas import them, and as a plain CSV file."""

import csv
import re
from collections.abc import Iterable, Sequence
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
class GradebookEntry:
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


def write_gradebook(entries: Iterable[GradebookEntry], stream: TextIO, form: GradebookFormat) -> None:
    """Write entries as they come; cells that a spreadsheet would take for a formula are written as text."""
    writer = csv.writer(stream, lineterminator="\n")
    match form:
        case GradebookFormat.CSV:
            writer.writerow(_PLAIN)
            writer.writerows(map(_plain_row, entries))
        case GradebookFormat.MOODLE:
            # Site administration calls the columns what it likes; these are the grade import's own names.
            writer.writerow(("Identifier", "Full name", "Grade", "Maximum Grade", "Feedback comments"))
            for entry in _best(entries):
                writer.writerow(
                    (safe(entry.identifier or entry.student), safe(entry.student), _number(entry.points),
                     _number(entry.max_points), safe(entry.feedback))
                )  # fmt: skip
        case GradebookFormat.CANVAS:
            _write_canvas(_best(entries), writer)


def _best(entries: Iterable[GradebookEntry]) -> list[GradebookEntry]:
    """Return one entry for each student and exercise: the one with the most points.

    A gradebook takes the last line of a student, and would have no mark where that could not be read. It has
    no line for what belongs to nobody, such as a forged receipt.
    """
    best: dict[tuple[str, str | None, str], GradebookEntry] = {}
    for entry in entries:
        key = entry.student, entry.identifier, entry.exercise
        if entry.student and entry.exercise and _rank(entry) > _rank(best.get(key)):
            best[key] = entry
    return list(best.values())


def _rank(entry: GradebookEntry | None) -> float:
    """The points; what could not be graded is less than none, and no entry less than that."""
    if entry is None:
        return -2.0
    return -1.0 if entry.points is None else entry.points


def safe(text: str) -> str:
    """Return the text as no spreadsheet takes it for a formula."""
    return _FORMULA.sub("'", text)


def _write_canvas(entries: Sequence[GradebookEntry], writer: "csv._writer") -> None:  # type: ignore[name-defined]
    """Canvas wants one column for an assignment and a second row with what it is worth."""
    exercises: dict[str, float | None] = {}
    for entry in entries:
        worth = exercises.get(entry.exercise)
        exercises[entry.exercise] = entry.max_points if worth is None else worth
    writer.writerow(("Student", "ID", "SIS Login ID", "Section", *map(safe, exercises)))
    writer.writerow(("    Points Possible", "", "", "", *map(_number, exercises.values())))
    students: dict[tuple[str, str], dict[str, float | None]] = {}
    for entry in entries:
        students.setdefault((entry.student, entry.identifier or ""), {})[entry.exercise] = entry.points
    for (student, identifier), points in students.items():
        given = (_number(points.get(name)) for name in exercises)
        number, login = (identifier, "") if identifier.isdecimal() else ("", identifier or student)
        writer.writerow((safe(student), number, safe(login), "", *given))


def _plain_row(entry: GradebookEntry) -> tuple[str, ...]:
    return (
        safe(entry.student),
        safe(entry.exercise),
        "" if entry.points is None else str(entry.correct).lower(),
        _number(entry.points),
        _number(entry.max_points),
        _number(entry.score),
        " ".join(entry.codes),
        safe(entry.feedback),
        safe(entry.source),
    )


def _number(value: float | None) -> str:
    return "" if value is None else format(value, ".6g")
