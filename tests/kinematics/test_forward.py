"""Forward kinematics: against a second derivation, and by its laws."""

import contextlib
import copy
import math
import pickle
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.angles import are_ordinary
from kinematics.dh import link_transform, link_transforms
from kinematics.errors import JointValueError, KinematicsError, PoseError, TableError
from kinematics.evaluation.plan import WARM, plan_of
from kinematics.forward import end_pose, end_poses, forward_kinematics
from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.kinematics import oracle
from tests.kinematics.robots import PUMA560, PUMA560_CRAIG, SCARA_RRPR
from tests.kinematics.strategies import configured, tables, transforms

EPS = np.finfo(float).eps
EYE = np.eye(4)


def reach(table, joints=(), *poses):
    """What lengths are compared with: an error of a few units in the last place of the longest stretch."""
    lengths = sum(abs(row.a) + abs(row.d) for row in table.rows)
    slides = sum(
        abs(q) for q, kind in zip(joints, table.joint_types, strict=False) if kind is JointType.PRISMATIC
    )
    return 1.0 + lengths + slides + sum(np.abs(pose[:3, 3]).sum() for pose in poses if pose is not None)


def ways(table, joints, **frames):
    """The same pose in every way that it can be computed: walked, straight, and in a batch."""
    fresh = DHTable(convention=table.convention, rows=table.rows)
    plan = plan_of.__globals__["_plans_of_equal"].__wrapped__(fresh)
    fresh.__dict__["_plans"] = plan
    walked = end_pose(fresh, joints, **frames)
    for _ in range(WARM):
        straight = end_pose(fresh, joints, **frames)
    (batch,) = end_poses(fresh, [joints], **frames)
    return {"walked": walked, "straight": straight, "batch": batch}


@given(configured(), st.none() | transforms(), st.none() | transforms())
def test_pose_is_the_product_of_elementary_matrices(robot, base, tool):
    table, joints = robot
    expected = oracle.pose(table, joints, base, tool)
    tolerance = 8 * EPS * (len(table.rows) + 2) * reach(table, joints, base, tool)
    for way, pose in ways(table, joints, base=base, tool=tool).items():
        np.testing.assert_allclose(pose, expected, rtol=0, atol=tolerance, err_msg=way)


@given(configured(min_rows=1, max_rows=6), st.none() | transforms())
def test_links_and_frames_are_the_products_of_elementary_matrices(robot, base):
    table, joints = robot
    links = np.array([oracle.as_array(link) for link in oracle.links(table, joints)])
    tolerance = 8 * EPS * (len(table.rows) + 1) * reach(table, joints, base)
    for _ in range(WARM + 1):
        result = forward_kinematics(table, joints, base=base)
        np.testing.assert_allclose(result.links, links, rtol=0, atol=tolerance)
        np.testing.assert_allclose(result.frames, oracle.frames(table, joints, base), rtol=0, atol=tolerance)
    batch = forward_kinematics(table, [joints, joints], base=base)
    assert batch.links.shape == batch.frames.shape == (2, len(table.rows), 4, 4)
    np.testing.assert_allclose(batch.links[1], links, rtol=0, atol=tolerance)
    np.testing.assert_allclose(batch.frames[1], result.frames, rtol=0, atol=tolerance)


@given(configured())
def test_poses_are_rigid(robot):
    table, joints = robot
    for pose in ways(table, joints).values():
        rotation = pose[:3, :3]
        np.testing.assert_allclose(rotation.T @ rotation, np.eye(3), rtol=0, atol=1e-14)
        assert np.linalg.det(rotation) == pytest.approx(1.0, abs=1e-14)
        assert pose[3].tolist() == [0.0, 0.0, 0.0, 1.0]


@given(configured(min_rows=1), st.data())
def test_a_chain_is_the_product_of_its_halves(robot, data):
    table, joints = robot
    cut = data.draw(st.integers(0, len(table.rows)))
    lower = DHTable(convention=table.convention, rows=table.rows[:cut])
    upper = DHTable(convention=table.convention, rows=table.rows[cut:])
    split = end_pose(lower, joints[: lower.n_joints]) @ end_pose(upper, joints[lower.n_joints :])
    whole = end_pose(table, joints)
    np.testing.assert_allclose(whole, split, rtol=0, atol=1e-14 * reach(table, joints))


