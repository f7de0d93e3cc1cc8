"""How far a pose is from its target: a distance and an angle."""

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, ArmReach, Array
from kinematics.se3 import cross_arrays

_TINY = 1e-8  # Up to here asin x = x to the last bit: the next term, x³/6, is less than half of it.

_NO_AXIS = 1e-6  # Below this sine of its angle the antisymmetric part of a half turn has lost the axis.

_PARTS = np.array(([0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [1.0, 0.0]) * 3)
"""Sums the squares of the upper three rows of a 4×4 matrix into those of its position and of its rotation."""


def pose_errors(poses: Array, targets: Array) -> tuple[Array, Array]:
    """Return the distance [m] of the origins and angle [rad] between the orientations.

    The angle is 2 asin(‖R - R*‖_F / √8), exact to rounding near zero.

    Args:
        poses: (m, 4, 4).
        targets: (4, 4) or (m, 4, 4).

    Returns:
        (m,) and (m,).
    """
    difference = poses[..., :3, :] - targets[..., :3, :]
    sums = np.square(difference, out=difference).reshape(len(poses), 12) @ _PARTS
    position, chord = np.sqrt(sums).T
    half = chord / np.sqrt(8.0)
    if half.max(initial=0.0) > _TINY or np.isnan(half).any():
        half = np.arcsin(np.minimum(half, 1.0))
    return position, 2.0 * half


def are_solutions(errors: Array, arm: Arm, tolerance: float) -> NDArray[np.bool_]:
    """Return whether error vectors are those of solutions: distance [m] and angle [rad] within the tolerance.

    Args:
        errors: (m, 6) from `error_vectors`.
        arm: the arm; of large ones the tolerance for the distance is what rounding leaves.
        tolerance: [m] and [rad].
    """
    distance = arm.size * np.linalg.norm(errors[:, :3], axis=1)
    angle = np.linalg.norm(errors[:, 3:], axis=1)
    return np.asarray((distance <= max(tolerance, arm.rounding)) & (angle <= tolerance))


def errors_of(arm: Arm, poses: Array, target: Array) -> Array:
    """Return the error vectors of an arm's poses, without what its `reach` leaves free.

    Of an axis the rotation vector is the shortest one that turns the tool's z axis to the target's.

    Returns:
        (m, 6).
    """
    if arm.reach is ArmReach.POSE:
        return error_vectors(poses, target, arm.size)
    errors = np.zeros((len(poses), 6))
    errors[:, :3] = (target[..., :3, 3] - poses[:, :3, 3]) / arm.size
    if arm.reach is ArmReach.AXIS:
        z, wanted = poses[:, :3, 2], np.broadcast_to(target[..., :3, 2], (len(poses), 3))
        across = cross_arrays(z, wanted)
        sine = np.linalg.norm(across, axis=1)
        angle = np.arctan2(sine, (z * wanted).sum(axis=1))
        aside = cross_arrays(z, np.where(np.abs(z[:, :1]) < 0.9, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
        lost = (sine < 1e-12) & (angle > 1.0)  # opposite axes: any turn by π about what is across
        across = np.where(lost[:, None], aside, across)
        length = np.where(lost, np.linalg.norm(aside, axis=1), sine)
        errors[:, 3:] = across * (angle / np.maximum(length, 1e-300))[:, None]
    return errors


def errors_at(arm: Arm, joints: Array, target: Array) -> Array:
    """Return the error vectors of configurations, (m, 6), as `errors_of` has them of their poses."""
    return errors_of(arm, arm.frames(joints)[-1], target)


def errors_and_jacobians(arm: Arm, x: Array, target: Array) -> tuple[Array, Array]:
    """Return the error vectors, (m, 6), and Jacobians, (m, 6, n), at configurations."""
    frames = arm.frames(x * arm.units)
    return errors_of(arm, frames[-1], target), arm.jacobians(frames) * arm.units


def error_vectors(poses: Array, target: Array, size: float) -> Array:
    """Return the way to the target: that of the origin, divided by the size, over the rotation vector.

    The rotation vector ω is the logarithm of R* Rᵀ, in the base.

    Args:
        poses: (m, 4, 4).
        target: (4, 4), or (m, 4, 4) one each.
        size: what counts as one unit of length [m].

    Returns:
        (m, 6).
    """
    errors = np.empty((len(poses), 6))
    errors[:, :3] = (target[..., :3, 3] - poses[:, :3, 3]) / size
    Q = target[..., :3, :3] @ poses[:, :3, :3].transpose(0, 2, 1)
    w = errors[:, 3:]
    w[:, 0] = Q[:, 2, 1] - Q[:, 1, 2]
    w[:, 1] = Q[:, 0, 2] - Q[:, 2, 0]
    w[:, 2] = Q[:, 1, 0] - Q[:, 0, 1]
    sine = 0.5 * np.sqrt((w * w).sum(axis=1))
    cosine = 0.5 * (Q[:, 0, 0] + Q[:, 1, 1] + Q[:, 2, 2] - 1.0)
    angle = np.arctan2(sine, cosine)
    turned = w.copy() if (cosine < 0.0).any() else w
    w *= (0.5 * angle / np.maximum(sine, 1e-300))[:, None]
    if turned is not w:
        half = (sine < _NO_AXIS) & (cosine < 0.0)
        w[half] = angle[half, None] * _axes_of_half_turns(Q[half], turned[half])
    return errors


def _axes_of_half_turns(Q: Array, w: Array) -> Array:
    """Unit axes of all but half turns, from Q + I ≈ 2 u uᵀ; w = 2 sin(angle) u says which way they point."""
    S = 0.5 * (Q + Q.transpose(0, 2, 1)) + np.eye(3)
    u = np.take_along_axis(S, np.einsum("mii->mi", S).argmax(axis=1)[:, None, None], axis=2)[:, :, 0]
    u /= np.linalg.norm(u, axis=1)[:, None]
    return np.where((u * w).sum(axis=1) < 0.0, -1.0, 1.0)[:, None] * u
