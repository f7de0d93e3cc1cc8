"""The robot's size, by which zero is judged."""

from __future__ import annotations

from collections.abc import Sequence

from kinematics.frames.axes import AxisLine, Pose
from kinematics.se3 import norm, subtract
from kinematics.table import JointType


def robot_size(lines: Sequence[AxisLine], first: Pose | None, last: Pose | None) -> float:
    """Return the extent [m] of the points that were given; 1 where they all coincide.

    The points of prismatic axes mean nothing and do not count. Coordinates that are large beside the extent
    carry rounding of their own size, so the result is at least 1e-5 of the largest.
    """
    points = [line.point for line in lines if line.joint is not JointType.PRISMATIC]
    points += [pose.origin for pose in (first, last) if pose is not None]
    if not points:
        return 1.0
    extent = max(norm(subtract(point, points[0])) for point in points)
    return max(extent, 1e-5 * max(map(norm, points))) or 1.0
