"""Square roots and reciprocals of algebraic numbers, as forms."""

from fractions import Fraction
from itertools import product
from math import gcd, lcm

from kinematics.expressions import rational_root
from kinematics.symbolic.elements import ONE_FORM, UNIT, ZERO_FORM, Form, Monomial, RingSymbol, Terms
from kinematics.symbolic.ring import Ring
from kinematics.symbolic.roots import LARGEST_PRIME, square_free, square_root_of_prime

_CONJUGATES_LIMIT = 64
_LARGEST_ORDER = 1000
"""Conjugates that a denominator is multiplied with, and orders of the roots in it, at most: each makes the
product longer."""


def tidy(ring: Ring, form: Form) -> Form:
    """Return the same form, written from its normal form.

    cos(π/3) is 1/2, not a sum of two roots of unity.
    """
    return ring.form(ring.terms(form))


def root_of_rational(ring: Ring, value: Fraction) -> Form:
    """Return the square root of a positive rational number: √(2/9) = √2/3, √12 = 2√3.

    Roots of small primes are sums of roots of unity, where they meet the cosines of π/12; roots of large
    primes are symbols of their own.
    """
    root, primes, certain = square_free(value.numerator * value.denominator)
    if not certain:
        ring.complete = False
    result = ring.rational(Fraction(root, value.denominator))
    for prime in primes:
        factor = ZERO_FORM
        if prime > LARGEST_PRIME:
            factor = ring.symbol(RingSymbol("radical", prime))
        else:
            for turn, sign in square_root_of_prime(prime):
                factor = ring.add(factor, ring.turn(turn), sign)
        result = ring.multiply(result, factor)
    return tidy(ring, result)


def denested_root(ring: Ring, terms: Terms) -> Form | None:
    """Return √(a + b√c) = √((a+d)/2) ± √((a-d)/2) where d² = a² - b²c is the square of a rational number."""
    conjugates = _conjugates(ring, terms)
    if not conjugates:
        return None
    total = ZERO_FORM
    for conjugate in conjugates:
        total = ring.add(total, conjugate)
    rational = ring.terms(ring.scale(total, Fraction(1, len(conjugates)))).get(UNIT, Fraction(0))
    surd = ring.add(ring.form(terms), ring.rational(rational), -1)
    squared = ring.terms(ring.multiply(surd, surd))
    if squared.keys() != {UNIT}:
        return None
    d = rational_root(rational**2 - squared[UNIT])
    if d is None or d >= rational:
        return None
    larger = root_of_rational(ring, (rational + d) / 2)
    smaller = root_of_rational(ring, (rational - d) / 2)
    for sign in (1, -1):
        candidate = ring.add(larger, smaller, sign)
        if ring.terms(ring.multiply(candidate, candidate)) == terms:
            return candidate
    return None


def algebraic_reciprocal(ring: Ring, terms: Terms) -> Form | None:
    """Return 1/x of an algebraic number.

    It is the product of its other conjugates over its norm, if they are few.
    """
    conjugates = _conjugates(ring, terms)
    if not conjugates:
        return None
    others = ONE_FORM
    for conjugate in conjugates[1:]:
        others = tidy(ring, ring.multiply(others, conjugate))
    norm = ring.terms(ring.multiply(conjugates[0], others))
    return ring.scale(others, 1 / norm[UNIT]) if norm.keys() == {UNIT} else None


def _conjugates(ring: Ring, terms: Terms) -> list[Form]:
    """The images of an algebraic number, itself first, under the Galois group of a field that it lies in.

    Nothing of what is no algebraic number, and of a number in a field whose group is large.
    """
    symbols = {symbol for monomial in terms for symbol, _ in monomial.exponents}
    order = lcm(*(monomial.turn.denominator for monomial in terms))
    if order > _LARGEST_ORDER or any(symbol.kind != "radical" for symbol in symbols):
        return []
    units = [k for k in range(1, order + 1) if gcd(k, order) == 1]
    if len(units) * 2 ** len(symbols) > _CONJUGATES_LIMIT:
        return []
    return [
        _conjugate(ring, terms, unit, dict(zip(sorted(symbols), signs, strict=True)))
        for unit, signs in product(units, product((1, -1), repeat=len(symbols)))
    ]


def _conjugate(ring: Ring, terms: Terms, unit: int, flips: dict[RingSymbol, int]) -> Form:
    total = ZERO_FORM
    for monomial, weight in terms.items():
        for symbol, _ in monomial.exponents:
            weight *= flips[symbol]
        rotated = {Monomial(monomial.turn * unit, monomial.exponents): weight}
        total = ring.add(total, ring.form(rotated))
    return total
