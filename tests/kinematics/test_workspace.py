"""The workspace: known arms by hand, others against brute force."""

import itertools
import math

import numpy as np
import pytest

from kinematics.catalogue import robot, robots
from kinematics.cells import bind_parameters
from kinematics.errors import JointValueError, PoseError, TableError
from kinematics.forward import end_pose, end_poses
from kinematics.table import Convention, DHTable, JointType
from kinematics.workspace import workspace
from tests.kinematics.inverse.arms import random_joints, random_table
from tests.kinematics.robots import PUMA560, numeric


def planar(*lengths):
    return numeric(Convention.STANDARD, *(("revolute", 0.0, length, 0.0, 0.0) for length in lengths))


def values(radii):
    return radii.inner.value, radii.outer.value


@pytest.mark.parametrize(
    ("lengths", "inner", "outer"),
    [((1.0, 1.0), 0.0, 2.0), ((0.5, 0.3), 0.2, 0.8), ((0.3, 0.5), 0.2, 0.8), ((1.0, 0.4, 0.3), 0.3, 1.7)],
)
def test_planar_arms(lengths, inner, outer):
    space = workspace(planar(*lengths))
    assert values(space.from_axis) == pytest.approx((inner, outer), abs=1e-9)
    assert values(space.from_origin) == pytest.approx((inner, outer), abs=1e-9)
    assert [e.value for e in space.greatest] == pytest.approx([outer, outer, 0.0], abs=1e-9)
    assert [e.value for e in space.least] == pytest.approx([-outer, -outer, 0.0], abs=1e-9)


def test_limits_are_respected():
    """An elbow that bends by 60° to 120°: the law of cosines."""
    low, high = math.radians(60), math.radians(120)
    space = workspace(planar(0.5, 0.3), limits=[(0.0, math.pi / 2), (low, high)])
    reach = [math.sqrt(0.25 + 0.09 + 0.3 * math.cos(angle)) for angle in (high, low)]
    assert values(space.from_axis) == pytest.approx(reach, abs=1e-9)
    for radii in (space.from_axis, space.from_origin):
        for extreme in (radii.inner, radii.outer):
            assert low <= extreme.joints[1] <= high
            assert 0 <= extreme.joints[0] <= math.pi / 2


def test_scara_with_a_slide():
    scara = numeric(
        Convention.MODIFIED,
        ("revolute", 0.0, 0.0, 0.0, 0.0),
        ("revolute", 0.0, 0.4, 0.0, 0.0),
        ("prismatic", 0.0, 0.3, 0.0, 0.0),
        ("revolute", 0.0, 0.0, 0.0, 0.0),
    )
    space = workspace(scara, limits=[None, None, (0.1, 0.4), None])
    assert values(space.from_axis) == pytest.approx((0.1, 0.7), abs=1e-9)
    assert values(space.from_origin) == pytest.approx((math.hypot(0.1, 0.1), math.hypot(0.7, 0.4)), abs=1e-9)
    assert (space.least[2].value, space.greatest[2].value) == pytest.approx((0.1, 0.4), abs=1e-12)


def test_puma_keeps_its_shoulder_offset():
    space = workspace(PUMA560)
    reach = 0.4318 + math.hypot(0.4318, 0.0203)
    assert values(space.from_axis) == pytest.approx((0.15005, math.hypot(reach, 0.15005)), abs=1e-9)


def test_dmra_and_its_printed_radii():
    """Printed: 65 and 340 mm (seed 003). Table 1 reaches further out, and without joint limits further in.

    Outer: 45 + 115 + √(20² + 130²) + 50 = 341.53 with the hand turned into line: printed rounded to 340.
    Inner: nothing keeps the free arm from its own axis. 65 = 45 + 20 is where the wrist stands with upper arm
    upright and forearm upright, which is no least distance of the table's arm.
    """
    dmra = robot("dmra")
    space = workspace(bind_parameters(dmra.table, dmra.parameters))
    assert space.from_axis.outer.value == pytest.approx(45 + 115 + math.hypot(20, 130) + 50, abs=1e-6)
    assert abs(space.from_axis.outer.value - 340) / 340 < 0.005
    assert space.from_axis.inner.value == 0.0
    wrist = DHTable(
        convention=Convention.STANDARD,
        rows=bind_parameters(dmra.table, dmra.parameters).rows[:3],
    )
    upright = end_pose(wrist, [0.0, -math.pi / 2, math.pi / 2])
    assert np.hypot(*upright[:2, 3]) == pytest.approx(45 + 20)


