"""How near to and how far from a place the joints bring a point: the radii of a workspace."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.table import JointType, NumericTable
from kinematics.workspace.coordinate_ascent import maxima
from kinematics.workspace.objectives import distance_objectives

Array = NDArray[np.float64]
Interval = tuple[float, float]

TURN: Interval = (-math.pi, math.pi)


@dataclass(frozen=True, kw_only=True, slots=True)
class Reach:
    """Radii of a workspace, in the table's unit.

    Attributes:
        inner: least distance.
        outer: greatest distance.
    """

    inner: float
    outer: float


def reach(
    table: NumericTable,
    point: Array,
    origin: Array,
    square_to: Array | None,
    limits: Sequence[Interval | None],
) -> Reach:
    """Return the least and greatest distance of a point of the last link.

    Args:
        table: the robot.
        point: (3,) the point in frame N.
        origin: (3,) in frame 0, from where the distance is measured.
        square_to: (3,) unit direction of an axis through the origin; then the distance is that from the axis.
        limits: per joint, lowest and highest value; None for a joint that turns fully. [rad or length]

    Raises:
        ValueError: a slide has no limits.
    """
    spans = [
        limit or _full_turn(joint_type) for limit, joint_type in zip(limits, table.joint_types, strict=True)
    ]
    tool = np.eye(4)
    tool[:3, 3] = point
    near, far = maxima(table, distance_objectives(origin, square_to), np.array(spans), tool)
    return Reach(inner=math.sqrt(max(-near.value, 0.0)), outer=math.sqrt(max(far.value, 0.0)))


def _full_turn(joint_type: JointType) -> Interval:
    if joint_type is JointType.PRISMATIC:
        raise ValueError("a slide needs limits")
    return TURN
