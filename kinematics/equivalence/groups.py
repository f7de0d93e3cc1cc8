"""The subgroups of SE(3) in which the admissible frame choices live.

At every joint the motions g that may still be applied to the submission form a coset of one of these groups,
and which one it is depends on the reference alone: SE(3), the rotations about a point, the translations and
rotations about a direction, a cylinder group (rotations about and translations along a line), the rotations
about a line, and the translations in a subspace. Each is a set of rotations together with a space of
translations.
"""

from dataclasses import dataclass
from enum import Enum, auto

from kinematics.se3 import (
    ORIGIN,
    Z_AXIS,
    Motion,
    Vector,
    angle_between,
    move,
    norm,
    rejection,
    rotate,
    rotation_angle,
    subtract,
    unit,
)


class Rotations(Enum):
    """Which rotations a group holds."""

    NONE = auto()
    ABOUT_LINE = auto()
    ABOUT_POINT = auto()


@dataclass(frozen=True, slots=True)
class Group:
    """A group of rigid motions.

    Attributes:
        rotations: which rotations it holds.
        point: a point of the line, or the point, that they are about.
        axis: unit direction of the line.
        translations: orthonormal basis of the space of its translations, of dimension 0 to 3.
    """

    rotations: Rotations
    point: Vector = ORIGIN
    axis: Vector = Z_AXIS
    translations: tuple[Vector, ...] = ()


@dataclass(frozen=True, slots=True)
class Nearness:
    """When directions count as parallel and points as coincident, in deciding the structure of the reference.

    Attributes:
        angle: [rad].
        length: in the table's unit.
        slide: the same as `angle` for a translation beside an axis, which a small displacement across the
            axis would multiply by the inverse of the angle [rad].
    """

    angle: float
    length: float
    slide: float


SPACE: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
EVERYTHING = Group(Rotations.ABOUT_POINT, translations=SPACE)
NOTHING = Group(Rotations.NONE)


def about_point(point: Vector) -> Group:
    """Return all rotations about a point."""
    return Group(Rotations.ABOUT_POINT, point=point)


def about_direction(axis: Vector) -> Group:
    """Return all translations, and the rotations about a direction."""
    return Group(Rotations.ABOUT_LINE, axis=axis, translations=SPACE)


def cylinder(point: Vector, axis: Vector) -> Group:
    """Return the rotations about and translations along a line."""
    return Group(Rotations.ABOUT_LINE, point=point, axis=axis, translations=(axis,))


def distance_to_line(p: Vector, point: Vector, axis: Vector) -> float:
    """Return the distance of p from the line through a point along a unit axis."""
    return norm(rejection(subtract(p, point), axis))


def are_parallel(a: Vector, b: Vector, near: Nearness) -> bool:
    """Return whether two unit vectors are parallel or antiparallel."""
    return norm(rejection(a, b)) <= near.angle


def outside(v: Vector, basis: tuple[Vector, ...]) -> Vector:
    """Return the part of v that is perpendicular to a space with this orthonormal basis."""
    for b in basis:
        v = rejection(v, b)
    return v


def _along(basis: tuple[Vector, ...], direction: Vector, near: Nearness) -> tuple[Vector, ...]:
    """Basis of the translations of a space that run along a direction."""
    if basis and norm(outside(direction, basis)) <= near.slide:
        return (direction,)
    return ()


def fixing_direction(group: Group, direction: Vector, near: Nearness) -> Group:
    """Return the subgroup whose motions keep a direction as it is."""
    if group.rotations is Rotations.ABOUT_POINT:
        return Group(Rotations.ABOUT_LINE, point=group.point, axis=direction, translations=group.translations)
    if group.rotations is Rotations.ABOUT_LINE and not are_parallel(group.axis, direction, near):
        return Group(Rotations.NONE, translations=group.translations)
    return group


def fixing_line(group: Group, point: Vector, direction: Vector, near: Nearness) -> Group:
    """Return the subgroup whose motions keep an oriented line as it is (and may slide it along itself)."""
    along = _along(group.translations, direction, near)
    if len(group.translations) == len(SPACE):
        turning = group.rotations is Rotations.ABOUT_POINT or (
            group.rotations is Rotations.ABOUT_LINE and are_parallel(group.axis, direction, near)
        )
        return cylinder(point, direction) if turning else Group(Rotations.NONE, translations=along)
    if group.rotations is Rotations.ABOUT_POINT:
        turning = distance_to_line(group.point, point, direction) <= near.length
    elif group.rotations is Rotations.ABOUT_LINE:
        turning = (
            are_parallel(group.axis, direction, near)
            and distance_to_line(point, group.point, group.axis) <= near.length
        )
    else:
        turning = False
    if turning:
        return Group(Rotations.ABOUT_LINE, point=point, axis=direction, translations=along)
    return Group(Rotations.NONE, translations=along)


def with_rotations_about(group: Group, point: Vector, direction: Vector) -> Group:
    """Return the group of a line's fixing motions, together with the rotations about that line."""
    return Group(Rotations.ABOUT_LINE, point=point, axis=direction, translations=group.translations)


def with_translations_along(group: Group, direction: Vector, near: Nearness) -> Group:
    """Return the group, together with the translations along a direction."""
    rest = outside(direction, group.translations)
    if norm(rest) <= near.slide:
        return group
    return Group(
        group.rotations, point=group.point, axis=group.axis, translations=(*group.translations, unit(rest))
    )


def departure(group: Group, g: Motion) -> tuple[float, float]:
    """Return how far a motion is from belonging to the group.

    Returns:
        Angle [rad] and length, both zero for a member.
    """
    if group.rotations is Rotations.NONE:
        return rotation_angle(g), norm(outside((g[9], g[10], g[11]), group.translations))
    if group.rotations is Rotations.ABOUT_POINT:
        return 0.0, norm(outside(subtract(move(g, group.point), group.point), group.translations))
    angle = angle_between(rotate(g, group.axis), group.axis)
    return angle, norm(outside(subtract(move(g, group.point), group.point), group.translations))
