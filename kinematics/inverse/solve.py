"""One target: all solutions where there is a closed form, as many as a search finds elsewhere."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import Fault, PoseError, TableError
from kinematics.inverse.arm import Arm, Array, arm_of
from kinematics.inverse.closed_form import ClosedForm, closed_form_of
from kinematics.inverse.distinct import on_continuum, one_per_continuum
from kinematics.inverse.lengths import check_lengths, is_far, too_long
from kinematics.inverse.limits import JointLimits, read_limits, within_limits
from kinematics.inverse.refinement import solutions_of
from kinematics.inverse.residuals import pose_errors
from kinematics.inverse.results import (
    IKSolution,
    IKStatus,
    InverseKinematics,
    Isolation,
    Method,
    NearestPose,
    UnreachableReason,
)
from kinematics.inverse.search import JOINTS_OF_SPACE, Bounds, Box, search
from kinematics.se3 import Transform, check_transform
from kinematics.table import NumericTable

MAX_JOINTS = 12
MOST_SOLUTIONS = 64
"""Of a search no more solutions than this are returned."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Solver:
    """An arm made ready for inverse kinematics.

    Attributes:
        table: its table.
        base: (4, 4) pose of frame 0 in the world, or None.
        tool: (4, 4) pose of the tool in frame N, or None.
        arm: its constants and joints.
        closed_form: the method that yields all solutions, if there is one.
        box: joint limits.
    """

    table: NumericTable
    base: Transform | None
    tool: Transform | None
    arm: Arm
    closed_form: ClosedForm | None
    box: Box

    def solve(self, target: ArrayLike) -> InverseKinematics:
        """The joint variables that reach a target.

        Args:
            target: (4, 4) pose of the tool in the world.

        Raises:
            PoseError: not a rigid motion, or too far away to be computed with, at ("target", …).
        """
        pose = rigid_target(target, where=("target",))
        found, method = self._candidates(pose)
        answer = self._within_limits(found, pose, method)
        if answer is not None:
            return answer
        freely = None
        if not len(found) and self.arm.n_joints <= JOINTS_OF_SPACE:
            freely = search(self.arm, pose, self.box, Bounds.IGNORED)
            found, method = freely.solutions, Method.SEARCH if len(freely.solutions) else method
            answer = self._within_limits(found, pose, Method.SEARCH)
        if answer is not None:
            return answer
        if freely is None or self.box.limited:
            return self._search_within_limits(pose, len(found), method)
        return self._unreachable(pose, freely.nearest, 0, method)

    def solve_directly(self, target: ArrayLike) -> InverseKinematics | None:
        """What the closed form alone says: solutions within the limits, or None if it has none; never long.

        Args:
            target: (4, 4) pose of the tool in the world.

        Raises:
            PoseError: not a rigid motion, or too far away to be computed with, at ("target", …).
        """
        pose = rigid_target(target, where=("target",))
        found, method = self._candidates(pose)
        return self._within_limits(found, pose, method)

    def _candidates(self, pose: Transform) -> tuple[Array, Method]:
        """Solutions by the closed form, if it has an answer for this target."""
        found = None if self.closed_form is None else solutions_of(self.arm, self.closed_form, pose)
        if found is None:
            return np.empty((0, self.arm.n_joints)), Method.SEARCH
        return found, Method.CLOSED_FORM

    def _within_limits(self, found: Array, pose: Transform, method: Method) -> InverseKinematics | None:
        """The result for solutions of which some lie within the limits."""
        inside, fits = within_limits(found, self.arm.revolute, self.box, self.arm.size)
        if not fits.any():
            return None
        return self._answer(inside[fits], pose, method, int((~fits).sum()))

    def _answer(self, joints: Array, pose: Transform, method: Method, outside: int) -> InverseKinematics:
        """The result for solutions within the limits."""
        arm = self.arm
        continuum = np.zeros(len(joints), dtype=bool)
        if arm.n_joints <= JOINTS_OF_SPACE:
            continuum, directions = on_continuum(arm, pose, joints)
            if continuum.any():
                keep = one_per_continuum(arm, joints, continuum, directions)
                joints, continuum = joints[keep], continuum[keep]
        position, angle = pose_errors(arm.frames(joints)[-1], pose)
        order = np.argsort(np.abs(joints).sum(axis=1), kind="stable")[:MOST_SOLUTIONS]
        values, distances, angles = joints.tolist(), position.tolist(), angle.tolist()
        solutions = tuple(
            IKSolution(
                joints=tuple(values[i]),
                position_error=distances[i],
                orientation_error=angles[i],
                isolation=Isolation.CONTINUUM if continuum[i] else Isolation.ISOLATED,
            )
            for i in order.tolist()
        )
        singular = bool(continuum.any())
        return InverseKinematics(
            status=IKStatus.SINGULAR if singular else IKStatus.SOLVED,
            complete=method is Method.CLOSED_FORM and not singular,
            method=method,
            solutions=solutions,
            outside_limits=outside,
        )

    def _search_within_limits(self, pose: Transform, outside: int, method: Method) -> InverseKinematics:
        """The result where no solution is known within the limits: look there, or report the nearest pose."""
        found = search(self.arm, pose, self.box, Bounds.KEPT)
        answer = self._within_limits(found.solutions, pose, Method.SEARCH)
        if answer is not None:
            return replace(answer, outside_limits=outside)
        return self._unreachable(pose, found.nearest, outside, method)

    def _unreachable(
        self, pose: Transform, nearest: Array, outside: int, method: Method
    ) -> InverseKinematics:
        """The result without solutions, but with the configuration that comes nearest."""
        wrapped, _ = within_limits(nearest[None], self.arm.revolute, self.box, self.arm.size)
        transform = self.arm.frames(wrapped)[-1, 0]
        position, angle = pose_errors(transform[None], pose)
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
            ),
            reason=UnreachableReason.JOINT_LIMITS if outside else UnreachableReason.OUT_OF_REACH,
            outside_limits=outside,
        )


