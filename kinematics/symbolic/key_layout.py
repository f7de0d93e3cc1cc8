"""The exponents of a term, packed into the bits of one integer.

The lowest bits hold the 24th roots of unity; above them every symbol, and every denominator of its exponents,
has a place of its own. Adding two keys adds all exponents at once.
"""

from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

from kinematics.symbolic.elements import ZERO_FORM, Exponents, Form, RingSymbol

ROOT_MASK = 0xFF
ROOT_BITS = 8
HALF_TURN = 12
QUARTER_TURN = 6
ORDER = 24
"""A root of unity is counted in twenty-fourths of a turn, π/12 each, in the lowest eight bits of a key."""
_ROOM_BITS = 40
"""Bits of an exponent beyond those that it has: half of them let products grow, half guard the next place."""


@dataclass(slots=True)
class KeyField:
    """Where a key holds an exponent of one symbol.

    Attributes:
        symbol: which one.
        shift: its lowest bit.
        width: how many bits it has.
        unit: what the exponent is counted in.
        degree: the power of the symbol that is `value`; 0 if there is none.
        value: what that power is.
    """

    symbol: RingSymbol
    shift: int
    width: int
    unit: Fraction
    degree: int = 0
    value: Form = ZERO_FORM

    @property
    def room(self) -> int:
        """The largest exponent that is let in, far from what would run into the next place."""
        return 1 << (self.width - _ROOM_BITS // 2)

    def exponent(self, key: int) -> int:
        """Return the exponent that a key holds here, in units."""
        # exponents in lower places may be negative together: they have then borrowed from this one
        borrowed = key >> (self.shift - 1) & 1
        return _signed((key >> self.shift) + borrowed, self.width)


@dataclass(slots=True)
class KeyLayout:
    """The places of one ring.

    Attributes:
        places: all of them, from the lowest bits up.
    """

    places: list[KeyField] = field(default_factory=list)
    _known: dict[tuple[RingSymbol, Fraction], KeyField] = field(default_factory=dict)
    _shifts: list[int] = field(default_factory=list)
    _end: int = ROOT_BITS

    def key(self, symbol: RingSymbol, exponent: Fraction, degree: int, value: Form) -> int:
        """Return the key of symbol^exponent.

        With a degree, of a symbol whose power of that degree is `value`.
        """
        unit = Fraction(1, exponent.denominator)
        place = self._known.get((symbol, unit))
        width = exponent.numerator.bit_length() + _ROOM_BITS
        if place is None or width > place.width:
            place = KeyField(symbol, self._end, width, unit, degree, value)
            self.places.append(place)
            self._shifts.append(place.shift)
            self._known[symbol, unit] = place
            self._end += width
        return exponent.numerator << place.shift

    def place(self, symbol: RingSymbol) -> KeyField:
        """Return the place of a symbol whose exponents are whole."""
        return self._known[symbol, Fraction(1)]

    @property
    def related(self) -> list[KeyField]:
        """The places of symbols one power of which is something else."""
        return [place for place in self.places if place.degree]

    @property
    def order(self) -> int:
        """The order of the roots of unity in use."""
        return lcm(ORDER, *(place.unit.denominator for place in self._roots))

    @property
    def are_normal(self) -> bool:
        """Whether keys that differ, roots of unity aside, are different exponents."""
        symbols = [place.symbol for place in self.places if place.symbol.kind != "root"]
        return len(set(symbols)) == len(symbols) and all(symbol.kind != "radical" for symbol in symbols)

    @property
    def are_numbers(self) -> bool:
        """Whether every symbol has one place, whole exponents, and no relation to others."""
        plain = all(
            place.unit == 1 and not place.degree and place.symbol.kind in ("power", "exponential")
            for place in self.places
        )
        return plain and self.are_normal

    def split(self, kind: str) -> tuple[int, int]:
        """Return what makes a key's exponents non-negative when added, and the mask of a kind's symbols."""
        bias = mask = 0
        for place in self.places:
            bias += 1 << (place.shift + place.width - 1)
            if place.symbol.kind == kind:
                mask |= ((1 << place.width) - 1) << place.shift
        return bias, mask

    def numbered(self, key: int) -> list[tuple[int, int]]:
        """Return the exponents in a key without roots of unity, each with the number of its place."""
        found = []
        shifts = self._shifts
        while key:
            # what is below the lowest bit is zero: the next exponent that is not stands there
            number = bisect_right(shifts, (key & -key).bit_length() - 1) - 1
            place = self.places[number]
            raw = _signed(key >> place.shift, place.width)
            key -= raw << place.shift
            found.append((number, raw))
        return found

    @property
    def _roots(self) -> list[KeyField]:
        return [place for place in self.places if place.symbol.kind == "root"]

    def by_rest(self, coefficients: Mapping[int, int], order: int) -> dict[int, dict[int, int]]:
        """Return the coefficients by what the keys hold besides roots of unity, and by the roots' turn."""
        roots = self._roots
        found: dict[int, dict[int, int]] = {}
        for key, coefficient in coefficients.items():
            step = (key & ROOT_MASK) * (order // ORDER)
            rest = key - (key & ROOT_MASK)
            for place in roots:
                exponent = place.exponent(key)
                rest -= exponent << place.shift
                step += exponent * (order // place.unit.denominator)
            by_step = found.setdefault(rest, {})
            step %= order
            by_step[step] = by_step.get(step, 0) + coefficient
        return found

    def exponents(self, key: int) -> tuple[Exponents, Fraction]:
        """Return the exponents in a key without roots of unity, and what pairs of equal square roots give."""
        factor = Fraction(1)
        found: dict[RingSymbol, Fraction] = {}
        for number, raw in self.numbered(key):
            place = self.places[number]
            exponent = raw * place.unit if place.unit != 1 else Fraction(raw)
            found[place.symbol] = found[place.symbol] + exponent if place.symbol in found else exponent
        for symbol, exponent in list(found.items()):
            if symbol.kind == "radical":
                pairs, rest = divmod(exponent.numerator, 2)
                assert isinstance(symbol.of, int)
                factor *= Fraction(symbol.of) ** pairs
                found[symbol] = Fraction(rest)
        return frozenset(item for item in found.items() if item[1]), factor


def _signed(bits: int, width: int) -> int:
    """Return the number whose lowest bits, in two's complement, are these."""
    half = 1 << (width - 1)
    return ((bits & (half + half - 1)) ^ half) - half
