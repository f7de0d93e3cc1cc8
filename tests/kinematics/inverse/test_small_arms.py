"""Arms smaller than a tolerance: their solutions are those of the same arm of ordinary size."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.forward import end_pose, end_poses
from kinematics.inverse import UnreachableReason, inverse_kinematics, solve_many, solver_of
from kinematics.inverse.arm import ArmReach
from kinematics.table import Convention, DHTable
from tests.kinematics.inverse.arms import THREE_LINKS, TWO_LINKS, UR5
from tests.kinematics.robots import PUMA560, numeric

JOINTS = (0.3, -0.7, 1.2, 0.5, 0.9, -1.4)
ARMS = {"two": TWO_LINKS, "three": THREE_LINKS, "ur5": UR5, "puma": PUMA560}


def shrunk(table: DHTable, size: float) -> DHTable:
    return replace(table, rows=tuple(replace(row, a=size * row.a, d=size * row.d) for row in table.rows))


@pytest.mark.parametrize("size", [5e-8, 1e-9, 4e-10, 7e-12])
def test_an_arm_smaller_than_a_tolerance_has_its_elbow_up_and_down(size):
    table = numeric(Convention.STANDARD, *(("revolute", 0.0, a * size, 0.0, 0.0) for a in (0.5, 0.3)))
    solver = solver_of(table, reach=ArmReach.POSITION)
    poses = end_poses(table, np.array([[0.3, 0.8], [-1.2, 2.9], [0.7, 1e-4]]))
    for pose, elbow in zip(poses, (0.8, 2.9, 1e-4), strict=True):
        answer = solver.solve(pose)
        assert answer.complete
        assert sorted(s.joints[1] for s in answer.solutions) == pytest.approx([-elbow, elbow], rel=1e-6)
        assert answer.tolerance < 1e-9 * size
        assert max(s.position_error for s in answer.solutions) < 1e-14 * size
    batch = solve_many(solver, poses)
    assert batch.complete.all()
    assert len(batch.joints) == 6
    near = poses[0].copy()
    near[:3, 3] *= 0.8 * size * (1.0 + 1e-5) / np.linalg.norm(near[:3, 3])
    assert solver.solve(near).reason is UnreachableReason.OUT_OF_REACH
    assert solver.solve(near, 1e-4 * size).tolerance == pytest.approx(1e-4 * size)
    assert len(solver.solve(near, 1e-4 * size).solutions) == 1
    far = poses[0].copy()
    far[:3, 3] *= 3.0 * size / np.linalg.norm(far[:3, 3])
    assert solver.solve(far).nearest.position_error == pytest.approx(2.2 * size)


@pytest.mark.parametrize("size", [1e-7, 3e-10])
@pytest.mark.parametrize("name", ARMS)
def test_a_small_arm_has_the_solutions_of_a_large_one(name, size):
    large, small = ARMS[name], shrunk(ARMS[name], size)
    q = np.array(JOINTS[: large.n_joints])
    expected = inverse_kinematics(large, end_pose(large, q))
    answer = inverse_kinematics(small, end_pose(small, q))
    assert answer.complete
    assert expected.complete
    assert answer.tolerance < 1e-9 * size
    found = sorted(s.joints for s in answer.solutions)
    np.testing.assert_allclose(found, sorted(s.joints for s in expected.solutions), atol=1e-6)
    drilled = inverse_kinematics(small, end_pose(small, q), reach=ArmReach.AXIS)
    assert len(drilled.solutions) == len(
        inverse_kinematics(large, end_pose(large, q), reach=ArmReach.AXIS).solutions
    )


@pytest.mark.parametrize("tolerance", [None, 1e-9, 1e-5])
@pytest.mark.parametrize("size", [1e-7, 3e-10])
@pytest.mark.parametrize("name", ARMS)
def test_a_small_arm_does_not_reach_what_is_far_beyond_its_size(name, size, tolerance):
    solver = solver_of(shrunk(ARMS[name], size))
    pose = end_pose(solver.table, JOINTS[: solver.arm.n_joints])
    pose[:3, 3] *= 9.0 * size / np.linalg.norm(pose[:3, 3])
    answer = solver.solve(pose, tolerance)
    assert answer.reason is UnreachableReason.OUT_OF_REACH
    assert answer.tolerance <= 0.0101 * solver.arm.size
    if tolerance is None:
        assert len(solve_many(solver, [pose]).joints) == 0


@pytest.mark.parametrize("decimals", [4, 6, 8])
def test_the_pose_of_a_small_arm_may_be_rounded(decimals):
    table = shrunk(PUMA560, 1e-9)
    pose = end_pose(table, JOINTS)
    pose[:3, :3] = pose[:3, :3].round(decimals)
    pose[:3, 3] = pose[:3, 3].round(9 + decimals)
    answer = inverse_kinematics(table, pose, tolerance=10.0**-decimals)
    assert answer.complete
    apart = np.abs(np.array([s.joints for s in answer.solutions]) - JOINTS).max(axis=1)
    assert apart.min() < 20.0 * 10.0**-decimals
    assert len(apart) == 8
