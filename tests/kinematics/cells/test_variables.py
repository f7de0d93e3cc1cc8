"""Joint variables: where they may stand, how they are numbered, and why anything else is refused."""

from fractions import Fraction

import pytest

from kinematics.cells import AngleUnit
from kinematics.errors import CellError, TableError
from kinematics.expressions import ZERO, Parameter, add, number, pi_times
from tests.kinematics.cells.tables import FIXED, PRISMATIC, REVOLUTE, faults_of, raw_row, raw_table, read

HALF = pi_times(Fraction(1, 2))


def joints_of(*rows, **options):
    return [row.joint for row in read(*rows, **options).table.rows]


# which joint a row holds


def test_the_joint_follows_from_the_cells():
    rows = (raw_row(theta="q1"), raw_row(d="q2"), raw_row(theta=1, d=2, a=3, alpha=4), raw_row(d="d_3"))
    assert joints_of(*rows) == [REVOLUTE, PRISMATIC, FIXED, PRISMATIC]


def test_a_revolute_row_keeps_its_d_as_a_parameter():
    table = read(raw_row(theta="θ1", d="d1"), raw_row(theta="θ2", d="d_2")).table
    assert [row.joint for row in table.rows] == [REVOLUTE, REVOLUTE]
    assert table.rows[1].d == Parameter("d2")


def test_d_of_another_row_is_a_parameter():
    row = read(raw_row(d="q1", a="d1"), raw_row(theta="q2", d="d1")).table
    assert row.rows[0].a == row.rows[1].d == Parameter("d1")


def test_plain_numbers_are_offsets_where_the_joint_is_given():
    first, second = read(raw_row(theta=0.3, joint=REVOLUTE), raw_row(d=0.2, joint=PRISMATIC)).table.rows
    assert (first.joint, first.theta, second.joint, second.d) == (
        REVOLUTE,
        number("0.3"),
        PRISMATIC,
        number("0.2"),
    )


def test_a_symbol_is_an_offset_where_the_joint_is_given_and_its_variable_is_not_named():
    (row,) = read(raw_row(theta="beta", joint=REVOLUTE)).table.rows
    assert row.theta == Parameter("beta")


def test_d_is_a_constant_where_the_row_is_fixed():
    (row,) = read(raw_row(d="d1", joint=FIXED)).table.rows
    assert row.d == Parameter("d1")


# how it enters


@pytest.mark.parametrize(
    ("cell", "sign", "offset"),
    [
        ("q1", 1, ZERO),
        ("-q1", -1, ZERO),
        ("q1+pi/2", 1, HALF),
        ("pi/2+q1", 1, HALF),
        ("pi/2-q1", -1, HALF),
        ("-(q1-pi/2)", -1, HALF),
        ("-(-q1)", 1, ZERO),
        ("(q1)", 1, ZERO),
        ("1*q1", 1, ZERO),
        ("q1*-1", -1, ZERO),
        ("q1/1", 1, ZERO),
        ("2*(q1/2)", 1, ZERO),
        ("-1(q1+beta)", -1, None),
        ("q1+beta-gamma", 1, None),
        ("q1+atan2(L1,L2)", 1, None),
    ],
)
def test_plus_or_minus_the_variable_plus_an_offset(cell, sign, offset):
    (row,) = read(raw_row(theta=cell)).table.rows
    assert row.sign == sign
    assert offset is None or row.theta == offset


def test_offsets_of_prismatic_rows():
    (row,) = read(raw_row(d="L1-q1+0.1")).table.rows
    assert (row.joint, row.sign, row.d) == (PRISMATIC, -1, add((Parameter("L1"), number("0.1"))))


@pytest.mark.parametrize(
    ("cell", "code"),
    [
        ("2*q1", "variable_scaled"),
        ("q1/2", "variable_scaled"),
        ("0*q1", "variable_scaled"),
        ("2(q1+pi)", "variable_scaled"),
        ("L1*q1", "variable_in_product"),
        ("q1*q2", "variable_in_product"),
        ("q1 q1", "variable_in_product"),
        ("q1*pi", "variable_in_product"),
        ("q1/L1", "variable_in_product"),
        ("1/q1", "variable_in_denominator"),
        ("q1^2", "variable_in_power"),
        ("q1²", "variable_in_power"),
        ("q1^1", "variable_in_power"),
        ("2^q1", "variable_in_power"),
        ("sin(q1)", "variable_in_function"),
        ("sqrt(q1)", "variable_in_function"),
        ("abs(q1)", "variable_in_function"),
        ("q1°", "degree_of_angle"),
        ("q1+q1", "variable_twice"),
        ("q1-q1", "variable_twice"),
        ("θ1+q_1", "variable_twice"),
        ("q1+q2", "variable_of_other_row"),
        ("q2", "variable_of_other_row"),
        ("q0", "variable_of_other_row"),
        ("q99", "variable_of_other_row"),
        ("q", "variable_without_number"),
        ("θ", "variable_without_number"),
        ("θ_i", "variable_without_number"),
        ("qᵢ", "variable_without_number"),
    ],
)
def test_anything_else_is_refused(cell, code):
    assert faults_of(raw_row(theta=cell)) == [(code, ("rows", 0, "theta"))]
    if "q1" in cell and code not in ("variable_in_function", "degree_of_angle"):
        in_d = cell.replace("q1", "d1")
        assert faults_of(raw_row(d=in_d, joint=PRISMATIC)) in (
            [(code, ("rows", 0, "d"))],
            [("variable_twice", ("rows", 0, "d"))],
        )


