"""Numbers from outside as exact entries."""

from collections.abc import Sequence
from fractions import Fraction

from kinematics.expressions import Expression, Number, evaluate
from kinematics.symbolic.angles import COSINES
from kinematics.symbolic.writing import Matrix

_LAST_DIGITS = 4e-16  # Two units in the last place of a number near 1, which rounding a cosine leaves.
_KNOWN = [(evaluate(cosine), cosine) for cosine in COSINES]


def exact_pose(matrix: Sequence[Sequence[float]]) -> Matrix:
    """Return a 4×4 pose of numbers with exact entries.

    An entry of the rotation that is the cosine of a multiple of π/12 to a double's last digits becomes that
    cosine: 0.7071067811865476 is √2/2, and 6.1e-17 is 0, for that is what such numbers were before they were
    rounded. Every other number is the decimal that it was typed as.
    """
    return tuple(
        tuple(_rotation_entry(value) if i < 3 and j < 3 else decimal(value) for j, value in enumerate(row))
        for i, row in enumerate(matrix)
    )


def decimal(value: float) -> Number:
    """Return a number as the decimal that it is typed as."""
    return Number(Fraction(repr(value)))


def _rotation_entry(value: float) -> Expression:
    for known, cosine in _KNOWN:
        if abs(value - known) <= _LAST_DIGITS:
            return cosine
    return decimal(value)
