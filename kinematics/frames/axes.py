"""What frame assignment starts from: the joint axes of a robot at its zero position, and its size."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import DescriptionError, Fault
from kinematics.se3 import (
    ORIGIN,
    Transform,
    Vector,
    check_transform,
    cross,
    foot,
    norm,
    rejection,
    subtract,
    unit,
)
from kinematics.table import JointType

MAX_AXES = 64  # As many as a table may have rows.
MAX_COORDINATE = 1e12
"""Squares of coordinates stay far from overflow, and their rounding of 1e-4 m is beyond any use."""


@dataclass(frozen=True, kw_only=True, slots=True)
class JointAxis:
    """The axis of one joint, with the robot at its zero position, in one fixed coordinate system.

    Attributes:
        joint: revolute or prismatic.
        direction: direction of the positive motion; any length but zero.
        point: a point of the axis [m]; only the direction of a prismatic joint means anything, so its point
            may be left out.
    """

    joint: JointType
    direction: Sequence[float]
    point: Sequence[float] = ORIGIN


@dataclass(frozen=True, kw_only=True, slots=True)
class Gripper:
    """A gripper, from which the end frame follows.

    The frame has its origin between the jaws, z towards the object, y in the direction in which the jaws
    slide, and x = y × z.

    Attributes:
        point: the middle between the jaws [m].
        approach: direction towards the object.
        jaws: direction in which the jaws slide; its part across the approach is used.

    Source: seed 002, the gripper as end effector.
    """

    point: Sequence[float]
    approach: Sequence[float]
    jaws: Sequence[float]


@dataclass(frozen=True, slots=True)
class AxisLine:
    """A directed line with the joint that moves about or along it; the direction is a unit vector."""

    joint: JointType
    point: Vector
    direction: Vector


@dataclass(frozen=True, slots=True)
class Pose:
    """A frame: origin and the directions of its x and z axes."""

    origin: Vector
    x: Vector
    z: Vector


@dataclass(frozen=True, slots=True)
class PartialPose:
    """A frame of which origin, x or z may still be missing."""

    origin: Vector | None
    x: Vector | None
    z: Vector | None


def read_axes(axes: Sequence[JointAxis]) -> list[AxisLine]:
    """Return the axes as directed lines.

    Raises:
        DescriptionError: no axes or more than 64, an unknown joint, three finite numbers missing, a zero
            direction; all faults at once, each at ("axes", i, name).
    """
    if not 1 <= len(axes) <= MAX_AXES:
        raise DescriptionError(Fault.at("axes_wrong_number", "axes", count=len(axes), limit=MAX_AXES))
    faults: list[Fault] = []
    lines = []
    for i, axis in enumerate(axes):
        if axis.joint not in (JointType.REVOLUTE, JointType.PRISMATIC):
            faults.append(Fault.at("axis_joint_unknown", "axes", i, "joint"))
        point = read_point(axis.point, ("axes", i, "point"), faults)
        direction = read_direction(axis.direction, ("axes", i, "direction"), faults)
        lines.append(AxisLine(axis.joint, point, direction))
    if faults:
        raise DescriptionError(faults)
    return lines


def gripper_frame(gripper: Gripper) -> Transform:
    """Return the end frame of a gripper: z towards the object, y across the jaws, x = y × z.

    Returns:
        (4, 4) pose, in the coordinates in which the gripper is given.

    Raises:
        DescriptionError: three finite numbers missing, or the jaws slide along the approach.

    Source: seed 002, the gripper as end effector.
    """
    faults: list[Fault] = []
    point = read_point(gripper.point, ("tool", "point"), faults)
    z = read_direction(gripper.approach, ("tool", "approach"), faults)
    jaws = read_direction(gripper.jaws, ("tool", "jaws"), faults)
    if faults:
        raise DescriptionError(faults)
    x = cross(jaws, z)
    if norm(x) < 1e-6:
        raise DescriptionError(Fault.at("gripper_jaws_along_approach", "tool", "jaws"))
    x = unit(x)
    return matrix(Pose(point, x, z))


def pose_of(transform: ArrayLike, name: str) -> Pose:
    """Return the frame that a 4×4 matrix describes, its axes made exactly perpendicular.

    Raises:
        PoseError: not the matrix of a rigid motion; at (name,).
    """
    T = check_transform(transform, where=(name,))
    x, _, z, origin = (tuple(column) for column in T[:3].T.tolist())
    z = unit(z)
    return Pose(origin, unit(rejection(x, z)), z)


def ends_of(base: ArrayLike | None, tool: ArrayLike | Gripper | None) -> tuple[Pose | None, Pose | None]:
    """Return the frames that base and tool prescribe; see `pose_of`."""
    end = gripper_frame(tool) if isinstance(tool, Gripper) else tool
    return None if base is None else pose_of(base, "base"), None if end is None else pose_of(end, "tool")


def matrix(pose: Pose) -> Transform:
    """Return the 4×4 matrix of a frame."""
    y = cross(pose.z, pose.x)
    (ox, oy, oz), (xx, xy, xz), (zx, zy, zz) = pose.origin, pose.x, pose.z
    return np.array([[xx, y[0], zx, ox], [xy, y[1], zy, oy], [xz, y[2], zz, oz], [0.0, 0.0, 0.0, 1.0]])


def read_point(value: Sequence[float], where: tuple[str | int, ...], faults: list[Fault]) -> Vector:
    """Return three finite numbers; if they are not, a fault is added to the list."""
    try:
        x, y, z = (float(component) for component in value)
    except (TypeError, ValueError, OverflowError):
        x = y = z = math.nan
    if max(abs(x), abs(y), abs(z)) <= MAX_COORDINATE and x == x and y == y and z == z:
        return (x, y, z)
    faults.append(Fault.at("vector_malformed", *where, limit=f"{MAX_COORDINATE:g}"))
    return ORIGIN


def read_direction(value: Sequence[float], where: tuple[str | int, ...], faults: list[Fault]) -> Vector:
    """Return the unit vector along three numbers, not all zero.

    If there is none, a fault is added to the list.
    """
    before = len(faults)
    vector = read_point(value, where, faults)
    if any(vector):
        return unit(vector)
    if len(faults) == before:
        faults.append(Fault.at("direction_zero", *where))
    return (0.0, 0.0, 1.0)


def robot_size(lines: Sequence[AxisLine], first: Pose | None, last: Pose | None) -> float:
    """Return the extent [m] of the points that were given; 1 where they all coincide.

    Any point of an axis may be given: if a frame is given, too, the one nearest to it counts, since a common
    normal of nearly parallel axes is far from a robot. Points of prismatic axes mean nothing and do not
    count.
    Points carry rounding of their own size, so the result is at least 1e-3 of their extent and 1e-5 of the
    largest coordinate.
    """
    turning = [line for line in lines if line.joint is not JointType.PRISMATIC]
    ends = [pose.origin for pose in (first, last) if pose is not None]
    given = ends + [line.point for line in turning]
    if not given:
        return 1.0
    near = ends + [foot(ends[0], line.point, line.direction) for line in turning] if ends else given
    return max(_extent(near), 1e-3 * _extent(given), 1e-5 * max(map(norm, given))) or 1.0


def _extent(points: Sequence[Vector]) -> float:
    return max(norm(subtract(point, points[0])) for point in points)