@pytest.mark.parametrize("cell", ["a", "alpha"])
def test_a_variable_is_no_link_constant(cell):
    assert faults_of(raw_row(**{cell: "q1"})) == [("variable_in_constant_cell", ("rows", 0, cell))]


def test_a_fixed_row_has_no_variable():
    assert faults_of(raw_row(theta="q1", joint=FIXED)) == [("variable_in_fixed_row", ("rows", 0, "theta"))]
    assert faults_of(raw_row(d="q1", joint=FIXED)) == [("variable_in_fixed_row", ("rows", 0, "d"))]


def test_the_variable_stands_where_its_joint_moves():
    assert faults_of(raw_row(d="q1", joint=REVOLUTE)) == [("variable_in_wrong_cell", ("rows", 0, "d"))]
    assert faults_of(raw_row(theta="q1", joint=PRISMATIC)) == [
        ("variable_in_wrong_cell", ("rows", 0, "theta"))
    ]


def test_a_row_has_one_variable():
    assert faults_of(raw_row(theta="q1", d="q1")) == [("variable_twice", ("rows", 0, "d"))]
    other = [("variable_in_wrong_cell", ("rows", 0, "d")), ("variable_of_other_row", ("rows", 0, "theta"))]
    assert faults_of(raw_row(theta="q2", d="q1")) == other
    assert faults_of(raw_row(theta="q1", d="q2")) == [("variable_in_wrong_cell", ("rows", 0, "d"))]


# how variables are numbered


def test_fixed_rows_are_not_counted():
    rows = (raw_row(a=1), raw_row(theta="q1"), raw_row(alpha=1), raw_row(d="q2"))
    assert joints_of(*rows) == [FIXED, REVOLUTE, FIXED, PRISMATIC]


def test_numbering_by_row_throughout_is_understood():
    rows = (raw_row(a=1), raw_row(theta="q2"), raw_row(alpha=1), raw_row(d="d4"))
    assert joints_of(*rows) == [FIXED, REVOLUTE, FIXED, PRISMATIC]


def test_a_mixture_is_refused():
    rows = (raw_row(a=1), raw_row(theta="q1"), raw_row(theta="q3"))
    assert faults_of(*rows) == [("variable_numbering_mixed", ("rows", 2, "theta"))]


def test_the_same_variable_in_two_rows():
    assert faults_of(raw_row(theta="q1"), raw_row(theta="q1")) == [("variable_twice", ("rows", 1, "theta"))]


def test_rows_out_of_order():
    assert faults_of(raw_row(theta="q2"), raw_row(theta="q1")) == [
        ("variable_of_other_row", ("rows", 0, "theta")),
        ("variable_of_other_row", ("rows", 1, "theta")),
    ]


def test_a_coupled_joint_is_refused_and_the_message_says_which_variable_belongs():
    with pytest.raises(TableError) as caught:
        read(raw_row(theta="q1"), raw_row(theta="q2+q1"))
    (fault,) = caught.value.faults
    assert fault.code == "variable_of_other_row"
    assert fault.params == {"column": 4, "name": "q1", "expected": "q2"}


def test_a_stated_prismatic_joint_counts_without_its_variable():
    rows = (raw_row(d=0.1, joint=PRISMATIC), raw_row(theta="q2"))
    assert joints_of(*rows) == [PRISMATIC, REVOLUTE]


def test_an_unreadable_cell_brings_no_faults_about_numbering():
    assert faults_of(raw_row(theta="q1+"), raw_row(theta="q2")) == [("cell_incomplete", ("rows", 0, "theta"))]


def test_cell_errors_and_table_errors_are_told_apart():
    with pytest.raises(CellError):
        read(raw_row(theta="1+"), raw_row(theta="2*q1"))
    with pytest.raises(TableError):
        read(raw_row(theta="2*q1"))


def test_degrees_hold_for_offsets_of_variables():
    (row,) = read(raw_row(theta="90-q1"), angle_unit=AngleUnit.DEG).table.rows
    assert (row.sign, row.theta) == (-1, HALF)


def test_equal_tables_are_read_once():
    rows = (raw_row(theta="q1", a="L1", d=0.123),)
    from kinematics.cells import read_table

    assert read_table(raw_table(*rows)) is read_table(raw_table(*rows))
    assert raw_table(*rows) == raw_table(*rows)
    assert raw_table(*rows) != raw_table(*rows, angle_unit=AngleUnit.DEG)


@pytest.mark.parametrize("joint", list(type(REVOLUTE)))
@pytest.mark.parametrize("cell", ["q1", "d1", "2*q1", "", None, "q7"])
def test_every_refusal_is_one_of_ours(joint, cell):
    found = faults_of(raw_row(theta=cell, joint=joint), raw_row(d=cell, joint=joint))
    assert all(code and where[0] == "rows" for code, where in found)
