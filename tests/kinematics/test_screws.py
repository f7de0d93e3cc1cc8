"""Products of exponentials, and exponentials of twists, against power series."""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.errors import DescriptionError, JointValueError, PoseError
from kinematics.forward import end_pose
from kinematics.jacobian import jacobian
from kinematics.screws import (
    ProductOfExponentials,
    Screw,
    exponential,
    pose_of_product,
    product_of_exponentials,
    table_of_product,
)
from kinematics.table import Convention, JointType
from tests.kinematics import oracle
from tests.kinematics.robots import PLANAR4, PRISMATIC_ENDS, PUMA560, PUMA560_CRAIG, RX90, SCARA_RRPR
from tests.kinematics.strategies import configured, transforms

ROBOTS = [PUMA560, PUMA560_CRAIG, RX90, SCARA_RRPR, PLANAR4, PRISMATIC_ENDS]

numbers = st.one_of(st.floats(-3, 3), st.sampled_from((0.0, 1.0, 1e-12, -1e-9, 1e-5, 1e-160)))
vectors = st.tuples(numbers, numbers, numbers)


def series(screw, q):
    """The matrix exponential by its power series, in 60 digits."""
    with mpmath.workdps(60):
        (vx, vy, vz), (wx, wy, wz) = screw
        rates = [[0, -wz, wy, vx], [wz, 0, -wx, vy], [-wy, wx, 0, vz], [0, 0, 0, 0]]
        twist = np.array([[mpmath.mpf(x) * mpmath.mpf(q) for x in row] for row in rates])
        term = total = np.eye(4, dtype=object)
        for n in range(1, 90):
            term = term @ twist / n
            total = total + term
        return oracle.as_array(total)


@given(vectors, vectors, st.floats(-2, 2))
def test_exponential_is_the_power_series(linear, angular, q):
    expected = series((linear, angular), q)
    np.testing.assert_allclose(exponential(Screw(linear, angular), q), expected, atol=2e-14)


@pytest.mark.parametrize(
    "angle", [1e-300, 1e-12, 1e-8, 0.99e-4, 1.01e-4, 1e-3, math.pi - 1e-9, math.pi, 2 * math.pi]
)
def test_exponential_at_the_edges_of_its_formulas(angle):
    screw = ((0.3, -2.0, 0.7), (0.6, 0.0, 0.8))
    np.testing.assert_allclose(exponential(Screw(*screw), angle), series(screw, angle), rtol=0, atol=2e-15)


@given(configured(max_rows=6), st.none() | transforms(), st.none() | transforms())
def test_product_of_exponentials_is_the_table(robot, base, tool):
    table, joints = robot
    size = (
        2.0
        + sum(abs(row.a) + abs(row.d) for row in table.rows)
        + sum(
            abs(q) for q, kind in zip(joints, table.joint_types, strict=True) if kind is JointType.PRISMATIC
        )
    )
    product = product_of_exponentials(table, base=base, tool=tool)
    expected = end_pose(table, joints, base=base, tool=tool)
    large = 1.0 + max(map(abs, joints), default=0.0)
    np.testing.assert_allclose(pose_of_product(product, joints), expected, atol=1e-14 * size * large)


@pytest.mark.parametrize("table", ROBOTS)
def test_screws_are_the_jacobian_at_zero_about_the_origin(table):
    """The velocity of the point that is at the world's origin; at q = 0 the columns of J0 moved there."""
    zero = [0.0] * table.n_joints
    columns = jacobian(table, zero).T
    tip = end_pose(table, zero)[:3, 3]
    for screw, column in zip(product_of_exponentials(table).screws, columns, strict=True):
        np.testing.assert_allclose(screw.angular, column[3:], atol=1e-15)
        np.testing.assert_allclose(screw.linear, column[:3] - np.cross(column[3:], tip), atol=1e-15)


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize("table", ROBOTS)
def test_a_product_of_exponentials_is_a_table_again(table, convention):
    product = product_of_exponentials(table)
    found = table_of_product(product, convention)
    assert found.table.convention is convention
    assert found.table.joint_types == table.joint_types
    for joints in np.random.default_rng(8).uniform(-2, 2, (5, table.n_joints)):
        again = end_pose(found.table, joints, base=found.base, tool=found.tool)
        np.testing.assert_allclose(again, end_pose(table, joints), atol=1e-12)


def test_scara_of_the_textbook():
    """Murray, Li, Sastry, example 3.1, with the axes of its figure 3.3."""
    l1, l2, l0 = 0.4, 0.3, 0.2
    home = np.eye(4)
    home[:3, 3] = (0.0, l1 + l2, l0)
    up = (0.0, 0.0, 1.0)
    product = ProductOfExponentials(
        screws=(
            Screw((0.0, 0.0, 0.0), up),
            Screw((l1, 0.0, 0.0), up),
            Screw((l1 + l2, 0.0, 0.0), up),
            Screw(up, (0.0, 0.0, 0.0)),
        ),
        home=home,
    )
    q1, q2, q3, q4 = 0.3, -0.5, 1.1, 0.25
    pose = pose_of_product(product, [q1, q2, q3, q4])
    position = [
        -l1 * math.sin(q1) - l2 * math.sin(q1 + q2),
        l1 * math.cos(q1) + l2 * math.cos(q1 + q2),
        l0 + q4,
    ]
    np.testing.assert_allclose(pose[:3, 3], position, atol=1e-15)
    assert math.atan2(pose[1, 0], pose[0, 0]) == pytest.approx(q1 + q2 + q3)


@pytest.mark.parametrize(
    ("screw", "code"),
    [
        (Screw((0.0, 0.0, 0.0), (0.0, 0.0, 2.0)), "screw_not_unit"),
        (Screw((0.0, 0.5, 0.0), (0.0, 0.0, 0.0)), "screw_not_unit"),
        (Screw((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), "screw_not_unit"),
        (Screw((math.nan, 0.0, 0.0), (0.0, 0.0, 1.0)), "screw_not_finite"),
        (Screw((1.0, 0.0, 0.1), (0.0, 0.0, 1.0)), "screw_has_pitch"),
    ],
)
def test_screws_that_no_joint_has_are_refused(screw, code):
    good = Screw((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    with pytest.raises(DescriptionError) as error:
        table_of_product(ProductOfExponentials(screws=(good, screw), home=np.eye(4)), Convention.STANDARD)
    assert error.value.code == code
    assert error.value.faults[0].where == ("screws", 1)


def test_the_home_pose_must_be_rigid():
    with pytest.raises(PoseError) as error:
        table_of_product(ProductOfExponentials(screws=(), home=np.ones((4, 4))), Convention.STANDARD)
    assert error.value.faults[0].where[0] == "home"


def test_joint_values_that_are_none_are_refused():
    with pytest.raises(JointValueError):
        pose_of_product(product_of_exponentials(PUMA560), [0.0] * 5)


def test_what_a_program_leaves_of_zero_does_not_turn():
    """ω of a slide may be 6e-17: rounding, as in every number that a program computed."""
    home = np.eye(4)
    slide = Screw((0.0, 0.0, 1.0), (6.1e-17, -1.3e-33, 0.0))
    found = table_of_product(ProductOfExponentials(screws=(slide,), home=home), Convention.STANDARD)
    assert [row.joint for row in found.table.rows] == [JointType.PRISMATIC]
    with pytest.raises(DescriptionError):
        table_of_product(
            ProductOfExponentials(screws=(Screw((0.0, 0.0, 1.0), (1e-8, 0.0, 0.0)),), home=home),
            Convention.STANDARD,
        )
