"""Rigid transforms as 4×4 arrays: what is one, and its inverse."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import Fault, PoseError
from kinematics.links import Transform

# Six decimals always pass: each entry is then off by at most 5e-7, a product of columns by 1.8e-6.
ORTHONORMAL_TOLERANCE = 2e-6

Place = tuple[str | int, ...]


def inverse_transform(transform: Transform) -> Transform:
    """Inverse of rigid transforms: (Rᵀ, −Rᵀ p), for (4, 4) or (…, 4, 4).

    Source: seed 001 eq. 2.7.
    """
    inverse = np.zeros_like(transform, dtype=np.float64)
    rotation = np.swapaxes(transform[..., :3, :3], -1, -2)
    inverse[..., :3, :3] = rotation
    inverse[..., :3, 3] = -(rotation @ transform[..., :3, 3:])[..., 0]
    inverse[..., 3, 3] = 1.0
    return inverse


def check_transform(
    value: ArrayLike, *, where: Place = (), tolerance: float = ORTHONORMAL_TOLERANCE
) -> Transform:
    """A copy of the value as a 4×4 array, having made sure that it is a rigid transform.

    Args:
        value: what claims to be one.
        where: place of the value, for the faults.
        tolerance: how far an entry of RᵀR may be from the identity's.

    Raises:
        PoseError: not 4×4 numbers, not finite, a bottom row other than (0, 0, 0, 1), a rotation part that is
            not orthonormal, or a left-handed one.
    """
    matrix = _matrix_4x4(value, where)
    r0, r1, r2, bottom = matrix.tolist()
    faults = [
        Fault(code="pose_not_finite", where=(*where, i, j))
        for i, row in enumerate((r0, r1, r2, bottom))
        for j, entry in enumerate(row)
        if not math.isfinite(entry)
    ]
    if faults:
        raise PoseError(faults)
    if bottom != [0.0, 0.0, 0.0, 1.0]:
        faults.append(Fault(code="pose_bottom_row", where=(*where, 3)))
    faults.extend(_rotation_faults(r0, r1, r2, where, tolerance))
    if faults:
        raise PoseError(faults)
    return matrix


def _matrix_4x4(value: ArrayLike, where: Place) -> Transform:
    try:
        matrix = np.asarray(value)
    except ValueError:
        matrix = np.asarray(None)
    if matrix.dtype.kind not in "fiu":
        raise PoseError(Fault(code="pose_not_numbers", where=where))
    if matrix.shape != (4, 4):
        shape = "x".join(map(str, matrix.shape)) or "1"
        raise PoseError(Fault(code="pose_wrong_shape", where=where, params={"shape": shape}))
    return np.array(matrix, dtype=np.float64)


def _rotation_faults(
    r0: list[float], r1: list[float], r2: list[float], where: Place, tolerance: float
) -> list[Fault]:
    """Whether the columns are perpendicular unit vectors, and right-handed."""
    x, y, z = ((r0[j], r1[j], r2[j]) for j in range(3))
    products = ((x, x, 1.0), (y, y, 1.0), (z, z, 1.0), (x, y, 0.0), (y, z, 0.0), (z, x, 0.0))
    error = max(abs(u[0] * v[0] + u[1] * v[1] + u[2] * v[2] - meant) for u, v, meant in products)
    if error > tolerance:
        params = {"error": f"{error:.1e}", "tolerance": f"{tolerance:g}"}
        return [Fault(code="pose_not_orthonormal", where=where, params=params)]
    across = (y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0])
    if x[0] * across[0] + x[1] * across[1] + x[2] * across[2] < 0.0:
        return [Fault(code="pose_left_handed", where=where)]
    return []
