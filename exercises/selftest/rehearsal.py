"""What students will hand in and be told, for the author to look at."""

from contextlib import suppress
from dataclasses import dataclass, replace
from random import Random

from exercises.answers import RawAnswer
from exercises.definition import Exercise
from exercises.errors import AnswerError
from exercises.grader import Report
from exercises.grading import Edit, Feedback
from exercises.grading.edits.misconceptions import CATALOGUE
from exercises.instance import Instance, generate
from exercises.parts.protocol import TABLE
from exercises.parts.registry import part_type
from exercises.selftest.answers import context_of, judged_answer, other_frames
from exercises.selftest.mistakes import MISTAKES
from exercises.selftest.variants import key_as_asked
from exercises.written_table import written_table
from kinematics.cells import RawTable, ReadTable
from kinematics.errors import KinematicsError

TRIES = 12  # So many tables are made for each that is wanted: some come out alike.


@dataclass(frozen=True, kw_only=True, slots=True)
class RehearsedAnswer:
    """An answer as somebody might hand it in, and what it earns.

    Attributes:
        misconception: what was done to a right table; None for a right one.
        table: the table.
        refused: it cannot be graded, and costs no attempt.
        correct: the table is accepted.
        score: of the table, 0 … 1.
        points: of the table with everything that follows from it.
        max_points: what the exercise is worth.
        repairs: what would make the table right, as it is told at the exercise's own level of help.
        feedback: what else is told of the table.
        remarks: how many of the lecturer's own remarks are told.
    """

    misconception: str | None
    table: RawTable
    refused: bool = False
    correct: bool = False
    score: float = 0.0
    points: float = 0.0
    max_points: float = 0.0
    repairs: tuple[Edit, ...] = ()
    feedback: tuple[Feedback, ...] = ()
    remarks: int = 0


def right_answers(exercise: Exercise, count: int) -> tuple[RehearsedAnswer, ...]:
    """Return right answers with other frames, signs, zeros and conventions, as many as the policy allows."""
    instance = generate(exercise)
    key = key_as_asked(exercise.reference, exercise.policy)
    found = {written_table(key): key}
    for k in range(TRIES * count):
        if len(found) == count:
            break
        read = other_frames(instance, Random(f"{exercise.id} right {k}"))  # noqa: S311 - repeatable
        found.setdefault(written_table(read), read)
    return tuple(_rehearsed(instance, table, read, None) for table, read in found.items())


def usual_mistakes(exercise: Exercise) -> tuple[RehearsedAnswer, ...]:
    """Return every misconception that can be had about this robot, made in the key, the likeliest first.

    Of the ways in which one can be made the first is taken that is a mistake here and can be judged.
    """
    instance = generate(exercise)
    key = key_as_asked(exercise.reference, exercise.policy)
    found: list[RehearsedAnswer] = []
    for code, make in MISTAKES.items():
        refused = None
        for read in make(key):
            answer = _rehearsed(instance, written_table(read), read, code)
            refused = answer if answer.refused else refused
            if not answer.correct and not answer.refused:
                found.append(answer)
                break
        else:
            found += [refused] if refused else []
    return tuple(sorted(found, key=_likelihood))


def _likelihood(answer: RehearsedAnswer) -> int:
    """Return the place in the catalogue, which has the likeliest first."""
    code = answer.repairs[0].code if answer.repairs else answer.misconception
    places = (k for k, entry in enumerate(CATALOGUE) if code in (entry.told_as or (entry.code,)))
    return next(places, len(CATALOGUE))


def _rehearsed(
    instance: Instance, table: RawTable, read: ReadTable, misconception: str | None
) -> RehearsedAnswer:
    try:
        report = _report(instance, table, read)
    except AnswerError:
        return RehearsedAnswer(misconception=misconception, table=table, refused=True)
    verdict = report.verdict
    assert verdict is not None
    return RehearsedAnswer(
        misconception=misconception,
        table=table,
        correct=verdict.correct,
        score=verdict.score,
        points=report.points,
        max_points=report.max_points,
        repairs=tuple(
            replace(edit, params=dict(edit.params))
            for edit in (verdict.repairs[0].edits if verdict.repairs else ())
        ),
        feedback=tuple(replace(entry, params=dict(entry.params)) for entry in verdict.feedback),
        remarks=len(report.remarks),
    )


def _report(instance: Instance, table: RawTable, read: ReadTable) -> Report:
    """Return what is said of a table with everything that follows from it.

    From a wrong table not every part follows, or not in words that anybody would write: such a part is left
    out.

    Raises:
        AnswerError: the table itself is refused.
    """
    context = context_of(instance, read)
    answer = {TABLE: table}
    for part in instance.exercise.parts:
        if part.kind != TABLE:
            with suppress(KinematicsError):
                answer[part.kind] = part_type(part.kind).right(part, context)
    try:
        return judged_answer(instance, RawAnswer(**answer))
    except AnswerError as error:
        refused = {str(fault.where[0]) for fault in error.faults if fault.where}
        if TABLE in refused or not refused & answer.keys():
            raise
        kept = {kind: raw for kind, raw in answer.items() if kind not in refused}
        return judged_answer(instance, RawAnswer(**kept))