@given(configured(min_rows=1), transforms(), transforms())
def test_base_and_tool_are_factors(robot, base, tool):
    table, joints = robot
    plain, framed = forward_kinematics(table, joints), forward_kinematics(table, joints, base=base, tool=tool)
    tolerance = 1e-14 * reach(table, joints, base, tool)
    np.testing.assert_allclose(framed.transform, base @ plain.transform @ tool, rtol=0, atol=tolerance)
    np.testing.assert_allclose(framed.frames, base @ plain.frames, rtol=0, atol=tolerance)
    np.testing.assert_allclose(framed.links, plain.links, rtol=0, atol=tolerance)


@given(configured(min_rows=1))
def test_frames_are_cumulative_products_of_links(robot):
    table, joints = robot
    result = forward_kinematics(table, joints)
    pose = EYE
    for link, frame in zip(result.links, result.frames, strict=True):
        pose = pose @ link
        np.testing.assert_allclose(frame, pose, rtol=0, atol=1e-14 * reach(table, joints))
    assert np.array_equal(result.frames[-1], result.transform)


@given(configured(min_rows=1))
def test_a_reversed_variable_is_the_negative_variable(robot):
    table, joints = robot
    turned = DHTable(
        convention=table.convention, rows=tuple(replace(row, sign=-row.sign) for row in table.rows)
    )
    negated = [-q for q in joints]
    expected = end_pose(table, joints)
    np.testing.assert_allclose(end_pose(turned, negated), expected, atol=1e-14 * reach(table, joints))


@given(tables(), st.lists(st.floats(-3, 3), min_size=2, max_size=4))
def test_link_transforms_of_several_sets_of_numbers_are_those_of_each(table, joints):
    for row in table.rows:
        other = replace(row, a=row.a + 0.5, theta=row.theta - 0.3)
        for convention in Convention:
            found = link_transforms((row, other), convention, (np.array(joints), np.array(joints[:1])))
            wanted = [link_transform(row, convention, q) for q in joints]
            wanted.append(link_transform(other, convention, joints[0]))
            np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12 * reach(table, joints))


@given(tables(min_rows=1, max_rows=4))
def test_link_transform_is_one_factor(table):
    row = table.rows[0]
    for convention in Convention:
        np.testing.assert_allclose(
            link_transform(row, convention, 0.7),
            oracle.as_array(oracle.link(row, convention, 0.7)),
            atol=4 * EPS * reach(table, (0.7,)),
        )


def test_batches_of_every_size_agree_with_single_configurations():
    rng = np.random.default_rng(4096)
    for table in (PUMA560, SCARA_RRPR):
        joints = rng.uniform(-math.pi, math.pi, (4097, table.n_joints))
        for size in (0, 1, 2, 4095, 4096, 4097):
            poses = end_poses(table, joints[:size])
            assert poses.shape == (size, 4, 4)
            assert poses.flags.c_contiguous
            for i in {0, size // 2, size - 1} & set(range(size)):
                np.testing.assert_allclose(poses[i], end_pose(table, joints[i]), atol=2e-15)


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64, ">f8", np.int64])
def test_any_array_of_numbers_will_do(order, dtype):
    joints = np.arange(18).reshape(3, 6).astype(dtype, order=order)
    expected = end_poses(PUMA560, joints.astype(float).tolist())
    assert np.array_equal(end_poses(PUMA560, joints), expected)
    np.testing.assert_allclose(end_pose(PUMA560, joints[1]), expected[1], atol=2e-15)
    np.testing.assert_allclose(end_pose(PUMA560, joints[1].tolist()), expected[1], atol=2e-15)
    np.testing.assert_allclose(end_pose(PUMA560, tuple(joints[1].tolist())), expected[1], atol=2e-15)


@pytest.mark.parametrize(
    "q",
    [math.pi, -math.pi, 3 * math.pi, -101 * math.pi, np.nextafter(math.pi, 0), np.nextafter(-math.pi, -4)],
)
def test_near_half_turns_the_tangent_of_the_half_angle_loses_nothing(q):
    arm = DHTable(
        convention=Convention.STANDARD,
        rows=(DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=1.0, alpha=0.0),),
    )
    (pose,) = end_poses(arm, [[q]])
    assert pose[0, 0] == math.cos(q) == -1.0
    assert pose[1, 0] == (pytest.approx(math.sin(q), rel=4 * EPS, abs=0) if are_ordinary([q]) else 0.0)


def test_right_angles_of_a_table_leave_exact_zeros():
    for pose in (end_pose(PUMA560, [0.0] * 6), end_poses(PUMA560, [[0.0] * 6])[0]):
        assert pose[:3, :3].tolist() == np.eye(3).tolist()
        assert not np.signbit(pose[pose == 0]).any()


