"""Is a function a product of given ones, times what never vanishes?

Numbers, lengths and roots of numbers never vanish; they may stand before the product, for det J and its
factors count up to a unit. As a polynomial in cosines and sines of half angles a function can be but one
product of given ones, and its degrees say how often each of them is a factor; functions that are no such
polynomials are compared in their canonical forms, each factor once.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import chain as in_turn
from itertools import islice
from typing import Any

from kinematics.errors import FormSizeError
from kinematics.expressions import (
    Call,
    Expression,
    Function,
    Number,
    Parameter,
    Power,
    Product,
    Sum,
    multiply,
)
from kinematics.symbolic import Canonical, canonical
from kinematics.symbolic.elements import Monomial
from kinematics.symbolic.polynomials import Polynomial, PolynomialReader, Symbol
from kinematics.symbolic.quotients import cleared

_ZERO = Fraction(0)
FORMED = 20_000  # Products of terms that a proof may form.
COMPARED_PRODUCTS = 64
"""Products of families that are compared with one function; mostly its degrees fit but one."""
CACHED_PRODUCTS = 1_000
"""Products of the families of one arm; with powers of up to three the five of an arm have as many."""


def factors_of(condition: Expression) -> list[Expression]:
    """Return the factors of a condition; powers and what never vanishes are left out."""
    match condition:
        case Product(factors):
            return list(in_turn.from_iterable(map(factors_of, factors)))
        case Power(base, exponent) if exponent > 0:
            return factors_of(base)
        case Number(value) if value:
            return []
        case Power() | Parameter():
            return []
    return [condition]


def never_vanishes(function: Expression) -> bool:
    """Return whether its numbers alone show that a function has no zeros, such as 2 + cos q1."""
    bounds = _bounds(function)
    return bounds is not None and (bounds[0] > 0 or bounds[1] < 0)


def _bounds(function: Expression) -> tuple[Fraction, Fraction] | None:
    match function:
        case Number(value):
            return value, value
        case Call(Function.SIN | Function.COS):
            return Fraction(-1), Fraction(1)
        case Sum(parts) | Product(parts):
            found = [part for part in map(_bounds, parts) if part is not None]
            if len(found) < len(parts):
                return None
            if isinstance(function, Sum):
                return sum((low for low, _ in found), _ZERO), sum((high for _, high in found), _ZERO)
            low, high = Fraction(1), Fraction(1)
            for bounds in found:
                ends = [one * other for one in (low, high) for other in bounds]
                low, high = min(ends), max(ends)
            return low, high
        case Power(base, exponent) if exponent.denominator == 1 and exponent > 0:
            part = _bounds(base)
            if part is None:
                return None
            ends = [end**exponent.numerator for end in part]
            crosses = exponent.numerator % 2 == 0 and part[0] < 0 < part[1]
            return (_ZERO if crosses else min(ends)), max(ends)
    return None


class FamilyProducts:
    """The products of some functions, up to what never vanishes."""

    def __init__(self, families: Sequence[Expression]) -> None:
        self._families = tuple(families)
        self._reader = PolynomialReader(parts=2)
        self._factors = [self._reader.read(cleared(family)) for family in families]
        self._degrees = [self._reader.degrees(factor or {}) for factor in self._factors]
        self._products: dict[tuple[int, ...], Polynomial | None] = {}

    def zeros(self, function: Expression) -> frozenset[int] | None:
        """Return the families whose zeros are proved to be those of a function; None if it is not proved."""
        powers = self.powers(function)
        return None if powers is None else frozenset(j for j, count in enumerate(powers) if count)

    def powers(self, function: Expression) -> tuple[int, ...] | None:
        """Return how often each family is a factor of a function; None if it is not proved."""
        none = (0,) * len(self._families)
        if never_vanishes(function):
            return none
        reader = self._reader.copy()
        given = reader.read(function)
        if given is None:  # few have a denominator
            reader = self._reader.copy()
            given = reader.read(cleared(function))
        if not given:
            return None
        degrees = reader.degrees(given)
        if not degrees:
            return none if len(given) == 1 else None  # a sum of lengths may vanish
        wanted = reader.normalised(given)
        for times in islice(self._fitting(degrees), COMPARED_PRODUCTS):
            if self._product(times) == wanted:
                return times
        return None

    def is_product(self, function: Expression, of: frozenset[int]) -> bool:
        """Return whether a function that may be no polynomial is proved to be a product, each factor once."""
        if None not in self._factors and self._reader.copy().read(cleared(function)) is not None:
            return False  # `zeros` has told
        return is_product_of(function, self._families, of)

    def _fitting(self, degrees: Mapping[Symbol, int], first: int = 0) -> Iterator[tuple[int, ...]]:
        """Yield how often each family from one on may be a factor of what has these degrees."""
        if first == len(self._factors):
            if not any(degrees.values()):
                yield ()
            return
        own = self._degrees[first] if self._factors[first] else {}
        most = min((degrees.get(symbol, 0) // by for symbol, by in own.items()), default=0)
        for times in range(most, -1, -1):
            left = {symbol: degree - times * own.get(symbol, 0) for symbol, degree in degrees.items()}
            for rest in self._fitting(left, first + 1):
                yield (times, *rest)

    def _product(self, times: tuple[int, ...]) -> Polynomial | None:
        """Return a product, normalised; None if it has too many terms."""
        if times not in self._products and len(self._products) < CACHED_PRODUCTS:
            reader = self._reader.copy()
            factors = [
                factor for factor, count in zip(self._factors, times, strict=True) for _ in range(count)
            ]
            product = reader.product(factor for factor in factors if factor is not None)
            self._products[times] = reader.normalised(product) if product else None
        return self._products.get(times)


def is_product_of(factor: Expression, families: Sequence[Expression], of: frozenset[int]) -> bool:
    """Return whether it is proved that a function is a product of families times what never vanishes."""
    try:
        given = canonical(cleared(factor), limit=FORMED)
        ours = _product(tuple(families[j] for j in sorted(of)))
    except (FormSizeError, ZeroDivisionError):
        return False
    if not given.exact or not ours.exact or len(given.terms) != len(ours.terms) or not given.terms:
        return False
    wanted = dict(ours.terms)
    (first, weight), *_ = sorted(given.terms, key=repr)
    for partner, other in ours.terms:
        shift = _shift(partner, first)
        if shift is None:
            continue
        ratio = weight / other
        if all(
            (image := _moved(monomial, shift)) in wanted and value == ratio * wanted[image]
            for monomial, value in given.terms
        ):
            return True
    return False


@lru_cache(maxsize=512)
def _product(families: tuple[Expression, ...]) -> Canonical:
    return canonical(multiply(families), limit=FORMED)


def _shift(partner: Monomial, of: Monomial) -> dict[Any, Any] | None:
    """Return by which powers of lengths and roots two monomials differ; None if angles are among them."""
    if partner.turn != of.turn:
        return None
    ours, given = dict(partner.exponents), dict(of.exponents)
    found = {}
    for symbol in {*ours, *given}:
        apart = given.get(symbol, 0) - ours.get(symbol, 0)
        if not apart:
            continue
        if symbol.kind == "exponential" or (symbol.kind == "power" and not isinstance(symbol.of, Parameter)):
            return None
        found[symbol] = apart
    return found


def _moved(monomial: Monomial, shift: Mapping[Any, Any]) -> Monomial:
    exponents = dict(monomial.exponents)
    for symbol, apart in shift.items():
        left = exponents.get(symbol, 0) - apart
        if left:
            exponents[symbol] = left
        else:
            exponents.pop(symbol, None)
    return Monomial(monomial.turn, frozenset(exponents.items()))
