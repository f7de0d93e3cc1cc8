"""The one function that grades an answer for every caller but the page itself, and the names of exercises."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import orjson

from exercises.answers import parse
from exercises.errors import ExerciseError
from exercises.grader import grade
from exercises.library import Library, packaged
from kinematics.cells import DEFAULT
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.scanner import scan
from kinematics.errors import Fault, KinematicsError
from service.http.problems import ServiceError, fault_sentence
from service.http.validation import validated
from service.messages import DEFAULT_LANGUAGE
from service.schemas.exercises.exercises import ExerciseAnswer
from service.wire.exercises.exercise_views import instance_of
from service.wire.exercises.verdicts import encoded, report_body


@dataclass(frozen=True, kw_only=True, slots=True)
class JudgedAnswer:
    """What an answer earned.

    Attributes:
        body: the answer of POST /exercises/{id}/grade.
        points: what was earned.
        max_points: what the parts that were handed in are worth.
        correct: everything that was handed in is right.
    """

    body: Mapping[str, Any]
    points: float
    max_points: float
    correct: bool

    @property
    def score(self) -> float:
        """The points as a part of 1."""
        return self.points / self.max_points

    @property
    def codes(self) -> tuple[str, ...]:
        """Codes of what was found, most important first; repairs by the codes of their edits."""
        return self._told("code")

    def sentences(self) -> tuple[str, ...]:
        """Return what a student is told, in the language of the call."""
        return self._told("message")

    def _told(self, member: str) -> tuple[str, ...]:
        """A member of all feedback: on the table, its first repair and the other parts."""
        told = [entry[member] for entry in self.body["feedback"]]
        told += [edit[member] for repair in self.body["repairs"][:1] for edit in repair["edits"]]
        for part in self.body["parts"].values():
            told += [entry[member] for entry in part["feedback"]]
        return tuple(dict.fromkeys(told))


@dataclass(frozen=True, kw_only=True, slots=True)
class NotGraded:
    """An answer that cannot be graded, and costs no attempt."""

    faults: tuple[Fault, ...]

    def sentences(self, language: str) -> tuple[str, ...]:
        """Return what is wrong, in a language, with its place."""
        return tuple(told_fault(fault, language) for fault in self.faults)


def told_fault(fault: Fault, language: str) -> str:
    """Return the sentence of a fault, behind its place."""
    text = fault_sentence(fault, language)
    place = ", ".join(str(step + 1 if isinstance(step, int) else step) for step in fault.where)
    return f"{place}: {text}" if place else text


def judge(
    exercise_id: str,
    answer: Mapping[str, Any],
    language: str = DEFAULT_LANGUAGE,
    library: Library | None = None,
) -> JudgedAnswer | NotGraded:
    """Grade an answer.

    Args:
        answer: the body of POST /exercises/{id}/grade: the parts, `seed`, `help`.
        library: the exercises; those of the package if left out.

    Raises:
        UnknownExerciseError: there is no such exercise.
    """
    library = library or packaged()
    library.exercise(exercise_id)
    try:
        wire = validated(ExerciseAnswer, answer)
        instance = instance_of(library, exercise_id, wire.seed)
        report = grade(instance, parse(instance, wire.raw(), DEFAULT), wire.help)
    except (KinematicsError, ExerciseError, ServiceError) as error:
        return NotGraded(faults=error.faults)
    return JudgedAnswer(
        body=orjson.loads(encoded(report_body(report, language))),
        points=report.points,
        max_points=sum(part.max_points for part in report.parts),
        correct=report.correct,
    )


def with_joint_types(
    exercise_id: str, table: Mapping[str, Any], library: Library | None = None
) -> Mapping[str, Any]:
    """Give a table of plain numbers the joint types of the exercise, row by row.

    Tables of other programs list offsets and name no variables. A table that says its joints itself, or has
    another number of rows than the exercise has joints, stays as it is.
    """
    types = (library or packaged()).exercise(exercise_id).reference.table.joint_types
    rows = table.get("rows")
    if (
        not isinstance(rows, list)
        or len(rows) != len(types)
        or not all(isinstance(row, dict) for row in rows)
    ):
        return table
    if any("joint" in row or _is_variable(row.get("theta")) or _is_variable(row.get("d")) for row in rows):
        return table
    return {**table, "rows": [{**row, "joint": kind.value} for row, kind in zip(rows, types, strict=True)]}


def _is_variable(cell: object) -> bool:
    """Whether a joint variable stands in a cell, however it is written, or what looks like one."""
    if not isinstance(cell, str):
        return False
    if _names_a_variable(cell.replace("\\", "").replace("_", "").replace(" ", "")):
        return True
    with suppress(CellRefusal):
        return any(_names_a_variable(token) for token in scan(cell) if token.type == "NAME")
    return False


def _names_a_variable(text: str) -> bool:
    lower = text.lower()
    return any(
        f"{letter}{digit}" in lower for letter in ("q", "θ", "theta", "d") for digit in "₁₂₃₄₅₆₇₈₉123456789"
    )


def exercise_named(name: str, library: Library | None = None) -> str | None:
    """Return the exercise that a file means by a robot's name: its id, whatever the case and the spaces."""
    bare = "".join(letter for letter in name.lower() if letter.isalnum())
    return next((known for known in (library or packaged()).ids if known.replace("-", "") == bare), None)
