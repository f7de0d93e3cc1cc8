"""How an arm whose axes are at right angles is taken apart."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from kinematics.expressions import ZERO, Expression, add, negate
from kinematics.inverse_forms.planar_joints import JointPlane
from kinematics.inverse_forms.signed_axes import Axis, SignedArm, SignedJoint, Vector
from kinematics.se3 import cross, dot, opposite, triple

LONGEST_TAIL = 3  # Joints of a wrist: what turns about its centre leaves the other joints to bring it there.
_UNIT: tuple[Axis, ...] = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


@dataclass(frozen=True, kw_only=True, slots=True)
class Parts:
    """An arm taken apart.

    Attributes:
        lead: the joint that turns across the plane, or None.
        slide: the joint that slides along the plane's normal, or None.
        tilt: the joint that turns across the plane's normal behind two planar joints, or None.
        planar: two or three joints that move in the plane; or none, and the tail is all but a slide.
        tail: the turns at the end-effector.
        point: the point that the tail leaves alone.
    """

    lead: SignedJoint | None
    slide: SignedJoint | None
    tilt: SignedJoint | None
    planar: tuple[SignedJoint, ...]
    tail: tuple[SignedJoint, ...]
    plane: JointPlane
    point: Vector


def partitions(arm: SignedArm) -> Iterator[Parts]:
    """Yield the ways to take an arm apart, those with most joints in a plane first."""
    n = len(arm.joints)
    for size in (3, 2, 0):
        for length in range(min(LONGEST_TAIL, n - size), -1, -1):
            head, tail = arm.joints[: n - length], arm.joints[n - length :]
            if len(head) - size > 1 or (size == 3 and length == LONGEST_TAIL):
                continue
            point = _point_left_alone(tail, arm.end)
            if point is None:
                continue
            for h in _UNIT:
                parts = _parts(head, tail, size, h, point)
                if parts is not None:
                    yield parts


def _parts(
    head: Sequence[SignedJoint], tail: Sequence[SignedJoint], size: int, h: Axis, point: Vector
) -> Parts | None:
    plane = JointPlane(h, cross(h, _across(h)))
    planar = tuple(joint for joint in head if plane.moves_in(joint))
    others = [joint for joint in head if not plane.moves_in(joint)]
    if len(planar) != size or len(others) > 1 or (not any(joint.turns for joint in planar) and size == 3):
        return None
    senses = [plane.sense(joint) for joint in planar if joint.turns]
    if senses and senses[0] < 0:
        h = opposite(h)
    lead = slide = tilt = None
    if others:
        (other,) = others
        if not other.turns:
            slide = other
        elif other is head[0] and planar:
            lead = other
        elif other is head[-1] and size == 2:
            tilt = other
        else:
            return None
    across = lead or tilt
    f = _upright(cross(h, across.axis if across else _across(h)))
    return Parts(
        lead=lead,
        slide=slide,
        tilt=tilt,
        planar=planar,
        tail=tuple(tail),
        plane=JointPlane(h, f),
        point=point,
    )


def _upright(axis: Axis) -> Axis:
    """The axis or its opposite, whichever is x, y or z."""
    return axis if axis in _UNIT else opposite(axis)


def _across(h: Axis) -> Axis:
    """The axis with cross(h, it) = x, y, z in turn: coordinates x, y of h = z."""
    i = next(i for i in range(3) if h[i])
    return tuple(-int(k == (i + 2) % 3) for k in range(3))  # type: ignore[return-value]


def _point_left_alone(tail: Sequence[SignedJoint], end: Vector) -> Vector | None:
    """The common point of the axes of the tail that is nearest to the end; without a tail the end itself."""
    if not all(joint.turns for joint in tail):
        return None
    if any(dot(one.axis, other.axis) for one, other in pairwise(tail)):
        return None
    known: dict[int, Expression] = {}
    for joint in tail:
        for i in range(3):
            if joint.axis[i]:
                continue
            if i in known and add((known[i], negate(joint.point[i]))) != ZERO:
                return None
            known[i] = joint.point[i]
    return triple(known.get(i, end[i]) for i in range(3))
