"""Valid tables that keep strict rules: frame 0, frame N, zeros and directions where a policy wants them.

Drawn like those of `generators`, by the definition of the frames: the key's axes and last frame at one
configuration, in the key's frame 0; then a chain of lines, each carried to the next along a common normal.
"""

import math
from dataclasses import replace
from itertools import pairwise
from random import Random
from typing import NamedTuple

import numpy as np

from kinematics.equivalence import BaseRule, DirectionRule, Policy, ToolRule, ZeroRule
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable
from tests.kinematics.equivalence.generators import (
    Joint,
    Line,
    Robot,
    angle,
    common_normal,
    cross,
    length_of,
    random_direction,
    robot_at,
    some_normal,
)

SAME = 1e-9
NEGLIGIBLE = 1e-13
ON_THE_AXIS = 0.6
"""How often an end that may lie anywhere lies on the axis of its joint."""


class End(NamedTuple):
    """Frame 0 or frame N.

    Attributes:
        line: its z axis.
        merged: that is the line of the first or the last joint, so that no row leads there.
        origin: a point of the line; None, if any will do.
        x: a direction at right angles to it; None, if any will do.
    """

    line: Line
    merged: bool
    origin: np.ndarray | None = None
    x: np.ndarray | None = None


def strict_table(reference: NumericTable, policy: Policy, rng: Random) -> NumericTable:
    """A random table of the robot that keeps the rules of a policy, in either convention."""
    still = policy.zero is ZeroRule.FIGURE
    values = [0.0 if still else rng.uniform(-math.pi, math.pi) for _ in range(reference.n_joints)]
    robot = robot_at(reference, tuple(values))
    lines = [_line(joint, robot, policy, rng) for joint in robot.joints]
    first = _end(policy.base.value, lines[0], np.eye(4), robot, rng)
    if first.merged:
        lines[0] = replace(lines[0], point=first.line.point)
    last = _end(policy.tool.value, lines[-1], robot.tool, robot, rng)
    if last.merged and (len(lines) > 1 or not first.merged):
        lines[-1] = replace(lines[-1], point=last.line.point)
    else:
        lines.append(replace(last.line, joint=JointType.FIXED, sign=1))
    if not first.merged:
        lines.insert(0, first.line)
    return _read_off(lines, first, last, robot.size, rng)


def _line(joint: Joint, robot: Robot, policy: Policy, rng: Random) -> Line:
    """The z axis of a joint: either way; a slider's anywhere."""
    z_sign = rng.choice((1, -1))
    row_sign = z_sign if policy.direction is DirectionRule.FIGURE else rng.choice((1, -1))
    point = joint.point + rng.uniform(-1, 1) * robot.size * joint.direction
    if joint.type is JointType.PRISMATIC:
        point = point + np.array([rng.uniform(-1, 1) for _ in range(3)]) * robot.size
    return Line(point, z_sign * joint.direction, joint.type, row_sign)


def _end(rule: str, joint: Line, frame: np.ndarray, robot: Robot, rng: Random) -> End:
    """Frame 0 or frame N where a rule wants it.

    Args:
        rule: the rule's value.
        joint: the z axis of the joint next to it.
        frame: the key's own frame.
        robot: for its size.
        rng: draws.
    """
    x, z, origin = frame[:3, 0], frame[:3, 2], frame[:3, 3]
    turned = rng.choice((1, -1))
    if rule == BaseRule.FREE.value:
        if rng.random() < ON_THE_AXIS:
            return End(joint, merged=True)
        point = joint.point + np.array([rng.uniform(-1, 1) for _ in range(3)]) * robot.size
        return End(Line(point, random_direction(rng), JointType.FIXED, 1), merged=False)
    if rule == BaseRule.AXIS.value:
        if rng.random() < ON_THE_AXIS:
            return End(joint, merged=True)
        point, direction = rng.choice(((joint.point, joint.direction), (origin, z)))
        return End(Line(point, turned * direction, JointType.FIXED, 1), merged=False)
    slides = joint.joint is JointType.PRISMATIC
    reached = slides or length_of(cross(joint.direction, origin - joint.point)) < SAME * robot.size
    if rule == BaseRule.FRAME.value:
        merged = reached and length_of(joint.direction - z) < SAME
        return End(Line(origin, z, JointType.FIXED, 1), merged, origin, x)
    assert rule in (BaseRule.ORIGIN.value, ToolRule.POINT.value)
    if reached and rng.random() < ON_THE_AXIS:
        return End(Line(origin, joint.direction, JointType.FIXED, 1), True, origin)
    direction = rng.choice((turned * z, random_direction(rng)))
    return End(Line(origin, direction, JointType.FIXED, 1), False, origin)


def _read_off(lines: list[Line], first: End, last: End, scale: float, rng: Random) -> NumericTable:
    """The table of a chain of lines: along and about z on every line, along and about x between them."""
    convention = rng.choice(list(Convention))
    normals = [common_normal(one, two, rng, scale) for one, two in pairwise(lines)]
    starts = [(n.second, n.direction) for n in normals]
    goals = [(n.first, n.direction) for n in normals]
    here = goals[0] if goals else (lines[0].point, some_normal(lines[0].direction, rng))
    starts.insert(0, _placed(first, here))
    goals.append(_placed(last, starts[-1]))
    along_z = [
        (angle(x, new, line.direction), _length(goal - origin, line.direction, scale))
        for line, (origin, x), (goal, new) in zip(lines, starts, goals, strict=True)
    ]
    along_x = [
        (_length(n.second - n.first, n.direction, scale), angle(one.direction, two.direction, n.direction))
        for n, (one, two) in zip(normals, pairwise(lines), strict=True)
    ]
    nothing = (0.0, 0.0)
    along_x = [*along_x, nothing] if convention is Convention.STANDARD else [nothing, *along_x]
    rows = [
        DHRow(joint=line.joint, sign=line.sign, theta=theta, d=d, a=a, alpha=alpha)
        for line, (theta, d), (a, alpha) in zip(lines, along_z, along_x, strict=True)
    ]
    return DHTable(convention=convention, rows=tuple(row for row in rows if _does_something(row)))


def _length(way: np.ndarray, along: np.ndarray, scale: float) -> float:
    found = float(way @ along)
    return found if abs(found) > NEGLIGIBLE * scale else 0.0


def _placed(end: End, usual: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Origin and x axis of an end frame: what is not fixed is as what comes next to it."""
    return (
        usual[0] if end.origin is None else end.origin,
        usual[1] if end.x is None else end.x,
    )


def _does_something(row: DHRow[float]) -> bool:
    still = abs(row.d) + abs(row.a) + abs(math.sin(row.theta / 2)) + abs(math.sin(row.alpha / 2)) < 1e-12
    return row.joint is not JointType.FIXED or not still
