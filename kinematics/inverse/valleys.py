"""Folds that a target only just reaches: the least errors along what the Jacobian hardly sees.

Source: J. Nocedal, S. J. Wright, Numerical optimization (2006) §10.3, the full Newton method for least
squares: beside a fold what the Gauss–Newton method leaves out is what counts.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.residuals import are_solutions, errors_and_jacobians

STEPS = 30
"""Newton steps along a valley: where the error grows with the square of the way, each leaves two thirds."""

STEEP = 1e-2  # Singular values above this are those of directions across a valley.

ACROSS = 4  # Gauss–Newton steps across a fold; they converge quadratically from the root of a tolerance.

A_LITTLE = 1e-5  # Step [rad, or parts of the size] of difference quotients of the Jacobian.

BEND, LEAST_BEND = 1e-4, 1e-2
"""Step [rad, or parts of the size] over which a fold bends by more than this, or is none."""

FLATTEST = 1e-14
"""Part of the greatest curvature of the squared error up to which a direction is level: rounding."""

LEVEL = 1e-6  # Part of the greatest curvature up to which difference quotients do not tell one from none.

LONGEST = 0.3  # Longest step [rad, or parts of the size].

NARROW = 1e-4  # A direction with a singular value up to this is walked along: the Jacobian hardly sees it.

STRIDE = 0.1  # Length of a step of a walk [rad, or parts of the size].

STRIDES = 64  # Steps to either side: a full turn.

LEFT = 1e-3  # An error [rad, and parts of the size] with which a walk has left its valley.


def along_valleys(arm: Arm, target: Array, joints: Array) -> Array:
    """Return the least errors near configurations, by Newton's method with second derivatives.

    Where a fold is a single point that its target only just reaches, the error grows with the square of the
    way in two directions, in one of them thousands of times less: steps by the Jacobian alone go to and fro.
    """
    x = across_folds(arm, target, joints, STEEP) / arm.units
    e, J = errors_and_jacobians(arm, x, target)
    sides = A_LITTLE * np.eye(x.shape[1])
    for _ in range(STEPS):
        after, before = (
            [errors_and_jacobians(arm, x + sign * side, target)[1] for side in sides] for sign in (1, -1)
        )
        changes = [one - other for one, other in zip(after, before, strict=True)]
        bends = np.stack([np.einsum("mij,mi->mj", dJ, e) for dJ in changes], axis=1) / (2.0 * A_LITTLE)
        H = J.transpose(0, 2, 1) @ J - 0.5 * (bends + bends.transpose(0, 2, 1))
        values, V = np.linalg.eigh(H)
        along = np.einsum("mik,mij,mj->mk", V, J.transpose(0, 2, 1), e)
        values = np.abs(values)
        counts = values > FLATTEST * values.max(axis=1, keepdims=True)
        step = np.einsum("mik,mk->mi", V, np.where(counts, along / np.where(counts, values, 1.0), 0.0))
        length = np.linalg.norm(step, axis=1)
        tried = x + step * np.minimum(1.0, LONGEST / np.maximum(length, 1e-300))[:, None]
        tried = across_folds(arm, target, tried * arm.units, STEEP) / arm.units
        new_e, new_J = errors_and_jacobians(arm, tried, target)
        better = (new_e * new_e).sum(axis=1) < (e * e).sum(axis=1)
        if not better.any():
            break
        x, e = np.where(better[:, None], tried, x), np.where(better[:, None], new_e, e)
        J = np.where(better[:, None, None], new_J, J)
    return np.asarray(x * arm.units)


def across_folds(arm: Arm, target: Array, q: Array, least: float) -> Array:
    """Return the nearest poses beside configurations at folds, reached by steps in the directions that count.

    What is out of reach there is so for every configuration near; a step that is to make up for it, as
    `polish` takes one, leads away along the fold.

    Singular values up to `least` do not count.
    """
    x = q / arm.units
    for _ in range(ACROSS):
        e, J = errors_and_jacobians(arm, x, target)
        U, values, Vt = np.linalg.svd(J, full_matrices=False)
        inverse = np.where(values > least, 1.0 / np.maximum(values, least), 0.0)
        x = x + np.einsum("mkn,mk,mik,mi->mn", Vt, inverse, U, e)
    return np.asarray(x * arm.units)


def way_to_fold(arm: Arm, joints: Array, u: Array, v: Array) -> Array:
    """Return how far along v, (m, n), the nearest fold is, (m,) [rad, or parts of the size].

    There the least singular value of the Jacobian vanishes, which is u·J v, and nearly linear on the way; 0
    where it does not change.
    """

    def lost(q: Array) -> Array:
        J = arm.jacobians(arm.frames(q)) * arm.units
        return np.asarray(np.einsum("mi,mij,mj->m", u, J, v))

    value = lost(joints)
    slope = (lost(joints + BEND * v * arm.units) - value) / BEND
    return np.where(np.abs(slope) > LEAST_BEND, -value / np.where(slope == 0.0, 1.0, slope), 0.0)


def least_error(arm: Arm, target: Array, joints: Array, low: Array, high: Array) -> Array:
    """Return the (n,) configuration of least error near one, within bounds, to rounding.

    Descents end where the error no longer changes, and that is √rounding away from where it is least.
    """
    x, low, high = joints / arm.units, low / arm.units, high / arm.units
    g, cost = _gradient(arm, target, x)
    for _ in range(STEPS):
        free = ~(((x <= low) & (g > 0.0)) | ((x >= high) & (g < 0.0)))
        sides = A_LITTLE * np.eye(len(x))[free]
        rows = [_gradient(arm, target, x + side)[0] - _gradient(arm, target, x - side)[0] for side in sides]
        H = np.array(rows).reshape(-1, len(x))[:, free] / (2.0 * A_LITTLE)
        values, V = np.linalg.eigh(0.5 * (H + H.T))
        steep = values > LEVEL * np.abs(values).max(initial=0.0)
        step = V @ np.where(steep, (V.T @ g[free]) / np.where(steep, values, 1.0), 0.0)
        tried = x.copy()
        tried[free] -= step * min(1.0, LONGEST / max(float(np.linalg.norm(step)), 1e-300))
        tried = np.clip(tried, low, high)
        new_g, new_cost = _gradient(arm, target, tried)
        if new_cost > cost * (1.0 + 1e-12) or np.abs(new_g[free]).sum() >= np.abs(g[free]).sum():
            break
        x, g, cost = tried, new_g, new_cost
    return np.clip(x * arm.units, low * arm.units, high * arm.units)


def _gradient(arm: Arm, target: Array, x: Array) -> tuple[Array, float]:
    """Gradient of half the squared error at x, (n,), and that."""
    e, J = errors_and_jacobians(arm, x[None], target)
    return -J[0].T @ e[0], 0.5 * float(e[0] @ e[0])


def in_valleys(arm: Arm, target: Array, joints: Array, tolerance: float) -> NDArray[np.bool_]:
    """Return at which configurations `low_points` walks, (m,); arguments are its own."""
    e, J = errors_and_jacobians(arm, joints / arm.units, target)
    _, values, _ = np.linalg.svd(J, full_matrices=False)
    return _is_narrow(values, arm, e, tolerance)


def _is_narrow(values: Array, arm: Arm, errors: Array, tolerance: float) -> NDArray[np.bool_]:
    """Whether the least singular value is small; if smaller still, no error tells two solutions apart."""
    there = are_solutions(errors, arm, tolerance)
    near = there | (np.linalg.norm(errors, axis=1) <= LEFT)
    return np.asarray(near & (values[:, -1] <= NARROW) & ~(there & (values[:, -1] <= tolerance)))


def low_points(arm: Arm, target: Array, joints: Array, tolerance: float) -> Array:
    """Return where else along their valleys the error of configurations is least, (k, n); close to it.

    With a wrist's centre all but on the axis of a shoulder, or an elbow folded, arms nearly move while the
    tool stands still, and two solutions lie at the ends of such a way. They are nearly one root of the
    equations that solve the arm, of which rounding may leave only one; or none, but configurations on the
    way between, where no small step comes nearer to the target. Those of a fold that is nearer than a stride
    lie all but symmetrically to it.

    Those that are not parted by more than the tolerance are joined.
    """
    x = joints / arm.units
    e, J = errors_and_jacobians(arm, x, target)
    U, values, Vt = np.linalg.svd(J, full_matrices=False)
    narrow = _is_narrow(values, arm, e, tolerance)
    way = way_to_fold(arm, joints[narrow], U[narrow, :, -1], Vt[narrow, -1])
    found = [x[narrow] + 2.0 * np.where(np.abs(way) < STRIDE, way, 0.0)[:, None] * Vt[narrow, -1]]
    along = np.concatenate((Vt[narrow, -1], -Vt[narrow, -1]))
    there = np.tile(are_solutions(e[narrow], arm, tolerance), 2)
    last = np.where(there, 0.0, np.tile(np.linalg.norm(e[narrow], axis=1), 2))
    x = np.concatenate((x[narrow], x[narrow]))
    before, highest = np.zeros(len(x)), np.where(there, 0.0, np.inf)
    for _ in range(STRIDES):
        if not len(x):
            break
        here, ahead, error = _along(arm, target, x + STRIDE * along, along)
        low = (last < before) & (last <= error) & (highest > 2.0 * tolerance)
        found.append(x[low])
        inside = (error <= LEFT) & ~low
        x, along, before, last = here[inside], ahead[inside], last[inside], error[inside]
        highest = np.maximum(highest[inside], last)
    return np.asarray(np.concatenate(found) * arm.units)


def _along(arm: Arm, target: Array, x: Array, along: Array) -> tuple[Array, Array, Array]:
    """Step across valleys to their floors: where that is, the way on, and the errors there."""
    for _ in range(ACROSS):
        e, J = errors_and_jacobians(arm, x, target)
        U, values, Vt = np.linalg.svd(J, full_matrices=False)
        inverse = np.where(values > NARROW, 1.0 / np.maximum(values, NARROW), 0.0)
        inverse[:, -1] = 0.0
        x = x + np.einsum("mkn,mk,mik,mi->mn", Vt, inverse, U, e)
    ahead = Vt[:, -1] * np.where((Vt[:, -1] * along).sum(axis=1) < 0.0, -1.0, 1.0)[:, None]
    return x, ahead, np.asarray(np.linalg.norm(e, axis=1))
