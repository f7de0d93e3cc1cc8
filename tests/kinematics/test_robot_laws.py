"""The laws of the numeric core on every robot of the catalogue, in both conventions."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics import catalogue
from kinematics.cells import bind_parameters
from kinematics.conversion import XScrew, convert, screw_transform
from kinematics.expressions import evaluate
from kinematics.forward import end_pose, end_poses, forward_kinematics
from kinematics.jacobian import JacobianFrame, jacobian
from kinematics.screws import pose_of_product, product_of_exponentials, table_of_product
from kinematics.table import Convention, JointType, bind
from tests.conftest import EXPLORE
from tests.kinematics import oracle

ROBOTS = {robot.id: bind_parameters(robot.table, robot.parameters) for robot in catalogue.robots()}
OTHER = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}
EVERY_ROBOT = pytest.mark.parametrize("robot_id", ROBOTS)
EVERY_CONVENTION = pytest.mark.parametrize("convention", Convention)

turns = st.one_of(
    st.floats(-math.pi, math.pi),
    st.sampled_from((0.0, math.pi, -math.pi, math.pi / 2, -math.pi / 2, 1e-12, 7 * math.pi, 1e4)),
)


def size(table):
    return sum(abs(row.a) + abs(row.d) for row in table.rows) or 1.0


def arm(robot_id, convention):
    """A robot in a convention, with the base and tool that this takes."""
    converted = convert(ROBOTS[robot_id], convention)
    return converted.table, screw_transform(converted.base), screw_transform(converted.tool)


def draw_joints(data, table):
    slides = st.floats(-size(table), size(table))
    return list(
        data.draw(st.tuples(*(slides if k is JointType.PRISMATIC else turns for k in table.joint_types)))
    )


@EVERY_ROBOT
@EVERY_CONVENTION
@settings(max_examples=16 if EXPLORE else 3)
@given(st.data())
def test_poses_are_products_of_elementary_matrices_in_both_conventions(robot_id, convention, data):
    original = ROBOTS[robot_id]
    table, base, tool = arm(robot_id, convention)
    joints = draw_joints(data, original)
    expected = oracle.pose(original, joints)
    scale = np.array([[1.0, 1.0, 1.0, 2 * size(original)]] * 3 + [[1.0] * 4])
    result = forward_kinematics(table, joints, base=base, tool=tool)
    np.testing.assert_allclose(result.transform / scale, expected / scale, rtol=0, atol=1e-14)
    np.testing.assert_allclose(result.frames[-1] @ tool / scale, expected / scale, rtol=0, atol=1e-14)
    (batch,) = end_poses(table, [joints], base=base, tool=tool)
    np.testing.assert_allclose(batch / scale, expected / scale, rtol=0, atol=1e-14)


@EVERY_ROBOT
@EVERY_CONVENTION
@settings(max_examples=8 if EXPLORE else 2)
@given(st.data())
def test_jacobians_are_derivatives_in_both_conventions(robot_id, convention, data):
    table, base, tool = arm(robot_id, convention)
    joints = draw_joints(data, table)
    expected = oracle.jacobian(ROBOTS[robot_id], joints)
    rotation = oracle.pose(ROBOTS[robot_id], joints)[:3, :3]
    scale = np.array([[2 * size(table)]] * 3 + [[1.0]] * 3)
    found = jacobian(table, joints, base=base, tool=tool)
    np.testing.assert_allclose(found / scale, expected / scale, rtol=0, atol=1e-13)
    at_end = np.kron(np.eye(2), rotation) @ jacobian(table, joints, JacobianFrame.END, base=base, tool=tool)
    np.testing.assert_allclose(at_end / scale, expected / scale, rtol=0, atol=1e-13)


@EVERY_ROBOT
def test_symbolic_conversion_is_the_numeric_one(robot_id):
    robot = catalogue.robot(robot_id)
    exact = robot.table.table
    to = OTHER[exact.convention]
    symbolic, numeric = convert(exact, to), convert(ROBOTS[robot_id], to)
    assert symbolic.table.rows[0].joint is exact.rows[0].joint
    values = robot.parameters
    lengths_only = all(kind == "length" for kind in map(str, robot.table.parameters.values()))
    assert lengths_only, "bind takes angles in radians"
    assert bind(symbolic.table, values) == numeric.table
    for screw, bound in ((symbolic.base, numeric.base), (symbolic.tool, numeric.tool)):
        in_numbers = screw and XScrew(a=evaluate(screw.a, values), alpha=evaluate(screw.alpha, values))
        assert in_numbers == bound
    back = convert(symbolic.table, exact.convention, base=symbolic.base, tool=symbolic.tool)
    assert (back.table, back.base, back.tool) == (exact, None, None)


@EVERY_ROBOT
@EVERY_CONVENTION
def test_products_of_exponentials_there_and_back(robot_id, convention):
    original = ROBOTS[robot_id]
    product = product_of_exponentials(original)
    found = table_of_product(product, convention)
    scale = np.array([[1.0, 1.0, 1.0, 2 * size(original)]] * 3 + [[1.0] * 4])
    slides = [size(original) if kind is JointType.PRISMATIC else 3.0 for kind in original.joint_types]
    for joints in np.random.default_rng(11).uniform(-1, 1, (4, original.n_joints)) * slides:
        expected = end_pose(original, joints) / scale
        np.testing.assert_allclose(pose_of_product(product, joints) / scale, expected, rtol=0, atol=1e-13)
        again = end_pose(found.table, joints, base=found.base, tool=found.tool) / scale
        np.testing.assert_allclose(again, expected, rtol=0, atol=1e-12)
