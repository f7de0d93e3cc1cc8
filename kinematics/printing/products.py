"""What stands above and below the line of a product."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from kinematics.expressions import Call, Expression, Function, Number, Pi, Power


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
    found = Factors(Fraction(1), [], [], [])
    weight = Fraction(1)
    for factor in factors:
        match factor:
            case Number(value):
                weight *= value
            case Power(base, exponent) if exponent < 0:
                found.below.append((base, -exponent))
            case Pi() | Call(Function.SQRT, (Number(),)):
                found.constants.append(factor)
            case _:
                found.above.append(factor)
    return found._replace(weight=weight)
