"""Arithmetic of closed forms: turning a pair of coordinates is multiplying by cosine and sine."""

from fractions import Fraction
from random import Random

import pytest

from kinematics.errors import FormSizeError
from kinematics.symbolic.elements import IMAGINARY_UNIT, ONE_FORM, ZERO_FORM, Form, RingSymbol
from kinematics.symbolic.ring import Ring

HALF = Fraction(1, 2)


def circle_of(ring: Ring, angle: Fraction | str) -> tuple[Form, Form]:
    """e^(iφ) and e^(-iφ) of a part of a turn, or of a variable."""
    if isinstance(angle, str):
        symbol = RingSymbol("exponential", angle)
        return ring.symbol(symbol), ring.symbol(symbol, Fraction(-1))
    return ring.turn(angle), ring.turn(-angle)


@pytest.mark.parametrize("angle", [*(Fraction(k, 24) for k in range(24)), "q1"], ids=str)
@pytest.mark.parametrize("which", [(1, 0), (0, 1), (2, 3), (-1, 5)], ids=str)
def test_coordinates_turn_by_cosine_and_sine(angle: Fraction | str, which: tuple[int, int]) -> None:
    ring = Ring()
    length = ring.symbol(RingSymbol("power", "L1"))
    x = ring.add(ring.scale(length, which[0]), ring.rational(Fraction(which[0], 3)))
    y = ring.scale(length, Fraction(which[1], 7))
    forward, backward = circle_of(ring, angle)
    cosine = ring.scale(ring.add(forward, backward), HALF)
    sine = ring.multiply(ring.scale(ring.add(forward, backward, -1), -HALF), IMAGINARY_UNIT)
    first, second = ring.turned((forward, backward), x, y)
    assert ring.is_zero(ring.add(first, ring.add(ring.multiply(cosine, x), ring.multiply(sine, y), -1), -1))
    assert ring.is_zero(ring.add(second, ring.add(ring.multiply(sine, x), ring.multiply(cosine, y)), -1))
    square = ring.add(ring.multiply(cosine, cosine), ring.multiply(sine, sine))
    assert ring.is_zero(ring.add(square, ONE_FORM, -1))


def test_squares_of_squares_are_refused_before_an_exponent_runs_into_the_next() -> None:
    ring = Ring()
    square, other = ring.symbol(RingSymbol("power", "L1")), ring.symbol(RingSymbol("power", "L2"))

    def squared(times: int) -> Form:
        return square if not times else ring.power(squared(times - 1), 2)

    assert not ring.is_zero(ring.add(squared(20), other, -1))
    with pytest.raises(FormSizeError):
        squared(80)


@pytest.mark.parametrize("factor", [Fraction(1, 2), Fraction(3, 4), Fraction(-5, 6), Fraction(7, 3)], ids=str)
@pytest.mark.parametrize("times", [2, 3, 4])
def test_a_form_is_in_lowest_terms_whichever_way_it_was_made(factor: Fraction, times: int) -> None:
    ring = Ring()
    whole = ring.add(ring.symbol(RingSymbol("power", "L1")), ring.rational(5))
    wanted = ring.scale(whole, factor)
    assert ring.scale(ring.scale(whole, times), factor / times) == wanted
    assert ring.multiply(ring.scale(whole, times), ring.rational(factor / times)) == wanted
    assert ring.add(ring.scale(whole, factor * times), ring.scale(whole, factor * (times - 1)), -1) == wanted


LENGTH, OTHER, MASS = (RingSymbol("power", name) for name in ("L1", "L2", "m"))
ANGLE, ANOTHER = (RingSymbol("exponential", name) for name in ("q1", "q2"))


def drawn(ring: Ring, rng: Random, *symbols: RingSymbol) -> Form:
    """A few terms with roots of unity, and with negative exponents."""
    total = ZERO_FORM
    for _ in range(rng.randint(1, 4)):
        term = ring.scale(ring.turn(Fraction(rng.randrange(24), 24)), Fraction(rng.choice((-3, 2, 5)), 6))
        for symbol in symbols:
            term = ring.multiply(term, ring.power(ring.symbol(symbol), rng.randint(-2, 2)))
        total = ring.add(total, term)
    return total


