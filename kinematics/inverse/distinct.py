"""Which solutions are the same."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.residuals import errors_at

SAME = 1e-6
"""Joint values this near [rad, or parts of the size] are the same."""

DOUBLE_ROOT = 1e-3
"""Solutions this near are the same if the configuration between them is a solution too: a double root."""

UNMOVED = 1e-12
"""Size of the error vector with which a continuum is followed, and between two ends of a double root [rad, or
parts of the size]; beside a singularity an arm does not stay so near."""


def differences(q: Array, other: Array, arm: Arm) -> Array:
    """Return the joint differences, turns in [-π, π), slides divided by the size."""
    return shorter_way((q - other) / arm.units, arm.revolute)


def shorter_way(way: Array, revolute: NDArray[np.bool_]) -> Array:
    """Return joint differences, (…, n), turns on the circle: in [-π, π)."""
    return np.where(revolute, (way + np.pi) % (2.0 * np.pi) - np.pi, way)


def distinct(arm: Arm, target: Array, joints: Array) -> Array:
    """Return the distinct configurations, each at its first occurrence."""
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
    e = errors_at(arm, middle, target)
    return np.asarray(np.linalg.norm(e, axis=1) <= UNMOVED)
