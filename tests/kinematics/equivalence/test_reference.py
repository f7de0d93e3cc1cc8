"""Where two sides are compared: configurations that fill the joint space and lie on no grid."""

from __future__ import annotations

import numpy as np
import pytest

from kinematics.equivalence.reference import sample_joints


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
