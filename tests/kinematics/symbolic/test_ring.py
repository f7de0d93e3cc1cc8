"""Arithmetic of closed forms: turning a pair of coordinates is multiplying by cosine and sine."""

from __future__ import annotations

from fractions import Fraction

import pytest

from kinematics.symbolic.elements import IMAGINARY_UNIT, ONE_FORM, Form, RingSymbol
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


@pytest.mark.parametrize("factor", [Fraction(1, 2), Fraction(3, 4), Fraction(-5, 6), Fraction(7, 3)], ids=str)
@pytest.mark.parametrize("times", [2, 3, 4])
def test_a_form_is_in_lowest_terms_whichever_way_it_was_made(factor: Fraction, times: int) -> None:
    ring = Ring()
    whole = ring.add(ring.symbol(RingSymbol("power", "L1")), ring.rational(5))
    wanted = ring.scale(whole, factor)
    assert ring.scale(ring.scale(whole, times), factor / times) == wanted
    assert ring.multiply(ring.scale(whole, times), ring.rational(factor / times)) == wanted
    assert ring.add(ring.scale(whole, factor * times), ring.scale(whole, factor * (times - 1)), -1) == wanted
