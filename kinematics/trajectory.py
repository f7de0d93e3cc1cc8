"""Joint trajectories from rest to rest: one polynomial of time for all joints."""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import ArrayLike

from kinematics.joint_values import one_configuration
from kinematics.se3 import Floats


class TimeScaling(StrEnum):
    """How far along the motion is, as a polynomial of the share of its duration.

    CUBIC: 3τ² − 2τ³, at rest at both ends.
    QUINTIC: 10τ³ − 15τ⁴ + 6τ⁵, at rest and without acceleration at both ends.
    """

    CUBIC = "cubic"
    QUINTIC = "quintic"


_SHARE = {
    TimeScaling.CUBIC: Polynomial([0, 0, 3, -2]),
    TimeScaling.QUINTIC: Polynomial([0, 0, 0, 10, -15, 6]),
}


@dataclass(frozen=True, kw_only=True, slots=True)
class JointTrajectory:
    """Joint values over time, at m instants.

    Attributes:
        times: (m,) from 0 to the duration [s].
        positions: (m, n) joint values [rad, or the table's unit].
        velocities: (m, n) their rates [per s].
        accelerations: (m, n) the rates of these [per s²].
    """

    times: Floats
    positions: Floats
    velocities: Floats
    accelerations: Floats


def joint_trajectory(
    start: ArrayLike, end: ArrayLike, *, duration: float, samples: int, scaling: TimeScaling
) -> JointTrajectory:
    """Return q(t) = q_0 + s(t / T) (q_1 − q_0): all joints start and stop together, none overshoots.

    Args:
        start: (n,) joint values at rest at the beginning.
        end: (n,) joint values at rest at the end.
        duration: T [s], greater than zero.
        samples: m >= 2, the number of instants, evenly spaced, both ends included.
        scaling: the polynomial s.

    Raises:
        JointValueError: start or end does not hold finite numbers, or not equally many.

    Source: J. J. Craig, Introduction to Robotics, 3rd ed. (2005), eq. 7.6 (cubic) and 7.18 (quintic), at rest
    at both ends.
    """
    first = np.array(one_configuration(start, len(np.atleast_1d(np.asarray(start)))))
    last = np.array(one_configuration(end, len(first)))
    share = np.linspace(0.0, 1.0, samples)
    s = _SHARE[scaling]
    way = last - first
    return JointTrajectory(
        times=share * duration,
        positions=first + np.outer(s(share), way),
        velocities=np.outer(s.deriv(1)(share) / duration, way),
        accelerations=np.outer(s.deriv(2)(share) / duration**2, way),
    )
