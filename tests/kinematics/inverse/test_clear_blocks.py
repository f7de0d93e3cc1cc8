"""Many targets away from singularities: what is said of each is what scalars say, and true."""

import math

import numpy as np
import pytest

from kinematics.forward import end_poses
from kinematics.inverse import solve_many, solver_of
from kinematics.inverse.goals import LEAST_TOLERANCE
from kinematics.inverse.methods.clear_blocks import SOLUTIONS, clear_solutions
from kinematics.inverse.residuals import pose_errors
from tests.kinematics.inverse.models import MODELS

ARMS = ["puma", "puma, craig", "catalogue rx90", "irb140", "kr5", "catalogue dmra", "no offsets"]


def drawn(table, count, seed=4):
    return end_poses(table, np.random.default_rng(seed).uniform(-math.pi, math.pi, (count, 6)))


def alike(targets):
    return np.full(len(targets), LEAST_TOLERANCE)


@pytest.mark.parametrize("name", ARMS)
def test_they_are_what_scalars_find(name):
    solver = solver_of(MODELS[name])
    assert solver.clear is not None
    targets = drawn(MODELS[name], 60)
    found = clear_solutions(solver.clear, targets, alike(targets))
    assert found.clear.any()
    for i, target in enumerate(targets):
        alone = solver.clear.solutions(target, LEAST_TOLERANCE)
        if not found.clear[i]:
            assert alone is None or len(alone) < SOLUTIONS
            continue
        expected = np.array(sorted(one.joints for one in alone))
        assert np.allclose(np.array(sorted(found.joints[i].tolist())), expected, atol=1e-9)


@pytest.mark.parametrize("name", ARMS)
def test_each_is_no_farther_off_than_it_says(name):
    solver = solver_of(MODELS[name])
    targets = drawn(MODELS[name], 300)
    found = clear_solutions(solver.clear, targets, alike(targets))
    joints = found.joints[found.clear].reshape(-1, 6)
    assert (joints > -math.pi - 1e-15).all()
    assert (joints <= math.pi + 1e-15).all()
    wanted = np.repeat(targets[found.clear], SOLUTIONS, axis=0)
    position, angle = pose_errors(solver.arm.frames(joints)[-1], wanted)
    rounding = 1e-14
    assert (angle <= found.orientation_error[found.clear].ravel() + rounding).all()
    assert (position <= found.position_error[found.clear].ravel() + rounding * solver.arm.size).all()


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("away", [0.0, 1e-9, 3e-8])
def test_what_is_beside_a_singularity_is_left_to_others(name, away):
    table = MODELS[name]
    solver = solver_of(table)
    q = np.random.default_rng(6).uniform(-math.pi, math.pi, (40, 6))
    q[:, 4] = np.where(np.arange(40) % 2, math.pi, 0.0) + away
    assert not clear_solutions(solver.clear, end_poses(table, q), alike(q)).clear.any()


def test_out_of_reach_and_what_is_no_number_is_not_clear():
    solver = solver_of(MODELS["puma"])
    targets = drawn(MODELS["puma"], 4)
    targets[0, :3, 3] *= 100.0
    targets[1, 0, 3] = math.nan
    clear = clear_solutions(solver.clear, targets, alike(targets)).clear
    assert not clear[:2].any()
    assert clear[2:].all()


def test_in_a_batch_every_solution_is_told_once():
    table = MODELS["puma"]
    targets = drawn(table, 1500, seed=8)
    batch = solve_many(solver_of(table), targets)
    assert batch.complete.all()
    assert (np.diff(batch.target) >= 0).all()
    counts = np.bincount(batch.target, minlength=1500)
    assert set(counts.tolist()) <= {4, 8}
    for i in np.flatnonzero(counts == 4).tolist():
        assert len(solver_of(table).solve(targets[i]).solutions) == 4
    assert float(batch.residual.max()) < 1e-9
