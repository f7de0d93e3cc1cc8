"""The workspace: known arms by hand, others against many samples."""

import math

import numpy as np
import pytest

from kinematics import catalogue, end_pose, end_poses
from kinematics.errors import JointValueError, PoseError, TableError
from kinematics.table import Convention, DHTable, JointType
from kinematics.workspace import coordinate_ascent, workspace
from kinematics.workspace.spans import joint_spans, spread
from tests.conftest import EXPLORE
from tests.kinematics.robots import PRISMATIC_ENDS, PUMA560, SCARA_RRPR, listed_numbers, numeric

RIGHT = math.pi / 2


def planar(*lengths):
    return numeric(Convention.STANDARD, *(("revolute", 0.0, length, 0.0, 0.0) for length in lengths))


def radii(found):
    return [r.value for r in (found.inner.axis, found.inner.origin, found.outer.axis, found.outer.origin)]


@pytest.mark.parametrize(
    ("lengths", "inner", "outer"),
    [
        ((1.0,), 1.0, 1.0),
        ((1.0, 1.0), 0.0, 2.0),
        ((0.5, 0.3), 0.2, 0.8),
        ((0.3, 0.5), 0.2, 0.8),
        ((1.0, 0.4, 0.3), 0.3, 1.7),
        ((0.4, 0.4, 0.4, 0.4, 0.4), 0.0, 2.0),
    ],
)
def test_planar_arms(lengths, inner, outer):
    found = workspace(planar(*lengths))
    assert radii(found) == pytest.approx([inner, inner, outer, outer], abs=1e-10)
    assert (*found.low, *found.high) == pytest.approx((-outer, -outer, 0, outer, outer, 0), abs=1e-10)


def test_limits_are_kept():
    """An elbow that bends by 60° to 120°, a shoulder from 0° to 90°: the law of cosines."""
    low, high = math.radians(60), math.radians(120)
    found = workspace(planar(0.5, 0.3), [(0.0, RIGHT), (low, high)])
    near, far = (math.sqrt(0.34 + 0.3 * math.cos(angle)) for angle in (high, low))
    assert radii(found) == pytest.approx([near, near, far, far], abs=1e-12)
    for radius in (found.inner.axis, found.outer.origin):
        assert low <= radius.joints[1] <= high
    assert found.low[0] == pytest.approx(-0.3, abs=1e-12)  # both at 90°


def test_a_limit_on_one_side_still_turns_fully():
    assert radii(workspace(planar(0.5, 0.3), [None, (1.0, None)])) == pytest.approx([0.2, 0.2, 0.8, 0.8])
    assert radii(workspace(planar(0.5, 0.3), [None, (-9.0, 9.0)])) == pytest.approx([0.2, 0.2, 0.8, 0.8])


def test_a_scara_with_a_slide():
    found = workspace(SCARA_RRPR, [None, None, (0.1, 0.4), None])
    assert radii(found) == pytest.approx([0.1, math.hypot(0.1, 0.1), 0.7, math.hypot(0.7, 0.4)], abs=1e-12)
    assert (found.low[2], found.high[2]) == pytest.approx((0.1, 0.4), abs=1e-12)


def test_the_puma_keeps_its_shoulder_offset():
    """The wrist centre passes the first axis at d3, and is farthest with a2 and hypot(a3, d4) in line."""
    found = workspace(PUMA560)
    forearm = math.hypot(0.4318, 0.0203)
    far = math.hypot(0.4318 + forearm, 0.15005)
    near = math.hypot(0.4318 - forearm, 0.15005)
    assert radii(found) == pytest.approx([0.15005, near, far, far], abs=1e-10)


def test_the_desktop_arm_and_its_printed_radii():
    """Seed 003 prints 65 and 340 mm.

    340 = a1 + a2 + d4 + d6 leaves out a3 = 20, by which the forearm stands beside the upper arm: the table
    reaches 45 + 115 + √(20² + 130²) + 50. 65 = a1 + a3 is the least distance from the first axis while
    forearm and hand hang straight down (q3 = −q2), with the upper arm upright.
    Nothing else keeps it away.
    """
    dmra = listed_numbers("dmra")
    found = workspace(dmra)
    far = 45 + 115 + math.hypot(20, 130) + 50
    assert found.outer.axis.value == pytest.approx(far, rel=1e-12)
    assert round(far - 340, 2) == 1.53
    assert found.inner.axis.value == 0.0
    hanging = end_pose(dmra, [0.0, -RIGHT, RIGHT, 0.0, 0.0, 0.0])[:3, 3]
    assert hanging.tolist() == pytest.approx([65, 0, 10], abs=1e-9)
    q2 = np.linspace(-RIGHT, RIGHT, 181)
    still = np.zeros_like(q2)
    hung = end_poses(dmra, np.column_stack((still, q2, -q2, still, still, still)))[:, :3, 3]
    assert hung[:, 0].min() == pytest.approx(65, abs=1e-9)


