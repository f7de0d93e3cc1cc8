"""Inverse kinematics of a table: what can be known of the arm before any target is, and one target."""

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import Fault, TableError
from kinematics.inverse.arm import Arm, ArmReach, arm_of
from kinematics.inverse.lengths import check_lengths, check_near
from kinematics.inverse.limits import JointLimits, read_limits
from kinematics.inverse.methods.closed_form import InverseClosedForm, closed_form_of
from kinematics.inverse.methods.locked import LockedArms, locked_arms_of
from kinematics.inverse.methods.wrist import WristArm
from kinematics.inverse.methods.wrist_scalars import ClearWrist, clear_wrist_of
from kinematics.inverse.results import InverseKinematics
from kinematics.inverse.solver import SMALL, Solver
from kinematics.se3 import check_transform
from kinematics.table import NumericTable

MAX_JOINTS = 12  # Joints of an arm whose redundancy a search can still report.


def inverse_kinematics(
    table: NumericTable,
    target: ArrayLike,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    limits: JointLimits | None = None,
    tolerance: float | None = None,
    reach: ArmReach = ArmReach.POSE,
) -> InverseKinematics:
    """Return the joint variables at which the arm reaches a target: base · A_1(q) ⋯ A_N(q) · tool = target.

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
        tolerance: distance [m] and angle [rad] within which the target counts as reached; see `Solver.solve`.
        reach: what of the tool has to reach the target; what is left out of it does not matter.

    Raises:
        TableError: no joint, or more than 12.
        JointValueError: malformed limits.
        PoseError: target, base or tool is not a rigid motion.
    """
    return solver_of(table, base=base, tool=tool, limits=limits, reach=reach).solve(target, tolerance)


def solver_of(
    table: NumericTable,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    limits: JointLimits | None = None,
    reach: ArmReach = ArmReach.POSE,
) -> Solver:
    """Make a table ready for many targets; arguments and refusals are those of `inverse_kinematics`."""
    T_w_0 = None if base is None else check_transform(base, where=("base",))
    T_n_t = None if tool is None else check_transform(tool, where=("tool",))
    for pose, name in ((T_w_0, "base"), (T_n_t, "tool")):
        if pose is not None:
            check_near(pose, name)
    arm, closed_form, clear, locked = _prepared(
        table, None if T_w_0 is None else T_w_0.tobytes(), None if T_n_t is None else T_n_t.tobytes(), reach
    )
    return Solver(
        table=table,
        base=T_w_0,
        tool=T_n_t,
        arm=arm,
        closed_form=closed_form,
        clear=clear,
        locked=locked,
        box=read_limits(limits, arm.revolute.tolist()),
    )


@lru_cache(maxsize=256)
def _prepared(
    table: NumericTable, base: bytes | None, tool: bytes | None, reach: ArmReach
) -> tuple[Arm, InverseClosedForm | None, ClearWrist | None, LockedArms | None]:
    check_lengths(table)
    if not 1 <= table.n_joints <= MAX_JOINTS:
        raise TableError(Fault.at("inverse_joint_count", "rows", count=table.n_joints, limit=MAX_JOINTS))
    T_w_0, T_n_t = (None if T is None else np.frombuffer(T).reshape(4, 4) for T in (base, tool))
    arm = arm_of(table, T_w_0, T_n_t, reach)
    closed_form = closed_form_of(arm)
    clear = None
    if isinstance(closed_form, WristArm) and arm.size >= SMALL:
        clear = clear_wrist_of(arm, closed_form)
    return arm, closed_form, clear, locked_arms_of(arm)
