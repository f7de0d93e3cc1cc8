"""What stands above and below the line of a product."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from kinematics.expressions import Call, Expression, Function, Number, Pi, Power

_ONE = Fraction(1)


class Factors(NamedTuple):
    """The factors of a product, sorted.

    Attributes:
        weight: the rational number.
        constants: roots of numbers and π, which are typeset with that number: √3/2.
        above: the others.
        below: what is divided by, and to which positive power.
    """

    weight: Fraction
    constants: list[Expression]
    above: list[Expression]
    below: list[tuple[Expression, Fraction]]


def sorted_factors(factors: Iterable[Expression]) -> Factors:
    """The factors of a product, sorted."""
    weight = _ONE
    constants: list[Expression] = []
    above: list[Expression] = []
    below: list[tuple[Expression, Fraction]] = []
    for factor in factors:
        kind = type(factor)
        if isinstance(factor, Number):
            weight = factor.value if weight is _ONE else weight * factor.value
        elif isinstance(factor, Power) and factor.exponent < 0:
            below.append((factor.base, -factor.exponent))
        elif kind is Pi or (kind is Call and _is_root_of_number(factor)):
            constants.append(factor)
        else:
            above.append(factor)
    return Factors(weight, constants, above, below)


def _is_root_of_number(factor: Expression) -> bool:
    return (
        isinstance(factor, Call)
        and factor.function is Function.SQRT
        and isinstance(factor.arguments[0], Number)
    )