def total_of(ring: Ring, forms: list[Form]) -> Form:
    total = ZERO_FORM
    for form in forms:
        total = ring.add(total, form)
    return total


@pytest.mark.parametrize("seed", range(6))
def test_the_terms_of_a_form_make_it_up(seed: int) -> None:
    """An exponential, a product of powers, a root of unity and a coefficient each."""
    ring, rng = Ring(), Random(f"terms {seed}")
    form = drawn(ring, rng, ANGLE, LENGTH, ANOTHER, OTHER)
    made: list[Form] = []
    for angle, powers, step, coefficient in ring.split_terms(form) or ():
        term = ring.scale(ring.turn(Fraction(step, 24)), Fraction(coefficient, form.denominator))
        for kind, key in ("exponential", angle), ("power", powers):
            for number, exponent in ring.exponents(key):
                assert ring.symbols[number].kind == kind
                term = ring.multiply(term, ring.power(ring.symbol(ring.symbols[number]), exponent))
        made.append(term)
    assert len(made) == len(form.coefficients)
    assert total_of(ring, made) == form


@pytest.mark.parametrize(
    ("symbol", "exponent", "degree"),
    [
        (LENGTH, HALF, 0),
        (RingSymbol("opaque", "r"), Fraction(1), 2),
        (RingSymbol("radical", 2), Fraction(1), 0),
        (RingSymbol("root", None), Fraction(1, 5), 0),
    ],
    ids=["half a power", "square root of a sum", "root of two", "fifth of a turn"],
)
def test_terms_that_are_not_told_apart_by_whole_exponents_are_not_listed(
    symbol: RingSymbol, exponent: Fraction, degree: int
) -> None:
    ring = Ring()
    form = ring.symbol(LENGTH)
    assert ring.split_terms(form) is not None
    related = ring.symbol(symbol, exponent, degree=degree, value=ring.rational(3) if degree else ZERO_FORM)
    assert ring.split_terms(ring.add(form, related)) is None


@pytest.mark.parametrize("seed", range(6))
def test_every_power_of_a_symbol_is_replaced_by_a_form_of_its_own(seed: int) -> None:
    ring, rng = Ring(), Random(f"replaced {seed}")
    mass = ring.symbol(MASS)
    parts = [drawn(ring, rng, ANGLE, LENGTH) for _ in range(4)]
    values = [drawn(ring, rng, ANOTHER, LENGTH) for _ in range(3)]
    whole = total_of(ring, [ring.multiply(part, ring.power(mass, k)) for k, part in enumerate(parts)])
    wanted = total_of(
        ring, [ring.multiply(part, by) for part, by in zip(parts, (ONE_FORM, *values), strict=True)]
    )
    assert ring.replaced(whole, MASS, values) == wanted


def test_replacing_is_counted_as_multiplying_is() -> None:
    ring = Ring(limit=5)
    pair = ring.add(ring.symbol(LENGTH), ring.symbol(OTHER))
    whole = ring.multiply(pair, ring.symbol(MASS))
    assert ring.replaced(ring.symbol(MASS), MASS, [pair]) == pair
    with pytest.raises(FormSizeError):
        ring.replaced(whole, MASS, [pair])


def test_of_the_values_the_one_that_is_put_in_is_counted() -> None:
    ring = Ring(limit=3)
    pair = ring.add(ring.symbol(LENGTH), ring.symbol(OTHER))
    many = total_of(ring, [pair, ring.symbol(ANGLE), ONE_FORM])
    assert ring.replaced(ring.symbol(MASS), MASS, [pair, many]) == pair


def test_an_exponent_is_let_in_up_to_the_room_that_its_place_has() -> None:
    ring = Ring()
    length = ring.symbol(LENGTH)
    room = ring._keys.place(LENGTH).room
    assert room == 2 * 2**20  # of the forty bits beyond the exponent's own, half let products grow
    assert ring.exponents(next(iter(ring.power(length, room).coefficients))) == [(0, room)]
    with pytest.raises(FormSizeError):
        ring.power(length, room + 1)
    with pytest.raises(FormSizeError):
        ring.power(ring.power(length, room), 2)
