"""Exact expressions: folding never changes a value, and what is exact stays exact."""

import math
from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kinematics.errors import ParameterError
from kinematics.expressions import (
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Call,
    Function,
    JointVariable,
    Number,
    Parameter,
    Power,
    Product,
    Sum,
    add,
    call,
    evaluate,
    joint_variables_in,
    multiply,
    negate,
    number,
    parameters_in,
    pi_fraction,
    pi_times,
    power,
    rational_value,
)

VALUES = {"L1": 0.3, "L2": -1.7, "beta": 0.9}
JOINTS = (0.4, -2.0)

leaves = st.one_of(
    st.fractions(-20, 20, max_denominator=24).map(Number),
    st.just(PI),
    st.sampled_from(sorted(VALUES)).map(Parameter),
    st.sampled_from((1, 2)).map(JointVariable),
)


@st.composite
def computations(draw, depth=4):
    """An expression, and the value that plain floats give to the same computation."""
    if depth == 0 or draw(st.booleans()):
        leaf = draw(leaves)
        return leaf, evaluate(leaf, VALUES, JOINTS)
    kind = draw(st.sampled_from(("add", "multiply", "negate", "power", "sin", "abs")))
    (left, x), (right, y) = draw(st.tuples(computations(depth - 1), computations(depth - 1)))
    assume(abs(x) < 1e3 and abs(y) < 1e3)
    return {
        "add": lambda: (add((left, right)), x + y),
        "multiply": lambda: (multiply((left, right)), x * y),
        "negate": lambda: (negate(left), -x),
        "power": lambda: (power(left, 2), x**2),
        "sin": lambda: (call(Function.SIN, left), math.sin(x)),
        "abs": lambda: (call(Function.ABS, left), abs(x)),
    }[kind]()


@given(computations())
def test_folding_keeps_the_value(computation):
    expression, value = computation
    assert evaluate(expression, VALUES, JOINTS) == pytest.approx(value, rel=1e-9, abs=1e-9)


@given(computations(), computations())
def test_sums_and_differences_fold(one, other):
    (a, _), (b, _) = one, other
    assert add((a, negate(a))) == ZERO
    assert add((a, ZERO)) == a
    assert multiply((a, ONE)) == a
    assert multiply((a, ZERO)) == ZERO
    assert negate(negate(a)) == add((a,))
    assert evaluate(add((a, b)), VALUES, JOINTS) == pytest.approx(
        evaluate(add((b, a)), VALUES, JOINTS), rel=1e-9, abs=1e-9
    )


@given(st.fractions(max_denominator=1000), st.fractions(max_denominator=1000))
def test_multiples_of_pi_add_exactly(a, b):
    assert pi_fraction(add((pi_times(a), pi_times(b)))) == a + b
    assert rational_value(add((Number(a), Number(b)))) == a + b
    assert evaluate(pi_times(a)) == pytest.approx(math.pi * a)


def test_decimals_are_rational():
    assert number("0.1") == Number(Fraction(1, 10))
    assert add((number("0.1"), number("0.2"))) == number("0.3")


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (power(number(2), -2), Number(Fraction(1, 4))),
        (power(Parameter("L1"), 1), Parameter("L1")),
        (power(Parameter("L1"), 0), ONE),
        (power(power(Parameter("L1"), 2), 3), Power(Parameter("L1"), Fraction(6))),
        (
            power(power(Parameter("L1"), 2), Fraction(1, 2)),
            Power(Power(Parameter("L1"), Fraction(2)), Fraction(1, 2)),
        ),
        (call(Function.SQRT, number("0.25")), number("0.5")),
        (call(Function.SQRT, number(2)), Call(Function.SQRT, (number(2),))),
        (call(Function.ABS, number(-3)), number(3)),
        (
            multiply((MINUS_ONE, Sum((Parameter("L1"), ONE)))),
            Product((MINUS_ONE, Sum((Parameter("L1"), ONE)))),
        ),
        (negate(Sum((Parameter("L1"), ONE))), Sum((Product((MINUS_ONE, Parameter("L1"))), MINUS_ONE))),
        (add((Parameter("L1"), Parameter("L1"))), Product((number(2), Parameter("L1")))),
    ],
)
def test_what_folds_and_what_does_not(expression, expected):
    assert expression == expected


@pytest.mark.parametrize(
    "expression",
    [
        Power(ZERO, Fraction(-1)),
        Power(number(-1), Fraction(1, 2)),
        Call(Function.SQRT, (number(-1),)),
        Call(Function.ASIN, (number(2),)),
        Power(number(10), Fraction(400)),
        Product((Power(number(10), Fraction(300)), Power(number(10), Fraction(300)))),
    ],
)
def test_what_has_no_finite_value_is_refused(expression):
    with pytest.raises(ParameterError) as error:
        evaluate(expression)
    assert error.value.code == "value_undefined"


def test_a_missing_parameter_is_named():
    with pytest.raises(ParameterError) as error:
        evaluate(add((Parameter("L1"), Parameter("L9"))), {"L1": 1.0})
    assert error.value.code == "parameter_missing"
    assert error.value.faults[0].where == ("parameters", "L9")


def test_sines_and_cosines_of_right_angles_are_exact():
    quarters = [pi_times(Fraction(k, 2)) for k in range(-4, 5)]
    assert [evaluate(call(Function.COS, angle)) for angle in quarters] == [1, 0, -1, 0, 1, 0, -1, 0, 1]
    assert [evaluate(call(Function.SIN, angle)) for angle in quarters] == [0, 1, 0, -1, 0, 1, 0, -1, 0]


def test_names_in_an_expression():
    expression = multiply((Parameter("L1"), call(Function.COS, add((JointVariable(2), Parameter("beta"))))))
    assert parameters_in(expression) == {"L1", "beta"}
    assert joint_variables_in(expression) == {2}
