"""Entries in a short form: the same functions, and never longer."""

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

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
    power,
)
from kinematics.symbolic import count_operations
from kinematics.symbolic.shortening import shortened

q1, q2, q3, d4 = (JointVariable(k) for k in (1, 2, 3, 4))
L, M = Parameter("L"), Parameter("M")


def cos(*terms: Expression) -> Expression:
    return call(Function.COS, add(terms))


def sin(*terms: Expression) -> Expression:
    return call(Function.SIN, add(terms))


def squared(base: Expression) -> Expression:
    return power(base, 2)


def short(entry: Expression) -> Expression:
    ((found,),) = shortened(((entry,),))
    return found


atoms = st.sampled_from([cos(q1), sin(q1), cos(q2), sin(q2), sin(q2, q3), d4, L, M, number(-2), number(3)])
products = st.lists(atoms, min_size=1, max_size=4).map(multiply)
entries = st.lists(products, min_size=1, max_size=5).map(add)


@given(st.lists(entries, min_size=1, max_size=3))
@example([add((L, M)), add((L, multiply((number(2), d4))))])
@example([number(0)])
def test_entries_are_the_same_functions_and_no_longer(row: list[Expression]) -> None:
    (found,) = shortened((tuple(row),))
    for entry, form in zip(row, found, strict=True):
        assert count_operations([form]) <= count_operations([entry])
        for q in ([0.4, -0.7, 1.1, 0.3], [2.1, 0.2, -1.4, -0.6]):
            values = [evaluate(each, {"L": 0.7, "M": -0.4}, q) for each in (form, entry)]
            assert values[0] == pytest.approx(values[1], abs=1e-9)


@pytest.mark.parametrize(
    ("entry", "form"),
    [
        (
            add(
                (
                    multiply((squared(cos(q1)), squared(cos(q2)))),
                    squared(sin(q1)),
                    multiply((squared(cos(q1)), squared(sin(q2)))),
                )
            ),
            number(1),
        ),
        (add((squared(cos(q1, q2)), squared(sin(q1, q2)))), number(1)),
        (add((multiply((cos(q1), cos(q2))), multiply((number(-1), sin(q1), sin(q2))))), cos(q1, q2)),
        (add((multiply((L, squared(sin(q1)))), multiply((L, squared(cos(q1)))))), L),
        (add((sin(q1), multiply((number(-1), sin(q1))))), number(0)),
    ],
)
def test_what_sums_to_less_is_written_so(entry: Expression, form: Expression) -> None:
    assert short(entry) == form


def test_what_terms_have_in_common_stands_before_their_sum() -> None:
    """L c1 c2 + M c1 s2 + 2 L c1 + s1 becomes c1 (L c2 + M s2 + 2 L) + s1; within a factor, too."""
    terms = [(L, cos(q1), cos(q2)), (M, cos(q1), sin(q2)), (number(2), L, cos(q1)), (sin(q1),)]
    within = add((multiply((L, cos(q2))), multiply((M, sin(q2))), multiply((number(2), L))))
    form = add((multiply((cos(q1), within)), sin(q1)))
    assert operations_of_short(terms) <= count_operations([form])
    other = [multiply((number(-2), sin(q2, q3), cos(q3))), multiply((number(-2), cos(q1), sin(q1)))]
    terms = [(M, cos(q2), L, d4), (M, cos(q2), other[0]), (M, other[1])]
    form = multiply((M, add((multiply((cos(q2), add((multiply((L, d4)), other[0])))), other[1]))))
    assert operations_of_short(terms) <= count_operations([form])


def operations_of_short(terms: list[tuple[Expression, ...]]) -> int:
    return count_operations([short(add(map(multiply, terms)))])
