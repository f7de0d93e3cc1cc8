"""All solutions of arms that can be taken apart: a head of at most three joints of any kind, and a tail.

The tail is up to three revolute joints at the end-effector whose axes pass through one point. That point,
which the tail cannot move, has its place by the head alone (Pieper's condition); what rotation is left is the
tail's. A tail of one joint leaves its whole axis alone, an empty tail the whole end-effector: so arms of up
to four joints can always be taken apart, and of the longer ones those with a wrist, the Stanford arm among
them.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.axis_lines import angle_about, common_point
from kinematics.inverse.methods.position import DegenerateError, Joint, place_points
from kinematics.inverse.methods.trigonometric import rotations
from kinematics.se3 import cross_arrays, inverse_transform

LONGEST_HEAD = 3  # Joints that the positions of points fix: `position` solves for three.
LONGEST_TAIL = 3  # Joints behind these that turn about one point: a wrist.

_PARALLEL = 1e-6  # Sine of the angle below which two axes are parallel.

_ALONG = 1e-12
"""Sine of the angle to an axis below which a direction lies along it: well below every tolerance."""

_HAND = np.array(((0.4142, 0.7321, 0.2361), (-0.6458, 0.3166, 0.1231), (0.3589, -0.2426, 0.7958)))
"""Three points of the end-effector, in units of the size; they fix its pose and lie on no likely axis."""


@dataclass(frozen=True, eq=False)
class PartitionedArm:
    """A head that places points, and a tail that turns about them.

    Attributes:
        head: at most three joints of any kind.
        tail: at most three revolute joints with axes through one point.
        points: (k, 3) points at q = 0 that the tail leaves alone and the head places.
        end: (4, 4) pose of the end-effector at q = 0.
        size: the arm's size.
    """

    head: Sequence[Joint]
    tail: Sequence[Joint]
    points: Array
    end: Array
    size: float

    def candidates(self, target: Array) -> Array | None:
        """See `InverseClosedForm`."""
        moved = target @ inverse_transform(self.end)
        try:
            heads = place_points(self.head, self.points, _applied(moved, self.points), self.size)
        except DegenerateError:
            return None
        found: list[list[float]] = []
        for q in heads:
            R = moved[:3, :3]
            for joint, value in zip(self.head, q, strict=True):
                R = rotations(joint.axis, -value) @ R if joint.revolute else R
            found.extend([*q, *revolute] for revolute in _tail_turns(self.tail, R))
        return np.array(found, dtype=np.float64).reshape(len(found), len(self.head) + len(self.tail))


def partition_of(arm: Arm) -> PartitionedArm | None:
    """Return the way to take an arm apart, or None if there is none."""
    if arm.n_joints <= LONGEST_HEAD:
        return _undivided(arm, arm.size * _HAND)
    return _partition(_joints_of(arm), arm.screws[2], arm.size)


def placement_of(arm: Arm) -> PartitionedArm | None:
    """Return the way to bring the tool's origin to a place, or None of more than three joints."""
    return _undivided(arm, arm.screws[2][None, :3, 3]) if arm.n_joints <= LONGEST_HEAD else None


def _undivided(arm: Arm, points: Array) -> PartitionedArm:
    """An arm that is all head, which places the points."""
    return PartitionedArm(_joints_of(arm), [], points, arm.screws[2], arm.size)


def _joints_of(arm: Arm) -> list[Joint]:
    directions, points, _ = arm.screws
    return [
        Joint(bool(revolute), axis, point)
        for revolute, axis, point in zip(arm.revolute, directions, points, strict=True)
    ]


def _partition(joints: Sequence[Joint], end: Array, size: float) -> PartitionedArm | None:
    shortest = max(len(joints) - LONGEST_HEAD, 1)
    for length in range(LONGEST_TAIL, shortest - 1, -1):
        head, tail = joints[:-length], joints[-length:]
        points = _points_left_alone(tail, size)
        if points is not None:
            return PartitionedArm(head, tail, points, end, size)
    return None


