"""⁰T_N in numbers, at given values of the joint variables.

Where a table's variables are zero and which way they count is the student's choice (unless the policy fixes
both), so the pose is the one of the student's own table. It earns its marks if it follows from that table,
right or wrong.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from exercises.definition import PartKind
from exercises.grading import (
    BaseRule,
    DirectionRule,
    Feedback,
    Finding,
    HelpLevel,
    Policy,
    ToolRule,
    ZeroRule,
)
from exercises.parts.comparison import Matrices, agreeing, inverse, transposed_rotation
from exercises.parts.context import Context
from exercises.parts.matrix_cells import SymbolicMatrix
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, shown
from exercises.parts.transform import transform_is_robot
from kinematics.equivalence import Tolerance
from kinematics.errors import ParameterError
from kinematics.forward import forward_kinematics
from kinematics.table import JointType

_DISCLOSURES = {
    "pose_rotation_right": Disclosure(level=HelpLevel.ROW),
    "pose_position_right": Disclosure(level=HelpLevel.ROW),
    "pose_inverse": Disclosure(level=HelpLevel.REPAIR),
    "pose_rotation_transposed": Disclosure(level=HelpLevel.REPAIR),
    "pose_degrees_as_radians": Disclosure(level=HelpLevel.REPAIR),
}


def policy_fixes_pose(policy: Policy) -> bool:
    """Whether every table that keeps the policy gives the same pose at the same joint values."""
    return (
        policy.zero is ZeroRule.FIGURE
        and policy.direction is DirectionRule.FIGURE
        and policy.base is BaseRule.FRAME
        and policy.tool is ToolRule.FRAME
    )


def grade_pose(
    context: Context,
    answer: Matrices,
    joints: Sequence[float],
    transform: SymbolicMatrix | None,
    points: Fraction,
    tolerance: float,
) -> PartReport:
    """Judge a pose: its rotation and its position count half each.

    Args:
        context: what the answer is judged by.
        answer: (4, 4) what was handed in, lengths in the student's unit.
        joints: the joint values [rad, or the student's unit].
        transform: the student's own ⁰T_N in closed form, if one was handed in.
        points: what the part is worth.
        tolerance: largest error of a position relative to the robot's size, and of a direction cosine.
    """
    allowed = Tolerance(length=tolerance, angle=tolerance)
    score, answer, pose, credit = max(
        (
            (_score(agreeing(given[None], pose[None], context.size, allowed)), given, pose, credit)
            for pose, credit in _expected(context, joints, transform)
            for given in _in_either_unit(context, answer)
        ),
        key=lambda judged: judged[0],
        default=(0.0, answer, np.full((4, 4), np.nan), Credit.NONE),
    )
    cells = agreeing(answer[None], pose[None], context.size, allowed)
    report = PartReport(
        kind=PartKind.POSE,
        correct=score == 1.0 and credit is Credit.KEY,
        score=score,
        points=float(points) * score,
        max_points=float(points),
        credit=credit if score else Credit.NONE,
        facts=tuple(
            Fact(where=(r, c), finding=Finding.OK if cells[r, c] else Finding.WRONG)
            for r in range(4)
            for c in range(4)
        ),
        feedback=tuple(_feedback(context, answer, pose, score, credit, joints, allowed)),
    )
    return shown(report, context.help_level, _DISCLOSURES)


def _score(cells: NDArray[np.bool_]) -> float:
    """Half for the rotation and half for the position, nothing without a last row 0 0 0 1."""
    rotation, position = cells[:3, :3].all(), cells[:3, 3].all()
    return 0.5 * (float(rotation) + float(position)) if cells[3].all() else 0.0


def _in_either_unit(context: Context, answer: Matrices) -> Iterator[Matrices]:
    """The pose in the unit of the student's table; it may have been given in the exercise's."""
    yield answer
    if context.unit_ratio != 1.0:
        converted = answer.copy()
        converted[:3, 3] *= context.unit_ratio
        yield converted


def _expected(
    context: Context, joints: Sequence[float], transform: SymbolicMatrix | None
) -> Iterator[tuple[Matrices, Credit]]:
    """The poses that earn marks, and what the marks rest on then."""
    if policy_fixes_pose(context.policy):
        ratio = context.unit_ratio
        q = [
            value / ratio if type_ is JointType.PRISMATIC else value
            for value, type_ in zip(joints, context.reference.table.joint_types, strict=True)
        ]
        pose = forward_kinematics(context.reference_numbers, q).transform.copy()
        pose[:3, 3] *= ratio
        yield pose, Credit.KEY
    if context.own is not None and len(context.own.table.joint_types) == len(joints):
        credit = Credit.KEY if context.own_correct else Credit.OWN_TABLE
        with suppress(ParameterError):
            yield context.own_poses(context.values(context.own_names()), joints).transform, credit
    if transform is not None and len(context.joint_types) == len(joints):
        if transform_is_robot(context, transform):
            yield transform.at(context.values(transform.names()), joints), Credit.KEY
        elif context.own is None:
            yield transform.at(context.values(transform.names()), joints), Credit.OWN_TABLE


def _feedback(
    context: Context,
    answer: Matrices,
    pose: Matrices,
    score: float,
    credit: Credit,
    joints: Sequence[float],
    allowed: Tolerance,
) -> Iterator[Feedback]:
    if score == 1.0:
        yield Feedback(code="pose_right" if credit is Credit.KEY else "pose_follows_table")
        return

    def looks_like(other: Matrices) -> bool:
        return bool(agreeing(answer[None], other[None], context.size, allowed).all())

    yield Feedback(code="pose_wrong")
    if score:
        rotation = agreeing(answer[None], pose[None], context.size, allowed)[:3, :3].all()
        yield Feedback(code="pose_rotation_right" if rotation else "pose_position_right")
    if looks_like(inverse(pose)):
        yield Feedback(code="pose_inverse")
    elif looks_like(transposed_rotation(pose)):
        yield Feedback(code="pose_rotation_transposed")
    elif context.own is not None and _degrees_as_radians(context, joints, looks_like):
        yield Feedback(code="pose_degrees_as_radians")


def _degrees_as_radians(
    context: Context, joints: Sequence[float], looks_like: Callable[[Matrices], bool]
) -> bool:
    """Whether the sines and cosines were taken of the degrees as if they were radians."""
    assert context.own is not None
    types = context.own.table.joint_types
    if len(types) != len(joints):
        return False
    q = [math.degrees(v) if t is JointType.REVOLUTE else v for v, t in zip(joints, types, strict=True)]
    try:
        pose = context.own_poses(context.values(context.own_names()), q).transform
    except ParameterError:
        return False
    return looks_like(pose)
