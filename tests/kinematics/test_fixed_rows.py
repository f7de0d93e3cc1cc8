"""Poses as fixed rows: every pose, in both conventions, with lengths no longer than they must be."""

import math

import numpy as np
import pytest

from kinematics.dh import link_transform
from kinematics.fixed_rows import STEEP, fixed_rows
from kinematics.poses import transform_from_xyzabc
from kinematics.table import Convention

both = pytest.mark.parametrize("convention", list(Convention))
TWISTS = [0.0, 1e-15, 1e-9, 1e-3, 0.09, 0.11, math.pi / 2, math.pi - 1e-4, math.pi]


def made(rows, convention):
    pose = np.eye(4)
    for row in rows:
        pose = pose @ link_transform(row, convention)
    return pose


@both
@pytest.mark.parametrize("twist", TWISTS)
def test_the_product_of_the_rows_is_the_pose(twist, convention):
    rng = np.random.default_rng(4)
    for _ in range(50):
        first, last = rng.uniform(-math.pi, math.pi, 2)
        turns = [
            transform_from_xyzabc([0, 0, 0, *abc]) for abc in ((first, 0, 0), (0, 0, twist), (last, 0, 0))
        ]
        pose = turns[0] @ turns[1] @ turns[2]
        pose[:3, 3] = rng.choice([0.0, 1.0], 3) * rng.normal(size=3)
        rows = fixed_rows(pose, convention)
        np.testing.assert_allclose(made(rows, convention), pose, atol=2e-14)
        longest = np.abs(pose[:3, 3]).sum() / STEEP
        assert all(abs(length) <= longest for row in rows for length in (row.a, row.d))
        assert len(rows) <= 3


@both
@pytest.mark.parametrize("turn", [0.0, math.pi], ids=["upright", "overhead"])
def test_an_entry_that_was_rounded_away_turns_nothing(turn, convention):
    """The small entries of an axis tilted by 1e-10 say in which direction; a zero among them is rounding."""
    for around in np.linspace(-3.0, 3.0, 13):
        pose = transform_from_xyzabc([-0.25, 0.83, 0.0, around, 0, turn])
        for i, j in ((0, 2), (1, 2), (2, 0), (2, 1)):
            tilted = pose.copy()
            tilted[:2, 2] += 7e-11, -2e-11
            tilted[2, :2] = -tilted[:3, :2].T @ [7e-11, -2e-11, 0.0] * np.sign(pose[2, 2])
            tilted[i, j] = 0.0
            np.testing.assert_allclose(made(fixed_rows(tilted, convention), convention), pose, atol=3e-10)


@both
def test_simple_poses_need_few_rows(convention):
    assert fixed_rows(np.eye(4), convention) == ()
    (row,) = fixed_rows(transform_from_xyzabc([0, 0, 0.5, 0.3, 0, 0]), convention)
    assert (row.d, row.a, row.alpha) == (0.5, 0.0, 0.0)
    assert row.theta == pytest.approx(0.3)
    assert len(fixed_rows(transform_from_xyzabc([0.2, 0, 0, 0, 0, 0.4]), convention)) == 1
    assert len(fixed_rows(transform_from_xyzabc([0.2, -0.1, 0.4, 1, 0.5, -2]), convention)) == 2


@both
@pytest.mark.parametrize(
    "turns", [(0.0, 60.0, 0.0), (30.0, 45.0, 0.0), (90.0, 30.0, 90.0), (0.0, -60.0, 0.0)]
)
def test_shifts_that_are_none_are_zero(turns, convention):
    rows = fixed_rows(transform_from_xyzabc([0.2, 0.0, 0.0, *np.radians(turns)]), convention)
    lengths = np.array([length for row in rows for length in (row.a, row.d)])
    assert (np.abs(lengths[lengths != 0.0]) > 1e-9).all()
