"""Corrections: from configurations near a family back to it, without a step along it."""

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.residuals import errors_and_jacobians

ROUNDS = 4
"""Gauss–Newton steps for one step along the path: convergence is quadratic from an error of STRAIGHT·step."""

EXACT = 1e-14  # Size of the error vector that another step would not make smaller.

UNSEEN = 1e-7  # Part of the largest singular value up to which a correction takes others for zero.

PLAIN, RIDGE = 1e8, 1e-14
"""Condition of normal equations up to which their steps are as good as any: the next step mends what 1e-8 of
one is off. A ridge, a part of their trace, keeps most that are singular from being refused."""

LEVEL = 1e-9
"""Error vectors of this size or less are not corrected by shorter steps: near rounding none is better."""

LEAST_CHANGE = 1e-5
"""Part of an error vector by which a step has to change it to be followed by another: what a rounded target
is missed by stays, and such a step makes it smaller by this part squared."""


def corrected(arm: Arm, target: Array, x: Array, held: Array) -> tuple[Array, Array, Array]:
    """Return x, (m, n), error vectors and Jacobians, (m, 6, n), at the nearest poses with the same held·x."""
    free = np.linalg.svd(held)[2][:, held.shape[1] :]
    return corrected_across(arm, target, x, free.transpose(0, 2, 1))


def corrected_across(arm: Arm, target: Array, x: Array, across: Array) -> tuple[Array, Array, Array]:
    """Return the same as `corrected`, x moved along the columns of `across` alone.

    These, (m, n, k), are orthonormal, or a projection.

    Where a target is missed by ε, as at the edge of the reach, a Gauss–Newton step knows nothing of how the
    error bends, which counts where singular values are less than √ε: one that helps nothing is taken again
    with the singular values damped by ε, and so are those after it.

    Source: N. Yamashita, M. Fukushima, On the rate of convergence of the Levenberg–Marquardt method (2001),
    for a damping by the error, with which convergence stays quadratic.
    """
    e, J = errors_and_jacobians(arm, x, target)
    square = (e * e).sum(axis=1)
    going, damped = np.ones(len(x), dtype=bool), np.zeros(len(x), dtype=bool)
    for _ in range(ROUNDS):
        A = J @ across
        step = _steps(A, across, e, damped)
        tried = x + step
        new_e, new_J = errors_and_jacobians(arm, tried, target)
        new_square = (new_e * new_e).sum(axis=1)
        change = (J @ step[:, :, None])[:, :, 0]
        level = (change * change).sum(axis=1) <= LEAST_CHANGE**2 * square
        worse = np.flatnonzero(going & ~damped & ~level & (new_square >= square) & (square > LEVEL**2))
        if len(worse):
            damped[worse] = True
            some = across[worse] if across.ndim > 2 else across
            step[worse] = _by_singular_values(A[worse], some, e[worse], damped[worse])
            tried[worse] = x[worse] + step[worse]
            new_e[worse], new_J[worse] = errors_and_jacobians(arm, tried[worse], target)
            new_square = (new_e * new_e).sum(axis=1)
        going = going & (new_square < square)
        x, e = np.where(going[:, None], tried, x), np.where(going[:, None], new_e, e)
        J, square = np.where(going[:, None, None], new_J, J), np.where(going, new_square, square)
        going = going & ~level & ((step * step).sum(axis=1) >= 1e-24) & (square >= EXACT**2)
        if not going.any():
            break
    return x, e, J


def _steps(A: Array, across: Array, e: Array, damped: NDArray[np.bool_]) -> Array:
    """Gauss–Newton steps, (m, n), by normal equations where these are well conditioned; or damped ones.

    They take a quarter of the time of singular values. AᵀA knows nothing of what a projection leaves out,
    so that is added: it changes no step.
    """
    G = A.transpose(0, 2, 1) @ A + (np.eye(A.shape[2]) - across.swapaxes(-1, -2) @ across)
    diagonal = np.einsum("mii->mi", G)
    trace = diagonal.sum(axis=1)
    diagonal += RIDGE * trace[:, None]
    try:
        inverse = np.linalg.inv(G)
    except np.linalg.LinAlgError:  # one is singular to the last digit, as where no joint moves the hand
        return _by_singular_values(A, across, e, damped)
    step = (across @ (inverse @ (A.transpose(0, 2, 1) @ e[:, :, None])))[:, :, 0]
    unclear = np.flatnonzero(damped | ~(trace * np.abs(inverse).max(axis=(1, 2), initial=0.0) < PLAIN))
    if len(unclear):
        some = across[unclear] if across.ndim > 2 else across
        step[unclear] = _by_singular_values(A[unclear], some, e[unclear], damped[unclear])
    return step


def _by_singular_values(A: Array, across: Array, e: Array, damped: NDArray[np.bool_]) -> Array:
    """The same where values may be zero: damped by the errors' size, or as far as they count."""
    U, values, Vt = np.linalg.svd(A, full_matrices=False)
    counts = values > UNSEEN * values[:, :1]
    inverse = np.where(counts, 1.0 / np.where(counts, values, 1.0), 0.0)
    if damped.any():
        size = np.linalg.norm(e, axis=1)[:, None]
        inverse = np.where(damped[:, None], values / np.maximum(values**2 + size, 1e-300), inverse)
    seen = (U.transpose(0, 2, 1) @ e[:, :, None])[:, :, 0]
    return np.asarray((across @ (Vt.transpose(0, 2, 1) @ (inverse * seen)[:, :, None]))[:, :, 0])
