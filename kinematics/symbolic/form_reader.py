"""From expression trees to forms: sines and cosines become exponentials, roots of numbers roots of unity."""

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache

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
    pi_fraction,
    pi_times,
)
from kinematics.symbolic.elements import (
    IMAGINARY_UNIT,
    ONE_FORM,
    UNIT,
    ZERO_FORM,
    Form,
    Monomial,
    RingSymbol,
    content,
)
from kinematics.symbolic.ring import Ring
from kinematics.symbolic.roots import has_large_prime
from kinematics.symbolic.surds import algebraic_reciprocal, denested_root, root_of_rational, tidy

PI_SYMBOL = RingSymbol("power", Pi())
_PI_MONOMIAL = Monomial(Fraction(0), frozenset({(PI_SYMBOL, Fraction(1))}))
_STEPS = 24
_HALF_TURN = 12  # Steps of a turn, and of half of one: multiples of π/12 have cosines that are written out.


@dataclass(slots=True)
class FormReader:
    """Reads expressions into one ring.

    Attributes:
        ring: where the forms live.
        decisive: whether every form that was found not to vanish is certainly not the zero function.
        arcs_taken_apart: whether the cosine of an arctangent is the quotient that it is; else the arctangent
            stays an angle like any other, and products with it stay short.
    """

    ring: Ring = field(default_factory=Ring)
    decisive: bool = True
    arcs_taken_apart: bool = True
    _constant_exponentials: bool = False
    _known: dict[Expression, Form] = field(default_factory=dict)
    _circle: dict[Expression, tuple[Form, Form]] = field(default_factory=dict)
    _arcs: dict[Monomial, tuple[Form, Form]] = field(default_factory=dict)

    def form(self, expression: Expression) -> Form:
        """Return the form of an expression.

        Raises:
            FormSizeError: expanding it would pass the ring's limit.
            ZeroDivisionError: it divides by zero.
        """
        known = self._known.get(expression)
        if known is None:
            known = self._known[expression] = self._read(expression)
        return known

    def cosine_and_sine(self, angle: Expression) -> tuple[Form, Form]:
        """Return the cosine and sine of an angle [rad]."""
        known = self._circle.get(angle)
        if known is None:
            turns = pi_fraction(angle)
            if turns is not None and _HALF_TURN % turns.denominator == 0:
                known = _twelfths(int(turns * _HALF_TURN) % _STEPS)
            else:
                known = self._cosine_and_sine(self.form(angle))
            self._circle[angle] = known
        return known

    def exponentials(self, angle: Expression) -> tuple[Form, Form]:
        """Return e^(i·angle) and e^(-i·angle) of an angle [rad].

        One term each, unless it is an arctangent.
        """
        return self._pair(self.form(angle))

    def half_turns(self, angle: Expression) -> Fraction | None:
        """Return the r of an angle r·π, such as that of atan2(1, 1); None of any other angle."""
        try:
            terms = self.ring.terms(self.form(angle))
        except ZeroDivisionError:
            return None
        if not terms:
            return Fraction(0)
        return terms[_PI_MONOMIAL] if terms.keys() == {_PI_MONOMIAL} else None

    def vanishes(self, form: Form) -> bool:
        """Return whether a form is zero; a doubtful no is noted in `decisive`."""
        if self.ring.is_zero(form):
            return True
        if not self.is_exact(form):
            self.decisive = False
        return False

    def is_exact(self, form: Form) -> bool:
        """Return whether forms that differ from this one are certainly other functions.

        That π and e^i are independent is known from Schanuel's conjecture only: they may not stand together.
        """
        if self._constant_exponentials:
            symbols = (symbol for monomial in self.ring.terms(form) for symbol, _ in monomial.exponents)
            if any(symbol == PI_SYMBOL for symbol in symbols):
                return False
        return self.ring.complete

    def _cosine_and_sine(self, angle: Form) -> tuple[Form, Form]:
        ring, half = self.ring, Fraction(1, 2)
        forward, backward = self._pair(angle)
        cosine = ring.scale(ring.add(forward, backward), half)
        sine = ring.scale(ring.multiply(ring.turn(Fraction(3, 4)), ring.add(forward, backward, -1)), half)
        if ring.is_constant(forward):
            return tidy(ring, cosine), tidy(ring, sine)
        return cosine, sine

    def _pair(self, angle: Form) -> tuple[Form, Form]:
        """e^(i·angle) and e^(-i·angle)."""
        forward = self._exponential(angle)
        if self.ring.is_term(forward):
            return forward, self.ring.power(forward, -1)
        return forward, self._exponential(self.ring.scale(angle, -1))

    def _exponential(self, angle: Form) -> Form:
        """e^(i·angle)."""
        ring, result, turn = self.ring, ONE_FORM, Fraction(0)
        for monomial, weight in ring.terms(angle).items():
            arc = self._arcs.get(monomial)
            if monomial == _PI_MONOMIAL:
                turn += weight / 2
            elif arc is not None and weight.denominator == 1:
                result = ring.multiply(result, ring.power(arc[weight < 0], abs(weight.numerator)))
            else:
                self._note(monomial)
                result = ring.multiply(result, ring.symbol(RingSymbol("exponential", monomial), weight))
        if has_large_prime(turn):
            ring.complete = False
        return ring.multiply(result, ring.turn(turn))

    def _note(self, monomial: Monomial) -> None:
        """Remember when exponentials are used about which independence isn't known."""
        kinds = {symbol.kind for symbol, _ in monomial.exponents}
        names = {symbol.of for symbol, _ in monomial.exponents if symbol.kind == "power"}
        if "exponential" in kinds or names == {PI_SYMBOL.of}:
            self.ring.complete = False
        elif not names:
            self._constant_exponentials = True

    def _read(self, expression: Expression) -> Form:
        ring = self.ring
        match expression:
            case Number(value):
                return ring.rational(value)
            case Pi() | Parameter() | JointVariable():
                return ring.symbol(RingSymbol("power", expression))
            case Sum(terms):
                total = ZERO_FORM
                for term in terms:
                    total = ring.add(total, self.form(term))
                return total
            case Product(factors):
                result = ONE_FORM
                for factor in factors:
                    result = ring.multiply(result, self.form(factor))
                return result
            case Power(base, exponent):
                return self._power(self.form(base), exponent)
            case Call(function, arguments):
                return self._call(function, arguments)

    def _call(self, function: Function, arguments: tuple[Expression, ...]) -> Form:
        match function:
            case Function.COS:
                return self.cosine_and_sine(arguments[0])[0]
            case Function.SIN:
                return self.cosine_and_sine(arguments[0])[1]
            case Function.TAN:
                cosine, sine = self.cosine_and_sine(arguments[0])
                return self.ring.multiply(sine, self._integer_power(cosine, -1))
        values = tuple(self.form(argument) for argument in arguments)
        match function:
            case Function.SQRT:
                return self._square_root(values[0])
            case Function.ABS:
                return self._square_root(self.ring.power(values[0], 2))
        return self._arc(function, values)

    def _power(self, base: Form, exponent: Fraction) -> Form:
        if exponent.denominator == 1:
            return self._integer_power(base, exponent.numerator)
        if exponent.denominator == 2:
            return self._integer_power(self._square_root(base), exponent.numerator)
        root = self._opaque("root", (exponent.denominator,), base, degree=exponent.denominator)
        return self._integer_power(root, exponent.numerator)

    def _integer_power(self, base: Form, exponent: int) -> Form:
        if exponent >= 0 or self.ring.is_term(base):
            return self.ring.power(base, exponent)
        return self.ring.power(self._reciprocal(base), -exponent)

    def _reciprocal(self, base: Form) -> Form:
        ring, terms = self.ring, self.ring.terms(base)
        if not terms:
            raise ZeroDivisionError
        base = ring.form(terms)
        if ring.is_term(base):
            return ring.power(base, -1)
        inverse = algebraic_reciprocal(ring, terms)
        if inverse is not None:
            return inverse
        factor = content(terms)
        divisor = self._opaque("divisor", (), ring.scale(base, 1 / factor), degree=1)
        return ring.scale(ring.power(divisor, -1), 1 / factor)

    def _square_root(self, base: Form) -> Form:
        ring, terms = self.ring, self.ring.terms(base)
        if not terms:
            return ZERO_FORM
        if terms.keys() == {UNIT} and terms[UNIT] > 0:
            return root_of_rational(ring, terms[UNIT])
        denested = denested_root(ring, terms)
        if denested is not None:
            return denested
        factor = abs(content(terms))
        root = self._opaque("root", (2,), ring.scale(ring.form(terms), 1 / factor), degree=2)
        return ring.multiply(root_of_rational(ring, factor), root)

    def _arc(self, function: Function, values: tuple[Form, ...]) -> Form:
        """An inverse trigonometric function: an angle whose cosine and sine are known."""
        ring, x = self.ring, values[0]
        match function:
            case Function.ASIN:
                cosine, sine = self._square_root(ring.add(ONE_FORM, ring.power(x, 2), -1)), x
            case Function.ACOS:
                cosine, sine = x, self._square_root(ring.add(ONE_FORM, ring.power(x, 2), -1))
            case Function.ATAN:
                cosine, sine = self._on_circle(ONE_FORM, x)
            case _:
                if not ring.terms(x) and not ring.terms(values[1]):
                    return ZERO_FORM
                cosine, sine = self._on_circle(values[1], x)
        imaginary = ring.multiply(IMAGINARY_UNIT, sine)
        pair = ring.add(cosine, imaginary), ring.add(cosine, imaginary, -1)
        exact = self._exact_turn(pair[0])
        if exact is not None:
            return ring.scale(ring.symbol(PI_SYMBOL), 2 * exact)
        angle = self._opaque(function.value, (), *values)
        ((monomial, _),) = ring.terms(angle).items()
        if self.arcs_taken_apart:
            self._arcs[monomial] = pair
        return angle

    def _on_circle(self, x: Form, y: Form) -> tuple[Form, Form]:
        ring = self.ring
        radius = self._square_root(ring.add(ring.power(x, 2), ring.power(y, 2)))
        inverse = self._integer_power(radius, -1)
        return ring.multiply(x, inverse), ring.multiply(y, inverse)

    def _exact_turn(self, point: Form) -> Fraction | None:
        """The turn in (-1/2, 1/2] of a point of the unit circle, if it is a multiple of 1/24."""
        ring = self.ring
        if not ring.is_constant(point):
            return None
        terms = ring.terms(point)
        for step in range(1 - _STEPS // 2, _STEPS // 2 + 1):
            if ring.terms(ring.turn(Fraction(step, _STEPS))) == terms:
                return Fraction(step, _STEPS)
        return None

    def _opaque(self, name: str, detail: tuple[int, ...], *arguments: Form, degree: int = 0) -> Form:
        """A symbol for what cannot be taken apart, named by the normal forms of its arguments."""
        self.ring.complete = False
        key = (name, detail, *(frozenset(self.ring.terms(argument).items()) for argument in arguments))
        value = arguments[0] if degree else ZERO_FORM
        return self.ring.symbol(RingSymbol("power", key), degree=degree, value=value)


@cache
def _twelfths(steps: int) -> tuple[Form, Form]:
    """Cosine and sine of a multiple of π/12: roots of unity alone, and so the same in every ring."""
    reader = FormReader()
    cosine, sine = reader._cosine_and_sine(reader.form(pi_times(Fraction(steps, _HALF_TURN))))
    return _shared(cosine), _shared(sine)


def _shared(form: Form) -> Form:
    """The form, or the very object that 0 or 1 is known by."""
    return next((known for known in (ZERO_FORM, ONE_FORM) if known == form), form)
