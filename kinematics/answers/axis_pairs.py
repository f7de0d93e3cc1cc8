"""How axes lie to each other: by angles and distances, which no choice of frames changes."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from kinematics.chain import Axis, size_of
from kinematics.equivalence import Policy
from kinematics.equivalence.reference import prepared
from kinematics.se3 import ORIGIN, angle_between, cross, dot, norm, rejection, subtract
from kinematics.table import JointType, NumericTable

NEARLY_PARALLEL = 1e-6  # A sine: two decimals of six leave no better common normal.


class AxisPair(NamedTuple):
    """Two axes whose angle and distance no choice of frames changes.

    Attributes:
        first: a joint, from 1.
        second: the next one; or the next that turns, where only prismatic joints along one of the two stand
            between.
        alike: they lie relative to each other as the robot's do.
    """

    first: int
    second: int
    alike: bool


def pairs_on_one_line(key: NumericTable, policy: Policy) -> tuple[AxisPair, ...]:
    """Return which axes lie to each other as if all were one line: that is known for nothing."""
    line = [Axis(kind is JointType.PRISMATIC, (0.0, 0.0, 1.0), ORIGIN) for kind in key.joint_types]
    return tuple(axis_pairs(key, line, policy.tolerance.length))


def axis_pairs(key: NumericTable, theirs: Sequence[Axis], share: float) -> Iterator[AxisPair]:
    """Yield whether axes lie relative to each other as the robot's, by angle and distance.

    Args:
        key: a table of the robot.
        theirs: as many axes as it has joints.
        share: by how much an angle may differ [rad], and a distance as a share of the robot's size; three
            times as much is allowed.
    """
    ours = prepared(key).chain.axes
    allowed = 3 * share * (size_of(prepared(key).chain) or 1.0)
    for i, k in (*pairwise(range(len(ours))), *_across_prismatic(ours)):
        a, b, c, d = ours[i], ours[k], theirs[i], theirs[k]
        same = (a.prismatic, b.prismatic) == (c.prismatic, d.prismatic)
        somewhere = ORIGIN not in (c.direction, d.direction)
        alike = same and somewhere and abs(_angle(a, b) - _angle(c, d)) <= 3 * share
        apart = a.prismatic or b.prismatic or abs(_distance(a, b) - _distance(c, d)) <= allowed
        yield AxisPair(i + 1, k + 1, alike and apart)


def _across_prismatic(axes: Sequence[Axis]) -> Iterator[tuple[int, int]]:
    """Yield revolute axes whose distance no prismatic joint between changes: each is along one of them."""
    for i, k in pairwise(i for i, axis in enumerate(axes) if not axis.prismatic):
        between = axes[i + 1 : k]
        if between and all(
            min(_angle(axis, axes[i]), _angle(axis, axes[k])) <= NEARLY_PARALLEL for axis in between
        ):
            yield i, k


def _angle(first: Axis, second: Axis) -> float:
    """Return the angle between two lines, 0 … π/2."""
    angle = angle_between(first.direction, second.direction)
    return min(angle, math.pi - angle)


def _distance(first: Axis, second: Axis) -> float:
    """Return the distance of two lines."""
    between = subtract(second.point, first.point)
    normal = cross(first.direction, second.direction)
    length = norm(normal)
    if length < NEARLY_PARALLEL:
        return norm(rejection(between, first.direction))
    return abs(dot(between, normal)) / length
