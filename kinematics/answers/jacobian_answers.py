"""A Jacobian in numbers, and the joint forces for a wrench: are they right, and what is a wrong one?

    (v, ω) = J(q) q̇        τ = J(q)ᵀ (f, m)

The geometric Jacobian of the last frame's origin, in the axes of frame 0 or of the last frame, its rows in
either order, or the analytic one of a sequence of angles, is one matrix once table, configuration and these
are named: it is right when every entry is. Which frames the table has is the answerer's choice: J is that of
the answerer's own accepted table, the key's with B, diag(σ), and the point and the axes moved by E
(`kinematics.equivalence`).

Source: D. E. Whitney (1969); J. J. Craig, Introduction to Robotics, ch. 5; seed 001 eq. 3.22.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from kinematics.answers.jacobian_verdicts import JacobianMistake, JacobianVerdict
from kinematics.chain import Chain, size_of
from kinematics.errors import Fault, JointValueError
from kinematics.jacobian import JacobianFrame
from kinematics.rates import analytic_jacobian
from kinematics.rotations.sequences import EulerSequence
from kinematics.se3 import Floats

DEGREE = math.radians(1.0)  # Ratio of columns per degree to those per radian.
MIDDLE = 4
"""Row of the middle angle: its rate has the other sign for the other triple of the same orientation."""


def jacobian_at(
    chain: Chain, joints: Sequence[float], frame: JacobianFrame, angles: EulerSequence | None = None
) -> Floats:
    """Return the Jacobian of the last frame's origin, (6, n), linear rows first.

    Args:
        joints: the configuration [rad, or the table's length].
        frame: in whose axes the geometric one is.
        angles: of the analytic one, whose linear rows are in frame 0; None for the geometric one.

    Raises:
        JointValueError: the angles have no rates there.
    """
    if angles is not None:
        analytic = analytic_jacobian(chain, np.array(joints, dtype=np.float64), angles)
        if analytic is None:
            raise JointValueError(Fault.at("angles_locked", "joints", axes=angles.axes))
        return analytic
    jacobian = chain.jacobian(np.array(joints, dtype=np.float64))
    return jacobian if frame is JacobianFrame.BASE else _turned(chain, joints) @ jacobian


@np.errstate(all="ignore")
def judge_jacobian(
    chain: Chain,
    joints: Sequence[float],
    given: Floats,
    frame: JacobianFrame,
    tolerance: float,
    angles: EulerSequence | None = None,
) -> JacobianVerdict:
    """Judge a Jacobian, entry by entry.

    Args:
        chain: of the table that it is said to be of.
        joints: the configuration [rad, or the table's length].
        given: (6, n), linear rows first; any finite numbers.
        frame: in whose axes it is asked.
        tolerance: of an entry; where it is a length, as a share of the arm's size.
        angles: of the analytic Jacobian; either triple that makes the orientation may be meant.

    Raises:
        JointValueError: the angles have no rates there.
    """
    limit = entry_limits(chain, tolerance)

    def close(expected: Floats) -> NDArray[np.bool_]:
        return np.asarray(np.abs(given - expected) <= limit, dtype=np.bool_)

    expected = jacobian_at(chain, joints, frame, angles)
    if angles is not None and close(-expected)[MIDDLE].sum() > close(expected)[MIDDLE].sum():
        expected[MIDDLE] *= -1.0
    entries = close(expected)
    if entries.all():
        return JacobianVerdict(entries=entries)
    meant = [expected]
    if angles is not None:
        meant.append(expected.copy())
        meant[1][MIDDLE] *= -1.0
    for mistake, matrix in _whole(chain, joints, meant, frame, angles is not None):
        if close(matrix).all():
            return JacobianVerdict(entries=entries, mistakes=((mistake, None),))
    for unit, ours in product(_other_units(chain), meant):
        shown = (np.abs(ours) > limit)[~entries].any()  # any number is in another unit than a zero
        if shown and (np.abs(given / unit - ours) <= limit).all():
            return JacobianVerdict(entries=entries, mistakes=((JacobianMistake.OTHER_UNIT, None),))
    if angles is not None:
        return JacobianVerdict(entries=entries)
    wrong = [int(i) for i in np.flatnonzero(~entries.all(axis=0))]
    slips = tuple(_columns(chain, joints, given, frame, wrong, limit))
    if len(slips) < len(wrong) and _of_another_point(expected, given, entries, limit):
        slips = ((JacobianMistake.OTHER_POINT, None),)
    return JacobianVerdict(entries=entries, mistakes=slips)


@np.errstate(all="ignore")
def joint_forces_at(
    chain: Chain, joints: Sequence[float], wrench: Sequence[float], frame: JacobianFrame
) -> Floats:
    """Return τ = Jᵀ (f, m) of a wrench in a frame's axes, at the last frame's origin."""
    return np.asarray(jacobian_at(chain, joints, frame).T @ np.array(wrench), dtype=np.float64)


@np.errstate(all="ignore")
def judge_forces(
    chain: Chain,
    joints: Sequence[float],
    wrench: Sequence[float],
    given: Sequence[float],
    frame: JacobianFrame,
    tolerance: float,
) -> tuple[tuple[bool, ...], JacobianMistake | None]:
    """Judge joint forces; return which are right, and what wrong ones look like.

    Args:
        chain: of the table whose joints they are of.
        wrench: force and moment that the tool exerts, (f, m).
        given: one number for each joint.
        frame: in whose axes the wrench is given.
        tolerance: as a share of what force and moment can do at the arm's size.
    """
    size = size_of(chain) or 1.0
    force, moment = math.hypot(*wrench[:3]), math.hypot(*wrench[3:])
    limit = np.array(
        [tolerance * (force if axis.prismatic else force * size + moment) for axis in chain.axes]
    )
    values = np.array(given, dtype=np.float64)
    expected = joint_forces_at(chain, joints, wrench, frame)
    right = np.abs(values - expected) <= limit
    if right.all() or not values.any():
        return tuple(right.tolist()), None
    (other,) = set(JacobianFrame) - {frame}
    ways = (
        (JacobianMistake.SIGN, -expected),
        (JacobianMistake.OTHER_FRAME, joint_forces_at(chain, joints, wrench, other)),
        (JacobianMistake.ROWS_EXCHANGED, joint_forces_at(chain, joints, [*wrench[3:], *wrench[:3]], frame)),
        (JacobianMistake.SPATIAL, _spatial(chain, joints).T @ np.array(wrench)),
    )
    for mistake, forces in ways:
        if (np.abs(values - forces) <= limit).all():
            return tuple(right.tolist()), mistake
    return tuple(right.tolist()), None


def entry_limits(chain: Chain, tolerance: float) -> Floats:
    """Return the largest errors of the entries: lengths relative to the arm, all others as they are."""
    limit = np.full((6, len(chain.axes)), tolerance)
    size = size_of(chain) or 1.0
    for i, axis in enumerate(chain.axes):
        if not axis.prismatic:
            limit[:3, i] *= size
    return limit


def _whole(
    chain: Chain, joints: Sequence[float], meant: Sequence[Floats], frame: JacobianFrame, analytic: bool
) -> Iterator[tuple[JacobianMistake, Floats]]:
    """Yield what is written where one slip runs through a whole Jacobian, of either triple of angles."""
    (other,) = set(JacobianFrame) - {frame}
    if analytic:
        yield JacobianMistake.GEOMETRIC, jacobian_at(chain, joints, JacobianFrame.BASE)
    else:
        yield JacobianMistake.OTHER_FRAME, jacobian_at(chain, joints, other)
    for ours in meant:
        yield JacobianMistake.ROWS_EXCHANGED, np.vstack([ours[3:], ours[:3]])
    yield JacobianMistake.SPATIAL, _spatial(chain, joints)
    for ours in meant:
        yield (JacobianMistake.PER_DEGREE, ours * [1.0 if axis.prismatic else DEGREE for axis in chain.axes])


def _other_units(chain: Chain) -> Iterator[Floats]:
    """Yield how many times as large every entry is with lengths in mm or cm where m are asked, and back.

    The travel of prismatic joints may be in that unit, too, or not.
    """
    turning = [not axis.prismatic for axis in chain.axes]
    for columns in (turning, [True] * len(turning)):
        for ratio in (1000.0, 100.0, 0.01, 0.001):
            unit = np.ones((6, len(turning)))
            unit[:3, columns] = ratio
            yield unit


def _turned(chain: Chain, joints: Sequence[float]) -> Floats:
    """Return diag(Rᵀ, Rᵀ) of the last frame."""
    rotation = chain.poses(np.array(joints, dtype=np.float64))[:3, :3]
    return np.asarray(np.kron(np.eye(2), rotation.T), dtype=np.float64)


def _spatial(chain: Chain, joints: Sequence[float]) -> Floats:
    """Return the Jacobian of the point of the last link that is at frame 0's origin."""
    directions, points = chain.axes_at(np.array(joints, dtype=np.float64))
    columns = [
        [*direction, 0.0, 0.0, 0.0] if axis.prismatic else [*np.cross(point, direction), *direction]
        for axis, direction, point in zip(chain.axes, directions, points, strict=True)
    ]
    return np.array(columns).T


def _of_another_point(expected: Floats, given: Floats, entries: NDArray[np.bool_], limit: Floats) -> bool:
    """Return whether v is that of one other point of the last link: off by ω × d, d the same throughout."""
    if not entries[3:].all() or np.count_nonzero(~entries.all(axis=0)) < 2:
        return False
    off, angular = (given - expected)[:3], expected[3:]
    crossed = np.vstack([np.cross(omega, np.eye(3)).T for omega in angular.T])
    d = np.linalg.lstsq(crossed, off.T.ravel(), rcond=None)[0]
    return bool((np.abs(off - np.cross(angular.T, d).T) <= limit[:3]).all())


def _columns(
    chain: Chain,
    joints: Sequence[float],
    given: Floats,
    frame: JacobianFrame,
    wrong: Sequence[int],
    limit: Floats,
) -> Iterator[tuple[JacobianMistake, int | None]]:
    """Yield the slip that makes each wrong column, where one does."""
    directions, points = chain.axes_at(np.array(joints, dtype=np.float64))
    end = chain.poses(np.array(joints, dtype=np.float64))
    (other,) = set(JacobianFrame) - {frame}
    in_other = jacobian_at(chain, joints, other)
    turn = np.eye(6) if frame is JacobianFrame.BASE else _turned(chain, joints)
    n = len(chain.axes)
    lines = [*zip(directions, points, strict=True), (end[:3, 2], end[:3, 3])]
    for i in wrong:
        axis, (z, p) = chain.axes[i], lines[i]
        reach = end[:3, 3] - p
        ways: list[tuple[JacobianMistake, list[float]]] = []
        if axis.prismatic:
            ways.append((JacobianMistake.PRISMATIC, [*np.cross(z, reach), *z]))
            ways.append((JacobianMistake.PRISMATIC, [0.0, 0.0, 0.0, *z]))
            ways.append((JacobianMistake.PRISMATIC, [*z, *z]))
        else:
            ways.append((JacobianMistake.POINT_SWAPPED, [*np.cross(reach, z), *z]))
            ways.append((JacobianMistake.PRISMATIC, [*z, 0.0, 0.0, 0.0]))
        right = [*z, 0.0, 0.0, 0.0] if axis.prismatic else [*np.cross(z, reach), *z]
        ways.append((JacobianMistake.REVERSED, [-entry for entry in right]))
        for k in (i + 1, i - 1):
            if 0 <= k <= n:
                u, o = lines[k]
                ways.append((JacobianMistake.NEXT_AXIS, [*np.cross(u, end[:3, 3] - o), *u]))
                ways.append((JacobianMistake.NEXT_AXIS, [*u, 0.0, 0.0, 0.0]))
        if (np.abs(given[:, i] - in_other[:, i]) <= limit[:, i]).all():
            yield JacobianMistake.OTHER_FRAME, i + 1
            continue
        for mistake, column in ways:
            if (np.abs(given[:, i] - turn @ np.array(column)) <= limit[:, i]).all():
                yield mistake, i + 1
                break
