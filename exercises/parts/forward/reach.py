"""How near to and how far from a place the joints bring a point: the radii of a workspace."""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from kinematics.se3 import Vector
from kinematics.table import JointType, NumericTable
from kinematics.workspace.coordinate_ascent import maxima
from kinematics.workspace.objectives import distance_objectives

Interval = tuple[float, float]

TURN: Interval = (-math.pi, math.pi)
REST: Interval = (0.0, 0.0)


@dataclass(frozen=True, kw_only=True, slots=True)
class Reach:
    """Radii of a workspace, in one unit of length."""

    inner: float
    outer: float


@lru_cache(maxsize=512)
def reach(
    table: NumericTable,
    point: Vector,
    origin: Vector,
    axis: Vector | None,
    limits: tuple[Interval | None, ...],
) -> Reach:
    """Return the least and greatest distance of a point of the last link, once for all with the same values.

    Args:
        point: the point in frame N.
        origin: in frame 0, from where the distance is measured.
        axis: unit direction of an axis through the origin; then the distance is that from the axis.
        limits: per joint, lowest and highest value [rad or length]; None for a joint that turns fully, or for
            a slide that rests at zero.
    """
    spans = [
        limit or (TURN if kind is JointType.REVOLUTE else REST)
        for limit, kind in zip(limits, table.joint_types, strict=True)
    ]
    tool = np.eye(4)
    tool[:3, 3] = point
    objectives = distance_objectives(np.array(origin), None if axis is None else np.array(axis))
    near, far = maxima(table, objectives, np.array(spans), tool)
    return Reach(inner=math.sqrt(max(-near.value, 0.0)), outer=math.sqrt(max(far.value, 0.0)))
