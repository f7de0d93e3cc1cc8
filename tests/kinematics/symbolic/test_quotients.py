"""Fractions of closed forms: one numerator over factors that are no fractions, and the same function."""

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
from kinematics.symbolic import ProofStatus, compare
from kinematics.symbolic.quotients import cleared, quotient_of, reduced

q1, q2, L = JointVariable(1), JointVariable(2), Parameter("L")
s1, c1, t1 = (call(function, q1) for function in (Function.SIN, Function.COS, Function.TAN))
HALF = Fraction(1, 2)
t2, c2 = call(Function.TAN, q2), call(Function.COS, q2)


@pytest.mark.parametrize(
    ("expression", "numerator", "denominator"),
    [
        (s1, s1, ()),
        (t1, s1, (c1,)),
        (power(t1, 2), power(s1, 2), (c1, c1)),
        (power(t1, -1), c1, (s1,)),
        (power(t1, -2), power(c1, 2), (s1, s1)),
        (power(c1, -3), number(1), (c1, c1, c1)),
        (multiply((L, t1, power(c2, -1))), multiply((L, s1)), (c1, c2)),
        (add((t1, t2)), add((multiply((s1, c2)), multiply((call(Function.SIN, q2), c1)))), (c1, c2)),
        (add((power(t1, 2), t1)), add((power(s1, 2), multiply((s1, c1)))), (c1, c1)),
        (power(add((t1, L)), 2), power(add((s1, multiply((L, c1)))), 2), (c1, c1)),
        (power(c1, Fraction(1, 2)), power(c1, Fraction(1, 2)), ()),
    ],
    ids=str,
)
def test_a_numerator_and_the_factors_below(
    expression: Expression, numerator: Expression, denominator: tuple[Expression, ...]
) -> None:
    top, bottom = quotient_of(expression)
    assert sorted(map(str, bottom)) == sorted(map(str, denominator))
    assert compare(top, numerator) is ProofStatus.PROVED
    assert compare(cleared(expression), numerator) is ProofStatus.PROVED


@pytest.mark.parametrize(
    ("expression", "whole", "denominator"),
    [
        (s1, s1, ()),
        (t1, t1, (c1,)),
        (multiply((c1, t1)), s1, ()),
        (multiply((power(c1, 2), t1)), multiply((c1, s1)), ()),
        (multiply((c1, power(t1, 2))), multiply((power(s1, 2), power(c1, -1))), (c1,)),
        (multiply((power(c1, 3), power(t1, 2))), multiply((c1, power(s1, 2))), ()),
        (multiply((c1, t1, t2)), multiply((s1, t2)), (c2,)),
        (multiply((power(c1, Fraction(3, 2)), t1)), multiply((power(c1, HALF), s1)), ()),
        (multiply((power(c1, HALF), t1)), multiply((power(c1, HALF), t1)), (c1,)),
        (
            add((t1, multiply((number(-1), power(c1, -1))))),
            add((t1, multiply((number(-1), power(c1, -1))))),
            (c1,),
        ),
    ],
    ids=str,
)
def test_what_stands_above_and_below_is_left_out(
    expression: Expression, whole: Expression, denominator: tuple[Expression, ...]
) -> None:
    found, bottom = reduced(expression)
    assert bottom == denominator
    assert compare(found, whole) is ProofStatus.PROVED
    if bottom == quotient_of(expression)[1]:
        assert found == expression
    elif not bottom:
        assert not quotient_of(found)[1]
