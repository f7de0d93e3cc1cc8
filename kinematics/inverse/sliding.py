"""All solutions of arms with sliding joints, where they can be taken apart.

Three kinds: arms of at most three joints; arms whose last (or first) three joints turn about axes through one
point, so that the other joints, at most three, alone decide where that point is (Pieper's condition; the
Stanford arm); and arms of parallel axes with a slide along them, which commutes with all the rest and is
solved first (SCARA). Arms of turning joints only are EAIK's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.position import DegenerateError, Joint, place_points
from kinematics.transforms import inverse_transform

_SAME_POINT = 1e-9
_PARALLEL = 1e-9
_HAND = np.array(((0.4142, 0.7321, 0.2361), (-0.6458, 0.3166, 0.1231), (0.3589, -0.2426, 0.7958)))
"""Three points of the hand, in units of the size; they fix its pose and lie on no axis that anybody drew."""


@dataclass(frozen=True, eq=False)
class ShortArm:
    """An arm of at most three joints: they bring three points of the hand to their places."""

    joints: Sequence[Joint]
    end: Array
    size: float

    def candidates(self, target: Array) -> Array | None:
        """See `ClosedForm`."""
        points, places = (self.size * _HAND @ T[:3, :3].T + T[:3, 3] for T in (self.end, target))
        try:
            return _rows(place_points(self.joints, points, places, self.size), len(self.joints))
        except DegenerateError:
            return None


@dataclass(frozen=True, eq=False)
class WristArm:
    """Up to three joints of any kind, then three that turn about axes through one point."""

    joints: Sequence[Joint]
    wrist: Sequence[Joint]
    end: Array
    size: float

    def candidates(self, target: Array) -> Array | None:
        """See `ClosedForm`."""
        centre = self.wrist[0].point
        moved = target @ inverse_transform(self.end)
        try:
            arms = place_points(self.joints, centre[None], _applied(moved, centre)[None], self.size)
        except DegenerateError:
            return None
        found: list[list[float]] = []
        for q in arms:
            R = np.eye(3)
            for joint, value in zip(self.joints, q, strict=True):
                R = R @ _rotation(joint, value)
            found.extend([*q, *turns] for turns in _wrist_turns(self.wrist, R.T @ moved[:3, :3]))
        return _rows(found, len(self.joints) + 3)


@dataclass(frozen=True, eq=False)
class ReversedArm:
    """An arm that is solved from the hand: T⁻¹ is the reversed chain at -q."""

    inner: WristArm

    def candidates(self, target: Array) -> Array | None:
        """See `ClosedForm`."""
        found = self.inner.candidates(inverse_transform(target))
        return None if found is None else -found[:, ::-1]


@dataclass(frozen=True, eq=False)
class LiftArm:
    """An arm of parallel axes with one slide along them, which is solved first."""

    lift: int
    joint: Joint
    rest: ShortArm
    end: Array

    def candidates(self, target: Array) -> Array | None:
        """See `ClosedForm`."""
        u = self.joint.axis
        height = float(u @ (target[:3, 3] - self.end[:3, 3]))
        lowered = target.copy()
        lowered[:3, 3] -= height * u
        found = self.rest.candidates(lowered)
        return None if found is None else np.insert(found, self.lift, height, axis=1)


def sliding_form_of(arm: Arm) -> ShortArm | WristArm | ReversedArm | LiftArm | None:
    """The way to take an arm apart, or None if there is none."""
    directions, points, end = arm.screws
    joints = [
        Joint(bool(turns), axis, point)
        for turns, axis, point in zip(arm.revolute, directions, points, strict=True)
    ]
    if len(joints) <= 3:
        return ShortArm(joints, end, arm.size)
    return (
        _lift_arm(joints, end, arm.size)
        or _wrist_arm(joints, end, arm.size)
        or _reversed(joints, end, arm.size)
    )


def _lift_arm(joints: Sequence[Joint], end: Array, size: float) -> LiftArm | None:
    slides = [i for i, joint in enumerate(joints) if not joint.turns]
    for i in slides:
        u = joints[i].axis
        rest = [joint for k, joint in enumerate(joints) if k != i]
        commutes = all(
            _parallel(joint.axis, u) if joint.turns else abs(joint.axis @ u) <= _PARALLEL for joint in rest
        )
        if commutes and len(rest) <= 3:
            return LiftArm(i, joints[i], ShortArm(rest, end, size), end)
    return None


def _wrist_arm(joints: Sequence[Joint], end: Array, size: float) -> WristArm | None:
    arm, wrist = joints[:-3], joints[-3:]
    if len(arm) > 3 or not all(joint.turns for joint in wrist):
        return None
    if _parallel(wrist[0].axis, wrist[1].axis) or _parallel(wrist[1].axis, wrist[2].axis):
        return None
    across = [np.eye(3) - np.outer(joint.axis, joint.axis) for joint in wrist]
    sum_across = np.add.reduce(across)
    moments = np.add.reduce([P @ joint.point for P, joint in zip(across, wrist, strict=True)])
    centre = np.asarray(np.linalg.solve(sum_across, moments), dtype=np.float64)
    if any(
        np.linalg.norm(P @ (centre - j.point)) > _SAME_POINT * size
        for P, j in zip(across, wrist, strict=True)
    ):
        return None
    return WristArm(arm, [Joint(True, joint.axis, centre) for joint in wrist], end, size)


def _reversed(joints: Sequence[Joint], end: Array, size: float) -> ReversedArm | None:
    """T = E_1 ⋯ E_n M, so T⁻¹ = E'_n(-q_n) ⋯ E'_1(-q_1) M⁻¹ with every E' = M⁻¹ E M."""
    inverse = inverse_transform(end)
    turned = [
        Joint(joint.turns, inverse[:3, :3] @ joint.axis, _applied(inverse, joint.point))
        for joint in reversed(joints)
    ]
    inner = _wrist_arm(turned, inverse, size)
    return None if inner is None else ReversedArm(inner)


