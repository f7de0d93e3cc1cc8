"""Which solutions are the same, and which belong to a continuum."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array, volumes
from kinematics.inverse.residuals import error_vectors

SAME = 1e-6
"""Joint values this near [rad, or parts of the size] are the same."""

DOUBLE_ROOT = 1e-3
"""Solutions this near are the same if the configuration between them is a solution too: a double root."""

SINGULAR_VALUE = 1e-7
"""Least singular value of the Jacobian below which a solution is examined for a continuum."""

UNMOVED = 1e-12
"""Size of the error vector with which a continuum is followed, and between two ends of a double root [rad, or
parts of the size]; beside a singularity an arm does not stay so near."""

SMALL_VOLUME = 1e-4
"""|det J| (of arms with fewer than six joints det JᵀJ) above which no singular value is that small."""

_STEP = 0.02


def differences(q: Array, other: Array, arm: Arm) -> Array:
    """Joint differences, turns in [-π, π), slides divided by the size."""
    difference = q - other
    turned = (difference + np.pi) % (2.0 * np.pi) - np.pi
    return np.where(arm.revolute, turned, difference / arm.size)


def distinct(arm: Arm, target: Array, joints: Array) -> Array:
    """The configurations without repetitions; of several the first is kept.

    Args:
        arm: the arm.
        target: (4, 4).
        joints: (m, n) solutions.
    """
    if len(joints) < 2:
        return joints
    apart = differences(joints[:, None], joints[None], arm)
    distance = np.abs(apart).max(axis=2)
    kept: list[int] = []
    for i in range(len(joints)):
        near = [k for k in kept if distance[i, k] <= DOUBLE_ROOT]
        if any(distance[i, k] <= SAME for k in near):
            continue
        if near and _between(arm, target, joints[i], joints[near]).any():
            continue
        kept.append(i)
    return joints[kept]


def _between(arm: Arm, target: Array, q: Array, others: Array) -> NDArray[np.bool_]:
    scale = arm.units
    middle = others + 0.5 * differences(np.broadcast_to(q, others.shape), others, arm) * scale
    e = error_vectors(arm.frames(middle)[-1], target, arm.size)
    return np.asarray(np.linalg.norm(e, axis=1) <= UNMOVED)


def on_continuum(arm: Arm, target: Array, joints: Array) -> tuple[NDArray[np.bool_], Array]:
    """Which solutions can be moved while the target stays reached.

    Where the Jacobian loses rank, the solution is moved by 0.02 along the direction that it does not see and
    corrected by Newton steps that keep that displacement. If the target is reached again, there is a
    continuum (a wrist in line); if not, the solution is a double root (a stretched elbow).

    Args:
        arm: an arm without joints to spare, n ≤ 6.
        target: (4, 4).
        joints: (m, n) solutions.

    Returns:
        (m,), and (m, n) the unit directions along which those can be moved; slides divided by the size.
    """
    scale = arm.units
    J = arm.jacobians(arm.frames(joints)) * scale
    directions = np.zeros(joints.shape)
    found = np.zeros(len(joints), dtype=bool)
    suspects = np.flatnonzero(volumes(J) < SMALL_VOLUME)
    if not len(suspects):
        return found, directions
    _, values, rows = np.linalg.svd(J[suspects])
    n = values.shape[1]
    tried = [
        _combinations(basis[:n][small]) for basis, small in zip(rows, values < SINGULAR_VALUE, strict=True)
    ]
    owner = np.repeat(suspects, [len(ways) for ways in tried])
    if len(owner):
        ways = np.concatenate(tried)
        moves = _moves(arm, target, joints[owner], ways, scale)
        for i, direction in zip(owner[moves][::-1].tolist(), ways[moves][::-1], strict=True):
            found[i], directions[i] = True, direction  # the first of them stays
    return found, directions


def _combinations(blind: Array) -> Array:
    """Directions that the Jacobian does not see: each of a basis, and the sums and differences of two."""
    pairs = [(one + s * other) / np.sqrt(2.0) for one, other in combinations(blind, 2) for s in (1, -1)]
    return np.array([*blind, *pairs]).reshape(-1, blind.shape[1])


def _moves(arm: Arm, target: Array, joints: Array, directions: Array, scale: Array) -> NDArray[np.bool_]:
    q = joints + _STEP * directions * scale
    for _ in range(4):
        frames = arm.frames(q)
        e = error_vectors(frames[-1], target, arm.size)
        moved = (((q - joints) / scale) * directions).sum(axis=1)
        J = np.concatenate((arm.jacobians(frames) * scale, directions[:, None]), axis=1)
        residual = np.concatenate((e, (_STEP - moved)[:, None]), axis=1)
        q = q + (np.linalg.pinv(J, rcond=1e-12) @ residual[:, :, None])[:, :, 0] * scale
    e = error_vectors(arm.frames(q)[-1], target, arm.size)
    return np.asarray(np.linalg.norm(e, axis=1) <= UNMOVED)


def one_per_continuum(
    arm: Arm, joints: Array, continuum: NDArray[np.bool_], directions: Array
) -> NDArray[np.bool_]:
    """Which solutions to keep if those that differ only along their common continuum count once."""
    keep = np.ones(len(joints), dtype=bool)
    for i in np.flatnonzero(continuum):
        for k in np.flatnonzero(continuum[:i] & keep[:i]):
            apart = differences(joints[i], joints[k], arm)
            along = apart @ directions[k]
            if np.abs(apart - along * directions[k]).max() <= 1e-4:
                keep[i] = False
                break
    return keep
