"""Motions that an arm has lost in a configuration: λ ≠ 0 with λᵀ J = 0.

Source: Y. Nakamura, Advanced Robotics, ch. 4.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics.answers.jacobian_answers import jacobian_at
from kinematics.answers.singular_arms import LOST, ROUNDED, SingularArm
from kinematics.jacobian import JacobianFrame
from kinematics.se3 import Floats
from kinematics.symbolic.determinants import MotionRows


def lost_motion_is_right(arm: SingularArm, joints: Sequence[float], given: Sequence[float]) -> bool | None:
    """Judge a motion that the end lost: λ ≠ 0 with λ · J q̇ = 0 for all q̇.

    Args:
        arm: which arm, and which motion.
        joints: a singular configuration.
        given: λ: what multiplies v, and, of the whole twist, what multiplies ω; in frame 0.

    Returns:
        Whether it is; None if it is zero, or zero but for motions that the arm never makes.
    """
    J, moving = _scaled(arm, joints)
    vector = np.array(given, dtype=np.float64)
    vector /= np.abs(vector).max() or 1.0
    vector[:3] *= arm.size
    norm = float(np.linalg.norm(vector))
    if norm == 0.0 or np.linalg.norm(vector[moving]) <= ROUNDED * norm:
        return None
    return bool(np.linalg.norm(vector @ J) <= 5 * ROUNDED * norm * float(np.linalg.norm(J)))


def lost_motions_at(arm: SingularArm, joints: Sequence[float]) -> list[tuple[float, ...]]:
    """Return a basis of the motions that are lost in a configuration, the largest component 1."""
    J, moving = _scaled(arm, joints)
    left, values, _ = np.linalg.svd(J[moving])
    rank = len(arm.usual)
    kept = int((values[:rank] > LOST * arm.usual).sum())
    found = []
    for k in range(kept, rank):
        vector = np.zeros(len(moving))
        vector[moving] = left[:, k]
        vector[:3] /= arm.size
        vector /= vector[np.argmax(np.abs(vector))]
        found.append(tuple(vector.tolist()))
    return found


def _scaled(arm: SingularArm, joints: Sequence[float]) -> tuple[Floats, NDArray[np.bool_]]:
    """Return J in the arm's size for a length, and which of its rows are not always zero."""
    count = 6 if arm.rows is MotionRows.TWIST else 3
    J = jacobian_at(arm.chain, joints, JacobianFrame.BASE) * arm.units
    J[:3] /= arm.size
    return J[:count], arm.moving[:count]
