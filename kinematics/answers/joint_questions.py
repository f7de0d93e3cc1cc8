"""A pose and all that reaches it: what an answer in joint values is judged by."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.answers.joint_verdicts import JointClaim
from kinematics.chain import Chain, chain_of_table, size_of
from kinematics.inverse import ArmReach, InverseKinematics, Solver, UnreachableReason
from kinematics.inverse.results import IKStatus, Isolation, Method
from kinematics.se3 import Transform

USUAL_TOLERANCE = 0.005  # Of positions as a share of the arm's size, and of angles [rad].


@dataclass(frozen=True, kw_only=True, eq=False)
class JointQuestion:
    """A pose and all that reaches it.

    Attributes:
        solver: the arm, with its limits.
        chain: the same arm, to evaluate configurations.
        target: (4, 4) the pose.
        found: every solution.
        every: all solutions are asked, not one.
        tolerance: of positions as a share of the arm's size, and of angles [rad].
        reach: what of the tool has to reach the target: its pose, or its position alone.
    """

    solver: Solver
    chain: Chain
    target: Transform
    found: InverseKinematics
    every: bool = True
    tolerance: float = USUAL_TOLERANCE
    reach: ArmReach = ArmReach.POSE

    @property
    def size(self) -> float:
        """Typical length of the arm."""
        return size_of(self.chain) or 1.0

    @property
    def expected(self) -> JointClaim:
        """What is true of the pose."""
        if self.found.status is IKStatus.UNREACHABLE:
            limits = self.found.reason is UnreachableReason.JOINT_LIMITS
            return JointClaim.JOINT_LIMITS if limits else JointClaim.OUT_OF_REACH
        families = any(found.isolation is Isolation.CONTINUUM for found in self.found.solutions)
        return JointClaim.INFINITE if families else JointClaim.FINITE

    @property
    def known(self) -> bool:
        """Every solution is known: isolated ones by a closed form, families by having been followed."""
        families = [found.family for found in self.found.solutions if found.isolation is Isolation.CONTINUUM]
        followed = all(family is not None and family.parameters for family in families)
        return self.found.complete or (self.found.method is Method.CLOSED_FORM and followed)

    def pose(self, row: Sequence[float]) -> Transform:
        """Return the tool's pose at a row of joint values."""
        pose: Transform = self.chain.poses(np.array([row], dtype=np.float64))[0]
        return pose

    def errors(self, pose: Transform) -> tuple[bool, bool]:
        """Return whether position and orientation of a pose are those of the target."""
        target = self.target
        position = float(np.linalg.norm(pose[:3, 3] - target[:3, 3])) <= self.tolerance * self.size
        if self.reach is ArmReach.POSITION:
            return position, True
        chord = float(np.linalg.norm(pose[:3, :3] - target[:3, :3])) / math.sqrt(8.0)
        return position, 2.0 * math.asin(min(1.0, chord)) <= self.tolerance

    def reaches(self, row: Sequence[float]) -> bool:
        """Return whether a row of joint values reaches the target, limits left out."""
        return all(math.isfinite(value) for value in row) and all(self.errors(self.pose(row)))

    def apart(self, row: Iterable[float], other: Iterable[float]) -> float:
        """Return the largest difference of two rows, turns left out; slides as shares of the size."""
        return max(
            abs(a - b) / self.size if axis.prismatic else abs(math.remainder(a - b, math.tau))
            for a, b, axis in zip(row, other, self.chain.axes, strict=True)
        )


def joint_question(
    solver: Solver,
    target: Transform,
    *,
    every: bool = True,
    tolerance: float = USUAL_TOLERANCE,
    reach: ArmReach = ArmReach.POSE,
    found: InverseKinematics | None = None,
) -> JointQuestion:
    """Return a pose with all that reaches it.

    Args:
        solver: the arm with its limits (`kinematics.inverse.solver_of`), made for the same reach.
        target: (4, 4) pose of the tool.
        every: all solutions are asked, not one.
        tolerance: of positions as a share of the arm's size, and of angles [rad].
        reach: what of the tool has to reach the target: its pose, or its position alone.
        found: what the solver says of the target, where that is known.

    Raises:
        PoseError: the target is no rigid motion, or too far away to be computed with.
    """
    chain = chain_of_table(solver.table, solver.base, solver.tool)
    return JointQuestion(
        solver=solver,
        chain=chain,
        target=target,
        found=solver.solve(target) if found is None else found,
        every=every,
        tolerance=tolerance,
        reach=reach,
    )
