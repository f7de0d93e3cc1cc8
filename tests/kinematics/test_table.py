"""Tables: joints among the rows, and numbers in the place of symbols."""

from dataclasses import replace

import pytest

from kinematics.errors import ParameterError
from kinematics.expressions import ZERO, Function, Parameter, add, call, multiply, number, power
from kinematics.table import Convention, DHRow, DHTable, JointType, bind, table_parameters

REVOLUTE = DHRow(joint=JointType.REVOLUTE, theta=ZERO, d=ZERO, a=Parameter("L1"), alpha=ZERO)
FIXED = replace(REVOLUTE, joint=JointType.FIXED, a=ZERO)
PRISMATIC = replace(REVOLUTE, joint=JointType.PRISMATIC, a=ZERO, d=Parameter("d0"), sign=-1)


def table(*rows):
    return DHTable(convention=Convention.MODIFIED, rows=rows)


def test_fixed_rows_are_not_joints():
    mixed = table(FIXED, REVOLUTE, FIXED, PRISMATIC, FIXED)
    assert mixed.joint_rows == (1, 3)
    assert mixed.joint_types == (JointType.REVOLUTE, JointType.PRISMATIC)
    assert mixed.n_joints == 2


def test_binding_puts_numbers_in_place():
    bound = bind(table(REVOLUTE, PRISMATIC), {"L1": 0.4, "d0": 0.1, "unused": 3.0})
    assert [row.a for row in bound.rows] == [0.4, 0.0]
    assert (bound.rows[1].d, bound.rows[1].sign, bound.rows[1].joint) == (0.1, -1, JointType.PRISMATIC)
    assert all(isinstance(row.theta, float) for row in bound.rows)


def test_all_faults_are_told_at_once_each_at_its_place():
    undefined = replace(REVOLUTE, d=call(Function.SQRT, number(-1)), alpha=Parameter("beta"))
    with pytest.raises(ParameterError) as error:
        bind(table(REVOLUTE, undefined, REVOLUTE))
    found = {(fault.code, fault.where) for fault in error.value.faults}
    assert found == {
        ("parameter_missing", ("parameters", "L1")),
        ("parameter_missing", ("parameters", "beta")),
        ("value_undefined", ("rows", 1, "d")),
    }


def test_parameters_in_the_order_in_which_they_are_met():
    first = replace(
        REVOLUTE, a=add((Parameter("L2"), Parameter("L1"))), d=multiply((Parameter("L3"), number(2)))
    )
    second = replace(REVOLUTE, a=power(Parameter("L0"), 2))
    assert table_parameters(table(first, second)) == ("L1", "L2", "L3", "L0")