def _wrist_turns(wrist: Sequence[Joint], R: Array) -> list[list[float]]:
    """The two ways in which three turns about z_4, z_5, z_6 make a rotation R.

    q_5 from z_4·R z_6 = z_4·E_5 z_6, then q_4 from E_4 (E_5 z_6) = R z_6, then q_6 from what is left.
    """
    z4, z5, z6 = (joint.axis for joint in wrist)
    along = (z4 @ z5) * (z5 @ z6)
    cosine, sine = float(z4 @ z6 - along), float(z4 @ np.cross(z5, z6))
    ratio = float(z4 @ R @ z6 - along) / np.hypot(cosine, sine)
    middle, half = np.arctan2(sine, cosine), np.arccos(np.clip(ratio, -1.0, 1.0))
    found = []
    for q5 in (float(middle - half), float(middle + half)):
        R5 = _rotation(wrist[1], q5)
        q4 = _turn(z4, R5 @ z6, R @ z6)
        left = R5.T @ _rotation(wrist[0], q4).T @ R
        across = np.linalg.svd(z6[None])[2][1]
        found.append([q4, q5, _turn(z6, across, left @ across)])
    return found


def _turn(axis: Array, u: Array, v: Array) -> float:
    u, v = u - (u @ axis) * axis, v - (v @ axis) * axis
    if np.linalg.norm(u) < 1e-9 or np.linalg.norm(v) < 1e-9:
        return 0.0
    return float(np.arctan2(axis @ np.cross(u, v), u @ v))


def _rotation(joint: Joint, q: float) -> Array:
    if not joint.turns:
        return np.eye(3)
    x, y, z = joint.axis
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(q) * K + (1.0 - np.cos(q)) * (K @ K))


def _parallel(u: Array, v: Array) -> bool:
    return float(np.linalg.norm(np.cross(u, v))) <= _PARALLEL


def _applied(T: Array, x: Array) -> Array:
    return np.asarray(T[:3, :3] @ x + T[:3, 3])


def _rows(found: Sequence[Sequence[float]], n_joints: int) -> Array:
    return np.array(found, dtype=np.float64).reshape(-1, n_joints)
