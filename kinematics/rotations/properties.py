"""Is a 3×3 matrix a rotation, and which of its defining properties fails if it is none?

    R ∈ SO(3)   ⇔   |columns| = 1,   columns ⟂ one another,   det R > 0

A matrix may fail several; each that fails is a true reason.
"""

import math
from enum import StrEnum
from itertools import combinations

from kinematics.rotations.matrices import Matrix3, determinant, transposed


class RotationProperty(StrEnum):
    """A defining property of rotation matrices."""

    UNIT_COLUMNS = "unit_columns"
    PERPENDICULAR_COLUMNS = "perpendicular_columns"
    RIGHT_HANDED = "right_handed"


def failed_properties(matrix: Matrix3, tolerance: float) -> tuple[RotationProperty, ...]:
    """Return which properties of a rotation a matrix lacks; none of a rotation.

    Args:
        matrix: any matrix of finite numbers.
        tolerance: how far a length may be from 1, and the cosine between two columns from 0.
    """
    columns = transposed(matrix)
    lengths = [math.hypot(*column) for column in columns]
    failed: list[RotationProperty] = []
    if any(abs(length - 1.0) > tolerance for length in lengths):
        failed.append(RotationProperty.UNIT_COLUMNS)
    dots = (sum(a * b for a, b in zip(u, v, strict=True)) for u, v in combinations(columns, 2))
    sizes = (u * v for u, v in combinations(lengths, 2))
    if any(abs(dot) > tolerance * (size or 1.0) for dot, size in zip(dots, sizes, strict=True)):
        failed.append(RotationProperty.PERPENDICULAR_COLUMNS)
    if determinant(matrix) < 0.0:
        failed.append(RotationProperty.RIGHT_HANDED)
    return tuple(failed)