def _points_left_alone(tail: Sequence[Joint], size: float) -> Array | None:
    """What the tail cannot move: two points of its only axis, or the common point of its axes."""
    if not all(joint.revolute for joint in tail):
        return None
    if len(tail) == 1:
        along = size * tail[0].axis
        return np.array((tail[0].point - 0.7 * along, tail[0].point + 0.4 * along))
    if any(_parallel(one.axis, other.axis) for one, other in pairwise(tail)):
        return None
    axes, own = np.array([joint.axis for joint in tail]), np.array([joint.point for joint in tail])
    centre = common_point(axes, own / size)
    return None if centre is None else size * centre[None]


def _tail_turns(tail: Sequence[Joint], R: Array) -> list[list[float]]:
    """The ways in which turns about the axes of the tail make a rotation R, as nearly as may be.

    Of three axes q_5 follows from z_4·R z_6 = z_4·E_5 z_6, two ways. Of the others the earlier follows from
    E_4 (E_5 z_6) = R z_6, the last from what is left.
    """
    axes = [joint.axis for joint in tail]
    if not axes:
        return [[]]
    if len(axes) == 1:
        return [[_last_turn(axes[0], R)]]
    if len(axes) == 2:
        q4 = _turn(axes[0], axes[1], R @ axes[1])
        return [[q4, _last_turn(axes[1], rotations(axes[0], q4).T @ R)]]
    z4, z5, z6 = axes
    along = (z4 @ z5) * (z5 @ z6)
    middle = np.arctan2(float(z4 @ cross_arrays(z5, z6)), float(z4 @ z6 - along))
    half = _half_turn(_angle(z4, z5), _angle(z5, z6), _angle(z4, R @ z6))
    found = []
    for q5 in (float(middle - half), float(middle + half)):
        R5 = rotations(z5, q5)
        q4 = _turn(z4, R5 @ z6, R @ z6)
        found.append([q4, q5, _last_turn(z6, R5.T @ rotations(axes[0], q4).T @ R)])
    return found


def _half_turn(first: float, second: float, wanted: float) -> float:
    """The turn of q_5 out of the plane of three axes that leaves a wanted angle between the outer ones.

    cos wanted = cos first · cos second + sin first · sin second · cos turn, by half angles: the arccosine of
    what is beside 1 has half its digits, and a wrist that is 1e-8 rad from its line would be in line.
    """
    sine = np.sin(0.5 * (wanted + first - second)) * np.sin(0.5 * (wanted - first + second))
    cosine = np.sin(0.5 * (first + second + wanted)) * np.sin(0.5 * (first + second - wanted))
    return 2.0 * float(np.arctan2(np.sqrt(max(float(sine), 0.0)), np.sqrt(max(float(cosine), 0.0))))


def _angle(u: Array, v: Array) -> float:
    """The angle between two directions."""
    return float(np.arctan2(np.linalg.norm(cross_arrays(u, v)), u @ v))


def _last_turn(axis: Array, R: Array) -> float:
    """The angle of a rotation about an axis."""
    across = np.linalg.svd(axis[None])[2][1]
    return _turn(axis, across, R @ across)


def _turn(axis: Array, u: Array, v: Array) -> float:
    """The angle about an axis from u to v; 0 if either lies along it, and every angle would do."""
    across = (float(np.linalg.norm(cross_arrays(axis, w))) for w in (u, v))
    return 0.0 if min(across) < _ALONG else angle_about(axis, u, v)


def _parallel(u: Array, v: Array) -> bool:
    return float(np.linalg.norm(cross_arrays(u, v))) <= _PARALLEL


def _applied(T: Array, x: Array) -> Array:
    """Points (…, 3) moved by a transform."""
    return np.asarray(x @ T[:3, :3].T + T[:3, 3])
