"""Rates of Jacobians, analytic Jacobians and forces: against differences and virtual work."""

from random import Random

import numpy as np
import pytest

from kinematics.chain import chain_of_table
from kinematics.errors import JointValueError
from kinematics.poses import rpy_from_transform
from kinematics.rates import analytic_jacobian, jacobian_rate, joint_forces
from tests.kinematics.equivalence.generators import random_robot, random_valid_table
from tests.kinematics.robots import PUMA560, SCARA_RRPR

STEP = 1e-6


def drawn(seed: int):
    rng = Random(seed)
    table = random_valid_table(random_robot(rng), rng)
    generator = np.random.default_rng(seed)
    return chain_of_table(table), generator.uniform(-2, 2, (2, table.n_joints))


@pytest.mark.parametrize("seed", range(12))
def test_the_rate_is_the_change_of_the_jacobian(seed: int) -> None:
    chain, (q, speeds) = drawn(seed)
    change = (chain.jacobian(q + STEP * speeds) - chain.jacobian(q - STEP * speeds)) / (2 * STEP)
    np.testing.assert_allclose(jacobian_rate(chain, q, speeds), change, atol=1e-7 * (1 + chain.extent))


@pytest.mark.parametrize("seed", range(12))
def test_the_analytic_jacobian_is_the_gradient_of_position_and_angles(seed: int) -> None:
    chain, (q, _) = drawn(seed)
    found = analytic_jacobian(chain, q)
    assert found is not None

    def written(at):
        pose = chain.poses(at)
        return np.array([*pose[:3, 3], *rpy_from_transform(pose)])

    for i, step in enumerate(STEP * np.eye(len(q))):
        change = written(q + step) - written(q - step)
        change[3:] = (change[3:] + np.pi) % (2 * np.pi) - np.pi
        np.testing.assert_allclose(found[:, i], change / (2 * STEP), atol=1e-5 * (1 + chain.extent))


def test_there_is_none_where_roll_and_yaw_are_one() -> None:
    level = chain_of_table(SCARA_RRPR)
    assert analytic_jacobian(level, [0.1] * 4) is not None
    turned = np.array([[0.0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]])
    assert analytic_jacobian(chain_of_table(SCARA_RRPR, None, turned), [0.1] * 4) is None


def test_forces_at_the_joints_do_the_same_work() -> None:
    chain = chain_of_table(PUMA560)
    q, speeds, wrench = np.random.default_rng(2).uniform(-1, 1, (3, 6))
    assert joint_forces(chain, q, wrench) @ speeds == pytest.approx(wrench @ chain.jacobian(q) @ speeds)


def test_what_is_refused() -> None:
    chain = chain_of_table(PUMA560)
    with pytest.raises(JointValueError):
        jacobian_rate(chain, [0.0] * 6, [0.0] * 5)
    with pytest.raises(JointValueError):
        analytic_jacobian(chain, [float("nan")] * 6)
