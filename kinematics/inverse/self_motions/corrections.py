"""Corrections: from configurations near a family back to it, without a step along it."""

from __future__ import annotations

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.residuals import errors_and_jacobians

ROUNDS = 4
"""Gauss–Newton steps for one step along the path: convergence is quadratic from an error of STRAIGHT·step."""

EXACT = 1e-14
"""Size of the error vector that another step would not make smaller."""

UNSEEN = 1e-7
"""Part of the largest singular value up to which a correction takes others for zero."""

LEVEL = 1e-9
"""Error vectors of this size or less are not corrected by shorter steps: near rounding none is better."""


def corrected(arm: Arm, target: Array, x: Array, held: Array) -> tuple[Array, Array, Array]:
    """The nearest poses with held·x unchanged: x, (m, n), error vectors, (m, 6), and Jacobians, (m, 6, n)."""
    free = np.linalg.svd(held)[2][:, held.shape[1] :]
    return corrected_across(arm, target, x, free.transpose(0, 2, 1))


def corrected_across(arm: Arm, target: Array, x: Array, across: Array) -> tuple[Array, Array, Array]:
    """The same with x moved along the columns of `across` alone, (m, n, k), orthonormal or a projection.

    Where a target is missed by ε, as at the edge of the reach, a Gauss–Newton step knows nothing of how the
    error bends, which counts where singular values are less than √ε: one that helps nothing is taken again
    with the singular values damped by ε.
    """
    e, J = errors_and_jacobians(arm, x, target)
    square = (e * e).sum(axis=1)
    going = np.ones(len(x), dtype=bool)
    for _ in range(ROUNDS):
        U, values, Vt = np.linalg.svd(J @ across, full_matrices=False)
        counts = values > UNSEEN * values[:, :1]
        inverse = np.where(counts, 1.0 / np.where(counts, values, 1.0), 0.0)
        seen = (U.transpose(0, 2, 1) @ e[:, :, None])[:, :, 0]
        step = (across @ (Vt.transpose(0, 2, 1) @ (inverse * seen)[:, :, None]))[:, :, 0]
        tried = x + step
        new_e, new_J = errors_and_jacobians(arm, tried, target)
        new_square = (new_e * new_e).sum(axis=1)
        worse = np.flatnonzero(going & (new_square >= square) & (square > LEVEL**2))
        if len(worse):
            damped = values[worse] / (values[worse] ** 2 + np.sqrt(square[worse])[:, None])
            back = (Vt[worse].transpose(0, 2, 1) @ (damped * seen[worse])[:, :, None])[:, :, 0]
            step[worse] = ((across[worse] if across.ndim > 2 else across) @ back[:, :, None])[:, :, 0]
            tried[worse] = x[worse] + step[worse]
            new_e[worse], new_J[worse] = errors_and_jacobians(arm, tried[worse], target)
            new_square = (new_e * new_e).sum(axis=1)
        going = going & (new_square < square)
        x, e = np.where(going[:, None], tried, x), np.where(going[:, None], new_e, e)
        J, square = np.where(going[:, None, None], new_J, J), np.where(going, new_square, square)
        going = going & ((step * step).sum(axis=1) >= 1e-24) & (square >= EXACT**2)
        if not going.any():
            break
    return x, e, J
