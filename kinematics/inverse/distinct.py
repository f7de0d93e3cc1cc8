"""Which solutions are the same."""

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.residuals import errors_at

SAME = 1e-6  # Joint values this near [rad, or parts of the size] are the same.

DOUBLE_ROOT = 1e-3
"""Solutions this near are the same if the configuration between them is a solution too: a double root."""

UNMOVED = 1e-12
"""Size of the error vector with which a continuum is followed, and between two ends of a double root [rad, or
parts of the size]; beside a singularity an arm does not stay so near."""


def differences(q: Array, other: Array, arm: Arm) -> Array:
    """Return the joint differences, turns in [-π, π), slides divided by the size."""
    return shorter_way((q - other) / arm.units, arm.revolute)


def shorter_way(way: Array, revolute: NDArray[np.bool_] | np.bool_) -> Array:
    """Return joint differences, (…, n), turns on the circle: in [-π, π)."""
    turns = np.floor(way * (0.5 / np.pi) + 0.5)
    turns *= 2.0 * np.pi * revolute
    return np.asarray(np.subtract(way, turns, out=turns))


def apart(arm: Arm, joints: Array, others: Array) -> Array:
    """Return the largest joint differences, (m, k), of (m, n) configurations from (k, n) others.

    One joint at a time: on what is m·k·n large this takes a third of the time of `differences`.
    """
    farthest = np.zeros((len(joints), len(others)))
    for q, other, turns in zip((joints / arm.units).T, (others / arm.units).T, arm.revolute, strict=True):
        way = np.subtract.outer(q, other)
        np.maximum(farthest, np.abs(shorter_way(way, turns)), out=farthest)
    return farthest


def distinct(arm: Arm, target: Array, joints: Array) -> Array:
    """Return the distinct configurations, each at its first occurrence."""
    if len(joints) < 2:
        return joints
    distance = np.tril(apart(arm, joints, joints)) + np.triu(np.full((len(joints), len(joints)), np.inf))
    kept = np.ones(len(joints), dtype=bool)
    for i in np.flatnonzero(distance.min(axis=1) <= DOUBLE_ROOT).tolist():
        near = np.flatnonzero(kept & (distance[i] <= DOUBLE_ROOT))
        same = bool((distance[i, near] <= SAME).any())
        kept[i] = not (same or _between(arm, target, joints[i], joints[near]).any())
    return joints[kept]


def _between(arm: Arm, target: Array, q: Array, others: Array) -> NDArray[np.bool_]:
    scale = arm.units
    middle = others + 0.5 * differences(np.broadcast_to(q, others.shape), others, arm) * scale
    e = errors_at(arm, middle, target)
    return np.asarray(np.linalg.norm(e, axis=1) <= UNMOVED)
