"""Sums of products that stay nested, the way a person writes them.

An entry such as c1·(a2·c2 + a3·c23) − d3·s1 is a sum of terms; a term is a rational number times factors; a
factor is a symbol or a sum in parentheses. Nothing is ever multiplied out. What is multiplied as a whole is
put in parentheses, after taking out of it what all its terms share.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from fractions import Fraction
from math import prod

from kinematics.expressions import ZERO, Call, Expression, Function, Number, Power, Product, Sum, call, number
from kinematics.symbolic.angles import Angle, cosine_and_sine
from kinematics.symbolic.roots import square_free
from kinematics.symbolic.terms import (
    MINUS,
    NAME_BITS,
    NOTHING,
    PLACE_BITS,
    UNITY,
    Nested,
    Rank,
    Rational,
    Term,
    leads_negative,
    place_of,
    plain,
    rank_of,
    stripped,
)


@dataclass(slots=True)
class Arena:
    """The factors in use: each is known by a number, in the order in which factors are written."""

    _factors: list[Expression] = field(default_factory=list)
    _names: dict[Expression, int] = field(default_factory=dict)
    _groups: dict[Nested, int] = field(default_factory=dict)
    _terms: dict[Nested, Term] = field(default_factory=dict)
    _inside: dict[int, Nested] = field(default_factory=dict)
    _sizes: dict[int, int] = field(default_factory=dict)
    _known: dict[Expression, Nested] = field(default_factory=dict)
    _circles: dict[Angle, tuple[Nested, Nested]] = field(default_factory=dict)
    _products: dict[Term, Expression] = field(default_factory=dict)

    def branch(self) -> "Arena":
        """Return an independent copy: what is added to one is not seen by the other."""
        return Arena(*(getattr(self, known.name).copy() for known in fields(self)))

    def circle(self, angle: Angle) -> tuple[Nested, Nested]:
        """Return the cosine and the sine of an angle."""
        known = self._circles.get(angle)
        if known is None:
            pair = cosine_and_sine(angle)
            if not _is_cosine(pair[0]):
                self.read(pair[1])  # c23 comes before s23, also where the cosine of an angle is s23
            known = self._circles[angle] = self.read(pair[0]), self.read(pair[1])
        return known

    def read(self, expression: Expression) -> Nested:
        """Return an expression as a nested sum."""
        known = self._known.get(expression)
        if known is None:
            known = self._known[expression] = self._read(expression)
        return known

    def _read(self, expression: Expression) -> Nested:
        match expression:
            case Number(value):
                return ((plain(value), ()),) if value else NOTHING
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
                weight = plain(Fraction(root, value.denominator))
                return ((weight, (self._root(primes),) if primes else ()),)
        return ((1, (self._symbol(expression),)),)

    def sum(self, *summands: Nested) -> Nested:
        """Return the sum, like terms merged."""
        if len(summands) == 2:
            if not summands[0]:
                return summands[1]
            if not summands[1]:
                return summands[0]
        weights: dict[tuple[int, ...], Rational] = {}
        for summand in summands:
            for weight, factors in summand:
                known = weights.get(factors)
                weights[factors] = weight if known is None else known + weight
        return tuple((weight, factors) for factors, weight in weights.items() if weight)

    def negative(self, a: Nested) -> Nested:
        """Return -a."""
        return tuple((-weight, factors) for weight, factors in a)

    def product(self, a: Nested, b: Nested) -> Nested:
        """Return the product; a sum of two or more terms becomes a factor in parentheses."""
        if not a or not b:
            return NOTHING
        for sign, other in ((a, b), (b, a)):
            if not sign[0][1]:
                if sign == UNITY:
                    return other
                if sign == MINUS:
                    return self.negative(other)
        (x, left), (y, right) = self.term(a), self.term(b)
        if not x or not y:
            return NOTHING
        if not left or not right:
            return ((x * y, left or right),)
        weight = x * y
        factors = tuple(sorted(left + right))
        if rank_of(factors[1]) == Rank.ROOT:
            root, factors = self._merged_roots(factors)
            return ((plain(weight * root), factors),)
        return ((weight, factors),)

    def term(self, a: Nested) -> Term:
        """Return the sum as a single term: what all its terms share, times the rest in parentheses."""
        if len(a) == 1:
            return a[0]
        if not a:
            return (0, ())
        known = self._terms.get(a)
        if known is None:
            known = self._terms[a] = self._gathered_term(a)
        return known

    def _gathered_term(self, a: Nested) -> Term:
        weight, shared, rest = stripped(a)
        opened = self._opened(rest)
        if opened is not None:
            factor, inner = self.term(opened)
            return weight * factor, tuple(sorted((*shared, *inner)))
        opposite = self.negative(rest)
        if rest not in self._groups and (opposite in self._groups or leads_negative(rest)):
            rest, weight = opposite, -weight
        return weight, tuple(sorted((*shared, self._group(rest))))

    def _opened(self, a: Nested) -> Nested | None:
        """The sum without parentheses that stand in it alone: (a + b) - b is a; None if there are none."""
        alone = [len(factors) == 1 and factors[0] in self._inside for _, factors in a]
        if not any(alone) or (len(a) == 1 and abs(a[0][0]) != 1):
            return None
        opened = []
        for (weight, factors), inside in zip(a, alone, strict=True):
            terms = self._inside[factors[0]] if inside else ((1, factors),)
            opened.append(tuple((weight * inner, parts) for inner, parts in terms))
        return self.sum(*opened)

    def _group(self, a: Nested) -> int:
        group = self._groups.get(a)
        if group is None:
            group = self._groups[a] = self._new(self.expression(a), Rank.PARENTHESES << PLACE_BITS)
            self._inside[group] = a
            self._sizes[group] = self.size(a)
        return group

    def gathered(self, a: Nested) -> Nested:
        """Return the sum with what all its terms share taken out, if there is anything."""
        weight, shared, rest = stripped(a) if len(a) > 1 else (1, (), a)
        opened = self._opened(rest)
        if opened is not None:
            return self.gathered(self.product(((weight, shared),), opened))
        if len(a) < 2:
            return a
        if not shared and abs(weight) == 1:
            return a
        return ((weight, tuple(sorted((*shared, self._group(rest))))),)

    def size(self, a: Nested) -> int:
        """Return how much there is to write, parentheses included."""
        return sum(1 + sum(self._sizes.get(name, 1) for name in factors) for _, factors in a)

    def expression(self, a: Nested) -> Expression:
        """Return the nested sum as an expression tree; parentheses that occur twice are one object.

        A sum does not begin with a minus sign if it need not: negative terms before the first positive one
        go to the end.
        """
        if not a:
            return ZERO
        if len(a) == 1:
            return self._product(*a[0])
        first = next((i for i, (weight, _) in enumerate(a) if weight > 0), 0)
        return Sum(tuple([self._product(weight, factors) for weight, factors in a[first:] + a[:first]]))

    def _product(self, weight: Rational, factors: tuple[int, ...]) -> Expression:
        known = self._products.get((weight, factors))
        if known is None:
            known = self._products[weight, factors] = self._new_product(weight, factors)
        return known

    def _new_product(self, weight: Rational, factors: tuple[int, ...]) -> Expression:
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
        return self._factors[name & ((1 << NAME_BITS) - 1)]

    def _symbol(self, expression: Expression) -> int:
        name = self._names.get(expression)
        if name is None:
            name = self._names[expression] = self._new(expression, place_of(expression))
        return name

    def _new(self, expression: Expression, place: int) -> int:
        self._factors.append(expression)
        return (place << NAME_BITS) + len(self._factors) - 1

    def _root(self, primes: Iterable[int]) -> int:
        return self._symbol(call(Function.SQRT, number(prod(primes))))

    def _merged_roots(self, factors: tuple[int, ...]) -> tuple[int, tuple[int, ...]]:
        """√2·√6 is 2·√3."""
        radicand, rest = 1, []
        for name in factors:
            if rank_of(name) != Rank.ROOT:
                rest.append(name)
                continue
            factor = self._factor(name)
            assert isinstance(factor, Call)
            assert isinstance(factor.arguments[0], Number)
            radicand *= factor.arguments[0].value.numerator
        root, primes, _ = square_free(radicand)
        return root, (*((self._root(primes),) if primes else ()), *rest)


def _is_cosine(expression: Expression) -> bool:
    factor = expression.factors[-1] if isinstance(expression, Product) else expression
    return isinstance(factor, Call) and factor.function is Function.COS
