"""From the candidates of a closed form to its solutions, as exact as floating point has them."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.closed_form import NEARLY
from kinematics.inverse.residuals import are_solutions, errors_of
from kinematics.inverse.search import polish
from kinematics.inverse.self_motions.families import weighing_alike
from kinematics.inverse.valleys import across_folds
from kinematics.se3 import Transform

AS_IT_IS = 1e-13
"""A candidate this exact [rad, and parts of the size] is left as it is: rounding of six links leaves as
much."""

BESIDE = 32.0
"""At a fold a target may be out of reach by what a turn of one tolerance makes of the arm's size: candidates
that are off by so many tolerances [rad, and parts of the size] are refined by distance and angle alike, and
across what the Jacobian does not see."""

HEAVIEST = 64.0
"""By so much more or less than usual a distance is weighed against an angle: at the ends one alone counts."""

WEIGHTS = 24
"""Weights that are tried: bisecting 64² so often leaves a millionth, finer than any tolerance is known."""


def solutions_of(arm: Arm, candidates: Array, target: Transform, tolerance: float) -> Array:
    """Return the candidates that are solutions, refined; the same solution may be there more than once.

    Args:
        arm: the arm.
        candidates: (m, n) configurations near the solutions.
        target: (4, 4).
        tolerance: distance [m] and angle [rad] within which the target is reached.
    """
    q = candidates[np.isfinite(candidates).all(axis=1)]
    if not len(q):
        return q
    vectors = errors_of(arm, arm.frames(q)[-1], target)
    errors = np.linalg.norm(vectors, axis=1)
    q, vectors, errors = (
        q[errors < NEARLY],
        vectors[errors < NEARLY],
        errors[errors < NEARLY],
    )
    rough, start = errors > AS_IT_IS, q
    if rough.any():
        q = q.copy()
        q[rough] = polish(arm, target, q[rough])
        vectors = errors_of(arm, arm.frames(q)[-1], target)
    reached = are_solutions(vectors, arm, tolerance)
    beside = ~reached & (np.linalg.norm(vectors, axis=1) <= BESIDE * tolerance)
    if beside.any():
        q, alike = q.copy(), weighing_alike(arm)
        if alike is not arm:
            q[beside] = polish(alike, target, start[beside])
            reached = are_solutions(errors_of(arm, arm.frames(q)[-1], target), arm, tolerance)
        left = beside & ~reached
        q[left] = across_folds(alike, target, start[left], math.sqrt(tolerance))
        vectors = errors_of(arm, arm.frames(q)[-1], target)
        reached = are_solutions(vectors, arm, tolerance)
        uneven = beside & ~reached & (np.hypot(*_shares(vectors, arm, tolerance)) <= math.sqrt(2.0))
        for i in np.flatnonzero(uneven):
            q[i] = _evened(arm, target, q[i], tolerance)
        if uneven.any():
            reached = are_solutions(errors_of(arm, arm.frames(q)[-1], target), arm, tolerance)
    return np.asarray(q[reached])


def _evened(arm: Arm, target: Transform, joints: Array, tolerance: float) -> Array:
    """Return the (n,) configuration near one with distance and angle within the tolerance, if there is any.

    An arm of fewer than six joints misses a rounded pose. The sum of squares may be least where the one is
    within its tolerance and the other is not; what lies between is found by weighing them otherwise.
    """
    low, high = arm.size / HEAVIEST, arm.size * HEAVIEST
    found = joints
    for _ in range(WEIGHTS):
        weighed = replace(arm, size=math.sqrt(low * high))
        found = polish(weighed, target, joints[None])[0]
        distance, angle = _shares(errors_of(arm, arm.frames(found[None])[-1], target), arm, tolerance)
        if max(distance[0], angle[0]) <= 1.0:
            break
        if distance[0] > angle[0]:
            high = weighed.size
        else:
            low = weighed.size
    return found


def _shares(vectors: Array, arm: Arm, tolerance: float) -> tuple[Array, Array]:
    """Distances and angles of error vectors, as shares of what may be, (m,) each."""
    distance = arm.size * np.linalg.norm(vectors[:, :3], axis=1) / max(tolerance, arm.rounding)
    return distance, np.linalg.norm(vectors[:, 3:], axis=1) / tolerance