def inverse_kinematics(
    table: NumericTable,
    target: ArrayLike,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    limits: JointLimits | None = None,
) -> InverseKinematics:
    """The joint variables at which the arm reaches a target: base · A_1(q) ⋯ A_N(q) · tool = target.

    Arms with a closed form yield every solution. Others are searched from many starts: what is returned are
    solutions, but there may be more. The residual of a solution is some 1e-15 of the arm's size in
    general; it is at most 1e-9 from a closed form and 1e-8 from a search, in radians and in the table's
    unit of length (in arms more than 10 000 units long, 1e-13 of their size).

    Args:
        table: the DH table, of 1 to 12 joints.
        target: (4, 4) pose of the tool in the world.
        base: (4, 4) pose of frame 0 in the world; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.
        limits: (least, greatest) of each joint [rad, or m], None where there is none.

    Raises:
        TableError: no joint, or more than 12.
        JointValueError: malformed limits.
        PoseError: target, base or tool is not a rigid motion.
    """
    return solver_of(table, base=base, tool=tool, limits=limits).solve(target)


def solver_of(
    table: NumericTable,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    limits: JointLimits | None = None,
) -> Solver:
    """The table made ready for many targets; arguments and refusals are those of `inverse_kinematics`."""
    T_w_0 = None if base is None else check_transform(base, where=("base",))
    T_n_t = None if tool is None else check_transform(tool, where=("tool",))
    for pose, name in ((T_w_0, "base"), (T_n_t, "tool")):
        if pose is not None and is_far(pose):
            raise PoseError(too_long((name,)))
    arm, closed_form = _prepared(
        table, None if T_w_0 is None else T_w_0.tobytes(), None if T_n_t is None else T_n_t.tobytes()
    )
    return Solver(
        table=table,
        base=T_w_0,
        tool=T_n_t,
        arm=arm,
        closed_form=closed_form,
        box=read_limits(limits, arm.revolute.tolist()),
    )


def rigid_target(target: ArrayLike, where: tuple[str | int, ...]) -> Transform:
    """The target as a rigid motion that can be computed with.

    Raises:
        PoseError: not a rigid motion, or a position too far away, at `where`.
    """
    pose = nearest_rigid(check_transform(target, where=where))
    if is_far(pose):
        raise PoseError(too_long(where))
    return pose


def nearest_rigid(target: Transform) -> Transform:
    """The target with its rotation part replaced by the nearest rotation, if it is off by more than rounding.

    Source: N. J. Higham, Matrix nearness problems and applications (1989) §3, the orthogonal polar factor.
    """
    R = target[:3, :3]
    if float(np.abs(R.T @ R - np.eye(3)).max()) <= 1e-14:
        return target
    U, _, V = np.linalg.svd(R)
    rigid = target.copy()
    rigid[:3, :3] = U @ V
    return rigid


@lru_cache(maxsize=256)
def _prepared(table: NumericTable, base: bytes | None, tool: bytes | None) -> tuple[Arm, ClosedForm | None]:
    check_lengths(table)
    if not 1 <= table.n_joints <= MAX_JOINTS:
        raise TableError(
            Fault(
                code="inverse_joint_count",
                where=("rows",),
                params={"count": table.n_joints, "limit": MAX_JOINTS},
            )
        )
    ends = [None if T is None else np.frombuffer(T).reshape(4, 4) for T in (base, tool)]
    arm = arm_of(table, *ends)
    return arm, closed_form_of(arm)
