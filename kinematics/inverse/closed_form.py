"""Methods that yield all solutions of an arm.

Arms of five or six turning joints go to the library EAIK, which decomposes them into the Paden–Kahan
subproblems. It is given the axes as directions and points at q = 0, not a DH table, so both conventions and
fixed rows are the same to it. All other arms, and those for which EAIK has no decomposition, are taken apart
by `partition` where they can be. What a method returns are candidates: each is refined and judged by our own
forward kinematics.

EAIK is not given arms of which the Jacobian never has full rank: on some of them (coincident neighbouring
axes) its analysis does not come to an end.

Source: D. Ostermeier, J. Külz, M. Althoff, Automatic geometric decomposition for analytical inverse
kinematics (2024).
"""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.partition import partition_of
from kinematics.inverse.search import low_discrepancy
from kinematics.se3 import cross_arrays

NEARLY = 0.1
"""Candidates with a larger error vector than this are least-squares answers, not solutions."""

FULL_RANK = 1e-4
"""Least singular value that the Jacobian of an arm without a spare joint exceeds somewhere."""

_DECOMPOSED = (5, 6)


class ClosedForm(Protocol):
    """A method that yields candidates among which all solutions are."""

    def candidates(self, target: Array) -> Array | None:
        """Configurations among which all solutions are.

        Args:
            target: (4, 4).

        Returns:
            (m, n); every isolated solution is near one of them. None where the method has no answer for this
            target.
        """
        ...


class Decomposition:
    """An arm of turning joints, decomposed by EAIK; lengths in units of the arm's size.

    Attributes:
        robot: EAIK's own object.
        n_joints: number of joints.
        size: the arm's size.
    """

    def __init__(self, robot: Any, n_joints: int, size: float) -> None:
        self.robot = robot
        self.n_joints = n_joints
        self.size = size

    def candidates(self, target: Array) -> Array | None:
        """See `ClosedForm`."""
        scaled = target.copy()
        scaled[:3, 3] /= self.size
        return np.asarray(self.robot.calculate_IK(scaled).Q, dtype=np.float64).reshape(-1, self.n_joints)


def closed_form_of(arm: Arm) -> ClosedForm | None:
    """The closed form of an arm, or None if there is none."""
    if arm.n_joints > max(_DECOMPOSED) or not _has_full_rank(arm):
        return None
    decomposition = None
    if arm.n_joints in _DECOMPOSED and arm.revolute.all() and _looks_special(arm):
        decomposition = _decomposition_of(arm)
    return decomposition or partition_of(arm)


def _looks_special(arm: Arm) -> bool:
    """Whether there is any hope: in six joints three axes that meet or are parallel, in five joints two.

    EAIK would say so too, but on the standard error stream.
    """
    z, p, _ = arm.screws
    sine = np.linalg.norm(cross_arrays(z[:-1], z[1:]), axis=1)
    gap = np.abs(np.einsum("ij,ij->i", cross_arrays(z[:-1], z[1:]), p[1:] - p[:-1]))
    near = 1e-5 * arm.size
    parallel, meeting = sine < 1e-5, gap < near * np.maximum(sine, 1e-5)
    if arm.n_joints < max(_DECOMPOSED):
        return bool((parallel | meeting).any())
    return bool((parallel[:-1] & parallel[1:]).any() or (meeting[:-1] & meeting[1:]).any())


def _has_full_rank(arm: Arm) -> bool:
    """Whether the arm has no joint to spare: its Jacobian has full rank somewhere."""
    q = 2.0 * np.pi * low_discrepancy(8, arm.n_joints)
    scale = arm.units
    J = arm.jacobians(arm.frames(q * np.where(arm.revolute, 1.0, arm.size / np.pi))) * scale
    return bool(np.linalg.svd(J, compute_uv=False)[:, -1].max() > FULL_RANK)


def _decomposition_of(arm: Arm) -> Decomposition | None:
    import eaik.pybindings.EAIK as EAIK

    directions, points, end = arm.screws
    offsets = np.diff(np.vstack((np.zeros(3), points, end[:3, 3])), axis=0) / arm.size
    try:
        robot = EAIK.Robot(directions.T.copy(), offsets.T.copy(), end[:3, :3].copy(), [], True)
    except RuntimeError:
        return None
    if not robot.has_known_decomposition() or "Unknown" in robot.get_kinematic_family():
        return None
    return Decomposition(robot, arm.n_joints, arm.size)
