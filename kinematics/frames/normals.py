"""How two axes lie relative to each other, and their common normal."""

from dataclasses import dataclass
from enum import StrEnum

from kinematics.frames.axes import AxisLine
from kinematics.se3 import Vector, along, cross, dot, foot, norm, rejection, scale, subtract, unit

EXACT_ANGLE = 1e-10
"""Two directions closer than this [rad] are taken as parallel without a word: it is rounding."""

EXACT_LENGTH = 1e-10
"""Lengths below this part of the robot's size are taken as zero without a word: it is rounding."""


class Relation(StrEnum):
    """How two consecutive axes lie relative to each other.

    SKEW: one common normal. INTERSECTING: one common point. PARALLEL and ANTIPARALLEL: apart, the same or
    the opposite direction. COINCIDENT: on one line, whichever way they point.
    """

    SKEW = "skew"
    INTERSECTING = "intersecting"
    PARALLEL = "parallel"
    ANTIPARALLEL = "antiparallel"
    COINCIDENT = "coincident"

    @property
    def slides(self) -> bool:
        """Whether the common normal may sit anywhere along the axes."""
        return self in (Relation.PARALLEL, Relation.ANTIPARALLEL, Relation.COINCIDENT)


@dataclass(frozen=True, slots=True)
class CommonNormal:
    """The common normal of two axes.

    Attributes:
        relation: how the axes lie.
        direction: unit vector from the first axis to the second; of intersecting axes z_1 × z_2, whose
            sign is free; None of coincident axes, where any perpendicular serves.
        near: its foot on the first axis; where the normal slides, the foot of the first axis's point.
        far: its foot on the second axis.
        length: the distance of the axes [m].
    """

    relation: Relation
    direction: Vector | None
    near: Vector
    far: Vector
    length: float


def common_normal(first: AxisLine, second: AxisLine, size: float) -> CommonNormal:
    """Return the common normal of two axes.

    With c = z_1 × z_2 and w = p_2 - p_1, the feet of the normal are p_1 + ((w × z_2)·c / c²) z_1 and
    p_2 + ((w × z_1)·c / c²) z_2.

    Args:
        first: axis i.
        second: axis i+1.
        size: the robot's size [m], by which zero is judged.

    Source: seed 000 §3.2.4 steps 3 and 5; seed 002 steps 3 and 4; seed 004 cases 1 to 3.
    """
    z1, z2 = first.direction, second.direction
    c = cross(z1, z2)
    sine = norm(c)
    w = subtract(second.point, first.point)
    if sine <= EXACT_ANGLE:
        return _parallel_normal(first, second, w, size)
    squared = sine * sine
    near = along(first.point, dot(cross(w, z2), c) / squared, z1)
    far = along(second.point, dot(cross(w, z1), c) / squared, z2)
    n = _across(c, z1)
    distance = dot(w, n)
    if abs(distance) <= EXACT_LENGTH * size:
        return CommonNormal(Relation.INTERSECTING, n, near, near, 0.0)
    if distance < 0.0:
        n, distance = scale(n, -1.0), -distance
    return CommonNormal(Relation.SKEW, n, near, far, distance)


def _parallel_normal(first: AxisLine, second: AxisLine, w: Vector, size: float) -> CommonNormal:
    across = rejection(w, first.direction)
    distance = norm(across)
    far = foot(first.point, second.point, second.direction)
    if distance <= EXACT_LENGTH * size:
        return CommonNormal(Relation.COINCIDENT, None, first.point, far, 0.0)
    relation = Relation.PARALLEL if dot(first.direction, second.direction) > 0 else Relation.ANTIPARALLEL
    return CommonNormal(relation, _across(across, first.direction), first.point, far, distance)


def _across(v: Vector, axis: Vector) -> Vector:
    """The direction of v, which is perpendicular to an axis but for the rounding of what it was formed from.

    Of a short v that rounding is a large part, and an x that is not across its axis tilts the next one.
    """
    return unit(rejection(unit(v), axis))
