"""The nodes of an expression, and the constructors that fold what is exact."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from typing import TypeAlias


class Function(StrEnum):
    """Functions that may stand in an expression; angles in [rad]."""

    SQRT = "sqrt"
    SIN = "sin"
    COS = "cos"
    TAN = "tan"
    ASIN = "asin"
    ACOS = "acos"
    ATAN = "atan"
    ATAN2 = "atan2"
    ABS = "abs"


@dataclass(frozen=True, slots=True, eq=False)
class Number:
    """A rational number; decimals as typed are rational (0.1 is 1/10)."""

    value: Fraction

    # trees are compared and looked up all the time, and a fraction takes long over both
    def __eq__(self, other: object) -> bool:
        if type(other) is not Number:
            return NotImplemented
        one, two = self.value, other.value
        return one is two or one.as_integer_ratio() == two.as_integer_ratio()

    def __hash__(self) -> int:
        return hash(self.value.as_integer_ratio())


@dataclass(frozen=True, slots=True)
class Pi:
    """The number π."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """A length or an angle known only by name, such as L1."""

    name: str


@dataclass(frozen=True, slots=True)
class JointVariable:
    """The joint variable q_index; index counts from 1."""

    index: int


@dataclass(frozen=True, slots=True)
class Sum:
    """Sum of two or more terms."""

    terms: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Product:
    """Product of two or more factors."""

    factors: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Power:
    """base ** exponent, the exponent rational and constant."""

    base: Expression
    exponent: Fraction


@dataclass(frozen=True, slots=True)
class Call:
    """A function applied to its arguments."""

    function: Function
    arguments: tuple[Expression, ...]


Expression: TypeAlias = Number | Pi | Parameter | JointVariable | Sum | Product | Power | Call

ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))
MINUS_ONE = Number(Fraction(-1))
_UNIT = Fraction(1)
PI = Pi()


def number(value: int | Fraction | str) -> Number:
    """Return a rational number, from an integer, a fraction or a decimal literal such as "0.4318"."""
    return Number(Fraction(value))


def pi_times(factor: int | Fraction) -> Expression:
    """Return the exact angle factor·π [rad]."""
    return multiply((Number(Fraction(factor)), PI))


def rational_value(expression: Expression) -> Fraction | None:
    """Return the value of a rational number, or None of anything else."""
    return expression.value if isinstance(expression, Number) else None


def pi_fraction(expression: Expression) -> Fraction | None:
    """Return the r of an exact angle r·π (0 included), or None of anything else."""
    match expression:
        case Number(value) if value == 0:
            return Fraction(0)
        case Pi():
            return Fraction(1)
        case Product((Number(value), Pi())):
            return value
    return None


def add(terms: Iterable[Expression]) -> Expression:
    """Return the sum of the terms, flattened.

    Numbers and rational multiples of π are added exactly, and like terms are merged.
    """
    terms = [term for term in terms if type(term) is not Number or term.value]
    if len(terms) == 1:
        return terms[0]
    merged: dict[Expression, tuple[Fraction, Expression | None]] = {}
    constant: Fraction | None = None
    for given in terms:
        for term in given.terms if type(given) is Sum else (given,):
            if type(term) is Number:
                constant = term.value if constant is None else constant + term.value
                continue
            weight, rest = split_weight(term)
            known = merged.get(rest)
            merged[rest] = (weight, term) if known is None else (known[0] + weight, None)
    kept = [
        multiply((Number(weight), rest)) if term is None else term
        for rest, (weight, term) in merged.items()
        if weight
    ]
    if constant:
        kept.append(Number(constant))
    if not kept:
        return ZERO
    return kept[0] if len(kept) == 1 else Sum(tuple(kept))


def multiply(factors: Iterable[Expression]) -> Expression:
    """Return the product of the factors: flattened, rational numbers multiplied exactly and put first."""
    weight: Fraction | None = None
    rest: list[Expression] = []
    for given in factors:
        for factor in given.factors if type(given) is Product else (given,):
            if type(factor) is Number:
                weight = factor.value if weight is None else weight * factor.value
            else:
                rest.append(factor)
    if weight is not None:
        if not weight:
            return ZERO
        if not rest:
            return Number(weight)
        if weight != 1:
            rest.insert(0, Number(weight))
    if not rest:
        return ONE
    return rest[0] if len(rest) == 1 else Product(tuple(rest))


def negate(expression: Expression) -> Expression:
    """Return the expression with the opposite sign; a sum is negated term by term."""
    if isinstance(expression, Sum):
        return add(multiply((MINUS_ONE, term)) for term in expression.terms)
    return multiply((MINUS_ONE, expression))


def power(base: Expression, exponent: Fraction | int) -> Expression:
    """Return the power with a constant exponent; an integer power of a rational number is folded.

    Raises:
        ZeroDivisionError: zero to a negative power.
    """
    exponent = Fraction(exponent)
    if exponent == 1:
        return base
    if exponent == 0:
        return ONE
    if isinstance(base, Number) and exponent.denominator == 1:
        return Number(base.value ** int(exponent))
    if isinstance(base, Power) and base.exponent.denominator == exponent.denominator == 1:
        return power(base.base, base.exponent * exponent)
    return Power(base, exponent)


def call(function: Function, *arguments: Expression) -> Expression:
    """Return the value of a function.

    The root of a rational square and the absolute value of a number are folded.
    """
    value = rational_value(arguments[0])
    if value is not None:
        if function is Function.ABS:
            return Number(abs(value))
        root = rational_root(value) if function is Function.SQRT else None
        if root is not None:
            return Number(root)
    return Call(function, arguments)


def rational_root(value: Fraction) -> Fraction | None:
    """Return the square root of a number that is a rational square, or None of any other."""
    if value < 0:
        return None
    root = Fraction(math.isqrt(value.numerator), math.isqrt(value.denominator))
    return root if root * root == value else None


def with_parts(expression: Expression, change: Callable[[Expression], Expression]) -> Expression:
    """Return an expression with each part directly below it changed; what has no parts, as it is."""
    match expression:
        case Sum(terms):
            return add(map(change, terms))
        case Product(factors):
            return multiply(map(change, factors))
        case Power(base, exponent):
            return Power(change(base), exponent)
        case Call(function, arguments):
            return Call(function, tuple(map(change, arguments)))
    return expression


def terms_of(expression: Expression) -> tuple[Expression, ...]:
    """Return the terms of a sum; anything else is the one term."""
    return expression.terms if isinstance(expression, Sum) else (expression,)


def split_weight(term: Expression) -> tuple[Fraction, Expression]:
    """Return the number before a term, and the term without it."""
    if type(term) is Product and type(term.factors[0]) is Number:
        rest = term.factors[1:]
        return term.factors[0].value, rest[0] if len(rest) == 1 else Product(rest)
    return _UNIT, term
