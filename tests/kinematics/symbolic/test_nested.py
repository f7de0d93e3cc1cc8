"""Sums of products that stay nested."""

from fractions import Fraction

import pytest

from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    Parameter,
    add,
    call,
    multiply,
    number,
    power,
)
from kinematics.symbolic.nested import NOTHING, Arena
from kinematics.symbolic.terms import leads_negative

L, q1 = Parameter("L"), JointVariable(1)
c1 = call(Function.COS, q1)


@pytest.mark.parametrize("base", [L, c1, add((L, c1)), number(Fraction(-2, 3))], ids=str)
@pytest.mark.parametrize("exponent", range(2, 17))
def test_a_power_is_a_product(base: Expression, exponent: int) -> None:
    arena = Arena()
    below = arena.read(power(base, exponent - 1))
    assert arena.read(power(base, exponent)) == arena.product(below, arena.read(base))


@pytest.mark.parametrize("exponent", [17, -1, Fraction(1, 2)], ids=str)
def test_other_powers_are_symbols_of_their_own(exponent: Fraction | int) -> None:
    arena = Arena()
    ((weight, factors),) = arena.read(power(add((L, c1)), exponent))
    assert (weight, len(factors)) == (1, 1)
    assert arena.read(power(L, exponent)) != ((weight, factors),)


@pytest.mark.parametrize("one", [L, add((L, c1)), number(3)], ids=str)
def test_nothing_times_anything_is_nothing(one: Expression) -> None:
    arena = Arena()
    assert arena.read(number(0)) == NOTHING
    assert arena.product(NOTHING, arena.read(one)) == NOTHING == arena.product(arena.read(one), NOTHING)


def test_roots_of_numbers_are_multiplied_out() -> None:
    """√2 √8 = 4, √2 √3 = √6, √(4/3) = 2/3 √3 and √(1/2) = 1/2 √2."""
    arena = Arena()

    def root(of: Fraction | int) -> Expression:
        return call(Function.SQRT, number(of))

    assert arena.product(arena.read(root(2)), arena.read(root(8))) == arena.read(number(4))
    assert arena.product(arena.read(root(2)), arena.read(root(3))) == arena.read(root(6))
    two_thirds = arena.read(number(Fraction(2, 3)))
    assert arena.read(root(Fraction(4, 3))) == arena.product(two_thirds, arena.read(root(3)))
    half = arena.read(number(Fraction(1, 2)))
    assert arena.read(root(Fraction(1, 2))) == arena.product(half, arena.read(root(2)))


@pytest.mark.parametrize("second", [3, -3], ids=str)
def test_a_number_that_all_terms_share_stands_before_the_parentheses(second: int) -> None:
    """3 L ± 3 c1 = 3 (L ± c1), and of 3 L ± 2 c1 nothing is shared."""
    arena = Arena()
    weight, factors = arena.term(arena.read(add((multiply((number(3), L)), multiply((number(second), c1))))))
    assert abs(weight) == 3
    assert factors == arena.term(arena.read(add((L, multiply((number(second // 3), c1))))))[1]
    plain, _ = arena.term(arena.read(add((multiply((number(3), L)), multiply((number(2), c1))))))
    assert abs(plain) == 1


def test_parentheses_around_everything_are_opened() -> None:
    arena = Arena()
    whole = arena.read(add((L, c1)))
    for sign in (1, -1):
        weight, factors = arena.term(whole)
        assert len(factors) == 1
        opened = arena.gathered(((sign * weight, factors),))
        assert set(opened) == set(whole if sign > 0 else arena.negative(whole))
    kept = ((2, factors),)
    assert arena.gathered(kept) == kept


def test_minus_one_times_a_sum_changes_its_signs() -> None:
    arena = Arena()
    whole = arena.read(add((L, c1)))
    for product in (
        arena.product(arena.read(number(-1)), whole),
        arena.product(whole, arena.read(number(-1))),
    ):
        assert product == arena.negative(whole)
    assert len(arena.product(arena.read(number(-2)), whole)) == 1


def test_the_size_is_that_of_what_is_written() -> None:
    """A term counts, and each factor in it; parentheses count as what stands in them."""
    arena = Arena()
    whole = arena.read(add((L, c1)))
    assert arena.size(whole) == 4
    assert arena.size(arena.product(arena.read(c1), arena.read(L))) == 3
    assert arena.size(arena.product(arena.read(c1), whole)) == 1 + 1 + 4
    assert arena.size(arena.read(number(3))) == 1


@pytest.mark.parametrize(
    ("signs", "negative"),
    [
        *(([-1, -1, 1], True), ([1, 1, -1], False), ([-1, 1, 1, -1], True), ([1, -1, -1, 1], False)),
        *(([Fraction(-1, 2), 2], True), ([Fraction(1, 2), -2], False)),
    ],
    ids=str,
)
def test_a_sum_is_written_with_the_sign_that_most_terms_have_or_the_first(
    signs: list[Fraction | int], negative: bool
) -> None:
    arena = Arena()
    names = [arena.read(Parameter(f"L{i}"))[0][1] for i in range(len(signs))]
    assert leads_negative(tuple(zip(signs, names, strict=True))) is negative


def test_what_cancels_once_its_parentheses_are_opened_is_nothing_times_anything() -> None:
    arena = Arena()
    whole, cosine = arena.read(add((L, c1))), arena.read(c1)
    cancelling = arena.sum((arena.term(whole),), arena.negative(whole))
    assert cancelling
    assert arena.product(cancelling, cosine) == NOTHING == arena.product(cosine, cancelling)
