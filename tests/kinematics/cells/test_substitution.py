"""Values in the place of parameters: the value of the replaced is the replaced value."""

import random

import pytest

from kinematics.cells.substitution import substitute, valued, with_values
from kinematics.errors import ParameterError
from kinematics.expressions import (
    ZERO,
    Function,
    JointVariable,
    Parameter,
    add,
    call,
    evaluate,
    multiply,
    negate,
    number,
    pi_times,
    power,
)
from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.kinematics.symbolic.rewriting import PARAMETERS, random_expression

L1, L2, ALPHA = map(Parameter, ("L1", "L2", "alpha"))


@pytest.mark.parametrize("seed", range(60))
def test_a_value_may_be_put_in_before_or_after(seed: int) -> None:
    expression = random_expression(random.Random(seed))
    names = {name: 0.41 + 0.23 * i for i, name in enumerate(PARAMETERS)}
    joints = (0.5, -1.2, 0.9)
    numbers = {name: number(str(value)) for name, value in names.items()}
    expected = evaluate(expression, names, joints)
    one = dict(list(numbers.items())[seed % len(numbers) :][:1])
    assert evaluate(substitute(expression, one), names, joints) == pytest.approx(expected, rel=1e-9, abs=1e-9)
    assert evaluate(substitute(expression, numbers), {}, joints) == pytest.approx(
        expected, rel=1e-9, abs=1e-9
    )


def test_what_became_exact_is_folded() -> None:
    right = {"alpha": pi_times("1/2")}
    assert substitute(call(Function.COS, ALPHA), right) == ZERO
    assert substitute(call(Function.SIN, add((ALPHA, JointVariable(1)))), right) == call(
        Function.SIN, add((pi_times("1/2"), JointVariable(1)))
    )
    assert substitute(power(add((L1, L2)), 2), {"L1": number(3), "L2": number(-1)}) == number(4)
    assert substitute(call(Function.SQRT, L1), {"L1": number(9)}) == number(3)
    assert substitute(multiply((L1, L2)), {"L1": number("1/2")}) == multiply((number("1/2"), L2))


def test_a_cell_that_loses_its_value_is_named() -> None:
    row = DHRow(
        joint=JointType.REVOLUTE, theta=ZERO, d=L2, a=power(add((L1, negate(L2))), -1), alpha=ALPHA, sign=1
    )
    table = DHTable(convention=Convention.STANDARD, rows=(row, row))
    assert with_values(table, {}) is table
    fine = with_values(table, {"L1": number(2), "alpha": pi_times("1/2")})
    assert [each.alpha for each in fine.rows] == [pi_times("1/2")] * 2
    assert fine.rows[1].a == power(add((number(2), negate(L2))), -1)
    assert (fine.convention, fine.rows[0].joint, fine.rows[0].sign) == (table.convention, row.joint, row.sign)
    with pytest.raises(ParameterError) as caught:
        with_values(table, {"L1": number(2), "L2": number(2)})
    assert [(fault.code, fault.where) for fault in caught.value.faults] == [
        ("value_undefined", ("rows", 0, "a")),
        ("value_undefined", ("rows", 1, "a")),
    ]


def test_a_cell_without_parameters_has_a_value_or_is_refused() -> None:
    assert valued(call(Function.SQRT, L1), {"L1": number(2)}) == call(Function.SQRT, number(2))
    with pytest.raises((ParameterError, ZeroDivisionError)):
        valued(call(Function.SQRT, L1), {"L1": number(-2)})
    assert valued(call(Function.SQRT, L1), {"L2": number(-2)}) == call(Function.SQRT, L1)
