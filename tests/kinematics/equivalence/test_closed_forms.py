"""Closed forms guessed from numbers: what is recognised, and that the work stays bounded."""

import math
import tracemalloc
from fractions import Fraction
from itertools import product

import pytest

from kinematics.equivalence.closed_forms import (
    MOST_SUMS,
    LengthForms,
    angle_form,
    known_number,
)
from kinematics.expressions import (
    Expression,
    Function,
    Number,
    Parameter,
    add,
    call,
    evaluate,
    multiply,
    negate,
    number,
    pi_times,
)

DRAWS = 3


def draws_of(names: list[str]) -> list[dict[str, float]]:
    """Values of which no two sums are equal."""
    return [
        {name: math.sqrt(2 + 3 * k + draw) % 1 + 0.5 for k, name in enumerate(names)} for draw in range(DRAWS)
    ]


def names_of(n: int) -> list[str]:
    return [f"L{i}" for i in range(n)]


def form_of(n: int, expression: Expression) -> Expression | None:
    names = names_of(n)
    draws = draws_of(names)
    forms = LengthForms([Parameter(name) for name in names], draws, 1.5)
    return forms.form([evaluate(expression, draw) for draw in draws])


@pytest.mark.parametrize("n", [3, 10, 16])
def test_sums_of_three_names_and_a_number_are_recognised(n: int) -> None:
    one, two, three = (Parameter(f"L{i}") for i in (0, 1, n - 1))
    for sum_ in (
        one,
        negate(three),
        add((one, negate(two))),
        add((one, negate(two), three)),
        add((negate(one), two, three, Number(number(3).value / 8))),
        number(0),
        number(2),
    ):
        assert form_of(n, sum_) == sum_


