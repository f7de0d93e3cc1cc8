"""Radicands that rounding has made negative.

A target that stretches an arm completely makes 1 - K² zero, and rounding may make it -2e-16. Such a radicand
counts as 0. A radicand that is further below 0 has no root: its branch does not exist.
"""

from __future__ import annotations

from fractions import Fraction

from kinematics.expressions import ZERO, Call, Expression, Function, Number, Product, Sum, add, call, multiply
from kinematics.inverse_forms.formulas import positive

ROUNDING = Fraction(1, 10**9)
"""Part of what is subtracted in a radicand by which rounding may leave it below 0."""


def rounding_of(radicand: Expression) -> Expression:
    """Return by how much rounding may leave a radicand below 0; nothing if nothing is subtracted in it."""
    terms = radicand.terms if isinstance(radicand, Sum) else (radicand,)
    subtracted = add(positive(term) for term in terms if positive(term) != term)
    return multiply((Number(ROUNDING), subtracted))


def without_root(value: Expression, radicand: Expression) -> Expression:
    """Return a value in which the root of a radicand is 0."""
    match value:
        case Call(Function.SQRT, (inner,)) if inner == radicand:
            return ZERO
        case Call(function, arguments):
            return call(function, *(without_root(argument, radicand) for argument in arguments))
        case Sum(terms):
            return add(without_root(term, radicand) for term in terms)
        case Product(factors):
            return multiply(without_root(factor, radicand) for factor in factors)
    return value
