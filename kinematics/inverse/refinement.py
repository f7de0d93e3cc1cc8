"""From the candidates of a closed form to its solutions, as exact as floating point has them."""

from __future__ import annotations

import math

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.closed_form import NEARLY
from kinematics.inverse.newton import evened, farthest_off, polish
from kinematics.inverse.residuals import are_solutions, errors_of
from kinematics.inverse.self_motions.families import weighing_alike
from kinematics.inverse.valleys import across_folds
from kinematics.se3 import Transform

AS_IT_IS = 1e-13
"""A candidate this exact [rad, and parts of the size] is left as it is: rounding of six links leaves as
much."""

BESIDE = 32.0
"""At a fold a target may be out of reach by what a turn of one tolerance makes of the arm's size: candidates
that are off by so many tolerances [rad, and parts of the size] are refined by distance and angle alike, and
across the null space of the Jacobian."""


def solutions_of(arm: Arm, candidates: Array, target: Transform, tolerance: float) -> Array:
    """Return the candidates that are solutions, refined; the same solution may be there more than once.

    Args:
        arm: the arm.
        candidates: (m, n) configurations near the solutions.
        target: (4, 4).
        tolerance: distance [m] and angle [rad] within which the target is reached.
    """
    return refined(arm, candidates, target, tolerance)[0]


def refined(arm: Arm, candidates: Array, target: Transform, tolerance: float) -> tuple[Array, Array]:
    """Return what `solutions_of` does, and the others, (k, n), each at the least error on its way."""
    q = candidates[np.isfinite(candidates).all(axis=1)]
    if not len(q):
        return q, q
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
    farthest = max(BESIDE * tolerance, farthest_off(arm, tolerance))
    beside = ~reached & (np.linalg.norm(vectors, axis=1) <= farthest)
    if beside.any():
        q, alike = q.copy(), weighing_alike(arm)
        if alike is not arm:
            q[beside] = polish(alike, target, start[beside])
            reached = are_solutions(errors_of(arm, arm.frames(q)[-1], target), arm, tolerance)
        left = beside & ~reached
        q[left] = across_folds(alike, target, start[left], math.sqrt(tolerance))
        vectors = errors_of(arm, arm.frames(q)[-1], target)
        reached = are_solutions(vectors, arm, tolerance)
        if not reached[beside].all():
            q[beside] = evened(arm, target, q[beside], tolerance)
            reached = are_solutions(errors_of(arm, arm.frames(q)[-1], target), arm, tolerance)
    return np.asarray(q[reached]), np.asarray(q[~reached])
