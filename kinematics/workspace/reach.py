"""Radii, box and points of a robot's workspace."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import Fault, PoseError, TableError
from kinematics.forward import end_poses
from kinematics.inverse.arm import ArmReach
from kinematics.inverse.lengths import check_lengths, check_near, is_long, too_long
from kinematics.inverse.limits import JointLimits
from kinematics.se3 import Floats, Transform, check_transform, inverse_transform, triple
from kinematics.table import NumericTable
from kinematics.workspace.conditions import Conditions, maxima_within, places_within
from kinematics.workspace.coordinate_ascent import Maximum, first_axis, maxima
from kinematics.workspace.objectives import direction_objective, distance_objectives
from kinematics.workspace.spans import joint_spans, spread

Vector3 = tuple[float, float, float]

LEVEL = 1e-9
"""Sine of the slope below which an axis is level: rounding, not the robot, decides where it points."""
AS_GOOD_AS_ZERO = 1e-12
"""A radius below this part of the greatest one is 0, and so is a joint value below this [rad, or length]."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Radius:
    """A distance, with a configuration that has it.

    Attributes:
        value: the distance, in the table's unit.
        joints: q_1 … q_n [rad, or the table's unit].
    """

    value: float
    joints: tuple[float, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Radii:
    """The same radius measured in two ways.

    Attributes:
        axis: at right angles from the axis of the first joint.
        origin: from the origin of frame 0.
    """

    axis: Radius
    origin: Radius


@dataclass(frozen=True, kw_only=True, slots=True)
class Workspace:
    """Where the origin of the end frame can be.

    Attributes:
        inner: the least distances.
        outer: the greatest distances.
        low: least x, y, z, in the world.
        high: greatest x, y, z, in the world.
        points: (samples, 3) places, in the world.
        section: (samples, 2) the same places in the half-plane of the first axis: distance at right angles
            from it, and height along it, upward in the world, above the point of it that is nearest to the
            origin of frame 0. Along a level axis heights have the sense of the joint.
    """

    inner: Radii
    outer: Radii
    low: Vector3
    high: Vector3
    points: Floats
    section: Floats


def workspace(
    table: NumericTable,
    limits: JointLimits | None = None,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    samples: int = 0,
    plane: tuple[ArrayLike, ArrayLike] | None = None,
    held: ArrayLike | None = None,
    counts: ArmReach = ArmReach.POSE,
) -> Workspace:
    """Return how near and how far the joints bring the origin of the end frame, and in which box.

    With a plane, or with the end frame held, only configurations count that have the origin in the plane and
    the frame as it is held.

    Every number is that of a configuration within the limits, so no number promises more than the robot can
    do. That nothing lies beyond is found by ascent from many starts, and not proved.

    Args:
        limits: (lowest, highest) of joint 1 … n [rad, or the table's unit]; None for a revolute joint that
            turns fully.
        base: (4, 4) pose of frame 0 in the world; it moves box and points, never the radii.
        tool: (4, 4) pose of the end frame in frame N.
        samples: number of points, spread evenly over the joints' ranges; under conditions those of them that
            could be brought to meet them.
        plane: a point of a plane in the world, and its normal; the origin of the end frame lies in it.
        held: (4, 4) pose of which the end frame has the orientation, in the world.
        counts: POSE where the whole orientation counts, AXIS where the z axis does.

    Raises:
        TableError: the table has no joint, or an entry is NaN, infinite or too large.
        JointValueError: limits of the wrong number, reversed or too large, or a prismatic joint without them.
        PoseError: base, tool or held is not a rigid transform, or too far away; a normal of no length, at
            ("plane", "normal"); or no configuration meets the conditions, at ("plane",), ("axis",)
            or ("quaternion",).
    """
    check_reach(table, base, tool)
    spans = joint_spans(table, limits)
    T_w_0 = np.eye(4) if base is None else check_transform(base, where=("base",))
    T_n_t = None if tool is None else check_transform(tool, where=("tool",))
    point, direction = first_axis(table)
    sides = [T_w_0[k, :3] * sign for sign in (-1.0, 1.0) for k in range(3)]
    objectives = [
        *distance_objectives(point, direction),
        *distance_objectives(np.zeros(3), None),
        *(direction_objective(side) for side in sides),
    ]
    conditions = _conditions(T_w_0, plane, held, counts)
    if conditions is None:
        found = maxima(table, objectives, spans, T_n_t)
        places = end_poses(table, spread(spans, samples), tool=tool)[:, :3, 3] if samples else None
    else:
        found = maxima_within(table, objectives, spans, conditions, T_n_t)
        places = places_within(table, samples, spans, conditions, T_n_t) if samples else None
    places = np.empty((0, 3)) if places is None else places
    near_axis, far_axis, near, far, *corners = found
    across = np.eye(3) - np.outer(direction, direction)
    reach = float(np.linalg.norm(far.place))
    ends = [corner.value for corner in corners]
    low = [float(T_w_0[k, 3]) - ends[k] for k in range(3)]
    high = [float(T_w_0[k, 3]) + ends[3 + k] for k in range(3)]
    return Workspace(
        inner=Radii(
            axis=_radius(near_axis, across @ (near_axis.place - point), reach),
            origin=_radius(near, near.place, reach),
        ),
        outer=Radii(
            axis=_radius(far_axis, across @ (far_axis.place - point), reach),
            origin=_radius(far, far.place, reach),
        ),
        low=_vector(low, reach),
        high=_vector(high, reach),
        points=places @ T_w_0[:3, :3].T + T_w_0[:3, 3],
        section=_section(places, point, _upward(direction, T_w_0)),
    )


def _conditions(
    base: Transform, plane: tuple[ArrayLike, ArrayLike] | None, held: ArrayLike | None, counts: ArmReach
) -> Conditions | None:
    """What has to hold, seen from frame 0; None if nothing has."""
    if plane is None and held is None:
        return None
    to_base = inverse_transform(base)
    level = None
    if plane is not None:
        point, normal = (np.asarray(vector, dtype=np.float64) for vector in plane)
        length = float(np.linalg.norm(normal))
        if not 0.0 < length < math.inf:
            raise PoseError(Fault.at("axis_length", "plane", "normal"))
        if is_long(np.abs(point).max()):
            raise PoseError(too_long(("plane", "point")))
        level = to_base[:3, :3] @ point + to_base[:3, 3], to_base[:3, :3] @ (normal / length)
    pose = None if held is None else to_base @ check_transform(held, where=("orientation",))
    return Conditions(plane=level, pose=pose, reach=counts)


def _upward(direction: Floats, base: Transform) -> Floats:
    """A direction in frame 0, or its opposite if it points down in the world: a joint may count against z."""
    return -direction if base[2, :3] @ direction < -LEVEL else direction


def _section(places: Floats, point: Floats, direction: Floats) -> Floats:
    """(m, 2) distance from an axis and height along it, from the axis's point nearest to the origin."""
    foot = point - direction * (point @ direction)
    arms = places - foot
    heights = arms @ direction
    return np.stack([np.linalg.norm(arms - np.outer(heights, direction), axis=1), heights], axis=1)


def check_reach(table: NumericTable, base: ArrayLike | None, tool: ArrayLike | None) -> None:
    """Make sure that something moves, and over distances that can be computed with.

    Raises:
        TableError: nothing does, or a length is too large, at ("rows", …).
        PoseError: base or tool is not a rigid transform, or too far away.
    """
    if table.n_joints == 0:
        raise TableError(Fault.at("workspace_without_joints", "rows"))
    check_lengths(table)
    for pose, name in ((base, "base"), (tool, "tool")):
        if pose is not None:
            check_near(check_transform(pose, where=(name,)), name)


def _radius(maximum: Maximum, away: Floats, reach: float) -> Radius:
    value = math.hypot(*away.tolist())
    return Radius(
        value=value if value > AS_GOOD_AS_ZERO * reach else 0.0,
        joints=tuple(q if abs(q) > AS_GOOD_AS_ZERO else 0.0 for q in maximum.joints.tolist()),
    )


def _vector(values: list[float], reach: float) -> Vector3:
    return triple(value if abs(value) > AS_GOOD_AS_ZERO * reach else 0.0 for value in values)
