"""One normal form for every function, and equality of functions as equality of normal forms."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from typing import TypeAlias, cast

from kinematics.expressions import Expression, Function, Number, add, call, multiply, number, pi_times, power
from kinematics.symbolic.angles import angle_of, cosine_and_sine
from kinematics.symbolic.elements import Form, Monomial, RingSymbol
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.ring import Ring


class ProofStatus(StrEnum):
    """What is known of an identity.

    PROVED: it holds for all joint and parameter values. REFUTED: it does not. UNDECIDED: it was not proved,
    and the entries hold what has no unique normal form (a square root of lengths, an arctangent), or their
    expansion is too large.
    """

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"


LIMIT = 2_000_000  # Products of terms that may be formed for one canonical form.

Term: TypeAlias = tuple[Monomial, Fraction]


@dataclass(frozen=True, slots=True)
class Canonical:
    """The normal form of a function of joint variables and parameters.

    Two functions with equal forms are equal. If `exact` holds for both, the converse is true as well.

    Attributes:
        terms: monomials ζ·(lengths)·e^(i·angle) in the basis, each with its rational coefficient.
        exact: whether nothing in it had to be left as it was (a root of lengths, an arctangent of them, a
            quotient by a sum); docs/symbolic.md has the list.
    """

    terms: frozenset[Term]
    exact: bool

    def expression(self) -> Expression:
        """Return the form as an expression: a sum of cosines of sums of angles, for the function is real."""
        return _real_sum(self.terms)


def canonical(expression: Expression, *, limit: int = LIMIT) -> Canonical:
    """Return the normal form of an expression.

    Raises:
        FormSizeError: the expansion needs more products of terms than `limit`.
        ZeroDivisionError: the expression divides by zero.
    """
    reader = FormReader(Ring(limit=limit))
    return canonical_of(reader, reader.form(expression))


def compare(a: Expression, b: Expression, *, limit: int = LIMIT) -> ProofStatus:
    """Return whether two expressions are the same function of variables and parameters, where both exist.

    Raises:
        FormSizeError: the expansion needs more products of terms than `limit`.
        ZeroDivisionError: an expression divides by zero.
    """
    return compare_all(((a, b),), limit=limit)


def compare_all(pairs: Iterable[tuple[Expression, Expression]], *, limit: int = LIMIT) -> ProofStatus:
    """Return whether the expressions of each pair are the same function; all are read into one ring.

    Raises:
        FormSizeError: the expansions need more products of terms than `limit`.
        ZeroDivisionError: an expression divides by zero.
    """
    reader = FormReader(Ring(limit=limit))
    for a, b in pairs:
        if not reader.vanishes(reader.ring.add(reader.form(a), reader.form(b), -1)):
            return ProofStatus.REFUTED if reader.decisive else ProofStatus.UNDECIDED
    return ProofStatus.PROVED


def same_function(a: Expression, b: Expression, *, limit: int = LIMIT) -> bool:
    """Return whether two expressions were proved to be the same function.

    See `compare` for the third answer.
    """
    return compare(a, b, limit=limit) is ProofStatus.PROVED


def canonical_of(reader: FormReader, form: Form) -> Canonical:
    """Return the normal form of what a reader has read."""
    return Canonical(frozenset(reader.ring.terms(form).items()), reader.is_exact(form))


def _real_sum(terms: frozenset[Term]) -> Expression:
    parts = [multiply((Number(weight), real_part(monomial))) for monomial, weight in terms]
    return add(sorted(parts, key=repr))


def real_part(monomial: Monomial) -> Expression:
    """Return Re(ζ · e^(i·angle)) · (powers) as an expression."""
    angle = [pi_times(2 * monomial.turn)]
    factors = []
    for symbol, exponent in monomial.exponents:
        if symbol.kind == "exponential":
            assert isinstance(symbol.of, Monomial)
            angle.append(multiply((Number(exponent), real_part(symbol.of))))
        else:
            factors.append(power(symbol_expression(symbol), exponent))
    cosine, _ = cosine_and_sine(angle_of(add(sorted(angle, key=repr))))
    return multiply((*sorted(factors, key=repr), cosine))


def symbol_expression(symbol: RingSymbol) -> Expression:
    """Return what a symbol stands for as an expression.

    It is a parameter, π, the root of a prime, or something opaque, named by its function and arguments.
    """
    if symbol.kind == "radical":
        assert isinstance(symbol.of, int)
        return call(Function.SQRT, number(symbol.of))
    if not isinstance(symbol.of, tuple):
        return cast(Expression, symbol.of)
    name, detail, *arguments = symbol.of
    values = [_real_sum(argument) for argument in arguments]
    match name:
        case "root":
            return power(values[0], Fraction(1, detail[0]))
        case "divisor":
            return values[0]
    return call(Function(name), *values)
