"""Refinement: steps that leave nearly the least, and no length of its own."""

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy, Tolerance, ToolRule, decide
from kinematics.equivalence.decision import mirrored
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.refinement import (
    CLOSE,
    FREE_TWISTS,
    LINE_TWISTS,
    Model,
    RefinementProblem,
)
from kinematics.equivalence.verification import Residual
from tests.kinematics.equivalence.generators import random_robot, random_valid_table, rounded
from tests.kinematics.equivalence.tables import HALF, P, R, scaled, standard


def model(errors: np.ndarray, jacobian: np.ndarray) -> Model:
    return Model(errors=errors, jacobian=jacobian, found=Residual(0.0, 0.0), damping=1e-12)


def test_the_middle_between_two_errors_leaves_the_least_largest() -> None:
    """Three errors along one direction, 0, 0 and 1: the mean leaves 2/3, the middle 1/2."""
    errors = np.array([[0.0, 0, 0], [0.0, 0, 0], [1.0, 0, 0]])
    found = model(errors, np.tile([[1.0], [0.0], [0.0]], (3, 1)))
    assert found.least_squares() == pytest.approx(1 / 3)
    step, least = found.least_largest()
    assert 0.5 <= found.after(step).max() <= 0.5 * CLOSE
    assert 0.5 / CLOSE <= least <= 0.5 + 1e-9


@pytest.mark.parametrize("seed", range(10))
def test_no_step_leaves_less_than_the_bound(seed: int) -> None:
    rng = np.random.default_rng(seed)
    errors, jacobian = rng.normal(size=(40, 3)) / 4, rng.normal(size=(120, 4)) / 3
    found = model(errors, jacobian)
    step, least = found.least_largest()
    reached = found.after(step).max()
    assert least <= reached <= found.after(found.least_squares()).max()
    assert reached <= CLOSE * least * 1.05
    for other in (*rng.normal(scale=0.1, size=(200, 4)), *(step + rng.normal(scale=0.02, size=(200, 4)))):
        assert found.after(other).max() >= least * (1 - 1e-9)


def test_errors_are_off_their_linear_function_by_their_squares() -> None:
    """In units of the tolerance: [rad], and shares of the robot, turned by as much."""
    found = replace(model(np.zeros((2, 3)), np.zeros((6, 1))), found=Residual(0.03, 0.02))
    assert found.curvature(Tolerance(length=0.5, angle=0.01)) == pytest.approx(0.09)


@pytest.mark.parametrize(("base", "first"), [(FREE_TWISTS, 0.0), (LINE_TWISTS, 1.0)])
def test_a_step_of_one_is_a_radian_or_the_robot_and_nothing_that_the_base_can_do(
    base: np.ndarray, first: float
) -> None:
    key = standard((R, HALF, 0.0, 0.3, 0.0), (R, -HALF, 0.2, 0.1, 0.0), (P, 0.0, 0.0, 0.0, 0.4))
    reference = prepared(key)
    problem = RefinementProblem(reference, reference.chain, Tolerance(), base, FREE_TWISTS, offsets_free=True)
    assert problem.joint_scales.tolist() == [first, 1.0, reference.size]


@pytest.mark.parametrize("seed", range(6))
def test_the_linear_function_is_what_a_small_step_does(seed: int) -> None:
    """Of all that may change: offsets, the base's motion and the tool's."""
    rng = Random(f"step {seed}")
    key = random_robot(rng, joints=rng.randint(2, 6))
    table = random_valid_table(key, rng, dummies=0.0)
    certificate = decide(key, table, Policy(tool=ToolRule.FREE)).certificate
    assert certificate is not None
    free = {"base_twists": FREE_TWISTS[:, 1:], "tool_twists": FREE_TWISTS, "offsets_free": True}
    problem = RefinementProblem(prepared(key), chain_of_table(table), Tolerance(), **free)
    here = problem.linearised(certificate.draws[0])
    step = np.random.default_rng(seed).normal(size=here.jacobian.shape[1])
    small = 1e-6
    there = problem.linearised(problem.moved(certificate.draws[0], small * step))
    change = ((here.errors - there.errors) / small).ravel()
    assert change == pytest.approx(here.jacobian @ step, abs=1e-4 * np.abs(change).max())


@pytest.mark.parametrize("seed", range(8))
def test_a_mirrored_table_is_the_mirrored_robot(seed: int) -> None:
    """In the plane z = 0 of frame 0, at the same joint values."""
    rng = Random(f"mirror {seed}")
    key = random_robot(rng, joints=rng.randint(2, 6))
    joints = np.random.default_rng(seed).uniform(-1.0, 1.0, (5, key.n_joints))
    mirror = np.diag((1.0, 1.0, -1.0, 1.0))
    expected = mirror @ chain_of_table(key).poses(joints) @ mirror
    assert chain_of_table(mirrored(key)).poses(joints) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("seed", range(12))
def test_the_unit_of_length_decides_nothing(seed: int) -> None:
    """In units a power of two smaller every number is the same but for its exponent."""
    rng = Random(f"unit {seed}")
    key = random_robot(rng, joints=rng.randint(4, 6))
    table = rounded(random_valid_table(key, rng, dummies=0.0, textbook_ends=True), 2)
    policy = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=0.006, angle=0.006))
    one, other = decide(key, table, policy), decide(scaled(key, 1024.0), scaled(table, 1024.0), policy)
    assert one.accepted is other.accepted
    if one.certificate is None or other.certificate is None:
        return
    units = [
        1024.0 if row.joint.value == "prismatic" else 1.0
        for row in (table.rows[index] for index in table.joint_rows)
    ]
    assert one.certificate.joint_signs == other.certificate.joint_signs
    expected = [offset * unit for offset, unit in zip(one.certificate.joint_offsets, units, strict=True)]
    assert other.certificate.joint_offsets == pytest.approx(expected, rel=1e-9, abs=1e-9)
    assert other.certificate.residual == pytest.approx(one.certificate.residual, rel=1e-6)
    assert math.isfinite(one.certificate.residual)
