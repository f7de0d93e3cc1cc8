"""Many targets: the same answers as one by one."""

import numpy as np
import pytest

from kinematics.errors import PoseError
from kinematics.forward import end_poses
from kinematics.inverse import IKStatus, solve_many, solver_of
from kinematics.inverse.goals import read_goal, tolerances_of_exact
from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.conftest import EXPLORE
from tests.kinematics.inverse.arms import STANFORD, UR5, apart, random_joints
from tests.kinematics.robots import PUMA560, PUMA560_CRAIG, RX90

TARGETS = 1000
FOLDS, PRINTED, ALONE = (40, 24, 25) if EXPLORE else (4, 4, 9)


@pytest.mark.parametrize("table", [PUMA560, PUMA560_CRAIG], ids=["standard", "modified"])
def test_a_thousand_poses_eight_solutions_each(table):
    rng = np.random.default_rng(0)
    q = np.array([random_joints(rng, table) for _ in range(TARGETS)])
    targets = end_poses(table, q)
    batch = solve_many(solver_of(table), targets)
    assert set(batch.status) == {IKStatus.SOLVED}
    assert batch.complete.all()
    assert np.array_equal(np.bincount(batch.target), np.full(TARGETS, 8))
    assert batch.residual.max() <= 1e-9
    assert np.abs(end_poses(table, batch.joints) - targets[batch.target]).max() <= 1e-9
    by_target = batch.joints.reshape(TARGETS, 8, 6)
    assert apart(table, q[:, None], by_target).min(axis=1).max() < 1e-6
    twins = apart(table, by_target[:, :, None], by_target[:, None])
    assert (twins + np.eye(8)).min() > 1e-6
    assert np.abs(batch.joints).max() <= np.pi


@pytest.mark.parametrize("table", [PUMA560, UR5, RX90, STANFORD], ids=["puma", "ur5", "rx90", "stanford"])
def test_as_one_by_one(table):
    """At random poses and at singular ones, with limits."""
    rng = np.random.default_rng(1)
    q = np.array([random_joints(rng, table, slide=0.4) for _ in range(ALONE)])
    q[::5, 4] = 0.0
    q[1::7, 2] = 0.0
    targets = end_poses(table, q)
    solver = solver_of(table, limits=[(-2.5, 3.0)] * 6)
    batch = solve_many(solver, targets)
    for i, target in enumerate(targets):
        alone = solver.solve(target)
        assert batch.status[i] is alone.status
        assert batch.complete[i] == alone.complete
        rows = batch.joints[batch.target == i]
        assert len(rows) == len(alone.solutions)
        if alone.status is IKStatus.SOLVED:
            known = np.array([solution.joints for solution in alone.solutions])
            assert all(apart(table, row, known).min() < 1e-6 for row in rows)


@pytest.mark.parametrize("table", [PUMA560, RX90], ids=["puma", "rx90"])
def test_beside_folds_as_one_by_one(table):
    """Elbows that are nearly stretched or folded."""
    rng = np.random.default_rng(4)
    solver = solver_of(table)
    q = np.array([random_joints(rng, table) for _ in range(FOLDS)])
    bent = 10.0 ** rng.uniform(-7, -2, FOLDS)
    q[:, 2] = np.pi * rng.integers(2, size=FOLDS) - solver.closed_form.zeros[2] + bent
    targets = end_poses(table, q)
    batch = solve_many(solver, targets)
    for i, target in enumerate(targets):
        alone = solver.solve(target)
        assert batch.complete[i] == alone.complete
        assert (batch.target == i).sum() == len(alone.solutions)


