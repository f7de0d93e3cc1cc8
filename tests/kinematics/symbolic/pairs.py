"""Pairs of expressions of which it is known whether they are one function.

Equal ones are made by identities of a school book (`rewriting`), unequal ones by one small change as well.
Both are judged by mpmath's values at sixty digits, which know nothing of normal forms: an identity that is
none is an error, and after a change that changes nothing a pair is drawn again. So is one that divides by
zero, as tan(π/2)·cos(π/2) in the place of sin(π/2) does: it is no function.
"""

import random
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import mpmath

from kinematics.expressions import (
    MINUS_ONE,
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Pi,
    Power,
    Product,
    Sum,
    add,
    joint_variables_in,
    multiply,
    negate,
    number,
    parameters_in,
    pi_times,
)
from tests.kinematics.symbolic.rewriting import (
    JOINTS,
    PARAMETERS,
    cos,
    random_expression,
    rewritten,
    sin,
    somewhere,
)

_DIGITS = 60
_SAME = mpmath.mpf("1e-40")
_POINTS = 3
_SMALL = tuple(Fraction(1, 10**digits) for digits in (3, 9, 15))

_FUNCTIONS: dict[Function, Any] = {
    Function.SQRT: mpmath.sqrt,
    Function.SIN: mpmath.sin,
    Function.COS: mpmath.cos,
    Function.ASIN: mpmath.asin,
    Function.ACOS: mpmath.acos,
    Function.ATAN: mpmath.atan,
    Function.ATAN2: mpmath.atan2,
    Function.ABS: mpmath.fabs,
}


def equal_pair(rng: random.Random) -> tuple[Expression, Expression]:
    """One function, written in two ways."""
    while True:
        first = random_expression(rng)
        second = rewritten(first, rng, rng.randrange(1, 9))
        distance = _distance(first, second)
        if distance is not None:
            assert distance < _SAME, (first, second)
            return first, second


def unequal_pair(rng: random.Random) -> tuple[Expression, Expression]:
    """Two functions: the second is the first, rewritten, but for one number, sign, function or symbol."""
    while True:
        first = random_expression(rng)
        second = somewhere(rewritten(first, rng, rng.randrange(0, 6)), rng, _changed)
        distance = _distance(first, second)
        if distance is not None and distance > _SAME:
            return first, second


def _changed(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Call() if _is_constant(node) and rng.random() < 0.7:
            return _rounded(node)
        case Call(Function.COS, (angle,)):
            return rng.choice([sin(angle), cos(add((angle, pi_times(Fraction(1, 180)))))])
        case Call(Function.SIN, (angle,)):
            return rng.choice([cos(angle), negate(sin(angle))])
        case Number(value):
            return Number(value + rng.choice(_SMALL))
        case Parameter(name):
            return Parameter(rng.choice([p for p in ("L1", "L2") if p != name]))
        case JointVariable(index):
            return JointVariable(index % JOINTS + 1)
        case Sum(terms):
            i = rng.randrange(len(terms))
            return add((*terms[:i], negate(terms[i]), *terms[i + 1 :]))
        case Product(factors):
            return multiply((MINUS_ONE, *factors))
    return None


def _rounded(node: Expression) -> Expression:
    """An irrational number as a program prints it: √5 as 2.23606797749979."""
    with mpmath.workdps(_DIGITS):
        (value,) = _values(node, [{}], [()])
    return number(mpmath.nstr(value, 15, min_fixed=-mpmath.inf, max_fixed=mpmath.inf))


def _is_constant(node: Expression) -> bool:
    return not parameters_in(node) and not joint_variables_in(node)


def _distance(first: Expression, second: Expression) -> Any:
    """The largest relative difference at a few points; None if a value does not exist."""
    with mpmath.workdps(_DIGITS):
        root = mpmath.sqrt(2)
        parameters = [
            {name: (i + 1) / root + mpmath.mpf(k) / 7 for i, name in enumerate(PARAMETERS)}
            for k in range(_POINTS)
        ]
        joints = [[mpmath.sin(k + 2 * j + root) for j in range(JOINTS)] for k in range(_POINTS)]
        try:
            pairs = zip(_values(first, parameters, joints), _values(second, parameters, joints), strict=True)
            return max(abs(x - y) / (1 + abs(x)) for x, y in pairs)
        except ZeroDivisionError:
            return None


def _values(
    expression: Expression, parameters: Sequence[Mapping[str, Any]], joints: Sequence[Sequence[Any]]
) -> list[Any]:
    return [_value(expression, *point) for point in zip(parameters, joints, strict=True)]


def _value(node: Expression, parameters: Mapping[str, Any], joints: Sequence[Any]) -> Any:
    def value(part: Expression) -> Any:
        return _value(part, parameters, joints)

    match node:
        case Number(number_):
            return mpmath.mpf(number_.numerator) / number_.denominator
        case Pi():
            return +mpmath.pi
        case Parameter(name):
            return parameters[name]
        case JointVariable(index):
            return joints[index - 1]
        case Sum(terms):
            return sum(map(value, terms))
        case Product(factors):
            return mpmath.fprod(map(value, factors))
        case Power(base, exponent) if exponent < 0:
            return 1 / _raised(_nonzero(value(base)), -exponent)
        case Power(base, exponent):
            return _raised(value(base), exponent)
        case Call(Function.TAN, (angle,)):
            turned = value(angle)
            return mpmath.sin(turned) / _nonzero(mpmath.cos(turned))
        case Call(function, arguments):
            return _FUNCTIONS[function](*map(value, arguments))
    raise AssertionError(node)


def _raised(base: Any, exponent: Fraction) -> Any:
    return base ** (mpmath.mpf(exponent.numerator) / exponent.denominator)


def _nonzero(value: Any) -> Any:
    if abs(value) < _SAME:
        raise ZeroDivisionError
    return value
