"""Which solutions stand alone: can neither be moved nor joined to another while the target stays reached.

All solutions are tried in the same array operations: a step along the null space of the Jacobian, and the
middle between two that are near each other, are corrected back to the target.
"""

import math
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.distinct import SAME, apart, differences
from kinematics.inverse.residuals import are_solutions, errors_of
from kinematics.inverse.self_motions.corrections import corrected
from kinematics.inverse.self_motions.families import LOST, Follower, weighing_alike

LONG = 0.02  # A solution that can be moved by this [rad, or parts of the size] belongs to a family.

ACROSS_A_FOLD = 8.0
"""Two solutions beside a fold with curvature κ are joined within a tolerance ε up to 2√(2ε/κ) apart; κ is
1/8 or more of arms whose links are not thousands of times their offsets. What is no longer than 8√ε is one
solution, not a family."""

MERGING = 6.0
"""Solutions whose least singular value is above 6√ε are neither joined by a fold of curvature κ ≤ 18,
where it is at most √(2εκ), nor long, where it is at most ε/LONG."""


def fold_length(tolerance: float) -> float:
    """Return the length [rad, or parts of the size] up to which a family counts as one solution."""
    return max(LONG, ACROSS_A_FOLD * math.sqrt(tolerance))


def lost_value(tolerance: float) -> float:
    """Return the singular value of the Jacobian below which its smallest may be a family's."""
    return max(tolerance / LONG * 2.0, LOST, math.sqrt(tolerance))


def told_apart(arm: Arm, target: Array, joints: Array, tolerance: float) -> tuple[list[int], list[int]]:
    """Return which solutions stand alone, each once, and which may be of families, most exact first."""
    if not len(joints):
        return [], []
    frames = arm.frames(joints)
    errors = np.linalg.norm(errors_of(arm, frames[-1], target), axis=1)
    J = arm.jacobians(frames) * arm.units
    least = np.linalg.svd(J, compute_uv=False)[:, arm.generic_rank - 1]
    delicate = (least <= MERGING * math.sqrt(tolerance)) | (arm.redundancy > 0)
    between = apart(arm, joints, joints)
    np.fill_diagonal(between, np.inf)
    if not arm.redundancy and float(least.min()) > lost_value(tolerance):
        delicate &= between.min(axis=1) <= fold_length(tolerance)
    order = np.argsort(errors, kind="stable").tolist()
    if not arm.redundancy and delicate.any():
        some = [i for i in order if delicate[i]]
        if not can_move(arm, target, joints[some], tolerance).any():
            joined = joined_before(Follower(arm, target, tolerance), joints, some, tolerance)
            order = [i for i in order if i not in joined]
            delicate[:] = False
    alone: list[int] = []
    for i in order:
        if not delicate[i] and all(between[i, k] > SAME for k in alone):
            alone.append(i)
    return alone, [i for i in order if delicate[i]]


def can_move(arm: Arm, target: Array, joints: Array, tolerance: float) -> NDArray[np.bool_]:
    """Return whether solutions can be moved as far as those of families, or in more than one direction.

    The arm has no redundant joints.
    """
    alike = weighing_alike(arm)
    x = joints / alike.units
    J = alike.jacobians(alike.frames(joints)) * alike.units
    _, values, directions = np.linalg.svd(J)
    nullity = (values <= lost_value(tolerance)).sum(axis=1)
    found = nullity > 1
    one = np.flatnonzero(nullity == 1)
    way = fold_length(tolerance) * directions[one, -1]
    ways, both = np.concatenate((way, -way)), np.concatenate((one, one))
    found[both[_reach(alike, target, x[both] + ways, ways, tolerance)]] = True
    return np.asarray(found)


def joined_before(follower: Follower, joints: Array, some: list[int], tolerance: float) -> set[int]:
    """Return those of `some` solutions, none of which can be moved, that are joined to one before."""
    units = follower.arm.units
    pairs = np.array([*combinations(some, 2)], dtype=np.intp).reshape(-1, 2)
    ways = differences(joints[pairs[:, 1]], joints[pairs[:, 0]], follower.arm)
    near = np.abs(ways).max(axis=1) <= fold_length(tolerance)
    pairs, ways = pairs[near], ways[near]
    x = joints[pairs[:, 0]] / units
    found: set[int] = set()
    for i, k in pairs[follower.joined_each(x, x + ways)].tolist():
        if i not in found:
            found.add(k)
    return found


def _reach(arm: Arm, target: Array, x: Array, way: Array, tolerance: float) -> NDArray[np.bool_]:
    """(k,) whether what is a way off solutions reaches the target, corrected by at most `fold_length`."""
    if not len(x):
        return np.empty(0, dtype=bool)
    unit = way / np.maximum(np.linalg.norm(way, axis=1), 1e-300)[:, None]
    there, e, _ = corrected(arm, target, x, unit[:, None])
    near = np.linalg.norm(there - x, axis=1) <= fold_length(tolerance)
    return np.asarray(near & are_solutions(e, arm, tolerance))
