"""From the candidates of a closed form to its solutions, as exact as floating point has them."""

import math

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.closed_form import NEARLY
from kinematics.inverse.newton import evened, farthest_off, polish
from kinematics.inverse.residuals import are_solutions, errors_at
from kinematics.inverse.self_motions.families import weighing_alike
from kinematics.inverse.valleys import STRIDE, across_folds, way_to_fold
from kinematics.se3 import Transform

AS_IT_IS = 1e-13
"""A candidate this exact [rad, and parts of the size] is left as it is, if it is within the tolerance:
rounding of six links leaves as much."""

FOLDED, ROUNDED = 1e-6, 5e-16
"""Up to this singular value a solution may be beside a fold by no more than rounding, which leaves this error
[rad, and parts of the size] on it: where a 2R arm is stretched, an elbow of 3e-8 rad is off by no more."""

BESIDE = 32.0
"""At a fold a target may be out of reach by what a turn of one tolerance makes of the arm's size: candidates
that are off by so many tolerances [rad, and parts of the size] are refined by distance and angle alike, and
across the null space of the Jacobian."""


def solutions_of(arm: Arm, candidates: Array, target: Transform, tolerance: float) -> Array:
    """Return the candidates that are solutions, refined; the same solution may be there more than once."""
    return refined(arm, candidates, target, tolerance)[0]


def refined(arm: Arm, candidates: Array, target: Transform, tolerance: float) -> tuple[Array, Array]:
    """Return what `solutions_of` does, and the other candidates, (k, n), each where its error was least."""
    q = candidates[np.isfinite(candidates).all(axis=1)]
    if not len(q):
        return q, q
    vectors = errors_at(arm, q, target)
    errors = np.linalg.norm(vectors, axis=1)
    near = errors < NEARLY
    q, vectors, errors = q[near], vectors[near], errors[near]
    farther = arm.size * np.linalg.norm(vectors[:, :3], axis=1) > tolerance
    rough, start = (errors > AS_IT_IS) | farther, q
    if rough.any():
        q = q.copy()
        q[rough] = polish(arm, target, q[rough])
        vectors = errors_at(arm, q, target)
    reached = are_solutions(vectors, arm, tolerance)
    farthest = max(BESIDE * tolerance, farthest_off(arm, tolerance))
    beside = ~reached & (np.linalg.norm(vectors, axis=1) <= farthest)
    if beside.any():
        q, alike = q.copy(), weighing_alike(arm)
        if alike is not arm:
            q[beside] = polish(alike, target, start[beside])
            reached = are_solutions(errors_at(arm, q, target), arm, tolerance)
        left = beside & ~reached
        q[left] = _onto_folds(alike, target, start[left], tolerance)
        vectors = errors_at(arm, q, target)
        reached = are_solutions(vectors, arm, tolerance)
        if not reached[beside].all():
            q[beside] = evened(arm, target, q[beside], tolerance)
            reached = are_solutions(errors_at(arm, q, target), arm, tolerance)
    return np.asarray(q[reached]), np.asarray(q[~reached])


def _onto_folds(arm: Arm, target: Array, candidates: Array, tolerance: float) -> Array:
    """Return the least errors beside candidates: across folds, or on the fold itself where that is less.

    Of a target out of reach the error is least on the fold. How far from it a candidate may be and reach what
    it can within the tolerance is a matter of the fold's curvature, which steps across it do not know.
    """
    least = math.sqrt(tolerance)
    q = across_folds(arm, target, candidates, least)
    U, _, Vt = np.linalg.svd(arm.jacobians(arm.frames(q)) * arm.units)
    last = arm.generic_rank - 1
    way = way_to_fold(arm, q, U[:, :, last], Vt[:, last])
    on = q + np.where(np.abs(way) < STRIDE, way, 0.0)[:, None] * Vt[:, last] * arm.units
    both = np.stack((q, across_folds(arm, target, on, least)))
    errors = np.array([np.linalg.norm(errors_at(arm, each, target), axis=1) for each in both])
    return np.asarray(np.where((errors[1] < errors[0])[:, None], both[1], both[0]))


def settled_on_folds(arm: Arm, target: Transform, solutions: Array, jacobians: Array) -> Array:
    """Return the solutions, those that rounding has moved off a fold put back on it.

    An elbow is then fully stretched, not nearly so.

    At a fold two solutions are one; along the way v that the Jacobian does not see the error grows with the
    square.
    """
    if arm.redundancy:
        return solutions
    U, values, Vt = np.linalg.svd(jacobians)
    last = arm.generic_rank - 1
    beside = np.flatnonzero((values[:, last] > 0.0) & (values[:, last] <= FOLDED))
    if not len(beside):
        return solutions
    u, v = U[beside, :, last], Vt[beside, last]
    q = solutions[beside]
    for _ in range(2):
        q = q + way_to_fold(arm, q, u, v)[:, None] * v * arm.units
    errors = np.linalg.norm(errors_at(arm, q, target), axis=1)
    before = np.linalg.norm(errors_at(arm, solutions[beside], target), axis=1)
    settled = errors <= np.maximum(before, ROUNDED)
    found = solutions.copy()
    found[beside[settled]] = q[settled]
    return found
