"""Real functions of joint variables as finite Fourier series, which are differentiated term by term.

A `FourierTerm` is Π p^e · cos(Σ k_i q_i + ⋯ + turn); a function is an integer weight for each term, over a
denominator that all functions of a table share. A real element of the ring takes this form when each
exponential is combined with its conjugate.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from math import lcm
from typing import NamedTuple, TypeAlias

from kinematics.expressions import JointVariable, Number, Parameter, add, multiply, power
from kinematics.symbolic.angles import Angle, angle_of, cosine_and_sine
from kinematics.symbolic.canonical import real_part, symbol_expression
from kinematics.symbolic.elements import Form, Monomial, RingSymbol, Terms, order_text
from kinematics.symbolic.key_layout import ORDER
from kinematics.symbolic.nested import Arena
from kinematics.symbolic.ring import Ring
from kinematics.symbolic.roots import basis_steps
from kinematics.symbolic.terms import Nested, Rational, Term, plain, quotient

Exponents: TypeAlias = tuple[tuple[int, Rational], ...]
WeightedTerm: TypeAlias = tuple[Exponents, Rational, Exponents, int]
"""Angle, turn and powers of a `FourierTerm`, and its weight."""

_HALF_TURN, _QUARTER_TURN = 12, 6  # Turns are counted in twenty-fourths, as in the ring.


class FourierTerm(NamedTuple):
    """A term without its weight; symbols are known by their numbers.

    Attributes:
        angle: what each angle in the cosine is multiplied by; the first is positive.
        turn: what is added to them, in 24ths of a turn, at least 0 and less than 12.
        powers: what stands before the cosine.
    """

    angle: Exponents
    turn: Rational
    powers: Exponents


FourierSeries: TypeAlias = Mapping[FourierTerm, int]


class SeriesTable:
    """Some elements of a ring as Fourier series.

    Attributes:
        series: the elements.
        denominator: what their weights are divided by.
        arena: in which they are written.

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
        self.arena = Arena()
        self._n_joints = n_joints
        for joint in range(1, n_joints + 1):
            variable = RingSymbol("power", JointVariable(joint))
            monomial = Monomial(Fraction(0), frozenset({(variable, Fraction(1))}))
            self._number(RingSymbol("exponential", monomial))
            self._number(variable)
        for name in names:
            self.arena.read(Parameter(name))
            self._number(RingSymbol("power", Parameter(name)))
        # what stands in a set comes in no order
        for symbol in sorted(set(ring.symbols) - self._numbers.keys(), key=order_text):
            self._number(symbol)
        self._angular = {n for n, symbol in enumerate(self._symbols) if symbol.kind == "exponential"}
        self._places = [self._numbers[symbol] for symbol in ring.symbols]
        self._exponents: dict[int, Exponents] = {}
        found = [self._terms(ring, form) for form in forms]
        self.denominator = lcm(*(denominator for _, denominator in found))
        self.series: tuple[FourierSeries, ...] = tuple(
            _sum(terms, self.denominator // denominator) for terms, denominator in found
        )

    def _terms(self, ring: Ring, form: Form) -> tuple[Iterator[WeightedTerm], int]:
        """The terms of a form with whole weights over a denominator."""
        split = ring.split_terms(form)
        if split is not None:
            return self._split(ring, split), form.denominator
        terms = ring.terms(form)
        denominator = lcm(*(weight.denominator for weight in terms.values()))
        return self._parted(terms, denominator), denominator

    def _split(self, ring: Ring, terms: Iterable[tuple[int, int, int, int]]) -> Iterator[WeightedTerm]:
        known = self._exponents
        for angle_key, power_key, step, weight in terms:
            angle = known.get(angle_key)
            if angle is None:
                angle = self._numbered(ring, angle_key)
            if angle and angle[0][1] < 0:
                continue  # its conjugate stands for both
            powers = known.get(power_key)
            if powers is None:
                powers = self._numbered(ring, power_key)
            for turn, sign in basis_steps(step, ORDER):
                yield angle, _steps(turn), powers, weight * sign

    def _numbered(self, ring: Ring, key: int) -> Exponents:
        found = tuple(sorted([(self._places[n], exponent) for n, exponent in ring.exponents(key)]))
        self._exponents[key] = found
        return found

    def _parted(self, terms: Terms, denominator: int) -> Iterator[WeightedTerm]:
        for monomial, weight in terms.items():
            exponents = sorted((self._numbers[symbol], plain(e)) for symbol, e in monomial.exponents)
            angle = tuple([item for item in exponents if item[0] in self._angular])
            if not angle or angle[0][1] > 0:
                powers = tuple([item for item in exponents if item[0] not in self._angular])
                whole = weight.numerator * (denominator // weight.denominator)
                yield angle, _steps(monomial.turn), powers, whole

    def derivative(self, series: FourierSeries, joint: int) -> FourierSeries:
        """Return ∂/∂q of a joint variable, whether it is an angle or a distance."""
        angular, linear = 2 * (joint - 1), 2 * (joint - 1) + 1
        found: dict[FourierTerm, int] = {}
        for (angle, turn, powers), weight in series.items():
            for number, factor in angle:
                if number == angular:
                    _put(found, angle, turn + _QUARTER_TURN, powers, weight * int(factor))
            for number, exponent in powers:
                if number == linear:
                    lowered = tuple((n, e - 1 if n == linear else e) for n, e in powers)
                    kept = tuple(item for item in lowered if item[1])
                    _put(found, angle, turn, kept, weight * int(exponent))
        return found

    def nested(self, series: FourierSeries, factor: Fraction = Fraction(1)) -> Nested:
        """Return a multiple as it is written.

        What stands before one cosine in parentheses, shared factors out.
        """
        groups: dict[tuple[Exponents, Rational], list[tuple[Exponents, int]]] = {}
        for (angle, turn, powers), weight in series.items():
            key = angle, turn
            if key in groups:
                groups[key].append((powers, weight))
            else:
                groups[key] = [(powers, weight)]
        factor /= self.denominator
        top, bottom = factor.numerator, factor.denominator
        product, summands = self.arena.product, []
        for key, parts in sorted(groups.items()):
            parts.sort()
            terms: list[Term] = []
            for powers, weight in parts:
                number, names = self._powers.get(powers) or self._power(powers)
                share = _quotient(weight * top, bottom)
                terms.append((share if number == 1 else number * share, names))
            cosine = self._cosine(key)
            if key[0]:
                summands.append(product(tuple(terms), cosine))
            else:
                summands += [product((term,), cosine) for term in terms]
        return self.arena.sum(*summands)

    def total(self, parts: Iterable[tuple[Nested, Nested]]) -> Nested:
        """Return the sum of some products."""
        return self.arena.sum(*(self.arena.product(a, b) for a, b in parts))

    def _power(self, powers: Exponents) -> Term:
        product = multiply(power(symbol_expression(self._symbols[n]), Fraction(e)) for n, e in powers)
        found = self._powers[powers] = self.arena.term(self.arena.read(product))
        return found

    def _cosine(self, key: tuple[Exponents, Rational]) -> Nested:
        known = self._cosines.get(key)
        if known is None:
            known = self._cosines[key] = self.arena.read(cosine_and_sine(self._angle(*key))[0])
        return known

    def _angle(self, multiples: Exponents, turn: Rational) -> Angle:
        joints, others = [], []
        for number, factor in multiples:
            monomial, weight = self._symbols[number].of, _fraction(factor)
            assert isinstance(monomial, Monomial)
            if number < 2 * self._n_joints:
                joints.append((JointVariable(number // 2 + 1), weight))
            else:
                others.append(multiply((Number(weight), real_part(monomial))))
        found = Angle(half_turns=_fraction(turn) / _HALF_TURN, parts=tuple(joints))
        return found.plus(angle_of(add(others))) if others else found

    def _number(self, symbol: RingSymbol) -> None:
        self._numbers[symbol] = len(self._symbols)
        self._symbols.append(symbol)


_fraction = lru_cache(maxsize=256)(Fraction)
_quotient = lru_cache(maxsize=4096)(quotient)
"""Shared numbers: they are looked up and compared all the time, and one fraction is itself at a glance."""


@lru_cache(maxsize=4096)
def _steps(turn: Fraction) -> Rational:
    return plain(turn * ORDER)


def combined(parts: Iterable[tuple[int, FourierSeries]]) -> FourierSeries:
    """Return the sum of some multiples of functions."""
    found: dict[FourierTerm, int] = {}
    for factor, series in parts:
        for term, weight in series.items():
            total = found.get(term, 0) + factor * weight
            if total:
                found[term] = total
            else:
                del found[term]
    return found


def _sum(terms: Iterable[WeightedTerm], scale: int) -> FourierSeries:
    """The real function of which these are the terms whose angle is positive, or that have none."""
    found: dict[FourierTerm, int] = {}
    for angle, turn, powers, weight in terms:
        _put(found, angle, turn, powers, (2 * scale if angle else scale) * weight)
    return found


def _put(
    found: dict[FourierTerm, int], angle: Exponents, turn: Rational, powers: Exponents, weight: int
) -> None:
    turn %= ORDER
    if turn >= _HALF_TURN:
        turn, weight = turn - _HALF_TURN, -weight
    if angle or turn != _QUARTER_TURN:
        term = FourierTerm(angle, turn, powers)
        total = found.get(term, 0) + weight
        if total:
            found[term] = total
        else:
            del found[term]