def test_right_angles_of_joints_leave_exact_zeros():
    joints = [math.radians(q) for q in (0, 90, -90, 180, 270, -360)]
    poses = [end_pose(PUMA560, joints) for _ in range(WARM + 2)] + [end_poses(PUMA560, [joints])[0]]
    for pose in poses:
        assert set(np.abs(pose[:3, :3]).ravel()) == {0.0, 1.0}
        assert pose.tobytes() == poses[0].tobytes()


def test_puma_zero_pose_is_the_published_one():
    """Zero angles: the arm stretched along x. P. I. Corke and B. Armstrong-Hélouvry, ICRA 1994, table 1."""
    expected = [[1, 0, 0, 0.4521], [0, 1, 0, -0.15005], [0, 0, 1, 0.4318], [0, 0, 0, 1]]
    np.testing.assert_allclose(end_pose(PUMA560, [0.0] * 6), expected, atol=1e-15)


def test_puma_of_craig_in_closed_form():
    """J. J. Craig, Introduction to Robotics (3rd ed.), eq. 3.14, with its symbols."""
    a2, a3, d3, d4 = 0.4318, 0.0203, 0.15005, 0.4318
    q = [0.3, -0.7, 1.1, 0.4, -0.9, 2.2]
    (c1, c2, _, c4, c5, c6), (s1, s2, _, s4, s5, s6) = np.cos(q), np.sin(q)
    c23, s23 = math.cos(q[1] + q[2]), math.sin(q[1] + q[2])
    r11 = c1 * (c23 * (c4 * c5 * c6 - s4 * s6) - s23 * s5 * c6) + s1 * (s4 * c5 * c6 + c4 * s6)
    r33 = s23 * c4 * s5 - c23 * c5
    px = c1 * (a2 * c2 + a3 * c23 - d4 * s23) - d3 * s1
    py = s1 * (a2 * c2 + a3 * c23 - d4 * s23) + d3 * c1
    pz = -a3 * s23 - a2 * s2 - d4 * c23
    pose = end_pose(PUMA560_CRAIG, q)
    np.testing.assert_allclose([pose[0, 0], pose[2, 2], *pose[:3, 3]], [r11, r33, px, py, pz], atol=1e-15)


def test_equal_tables_share_a_plan_and_leave_it_behind_when_they_travel():
    one, twin = (DHTable(convention=PUMA560.convention, rows=PUMA560.rows) for _ in range(2))
    assert plan_of(twin) is plan_of(one)
    for _ in range(2 * WARM):
        expected = end_pose(PUMA560, [0.1] * 6)
    for copied in (pickle.loads(pickle.dumps(PUMA560)), copy.deepcopy(PUMA560), copy.copy(PUMA560)):
        assert copied == PUMA560
        assert np.array_equal(end_pose(copied, [0.1] * 6), expected)


def test_results_do_not_change_with_the_caller_s_arrays():
    joints = np.full((2, 6), 0.3)
    result = forward_kinematics(PUMA560, joints)
    joints[:] = 9.0
    assert np.array_equal(result.frames[:, -1], result.transform)
    base = np.eye(4)
    before = end_pose(PUMA560, [0.3] * 6, base=base)
    base[0, 3] = 5.0
    assert end_pose(PUMA560, [0.3] * 6, base=base)[0, 3] == pytest.approx(before[0, 3] + 5.0)


def test_an_empty_table_is_the_identity():
    empty = DHTable(convention=Convention.MODIFIED, rows=())
    for _ in range(WARM + 2):
        assert np.array_equal(end_pose(empty, []), EYE)
    assert forward_kinematics(empty, []).links.shape == (0, 4, 4)
    assert np.array_equal(end_poses(empty, np.empty((3, 0))), np.array([EYE] * 3))


