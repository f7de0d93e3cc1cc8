"""Chains: the product of exponentials against the product of link transforms."""

from random import Random

import numpy as np
import pytest

from kinematics import catalogue
from kinematics.cells import bind_parameters
from kinematics.chain import chain_of_table, frames_at, frames_at_zero, size_of
from kinematics.equivalence import mirrored
from kinematics.equivalence.reference import prepared
from kinematics.forward import forward_kinematics
from kinematics.jacobian import jacobian
from kinematics.poses import transform_from_xyzabc
from kinematics.scm import table_of_chain
from kinematics.screws import product_of_exponentials, table_of_product
from kinematics.se3 import to_matrix
from kinematics.table import DHTable, bind
from kinematics.urdf import chain_from_urdf, urdf_from_table
from tests.kinematics.equivalence.generators import random_robot, random_valid_table
from tests.kinematics.equivalence.tables import HALF, PUMA, SCARA, F, P, R, changed, standard, table


@pytest.mark.parametrize("seed", range(20))
def test_exponentials_of_screws_are_the_forward_kinematics(seed: int) -> None:
    rng = Random(seed)
    drawn = random_valid_table(random_robot(rng), rng)
    q = np.random.default_rng(seed).uniform(-3, 3, (drawn.n_joints, 4))
    found = chain_of_table(drawn).poses(q.T)
    for k in range(4):
        expected = forward_kinematics(drawn, q[:, k])
        assert np.allclose(found[k], expected.transform, atol=1e-10 * (1 + chain_of_table(drawn).extent))
    at_zero = forward_kinematics(drawn, np.zeros(drawn.n_joints)).frames
    frames = [to_matrix(frame) for frame in frames_at_zero(drawn)]
    assert np.allclose(frames[0], np.eye(4))
    assert np.allclose(frames[1:], at_zero, atol=1e-10 * (1 + chain_of_table(drawn).extent))
    base = transform_from_xyzabc((0.3, -0.2, 0.1, 0.4, 0.5, 0.6))
    moved = [to_matrix(frame) for frame in frames_at(drawn, q[:, 0].tolist(), base)]
    expected = forward_kinematics(drawn, q[:, 0], base=base)
    assert np.allclose(moved, [base, *expected.frames], atol=1e-10 * (1 + chain_of_table(drawn).extent))


def test_size_hardly_depends_on_the_frames() -> None:
    rng = Random(5)
    for robot in (PUMA, SCARA):
        size = size_of(chain_of_table(robot))
        assert 0.5 < size < 1.5
        rows = [(r.joint, r.alpha, r.a, r.d, r.theta) for r in robot.rows]
        far_away = table(robot.convention, (F, 0.3, 10.0, 7.0, 0.2), *rows)
        assert size_of(chain_of_table(far_away)) == pytest.approx(size, rel=0.5)
        for _ in range(20):
            drawn = random_valid_table(robot, rng, dummies=0.0, textbook_ends=True)
            assert 0.3 * size < size_of(chain_of_table(drawn)) < 3.0 * size


def test_offsets_of_nearly_parallel_axes_do_not_inflate_the_size() -> None:
    arm = standard((R, HALF, 0, 0.1, 0), (R, 0.003, -0.4, 137.2, 0), (R, 0, -0.4, -137.1, 0))
    assert size_of(chain_of_table(arm)) < 2.0


def test_size_of_degenerate_robots() -> None:
    assert size_of(chain_of_table(standard((R, 1.0, 0, 0, 0), (R, 0, 0, 0, 0)))) == 0.0
    assert size_of(chain_of_table(standard((P, 1.0, 0.2, 0.3, 0)))) == 0.5
    assert prepared(standard((R, 1.0, 0, 0, 0))).scaleless


def test_the_mirror_image_is_a_reflection() -> None:
    arm = changed(PUMA, 2, alpha=0.4, joint=P)
    image = mirrored(arm)
    assert mirrored(image) == arm
    flip = np.diag([1.0, 1.0, -1.0, 1.0])
    q = np.array([0.3, 0.2, -0.5, 1.0, 0.7, 0.1])
    expected = flip @ forward_kinematics(arm, q).transform @ flip
    assert np.allclose(forward_kinematics(image, q).transform, expected)


def test_a_table_without_joints_is_a_constant() -> None:
    post = DHTable(convention=PUMA.convention, rows=standard((F, 0.1, 0.2, 0.3, 0.4)).rows)
    assert chain_of_table(post).poses(np.empty((3, 0))).shape == (3, 4, 4)


@pytest.mark.parametrize("seed", range(12))
def test_frames_and_jacobian_are_those_of_the_table(seed: int) -> None:
    rng = Random(seed)
    drawn = random_valid_table(random_robot(rng), rng)
    generator = np.random.default_rng(seed)
    base, tool = (transform_from_xyzabc(generator.uniform(-1, 1, 6).tolist()) for _ in range(2))
    chain = chain_of_table(drawn, base, tool)
    q = generator.uniform(-3, 3, (5, drawn.n_joints))
    expected = forward_kinematics(drawn, q, base=base, tool=tool)
    accuracy = 1e-10 * (1 + chain.extent)
    np.testing.assert_allclose(chain.frames(q)[:, 1:], expected.frames, atol=accuracy)
    np.testing.assert_allclose(chain.frames(q)[:, 0], np.broadcast_to(base, (5, 4, 4)), atol=1e-15)
    np.testing.assert_allclose(chain.poses(q), expected.transform, atol=accuracy)
    np.testing.assert_allclose(chain.jacobian(q), jacobian(drawn, q, base=base, tool=tool), atol=accuracy)
    np.testing.assert_allclose(chain.jacobian(q[0]), chain.jacobian(q)[0], atol=1e-15)
    np.testing.assert_allclose(chain.frames(q[0]), chain.frames(q)[0], atol=1e-15)


@pytest.mark.parametrize("robot", catalogue.robots(), ids=lambda robot: robot.id)
def test_every_description_of_a_robot_is_one_chain(robot: catalogue.Robot) -> None:
    """From the table, its screws, the SCM chain and a URDF: the same poses and Jacobians."""
    table = bind_parameters(robot.table, robot.parameters)
    of_table = chain_of_table(table)
    assert robot.chain is not None
    lengths = {name: robot.parameters[known] for name, known in robot.chain.parameters.items()}
    screwed = table_of_product(product_of_exponentials(table), table.convention)
    others = [
        chain_of_table(screwed.table, screwed.base, screwed.tool),
        chain_of_table(bind(table_of_chain(robot.chain.read.chain), lengths)),
        chain_from_urdf(urdf_from_table(table).text).chain,
    ]
    q = np.random.default_rng(6).uniform(-2, 2, (3, table.n_joints))
    accuracy = 1e-12 * (1 + of_table.extent)
    for chain in others:
        np.testing.assert_allclose(chain.poses(q), of_table.poses(q), atol=accuracy)
        np.testing.assert_allclose(chain.jacobian(q), of_table.jacobian(q), atol=accuracy)
