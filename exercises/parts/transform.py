"""⁰T_N in closed form: right if it follows from the student's own table, or is the robot's by itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

import numpy as np

from exercises.definition import PartKind
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.parts.comparison import (
    Compared,
    Expected,
    Matrices,
    agreeing,
    cell_names,
    compare,
    inverse,
    is_rigid,
    transposed_rotation,
)
from exercises.parts.context import Context
from exercises.parts.matrix_cells import SymbolicMatrix
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, shown
from exercises.parts.value import is_robot
from kinematics.errors import ParameterError

_DISCLOSURES = {
    "transform_rotation_right": Disclosure(level=HelpLevel.ROW),
    "transform_position_right": Disclosure(level=HelpLevel.ROW),
    "transform_cells_wrong": Disclosure(level=HelpLevel.KIND),
    "transform_not_rigid": Disclosure(level=HelpLevel.KIND),
    "transform_inverse": Disclosure(level=HelpLevel.REPAIR, instead="transform_cells_wrong"),
    "transform_rotation_transposed": Disclosure(level=HelpLevel.REPAIR, instead="transform_cells_wrong"),
    "transform_order_reversed": Disclosure(level=HelpLevel.REPAIR, instead="transform_cells_wrong"),
    "transform_links_missing": Disclosure(level=HelpLevel.REPAIR, instead="transform_cells_wrong"),
}


def grade_transform(context: Context, answer: SymbolicMatrix, points: Fraction) -> PartReport:
    """Judge a ⁰T_N: its rotation and its position count half each.

    Args:
        context: what the answer is judged by.
        answer: what was handed in.
        points: what the part is worth.
    """
    compared = compare(context, answer, _own(context)) if context.own is not None else None
    follows = compared is not None and compared.right
    if follows and context.own_correct:
        return _report(context, points, 1.0, Credit.KEY, (), (Feedback(code="transform_right"),))
    if transform_is_robot(context, answer):
        code = "transform_right_not_from_table" if context.own is not None else "transform_right"
        return _report(context, points, 1.0, Credit.KEY, (), (Feedback(code=code),))
    if follows:
        return _report(
            context, points, 1.0, Credit.OWN_TABLE, (), (Feedback(code="transform_follows_table"),)
        )
    if compared is None:
        return _report(context, points, 0.0, Credit.NONE, (), (Feedback(code="transform_wrong"),))
    return _wrong(context, compared, points)


def transform_is_robot(context: Context, answer: SymbolicMatrix) -> bool:
    """Whether a ⁰T_N describes the robot by itself."""
    values = context.values(answer.names() | context.own_names())
    return is_robot(context, lambda q: answer.at(values, q), context.joint_types)


def _own(context: Context) -> Expected:
    def expected(values: Mapping[str, float], joints: Sequence[float]) -> Matrices:
        try:
            return context.own_poses(values, joints).transform
        except ParameterError:
            return np.full((4, 4), np.nan)

    return expected


def _wrong(context: Context, compared: Compared, points: Fraction) -> PartReport:
    cells = compared.cells
    rotation, position = bool(cells[:3, :3].all()), bool(cells[:3, 3].all())
    feedback = [_what_is_off(context, compared)]
    if rotation:
        feedback.append(Feedback(code="transform_rotation_right"))
    if position:
        feedback.append(Feedback(code="transform_position_right"))
    facts = tuple(
        Fact(where=(r, c), finding=Finding.OK if cells[r, c] else Finding.WRONG)
        for r in range(4)
        for c in range(4)
    )
    credit = Credit.NONE
    if rotation or position:
        credit = Credit.KEY if context.own_correct else Credit.OWN_TABLE
    return _report(context, points, 0.5 * (rotation + position), credit, facts, tuple(feedback))


def _report(
    context: Context,
    points: Fraction,
    score: float,
    credit: Credit,
    facts: tuple[Fact, ...],
    feedback: tuple[Feedback, ...],
) -> PartReport:
    report = PartReport(
        kind=PartKind.TRANSFORM,
        correct=score == 1.0 and credit is Credit.KEY,
        score=score,
        points=float(points) * score,
        max_points=float(points),
        credit=credit,
        facts=facts,
        feedback=feedback,
    )
    return shown(report, context.help_level, _DISCLOSURES)


def _what_is_off(context: Context, compared: Compared) -> Feedback:
    """The misconception that explains a wrong ⁰T_N, or else its wrong cells."""
    links = np.array([context.own_poses(values, joints).links for values, joints in compared.samples])
    frames = np.array([context.own_poses(values, joints).frames for values, joints in compared.samples])
    own = frames[:, -1]

    def looks_like(other: Matrices) -> bool:
        return bool(agreeing(compared.actual, other, context.size, context.policy.tolerance).all())

    if looks_like(inverse(own)):
        return Feedback(code="transform_inverse")
    if looks_like(transposed_rotation(own)):
        return Feedback(code="transform_rotation_transposed")
    backwards = links[:, -1]
    for k in range(links.shape[1] - 2, -1, -1):
        backwards = backwards @ links[:, k]
    if looks_like(backwards):
        return Feedback(code="transform_order_reversed")
    for k in range(frames.shape[1] - 1, 0, -1):
        if looks_like(frames[:, k - 1]):
            return Feedback(code="transform_links_missing", params={"last": k})
    if not is_rigid(compared.actual, context.policy.tolerance):
        return Feedback(code="transform_not_rigid")
    return Feedback(code="transform_cells_wrong", params={"cells": cell_names(compared.cells)})
