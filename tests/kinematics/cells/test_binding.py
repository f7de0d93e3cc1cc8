"""Parameters get values; lengths change their unit."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.cells import AngleUnit, LengthUnit, ParameterKind, bind_parameters, in_length_unit
from kinematics.errors import ParameterError
from kinematics.expressions import Parameter, number
from kinematics.forward import forward_kinematics
from tests.kinematics.cells.tables import raw_row, read


def codes(read_table, parameters):
    with pytest.raises(ParameterError) as caught:
        bind_parameters(read_table, parameters)
    return [(fault.code, fault.where) for fault in caught.value.faults]


TABLE = read(raw_row(theta="q1+beta", d="L1", a="L_2"), raw_row(theta="q2", a="L₁/2"))


@pytest.mark.parametrize("spelling", [("L1", "L2"), ("L_1", "L_{2}"), ("L₁", " L2 ")])
def test_names_may_be_spelled_as_in_cells(spelling):
    one, two = spelling
    table = bind_parameters(TABLE, {one: 2, two: 3.0, "β": 0.5})
    assert (table.rows[0].d, table.rows[0].a, table.rows[1].a, table.rows[0].theta) == (2.0, 3.0, 1.0, 0.5)


def test_angle_parameters_of_a_table_in_degrees_are_in_degrees():
    table = read(raw_row(theta="q1+beta", d="L1*sin(gamma)", alpha="90"), angle_unit=AngleUnit.DEG)
    row = bind_parameters(table, {"beta": 180, "gamma": 30, "L1": 2}).rows[0]
    assert (row.theta, row.alpha) == (math.pi, math.pi / 2)
    assert row.d == pytest.approx(1.0)


def test_every_fault_at_once():
    assert codes(TABLE, {"L1": math.nan, "L_1": 1, "x": 1, "1+": 1}) == [
        ("parameter_not_finite", ("parameters", "L1")),
        ("parameter_given_twice", ("parameters", "L_1")),
        ("parameter_unused", ("parameters", "x")),
        ("parameter_name_invalid", ("parameters", "1+")),
        ("parameter_missing", ("parameters", "L2")),
        ("parameter_missing", ("parameters", "beta")),
    ]


@pytest.mark.parametrize("value", [math.inf, -math.inf, math.nan, True, None, "1", 10**400, [1.0]])
def test_a_value_is_a_finite_number(value):
    table = read(raw_row(theta="q1", a="L1"))
    assert codes(table, {"L1": value}) == [("parameter_not_finite", ("parameters", "L1"))]


def test_a_joint_variable_is_no_parameter():
    assert codes(read(raw_row(theta="q1")), {"q1": 1.0}) == [("parameter_unused", ("parameters", "q1"))]


def test_a_cell_without_value_for_these_parameters():
    table = read(raw_row(theta="q1", a="1/L1", d="sqrt(L1-1)"))
    assert codes(table, {"L1": 0.0}) == [
        ("value_undefined", ("rows", 0, "a")),
        ("value_undefined", ("rows", 0, "d")),
    ]


def test_a_table_without_parameters_is_bound_once():
    table = read(raw_row(theta="q1", a=0.5))
    assert bind_parameters(table, {}) is bind_parameters(table, {})


# units of length


def test_a_table_in_millimetres_equals_the_one_in_metres():
    rows_mm = (raw_row(theta="q1", d=75, a="L1+45"), raw_row(d="q2", a="2*L1", alpha="atan2(L1, 20)"))
    rows_m = (
        raw_row(theta="q1", d=0.075, a="L1+0.045"),
        raw_row(d="q2", a="2*L1", alpha="atan2(1000*L1, 20)"),
    )
    converted = in_length_unit(read(*rows_mm, length_unit=LengthUnit.MM), LengthUnit.M)
    assert converted.length_unit is LengthUnit.M
    assert converted.table == read(*rows_m).table


@pytest.mark.parametrize("cell", ["L1", "L1+L2", "sqrt(L1^2+L2^2)", "L1*sin(beta)", "abs(L1-L2)", "L1^2/L2"])
def test_what_scales_like_a_length_stays_as_it_is_written(cell):
    table = read(raw_row(theta="q1", a=cell), length_unit=LengthUnit.MM)
    assert in_length_unit(table, LengthUnit.M).table == table.table


def test_the_same_unit_is_the_same_table():
    assert in_length_unit(TABLE, LengthUnit.M) is TABLE


def test_inches_are_exact():
    converted = in_length_unit(
        read(raw_row(theta="q1", a=10, d="L1"), length_unit=LengthUnit.IN), LengthUnit.MM
    )
    assert converted.table.rows[0].a == number(254)
    assert converted.table.rows[0].d == Parameter("L1")


CELLS = st.sampled_from(
    ["L1", "3", "L1+5", "sqrt(L1^2+9)", "L1*L2", "L1^2", "2/L1", "L1*sin(beta)", "abs(L1-7)", "sqrt(L1)", "0"]
)
ANGLES = st.sampled_from(
    ["beta", "atan2(L1, L2)", "atan2(L1, 5)", "asin(L1/(L1+9))", "pi/2", "q1+acos(3/(L2+3))"]
)
SIZES = st.floats(0.5, 50.0)


@given(
    a=CELLS, d=CELLS, theta=ANGLES, sizes=st.tuples(SIZES, SIZES), beta=st.floats(-3, 3),
    units=st.tuples(st.sampled_from(LengthUnit), st.sampled_from(LengthUnit)), q=st.floats(-3, 3),
)  # fmt: skip
def test_the_mechanism_is_the_same_in_every_unit(a, d, theta, sizes, beta, units, q):
    old, new = units
    one, two = (size for size in sizes)
    names = {"L1": one, "L2": two, "beta": beta}
    table = read(
        raw_row(theta="q1"), raw_row(a=a, d=d, alpha=theta.replace("q1+", ""), theta=1), length_unit=old
    )
    here = {name: value for name, value in names.items() if name in table.parameters}
    ratio = float(old.metres_per_unit / new.metres_per_unit)
    there = {
        name: value * ratio if table.parameters[name] is ParameterKind.LENGTH else value
        for name, value in here.items()
    }
    before = forward_kinematics(bind_parameters(table, here), [q]).transform
    after = forward_kinematics(bind_parameters(in_length_unit(table, new), there), [q]).transform
    before[:3, 3] *= ratio
    np.testing.assert_allclose(after, before, rtol=1e-9, atol=1e-9 * ratio)
