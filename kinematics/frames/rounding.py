"""Frames that students rounded: what lies within a tolerance of what a rule asks for is taken to lie there.

The rules of `rules` are exact. On paper 0.7071 stands for √2/2 and 0.432 for 0.4318; the nearest frame that
obeys a rule is meant if it is no farther away than the tolerance.
"""

from collections.abc import Sequence
from dataclasses import replace

from kinematics.frames.axes import AxisLine, PartialPose
from kinematics.frames.rules import FramePlace
from kinematics.se3 import Vector, along, cross, dot, foot, norm, rejection, scale, subtract, unit
from kinematics.table import JointType

PARALLEL = 1e-9
"""Sine below which two exact directions count as parallel: rounding of unit vectors in double precision."""


def settled(frame: PartialPose, place: FramePlace, tolerance: float) -> PartialPose:
    """Return the frame with every part moved onto what its rule asks for, if that is within the tolerance.

    Args:
        frame: as the student chose it.
        place: the axes that it belongs to.
        tolerance: of directions [rad], and of points as a part of the robot's size.
    """
    z = _z(frame.z, place, tolerance)
    x = _x(frame.x, z, place, tolerance)
    if place.own_line is None and x is not None and z is not None and abs(dot(x, z)) <= tolerance:
        z = unit(rejection(z, x))
    return PartialPose(_origin(frame.origin, x, place, tolerance), x, z)


def slides_on_neighbours(
    frames: Sequence[PartialPose], lines: Sequence[AxisLine], holders: Sequence[int], near: float
) -> list[PartialPose]:
    """Return the frames with the lines of prismatic joints moved onto parallel neighbours that are near.

    The line of a prismatic joint goes through the origin of its frame. Rounded, it misses a neighbouring axis
    that it was drawn on, and would ask for a common normal that nobody meant.

    Args:
        frames: frame 0 … N.
        lines: axis 1 … N.
        holders: per axis the number of the frame whose z lies along it.
        near: what counts as near [m].
    """
    moved = list(frames)
    for k, line in enumerate(lines):
        origin = moved[holders[k]].origin
        if line.joint is not JointType.PRISMATIC or origin is None:
            continue
        for other in (k - 1, k + 1):
            if not 0 <= other < len(lines) or norm(cross(line.direction, lines[other].direction)) > PARALLEL:
                continue
            slides = lines[other].joint is JointType.PRISMATIC
            point = moved[holders[other]].origin if slides else lines[other].point
            if point is None:
                continue
            there = foot(origin, point, lines[other].direction)
            if norm(subtract(there, origin)) <= near:
                moved[holders[k]] = replace(moved[holders[k]], origin=there)
                origin = there
    return moved


def _z(z: Vector | None, place: FramePlace, tolerance: float) -> Vector | None:
    if z is None or place.own_line is None:
        return z
    axis = place.own_line.direction
    if norm(cross(z, axis)) > tolerance:
        return z
    return axis if dot(z, axis) > 0 else scale(axis, -1.0)


def _x(x: Vector | None, z: Vector | None, place: FramePlace, tolerance: float) -> Vector | None:
    if x is None:
        return None
    if place.own_line is not None and z is not None and abs(dot(x, z)) <= tolerance:
        x = unit(rejection(x, z))
    partner = place.partner_direction
    if partner is None or abs(dot(x, partner)) > tolerance:
        return x
    if place.own_line is None:
        return unit(rejection(x, partner))
    wanted = _common_normal_direction(place)
    if wanted is None or norm(cross(x, wanted)) > tolerance:
        return x
    return wanted if dot(x, wanted) > 0 else scale(wanted, -1.0)


def _common_normal_direction(place: FramePlace) -> Vector | None:
    """Return the direction that x must have, up to its sense; None where it may be any across the axis."""
    own, partner = place.own_line, place.partner_direction
    if own is None or partner is None:
        return None
    across = cross(own.direction, partner)
    if norm(across) > PARALLEL:
        return unit(across)
    if place.partner_line is None:
        return None
    apart = rejection(subtract(place.partner_line.point, own.point), own.direction)
    return unit(apart) if norm(apart) > PARALLEL * place.size else None


def _origin(origin: Vector | None, x: Vector | None, place: FramePlace, tolerance: float) -> Vector | None:
    if origin is None:
        return None
    near = tolerance * place.size
    own, partner = place.own_line, place.partner_line
    if own is None:
        if partner is None or x is None:
            return origin
        apart = subtract(foot(origin, partner.point, partner.direction), origin)
        missed = subtract(apart, scale(x, dot(apart, x)))
        return along(origin, 1.0, missed) if norm(missed) <= near else origin
    on_axis = foot(origin, own.point, own.direction)
    if norm(subtract(on_axis, origin)) > near:
        return origin
    across = None if partner is None else cross(own.direction, partner.direction)
    if partner is None or across is None or norm(across) <= PARALLEL:
        return on_axis
    apart = subtract(partner.point, own.point)
    reach = dot(cross(apart, partner.direction), across) / dot(across, across)
    end = along(own.point, reach, own.direction)
    return end if norm(subtract(end, on_axis)) <= near else on_axis
