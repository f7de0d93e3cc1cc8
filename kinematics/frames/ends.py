"""Whether a given frame can be frame 0 or frame N of a table.

A row holds four of the six numbers of a rigid motion, so the first and the last frame are not quite free.
In a standard table z_0 is axis 1 with the origin on it, and x_N crosses axis N at right angles. In a
modified table x_0 crosses axis 1 at right angles, and z_N is axis N with the origin on it.
"""

from __future__ import annotations

from kinematics.frames.axes import AxisLine, Pose
from kinematics.frames.normals import EXACT_ANGLE, EXACT_LENGTH
from kinematics.se3 import Vector, along, cross, dot, foot, norm, subtract
from kinematics.table import Convention


def may_start(first: Pose, axis: AxisLine, convention: Convention) -> bool:
    """Return whether a given frame has the orientation of a frame 0; the place of axis 1 aside."""
    if convention is Convention.STANDARD:
        return _same(first.z, axis.direction)
    return abs(dot(first.x, axis.direction)) <= EXACT_ANGLE


def may_end(last: Pose, axis: AxisLine, convention: Convention) -> bool:
    """Return whether a given frame has the orientation of a frame N; the place of axis N aside."""
    if convention is Convention.STANDARD:
        return abs(dot(last.x, axis.direction)) <= EXACT_ANGLE
    return _same(last.z, axis.direction)


def entering(first: Pose, axis: AxisLine, convention: Convention, size: float) -> Vector | None:
    """Return where the normal from a given frame 0 meets axis 1; None if the frame cannot be frame 0."""
    if convention is Convention.MODIFIED:
        return _crossing(first, axis, size)
    return first.origin if _lies_on(first.origin, axis, size) else None


def leaving(last: Pose, axis: AxisLine, convention: Convention, size: float) -> Vector | None:
    """Return where the normal to a given frame N leaves axis N; None if the frame cannot be frame N."""
    if convention is Convention.STANDARD:
        return _crossing(last, axis, size)
    return last.origin if _lies_on(last.origin, axis, size) else None


def _crossing(pose: Pose, axis: AxisLine, size: float) -> Vector | None:
    """Where the x axis of a frame crosses an axis at right angles, or None."""
    point = foot(pose.origin, axis.point, axis.direction)
    on_x = along(pose.origin, dot(subtract(point, pose.origin), pose.x), pose.x)
    return point if norm(subtract(point, on_x)) <= EXACT_LENGTH * size else None


def _lies_on(point: Vector, axis: AxisLine, size: float) -> bool:
    return norm(subtract(point, foot(point, axis.point, axis.direction))) <= EXACT_LENGTH * size


def _same(u: Vector, v: Vector) -> bool:
    return norm(cross(u, v)) <= EXACT_ANGLE and dot(u, v) > 0
