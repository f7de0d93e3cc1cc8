"""One target in scalars: the same solutions as by arrays, and none where care is needed."""

import numpy as np
import pytest

from kinematics.forward import end_pose, end_poses
from kinematics.inverse import inverse_kinematics, solver_of
from kinematics.inverse.goals import LEAST_TOLERANCE, read_goal
from kinematics.inverse.methods.wrist_scalars import ClearWrist
from kinematics.inverse.residuals import are_solutions, errors_of, pose_errors
from kinematics.inverse.results import Method
from kinematics.inverse.self_motions.isolation import LONG
from tests.conftest import EXPLORE
from tests.kinematics.inverse.arms import GENERAL, apart
from tests.kinematics.inverse.models import MODELS

LEVEL = ["puma", "puma, craig", "kr5", "irb140", "catalogue rx90", "catalogue lrmate200id", "catalogue dmra"]


def clear(name: str) -> ClearWrist:
    found = solver_of(MODELS[name]).clear
    assert found is not None
    return found


@pytest.mark.parametrize("name", LEVEL)
def test_solutions_are_those_of_the_arrays(name):
    solver = solver_of(MODELS[name])
    poses = end_poses(MODELS[name], np.random.default_rng(5).uniform(-np.pi, np.pi, (60, 6)))
    answered = 0
    for pose in poses:
        found = clear(name).solutions(pose, LEAST_TOLERANCE)
        if found is None:
            continue
        answered += 1
        goal = read_goal(pose, None, where=())
        expected = solver._answer(solver._by_closed_form(goal), goal, Method.CLOSED_FORM)
        assert expected.complete
        assert len(found) == len(expected.solutions)
        joints = np.array([one.joints for one in found])
        assert (np.abs(joints) <= np.pi).all()
        for one in expected.solutions:
            assert min(apart(MODELS[name], one.joints, q) for q in joints) < 1e-9
        position, angle = pose_errors(end_poses(MODELS[name], joints), pose[None])
        assert position.max() < 1e-12 * max(1.0, solver.arm.size)
        assert angle.max() < 1e-13
    assert answered > 50


@pytest.mark.parametrize("name", LEVEL)
@pytest.mark.parametrize("away", [0.0, 1e-12, 1e-9, 3e-8])
def test_beside_a_singularity_there_is_no_answer_in_scalars(name, away):
    q = np.array([0.4, -0.6, 0.9, 0.7, away, -0.3])
    assert clear(name).solutions(end_pose(MODELS[name], q), LEAST_TOLERANCE) is None


@pytest.mark.parametrize("name", LEVEL)
@pytest.mark.parametrize("tolerance", [LEAST_TOLERANCE, *([1e-7] if EXPLORE else []), 1e-6])
def test_no_solution_in_scalars_leads_to_another_or_far_away(name, tolerance):
    arm = solver_of(MODELS[name]).arm
    rng = np.random.default_rng(12)
    walked = 0
    for k in range(40):
        # Near each kind of singularity in turn: wrist in line, elbow stretched, wrist over the shoulder.
        q = rng.uniform(-np.pi, np.pi, 6)
        if k % 2:
            q[4] = 10.0 ** rng.uniform(-6, -1)
        else:
            q[2] = 10.0 ** rng.uniform(-4, -1) - clear(name).zeros[2]
        target = end_pose(MODELS[name], q)
        found = clear(name).solutions(target, tolerance)
        if found is None:
            continue
        walked += 1
        joints = np.array([one.joints for one in found])
        # The direction in which each moves most, and how far within a tolerance of either kind.
        J = arm.jacobians(arm.frames(joints))
        _, values, directions = np.linalg.svd(J)
        for start, least, direction in zip(joints, values[:, -1], directions[:, -1], strict=True):
            assert least * LONG > 0.5 * tolerance * min(1.0, 1.0 / arm.size)
            there = start + LONG * np.array([[1.0], [-1.0]]) * direction
            for _ in range(6):
                frames = arm.frames(there)
                across = np.eye(6) - np.outer(direction, direction)
                step = np.linalg.pinv(arm.jacobians(frames) @ across, rcond=1e-7)
                there = there + (step @ errors_of(arm, frames[-1], target)[:, :, None])[:, :, 0] @ across
            reached = are_solutions(errors_of(arm, arm.frames(there)[-1], target), arm, tolerance)
            # Where the target is reached again it is by another of the solutions.
            for q in there[reached]:
                assert min(apart(MODELS[name], q, one) for one in joints) < 0.5 * LONG
                assert apart(MODELS[name], q, start) > 0.5 * LONG
    assert walked > 4


def test_beyond_reach_there_is_no_answer_in_scalars():
    far = np.eye(4)
    far[0, 3] = 100.0
    assert clear("puma").solutions(far, LEAST_TOLERANCE) is None
    assert inverse_kinematics(MODELS["puma"], far).solutions == ()


def test_limits_choose_among_the_solutions():
    table = MODELS["puma"]
    pose = end_pose(table, [0.3, -0.7, 1.2, 0.5, 0.9, -1.4])
    limits = [(0.0, 1.0)] + [None] * 5
    free, within = inverse_kinematics(table, pose), inverse_kinematics(table, pose, limits=limits)
    assert within.complete
    assert {s.joints for s in within.solutions} == {s.joints for s in free.solutions if 0 <= s.joints[0] <= 1}
    assert within.outside_limits == len(free.solutions) - len(within.solutions)
    turned = inverse_kinematics(table, pose, limits=[(6.0, 7.0)] + [None] * 5)
    assert all(6.0 <= s.joints[0] <= 7.0 for s in turned.solutions)


def test_arms_without_a_level_wrist_have_none():
    assert solver_of(MODELS["ur5"]).clear is None
    assert solver_of(MODELS["jaco"]).clear is None
    assert solver_of(GENERAL).clear is None
