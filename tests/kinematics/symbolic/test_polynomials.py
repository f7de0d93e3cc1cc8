"""Polynomials in cosines and sines, against the ring of exponentials."""

import math
from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kinematics.expressions import add, call, evaluate, multiply, power
from kinematics.expressions.trees import (
    PI,
    Call,
    Function,
    JointVariable,
    Number,
    Parameter,
    Product,
    Sum,
    number,
    pi_times,
)
from kinematics.symbolic import ProofStatus, compare
from kinematics.symbolic.polynomials import FIELD, PolynomialReader

HALF = Fraction(1, 2)
q1, q2, d3, L, alpha = JointVariable(1), JointVariable(2), JointVariable(3), Parameter("L"), Parameter("a")


def sin(*terms):
    return call(Function.SIN, add(terms))


def cos(*terms):
    return call(Function.COS, add(terms))


whole = st.sampled_from([-2, -1, 1, 2, 3]).map(number)
angles = st.builds(
    lambda a, b, quarters: add((multiply((a, q1)), multiply((b, alpha)), pi_times(Fraction(quarters, 2)))),
    whole,
    st.sampled_from([number(0), number(1), number(-1)]),
    st.integers(-3, 3),
)
atoms = st.one_of(
    st.sampled_from([q2, d3, L, number("0.25")]),
    whole,
    st.builds(call, st.sampled_from([Function.SIN, Function.COS]), angles),
)
functions = st.recursive(
    atoms,
    lambda of: st.one_of(
        st.lists(of, min_size=2, max_size=3).map(add),
        st.lists(of, min_size=2, max_size=3).map(multiply),
        st.builds(power, of, st.sampled_from([2, 3])),
    ),
    max_leaves=6,
)


@given(functions, functions)
def test_equality_is_that_of_the_ring(a, b):
    reader = PolynomialReader()
    one, other, sum_of_both = reader.read(a), reader.read(b), reader.read(add((a, b)))
    assert (one == other) == (compare(a, b) is ProofStatus.PROVED)
    assert reader.read(add((b, a))) == sum_of_both
    product = reader.product([one, other])
    assert product == reader.read(multiply((b, a)))
    of_one, of_other = reader.degrees(one), reader.degrees(other)
    if one and other:
        sums = {symbol: of_one.get(symbol, 0) + of_other.get(symbol, 0) for symbol in {*of_one, *of_other}}
        assert reader.degrees(product) == sums