@pytest.mark.parametrize(("n", "terms"), [(17, 2), (54, 2), (200, 1), (3000, 1), (5000, 1)])
def test_with_many_names_fewer_terms_are_tried(n: int, terms: int) -> None:
    """The work is bounded: with sixty names all sums of three would take gigabytes."""
    tracemalloc.start()
    try:
        names = names_of(n)
        draws = draws_of(names)
        forms = LengthForms([Parameter(name) for name in names], draws, 1.5)
        tried = min(n, MOST_SUMS // 2)
        sum_ = add(Parameter(f"L{i}") for i in range(tried - terms, tried))
        assert forms.form([evaluate(sum_, draw) for draw in draws]) == sum_
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 12e6
    assert len(forms._sums) <= MOST_SUMS


def test_what_is_no_sum_has_no_form() -> None:
    product = multiply((Parameter("L0"), Parameter("L1")))
    assert form_of(3, product) is None
    assert form_of(0, number(5)) == number(5)


def test_angles_are_multiples_of_fifteen_degrees_and_sums_of_names() -> None:
    names = ["beta", "gamma"]
    draws = draws_of(names)
    atoms = [Parameter(name) for name in names]

    def form(expression: Expression) -> Expression | None:
        return angle_form([evaluate(expression, draw) for draw in draws], atoms, draws)

    for angle in (
        pi_times(0),
        pi_times(1),
        pi_times(-number(1).value / 12),
        atoms[1],
        add((pi_times(1), negate(atoms[0]))),
        add((atoms[0], negate(atoms[1]))),
    ):
        found = form(angle)
        assert found is not None
        other = {"beta": 0.123, "gamma": 2.345}
        assert evaluate(found, other) == pytest.approx(evaluate(angle, other), abs=1e-12)
    assert form(multiply((number(3), atoms[0]))) is None


def test_two_draws_tell_a_number_and_a_name_apart() -> None:
    draws = draws_of(["L0", "L1"])[:2]
    forms = LengthForms([Parameter("L0"), Parameter("L1")], draws, 1.5)
    assert forms.form([0.25, 0.25]) == Number(Fraction(1, 4))
    both = add((Parameter("L1"), Number(Fraction(1, 4))))
    assert forms.form([evaluate(both, draw) for draw in draws]) == both


def test_an_angle_is_given_at_every_draw() -> None:
    draws = draws_of(["beta"])
    with pytest.raises(ValueError, match="longer"):
        angle_form([draw["beta"] for draw in draws[:-1]], [Parameter("beta")], draws)


def test_angle_sums_of_many_names_are_bounded() -> None:
    names = names_of(500)
    draws = draws_of(names)
    atoms = [Parameter(name) for name in names]
    assert angle_form([1.234567] * DRAWS, atoms, draws) is None


@pytest.mark.parametrize("n", [2, 3, 6])
def test_known_numbers(n: int) -> None:
    root = call(Function.SQRT, number(n))
    assert known_number(math.sqrt(n)) == root
    assert known_number(-math.sqrt(n) / 4) == multiply((number(-1), Number(number(1).value / 4), root))
    assert known_number(math.sqrt(n) / 7) is None


@pytest.mark.parametrize(("size", "decimals"), [(0.0, 9), (1.0, 9), (0.5, 9), (2.0, 8), (1000.0, 6)])
def test_a_number_has_nine_digits_of_the_longest_length(size: float, decimals: int) -> None:
    """Beside angles alone, of 1."""
    forms = LengthForms([], [{}], size)
    assert forms.form([0.123456789123]) == Number(Fraction(repr(round(0.123456789123, decimals))))


@pytest.mark.parametrize(("one", "other"), [(1, 2), (1, 3), (1, 6), (2, 3), (2, 6)])
def test_a_length_in_two_directions_adds_up_to_a_known_multiple_of_it(one: int, other: int) -> None:
    """As L + L cos 45° does."""
    roots = [multiply((Number(Fraction(1, 2)), call(Function.SQRT, number(n)))) for n in (one, other)]
    both = add(roots)
    assert known_number(evaluate(both)) == both


def test_products_of_two_cosines_of_multiples_of_fifteen_degrees_are_known() -> None:
    for i, k in product(range(-11, 13), repeat=2):
        value = math.cos(i * math.pi / 12) * math.cos(k * math.pi / 12)
        found = known_number(value)
        assert found is not None
        assert evaluate(found) == pytest.approx(value, abs=1e-12)
    for one, other in (1, 2), (1, 6), (2, 3):
        value = math.sqrt(one) / 4 - 3 * math.sqrt(other) / 8
        assert evaluate(known_number(value) or number(0)) == pytest.approx(value, abs=1e-12)
    assert evaluate(known_number(-3.0) or number(0)) == -3.0
    assert known_number(3.25) is None
    assert known_number(0.5 + 1e-6) is None


COEFFICIENTS = [(math.sqrt(2) / 2, 0.0), (-1.5, 0.25), (math.cos(math.pi / 12), math.sqrt(3) / 2)]


def combination(weights: tuple[float, float], draws: int, off: float = 0.0) -> Expression | None:
    """The form of p L0 + q L1 + 1/8, at some draws, with one value off."""
    values = [{"L0": 0.5 + math.sqrt(2 + k) % 1, "L1": 0.5 + math.sqrt(3 + 2 * k) % 1} for k in range(draws)]
    lengths = [weights[0] * one["L0"] + weights[1] * one["L1"] + 0.125 for one in values]
    lengths[0] += off
    return LengthForms([Parameter("L0"), Parameter("L1")], values, 1.5).form(lengths)


@pytest.mark.parametrize("weights", COEFFICIENTS)
def test_known_coefficients_are_recognised_from_a_draw_more_than_names(weights: tuple[float, float]) -> None:
    other = {"L0": 0.3, "L1": 1.9}
    for draws in (3, 4):
        found = combination(weights, draws)
        assert found is not None
        assert evaluate(found, other) == pytest.approx(weights[0] * 0.3 + weights[1] * 1.9 + 0.125, abs=1e-9)
    assert combination(weights, 2) is None
    assert combination((weights[0] + 0.01, weights[1]), 4) is None
    assert combination(weights, 5, off=1e-5) is None


@pytest.mark.parametrize("size", [1e-9, 1e-3, 1.0, 1e3, 1e9])
def test_lengths_of_any_unit_are_recognised(size: float) -> None:
    """A robot in nanometres is no point: what is zero is so beside the robot's own lengths."""
    draws = [{"L0": size * value} for value in (0.7, 0.9, 1.1)]
    forms = LengthForms([Parameter("L0")], draws, 1.1 * size)
    assert forms.form([draw["L0"] for draw in draws]) == Parameter("L0")
    assert forms.form([1e-12 * size] * 3) == number(0)
    constant = forms.form([0.25 * size] * 3)
    assert constant is not None
    assert evaluate(constant) == pytest.approx(0.25 * size, rel=1e-9)
