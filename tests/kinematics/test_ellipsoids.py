"""Velocity ellipsoids: against the planar arm by hand, and as laws over the catalogue."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics import catalogue
from kinematics.ellipsoids import velocity_ellipsoids
from kinematics.jacobian import jacobian
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable
from tests.conftest import EXPLORE
from tests.kinematics.robots import listed_numbers

NAMES = sorted(robot.id for robot in catalogue.robots())


def two_links(first: float, second: float) -> NumericTable:
    return DHTable(
        convention=Convention.STANDARD,
        rows=tuple(
            DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=a, alpha=0.0) for a in (first, second)
        ),
    )


def test_a_stretched_planar_arm_moves_across_itself_and_not_along() -> None:
    """J_v = [[0, 0], [l1 + l2, l2]]: one radius √((l1 + l2)² + l2²) along y, none along x and z."""
    found = velocity_ellipsoids(two_links(0.4, 0.3), [0.0, 0.0]).translation
    np.testing.assert_allclose(found.radii, [math.hypot(0.7, 0.3), 0, 0], atol=1e-15)
    np.testing.assert_allclose(found.axes[0], [0, 1, 0], atol=1e-15)


def test_equal_links_at_the_best_elbow_are_isotropic() -> None:
    """Salisbury and Craig's arm: l1 = √2 l2 with the elbow at 135° has a round ellipse of radius l2."""
    found = velocity_ellipsoids(two_links(math.sqrt(2), 1.0), [0.3, math.radians(135)]).translation
    np.testing.assert_allclose(found.radii, [1, 1, 0], atol=1e-12)


@settings(max_examples=40 if EXPLORE else 10)
@given(data=st.data())
@pytest.mark.parametrize("name", NAMES)
def test_every_motion_of_unit_rates_lies_in_the_ellipsoids(name: str, data: st.DataObject) -> None:
    table = listed_numbers(name)
    numbers = st.floats(-3, 3, allow_subnormal=False)
    n = table.n_joints
    q = data.draw(st.lists(numbers, min_size=n, max_size=n))
    rates = np.array(data.draw(st.lists(st.floats(0.01, 1), min_size=n, max_size=n)))
    rates /= np.linalg.norm(rates)
    found = velocity_ellipsoids(table, q)
    units = np.array([found.length if kind is JointType.PRISMATIC else 1.0 for kind in table.joint_types])
    twist = jacobian(table, q) @ (units * rates)
    scale = max(1.0, float(np.abs(twist).max()))
    for part, ellipsoid in ((twist[:3], found.translation), (twist[3:], found.rotation)):
        along = ellipsoid.axes @ part
        np.testing.assert_allclose(ellipsoid.axes @ ellipsoid.axes.T, np.eye(3), atol=1e-12)
        assert np.all(np.abs(along[ellipsoid.radii == 0]) < 1e-8 * scale)
        moving = ellipsoid.radii > 0
        assert np.sum((along[moving] / ellipsoid.radii[moving]) ** 2) <= 1 + 1e-6
    halved = np.concatenate([twist[:3] / found.length, twist[3:]])
    np.testing.assert_allclose(found.blocked @ halved, 0, atol=1e-8 * scale)


def test_the_wrist_singularity_of_the_puma_blocks_one_motion() -> None:
    table = listed_numbers("puma560")
    assert len(velocity_ellipsoids(table, np.radians([0, 45, -180, 0, 45, 0])).blocked) == 0
    assert len(velocity_ellipsoids(table, np.radians([0, 45, -180, 0, 0, 0])).blocked) == 1
