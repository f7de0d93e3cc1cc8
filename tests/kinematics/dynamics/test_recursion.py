"""Numbers: golden values of peers, Lagrange's equations, and the laws of mechanics."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics.dynamics import MovingRobot, RigidBody
from kinematics.errors import DescriptionError, JointValueError, KinematicsError
from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.kinematics.answers.joint_values import robot
from tests.kinematics.dynamics.weights import (
    gravity,
    link,
    link_poses,
    mass_matrix,
    pseudo_inertia,
    puma_links,
    robots,
)

FALL = (0.3, -1.2, -9.81)
Q = np.array([0.1, -0.2, 0.3, 0.4, -0.5, 0.6])
RATES = np.array([0.6, 0.5, -0.4, 0.3, 0.2, -0.1])
SECOND = np.array([1.0, -1.0, 0.5, 2.0, -0.5, 3.0])


def drawn(table, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    q, rates, second = rng.uniform(-2.5, 2.5, (3, table.n_joints))
    return q, rates, second


def test_the_puma_of_the_robotics_toolbox() -> None:
    """roboticstoolbox 1.5 `Puma560().nofriction()` without motors: rne, inertia, gravload, coriolis @ qd."""
    puma = MovingRobot(robot("puma560"), puma_links())
    torque = [
        2.968899943852535, 34.39117811634433, -0.6099582455250347,
        0.005133783031260903, 0.009720338389348356, 0.0002341384156382568,
    ]  # fmt: skip
    np.testing.assert_allclose(puma.torque(Q, RATES, SECOND), torque, atol=1e-12)
    M = puma.mass_matrix(Q)
    first = [
        3.042446374267067, -0.0244601468467102, -0.1382960459975014,
        0.002099003442505086, -0.0007372493705540469, 3.669131043462911e-05,
    ]  # fmt: skip
    np.testing.assert_allclose(M[0], first, atol=1e-13)
    np.testing.assert_allclose(M[1, 1:3], [1.903480206648227, 0.2584352761922205], atol=1e-13)
    held = [0, 36.08067739859464, -0.6153147283783258, -0.0005265928986180509, 0.01119755517103125, 0]
    np.testing.assert_allclose(puma.gravity_torque(Q), held, atol=1e-12)
    velocity = [
        -0.03353525976408296, 0.109801077259228, 0.2216397908314472,
        0.0001471660497068004, 0.0006659813243606592, 3.506558282324275e-06,
    ]  # fmt: skip
    np.testing.assert_allclose(puma.velocity_torque(Q, RATES), velocity, atol=1e-13)


@settings(max_examples=30)
@given(robots(), st.integers(0, 2**32 - 1))
def test_lagranges_equations(built, seed: int) -> None:
    table, links = built
    moving = MovingRobot(table, links, FALL)
    q, rates, _ = drawn(table, seed)
    M = mass_matrix(table, links, q)
    size = 1.0 + np.abs(M).max()
    np.testing.assert_allclose(moving.mass_matrix(q), M, atol=1e-12 * size)
    held = gravity(table, links, q, np.array(FALL))
    np.testing.assert_allclose(moving.gravity_torque(q), held, atol=1e-11 * size)
    energy = 0.5 * rates @ M @ rates
    assert moving.kinetic_energy(q, rates) == pytest.approx(energy, rel=1e-9, abs=1e-11 * size)
    centres = [
        pose @ pseudo_inertia(body)[:, 3] for pose, body in zip(link_poses(table, q), links, strict=True)
    ]
    above = -sum(centre[:3] @ np.array(FALL) for centre in centres)
    assert moving.potential_energy(q) == pytest.approx(above, rel=1e-9, abs=1e-10 * size)


@settings(max_examples=30)
@given(robots(max_rows=5), st.integers(0, 2**32 - 1))
def test_christoffel_symbols_of_the_mass_matrix(built, seed: int) -> None:
    table, links = built
    moving = MovingRobot(table, links, FALL)
    q, rates, _ = drawn(table, seed)
    step, n = 1e-5, table.n_joints
    size = 1.0 + 10 * np.abs(mass_matrix(table, links, q)).max()
    slope = np.array(
        [
            (mass_matrix(table, links, q + step * e) - mass_matrix(table, links, q - step * e)) / (2 * step)
            for e in np.eye(n)
        ]
    )
    by_joint = np.einsum("kij->ijk", slope)
    symbols = 0.5 * (by_joint + np.einsum("jik->ijk", slope) - np.einsum("ijk->ijk", slope))
    C = moving.coriolis_matrix(q, rates)
    np.testing.assert_allclose(C, symbols @ rates, atol=1e-7 * size)


@settings(max_examples=30)
@given(robots(), st.integers(0, 2**32 - 1))
def test_laws(built, seed: int) -> None:
    """τ is the sum of its parts, M is symmetric and never negative, Ṁ − 2C is skew, power is dE/dt."""
    table, links = built
    moving = MovingRobot(table, links, FALL)
    q, rates, second = drawn(table, seed)
    M, C = moving.mass_matrix(q), moving.coriolis_matrix(q, rates)
    h, held = moving.velocity_torque(q, rates), moving.gravity_torque(q)
    poses = link_poses(table, q)
    size = 1.0 + np.abs(M).max() * 10
    assert (np.swapaxes(M, 0, 1) == M).all()
    assert np.linalg.eigvalsh(M).min() >= -1e-12 * size
    np.testing.assert_allclose(C @ rates, h, atol=1e-12 * size)
    torque = moving.torque(q, rates, second)
    parts = np.abs(M) @ np.abs(second) + np.abs(h) + np.abs(held)
    # What weighs much far from an axis may cancel at it: the sum is as exact as its terms are large.
    levers = [
        np.abs(pose[:3, 3]).sum() + np.abs(body.centre).sum() for pose, body in zip(poses, links, strict=True)
    ]
    moments = sum(body.mass * lever * (1.0 + lever) for body, lever in zip(links, levers, strict=True))
    terms = size + parts.max() + moments * (np.linalg.norm(FALL) + np.abs(second).sum() + rates @ rates)
    assert (np.abs(torque - (M @ second + h + held)) <= 1e-12 * terms).all()
    step = 1e-5
    rate = (moving.mass_matrix(q + step * rates) - moving.mass_matrix(q - step * rates)) / (2 * step)
    skew = rate - 2.0 * C
    np.testing.assert_allclose(skew, -skew.T, atol=1e-6 * size)

    def energy(time: float) -> float:
        at, moved = q + time * rates + time**2 / 2 * second, rates + time * second
        return float(moving.kinetic_energy(at, moved) + moving.potential_energy(at))

    power = (energy(step) - energy(-step)) / (2 * step)
    assert power == pytest.approx(rates @ torque, rel=1e-5, abs=1e-5 * size)


@settings(max_examples=30)
@given(robots(max_rows=4), st.integers(0, 2**32 - 1))
def test_a_batch_is_its_configurations(built, seed: int) -> None:
    table, links = built
    moving = MovingRobot(table, links)
    q, rates, second = np.random.default_rng(seed).uniform(-3, 3, (3, 5, table.n_joints))
    found = moving.torque(q, rates, second), moving.mass_matrix(q), moving.coriolis_matrix(q, rates)
    for k in range(5):
        np.testing.assert_allclose(found[0][k], moving.torque(q[k], rates[k], second[k]), atol=1e-9)
        np.testing.assert_allclose(found[1][k], moving.mass_matrix(q[k]), atol=1e-10)
        np.testing.assert_allclose(found[2][k], moving.coriolis_matrix(q[k], rates[k]), atol=1e-9)


def test_a_falling_arm_keeps_its_energy_and_forces_are_undone() -> None:
    puma = MovingRobot(robot("puma560"), puma_links())
    torque = puma.torque(Q, RATES, SECOND)
    np.testing.assert_allclose(puma.accelerations(Q, RATES, torque), SECOND, rtol=1e-8)
    free = np.zeros(6)

    def slope(state: np.ndarray) -> np.ndarray:
        return np.concatenate((state[6:], puma.accelerations(state[:6], state[6:], free)))

    state, step = np.concatenate((Q, RATES)), 0.001
    energy = puma.kinetic_energy(Q, RATES) + puma.potential_energy(Q)
    for _ in range(50):
        a = slope(state)
        b = slope(state + step / 2 * a)
        c = slope(state + step / 2 * b)
        d = slope(state + step * c)
        state = state + step / 6 * (a + 2 * b + 2 * c + d)
    assert np.abs(state[:6] - Q).max() > 0.02
    after = puma.kinetic_energy(state[:6], state[6:]) + puma.potential_energy(state[:6])
    assert after == pytest.approx(energy, abs=1e-9)


LOPSIDED = RigidBody(mass=1.0, centre=(0.0, 0.0, 0.0), inertia=((1, 0.5, 0), (0, 1, 0), (0, 0, 1)))
ONE = DHTable(
    convention=Convention.STANDARD,
    rows=(DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=1.0, alpha=0.0),),
)
BODY = link(1.0, (0.0, 0.0, 0.0), (0.1, 0.1, 0.1))


@pytest.mark.parametrize(
    ("links", "code"),
    [
        ((), "links_count"),
        ((BODY, BODY), "links_count"),
        ((link(-1.0, (0, 0, 0), (1, 1, 1)),), "mass_negative"),
        ((link(1.0, (0, 0, 0), (1, -1, 1)),), "inertia_negative"),
        ((LOPSIDED,), "inertia_not_symmetric"),
    ],
)
def test_bodies_that_cannot_be(links, code: str) -> None:
    with pytest.raises(DescriptionError) as caught:
        MovingRobot(ONE, links)
    assert caught.value.code == code


def test_what_weighs_nothing_has_no_motion_of_its_own() -> None:
    moving = MovingRobot(ONE, (link(0.0, (0, 0, 0), (0, 0, 0)),))
    assert moving.mass_matrix([0.3]).tolist() == [[0.0]]
    with pytest.raises(JointValueError) as caught:
        moving.accelerations([0.3], [0.0], [1.0])
    assert caught.value.code == "mass_matrix_singular"


def test_values_of_another_shape_are_refused() -> None:
    moving = MovingRobot(ONE, (BODY,))
    for values in (([0.1, 0.2], [0.0], [0.0]), ([0.1], [[0.0]], [0.0]), ([0.1], [float("nan")], [0.0])):
        with pytest.raises(KinematicsError):
            moving.torque(*values)
