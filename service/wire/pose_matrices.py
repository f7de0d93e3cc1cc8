"""Poses from the wire as 4×4 matrices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from kinematics.errors import Fault, PoseError
from kinematics.poses import transform_from_quaternion, transform_from_xyzabc
from kinematics.se3 import perpendicular, unit

Matrix: TypeAlias = Any


def pose_matrix(pose: Sequence[Any], angle: float, *where: str | int) -> Matrix:
    """Return a pose that is given as 4×4, or as [X, Y, Z, A, B, C].

    Args:
        pose: as it came.
        angle: what one unit of the request's angles is in [rad].
        where: the field, and the place in it, for faults.

    Raises:
        PoseError: six numbers that are no pose. What is no 4×4 matrix is left to whoever reads it.
    """
    if len(pose) != 6 or isinstance(pose[0], list):
        return pose
    try:
        return transform_from_xyzabc([*pose[:3], *(value * angle for value in pose[3:])])
    except PoseError as error:
        raise PoseError(fault.within(*where) for fault in error.faults) from None


def placed_matrix(
    position: Sequence[float], quaternion: Sequence[float] | None, axis: Sequence[float] | None
) -> Matrix:
    """Return a pose at a position, with an orientation or with its z axis along a direction if one is given.

    Raises:
        PoseError: a quaternion or an axis of no length.
    """
    if quaternion is not None:
        return transform_from_quaternion(quaternion, position)
    pose = np.eye(4)
    pose[:3, 3] = position
    if axis is None:
        return pose
    x, y, z = axis
    if not any(axis):
        raise PoseError(Fault(code="axis_length", where=("axis",)))
    direction = unit((x, y, z))
    across = perpendicular(direction)
    pose[:3, 0], pose[:3, 2] = across, direction
    pose[:3, 1] = np.cross(pose[:3, 2], pose[:3, 0])
    return pose
