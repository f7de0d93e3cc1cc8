"""Exact values of numbers, sines and angles, as far as a square root reaches."""

from fractions import Fraction
from functools import lru_cache

from kinematics.angles import TWELFTH, nearest_twelfth
from kinematics.errors import ParameterError
from kinematics.expressions import (
    ONE,
    ZERO,
    Call,
    Expression,
    Function,
    Number,
    Power,
    Product,
    call,
    evaluate,
    joint_variables_in,
    multiply,
    negate,
    number,
    parameters_in,
    pi_fraction,
    pi_times,
    power,
    rational_value,
)

_HALF = Fraction(1, 2)
_SINES: dict[Fraction, Expression] = {
    Fraction(0): ZERO,
    Fraction(1, 6): Number(_HALF),
    Fraction(1, 4): multiply((Number(_HALF), call(Function.SQRT, number(2)))),
    Fraction(1, 3): multiply((Number(_HALF), call(Function.SQRT, number(3)))),
    Fraction(1, 2): ONE,
}
_TANGENTS: dict[Fraction, Expression] = {
    Fraction(0): ZERO,
    Fraction(1, 6): multiply((number(Fraction(1, 3)), call(Function.SQRT, number(3)))),
    Fraction(1, 4): ONE,
    Fraction(1, 3): call(Function.SQRT, number(3)),
}
_SNAP_RELATIVE = 4e-16
"""Two units in the last place of a double: 3.141592653589793/6 is meant as π/6, whatever rounded it."""
_SNAP_STEPS = 12 * 64
"""64 half turns in twelfths: beyond, a number in [rad] is no angle that anybody writes as a part of π."""


def reciprocal(value: Expression) -> Expression:
    """Return 1/value, factor by factor; 1/sqrt(n) becomes sqrt(n)/n.

    Raises:
        ZeroDivisionError: the value is zero.
    """
    match value:
        case Product(factors):
            return multiply(reciprocal(factor) for factor in factors)
        case Call(Function.SQRT, (Number(radicand),)) if radicand > 0:
            return multiply((Number(1 / radicand), value))
        case Power(base, exponent):
            return power(base, -exponent)
    return power(value, -1)


def raised(base: Expression, exponent: Fraction) -> Expression:
    """Return base ** exponent; halves become square roots; sqrt(n) ** 2 of a number n becomes n.

    Raises:
        ZeroDivisionError: zero to a negative power.
    """
    if exponent < 0:
        return reciprocal(raised(base, -exponent))
    if exponent == _HALF:
        return call(Function.SQRT, base)
    match base:
        case Call(Function.SQRT, (Number(radicand),)) if exponent == 2 and radicand >= 0:
            return Number(radicand)
    return power(base, exponent)


def absolute(value: Expression) -> Expression:
    """Return the absolute value; folded for numbers and multiples of π."""
    turns = pi_fraction(value)
    return call(Function.ABS, value) if turns is None else pi_times(abs(turns))


def trigonometric(function: Function, angle: Expression) -> Expression:
    """Return the sine, cosine or tangent; exact for multiples of π/6 and π/4.

    Raises:
        ZeroDivisionError: the tangent of a right angle.
    """
    return call(function, angle) if pi_fraction(angle) is None else _of_turns(function, angle)


@lru_cache(maxsize=512)
def _of_turns(function: Function, angle: Expression) -> Expression:
    turns = pi_fraction(angle)
    assert turns is not None
    if function is Function.COS:
        turns += _HALF
    if function is Function.TAN:
        return _tangent(turns % 1, angle)
    turns %= 2
    sign, turns = (-1, turns - 1) if turns >= 1 else (1, turns)
    value = _SINES.get(min(turns, 1 - turns))
    if value is None:
        return call(function, angle)
    return value if sign > 0 else negate(value)


def inverse_trigonometric(function: Function, *arguments: Expression) -> Expression:
    """Return asin, acos, atan or atan2; exact where the angle is a multiple of π/6 or π/4 and provably so."""
    plain = call(function, *arguments)
    if any(parameters_in(argument) or joint_variables_in(argument) for argument in arguments):
        return plain
    try:
        steps = Fraction(round(evaluate(plain) / TWELFTH), 12)
    except ParameterError:  # no real value: reported where the whole cell is evaluated
        return plain
    candidate = pi_times(steps)
    return candidate if _proves(function, arguments, candidate) else plain


def snapped(value: Fraction) -> Expression:
    """Return an angle [rad] as a multiple of π/12, if it is one to a double's last digit, else itself."""
    approximate = float(value)
    k = nearest_twelfth(approximate, _SNAP_RELATIVE * abs(approximate))
    return pi_times(Fraction(k, 12)) if k and abs(k) <= _SNAP_STEPS else Number(value)


def _tangent(turns: Fraction, angle: Expression) -> Expression:
    if turns == _HALF:
        raise ZeroDivisionError
    value = _TANGENTS.get(min(turns, 1 - turns))
    if value is None:
        return call(Function.TAN, angle)
    return value if turns < _HALF else negate(value)


def _proves(function: Function, arguments: tuple[Expression, ...], angle: Expression) -> bool:
    sine, cosine = trigonometric(Function.SIN, angle), trigonometric(Function.COS, angle)
    match function:
        case Function.ASIN:
            return arguments[0] == sine
        case Function.ACOS:
            return arguments[0] == cosine
        case Function.ATAN:
            return cosine != ZERO and arguments[0] == trigonometric(Function.TAN, angle)
    y, x = arguments
    if ZERO in (sine, cosine):
        return (y == ZERO) == (sine == ZERO) and (x == ZERO) == (cosine == ZERO)
    return rational_value(x) is not None and multiply((y, reciprocal(x))) == trigonometric(
        Function.TAN, angle
    )
