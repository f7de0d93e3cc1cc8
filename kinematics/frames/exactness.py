"""Right angles and short decimals come out exact.

Geometry in floating point leaves 1.5707963267948963 where a right angle was meant and 0.43179999999999996
where 0.4318 was. Entries that differ from such a value by no more than rounding are that value.
"""

import math
from fractions import Fraction

from kinematics.angles import nearest_twelfth, twelfths
from kinematics.expressions import Expression, number, pi_times
from kinematics.frames.normals import EXACT_ANGLE, EXACT_LENGTH
from kinematics.table import DHRow, DHTable, NumericTable, SymbolicTable

_ROUNDING = 1e-14  # What some fifty roundings of 2e-16 leave of a length, as a part of the robot's size.


def clean_angle(angle: float) -> float:
    """Return the angle, or the multiple of π/12 within 1e-10 of it; in (-π, π] for an angle in [-π, π]."""
    k = nearest_twelfth(angle, EXACT_ANGLE)
    return angle if k is None else math.pi if k == -12 else twelfths(k)


def clean_length(length: float, size: float) -> float:
    """Return the short decimal that a length rounds to; zero if it is below 1e-10 of the robot's size."""
    if abs(length) <= EXACT_LENGTH * size:
        return 0.0
    short = float(f"{length:.12g}")
    return short if abs(short - length) <= _ROUNDING * size else length


def exact_table(table: NumericTable) -> SymbolicTable:
    """Return the table with exact entries: multiples of π/12 as such, all else as the decimal it is."""
    return DHTable(
        convention=table.convention,
        rows=tuple(
            DHRow(
                joint=row.joint,
                theta=exact_angle(row.theta),
                d=_exact_length(row.d),
                a=_exact_length(row.a),
                alpha=exact_angle(row.alpha),
                sign=row.sign,
            )
            for row in table.rows
        ),
    )


def exact_angle(angle: float) -> Expression:
    """Return an angle [rad]: a multiple of π/12 as such, all else as the decimal it is."""
    k = nearest_twelfth(angle, 0.0)
    return number(repr(angle)) if k is None else pi_times(Fraction(k, 12))


def _exact_length(length: float) -> Expression:
    return number(repr(length))
