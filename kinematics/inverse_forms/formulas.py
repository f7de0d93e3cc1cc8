"""What the equations are made of: roots, quotients, angles by atan2; and radicands below zero."""

from collections.abc import Sequence
from fractions import Fraction
from functools import partial

from kinematics.expressions import (
    ZERO,
    Call,
    Expression,
    Function,
    Number,
    Product,
    add,
    call,
    multiply,
    negate,
    power,
    terms_of,
    with_parts,
)
from kinematics.inverse_forms.signed_axes import Axis, Vector, along
from kinematics.se3 import triple


def square(value: Expression) -> Expression:
    """Return value², a sum left together and a minus sign left out."""
    return power(positive(value), 2)


def positive(value: Expression) -> Expression:
    """Return the value or its opposite, whichever has no minus sign before it."""
    head = value.factors[0] if isinstance(value, Product) else value
    return negate(value) if isinstance(head, Number) and head.value < 0 else value


def root(value: Expression) -> Expression:
    """Return √value."""
    return call(Function.SQRT, value)


def atan2(y: Expression, x: Expression) -> Expression:
    """Return the angle of (x, y); 0 where y is 0 and x a positive number."""
    if y == ZERO and isinstance(x, Number) and x.value > 0:
        return ZERO
    return call(Function.ATAN2, y, x)


def less_angle(angle: Expression, y: Expression, x: Expression) -> Expression:
    """Return angle - atan2(y, x), as angle + atan2(-y, x) where y has a minus sign before it."""
    if positive(y) != y:
        return add((angle, atan2(negate(y), x)))
    return add((angle, negate(atan2(y, x))))


def times(*factors: Expression) -> Expression:
    """Return the product."""
    return multiply(factors)


def over(value: Expression, divisor: Expression) -> Expression:
    """Return the quotient, a minus sign of the divisor before it."""
    quotient = multiply((value, power(positive(divisor), -1)))
    return quotient if positive(divisor) == divisor else negate(quotient)


def halved(value: Expression) -> Expression:
    """Return the value / 2."""
    return multiply((Number(Fraction(1, 2)), value))


def product_with(matrix: Sequence[Vector], axis: Axis) -> Vector:
    """Return a matrix, given by its rows, times an axis."""
    return triple(along(axis, row) for row in matrix)


ROUNDING = Fraction(1, 10**9)
"""Part of what is subtracted in a radicand by which rounding may leave it below 0: a target that stretches an
arm completely makes 1 - K² zero, and rounding may make it -2e-16. Further below there is no such branch."""


def rounding_of(radicand: Expression) -> Expression:
    """Return by how much rounding may leave a radicand below 0; nothing if nothing is subtracted in it."""
    terms = terms_of(radicand)
    subtracted = add(positive(term) for term in terms if positive(term) != term)
    return multiply((Number(ROUNDING), subtracted))


def without_root(value: Expression, radicand: Expression) -> Expression:
    """Return a value in which the root of a radicand is 0."""
    if value == Call(Function.SQRT, (radicand,)):
        return ZERO
    return with_parts(value, partial(without_root, radicand=radicand))
