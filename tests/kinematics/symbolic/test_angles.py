"""Angles as sums, exact where they can be, and the roots that write their cosines."""

import cmath
import math
from fractions import Fraction

import pytest

from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    Parameter,
    add,
    call,
    evaluate,
    multiply,
    number,
    pi_times,
    power,
)
from kinematics.symbolic import canonical, same_function
from kinematics.symbolic.angles import Angle, angle_of, cosine_and_sine
from kinematics.symbolic.exact_poses import decimal, exact_pose
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.roots import basis_terms, has_large_prime, square_free

L1, ALPHA, BETA = map(Parameter, ("L1", "alpha", "beta"))
q1, q2 = JointVariable(1), JointVariable(2)


@pytest.mark.parametrize("steps", range(-30, 31))
def test_every_multiple_of_a_twelfth_of_pi_is_exact(steps: int) -> None:
    angle = angle_of(pi_times(Fraction(steps, 12)))
    cosine, sine = cosine_and_sine(angle)
    assert evaluate(cosine) == pytest.approx(math.cos(steps * math.pi / 12), abs=1e-14)
    assert evaluate(sine) == pytest.approx(math.sin(steps * math.pi / 12), abs=1e-14)
    assert angle.half_turns == 1 - (1 - Fraction(steps, 12)) % 2


@pytest.mark.parametrize(
    "angle",
    [
        number("0.3"),
        number("2.5"),
        pi_times(Fraction(2, 5)),
        add((pi_times(Fraction(2, 5)), number("0.3"))),
        q1,
        multiply((number("1/2"), q1)),
        add((q1, multiply((number(-1), ALPHA)))),
    ],
    ids=str,
)
def test_no_sign_is_written_within_a_sine_where_none_need_be(angle: Expression) -> None:
    assert cosine_and_sine(angle_of(angle)) == (call(Function.COS, angle), call(Function.SIN, angle))
    opposite = multiply((number(-1), angle))
    cosine, sine = cosine_and_sine(angle_of(opposite))
    assert (cosine, sine) == (call(Function.COS, angle), multiply((number(-1), call(Function.SIN, angle))))


def test_an_arc_that_is_a_known_angle_is_one() -> None:
    sixth = call(Function.ASIN, number("1/2"))
    assert angle_of(sixth).half_turns == Fraction(1, 6)
    assert angle_of(multiply((number(3), sixth))).quarter_turns == 1
    assert angle_of(call(Function.ATAN2, number(-1), number(1))).half_turns == Fraction(-1, 4)
    assert angle_of(call(Function.ACOS, number(1))) == Angle()
    assert FormReader().half_turns(call(Function.ASIN, number("1/3"))) is None
    unknown = angle_of(call(Function.ASIN, number("1/3")))
    assert unknown != Angle()
    assert unknown.quarter_turns is None


def test_parts_are_added_with_their_weights_and_what_moves_comes_first() -> None:
    product = multiply((ALPHA, BETA))
    angle = angle_of(add((multiply((number(2), product)), ALPHA, q2, multiply((number(-1), q1)))))
    assert dict(angle.parts) == {product: 2, ALPHA: 1, q2: 1, q1: -1}
    assert [part for part, _ in angle.parts[:2]] == [q1, q2]
    assert (angle.weight_of(1), angle.weight_of(2), angle.weight_of(3)) == (-1, 1, 0)
    assert angle.plus(angle, -1) == Angle()


@pytest.mark.parametrize(
    "denominator", [1, 2, 4, 8, 9, 15, 25, 27, 30, 31, 37, 60, 72, 77, 120, 360, 961, 1001]
)
def test_a_root_of_unity_is_the_sum_of_its_basis(denominator: int) -> None:
    for numerator in (1, 7, 11, denominator - 1):
        turn = Fraction(numerator, denominator)
        written = sum(weight * cmath.exp(2j * math.pi * float(part)) for part, weight in basis_terms(turn))
        assert written == pytest.approx(cmath.exp(2j * math.pi * float(turn)), abs=1e-12)
        assert all(0 <= part < 1 for part, _ in basis_terms(turn))
    assert has_large_prime(Fraction(1, denominator)) == (denominator == 37)


@pytest.mark.parametrize("value", [1, 12, 18, 49, 72, 97, 5040, 2**10 * 3**5 * 11, 10007**2, 10007 * 10009])
def test_a_square_and_distinct_primes_make_the_number(value: int) -> None:
    root, primes, certain = square_free(value)
    assert root**2 * math.prod(primes) == value
    assert len(set(primes)) == len(primes)
    assert certain == (value != 10007 * 10009)


def test_a_reciprocal_of_a_sum_is_written_with_its_content_outside() -> None:
    twice = power(add((multiply((number(2), L1)), multiply((number(4), ALPHA)))), -1)
    once = multiply((number("1/2"), power(add((L1, multiply((number(2), ALPHA)))), -1)))
    assert same_function(twice, once)
    assert canonical(twice) == canonical(once)
    over = power(add((L1, ALPHA)), -1)
    assert same_function(add((multiply((L1, over)), multiply((ALPHA, over)))), number(1))
    inverse = power(add((number(1), call(Function.SQRT, number(5)))), -1)
    assert same_function(multiply((inverse, add((number(1), call(Function.SQRT, number(5)))))), number(1))


@pytest.mark.parametrize("twelfths", range(13))
def test_a_number_is_a_cosine_that_it_is_to_its_last_digits(twelfths: int) -> None:
    """In a rotation: it may be two units in the last place of a number near 1 off, but not four."""
    cosine, _ = cosine_and_sine(angle_of(pi_times(Fraction(twelfths, 12))))
    value = evaluate(cosine)
    for off in (-3e-16, 0.0, 3e-16):
        pose = exact_pose([[value + off] * 4] * 4)
        assert pose[0][0] == pose[2][2] == cosine
        assert pose[0][3] == pose[3][0] == decimal(value + off)
    for off in (-7e-16, 7e-16):
        assert exact_pose([[value + off] * 4] * 4)[1][1] == decimal(value + off)


@pytest.mark.parametrize(
    ("twelfths", "cosine", "sine"), [(4, "0.5", None), (2, None, "0.5"), (6, "0", "1"), (12, "-1", "0")]
)
def test_rational_cosines_and_sines_are_numbers_and_no_sums_of_roots_of_unity(
    twelfths: int, cosine: str | None, sine: str | None
) -> None:
    reader = FormReader()
    found = reader.cosine_and_sine(pi_times(Fraction(twelfths, 12)))
    for form, value in zip(found, (cosine, sine), strict=True):
        if value is not None:
            assert form == reader.ring.rational(Fraction(value))
