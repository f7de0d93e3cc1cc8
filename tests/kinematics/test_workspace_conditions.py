"""The workspace in a plane and with the hand held: known arms by hand, others against many samples."""

import math

import numpy as np
import pytest

from kinematics import end_pose, end_poses
from kinematics.errors import PoseError
from kinematics.inverse import ArmReach
from kinematics.table import Convention, JointType
from kinematics.workspace import workspace
from tests.kinematics.robots import PUMA560, listed_numbers, numeric
from tests.kinematics.test_workspace import RIGHT, radii

SUPPORT = ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0))
DOWN = np.diag([1.0, -1.0, -1.0, 1.0])


def test_the_desktop_arm_in_its_support_plane():
    """Seed 003 measures radii in the plane on which the arm stands; elbow to wrist it is √(20² + 130²)."""
    dmra, forearm = listed_numbers("dmra"), math.hypot(20, 130)
    found = workspace(dmra, plane=SUPPORT)
    far = 45 + math.sqrt((115 + forearm + 50) ** 2 - 75**2)
    assert radii(found) == pytest.approx([0.0, 0.0, far, far], abs=1e-8)
    assert (found.low[2], found.high[2]) == pytest.approx((0.0, 0.0), abs=1e-8)
    with_hand_down = workspace(dmra, plane=SUPPORT, held=DOWN, counts=ArmReach.AXIS)
    down = 45 + math.sqrt((115 + forearm) ** 2 - (75 - 50) ** 2)
    assert with_hand_down.outer.axis.value == pytest.approx(down, abs=1e-8)
    pose = end_pose(dmra, with_hand_down.outer.axis.joints)
    assert pose[2, 2] == pytest.approx(-1.0, abs=1e-9)
    assert pose[2, 3] == pytest.approx(0.0, abs=1e-7)


def test_the_puma_in_a_plane_with_its_hand_held():
    """The wrist's centre is as high as the shoulder; the elbow folds to |a2 - hypot(a3, d4)|."""
    forearm = math.hypot(0.4318, 0.0203)
    found = workspace(PUMA560, plane=SUPPORT, held=DOWN)
    near, far = (math.hypot(0.15005, length) for length in (forearm - 0.4318, forearm + 0.4318))
    assert radii(found) == pytest.approx([near, near, far, far], abs=1e-9)


def test_a_sphere_cut_by_a_plane():
    """Two links that turn about crossing axes reach a circle of radius √(1 - h²) in the plane z = h."""
    table = numeric(Convention.STANDARD, ("revolute", RIGHT, 0.0, 0.0, 0.0), ("revolute", 0.0, 1.0, 0.0, 0.0))
    for height in (-0.6, 0.0, 0.8):
        found = workspace(table, plane=((5.0, -3.0, height), (0.0, 0.0, -2.0)), samples=40)
        assert radii(found)[::2] == pytest.approx([math.sqrt(1 - height**2)] * 2, abs=1e-9)
        assert np.allclose(found.points[:, 2], height, atol=1e-9)
        assert len(found.points) > 20
    with pytest.raises(PoseError) as refused:
        workspace(table, plane=((0.0, 0.0, 1.1), (0.0, 0.0, 1.0)))
    assert refused.value.faults[0].code == "workspace_condition_unmet"


def test_conditions_are_seen_from_the_world():
    base = end_pose(PUMA560, [0.4, -0.3, 0.9, 0.2, 0.5, -0.7])
    here = workspace(PUMA560, plane=SUPPORT, held=DOWN)
    plane = (base[:3, 3], base[:3, 2])
    there = workspace(PUMA560, base=base, plane=plane, held=base @ DOWN)
    assert radii(there) == pytest.approx(radii(here), abs=1e-9)


def test_slides_at_their_ends_in_an_oblique_plane():
    """Joint 1 turns the others into the plane if any place at their height and distance lies in it."""
    rows = [
        ("revolute", RIGHT, 0.0, 0.0, 0.0),
        ("prismatic", RIGHT, 0.5, 0.0, RIGHT),
        ("revolute", -0.38, 0.0, 0.0, 0.0),
        ("prismatic", 0.0, 0.3, 0.0, 0.0),
    ]
    table, limits = numeric(Convention.STANDARD, *rows), [None, (-0.26, 0.13), None, (0.5, 0.71)]
    point, normal = np.array((0.42, -0.27, 0.89)), np.array((-0.83, -0.07, 0.55))
    slides = np.array([(a, b) for a in np.linspace(-0.26, 0.13, 5) for b in np.linspace(0.5, 0.71, 5)])
    turns = np.linspace(-math.pi, math.pi, 721)
    q = np.array([(0.0, a, turn, b) for a, b in slides for turn in turns])
    places = end_poses(table, q)[:, :3, 3]
    from_axis = np.hypot(places[:, 0], places[:, 1])
    height = abs(normal @ point - normal[2] * places[:, 2])
    reaching = math.hypot(normal[0], normal[1]) * from_axis >= height
    found = workspace(table, limits, plane=(point, normal))
    assert found.outer.axis.value >= from_axis[reaching].max()
    assert found.outer.origin.value >= np.linalg.norm(places[reaching], axis=1).max()
    assert found.inner.axis.value <= from_axis[reaching].min()
    assert found.inner.origin.value <= np.linalg.norm(places[reaching], axis=1).min()


@pytest.mark.parametrize("robot_id", ["rx90", "irb140", "scara", "ur5"])
def test_no_sample_in_the_plane_lies_outside(robot_id):
    table = listed_numbers(robot_id)
    limits = [(-0.2, 0.4) if kind is JointType.PRISMATIC else (-2.0, 2.5) for kind in table.joint_types]
    height = float(end_pose(table, [0.1 * (k + 1) for k in range(table.n_joints)])[2, 3])
    found = workspace(table, limits, plane=((0.0, 0.0, height), (0.0, 0.0, 1.0)), samples=3000)
    assert len(found.points) > 300
    distance = np.linalg.norm(found.points, axis=1)
    slack = 1e-9 * found.outer.origin.value
    assert found.inner.origin.value <= distance.min() + slack
    assert found.outer.origin.value >= distance.max() - slack
