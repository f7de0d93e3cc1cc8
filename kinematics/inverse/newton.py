"""Newton steps to the nearest pose, and beside a pose that was rounded to one within the tolerance."""

import math
from dataclasses import replace

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.distinct import SAME, differences
from kinematics.inverse.residuals import are_solutions, errors_at, errors_of

NEWTON_STEPS = 20  # Newton steps at most: convergence is quadratic, and the first few may lead round a bend.
IDLE_STEPS = 4
"""Newton steps in a row that halve neither the least error nor the last one before it is as small as it will
get."""

SIX_LINKS = 1e-14
"""Size of the error vector that rounding of six links leaves: who has come as near looks no farther."""

EXACT = 1e-16  # Size of the error vector below which another Newton step would only move rounding.

LEAST_DAMPING = 1e-28  # Square of the singular values that are rounding: some ten roundings of a Jacobian.

LONGEST_STEP = 0.3  # Longest Newton step [rad, or parts of the size]: from candidates it is a correction.

HEAVIEST = 64.0
"""By so much more or less than usual a distance is weighed against an angle: at the ends one alone counts."""

WEIGHTS = 24
"""Weights that are tried: bisecting 64² so often leaves a millionth, finer than any tolerance is known."""

BEYOND = 1.05
"""Where the weighed sum of squares is least and its root exceeds that of two tolerances by this factor, no
other weight brings distance and angle within them. It leaves room for a least that was not quite reached."""


def polish(arm: Arm, targets: Array, joints: Array) -> Array:
    """Return the best configurations on the way of Newton steps from those that are nearly right.

    Steps are damped by the error: δ = (JᵀJ + |e|²)⁻¹ Jᵀ e, of least norm where solutions are not isolated,
    and quadratically convergent to them as well (N. Yamashita, M. Fukushima, 2001). Beside a singularity
    the way to the solution is long and bent: the first step along it loses what the next one brings back.
    So a step is not refused for being worse.
    """
    best = x = joints / arm.units
    least = last = np.full(len(x), np.inf)
    idle, alive = np.zeros(len(x), dtype=int), np.arange(len(x))
    found = best.copy()
    for _ in range(NEWTON_STEPS):
        frames = arm.frames(x * arm.units)
        e = errors_of(arm, frames[-1], targets)
        cost = (e * e).sum(axis=1)
        better = cost < least
        returning = (least > SIX_LINKS**2) & (cost < 0.25 * last)
        last, idle = cost, np.where((cost < 0.25 * least) | returning, 0, idle + 1)
        best, least = np.where(better[:, None], x, best), np.where(better, cost, least)
        found[alive] = best
        going = (idle < IDLE_STEPS) & (cost > EXACT**2)
        if not going.all():
            x, e, best, least, last = x[going], e[going], best[going], least[going], last[going]
            frames, idle, alive, cost = frames[:, going], idle[going], alive[going], cost[going]
            targets = targets[going] if targets.ndim > 2 else targets
        if not len(alive):
            break
        J = arm.jacobians(frames) * arm.units
        U, values, Vt = np.linalg.svd(J, full_matrices=False)
        filtered = values / (values * values + np.maximum(cost, LEAST_DAMPING)[:, None])
        step = ((filtered * (e[:, None] @ U)[:, 0])[:, None] @ Vt)[:, 0]
        length = np.linalg.norm(step, axis=1)
        x = x + step * np.minimum(1.0, LONGEST_STEP / np.maximum(length, 1e-300))[:, None]
    return np.asarray(found * arm.units)


def farthest_off(arm: Arm, tolerance: float) -> float:
    """Return the size of an error vector whose distance and angle both equal a tolerance [m and rad]."""
    return math.hypot(tolerance, max(tolerance, arm.rounding) / arm.size)


def evened(arm: Arm, target: Array, joints: Array, tolerance: float) -> Array:
    """Return the configurations, (m, n), those that miss the target in only one of distance and angle moved.

    They are moved to where both are within the tolerance.

    An arm of fewer than six joints misses a rounded pose, and many descents end where it does: of the same
    configurations only the first is moved. The sum of squares may be least where the one is within its
    tolerance and the other is not; what lies between is found by weighing them otherwise.

    The sum of squares is least at `joints`, weighed by the arm's size or both alike.
    """
    vectors = errors_at(arm, joints, target)
    reached = are_solutions(vectors, arm, tolerance)
    off = np.linalg.norm(vectors, axis=1) <= farthest_off(arm, tolerance)
    uneven = ~reached & (off | (np.hypot(*_shares(vectors, arm, tolerance)) <= math.sqrt(2.0)))
    q = joints.copy()
    moved: list[int] = []
    for i in np.flatnonzero(uneven).tolist():
        apart = np.abs(differences(joints[moved], joints[i], arm)).max(axis=1)
        same = np.flatnonzero(apart <= SAME)
        q[i] = q[moved[same[0]]] if len(same) else _evened(arm, target, q[i], tolerance)
        if not len(same):
            moved.append(i)
    return q


def _evened(arm: Arm, target: Array, joints: Array, tolerance: float) -> Array:
    """Return the (n,) configuration near one with both within the tolerance, if there is any."""
    low, high = arm.size / HEAVIEST, arm.size * HEAVIEST
    found = joints
    for _ in range(WEIGHTS):
        weighed = replace(arm, size=math.sqrt(low * high))
        found = polish(weighed, target, joints[None])[0]
        vectors = errors_at(weighed, found[None], target)
        distance, angle = _shares(vectors, weighed, tolerance)
        if max(distance[0], angle[0]) <= 1.0:
            break
        if np.linalg.norm(vectors) > BEYOND * farthest_off(weighed, tolerance):
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
