"""Equation (1) at the sampled configurations: nothing is accepted without it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.equivalence.certificates import Candidate
from kinematics.equivalence.chains import Chain, poses
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.rigid import to_matrix

NOTHING = 1e-12


class Residual(NamedTuple):
    """The largest difference between the two sides of equation (1).

    Attributes:
        angle: rotation from one end frame to the other [rad].
        length: distance of their origins, relative to the robot's size [1].
    """

    angle: float
    length: float

    def within(self, tolerance: Tolerance) -> bool:
        """Whether both are within the tolerance."""
        return self.angle <= tolerance.angle and self.length <= tolerance.length

    def excess(self, tolerance: Tolerance) -> float:
        """The larger of the two, in units of its tolerance; at most 1 is within."""
        return max(self.angle / tolerance.angle, self.length / tolerance.length)


def size_for(reference: Reference, submission: Chain) -> float:
    """What relative lengths refer to: the reference's size, or the submission's if that has none."""
    return submission.extent if reference.scaleless and submission.extent > NOTHING else reference.size


def joint_values(reference: Reference, candidate: Candidate) -> NDArray[np.float64]:
    """σ∘q + δ at the sampled configurations, (n, samples)."""
    if not candidate.signs:
        return reference.joints
    turned = np.array((candidate.signs, candidate.offsets), dtype=np.float64)
    return np.asarray(reference.joints * turned[0][:, None] + turned[1][:, None], dtype=np.float64)


def residual(reference: Reference, submission: Chain, candidate: Candidate) -> Residual:
    """Compare F_s(σ∘q + δ) with B · F_r(q) · E at every sampled configuration."""
    difference = poses(submission, joint_values(reference, candidate))
    difference -= to_matrix(candidate.base) @ reference.poses @ to_matrix(candidate.tool)
    return largest(difference, size_for(reference, submission))


def largest(difference: NDArray[np.float64], size: float) -> Residual:
    """The largest rotation and relative displacement among differences of poses (samples, 4, 4)."""
    squares = np.einsum("sij,sij->sj", difference, difference)
    rotation = squares[:, :3].sum(axis=1).max()
    # ‖R - R'‖_F = 2√2 sin(angle/2); the chord √2·2 sin(angle/2)/2 is the angle to third order, and at most 2
    chord = min(float(np.sqrt(rotation / 8.0)), 1.0)
    return Residual(2.0 * float(np.arcsin(chord)), float(np.sqrt(squares[:, 3].max())) / size)
