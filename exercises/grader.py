"""`grade`: an answer judged, part by part."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exercises import grading
from exercises.answers import Answer
from exercises.consistency import values_in_radians
from exercises.definition import Exercise, Part, PartKind, PosePart, WorkspacePart
from exercises.grading import Feedback, HelpLevel, Verdict
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.link_matrices import grade_link_matrices
from exercises.parts.matrix_cells import SymbolicMatrix
from exercises.parts.pose import grade_pose
from exercises.parts.report import Credit, PartReport, at_least
from exercises.parts.schematic import grade_schematic
from exercises.parts.transform import grade_transform
from exercises.parts.value import is_robot
from exercises.parts.workspace import grade_workspace
from kinematics.cells import LengthUnit, ParameterKind
from kinematics.table import JointType


@dataclass(frozen=True, kw_only=True, slots=True)
class Report:
    """What is said of an answer.

    Attributes:
        verdict: on the table, if one was handed in.
        parts: on each part that was handed in, in the exercise's order.
        missing: parts that are asked and were not handed in.
        points: what the answer earned.
        max_points: what the exercise is worth.
        help_level: how much was told.
    """

    verdict: Verdict | None
    parts: tuple[PartReport, ...]
    missing: tuple[PartKind, ...]
    points: float
    max_points: float
    help_level: HelpLevel

    @property
    def score(self) -> float:
        """The points as a part of 1."""
        return self.points / self.max_points

    @property
    def correct(self) -> bool:
        """Everything that was handed in is right."""
        return all(part.correct for part in self.parts)


def allowed_help(exercise: Exercise, asked: HelpLevel | None) -> HelpLevel:
    """The level of help that an answer gets: what was asked for, and never more than the exercise allows."""
    if asked is None or at_least(asked, exercise.help):
        return exercise.help
    return asked


def grade(instance: Instance, answer: Answer, help_level: HelpLevel | None = None) -> Report:
    """Judge an answer.

    Args:
        instance: the exercise with the student's values.
        answer: what was handed in, as read.
        help_level: how much may be told; never more than the exercise allows.
    """
    exercise = instance.exercise
    level = allowed_help(exercise, help_level)
    verdict = _verdict(instance, answer, level)
    context = Context(
        reference=exercise.reference,
        parameters=instance.parameters,
        policy=exercise.policy,
        help_level=level,
        own=answer.table,
        own_correct=verdict is not None and verdict.correct,
        angle_unit=answer.angle_unit,
        length_unit=answer.length_unit,
    )
    given = answer.parts()
    reports = tuple(
        report
        for part in exercise.parts
        if part.kind in given
        for report in _judged(part.kind, instance, answer, context, verdict)
    )
    return Report(
        verdict=verdict,
        parts=reports,
        missing=tuple(part.kind for part in exercise.parts if part.kind not in given),
        points=sum(report.points for report in reports),
        max_points=float(exercise.points),
        help_level=level,
    )


def _verdict(instance: Instance, answer: Answer, level: HelpLevel) -> Verdict | None:
    if answer.table is None:
        return None
    exercise = instance.exercise
    return grading.grade(exercise.reference, answer.table, exercise.policy, instance.parameters, level)


def _judged(
    kind: PartKind, instance: Instance, answer: Answer, context: Context, verdict: Verdict | None
) -> Iterator[PartReport]:
    exercise = instance.exercise
    part = exercise.part(kind)
    assert part is not None
    match kind:
        case PartKind.TABLE if verdict is not None:
            yield _table_report(verdict, float(part.points))
        case PartKind.SCHEMATIC if answer.schematic is not None:
            yield grade_schematic(
                context.reference_numbers, answer.schematic, part.points, context.help_level
            )
        case PartKind.LINK_MATRICES if answer.link_matrices is not None:
            yield _link_matrices_report(context, answer.link_matrices, part)
        case PartKind.TRANSFORM if answer.transform is not None:
            yield grade_transform(context, answer.transform, part.points)
        case PartKind.POSE if answer.pose is not None and isinstance(part, PosePart):
            joints = pose_joints(instance, answer.length_unit)
            yield grade_pose(context, answer.pose, joints, answer.transform, part.points, part.tolerance)
        case PartKind.WORKSPACE if answer.workspace is not None and isinstance(part, WorkspacePart):
            yield grade_workspace(context, answer.workspace, part, exercise.figure)


def pose_joints(instance: Instance, unit: LengthUnit) -> list[float]:
    """The joint values of the numeric pose [rad, or a length in the given unit]."""
    exercise = instance.exercise
    ratio = float(exercise.length_unit.metres_per_unit / unit.metres_per_unit)
    types = exercise.reference.table.joint_types
    kinds = {
        f"q{i}": ParameterKind.ANGLE if joint_type is JointType.REVOLUTE else ParameterKind.LENGTH
        for i, joint_type in enumerate(types, 1)
    }
    values = {name: float(value) for name, value in zip(kinds, instance.pose_joints, strict=True)}
    in_radians = values_in_radians(values, kinds, exercise.angle_unit)
    return [
        value * (ratio if kinds[name] is ParameterKind.LENGTH else 1.0) for name, value in in_radians.items()
    ]


def _table_report(verdict: Verdict, points: float) -> PartReport:
    return PartReport(
        kind=PartKind.TABLE,
        correct=verdict.correct,
        score=verdict.score,
        points=points * verdict.score,
        max_points=points,
        credit=Credit.KEY if verdict.score else Credit.NONE,
    )


def _link_matrices_report(
    context: Context, matrices: tuple[SymbolicMatrix | None, ...], part: Part
) -> PartReport:
    """By the student's own rows; what does not follow from them may still be right as a whole."""
    report = grade_link_matrices(context, matrices, part.points) if context.own is not None else None
    if report is not None and (report.score == 1.0 or context.own_correct):
        return report
    whole = [matrix for matrix in matrices if matrix is not None]
    if len(whole) == len(matrices) and _product_is_robot(context, whole):
        code = "matrices_right" if context.own is None else "matrices_right_not_from_table"
        return PartReport(
            kind=PartKind.LINK_MATRICES,
            correct=True,
            score=1.0,
            points=float(part.points),
            max_points=float(part.points),
            credit=Credit.KEY,
            feedback=(Feedback(code=code),),
        )
    if report is not None:
        return report
    return PartReport(
        kind=PartKind.LINK_MATRICES,
        correct=False,
        score=0.0,
        points=0.0,
        max_points=float(part.points),
        credit=Credit.NONE,
        feedback=(Feedback(code="matrices_product_wrong"),),
    )


def _product_is_robot(context: Context, matrices: list[SymbolicMatrix]) -> bool:
    names = frozenset[str]().union(*(matrix.names() for matrix in matrices)) | context.own_names()
    values = context.values(names)

    def pose(joints: Sequence[float]) -> NDArray[np.float64]:
        product = np.eye(4)
        for matrix in matrices:
            product = product @ matrix.at(values, joints)
        return product

    return is_robot(context, pose, context.joint_types)
