"""Arithmetic in the ring where every entry of a closed form lives.

An element (a `Form`) is a finite sum of terms

    c · ζ · √p ⋯ · L1^a L2^b ⋯ · e^(i(k1·q1 + k2·α + ⋯)),

c rational, ζ a root of unity, √p roots of primes, then powers of lengths (and of whatever cannot be taken
apart), and exponentials of joint variables and angles. Sines and cosines are (e^(iφ) ± e^(-iφ))/2, so every
trigonometric identity is an identity between such sums, and multiplication is addition of exponents: the
exponents of a term are packed into the bits of one integer, its key.

Keys mean something only within one `Ring`. `Ring.terms` writes a form without reference to the ring.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm

from kinematics.errors import Fault, FormSizeError
from kinematics.symbolic.elements import (
    IMAGINARY_UNIT,
    ONE_FORM,
    ZERO_FORM,
    Form,
    Monomial,
    RingSymbol,
    Terms,
)
from kinematics.symbolic.key_layout import HALF_TURN, ORDER, QUARTER_TURN, ROOT_BITS, ROOT_MASK, KeyLayout
from kinematics.symbolic.roots import basis_steps


@dataclass(slots=True)
class Ring:
    """Symbols in use, their places in a key, and the account of work done.

    Attributes:
        limit: products of terms that may be formed before a `FormSizeError`.
        complete: whether different normal forms are certainly different functions; symbols that cannot be
            taken apart (square roots of sums, arctangents of lengths) make it false.
    """

    limit: int = 200_000
    complete: bool = True
    _keys: KeyLayout = field(default_factory=KeyLayout)
    _spent: int = 0

    def rational(self, value: Fraction | int) -> Form:
        """Return a rational number."""
        if not value:
            return ZERO_FORM
        return Form({0: value.numerator}, value.denominator)

    def turn(self, turn: Fraction) -> Form:
        """Return the root of unity e^(2πi·turn)."""
        turn %= 1
        steps = turn * ORDER
        if steps.denominator != 1:
            return self.symbol(RingSymbol("root", None), turn)
        if steps >= HALF_TURN:
            return Form({int(steps) - HALF_TURN: -1})
        return Form({int(steps): 1})

    def symbol(
        self,
        symbol: RingSymbol,
        exponent: Fraction = Fraction(1),
        *,
        degree: int = 0,
        value: Form = ZERO_FORM,
    ) -> Form:
        """Return symbol^exponent; with a degree, a symbol whose power of that degree is `value`."""
        return Form({self._keys.key(symbol, exponent, degree, value): 1})

    def add(self, a: Form, b: Form, sign: int = 1) -> Form:
        """Return the sum a + sign·b."""
        if not b.coefficients:
            return a
        if not a.coefficients and sign == 1:
            return b
        da, db = a.denominator, b.denominator
        common = da if da == db else da * db // gcd(da, db)
        scale = common // da
        out = dict(a.coefficients) if scale == 1 else {k: c * scale for k, c in a.coefficients.items()}
        scale = sign * (common // db)
        for key, coefficient in b.coefficients.items():
            total = out.get(key, 0) + coefficient * scale
            if total:
                out[key] = total
            else:
                del out[key]
        return Form(out, common)

    def multiply(self, a: Form, b: Form) -> Form:
        """Return the product a · b."""
        left, right = a.coefficients, b.coefficients
        if not left or not right:
            return ZERO_FORM
        if a is ONE_FORM:
            return b
        if b is ONE_FORM:
            return a
        self._spend(len(left) * len(right))
        if len(left) == 1 or len(right) == 1:
            return _by_term(left, right, a.denominator * b.denominator)
        out: dict[int, int] = {}
        for key_a, x in left.items():
            for key_b, y in right.items():
                key, product = key_a + key_b, x * y
                if key & ROOT_MASK >= HALF_TURN:
                    key, product = key - HALF_TURN, -product
                out[key] = out.get(key, 0) + product
        return _lowest(out, a.denominator * b.denominator)

    def scale(self, a: Form, factor: Fraction | int) -> Form:
        """Return a rational multiple of a form."""
        if not factor:
            return ZERO_FORM
        numerator = factor.numerator
        out = {k: c * numerator for k, c in a.coefficients.items()}
        return _lowest(out, a.denominator * factor.denominator)

    def turned(self, circle: tuple[Form, Form], x: Form, y: Form) -> tuple[Form, Form]:
        """Return the coordinates of (x + i·y) e^(iφ), where x, y and φ are real.

        `circle` is e^(iφ) and e^(-iφ).
        """
        if not (x.coefficients or y.coefficients):
            return x, y
        if circle[0] == IMAGINARY_UNIT:  # right angles are the usual ones
            return self.scale(y, -1), x
        if circle[1] == IMAGINARY_UNIT:
            return y, self.scale(x, -1)
        across = self.multiply(IMAGINARY_UNIT, y)
        forward = self.multiply(circle[0], self.add(x, across))
        backward = self.multiply(circle[1], self.add(x, across, -1))
        common = lcm(forward.denominator, backward.denominator)
        first, second = dict[int, int](), dict[int, int]()
        for form, sign in (forward, 1), (backward, -1):
            scale = common // form.denominator
            for key, coefficient in form.coefficients.items():
                coefficient *= scale
                first[key] = first.get(key, 0) + coefficient
                # of (F - B) / 2i: a quarter turn back
                if key & ROOT_MASK < QUARTER_TURN:
                    key += QUARTER_TURN
                    coefficient = -coefficient
                else:
                    key -= QUARTER_TURN
                second[key] = second.get(key, 0) + sign * coefficient
        return _lowest(first, 2 * common), _lowest(second, 2 * common)

    def replaced(self, a: Form, symbol: RingSymbol, values: Sequence[Form]) -> Form:
        """Return a form with values[k - 1] in the place of symbol^k."""
        place = self._keys.place(symbol)
        common = lcm(*(value.denominator for value in values))
        scaled = [
            [(key, weight * (common // value.denominator)) for key, weight in value.coefficients.items()]
            for value in values
        ]
        out: dict[int, int] = {}
        for key, coefficient in a.coefficients.items():
            number = place.exponent(key)
            if not number:
                out[key] = out.get(key, 0) + coefficient * common
                continue
            key -= number << place.shift
            self._spend(len(scaled[number - 1]))
            for more, weight in scaled[number - 1]:
                total, product = key + more, coefficient * weight
                if total & ROOT_MASK >= HALF_TURN:
                    total, product = total - HALF_TURN, -product
                out[total] = out.get(total, 0) + product
        return _lowest(out, a.denominator * common)

    def power(self, a: Form, exponent: int) -> Form:
        """Return a non-negative integer power, or any integer power of a single term."""
        if exponent < 0:
            a, exponent = self._reciprocal_of_term(a), -exponent
        if exponent > 1:
            self._check_exponents(a, exponent)
        result = ONE_FORM
        while exponent:
            if exponent & 1:
                result = self.multiply(result, a)
            exponent >>= 1
            if exponent:
                a = self.multiply(a, a)
        return result

    def is_term(self, a: Form) -> bool:
        """Return whether a form is one term, which has a reciprocal."""
        return len(a.coefficients) == 1

    def _reciprocal_of_term(self, a: Form) -> Form:
        ((key, coefficient),) = a.coefficients.items()
        steps = key & ROOT_MASK
        inverse, sign = -(key - steps), -1 if coefficient < 0 else 1
        if steps:
            inverse, sign = inverse + HALF_TURN - steps, -sign
        return _lowest({inverse: sign * a.denominator}, abs(coefficient))

    def is_constant(self, a: Form) -> bool:
        """Return whether a form is a combination of 24th roots of unity, seen from its keys alone."""
        return not any(key >> ROOT_BITS for key in a.coefficients)

    def is_zero(self, a: Form) -> bool:
        """Return whether a form is zero; denominators are cleared first, for they never are."""
        if len(a.coefficients) < 2:
            return not a.coefficients
        parts = self._parts(self._cleared(a))
        if not parts or self._keys.are_normal:
            return not parts
        return not self._merged(parts, 1)

    def terms(self, a: Form) -> Terms:
        """Return a form in its normal form: monomials in the basis, and their rational coefficients."""
        return self._merged(self._parts(self._reduced(a)), a.denominator)

    def split_terms(self, a: Form) -> Iterator[tuple[int, int, int, int]] | None:
        """Return the terms of a form, unreduced; None if its symbols have roots or relations.

        Yields:
            The key of its exponentials and that of its powers, which `exponents` reads; the root of unity in
            24ths of a turn; the coefficient over the form's denominator.
        """
        if not self._keys.are_numbers:
            return None
        bias, mask = self._keys.split("exponential")
        angular = bias & mask
        return (
            (angle - angular, (key & ~ROOT_MASK) - angle + angular, key & ROOT_MASK, coefficient)
            for key, coefficient in a.coefficients.items()
            for angle in ((key + bias) & mask,)
        )

    def exponents(self, key: int) -> list[tuple[int, int]]:
        """Return the exponents in a key without roots of unity, each with its symbol's place in `symbols`."""
        return self._keys.numbered(key)

    @property
    def symbols(self) -> list[RingSymbol]:
        """The symbols in use, by their numbers."""
        return [place.symbol for place in self._keys.places]

    def _parts(self, a: Form) -> dict[int, dict[Fraction, int]]:
        """What stands beside each key without roots of unity: a sum of roots of unity in the basis."""
        order = self._keys.order
        found = {}
        for rest, by_step in self._keys.by_rest(a.coefficients, order).items():
            reduced: dict[Fraction, int] = {}
            for step, coefficient in by_step.items():
                for piece, sign in basis_steps(step, order):
                    reduced[piece] = reduced.get(piece, 0) + sign * coefficient
            reduced = {piece: coefficient for piece, coefficient in reduced.items() if coefficient}
            if reduced:
                found[rest] = reduced
        return found

    def _merged(self, parts: dict[int, dict[Fraction, int]], denominator: int) -> Terms:
        """The parts as terms; keys that are the same exponents are added."""
        out: Terms = {}
        for rest, reduced in parts.items():
            exponents, factor = self._keys.exponents(rest)
            for piece, coefficient in reduced.items():
                monomial = Monomial(piece, exponents)
                weight = Fraction(coefficient, denominator)
                if factor != 1:
                    weight *= factor
                out[monomial] = out[monomial] + weight if monomial in out else weight
        return {monomial: weight for monomial, weight in out.items() if weight}

    def form(self, terms: Terms) -> Form:
        """Return the form of which `terms` is the normal form."""
        total = ZERO_FORM
        for monomial, weight in terms.items():
            product = self.multiply(self.turn(monomial.turn), self.rational(weight))
            for symbol, exponent in monomial.exponents:
                product = self.multiply(product, self.symbol(symbol, exponent))
            total = self.add(total, product)
        return total

    def _reduced(self, a: Form) -> Form:
        """The form with every related symbol's exponent below the degree of its relation."""
        for place in reversed(self._keys.related):
            parts: dict[int, dict[int, int]] = {}
            for key, coefficient in a.coefficients.items():
                steps = max(place.exponent(key), 0) // place.degree
                rest = key - ((steps * place.degree) << place.shift)
                parts.setdefault(steps, {})[rest] = coefficient
            if any(parts.keys() - {0}):
                total = ZERO_FORM
                for steps, coefficients in parts.items():
                    replaced = self.multiply(
                        Form(coefficients, a.denominator), self.power(place.value, steps)
                    )
                    total = self.add(total, replaced)
                a = total
        return a

    def _cleared(self, a: Form) -> Form:
        """The form times the powers of related symbols that leave none in a denominator."""
        for place in reversed(self._keys.related):
            lowest = min([0, *map(place.exponent, a.coefficients)])
            if lowest:
                shift = (-lowest) << place.shift
                a = Form({key + shift: c for key, c in a.coefficients.items()}, a.denominator)
            a = self._reduced(a)
        return a

    def _check_exponents(self, a: Form, exponent: int) -> None:
        for place in self._keys.places:
            room = place.room
            if any(abs(place.exponent(key)) * exponent > room for key in a.coefficients):
                raise self._too_large()

    def _spend(self, products: int) -> None:
        self._spent += products
        if self._spent > self.limit:
            raise self._too_large()

    def _too_large(self) -> FormSizeError:
        return FormSizeError(Fault.at("form_too_large", limit=self.limit))


def _by_term(left: Mapping[int, int], right: Mapping[int, int], denominator: int) -> Form:
    """A product one factor of which is a single term: no two of its terms are alike."""
    ((step, by),), other = (left.items(), right) if len(left) == 1 else (right.items(), left)
    out: dict[int, int] = {}
    for key, coefficient in other.items():
        key += step
        if key & ROOT_MASK >= HALF_TURN:
            out[key - HALF_TURN] = -coefficient * by
        else:
            out[key] = coefficient * by
    return Form(out) if denominator == 1 else _lowest(out, denominator)


def _lowest(out: dict[int, int], denominator: int) -> Form:
    """The form without zero coefficients, in lowest terms."""
    kept = {key: coefficient for key, coefficient in out.items() if coefficient}
    if denominator == 1:
        return Form(kept)
    divisor = gcd(denominator, *kept.values())
    if divisor == 1:
        return Form(kept, denominator)
    return Form({key: coefficient // divisor for key, coefficient in kept.items()}, denominator // divisor)
