"""`grade`: an answer judged, part by part."""

from collections.abc import Mapping
from dataclasses import dataclass

from exercises import grading
from exercises.access import lowest
from exercises.answers import Answer
from exercises.definition import Exercise
from exercises.departure import Departure, departure_of
from exercises.drawings import KeyPose, key_pose
from exercises.grading import HelpLevel, Verdict
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.following import as_it_follows
from exercises.parts.registry import part_type
from exercises.parts.report import PLACES, Credit, PartReport
from kinematics.cells import AngleUnit, LengthUnit


@dataclass(frozen=True, kw_only=True, slots=True)
class Report:
    """What is said of an answer; it can be stored, and shown later in any language.

    Attributes:
        verdict: on the table, if one was handed in.
        parts: on each part that was handed in, in the exercise's order.
        missing: parts that are asked and were not handed in.
        points: what the answer earned.
        help_level: how much was told.
        seed: from what the student's values were drawn.
        angle_unit: unit of the answer's angles.
        length_unit: unit of the answer's lengths.
        figure: how the key lies in the figure; with an accepted table only.
        departure: where the robot of a wrong table leaves the figure's; from the help level `kind` on.
        remarks: the lecturer's own words, by language, on what was found.
    """

    verdict: Verdict | None
    parts: tuple[PartReport, ...]
    missing: tuple[str, ...]
    points: float
    max_points: float
    help_level: HelpLevel
    seed: str | None
    version: int
    angle_unit: AngleUnit
    length_unit: LengthUnit
    figure: KeyPose | None
    departure: Departure | None = None
    remarks: tuple[Mapping[str, str], ...] = ()

    @property
    def score(self) -> float:
        """The points as a part of 1."""
        return self.points / self.max_points

    @property
    def correct(self) -> bool:
        """Everything that was handed in is right."""
        return all(part.correct for part in self.parts)


def allowed_help(exercise: Exercise, asked: HelpLevel | None, attempt: int | None = None) -> HelpLevel:
    """Return the help that an answer gets: as asked for, never more than the exercise allows by then."""
    most = exercise.access.help_at(attempt)
    return most if asked is None else lowest((asked, most))


def grade(
    instance: Instance,
    answer: Answer,
    help_level: HelpLevel | None = None,
    attempt: int | None = None,
    *,
    drawn: bool = True,
) -> Report:
    """Judge an answer.

    Args:
        answer: what was handed in, as read.
        help_level: how much may be told; never more than the exercise allows.
        attempt: which attempt it is, from 1, for the exercise's help ladder.
        drawn: whether somebody will look at where the robot of a wrong table departs.
    """
    exercise = instance.exercise
    level = allowed_help(exercise, help_level, attempt)
    verdict = _verdict(instance, answer, level)
    context = Context(instance=instance, answer=answer, verdict=verdict)
    reports: list[PartReport] = []
    for part in exercise.parts:
        given = answer.get(part.kind)
        if given is not None:
            judge = part_type(part.kind)
            found = judge.grade(part, given, context)
            if found.credit is Credit.OWN_TABLE:
                found = as_it_follows(found, context.own_share)
            reports.append(judge.shown(found, level))
    return Report(
        verdict=verdict,
        parts=tuple(reports),
        missing=tuple(part.kind for part in exercise.parts if answer.get(part.kind) is None),
        points=round(sum(report.points for report in reports), PLACES),
        max_points=float(exercise.points),
        help_level=level,
        seed=instance.seed,
        version=exercise.version,
        angle_unit=answer.angle_unit,
        length_unit=answer.length_unit,
        figure=key_pose(instance) if context.own_correct else None,
        departure=_departure(instance, answer, verdict, level) if drawn else None,
        remarks=_remarks(exercise, verdict),
    )


def _verdict(instance: Instance, answer: Answer, level: HelpLevel) -> Verdict | None:
    if answer.table is None:
        return None
    exercise = instance.exercise
    return grading.grade(
        exercise.reference, answer.table, exercise.policy, instance.parameters, level, exercise.weights
    )


def _departure(
    instance: Instance, answer: Answer, verdict: Verdict | None, level: HelpLevel
) -> Departure | None:
    if verdict is None or answer.table is None or lowest((level, HelpLevel.KIND)) is not HelpLevel.KIND:
        return None
    return departure_of(instance, answer.table, verdict)


def _remarks(exercise: Exercise, verdict: Verdict | None) -> tuple[Mapping[str, str], ...]:
    """Return the lecturer's words on the most plausible repair; none where help keeps repairs back."""
    codes = [edit.code for repair in (verdict.repairs[:1] if verdict else ()) for edit in repair.edits]
    return tuple(exercise.remarks[code] for code in dict.fromkeys(codes) if code in exercise.remarks)
