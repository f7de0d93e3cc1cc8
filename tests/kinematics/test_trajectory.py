"""Joint trajectories: the polynomials by hand, rest at both ends, no overshoot, rates that integrate."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.errors import JointValueError
from kinematics.trajectory import TimeScaling, joint_trajectory

VALUES = st.lists(st.floats(-10, 10), min_size=3, max_size=3)


def test_peaks_of_the_two_polynomials() -> None:
    """Halfway the cubic moves at 3/2 of the mean rate, the quintic at 15/8 of it."""
    cubic = joint_trajectory([0.0], [2.0], duration=4.0, samples=5, scaling=TimeScaling.CUBIC)
    np.testing.assert_allclose(cubic.positions[:, 0], [0, 0.3125, 1, 1.6875, 2])
    np.testing.assert_allclose(cubic.velocities[2], 1.5 * 0.5)
    np.testing.assert_allclose(cubic.accelerations[[0, -1], 0], [6 * 2 / 16, -6 * 2 / 16])
    quintic = joint_trajectory([0.0], [2.0], duration=4.0, samples=5, scaling=TimeScaling.QUINTIC)
    np.testing.assert_allclose(quintic.velocities[2], 15 / 8 * 0.5)


@pytest.mark.parametrize("scaling", TimeScaling)
@given(start=VALUES, end=VALUES, duration=st.floats(0.1, 100))
def test_laws(scaling: TimeScaling, start: list[float], end: list[float], duration: float) -> None:
    found = joint_trajectory(start, end, duration=duration, samples=401, scaling=scaling)
    np.testing.assert_allclose(found.positions[[0, -1]], [start, end], atol=1e-12)
    np.testing.assert_allclose(found.velocities[[0, -1]], 0, atol=1e-9)
    if scaling is TimeScaling.QUINTIC:
        np.testing.assert_allclose(found.accelerations[[0, -1]], 0, atol=1e-6)
    low, high = np.minimum(start, end) - 1e-12, np.maximum(start, end) + 1e-12
    assert np.all((found.positions >= low) & (found.positions <= high))
    assert found.times[-1] == pytest.approx(duration)
    step = duration / 400
    slope = np.gradient(found.positions, step, axis=0)[1:-1]
    np.testing.assert_allclose(slope, found.velocities[1:-1], atol=2e-3 / step + 1e-9)


def test_ends_of_different_arms_are_refused() -> None:
    with pytest.raises(JointValueError):
        joint_trajectory([0.0, 1.0], [0.0], duration=1.0, samples=2, scaling=TimeScaling.CUBIC)
