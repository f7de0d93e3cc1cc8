"""Jacobians: against finite differences in 50 digits, and by their laws."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.errors import JointValueError
from kinematics.evaluation.plan import WARM
from kinematics.forward import end_pose
from kinematics.jacobian import JacobianFrame, dexterity, jacobian
from kinematics.table import DHTable, JointType
from tests.kinematics import oracle
from tests.kinematics.robots import PLANAR4, PRISMATIC_ENDS, PUMA560, PUMA560_CRAIG, RIGHT, RX90, SCARA_RRPR
from tests.kinematics.strategies import configured, transforms

ROBOTS = {
    "puma560": PUMA560,
    "puma560-craig": PUMA560_CRAIG,
    "rx90": RX90,
    "scara": SCARA_RRPR,
    "planar4": PLANAR4,
    "prismatic-ends": PRISMATIC_ENDS,
}


def parts(result):
    return result.twist, result.translation, result.rotation


def size(table, joints, *poses):
    lengths = sum(abs(row.a) + abs(row.d) for row in table.rows)
    slides = sum(
        abs(q) for q, kind in zip(joints, table.joint_types, strict=True) if kind is JointType.PRISMATIC
    )
    return 1.0 + lengths + slides + sum(np.abs(pose[:3, 3]).sum() for pose in poses if pose is not None)


@given(configured(max_rows=6), st.none() | transforms(), st.none() | transforms())
def test_jacobians_are_derivatives_of_the_pose(robot, base, tool):
    table, joints = robot
    expected = oracle.jacobian(table, joints, base, tool)
    rotation = oracle.pose(table, joints, base, tool)[:3, :3]
    inward = np.kron(np.eye(2), rotation.T)
    tolerance = 1e-14 * (len(table.rows) + 2) * size(table, joints, base, tool)
    for _ in range(WARM + 1):
        in_base = jacobian(table, joints, base=base, tool=tool)
        in_end = jacobian(table, joints, JacobianFrame.END, base=base, tool=tool)
        assert in_base.shape == in_end.shape == (6, table.n_joints)
        np.testing.assert_allclose(in_base, expected, rtol=0, atol=tolerance)
        np.testing.assert_allclose(in_end, inward @ expected, rtol=0, atol=tolerance)
    for frame, single in ((JacobianFrame.BASE, in_base), (JacobianFrame.END, in_end)):
        (batch,) = jacobian(table, [joints], frame, base=base, tool=tool)
        np.testing.assert_allclose(batch, single, rtol=0, atol=tolerance)


@pytest.mark.parametrize("table", ROBOTS.values(), ids=ROBOTS)
def test_batches_agree_with_single_configurations(table):
    joints = np.random.default_rng(7).uniform(-math.pi, math.pi, (4100, table.n_joints))
    for frame in JacobianFrame:
        batch = jacobian(table, joints, frame)
        assert batch.shape == (4100, 6, table.n_joints)
        for i in (0, 4095, 4096, 4099):
            np.testing.assert_allclose(batch[i], jacobian(table, joints[i], frame), atol=1e-14)


@given(configured(min_rows=1, max_rows=6), st.floats(-2, 2))
def test_a_tool_offset_adds_the_velocity_of_its_lever(robot, length):
    table, joints = robot
    tool = np.eye(4)
    tool[:3, 3] = (length, 0.1, -length)
    lever = end_pose(table, joints)[:3, :3] @ tool[:3, 3]
    plain, moved = jacobian(table, joints), jacobian(table, joints, tool=tool)
    expected = plain[:3] + np.cross(plain[3:].T, lever).T
    np.testing.assert_allclose(moved[:3], expected, atol=1e-13 * size(table, joints))
    np.testing.assert_allclose(moved[3:], plain[3:], atol=1e-14)


def test_a_reversed_variable_turns_its_column():
    joints = [0.3, -0.4, 0.7, 1.1, -0.2, 0.9]
    rows = (replace(PUMA560.rows[0], sign=-1), *PUMA560.rows[1:])
    turned = DHTable(convention=PUMA560.convention, rows=rows)
    signs = [-1, 1, 1, 1, 1, 1]
    expected = jacobian(PUMA560, joints) * signs
    np.testing.assert_allclose(jacobian(turned, [-0.3, *joints[1:]]), expected, atol=1e-15)


def test_planar_arm_in_closed_form():
    """B. Siciliano et al., Robotics: Modelling, Planning and Control, eq. 3.35 with four links of 0.5 m."""
    q = np.array([0.3, -0.8, 0.5, 1.2])
    angles = np.cumsum(q)
    x, y = 0.5 * np.cos(angles), 0.5 * np.sin(angles)
    expected = np.zeros((6, 4))
    expected[0], expected[1], expected[5] = -np.cumsum(y[::-1])[::-1], np.cumsum(x[::-1])[::-1], 1.0
    np.testing.assert_allclose(jacobian(PLANAR4, q), expected, atol=1e-15)


@pytest.mark.parametrize(
    ("table", "joints", "rank", "generic"),
    [
        (PUMA560, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], 6, 6),
        (PUMA560, [0.1, 0.2, 0.3, 0.4, 0.0, 0.6], 5, 6),
        (PUMA560, [0.1, 0.2, 0.3, 0.4, math.pi, 0.6], 5, 6),
        (PUMA560, [0.1, 0.2, 0.3, 0.4, 1e-5, 0.6], 6, 6),
        (RX90, [0.1, 0.2, -RIGHT, 0.4, 0.5, 0.6], 5, 6),
        (RX90, [0.1, 0.2, 0.7, 0.4, 0.0, 0.6], 5, 6),
        (SCARA_RRPR, [0.1, 0.2, 0.3, 0.4], 4, 4),
        (SCARA_RRPR, [0.1, 0.0, 0.3, 0.4], 3, 4),
        (PLANAR4, [0.1, 0.2, 0.3, 0.4], 3, 3),
        (PLANAR4, [0.1, 0.0, 0.0, 0.0], 2, 3),
        (PLANAR4, [0.1, math.pi, 0.0, math.pi], 2, 3),
    ],
)
def test_singular_means_that_a_direction_of_motion_is_lost(table, joints, rank, generic):
    result = dexterity(table, joints).twist
    assert (result.rank, result.generic_rank) == (rank, generic)
    assert bool(result.singular) is (rank < generic)
    assert np.isinf(result.condition) == (rank < generic)


@pytest.mark.parametrize("scale", [1e-3, 1e3, 1e6])
@pytest.mark.parametrize("table", ROBOTS.values(), ids=ROBOTS)
def test_the_verdict_does_not_depend_on_the_unit_of_length(table, scale):
    slides = np.array([scale if kind is JointType.PRISMATIC else 1.0 for kind in table.joint_types])
    scaled = DHTable(
        convention=table.convention,
        rows=tuple(replace(row, a=row.a * scale, d=row.d * scale) for row in table.rows),
    )
    joints = np.random.default_rng(3).uniform(-1.0, 1.0, (20, table.n_joints))
    joints[0] = 0.0
    here, there = dexterity(table, joints), dexterity(scaled, joints * slides)
    for small, large in zip(parts(here), parts(there), strict=True):
        np.testing.assert_allclose(small.singular_values, large.singular_values, atol=1e-12)
        assert small.rank.tolist() == large.rank.tolist()
        assert small.generic_rank == large.generic_rank


@pytest.mark.parametrize(
    ("name", "task"),
    [("puma560", range(6)), ("rx90", range(6)), ("planar4", [0, 1, 5]), ("scara", [0, 1, 2, 5])],
)
def test_manipulability_is_yoshikawa_s(name, task):
    table = ROBOTS[name]
    joints = np.random.default_rng(5).uniform(-1.0, 1.0, (10, table.n_joints))
    for q, measured in zip(joints, dexterity(table, joints).twist.manipulability, strict=True):
        j = jacobian(table, q)[list(task)]
        assert measured == pytest.approx(math.sqrt(np.linalg.det(j @ j.T)), rel=1e-9)
        assert dexterity(table, q).twist.manipulability == pytest.approx(measured, rel=1e-13)


@pytest.mark.parametrize("elbow", [0.0, 0.3, -RIGHT, math.pi])
def test_a_stretched_two_link_arm_is_singular_in_its_translation(elbow):
    """Siciliano et al., example 3.4: w = a1·a2·|sin q2|."""
    arm = DHTable(convention=PLANAR4.convention, rows=(PLANAR4.rows[0], replace(PLANAR4.rows[1], a=0.3)))
    result = dexterity(arm, [0.4, elbow])
    stretched = elbow in (0.0, math.pi)
    assert bool(result.translation.singular) is stretched
    assert result.translation.manipulability == pytest.approx(0.5 * 0.3 * abs(math.sin(elbow)), abs=1e-15)
    assert not result.twist.singular
    assert (result.rotation.rank, result.rotation.generic_rank) == (1, 1)


def test_dexterity_does_not_depend_on_the_base():
    base = np.eye(4)
    base[:3, :3] = oracle.as_array(oracle.elementary("x", 0.4, 0.0))[:3, :3]
    q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
    for turned, plain in zip(
        parts(dexterity(PUMA560, q, base=base)), parts(dexterity(PUMA560, q)), strict=True
    ):
        np.testing.assert_allclose(turned.singular_values, plain.singular_values, atol=1e-14)


def test_an_arm_without_joints_cannot_move():
    welded = DHTable(
        convention=PUMA560.convention, rows=tuple(replace(row, joint=JointType.FIXED) for row in PUMA560.rows)
    )
    assert jacobian(welded, []).shape == (6, 0)
    assert jacobian(welded, np.empty((5, 0))).shape == (5, 6, 0)
    for result in parts(dexterity(welded, [])):
        assert (result.rank, result.generic_rank, result.manipulability) == (0, 0, 0.0)
        assert not result.singular


@pytest.mark.parametrize("frame", JacobianFrame)
def test_joint_values_that_are_none_are_refused(frame):
    with pytest.raises(JointValueError) as error:
        jacobian(PUMA560, [0.0] * 5, frame)
    assert error.value.code == "joints_wrong_length"
    with pytest.raises(JointValueError) as error:
        dexterity(PUMA560, [math.nan] * 6)
    assert error.value.code == "joint_not_finite"
