"""A cell in another unit of length, exact."""

from collections.abc import Mapping
from fractions import Fraction

from kinematics.cells.substitution import substitute
from kinematics.cells.units import ParameterKind
from kinematics.expressions import (
    Call,
    Expression,
    Function,
    Number,
    Parameter,
    Power,
    Product,
    Sum,
    add,
    multiply,
    terms_of,
)

Kinds = Mapping[str, ParameterKind]


def scaled_cell(expression: Expression, kind: ParameterKind, kinds: Kinds, ratio: Fraction) -> Expression:
    """Return c(p·ratio)/ratio of a length, c(p·ratio) of an angle, where p are the length parameters.

    `ratio` is how many old units a new one has: 1000 from millimetres to metres.
    """
    weight = 1 / ratio if kind is ParameterKind.LENGTH else Fraction(1)
    return add(_scaled_term(term, weight, kinds, ratio) for term in terms_of(expression))


def _scaled_term(term: Expression, weight: Fraction, kinds: Kinds, ratio: Fraction) -> Expression:
    degree = _degree(term, kinds)
    if degree is not None and degree.denominator == 1:
        return multiply((Number(weight * ratio ** int(degree)), term))
    lengths = [Parameter(name) for name, kind in kinds.items() if kind is ParameterKind.LENGTH]
    scaled = {length.name: multiply((Number(ratio), length)) for length in lengths}
    return multiply((Number(weight), substitute(term, scaled)))


def _degree(expression: Expression, kinds: Kinds) -> Fraction | None:
    """The k of c(s·p) = s^k·c(p), if the expression is so homogeneous in its length parameters p."""
    match expression:
        case Parameter(name):
            return Fraction(kinds.get(name) is ParameterKind.LENGTH)
        case Sum(terms):
            degrees = {_degree(term, kinds) for term in terms}
            return degrees.pop() if len(degrees) == 1 else None
        case Product(factors):
            factor_degrees = [_degree(factor, kinds) for factor in factors]
            known = [degree for degree in factor_degrees if degree is not None]
            return sum(known, Fraction(0)) if len(known) == len(factor_degrees) else None
        case Power(base, exponent):
            degree = _degree(base, kinds)
            return None if degree is None else degree * exponent
        case Call(function, arguments):
            return _call_degree(function, [_degree(argument, kinds) for argument in arguments])
    return Fraction(0)


def _call_degree(function: Function, degrees: list[Fraction | None]) -> Fraction | None:
    first = degrees[0]
    if any(degree != first for degree in degrees) or first is None:
        return None
    match function:
        case Function.SQRT:
            return first / 2
        case Function.ABS:
            return first
        case Function.ATAN2:
            return Fraction(0)
    return Fraction(0) if first == 0 else None
