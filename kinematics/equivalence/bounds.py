"""Bounds on how far equation (1) fails, over all configurations: what need not be searched or climbed for.

With every axis of the submission moved to σ∘q + δ and every axis of the reference moved by B, equation (1) is
one product of exponentials against another. Exchanging factor after factor, the difference is the sum of

    ‖exp([A_i] q) x − exp([B_i] q) x‖ ≤ 2α_i |x − a_i| + 2 |a_i − b_i|,      x the end frame's origin,

α_i the angle between the axes and a_i, b_i points of them, and of what the end frames differ by; of
rotations, of the angles 2α_i. The sum bounds the difference from above wherever the joints stand.
"""

from itertools import pairwise
from math import cos, sin

from kinematics.chain import Axis, Chain
from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.verification import Residual
from kinematics.se3 import (
    Motion,
    Vector,
    angle_between,
    compose,
    cross,
    dot,
    foot,
    inverse,
    move,
    norm,
    position,
    rejection,
    rotate,
    rotation_about,
    rotation_angle,
    scale,
    subtract,
    translation,
)

CERTAINLY = 10.0
"""In units of the tolerance. A joint turned by π shows the direction of its axis within one, and the point of
the axis nearest to the end frame; so two axes lie to each other within two, and parallel ones, whose points
are at most two robots apart, are within four of their distance. Twice that is certain."""
PARALLEL = 1e-12  # A sine: axes are parallel but for the errors of the arithmetic.


def upper_bound(reference: Reference, submission: Chain, candidate: CertificateCandidate) -> Residual:
    """Bound the difference between the two sides of equation (1) over all configurations, from above.

    Revolute joints go all the way round, prismatic joints as far as the robot's size either way.
    """
    base, size = candidate.base, reference.size
    placed: list[tuple[Vector, Vector]] = []
    here: Motion | None = None
    for axis, offset in zip(submission.axes, candidate.offsets, strict=True):
        direction, point = axis.direction, axis.point
        if here is not None:
            direction, point = rotate(here, direction), move(here, point)
        placed.append((direction, point))
        if offset:
            step = _motion(direction, point, offset, prismatic=axis.prismatic)
            here = step if here is None else compose(step, here)
    end = submission.end if here is None else compose(here, submission.end)
    wanted = compose(compose(base, reference.chain.end), candidate.tool)
    angle = rotation_angle(compose(inverse(end), wanted))
    length = norm(subtract(position(end), position(wanted)))
    reach, tip = 0.0, position(end)
    signs = candidate.signs
    for i in range(len(placed) - 1, -1, -1):
        axis, (direction, point) = reference.chain.axes[i], placed[i]
        other = rotate(base, axis.direction)
        apart = angle_between(scale(direction, float(signs[i])), other)
        if axis.prismatic:
            length += size * apart
            reach += size
            continue
        ours = foot(tip, point, direction)
        reach += norm(subtract(tip, ours))
        tip = ours
        theirs = foot(ours, move(base, axis.point), other)
        angle += 2.0 * apart
        length += 2.0 * (apart * reach + norm(subtract(ours, theirs)))
    return Residual(angle, length / size)


def surely_apart(reference: Reference, submission: Chain, tolerance: Tolerance) -> bool:
    """Return whether neighbouring axes lie so differently to each other that no certificate can stand.

    Angles are compared, and distances of parallel axes; False says nothing.
    """
    most_angle = CERTAINLY * max(tolerance.angle, tolerance.length)
    most_length = most_angle * reference.size
    pairs = zip(pairwise(reference.chain.axes), pairwise(submission.axes), strict=True)
    for (a, b), (c, d) in pairs:
        ours, theirs = cross(a.direction, b.direction), cross(c.direction, d.direction)
        across, beside = norm(ours), norm(theirs)
        along, with_it = abs(dot(a.direction, b.direction)), abs(dot(c.direction, d.direction))
        if abs(across - beside) > most_angle or abs(along - with_it) > most_angle:
            return True
        parallel = max(across, beside) < PARALLEL and not (a.prismatic or b.prismatic)
        if parallel and abs(_apart(a, b) - _apart(c, d)) > most_length:
            return True
    return False


def _apart(first: Axis, second: Axis) -> float:
    """The distance of parallel axes."""
    return norm(rejection(subtract(second.point, first.point), first.direction))


def _motion(direction: Vector, point: Vector, value: float, *, prismatic: bool) -> Motion:
    if prismatic:
        return translation(scale(direction, value))
    return rotation_about(point, direction, cos(value), sin(value))