@pytest.mark.parametrize(
    ("joints", "code", "where"),
    [
        ([0.0] * 5, "joints_wrong_length", ("joints",)),
        ([0.0] * 7, "joints_wrong_length", ("joints",)),
        ([], "joints_wrong_length", ("joints",)),
        (0.0, "joints_malformed", ("joints",)),
        ([0, 0, math.nan, 0, 0, 0.0], "joint_not_finite", ("joints", 2)),
        (np.array([0, 0, 0, 0, 0, math.inf]), "joint_not_finite", ("joints", 5)),
        (["0"] * 6, "joints_malformed", ("joints",)),
        ([True] * 6, "joints_malformed", ("joints",)),
        ([None] * 6, "joints_malformed", ("joints",)),
        ([1j] * 6, "joints_malformed", ("joints",)),
        ([10**400] * 6, "joints_malformed", ("joints",)),
        ([[0.0] * 6, [0.0] * 5], "joints_malformed", ("joints",)),
        ([[0.0] * 5], "joints_wrong_length", ("joints",)),
        ([[0.0] * 6, [0, 0, -math.inf, 0, 0, 0]], "joint_not_finite", ("joints", 1, 2)),
        (np.zeros((2, 2, 6)), "joints_malformed", ("joints",)),
    ],
)
def test_joint_values_that_are_none_are_refused(joints, code, where):
    with pytest.raises(JointValueError) as error:
        forward_kinematics(PUMA560, joints)
    assert error.value.code == code
    assert error.value.faults[0].where == where


def test_one_configuration_is_no_batch_and_a_batch_is_no_configuration():
    with pytest.raises(JointValueError) as error:
        end_pose(PUMA560, [[0.0] * 6])
    assert error.value.code == "joints_malformed"
    with pytest.raises(JointValueError) as error:
        end_poses(PUMA560, [0.0] * 6)
    assert error.value.code == "joints_malformed"
    assert end_poses(PUMA560, []).shape == (0, 4, 4)


def test_every_value_that_is_not_finite_is_named():
    with pytest.raises(JointValueError) as error:
        end_pose(PUMA560, [math.nan, 0, math.inf, 0, 0, -math.inf])
    assert [fault.where for fault in error.value.faults] == [("joints", 0), ("joints", 2), ("joints", 5)]


def test_large_finite_values_are_not_mistaken_for_infinite_ones():
    big = [1.7e308, 1.7e308, -1.7e308, 0.0, 0.0, 0.0]
    reduced = [math.atan2(math.sin(q), math.cos(q)) for q in big]
    np.testing.assert_allclose(end_pose(PUMA560, big), end_pose(PUMA560, reduced), atol=1e-14)
    np.testing.assert_allclose(end_poses(PUMA560, [big])[0], end_pose(PUMA560, reduced), atol=1e-14)


def overflowing(*joints: JointType) -> DHTable[float]:
    rows = tuple(DHRow(joint=joint, theta=0.0, d=0.0, a=1e308, alpha=0.0) for joint in joints)
    return DHTable(convention=Convention.STANDARD, rows=rows)


@pytest.mark.parametrize(
    "call", [lambda t, q: end_pose(t, q), lambda t, q: forward_kinematics(t, q).transform]
)
def test_results_that_overflow_are_refused(call):
    arm = overflowing(JointType.REVOLUTE, JointType.REVOLUTE)
    for _ in range(WARM + 2):
        assert np.isfinite(call(arm, [0.0, math.pi])).all()
        with pytest.raises(JointValueError) as error:
            call(arm, [0.0, 0.0])
        assert error.value.code == "result_not_finite"
    with pytest.raises(JointValueError) as error:
        end_poses(arm, [[0.0, math.pi], [0.0, 0.0]])
    assert error.value.faults[0].where == ("joints", 1)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("cell", ["theta", "d", "a", "alpha"])
def test_entries_of_a_table_must_be_finite(cell, value):
    rows = (PUMA560.rows[0], replace(PUMA560.rows[1], **{cell: value}))
    with pytest.raises(TableError) as error:
        end_pose(DHTable(convention=Convention.STANDARD, rows=rows), [0.0, 0.0])
    assert error.value.code == "entry_not_finite"
    assert error.value.faults[0].where == ("rows", 1, cell)


@pytest.mark.parametrize("name", ["base", "tool"])
def test_base_and_tool_must_be_rigid(name):
    with pytest.raises(PoseError) as error:
        end_pose(PUMA560, [0.0] * 6, **{name: 2 * EYE})
    assert error.value.faults[0].where[0] == name


@given(
    st.recursive(
        st.none() | st.floats() | st.text(max_size=2), lambda s: st.lists(s, max_size=3), max_leaves=8
    )
)
def test_whatever_is_given_as_joints_is_computed_or_refused(joints):
    poses = np.empty((0, 4, 4))
    with contextlib.suppress(KinematicsError):
        poses = forward_kinematics(SCARA_RRPR, joints).transform
    assert np.isfinite(poses).all()