@pytest.mark.parametrize("robot_id", catalogue.robot_ids())
def test_no_sample_lies_outside_and_every_radius_is_there(robot_id):
    table = listed_numbers(robot_id)
    limits = [(-0.2, 0.6) if kind is JointType.PRISMATIC else None for kind in table.joint_types]
    found = workspace(table, limits, samples=50)
    rng = np.random.default_rng(3)
    spans = joint_spans(table, limits)
    q = rng.uniform(spans[:, 0], spans[:, 1], (20_000 if EXPLORE else 5_000, table.n_joints))
    p = end_poses(table, q)[:, :3, 3]
    distance = np.linalg.norm(p, axis=1)
    slack = 1e-10 * found.outer.origin.value
    assert found.inner.origin.value <= distance.min() + slack
    assert found.outer.origin.value >= distance.max() - slack
    assert (p.min(axis=0) >= np.array(found.low) - slack).all()
    assert (p.max(axis=0) <= np.array(found.high) + slack).all()
    for radius in (found.inner.origin, found.outer.origin):
        there = np.linalg.norm(end_pose(table, radius.joints)[:3, 3])
        assert there == pytest.approx(radius.value, abs=slack)
    assert found.points.shape == (50, 3)
    assert (np.linalg.norm(found.points, axis=1) <= found.outer.origin.value + slack).all()


@pytest.mark.parametrize("seed", range(8))
def test_random_arms_against_a_grid(seed):
    rng = np.random.default_rng(seed)
    kinds = rng.choice(["revolute", "revolute", "prismatic"], 3)
    rows = [(kind, *rng.uniform(-1, 1, 4)) for kind in kinds]
    table = numeric(list(Convention)[seed % 2], *rows)
    limits = [(-1.0, 0.8)] * 3
    found = workspace(table, limits)
    side = np.linspace(-1.0, 0.8, 31)
    grid = np.stack(np.meshgrid(side, side, side), axis=-1).reshape(-1, 3)
    p = end_poses(table, grid)[:, :3, 3]
    distance = np.linalg.norm(p, axis=1)
    assert distance.min() - 0.15 <= found.inner.origin.value <= distance.min() + 1e-12
    assert distance.max() - 1e-12 <= found.outer.origin.value <= distance.max() + 0.01
    assert np.all(np.array(found.low) <= p.min(axis=0) + 1e-12)
    assert np.all(np.array(found.high) >= p.max(axis=0) - 1e-12)
    assert np.abs(np.array(found.high) - p.max(axis=0)).max() < 0.01


def test_a_base_moves_the_box_alone_and_a_tool_moves_the_point():
    base = end_pose(PUMA560, [0.3, 0.4, 0.5, 0.6, 0.7, 0.8])
    tool = np.eye(4)
    tool[:3, 3] = 0.1, 0.2, 0.3
    plain, moved = workspace(PUMA560, tool=tool), workspace(PUMA560, base=base, tool=tool)
    assert radii(moved) == pytest.approx(radii(plain), abs=1e-10)
    assert radii(plain)[3] > radii(workspace(PUMA560))[3] + 0.3
    p = end_poses(PUMA560, spread(joint_spans(PUMA560, None), 5000), base=base, tool=tool)[:, :3, 3]
    assert np.all(p >= np.array(moved.low))
    assert np.all(p <= np.array(moved.high))


