"""Whether a given frame can be frame 0 or frame N of a table.

A row holds four of the six numbers of a rigid motion, so the first and the last frame are not quite free.
In a standard table z_0 is axis 1 with the origin on it, and x_N crosses axis N at right angles. In a
modified table x_0 crosses axis 1 at right angles, and z_N is axis N with the origin on it. So one of the two
has its z on its axis, the other has its x across it.
"""

from kinematics.frames.axes import AxisLine, Pose
from kinematics.frames.normals import EXACT_ANGLE, EXACT_LENGTH
from kinematics.se3 import Vector, along, cross, dot, foot, norm, subtract


def may_stand(pose: Pose, axis: AxisLine, *, z_on_axis: bool) -> bool:
    """Return whether a given frame has the orientation of an end frame; the place of the axis aside."""
    if z_on_axis:
        return norm(cross(pose.z, axis.direction)) <= EXACT_ANGLE and dot(pose.z, axis.direction) > 0
    return abs(dot(pose.x, axis.direction)) <= EXACT_ANGLE


def meeting(pose: Pose, axis: AxisLine, size: float, *, z_on_axis: bool) -> Vector | None:
    """Return where the normal between a given frame and its axis meets this; None if the frame is no end."""
    if not z_on_axis:
        return _crossing(pose, axis, size)
    off = subtract(pose.origin, foot(pose.origin, axis.point, axis.direction))
    return pose.origin if norm(off) <= EXACT_LENGTH * size else None


def _crossing(pose: Pose, axis: AxisLine, size: float) -> Vector | None:
    """Where the x axis of a frame crosses an axis at right angles, or None."""
    point = foot(pose.origin, axis.point, axis.direction)
    on_x = along(pose.origin, dot(subtract(point, pose.origin), pose.x), pose.x)
    return point if norm(subtract(point, on_x)) <= EXACT_LENGTH * size else None
