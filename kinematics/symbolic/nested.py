"""Sums of products that stay nested, the way a person writes them.

An entry such as c1·(a2·c2 + a3·c23) − d3·s1 is a sum of terms; a term is a rational number times factors; a
factor is a symbol or a sum in parentheses. Nothing is ever multiplied out. What is multiplied as a whole is
put in parentheses, after taking out of it what all its terms share.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import IntEnum
from fractions import Fraction
from typing import TypeAlias

from kinematics.expressions import (
    ZERO,
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
    call,
    joint_variables_in,
    number,
)
from kinematics.symbolic.roots import square_free

Rational: TypeAlias = int | Fraction
Term: TypeAlias = tuple[Rational, tuple[int, ...]]
Nested: TypeAlias = tuple[Term, ...]

NOTHING: Nested = ()
UNITY: Nested = ((1, ()),)
_MINUS: Nested = ((-1, ()),)

_RANK_BITS = 32


class _Rank(IntEnum):
    """The order of factors within a term."""

    ROOT = 0
    LENGTH = 1
    SLIDER = 2
    CONSTANT_ANGLE = 3
    JOINT_ANGLE = 4
    PARENTHESES = 5


@dataclass(slots=True)
class Arena:
    """The factors in use: each is known by a number, in the order in which factors are written."""

    _factors: list[Expression] = field(default_factory=list)
    _names: dict[Expression, int] = field(default_factory=dict)
    _groups: dict[Nested, int] = field(default_factory=dict)
    _terms: dict[Nested, Term] = field(default_factory=dict)
    _known: dict[Expression, Nested] = field(default_factory=dict)

    def read(self, expression: Expression) -> Nested:
        """An expression as a nested sum."""
        known = self._known.get(expression)
        if known is None:
            known = self._known[expression] = self._read(expression)
        return known

    def _read(self, expression: Expression) -> Nested:
        match expression:
            case Number(value):
                return ((_plain(value), ()),) if value else NOTHING
            case Sum(terms):
                return self.sum(*map(self.read, terms))
            case Product(factors):
                result = UNITY
                for factor in factors:
                    result = self.product(result, self.read(factor))
                return result
            case Power(base, exponent) if exponent.denominator == 1 and 1 < exponent <= 16:
                result, repeated = UNITY, self.read(base)
                for _ in range(exponent.numerator):
                    result = self.product(result, repeated)
                return result
            case Call(Function.SQRT, (Number(value),)) if value > 0:
                root, primes, _ = square_free(value.numerator * value.denominator)
                weight = _plain(Fraction(root, value.denominator))
                return ((weight, (self._root(primes),) if primes else ()),)
        return ((1, (self._symbol(expression),)),)

    def sum(self, *summands: Nested) -> Nested:
        """The sum, like terms merged."""
        if len(summands) == 2:
            if not summands[0]:
                return summands[1]
            if not summands[1]:
                return summands[0]
        weights: dict[tuple[int, ...], Rational] = {}
        for summand in summands:
            for weight, factors in summand:
                weights[factors] = weights.get(factors, 0) + weight
        return tuple((weight, factors) for factors, weight in weights.items() if weight)

    def negative(self, a: Nested) -> Nested:
        """-a."""
        return tuple((-weight, factors) for weight, factors in a)

    def product(self, a: Nested, b: Nested) -> Nested:
        """The product; a sum of two or more terms becomes a factor in parentheses."""
        if not a or not b:
            return NOTHING
        for sign, other in ((a, b), (b, a)):
            if sign == UNITY:
                return other
            if sign == _MINUS:
                return self.negative(other)
        (x, left), (y, right) = self.term(a), self.term(b)
        if not left or not right:
            return ((x * y, left or right),)
        factors = tuple(sorted(left + right))
        if factors[1] < 1 << _RANK_BITS:
            root, factors = self._merged_roots(factors)
            return ((_plain(x * y * root), factors),)
        return ((x * y, factors),)

    def term(self, a: Nested) -> Term:
        """The sum as a single term: what all its terms share, times the rest in parentheses."""
        if len(a) == 1:
            return a[0]
        if not a:
            return (0, ())
        known = self._terms.get(a)
        if known is None:
            known = self._terms[a] = self._gathered_term(a)
        return known

    def _gathered_term(self, a: Nested) -> Term:
        weight, shared, rest = _stripped(a)
        opposite = self.negative(rest)
        if rest not in self._groups and (opposite in self._groups or _leads_negative(rest)):
            rest, weight = opposite, -weight
        return weight, tuple(sorted((*shared, self._group(rest))))

    def _group(self, a: Nested) -> int:
        group = self._groups.get(a)
        if group is None:
            group = self._groups[a] = self._new(self.expression(a), _Rank.PARENTHESES)
        return group

    def gathered(self, a: Nested) -> Nested:
        """The sum with what all its terms share taken out, if there is anything."""
        if len(a) < 2:
            return a
        weight, shared, rest = _stripped(a)
        if not shared and abs(weight) == 1:
            return a
        return ((weight, tuple(sorted((*shared, self._group(rest))))),)

    def expression(self, a: Nested) -> Expression:
        """The nested sum as an expression tree; parentheses that occur twice are one object."""
        if not a:
            return ZERO
        if len(a) == 1:
            return self._product(*a[0])
        first = next((i for i, (weight, _) in enumerate(a) if weight > 0), 0)
        ordered = (a[first], *a[:first], *a[first + 1 :]) if first else a
        return Sum(tuple(self._product(weight, factors) for weight, factors in ordered))

    def _product(self, weight: Rational, factors: tuple[int, ...]) -> Expression:
        if not factors:
            return Number(Fraction(weight))
        parts: list[Expression] = [] if weight == 1 else [Number(Fraction(weight))]
        previous, repeated = -1, 0
        for factor in factors:
            if factor == previous:
                repeated += 1
                parts[-1] = Power(self._factor(factor), Fraction(repeated))
            else:
                parts.append(self._factor(factor))
                previous, repeated = factor, 1
        return parts[0] if len(parts) == 1 else Product(tuple(parts))

    def _factor(self, name: int) -> Expression:
        return self._factors[name & ((1 << _RANK_BITS) - 1)]

    def _symbol(self, expression: Expression) -> int:
        name = self._names.get(expression)
        if name is None:
            name = self._names[expression] = self._new(expression, _rank(expression))
        return name

    def _new(self, expression: Expression, rank: _Rank) -> int:
        self._factors.append(expression)
        return (rank << _RANK_BITS) + len(self._factors) - 1

    def _root(self, primes: Iterable[int]) -> int:
        radicand = 1
        for prime in primes:
            radicand *= prime
        return self._symbol(call(Function.SQRT, number(radicand)))

    def _merged_roots(self, factors: tuple[int, ...]) -> tuple[int, tuple[int, ...]]:
        """√2·√6 is 2·√3."""
        radicand, rest = 1, []
        for name in factors:
            if name >> _RANK_BITS:
                rest.append(name)
                continue
            factor = self._factor(name)
            assert isinstance(factor, Call)
            assert isinstance(factor.arguments[0], Number)
            radicand *= factor.arguments[0].value.numerator
        root, primes, _ = square_free(radicand)
        return root, (*((self._root(primes),) if primes else ()), *rest)


def _rank(expression: Expression) -> _Rank:
    match expression:
        case Call(Function.SQRT, (Number(),)):
            return _Rank.ROOT
        case JointVariable():
            return _Rank.SLIDER
        case Parameter() | Pi():
            return _Rank.LENGTH
        case Call(Function.SIN | Function.COS | Function.TAN):
            return _Rank.JOINT_ANGLE if joint_variables_in(expression) else _Rank.CONSTANT_ANGLE
    return _Rank.LENGTH


def _shared_factors(a: Nested) -> tuple[int, ...]:
    """The factors that every term has, as often as every term has them."""
    shared = list(a[0][1])
    for _, factors in a[1:]:
        if not shared:
            break
        left = list(factors)
        kept = []
        for name in shared:
            if name in left:
                left.remove(name)
                kept.append(name)
        shared = kept
    return tuple(shared)


def _shared_weight(a: Nested) -> Rational:
    """The number that every term has up to sign; negative if all terms are."""
    first = a[0][0]
    size = first if first > 0 else -first
    if any(weight not in (size, -size) for weight, _ in a):
        size = 1
    return size if any(weight > 0 for weight, _ in a) else -size


def _leads_negative(a: Nested) -> bool:
    """Whether a sum without parentheses within looks better with the opposite sign: c4·c6 - s4·c5·s6."""
    if any(factors and factors[-1] >> _RANK_BITS == _Rank.PARENTHESES for _, factors in a):
        return False
    return min(a, key=lambda term: term[1])[0] < 0


def _stripped(a: Nested) -> tuple[Rational, tuple[int, ...], Nested]:
    """What all terms share, a number and factors, and the sum that is left."""
    weight = _shared_weight(a)
    shared = _shared_factors(a)
    if weight == -1:
        a = tuple((-w, f) for w, f in a)
    elif weight != 1:
        a = tuple((_plain(Fraction(w) / weight), f) for w, f in a)
    if shared:
        a = tuple((w, _without(f, shared)) for w, f in a)
    return weight, shared, a


def _without(factors: tuple[int, ...], shared: tuple[int, ...]) -> tuple[int, ...]:
    left = list(factors)
    for name in shared:
        left.remove(name)
    return tuple(left)


def _plain(value: Rational) -> Rational:
    """A whole number as an int, whose arithmetic is faster."""
    return int(value) if value == int(value) else value
