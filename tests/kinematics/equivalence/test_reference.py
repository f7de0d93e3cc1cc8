"""A prepared key: configurations that fill the joint space and lie on no grid, and what is near in it."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.equivalence import Tolerance
from kinematics.equivalence.groups import Nearness
from kinematics.equivalence.reference import prepared, sample_joints
from kinematics.table import DHTable
from tests.kinematics.equivalence.tables import PUMA


def test_every_joint_steps_by_the_root_of_a_prime() -> None:
    """Of 2, 3, 5, …: of whole turns, so that no two joints ever come back to where they were together."""
    turns = np.diff(sample_joints(6), axis=1) / 2.0
    roots = np.sqrt([2.0, 3.0, 5.0, 7.0, 11.0, 13.0])
    assert np.exp(2j * np.pi * turns) == pytest.approx(
        np.broadcast_to(np.exp(2j * np.pi * roots)[:, None], turns.shape)
    )


def test_samples_fill_the_joint_space() -> None:
    q = sample_joints(12)
    assert q.shape == (12, 64)
    assert np.abs(q).max() <= 1.0
    for row in q:
        assert np.diff(np.sort(row)).max() < 0.2
        assert len(np.unique(np.round(row, 9))) == 64
        assert abs(row.mean()) < 0.1


def test_what_is_near_by_hand() -> None:
    """To the arithmetic; then within twice the tolerance, with three notions of what may slide."""
    near = prepared(PUMA).nearnesses(Tolerance(length=0.1, angle=0.01))
    size = prepared(PUMA).size
    assert near[0] == Nearness(1e-9, 1e-9 * size, 1e-9)
    for one, slide in zip(near[1:], (0.02, 0.04, 0.2), strict=True):
        assert (one.angle, one.length, one.slide) == pytest.approx((0.02, 0.2 * size, slide))


def test_a_key_without_lengths_takes_on_the_size_of_what_lies_beside_it() -> None:
    rows = tuple(replace(row, a=0.0, d=0.0) for row in PUMA.rows)
    reference = prepared(DHTable(convention=PUMA.convention, rows=rows))
    assert (reference.scaleless, reference.size) == (True, 1.0)
    chain = prepared(PUMA).chain
    beside = reference.beside(chain)
    assert (beside.scaleless, beside.size) == (True, chain.extent)
    assert prepared(PUMA).beside(reference.chain) is prepared(PUMA)


def test_what_is_near_grows_with_the_robot_and_with_the_tolerance() -> None:
    """But for the strictest notion, which is the arithmetic's."""
    rows = tuple(replace(row, a=1000.0 * row.a, d=1000.0 * row.d) for row in PUMA.rows)
    large, small = prepared(DHTable(convention=PUMA.convention, rows=rows)), prepared(PUMA)
    coarse, fine = Tolerance(length=2e-3, angle=2e-3), Tolerance(length=1e-3, angle=1e-3)
    for one, other in zip(large.nearnesses(fine), small.nearnesses(fine), strict=True):
        assert (one.angle, one.slide) == pytest.approx((other.angle, other.slide))
        assert one.length == pytest.approx(1000.0 * other.length)
    (strict, *loose), (same, *looser) = small.nearnesses(fine), small.nearnesses(coarse)
    assert strict == same
    for one, other in zip(loose, looser, strict=True):
        assert (other.angle, other.length, other.slide) == pytest.approx(
            (2.0 * one.angle, 2.0 * one.length, 2.0 * one.slide)
        )
        assert one.angle >= 2.0 * fine.angle
