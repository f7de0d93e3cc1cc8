"""Poses from the wire as 4×4 matrices."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from kinematics.errors import Fault, PoseError
from kinematics.inverse.lengths import is_long, too_long
from kinematics.poses import transform_from_quaternion, transform_from_xyzabc
from kinematics.se3 import perpendicular, unit
from service.http.problems import located
from service.schemas.kinematics.robot_question import PlacedPose, PlacedRobotQuestion, PoseInput

Matrix: TypeAlias = Any


def base_and_tool(question: PlacedRobotQuestion, angle: float) -> tuple[Matrix | None, Matrix | None]:
    """Return both poses of a question as matrices, None where none is given; see `pose_matrix`."""
    base, tool = question.base, question.tool
    return (
        None if base is None else pose_matrix(base, angle, "base"),
        None if tool is None else pose_matrix(tool, angle, "tool"),
    )


def pose_matrix(pose: PoseInput, angle: float, *where: str | int) -> Matrix:
    """Return a pose that is given as 4×4, as [X, Y, Z, A, B, C], or as a position with a quaternion.

    Args:
        angle: what one unit of the request's angles is in [rad].
        where: the field, and the place in it, for faults.

    Raises:
        PoseError: six numbers or a quaternion that are no pose. What is no 4×4 matrix is left to whoever
            reads it.
    """
    if not isinstance(pose, PlacedPose) and (len(pose) != 6 or isinstance(pose[0], list)):
        return pose
    with located(*where):
        if isinstance(pose, PlacedPose):
            return transform_from_quaternion(pose.quaternion, pose.position).tolist()
        return transform_from_xyzabc([*pose[:3], *(value * angle for value in pose[3:])]).tolist()


def placed_matrix(
    position: Sequence[float], quaternion: Sequence[float] | None, axis: Sequence[float] | None
) -> Matrix:
    """Return a pose at a position, with an orientation or with its z axis along a direction if one is given.

    Raises:
        PoseError: a quaternion or an axis of no length, or a position too far away.
    """
    if any(map(is_long, position)):
        raise PoseError(too_long(("position",)))
    if quaternion is not None:
        return transform_from_quaternion(quaternion, position)
    pose = np.eye(4)
    pose[:3, 3] = position
    if axis is None:
        return pose
    x, y, z = axis
    if not any(axis):
        raise PoseError(Fault.at("axis_length", "axis"))
    direction = unit((x, y, z))
    across = perpendicular(direction)
    pose[:3, 0], pose[:3, 2] = across, direction
    pose[:3, 1] = np.cross(pose[:3, 2], pose[:3, 0])
    return pose
