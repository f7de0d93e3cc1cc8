"""Equation (1) at the sampled configurations: nothing is accepted without it."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.chain import Chain
from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import Reference
from kinematics.se3 import to_matrix


class Residual(NamedTuple):
    """The largest difference between the two sides of equation (1).

    Attributes:
        angle: rotation from one end frame to the other [rad].
        length: distance of their origins, relative to the robot's size [1].
    """

    angle: float
    length: float

    def within(self, tolerance: Tolerance) -> bool:
        """Return whether both are within the tolerance."""
        return self.angle <= tolerance.angle and self.length <= tolerance.length

    def excess(self, tolerance: Tolerance) -> float:
        """Return the larger of the two, in units of its tolerance; at most 1 is within."""
        return max(self.angle / tolerance.angle, self.length / tolerance.length)


def joint_values(reference: Reference, candidate: CertificateCandidate) -> NDArray[np.float64]:
    """Return σ∘q + δ at the sampled configurations, (n, samples)."""
    turned = np.array((candidate.signs, candidate.offsets), dtype=np.float64)
    return np.asarray(reference.joints * turned[0][:, None] + turned[1][:, None], dtype=np.float64)


def differences(
    reference: Reference, submission: Chain, candidate: CertificateCandidate
) -> NDArray[np.float64]:
    """Return F_s(σ∘q + δ) - B · F_r(q) · E at every sampled configuration: (samples, 4, 4)."""
    difference = submission.poses(joint_values(reference, candidate).T)
    poses = reference.poses.reshape(-1, 4) @ to_matrix(candidate.tool)
    difference -= to_matrix(candidate.base) @ poses.reshape(reference.poses.shape)
    return difference


def residual(reference: Reference, submission: Chain, candidate: CertificateCandidate) -> Residual:
    """Compare the two sides of equation (1) at every sampled configuration."""
    return largest(differences(reference, submission, candidate), reference.size)


def largest(difference: NDArray[np.float64], size: float) -> Residual:
    """Return the largest rotation and relative displacement among differences of poses (samples, 4, 4)."""
    squares = np.einsum("sij,sij->sj", difference, difference)
    turn = rotation_from_square(squares[:, :3].sum(axis=1).max())
    return Residual(turn, float(np.sqrt(squares[:, 3].max())) / size)


def rotation_from_square(square: float) -> float:
    """Return the angle between two rotations [rad], given ‖R - R'‖² = 8 sin²(angle/2)."""
    return 2.0 * float(np.arcsin(min(float(np.sqrt(square / 8.0)), 1.0)))
