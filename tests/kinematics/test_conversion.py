"""Standard to modified and back: nothing lost, nothing computed."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.conversion import Conversion, XScrew, convert, fixed_row, screw_transform
from kinematics.expressions import ZERO, Expression, Parameter, add, evaluate, multiply, number, pi_times
from kinematics.forward import end_pose
from kinematics.table import Convention, DHRow, DHTable, JointType, bind
from tests.kinematics import oracle
from tests.kinematics.robots import PRISMATIC_ENDS, PUMA560, PUMA560_CRAIG, RX90, SCARA_RRPR
from tests.kinematics.strategies import configured, tables

OTHER = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}


def pose(conversion, joints):
    base, tool = screw_transform(conversion.base), screw_transform(conversion.tool)
    return oracle.pose(conversion.table, joints, base, tool)


@given(configured())
def test_base_times_new_table_times_tool_is_the_old_table(robot):
    table, joints = robot
    size = 1.0 + sum(abs(row.a) + abs(row.d) for row in table.rows) + 3 * table.n_joints
    converted = convert(table, OTHER[table.convention])
    assert converted.table.convention is OTHER[table.convention]
    assert len(converted.table.rows) == len(table.rows)
    np.testing.assert_allclose(pose(converted, joints), oracle.pose(table, joints), atol=1e-14 * size)


@given(tables())
def test_there_and_back_gives_the_very_same_table(table):
    there = convert(table, OTHER[table.convention])
    back = convert(there.table, table.convention, base=there.base, tool=there.tool)
    assert back == Conversion(table=table, base=None, tool=None)


@given(tables())
def test_joints_keep_their_kind_their_sign_and_their_zero(table):
    for old, new in zip(table.rows, convert(table, OTHER[table.convention]).table.rows, strict=True):
        assert (old.joint, old.theta, old.d, old.sign) == (new.joint, new.theta, new.d, new.sign)


@given(tables(), st.none() | st.just(XScrew(a=0.3, alpha=0.2)))
def test_a_table_that_is_so_already_stays_as_it_is(table, screw):
    assert convert(table, table.convention, base=screw, tool=screw) == Conversion(
        table=table, base=screw, tool=screw
    )


@given(configured(min_rows=1, max_rows=5), st.floats(-1, 1), st.floats(-4, 4))
def test_given_base_and_tool_are_kept(robot, a, alpha):
    table, joints = robot
    base, tool = XScrew(a=a, alpha=alpha), XScrew(a=alpha, alpha=a)
    converted = convert(table, OTHER[table.convention], base=base, tool=tool)
    expected = oracle.pose(table, joints, screw_transform(base), screw_transform(tool))
    np.testing.assert_allclose(pose(converted, joints), expected, atol=1e-12)


@pytest.mark.parametrize("table", [PUMA560, PUMA560_CRAIG, RX90, SCARA_RRPR, PRISMATIC_ENDS])
def test_named_arms(table):
    for joints in np.random.default_rng(2).uniform(-3, 3, (5, table.n_joints)).tolist():
        converted = convert(table, OTHER[table.convention])
        np.testing.assert_allclose(pose(converted, joints), oracle.pose(table, joints), atol=1e-14)


def test_an_empty_table_has_nothing_to_move():
    empty = DHTable(convention=Convention.STANDARD, rows=())
    screw = XScrew(a=1.0, alpha=0.0)
    assert convert(empty, Convention.MODIFIED, tool=screw) == Conversion(
        table=DHTable(convention=Convention.MODIFIED, rows=()), base=None, tool=screw
    )


entries = st.sampled_from(
    [
        ZERO,
        number("0.4318"),
        Parameter("L1"),
        multiply((number(2), Parameter("L2"))),
        add((Parameter("L1"), number(Fraction(1, 3)))),
    ]
)
angles = st.sampled_from([ZERO, pi_times(Fraction(1, 2)), pi_times(Fraction(-1, 2)), Parameter("beta")])


@st.composite
def symbolic_tables(draw: st.DrawFn) -> DHTable[Expression]:
    rows = draw(
        st.lists(
            st.builds(
                DHRow,
                joint=st.sampled_from(JointType),
                theta=angles,
                d=entries,
                a=entries,
                alpha=angles,
                sign=st.sampled_from((1, -1)),
            ),
            max_size=6,
        )
    )
    return DHTable(convention=draw(st.sampled_from(Convention)), rows=tuple(rows))


@given(symbolic_tables(), st.data())
def test_symbols_stay_symbols(table, data):
    converted = convert(table, OTHER[table.convention])
    cells = {cell for row in table.rows for cell in (row.a, row.alpha, row.d, row.theta)} | {ZERO}
    moved = {cell for row in converted.table.rows for cell in (row.a, row.alpha, row.d, row.theta)}
    assert moved <= cells
    back = convert(converted.table, table.convention, base=converted.base, tool=converted.tool)
    assert back == Conversion(table=table, base=None, tool=None)
    parameters = {"L1": 0.3, "L2": -0.2, "beta": 0.7}
    joints = data.draw(st.tuples(*[st.floats(-3, 3)] * table.n_joints)).__iter__()
    q = list(joints)
    screws = [
        s and XScrew(a=evaluate(s.a, parameters), alpha=evaluate(s.alpha, parameters))
        for s in (converted.base, converted.tool)
    ]
    base, tool = (screw_transform(screw) for screw in screws)
    np.testing.assert_allclose(
        end_pose(bind(converted.table, parameters), q, base=base, tool=tool),
        end_pose(bind(table, parameters), q),
        atol=1e-13,
    )


def test_the_leftover_of_a_symbolic_table_is_exact():
    row = DHRow(
        joint=JointType.REVOLUTE, theta=ZERO, d=ZERO, a=Parameter("L1"), alpha=pi_times(Fraction(1, 2))
    )
    table = DHTable(convention=Convention.STANDARD, rows=(row, replace(row, a=Parameter("L2"))))
    converted = convert(table, Convention.MODIFIED)
    assert converted.base is None
    assert converted.tool == XScrew(a=Parameter("L2"), alpha=pi_times(Fraction(1, 2)))
    assert [row.a for row in converted.table.rows] == [ZERO, Parameter("L1")]
    assert fixed_row(converted.tool).a == Parameter("L2")
    joined = convert(table, Convention.MODIFIED, tool=XScrew(a=Parameter("L3"), alpha=ZERO))
    assert joined.tool == XScrew(a=add((Parameter("L2"), Parameter("L3"))), alpha=pi_times(Fraction(1, 2)))


def test_scara_of_seed_002_in_standard_form():
    """A modified table with a in rows 2 and 3 becomes the standard table with a in rows 1 and 2."""
    converted = convert(SCARA_RRPR, Convention.STANDARD)
    assert [row.a for row in converted.table.rows] == [0.4, 0.3, 0.0, 0.0]
    assert (converted.base, converted.tool) == (None, None)


def test_the_twist_of_the_puma_s_last_row_is_none():
    assert convert(PUMA560, Convention.MODIFIED).tool is None
    twisted = replace(PUMA560, rows=(*PUMA560.rows[:5], replace(PUMA560.rows[5], alpha=math.pi / 2)))
    assert convert(twisted, Convention.MODIFIED).tool == XScrew(a=0.0, alpha=math.pi / 2)
