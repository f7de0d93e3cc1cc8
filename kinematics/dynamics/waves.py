"""Real functions of joint variables as sums of cosines, which are differentiated term by term.

A `Wave` is Π p^e · cos(Σ k_i q_i + ⋯ + turn); a function is a whole weight for each wave, over a denominator
that all functions of a table share. It is what a real element of the ring is when each exponential is put
together with its conjugate.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from math import lcm
from typing import NamedTuple, TypeAlias

from kinematics.expressions import (
    Expression,
    JointVariable,
    Number,
    Parameter,
    add,
    multiply,
    pi_times,
    power,
)
from kinematics.symbolic.angles import angle_of, cosine_and_sine
from kinematics.symbolic.canonical import real_part, symbol_expression
from kinematics.symbolic.elements import Form, Monomial, RingSymbol, order_text
from kinematics.symbolic.key_layout import ORDER
from kinematics.symbolic.nested import Arena
from kinematics.symbolic.ring import Ring
from kinematics.symbolic.terms import Nested, Rational, Term, plain, quotient

Exponents: TypeAlias = tuple[tuple[int, Rational], ...]
NumberedTerm: TypeAlias = tuple[list[tuple[int, Rational]], Fraction, int]
"""Exponents of symbols by their numbers, the turn of a root of unity, and a weight."""

_HALF_TURN, _QUARTER_TURN = 12, 6
"""Turns are counted in twenty-fourths, as in the ring."""


class Wave(NamedTuple):
    """A term without its weight; symbols are known by their numbers.

    Attributes:
        angle: what each angle in the cosine is multiplied by; the first is positive.
        turn: what is added to them, in 24ths of a turn, at least 0 and less than 12.
        powers: what stands before the cosine.
    """

    angle: Exponents
    turn: Rational
    powers: Exponents


Waves: TypeAlias = Mapping[Wave, int]


class WaveTable:
    """Some elements of a ring as waves.

    Attributes:
        waves: the elements.
        denominator: what their weights are divided by.

    Args:
        ring: where the elements are.
        forms: the elements, each a real function.
        n_joints: how many joint variables there are.
        names: parameters in the order in which they are written.
    """

    def __init__(self, ring: Ring, forms: Iterable[Form], n_joints: int, names: Sequence[str]) -> None:
        self._symbols: list[RingSymbol] = []
        self._numbers: dict[RingSymbol, int] = {}
        self._cosines: dict[tuple[Exponents, Rational], Nested] = {}
        self._powers: dict[Exponents, Term] = {}
        self._arena = Arena()
        for joint in range(1, n_joints + 1):
            variable = RingSymbol("power", JointVariable(joint))
            monomial = Monomial(Fraction(0), frozenset({(variable, Fraction(1))}))
            self._number(RingSymbol("exponential", monomial))
            self._number(variable)
        for name in names:
            self._arena.read(Parameter(name))
            self._number(RingSymbol("power", Parameter(name)))
        # what stands in a set comes in no order
        for symbol in sorted(set(ring.symbols) - self._numbers.keys(), key=order_text):
            self._number(symbol)
        found = [self._terms(ring, form) for form in forms]
        self.denominator = lcm(*(denominator for _, denominator in found))
        self.waves: tuple[Waves, ...] = tuple(
            self._read(terms, self.denominator // denominator) for terms, denominator in found
        )

    def _terms(self, ring: Ring, form: Form) -> tuple[list[NumberedTerm], int]:
        """The terms of a form with whole weights over a denominator."""
        numbered = ring.numbered_terms(form)
        if numbered is not None:
            numbers = [self._numbers[symbol] for symbol in ring.symbols]
            return [
                ([(numbers[n], exponent) for n, exponent in exponents], turn, weight)
                for exponents, turn, weight in numbered
            ], form.denominator
        terms = ring.terms(form)
        denominator = lcm(*(weight.denominator for weight in terms.values()))
        return [
            (
                [(self._numbers[symbol], plain(exponent)) for symbol, exponent in monomial.exponents],
                monomial.turn,
                weight.numerator * (denominator // weight.denominator),
            )
            for monomial, weight in terms.items()
        ], denominator

    def _read(self, terms: Iterable[NumberedTerm], scale: int) -> Waves:
        found: dict[Wave, int] = {}
        angular = {number for number, symbol in enumerate(self._symbols) if symbol.kind == "exponential"}
        for exponents, turn, weight in terms:
            exponents.sort()
            angle = tuple([item for item in exponents if item[0] in angular])
            if angle and angle[0][1] < 0:
                continue  # its conjugate stands for both
            powers = tuple([item for item in exponents if item[0] not in angular])
            weight *= scale
            _put(found, angle, _steps(turn), powers, 2 * weight if angle else weight)
        return found

    def derivative(self, waves: Waves, joint: int) -> Waves:
        """∂/∂q of a joint variable, whether it is an angle or a distance."""
        angular, linear = 2 * (joint - 1), 2 * (joint - 1) + 1
        found: dict[Wave, int] = {}
        for (angle, turn, powers), weight in waves.items():
            for number, factor in angle:
                if number == angular:
                    _put(found, angle, turn + _QUARTER_TURN, powers, weight * int(factor))
            for number, exponent in powers:
                if number == linear:
                    lowered = tuple((n, e - 1 if n == linear else e) for n, e in powers)
                    kept = tuple(item for item in lowered if item[1])
                    _put(found, angle, turn, kept, weight * int(exponent))
        return found

    def nested(self, waves: Waves, factor: Fraction = Fraction(1)) -> Nested:
        """A multiple as it is written: what stands before one cosine in parentheses, shared factors out."""
        groups: dict[tuple[Exponents, Rational], list[tuple[Exponents, int]]] = {}
        for (angle, turn, powers), weight in waves.items():
            groups.setdefault((angle, turn), []).append((powers, weight))
        factor /= self.denominator
        top, bottom = factor.numerator, factor.denominator
        arena, summands = self._arena, []
        for key in sorted(groups):
            terms: Nested = tuple(
                (quotient(number * weight * top, bottom), names)
                for (number, names), weight in [(self._power(p), w) for p, w in sorted(groups[key])]
            )
            cosine = self._cosine(key)
            if key[0]:
                summands.append(arena.product(terms, cosine))
            else:
                summands += [arena.product((term,), cosine) for term in terms]
        return arena.sum(*summands)

    def symbol(self, expression: Expression) -> Nested:
        """A symbol beside the waves, such as a joint's rate."""
        return self._arena.read(expression)

    def negative(self, nested: Nested) -> Nested:
        """What was written, with the other sign."""
        return self._arena.negative(nested)

    def total(self, parts: Iterable[tuple[Nested, Nested]]) -> Nested:
        """The sum of some products."""
        return self._arena.sum(*(self._arena.product(a, b) for a, b in parts))

    def expression(self, nested: Nested) -> Expression:
        """What was written, as an expression."""
        return self._arena.expression(nested)

    def _power(self, powers: Exponents) -> Term:
        known = self._powers.get(powers)
        if known is None:
            product = multiply(power(symbol_expression(self._symbols[n]), Fraction(e)) for n, e in powers)
            known = self._powers[powers] = self._arena.term(self._arena.read(product))
        return known

    def _cosine(self, key: tuple[Exponents, Rational]) -> Nested:
        known = self._cosines.get(key)
        if known is None:
            angle, turn = key
            terms = [pi_times(Fraction(2 * turn) / ORDER)]
            for number, factor in angle:
                monomial = self._symbols[number].of
                assert isinstance(monomial, Monomial)
                terms.append(multiply((Number(Fraction(factor)), real_part(monomial))))
            known = self._arena.read(cosine_and_sine(angle_of(add(terms)))[0])
            self._cosines[key] = known
        return known

    def _number(self, symbol: RingSymbol) -> None:
        self._numbers[symbol] = len(self._symbols)
        self._symbols.append(symbol)


@cache
def _steps(turn: Fraction) -> Rational:
    return plain(turn * ORDER)


def combined(parts: Iterable[tuple[int, Waves]]) -> Waves:
    """The sum of some multiples of functions."""
    found: dict[Wave, int] = {}
    for factor, waves in parts:
        for wave, weight in waves.items():
            total = found.get(wave, 0) + factor * weight
            if total:
                found[wave] = total
            else:
                del found[wave]
    return found


def _put(found: dict[Wave, int], angle: Exponents, turn: Rational, powers: Exponents, weight: int) -> None:
    turn %= ORDER
    if turn >= _HALF_TURN:
        turn, weight = turn - _HALF_TURN, -weight
    if angle or turn != _QUARTER_TURN:
        wave = Wave(angle, turn, powers)
        total = found.get(wave, 0) + weight
        if total:
            found[wave] = total
        else:
            del found[wave]
