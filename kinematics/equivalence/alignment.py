"""One alignment: move the submission's axis onto plus or minus the reference's by a motion of a group."""

import math
from typing import NamedTuple

from kinematics.equivalence.groups import Rotations
from kinematics.equivalence.plan import Step
from kinematics.se3 import (
    IDENTITY,
    Motion,
    Vector,
    angle_between,
    compose,
    cross,
    dot,
    move,
    norm,
    rejection,
    rotate,
    rotation_about,
    subtract,
    translation,
    turn_onto,
)


class Alignment(NamedTuple):
    """The best motion of the group, and what it leaves.

    Attributes:
        motion: the motion, a member of the step's group.
        angle: angle left between the axes [rad].
        gap: displacement left from the submission's axis to the reference's, perpendicular to the latter.
        distance: its length.
        direction: the submission's direction after the motion.
    """

    motion: Motion
    angle: float
    gap: Vector
    distance: float
    direction: Vector


_NO_GAP = (0.0, 0.0, 0.0)


def align(step: Step, direction: Vector, point: Vector, sign: int) -> Alignment:
    """Bring an axis onto the step's, as far as the step's group can.

    Args:
        step: the target and the group.
        direction: unit direction of the axis.
        point: a point of it.
        sign: +1 to bring the directions together, -1 to bring them opposite.
    """
    h, direction, gap = aligning_motion(step, direction, point, sign)
    angle = angle_between(direction, step.axis.direction)
    if step.axis.prismatic:
        return Alignment(h, angle, _NO_GAP, 0.0, direction)
    gap = rejection(gap, step.axis.direction)
    return Alignment(h, angle, gap, norm(gap), direction)


def aligning_motion(step: Step, direction: Vector, point: Vector, sign: int) -> tuple[Motion, Vector, Vector]:
    """Return the motion of `align` by itself, for where it does not matter how well it does.

    Returns:
        The motion; the axis's direction, reversed for sign -1, after it; what is left from its point to the
        target's.
    """
    if sign < 0:
        direction = (-direction[0], -direction[1], -direction[2])
    target = step.axis
    h = _rotation(step, direction, point)
    if h is not IDENTITY:
        direction = rotate(h, direction)
    if target.prismatic:
        return h, direction, _NO_GAP
    if h is not IDENTITY:
        point = move(h, point)
    gap = subtract(target.point, point)
    if step.slide is not None:
        a, b, c, d, e, f, k, l, m = step.slide  # noqa: E741
        x, y, z = gap
        v = (a * x + b * y + c * z, d * x + e * y + f * z, k * x + l * y + m * z)
        gap = subtract(gap, v)
        h = translation(v) if h is IDENTITY else (*h[:9], h[9] + v[0], h[10] + v[1], h[11] + v[2])
    elif len(step.group.translations) == 3:
        gap = rejection(gap, target.direction)
    return h, direction, gap


def _rotation(step: Step, direction: Vector, point: Vector) -> Motion:
    group, target = step.group, step.axis
    if group.rotations is Rotations.NONE:
        return IDENTITY
    if group.rotations is Rotations.ABOUT_LINE:
        return _turn(step, group.axis, direction, point)
    h = turn_onto(group.point, direction, target.direction)
    if step.by_moment:
        second = _turn(step, target.direction, rotate(h, direction), move(h, point))
        return compose(second, h)
    return h


def _turn(step: Step, axis: Vector, direction: Vector, point: Vector) -> Motion:
    """The rotation about a line that best brings direction and moment onto the target's, in closed form."""
    cosine = sine = 0.0
    if step.by_direction:
        goal = step.axis.direction
        cosine = dot(direction, goal) - dot(direction, axis) * dot(goal, axis)
        sine = dot(axis, cross(direction, goal))
    if step.by_moment:
        goal = step.moment
        moment = cross(subtract(point, step.group.point), direction)
        cosine += step.by_moment * (dot(moment, goal) - dot(moment, axis) * dot(goal, axis))
        sine += step.by_moment * dot(axis, cross(moment, goal))
    size = math.hypot(cosine, sine)
    if size < 1e-14:
        return IDENTITY
    return rotation_about(step.group.point, axis, cosine / size, sine / size)
