"""3×3 rotation matrices as plain floats, and how far two of them are apart."""

import math
from collections.abc import Sequence
from functools import reduce
from typing import TypeAlias

import numpy as np

from kinematics.angles import cos_sin
from kinematics.se3 import Transform, triple

Triple: TypeAlias = tuple[float, float, float]
Matrix3: TypeAlias = tuple[Triple, Triple, Triple]

IDENTITY: Matrix3 = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def matrix3(rows: Sequence[Sequence[float]]) -> Matrix3:
    """Return three rows of three numbers as a matrix."""
    return triple(triple(map(float, row)) for row in rows)


def rotation_part(transform: Transform) -> Matrix3:
    """Return the rotation of a pose."""
    return matrix3([row[:3] for row in transform.tolist()[:3]])


def as_transform(rotation: Matrix3) -> Transform:
    """Return the (4, 4) pose at the origin that has a rotation."""
    pose = np.eye(4)
    pose[:3, :3] = rotation
    return pose


def product(*factors: Matrix3) -> Matrix3:
    """Return the product of matrices, left to right; the identity of none."""
    return reduce(_times, factors, IDENTITY)


def transposed(matrix: Matrix3) -> Matrix3:
    """Return Mᵀ, the inverse of a rotation."""
    return triple(zip(*matrix, strict=True))


def rotation_about_axis(axis: int, angle: float) -> Matrix3:
    """Return Rot_x, Rot_y or Rot_z of an angle [rad]; axis 0, 1 or 2."""
    c, s = cos_sin(angle)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    rows = [[0.0] * 3 for _ in range(3)]
    rows[axis][axis] = 1.0
    rows[j][j] = rows[k][k] = c
    rows[j][k], rows[k][j] = -s, s
    return matrix3(rows)


def angle_between(first: Matrix3, second: Matrix3) -> float:
    """Return the angle [rad, 0 … π] of the rotation from one orientation to another.

    From the chord, ‖R − S‖ = 2√2·sin(φ/2), which loses nothing where the two are nearly the same.
    """
    return 2.0 * math.asin(min(1.0, distance(first, second) / math.sqrt(8.0)))


def distance(first: Matrix3, second: Matrix3) -> float:
    """Return the Frobenius norm ‖M − N‖."""
    pairs = zip(first, second, strict=True)
    differences = (a - b for row, other in pairs for a, b in zip(row, other, strict=True))
    return math.hypot(*differences)


def determinant(matrix: Matrix3) -> float:
    """Return det M, the triple product of the rows."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def _times(left: Matrix3, right: Matrix3) -> Matrix3:
    (a, b, c), (d, e, f), (g, h, i) = right
    return triple((p * a + q * d + r * g, p * b + q * e + r * h, p * c + q * f + r * i) for p, q, r in left)
