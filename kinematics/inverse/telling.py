"""What is told of one target: solutions with their errors, or the pose that comes nearest."""

import numpy as np

from kinematics.inverse.arm import Arm, ArmReach, Array
from kinematics.inverse.goals import Goal
from kinematics.inverse.limits import within_limits
from kinematics.inverse.residuals import errors_of, pose_errors
from kinematics.inverse.results import (
    Family,
    IKSolution,
    IKStatus,
    InverseKinematics,
    Isolation,
    Method,
    NearestPose,
    UnreachableReason,
)
from kinematics.inverse.search import Box
from kinematics.se3 import Transform

MOST_SOLUTIONS = 64  # No more are returned of a search.

_STEPS_LEAVE = 1e-15
"""Joint values below this part of their unit are what steps towards 0 leave of it, down to 1e-320."""


def told_solutions(
    arm: Arm, found: list[tuple[Array, Family | None]], pose: Transform
) -> tuple[IKSolution, ...]:
    """Return solutions with their errors, the one with the smallest joint values first.

    Where there are too many, members of families that were not followed are left out.
    """
    mere = [family is not None and not family.parameters for _, family in found]
    found = [found[i] for i in np.argsort(mere, kind="stable")[:MOST_SOLUTIONS].tolist()]
    joints = np.array([q for q, _ in found])
    position, angle = _errors(arm, arm.frames(joints)[-1], pose)
    order = np.argsort(np.abs(joints / arm.units).sum(axis=1), kind="stable")
    values, distances, angles = joints.tolist(), position.tolist(), angle.tolist()
    return tuple(
        IKSolution(
            joints=tuple(values[i]),
            position_error=distances[i],
            orientation_error=angles[i],
            isolation=Isolation.ISOLATED if found[i][1] is None else Isolation.CONTINUUM,
            family=found[i][1],
        )
        for i in order.tolist()
    )


def unreachable(
    arm: Arm, box: Box, goal: Goal, nearest: Array, outside: int, method: Method
) -> InverseKinematics:
    """Return the answer without solutions, but with the configuration that comes nearest."""
    settled = np.where(np.abs(nearest) < _STEPS_LEAVE * arm.units, 0.0, nearest)
    wrapped, _ = within_limits(settled[None], arm.revolute, box, arm.size)
    transform = arm.frames(wrapped)[-1, 0]
    position, angle = _errors(arm, transform[None], goal.pose)
    return InverseKinematics(
        status=IKStatus.UNREACHABLE,
        complete=method is Method.CLOSED_FORM,
        method=method,
        solutions=(),
        nearest=NearestPose(
            joints=tuple(wrapped[0].tolist()),
            transform=transform,
            position_error=float(position[0]),
            orientation_error=float(angle[0]),
            size=arm.size,
        ),
        reason=UnreachableReason.JOINT_LIMITS if outside else UnreachableReason.OUT_OF_REACH,
        outside_limits=outside,
        tolerance=goal.tolerance,
    )


def _errors(arm: Arm, poses: Array, pose: Transform) -> tuple[Array, Array]:
    """Distances [m] and angles [rad] from the target, of what has to reach it."""
    if arm.reach is ArmReach.POSE:
        return pose_errors(poses, pose)
    errors = errors_of(arm, poses, pose)
    return arm.size * np.linalg.norm(errors[:, :3], axis=1), np.linalg.norm(errors[:, 3:], axis=1)
