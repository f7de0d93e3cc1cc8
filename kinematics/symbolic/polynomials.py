"""Functions as polynomials in names, joint variables, and cosines and sines of angles.

Most entries that people write are such polynomials: products of lengths, c1, s23, c1^2. With s² = 1 − c² for
each angle a polynomial has one form alone, for names and the cosines of different angles are algebraically
independent; so equality of forms is equality of functions. What people write product by product stays short,
as it does not in exponentials (`kinematics.symbolic.ring`), where k cosines make 2^k terms. Quotients, roots,
arctangents and angles of constants other than quarter turns are left to the ring.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeAlias

from kinematics.expressions import (
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
    terms_of,
)

Rational: TypeAlias = int | Fraction
Polynomial: TypeAlias = Mapping[int, Rational]
"""Coefficients, none of them zero, by the exponents that are packed into a key; keys of one reader only."""
Symbol: TypeAlias = JointVariable | Parameter

PRODUCTS = 20_000  # Products of terms that one reader may form, some 5 ms.
_BITS = 12
FIELD = (1 << _BITS) - 1
_LARGEST_POWER = 64
_LARGEST_MULTIPLE = 24
"""Bits of an exponent; the largest power, and multiple of an angle, that are read: far below half a field,
so that products of what is read have room."""
_NOTHING: Polynomial = {}
ONE: Polynomial = {0: 1}
_QUARTERS: tuple[tuple[Polynomial, Polynomial], ...] = (
    (ONE, _NOTHING),
    (_NOTHING, ONE),
    ({0: -1}, _NOTHING),
    (_NOTHING, {0: -1}),
)
"""Cosine and sine of whole quarter turns."""


class _NotReadError(Exception):
    """An expression is no such polynomial, or has too many terms."""


@dataclass(slots=True)
class PolynomialReader:
    """Reads expressions into polynomials over one set of symbols.

    Attributes:
        parts: what an angle is counted in: its cosines and sines are those of q_i / parts.
    """

    parts: int = 1
    _names: dict[Symbol, int] = field(default_factory=dict)
    _angles: dict[Symbol, int] = field(default_factory=dict)
    _pairs: dict[Expression, tuple[Polynomial, Polynomial]] = field(default_factory=dict)
    _end: int = 0
    _beyond: int = 0
    _spent: int = 0

    def copy(self) -> "PolynomialReader":
        """Return a reader that knows the symbols of this one, and leaves it as it is."""
        return PolynomialReader(
            self.parts, dict(self._names), dict(self._angles), dict(self._pairs), self._end, self._beyond
        )

    def read(self, expression: Expression) -> Polynomial | None:
        """Return the polynomial of an expression; None if it is none, or one of very many terms."""
        try:
            return self._read(expression)
        except _NotReadError:
            return None

    def take(self, angle: Expression, name: Symbol) -> None:
        """Count an angle as a whole from now on, also where it is a sum: as the angle of this name."""
        self._pairs[angle] = self._multiple(name, 1)

    def factors(self, wholes: Mapping[Symbol, Expression]) -> dict[Expression, int]:
        """Return the place of the exponent in a key for each name, and each cosine and sine of an angle.

        Args:
            wholes: the angles that were taken as wholes, by their names.
        """
        found: dict[Expression, int] = {}
        found.update(self._names.items())
        for name, shift in self._angles.items():
            angle = wholes.get(name, name)
            found |= {call(Function.COS, angle): shift, call(Function.SIN, angle): shift + _BITS}
        return found

    def product(self, polynomials: Iterable[Polynomial]) -> Polynomial | None:
        """Return a product; None if it has very many terms."""
        result = ONE
        try:
            for polynomial in polynomials:
                result = self._times(result, polynomial)
        except _NotReadError:
            return None
        return result

    def degrees(self, polynomial: Polynomial) -> dict[Symbol, int]:
        """Return the degree in the sine and cosine of each angle and in each prismatic variable."""
        found: dict[Symbol, int] = {}
        for symbol, shift in self._angles.items():
            powers = [(key >> shift & FIELD) + (key >> shift + _BITS & FIELD) for key in polynomial]
            found[symbol] = max(powers, default=0)
        for symbol, shift in self._names.items():
            if type(symbol) is JointVariable and not found.get(symbol):
                found[symbol] = max((key >> shift & FIELD for key in polynomial), default=0)
        return {symbol: degree for symbol, degree in found.items() if degree}

    def normalised(self, polynomial: Polynomial) -> Polynomial:
        """Return a polynomial without its rational content's sign and size, and common powers of names."""
        common = 0
        for symbol, shift in self._names.items():
            if isinstance(symbol, Parameter):
                common += min(key >> shift & FIELD for key in polynomial) << shift
        lead = polynomial[max(polynomial)]
        return {key - common: Fraction(weight) / lead for key, weight in polynomial.items()}

    def _read(self, node: Expression) -> Polynomial:
        if type(node) is Product:
            return self._product(node.factors)
        if type(node) is Call:
            return self._call(node.function, node.arguments)
        if type(node) is Sum:
            return self._sum(node.terms)
        if type(node) is Number:
            value = node.value
            if value.denominator != 1:
                return {0: value}
            return {0: value.numerator} if value.numerator else _NOTHING
        if type(node) is Parameter or type(node) is JointVariable:
            return {1 << self._name(node): 1}
        if type(node) is Power:
            return self._power(node.base, node.exponent)
        raise _NotReadError

    def _product(self, factors: tuple[Expression, ...]) -> Polynomial:
        # factors of one term are put together by adding their keys, others by multiplying out
        key = 0
        weight: Rational = 1
        result = ONE
        for factor in factors:
            part = self._read(factor)
            if len(part) == 1:
                ((more, by),) = part.items()
                key, weight = key + more, weight * by
                if key & self._beyond:
                    result = self._times(result, self._lowered(key, weight))
                    key, weight = 0, 1
            elif not part:
                return _NOTHING
            else:
                result = part if result is ONE else self._times(result, part)
        return {key: weight} if result is ONE else self._times(result, {key: weight})

    def _sum(self, terms: tuple[Expression, ...]) -> Polynomial:
        total: dict[int, Rational] = {}
        for term in terms:
            for key, weight in self._read(term).items():
                total[key] = total.get(key, 0) + weight
        return {key: weight for key, weight in total.items() if weight}

    def _power(self, base: Expression, exponent: Fraction) -> Polynomial:
        if exponent.denominator != 1 or not 0 < exponent.numerator <= _LARGEST_POWER:
            raise _NotReadError
        value, result = self._read(base), ONE
        for _ in range(exponent.numerator):
            result = self._times(result, value)
        return result

    def _call(self, function: Function, arguments: tuple[Expression, ...]) -> Polynomial:
        if function is Function.COS:
            return self._pair(arguments[0])[0]
        if function is Function.SIN:
            return self._pair(arguments[0])[1]
        raise _NotReadError

    def _pair(self, angle: Expression) -> tuple[Polynomial, Polynomial]:
        """Return cosine and sine of an angle."""
        known = self._pairs.get(angle)
        if known is None:
            found = ONE, _NOTHING
            for term in terms_of(angle):
                found = self._turned(found, self._term(term))
            known = self._pairs[angle] = found
        return known

    def _term(self, term: Expression) -> tuple[Polynomial, Polynomial]:
        match term:
            case Number(value) if not value:
                return _QUARTERS[0]
            case Pi():
                return _QUARTERS[2]
            case Product((Number(weight), Pi())) if (weight * 2).denominator == 1:
                return _QUARTERS[(weight * 2).numerator % 4]
            case JointVariable() | Parameter():
                return self._multiple(term, self.parts)
            case Product((Number(weight), JointVariable() | Parameter() as symbol)):
                times = weight * self.parts
                if times.denominator == 1 and abs(times) <= _LARGEST_MULTIPLE:
                    return self._multiple(symbol, times.numerator)
        raise _NotReadError

    def _multiple(self, symbol: Symbol, times: int) -> tuple[Polynomial, Polynomial]:
        shift = self._angle(symbol)
        sense = 1 if times > 0 else -1
        once = {1 << shift: 1}, {1 << shift + _BITS: sense}
        found: tuple[Polynomial, Polynomial] = once
        for _ in range(abs(times) - 1):
            found = self._turned(found, once)
        return found

    def _turned(
        self, a: tuple[Polynomial, Polynomial], b: tuple[Polynomial, Polynomial]
    ) -> tuple[Polynomial, Polynomial]:
        """Return cosine and sine of a sum of two angles."""
        if a == _QUARTERS[0]:
            return b
        (c, s), (x, y) = a, b
        return (
            _added(self._times(c, x), self._times(s, y), -1),
            _added(self._times(s, x), self._times(c, y), 1),
        )

    def _times(self, a: Polynomial, b: Polynomial) -> Polynomial:
        self._spent += len(a) * len(b)
        if self._spent > PRODUCTS:
            raise _NotReadError
        out: dict[int, Rational] = {}
        for one, x in a.items():
            for other, y in b.items():
                key = one + other
                if key & self._beyond:
                    for lower, weight in self._lowered(key, x * y).items():
                        out[lower] = out.get(lower, 0) + weight
                else:
                    out[key] = out.get(key, 0) + x * y
        return {key: weight for key, weight in out.items() if weight}

    def _lowered(self, key: int, weight: Rational) -> Polynomial:
        """Return a term whose sines have exponents up to 2, by s² = 1 − c²."""
        found = {key: weight}
        for shift in self._angles.values():
            if key >> shift + _BITS & 2:
                squares, found = found, {}
                for square, by in squares.items():
                    lower = square - (2 << shift + _BITS)
                    found[lower] = by
                    found[lower + (2 << shift)] = -by
        if any(lower & self._beyond for lower in found):
            raise _NotReadError  # some exponent leaves its field
        return found

    def _name(self, symbol: Symbol) -> int:
        shift = self._names.get(symbol)
        if shift is None:
            shift = self._names[symbol] = self._field(1 << _BITS - 1)
        return shift

    def _angle(self, symbol: Symbol) -> int:
        shift = self._angles.get(symbol)
        if shift is None:
            shift = self._angles[symbol] = self._field(1 << _BITS - 1)
            self._field(FIELD - 1)
        return shift

    def _field(self, beyond: int) -> int:
        shift = self._end
        self._end += _BITS
        self._beyond |= beyond << shift
        return shift


def _added(a: Polynomial, b: Polynomial, sign: int) -> Polynomial:
    out = dict(a)
    for key, weight in b.items():
        out[key] = out.get(key, 0) + sign * weight
    return {key: weight for key, weight in out.items() if weight}
