"""Is a function a product of given ones, times what never vanishes?

Numbers, lengths and roots of numbers never vanish; they may stand before the product, for det J and its
factors count up to a unit. Both sides are brought to their canonical forms and compared term by term.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from itertools import chain as in_turn
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
    add,
    call,
    multiply,
    power,
)
from kinematics.symbolic import Canonical, canonical
from kinematics.symbolic.elements import Monomial

FORMED = 20_000
"""Products of terms that a proof may form."""


def factors_of(condition: Expression) -> list[Expression]:
    """Return the factors of a condition; powers and what never vanishes are left out."""
    match condition:
        case Product(factors):
            return list(in_turn.from_iterable(map(factors_of, factors)))
        case Power(base, exponent) if exponent > 0:
            return factors_of(base)
        case Number(value) if value:
            return []
        case Power(base, _):
            return []
        case Parameter():
            return []
    return [condition]


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


def cleared(expression: Expression) -> Expression:
    """Return the numerator of an expression; tangents are sine over cosine."""
    return _fraction(expression)[0]


def _fraction(expression: Expression) -> tuple[Expression, tuple[Expression, ...]]:
    """Return a numerator and the factors of a denominator."""
    match expression:
        case Call(Function.TAN, (angle,)):
            return call(Function.SIN, angle), (call(Function.COS, angle),)
        case Power(base, exponent) if exponent < 0 and exponent.denominator == 1:
            top, bottom = _fraction(base)
            over = (top,) * -exponent.numerator
            return multiply(bottom * -exponent.numerator), over
        case Power(base, exponent) if exponent.denominator == 1:
            top, bottom = _fraction(base)
            return power(top, exponent), bottom * exponent.numerator
        case Product(factors):
            parts = [_fraction(factor) for factor in factors]
            return multiply(top for top, _ in parts), tuple(in_turn.from_iterable(b for _, b in parts))
        case Sum(terms):
            parts = [_fraction(term) for term in terms]
            common = tuple(dict.fromkeys(in_turn.from_iterable(bottom for _, bottom in parts)))
            counts = {each: max(bottom.count(each) for _, bottom in parts) for each in common}
            rows = [
                multiply((top, *(power(each, counts[each] - bottom.count(each)) for each in common)))
                for top, bottom in parts
            ]
            return add(rows), tuple(each for each in common for _ in range(counts[each]))
    return expression, ()


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