@given(functions)
@example(multiply((L, cos(q1), add((cos(q2), multiply((d3, sin(q2))))))))
@example(add((power(L, 2), multiply((alpha, d3, sin(q2))))))
def test_a_polynomial_has_the_values_of_what_it_was_read_from(function):
    """Each name, cosine and sine has a field of its own in the keys."""
    reader = PolynomialReader()
    polynomial = reader.read(function)
    values, q = {"L": 0.7, "a": -0.4}, [0.3, 1.1, -0.6]
    places = [(evaluate(factor, values, q), place) for factor, place in reader.factors({}).items()]
    total = sum(
        float(weight) * math.prod(value ** (key >> place & FIELD) for value, place in places)
        for key, weight in polynomial.items()
    )
    assert total == pytest.approx(evaluate(function, values, q), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(
    ("a", "b"),
    [
        (sin(q1, q2), add((multiply((sin(q1), cos(q2))), multiply((cos(q1), sin(q2)))))),
        (power(sin(q1), 4), power(add((number(1), multiply((number(-1), power(cos(q1), 2))))), 2)),
        (cos(pi_times(HALF), q1), multiply((number(-1), sin(q1)))),
        (Call(Function.SIN, (Sum((pi_times(HALF), q1)),)), cos(q1)),
        (cos(q1, PI), multiply((number(-1), cos(q1)))),
        (
            sin(multiply((number(3), q1))),
            add((multiply((number(3), sin(q1))), multiply((number(-4), power(sin(q1), 3))))),
        ),
        (add((power(sin(alpha), 2), power(cos(alpha), 2))), number(1)),
        (multiply((L, add((d3, L)))), add((power(L, 2), multiply((L, d3))))),
        (Call(Function.COS, (pi_times(2),)), number(1)),
        (Call(Function.SIN, (pi_times(2),)), number(0)),
        (Call(Function.SIN, (pi_times(-HALF),)), number(-1)),
        (Call(Function.COS, (PI,)), number(-1)),
        (Call(Function.SIN, (multiply((number(-1), q1)),)), multiply((number(-1), sin(q1)))),
        (
            Product((number(2), sin(q1), sin(q1), L)),
            add((multiply((number(2), L)), multiply((number(-2), L, power(cos(q1), 2))))),
        ),
        (Product((L, sin(q1), sin(q1), d3, sin(q1))), multiply((d3, L, power(sin(q1), 3)))),
        (multiply((number(4), add((number("0.25"), d3)))), add((number(1), multiply((number(4), d3))))),
    ],
)
def test_identities(a, b):
    reader = PolynomialReader()
    assert reader.read(a) == reader.read(b)


def test_half_angles_are_read_where_angles_are_counted_in_halves():
    half = multiply((Number(Fraction(1, 2)), q1))
    assert PolynomialReader().read(sin(half)) is None
    reader = PolynomialReader(parts=2)
    assert reader.read(sin(q1)) == reader.read(multiply((number(2), sin(half), cos(half))))
    assert reader.degrees(reader.read(sin(q1))) == {q1: 2}


@pytest.mark.parametrize("parts", [1, 2])
@pytest.mark.parametrize("function", [sin, cos])
def test_a_joint_is_read_the_same_after_its_multiples(parts, function):
    weights = [Fraction(1, 2)] * (parts == 2) + [Fraction(2), Fraction(3), Fraction(1), Fraction(-1)]
    reader = PolynomialReader(parts=parts)
    multiples = [function(multiply((Number(weight), q1))) for weight in weights]
    found = [reader.read(multiple) for multiple in multiples]
    assert found == [reader.read(multiple) for multiple in reversed(multiples)][::-1]
    for one, weight in zip(found, weights, strict=True):
        fresh = PolynomialReader(parts=parts)
        fresh.read(function(q1))
        assert fresh.read(function(multiply((Number(weight), q1)))) == one
    assert len({tuple(sorted(one.items())) for one in found}) >= len(weights) - (function is cos)


def test_units_are_left_out_of_a_normalised_polynomial():
    reader = PolynomialReader()
    one = reader.read(add((multiply((L, sin(q1))), multiply((number(2), L, d3)))))
    other = reader.read(multiply((number(-3), add((sin(q1), multiply((number(2), d3)))))))
    assert one != other
    assert reader.normalised(one) == reader.normalised(other)
    assert reader.normalised(reader.read(d3)) == reader.read(d3)


def test_of_several_names_each_is_left_out_as_often_as_in_every_term():
    reader = PolynomialReader()
    some = add((multiply((alpha, d3)), sin(q1)))
    factors = multiply((number("0.5"), power(L, 2), power(alpha, 3)))
    assert reader.normalised(reader.read(multiply((factors, some)))) == reader.normalised(reader.read(some))
    other = add((L, multiply((power(L, 3), d3))))
    divided = add((number(1), multiply((power(L, 2), d3))))
    assert reader.normalised(reader.read(other)) == reader.read(divided)


@pytest.mark.parametrize(
    "expression",
    [
        power(L, -1),
        power(L, Fraction(1, 2)),
        power(L, 65),
        call(Function.ATAN2, L, d3),
        sin(pi_times(Fraction(1, 6)), q1),
        sin(number(1), q1),
        sin(L, multiply((number(25), q1))),
        multiply((L, PI)),
        multiply([power(L, 60)] * 40),
        power(add((L, d3, cos(q1), cos(q2), sin(q1))), 30),
    ],
)
def test_what_is_no_such_polynomial_or_a_long_one_is_left_to_the_ring(expression):
    reader = PolynomialReader()
    assert reader.read(expression) is None


def test_a_copy_leaves_its_original_as_it_was():
    reader = PolynomialReader()
    known = reader.read(add((sin(q1), L)))
    copy = reader.copy()
    assert copy.read(multiply((d3, cos(q2), alpha))) is not None
    assert copy.read(add((L, sin(q1)))) == known
    assert reader.degrees(known) == {q1: 1}


@pytest.mark.parametrize(("last", "fits"), [(61, True), (63, False)])
def test_an_exponent_beyond_its_field_is_not_read(last, fits):
    """Of cⁿ s² = cⁿ − cⁿ⁺² the second term may leave the field alone: it holds exponents below 2048."""
    reader = PolynomialReader()
    factors = [reader.read(power(cos(q1), n)) for n in (*[64] * 31, last)]
    sine = reader.read(sin(q1))
    assert (reader.product([*factors, sine, sine]) is not None) is fits


def test_degrees_are_those_in_joint_variables():
    reader = PolynomialReader()
    assert reader.degrees(reader.read(d3)) == {d3: 1}
    assert reader.degrees(reader.read(number(0))) == {}
    whole = multiply((power(d3, 2), L, add((sin(q1), number(1))), add((cos(q1, q2), d3))))
    assert reader.degrees(reader.read(whole)) == {d3: 3, q1: 2, q2: 1}
    others = PolynomialReader()
    assert others.degrees(others.read(multiply((power(L, 5), alpha, add((power(d3, 2), cos(q1))))))) == {
        d3: 2,
        q1: 1,
    }


@pytest.mark.parametrize("symbol", [L, d3], ids=str)
def test_a_power_of_a_name_is_read_up_to_half_of_its_field(symbol):
    reader = PolynomialReader()
    highest = [reader.read(power(symbol, 64))] * 31 + [reader.read(power(symbol, 63))]
    assert reader.product(highest) is not None
    assert reader.product([*highest, reader.read(symbol)]) is None