@pytest.mark.parametrize("robot_id", ["kr100p", "kr125", "kr2150k", "scorbot"])
def test_the_section_is_upright_whichever_way_the_first_joint_counts(robot_id):
    """The KUKA arms of document 001 turn about an axis that points down."""
    found = workspace(listed_numbers(robot_id), samples=20)
    np.testing.assert_allclose(found.section[:, 1], found.points[:, 2], atol=1e-12)
    found = workspace(listed_numbers(robot_id), base=np.diag([1.0, -1.0, -1.0, 1.0]), samples=20)
    np.testing.assert_allclose(found.section[:, 1], found.points[:, 2], atol=1e-12)


def test_along_a_level_axis_heights_have_the_sense_of_its_joint():
    lying = np.eye(4)[[0, 2, 1, 3]] * [1.0, 1.0, -1.0, 1.0]
    found = workspace(listed_numbers("scorbot"), base=lying, samples=20)
    np.testing.assert_allclose(found.section[:, 1], -found.points[:, 1], atol=1e-12)


def test_the_same_question_has_the_same_answer():
    assert radii(workspace(PUMA560)) == radii(workspace(PUMA560))


def test_refusals():
    with pytest.raises(JointValueError) as refusal:
        workspace(PRISMATIC_ENDS, [(0.0, None), None, None])
    assert [(fault.code, fault.where) for fault in refusal.value.faults] == [
        ("slide_without_limits", ("limits", 0)),
        ("slide_without_limits", ("limits", 2)),
    ]
    with pytest.raises(TableError) as nothing:
        workspace(DHTable(convention=Convention.STANDARD, rows=()))
    assert nothing.value.code == "workspace_without_joints"
    with pytest.raises(PoseError):
        workspace(PUMA560, tool=np.ones((4, 4)))
    with pytest.raises(JointValueError):
        workspace(PUMA560, [None])


def test_a_corner_that_nothing_spread_evenly_is_near_is_found():
    """The least x is where all three joints are at a limit, and the way up to it begins close by."""
    table = numeric(
        Convention.STANDARD,
        ("revolute", 0.7, 0.4, 0.1, 0.0),
        ("revolute", 0.0, 0.4, 0.1, 0.0),
        ("prismatic", -RIGHT, 0.4, 0.2, 0.0),
    )
    limits = [(-1.3925, 0.8243), (-0.673, 2.8954), (-0.2, 0.2681)]
    corner = end_pose(table, [-1.3925, -0.673, 0.2681])[0, 3]
    assert workspace(table, limits).low[0] == pytest.approx(corner, abs=1e-9)


def test_of_two_nearly_equal_tops_of_one_joint_the_greater_is_taken():
    """A wrist that turns from its limit to a top between grid points, 4e-5 farther out than the limit."""
    table = numeric(
        Convention.STANDARD,
        ("revolute", RIGHT, 0.0, 0.1, 0.0),
        ("revolute", RIGHT, 0.0, 0.1, 0.0),
        ("prismatic", 0.7, 0.4, 0.0, 0.0),
    )
    limits = [(-1.9391, 1.8366), (-2.6902, 0.8593536958), (-0.2, 0.4746944805)]
    turns = np.linspace(-2.6902, 0.8593536958, 200_001)
    q = np.column_stack((np.zeros_like(turns), turns, np.full_like(turns, 0.4746944805)))
    places = end_poses(table, q)[:, :3, 3]
    assert workspace(table, limits).outer.axis.value >= np.hypot(places[:, 0], places[:, 1]).max() - 1e-12


def test_what_gains_nothing_more_is_not_swept_further(monkeypatch):
    """Of this arm one of ten numbers rises slowly: the others, whose starts are most of the work, rest."""
    table = numeric(
        Convention.MODIFIED,
        ("revolute", RIGHT / 2, 0.5, 0.0, 0.0),
        ("revolute", 0.3, 0.0, 0.0, 0.0),
        ("revolute", RIGHT, 0.3, 0.0, 0.0),
        ("revolute", RIGHT, 0.5, 0.0, 0.0),
        ("revolute", -RIGHT, 0.0, 0.2, 0.0),
    )
    rows = []
    swept = coordinate_ascent._swept

    def counted(table, ascents, joints, spans, tool):
        rows.append(len(joints))
        return swept(table, ascents, joints, spans, tool)

    monkeypatch.setattr(coordinate_ascent, "_swept", counted)
    workspace(table, [(-1.3834, 0.6829), None, None, None, None])
    assert rows[0] == 10 * coordinate_ascent.STARTS
    assert sum(rows) < 0.5 * len(rows) * rows[0]
