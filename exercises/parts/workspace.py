"""The radii of the workspace: how near and how far a point of the last link can be brought."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

import numpy as np

from exercises.definition import PartKind, ReachFrom, WorkspacePart
from exercises.figures.camera import Array
from exercises.figures.points import Points
from exercises.figures.specification import FigureSpecification
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.parts.comparison import inverse
from exercises.parts.context import Context
from exercises.parts.reach import Interval, Reach, reach
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, shown
from kinematics.cells import AngleUnit
from kinematics.chain import chain_of_table
from kinematics.table import JointType, NumericTable

Key = tuple[float, float, float]

_DISCLOSURES = {
    "workspace_inner_wrong": Disclosure(level=HelpLevel.ROW),
    "workspace_outer_wrong": Disclosure(level=HelpLevel.ROW),
    "workspace_swapped": Disclosure(level=HelpLevel.KIND),
    "workspace_diameters": Disclosure(level=HelpLevel.REPAIR),
    "workspace_other_length_unit": Disclosure(level=HelpLevel.KIND),
}


@dataclass(frozen=True, kw_only=True, slots=True)
class WorkspaceAnswer:
    """Inner and outer radius, in the student's length unit."""

    inner: float
    outer: float


def workspace_of(context: Context, part: WorkspacePart, figure: FigureSpecification) -> Reach:
    """The radii of the robot's workspace, in the exercise's unit."""
    table = context.reference_numbers
    values = context.reference_values
    points = Points(figure, context.reference.table, values)
    to_base, to_last = inverse(points.frames[0]), inverse(points.frames[-1])
    point = to_last[:3, :3] @ points.point(part.point) + to_last[:3, 3]
    if part.reach_from is ReachFrom.POINT and part.origin is not None:
        origin = to_base[:3, :3] @ points.point(part.origin) + to_base[:3, 3]
        axis = None
    else:
        first = chain_of_table(table).axes[0]
        origin, axis = np.array(first.point), np.array(first.direction)
    degrees = context.reference.angle_unit is AngleUnit.DEG
    limits = [
        None if limit is None else _interval(limit, degrees and joint_type is JointType.REVOLUTE)
        for limit, joint_type in zip(part.limits, table.joint_types, strict=True)
    ]
    free = [
        (0.0, 0.0) if limit is None and joint_type is JointType.PRISMATIC else limit
        for limit, joint_type in zip(limits, table.joint_types, strict=True)
    ]
    return _radii(table, _key(point), _key(origin), None if axis is None else _key(axis), tuple(free))


@lru_cache(maxsize=512)
def _radii(
    table: NumericTable, point: Key, origin: Key, axis: Key | None, limits: tuple[Interval | None, ...]
) -> Reach:
    """The radii, once for all who have the same values."""
    square_to = None if axis is None else np.array(axis)
    return reach(table, np.array(point), np.array(origin), square_to, limits)


def _key(vector: Array) -> Key:
    x, y, z = np.round(vector, 12).tolist()
    return x, y, z


def grade_workspace(
    context: Context, answer: WorkspaceAnswer, part: WorkspacePart, figure: FigureSpecification
) -> PartReport:
    """Judge the radii: each counts half.

    Args:
        context: what the answer is judged by.
        answer: the radii, in the student's unit or the exercise's.
        part: from where they are measured, and the tolerance.
        figure: holds the points.
    """
    key = workspace_of(context, part, figure)
    scaled = Reach(inner=key.inner * context.unit_ratio, outer=key.outer * context.unit_ratio)
    if abs(answer.outer - key.outer) <= part.tolerance * key.outer:
        scaled = key  # beside a table in another unit, radii may be in the exercise's own
    limit = part.tolerance * scaled.outer
    right = {
        "inner": abs(answer.inner - scaled.inner) <= limit,
        "outer": abs(answer.outer - scaled.outer) <= limit,
    }
    score = sum(right.values()) / 2
    feedback = [Feedback(code=f"workspace_{name}_wrong") for name, is_right in right.items() if not is_right]
    other = _what_is_off(answer, scaled, context, limit)
    if not all(right.values()) and other is not None:
        feedback.insert(0, other)
    report = PartReport(
        kind=PartKind.WORKSPACE,
        correct=score == 1.0,
        score=score,
        points=float(part.points) * score,
        max_points=float(part.points),
        credit=Credit.KEY if score else Credit.NONE,
        facts=tuple(
            Fact(where=(name,), finding=Finding.OK if is_right else Finding.WRONG)
            for name, is_right in right.items()
        ),
        feedback=tuple(feedback) or (Feedback(code="workspace_right"),),
    )
    return shown(report, context.help_level, _DISCLOSURES)


def _what_is_off(answer: WorkspaceAnswer, key: Reach, context: Context, limit: float) -> Feedback | None:
    def near(inner: float, outer: float, allowed: float) -> bool:
        return abs(answer.inner - inner) <= allowed and abs(answer.outer - outer) <= allowed

    if near(key.outer, key.inner, limit):
        return Feedback(code="workspace_swapped")
    if near(2 * key.inner, 2 * key.outer, 2 * limit):
        return Feedback(code="workspace_diameters")
    for factor in (1000.0, 0.001, 100.0, 0.01, 10.0, 0.1):
        if near(factor * key.inner, factor * key.outer, factor * limit):
            return Feedback(code="workspace_other_length_unit", params={"unit": context.length_unit.value})
    return None


def _interval(limit: tuple[Fraction, Fraction], degrees: bool) -> tuple[float, float]:
    low, high = (float(value) for value in limit)
    return (math.radians(low), math.radians(high)) if degrees else (low, high)
