"""Candidates judged in one pass: the same as by forward kinematics, Jacobian and determinant apart."""

import numpy as np
import pytest

from kinematics.evaluation.plan import plan_of
from kinematics.forward import end_poses
from kinematics.inverse.judging import judge
from kinematics.inverse.residuals import angles_of_chords
from kinematics.jacobian import jacobian
from kinematics.table import DHRow, DHTable, JointType
from tests.kinematics.inverse.arms import GENERAL, UR5, random_table
from tests.kinematics.robots import PUMA560, PUMA560_CRAIG, RX90

FIXED = DHRow(joint=JointType.FIXED, theta=0.4, d=0.2, a=-0.1, alpha=0.7)


def _with_fixed_rows(table):
    rows = (FIXED, *table.rows[:2], FIXED, *table.rows[2:])
    return DHTable(convention=table.convention, rows=rows)


ARMS = {
    "puma": PUMA560,
    "puma, modified": PUMA560_CRAIG,
    "ur5": UR5,
    "rx90": RX90,
    "general": GENERAL,
    "fixed rows": _with_fixed_rows(GENERAL),
    **{f"random {i}": random_table(np.random.default_rng(i), 6, sliding=0.0) for i in range(6)},
}


@pytest.mark.parametrize("table", ARMS.values(), ids=ARMS)
def test_as_forward_kinematics_and_jacobian_say(table):
    rng = np.random.default_rng(3)
    base, tool = end_poses(GENERAL, rng.uniform(-np.pi, np.pi, (2, 6)))
    q = rng.uniform(-np.pi, np.pi, (60, 6))
    counts = np.array([7, 0, 20, 1, 32])
    targets = end_poses(table, rng.uniform(-np.pi, np.pi, (5, 6)), base=base, tool=tool)
    found = judge(plan_of(table, base, tool), q, targets, counts)
    wanted = np.repeat(targets, counts, axis=0)
    reached = end_poses(table, q, base=base, tool=tool)
    cosine = 0.5 * ((wanted[:, :3, :3] * reached[:, :3, :3]).sum(axis=(1, 2)) - 1.0)
    determinant = np.linalg.det(jacobian(table, q, base=base, tool=tool))
    assert np.allclose(found.position_error, np.linalg.norm((reached - wanted)[:, :3, 3], axis=1), atol=1e-14)
    assert np.allclose(found.orientation_error, np.arccos(cosine), atol=1e-7)
    assert np.allclose(found.volume, np.abs(determinant), atol=1e-14)


def test_fingerprints_differ_by_no_more_than_joints_do():
    rng = np.random.default_rng(4)
    plan = plan_of(PUMA560)
    q = rng.uniform(-np.pi, np.pi, (2000, 6))
    beside = q + rng.uniform(-1e-6, 1e-6, q.shape) + 2 * np.pi * rng.integers(-1, 2, q.shape)
    targets, counts = end_poses(PUMA560, q), np.ones(len(q), dtype=np.intp)
    first, second = (judge(plan, joints, targets, counts).fingerprint for joints in (q, beside))
    assert np.abs(first - second).max() <= 1e-6
    assert np.diff(np.sort(first)).min() > 1e-9


def test_candidates_that_are_not_finite_reach_nothing():
    q = np.zeros((3, 6))
    q[1, 2], q[2, 4] = np.nan, np.inf
    found = judge(plan_of(PUMA560), q, end_poses(PUMA560, np.zeros((1, 6))), np.array([3]))
    near = (found.position_error <= 1e-9) & (found.orientation_error <= 1e-9)
    assert near.tolist() == [True, False, False]


def test_angles_of_chords():
    for angle in (0.0, 1e-12, 1e-8, 1e-3, 2.0, np.pi):
        chord = np.sqrt(8.0) * np.sin(angle / 2.0)
        assert angles_of_chords(np.array([chord]))[0] == pytest.approx(angle, rel=1e-7)
    both = angles_of_chords(np.array([0.0, np.sqrt(8.0) * 1.0000001]))
    assert both.tolist() == [0.0, np.pi]
