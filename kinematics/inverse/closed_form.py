"""All solutions of an arm whose axes allow a decomposition into subproblems.

The library EAIK decomposes arms of one to six turning joints into the Paden–Kahan subproblems. It is given
the axes as directions and points at q = 0, not a DH table, so both conventions and fixed rows are the same
to it. What it returns are candidates: each is refined and judged by our own forward kinematics.

Source: D. Ostermeier, J. Külz, M. Althoff, Automatic geometric decomposition for analytical inverse
kinematics (2024).
"""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.sliding import sliding_form_of

NEARLY = 0.1
"""Candidates with a larger error vector than this are least-squares answers, not solutions."""


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
    """An arm of turning joints, decomposed by EAIK.

    Attributes:
        robot: EAIK's own object.
        n_joints: number of joints.
    """

    def __init__(self, robot: Any, n_joints: int) -> None:
        self.robot = robot
        self.n_joints = n_joints

    def candidates(self, target: Array) -> Array:
        """All candidates that EAIK has for a target."""
        return np.asarray(self.robot.calculate_IK(target).Q, dtype=np.float64).reshape(-1, self.n_joints)


def closed_form_of(arm: Arm) -> ClosedForm | None:
    """The closed form of an arm, or None if there is none."""
    if arm.n_joints > 6:
        return None
    return decomposition_of(arm) if arm.revolute.all() else sliding_form_of(arm)


def decomposition_of(arm: Arm) -> Decomposition | None:
    """The decomposition of an arm of turning joints, or None if there is none."""
    import eaik.pybindings.EAIK as EAIK

    directions, points, end = arm.screws
    offsets = np.diff(np.vstack((np.zeros(3), points, end[:3, 3])), axis=0)
    robot = EAIK.Robot(directions.T.copy(), offsets.T.copy(), end[:3, :3].copy(), [], True)
    if not robot.has_known_decomposition() or "Unknown" in robot.get_kinematic_family():
        return None
    return Decomposition(robot, arm.n_joints)