@pytest.mark.parametrize("name", [entry.id for entry in robots()])
def test_no_sample_lies_outside(name):
    """Every catalogue robot: fresh samples never beat the extremes, and each extreme is where it says."""
    entry = robot(name)
    table = bind_parameters(entry.table, entry.parameters)
    limits = [(-0.2, 0.6) if j is JointType.PRISMATIC else None for j in table.joint_types]
    space = workspace(table, limits=limits, points=50)
    rng = np.random.default_rng(0)
    q = rng.uniform(-math.pi, math.pi, (20_000, table.n_joints))
    slides = [j is JointType.PRISMATIC for j in table.joint_types]
    q[:, slides] = rng.uniform(-0.2, 0.6, (20_000, sum(slides)))
    p = end_poses(table, q)[:, :3, 3]
    distance = np.linalg.norm(p, axis=1)
    slack = 1e-9 * max(space.from_origin.outer.value, 1.0)
    assert space.from_origin.inner.value - slack <= distance.min()
    assert distance.max() <= space.from_origin.outer.value + slack
    for i in range(3):
        assert space.least[i].value - slack <= p[:, i].min()
        assert p[:, i].max() <= space.greatest[i].value + slack
        for extreme in (space.least[i], space.greatest[i]):
            assert end_pose(table, extreme.joints)[i, 3] == pytest.approx(extreme.value, abs=slack)
    for extreme in (space.from_origin.inner, space.from_origin.outer):
        there = np.linalg.norm(end_pose(table, extreme.joints)[:3, 3])
        assert there == pytest.approx(extreme.value, abs=10 * slack)
    assert space.points.shape == (50, 3)


def test_random_arms_against_a_grid():
    rng = np.random.default_rng(1)
    for _ in range(6):
        table = random_table(rng, 3, sliding=0.3)
        limits = [(-1.0, 0.8)] * 3
        space = workspace(table, limits=limits)
        grid = np.array(list(itertools.product(np.linspace(-1.0, 0.8, 25), repeat=3)))
        distance = np.linalg.norm(end_poses(table, grid)[:, :3, 3], axis=1)
        assert space.from_origin.inner.value <= distance.min() + 1e-9
        assert space.from_origin.outer.value >= distance.max() - 1e-9
        assert space.from_origin.outer.value <= distance.max() + 0.02
        assert space.from_origin.inner.value >= distance.min() - 0.1


def test_base_and_tool():
    rng = np.random.default_rng(2)
    table = random_table(rng, 4, sliding=0.0)
    base = end_pose(random_table(rng, 3, sliding=0.0), random_joints(rng, planar(1, 1, 1)))
    tool = np.eye(4)
    tool[:3, 3] = 0.1, 0.2, 0.3
    plain = workspace(table, tool=tool)
    moved = workspace(table, base=base, tool=tool)
    assert values(moved.from_axis) == pytest.approx(values(plain.from_axis), abs=1e-7)
    assert values(moved.from_origin) != pytest.approx(values(plain.from_origin), abs=1e-3)


def test_refusals():
    slide = numeric(Convention.STANDARD, ("prismatic", 0.0, 0.0, 0.0, 0.0), ("prismatic", 1.0, 0.0, 0.0, 0.0))
    for limits in (None, [(0.0, None), (None, 1.0)]):
        with pytest.raises(JointValueError) as refusal:
            workspace(slide, limits=limits)
        assert [fault.code for fault in refusal.value.faults] == ["limits_required"] * 2
        assert [fault.where for fault in refusal.value.faults] == [("limits", 0), ("limits", 1)]
    with pytest.raises(TableError) as nothing:
        workspace(DHTable(convention=Convention.STANDARD, rows=()))
    assert nothing.value.code == "workspace_without_joints"
    with pytest.raises(PoseError):
        workspace(PUMA560, tool=np.ones((4, 4)))
    with pytest.raises(JointValueError):
        workspace(PUMA560, limits=[None])