TWISTED_WRIST = tuple(
    DHRow(joint=JointType.REVOLUTE, theta=0.2, d=0.0, a=0.0, alpha=alpha) for alpha in (1.2, -0.9, 0.3)
)
HEADS = {
    "plane": ((0.18, 1.57, 0.4), (0.6, 0.0, 0.1), (0.12, 1.3, 0.2)),
    "axes 1 and 2 meet": ((0.0, 0.9, 0.4), (0.5, 0.7, 0.1), (0.2, 1.1, 0.0)),
    "axes 1 and 2 parallel": ((0.4, 0.0, 0.3), (0.3, 0.8, 0.2), (0.1, 1.2, 0.1)),
    "general": ((0.3, 0.9, 0.4), (0.5, 0.7, 0.1), (0.2, 1.1, 0.0)),
}


@pytest.mark.parametrize("name", HEADS)
def test_every_head_before_a_wrist_that_is_not_at_right_angles(name):
    head = tuple(
        DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha) for a, alpha, d in HEADS[name]
    )
    table = DHTable(convention=Convention.STANDARD, rows=head + TWISTED_WRIST)
    rng = np.random.default_rng(3)
    q = rng.uniform(-np.pi, np.pi, (40, 6))
    targets = end_poses(table, q)
    solver = solver_of(table)
    batch = solve_many(solver, targets)
    assert batch.complete.all()
    assert batch.residual.max() <= 1e-9
    for i in range(40):
        rows = batch.joints[batch.target == i]
        assert apart(table, q[i], rows).min() < 1e-6
        if i < 6:
            assert len(rows) == len(solver.solve(targets[i]).solutions)


@pytest.mark.parametrize("decimals", [7, 9, 17])
def test_poses_as_they_are_printed(decimals):
    """Beside a stretched elbow, where rounding leaves some out of reach."""
    rng = np.random.default_rng(5)
    solver = solver_of(PUMA560)
    q = np.array([random_joints(rng, PUMA560) for _ in range(PRINTED)])
    q[::2, 2] = np.pi - solver.closed_form.zeros[2] + 10.0 ** rng.uniform(-8, -3, PRINTED // 2)
    targets = end_poses(PUMA560, q).round(decimals)
    batch = solve_many(solver, targets)
    for i, target in enumerate(targets):
        alone = solver.solve(target)
        assert batch.status[i] is alone.status
        assert batch.complete[i] == alone.complete
        assert (batch.target == i).sum() == len(alone.solutions)


def test_tolerances_are_those_of_one_alone():
    rng = np.random.default_rng(7)
    targets = np.tile(np.eye(4), (300, 1, 1))
    targets[:, :3, 3] = rng.uniform(-1.0, 1.0, (300, 3)) * 10.0 ** rng.uniform(-3, 6, (300, 1))
    targets[::3, :3, 3] = targets[::3, :3, 3].round(9)
    targets[1::3, :2, 3] = targets[1::3, :2, 3].round(4)
    expected = [read_goal(target, None, where=()).tolerance for target in targets]
    assert np.array_equal(tolerances_of_exact(targets), expected)
    assert len(set(expected)) == 2
    assert expected[::3] == [max(expected)] * 100


def test_an_unreachable_target_among_others():
    targets = end_poses(PUMA560, np.array([[0.1, 0.2, 0.3, 0.4, 0.5, 0.6]] * 3))
    targets[1, :3, 3] = 9.0
    batch = solve_many(solver_of(PUMA560), targets)
    assert [status.value for status in batch.status] == ["solved", "unreachable", "solved"]
    assert np.array_equal(np.unique(batch.target), [0, 2])


def test_no_targets():
    batch = solve_many(solver_of(PUMA560), np.empty((0, 4, 4)))
    assert batch.joints.shape == (0, 6)
    assert batch.status == ()


def test_malformed_targets():
    solver = solver_of(PUMA560)
    with pytest.raises(PoseError) as refusal:
        solve_many(solver, np.eye(4))
    assert refusal.value.code == "targets_wrong_shape"
    targets = np.array([np.eye(4), np.ones((4, 4))])
    with pytest.raises(PoseError) as refusal:
        solve_many(solver, targets)
    assert refusal.value.faults[0].where[:2] == ("target", 1)
