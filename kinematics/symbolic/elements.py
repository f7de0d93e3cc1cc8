"""The elements of the ring: symbols, monomials, and forms."""

from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm
from typing import NamedTuple, TypeAlias

Exponents: TypeAlias = frozenset[tuple["RingSymbol", Fraction]]


class RingSymbol(NamedTuple):
    """What a factor of a term is a power of.

    kind "power": `of` itself (a parameter, π, something opaque). "radical": the root of the prime `of`.
    "exponential": e^(i·of), `of` a `Monomial`. "root": e^(2πi), its exponent a turn.
    """

    kind: str
    of: Hashable


class Monomial(NamedTuple):
    """A term without its rational coefficient: ζ^turn times powers of symbols."""

    turn: Fraction
    exponents: Exponents


Terms: TypeAlias = dict[Monomial, Fraction]
UNIT = Monomial(Fraction(0), frozenset())


@dataclass(frozen=True, slots=True)
class Form:
    """An element of the ring: integer coefficients by key, over a common denominator."""

    coefficients: Mapping[int, int]
    denominator: int = 1

    def __bool__(self) -> bool:
        return bool(self.coefficients)


ZERO_FORM = Form({})
ONE_FORM = Form({0: 1})
IMAGINARY_UNIT = Form({6: 1})


def content(terms: Terms) -> Fraction:
    """Return a rational number that, divided by, makes all multiples of a form one and the same."""
    numerator = gcd(*(weight.numerator for weight in terms.values()))
    denominator = lcm(*(weight.denominator for weight in terms.values()))
    lead = terms[min(terms, key=order_text)]
    return Fraction(numerator if lead > 0 else -numerator, denominator)


def order_text(part: object) -> str:
    """Return a text by which monomials are put in an order that depends on nothing else."""
    if isinstance(part, frozenset):
        return "{" + ",".join(sorted(map(order_text, part))) + "}"
    if isinstance(part, tuple):
        return "(" + ",".join(map(order_text, part)) + ")"
    return repr(part)
