"""How distance and angle are weighed against each other where a rounded target is missed by both."""

import math
from dataclasses import replace

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.newton import HEAVIEST
from kinematics.inverse.residuals import errors_and_jacobians
from kinematics.inverse.self_motions.corrections import corrected_across
from kinematics.inverse.self_motions.families import Follower

LEVEL, ROUNDED = 1e-2, 1e-13
"""Where an error is least, the gradients of distance and angle leave no more of each other, or rounding."""


def follower_at(arm: Arm, target: Array, tolerance: float, q: Array) -> Follower:
    """Return a follower of families for a target.

    With two or more redundant joints every step over a surface has to keep the target: where the arm's own
    weight loses it, the one is taken with which the error is least at a solution.
    """
    follower = Follower(arm, target, tolerance)
    if arm.redundancy < 2:
        return follower
    x = q / follower.arm.units
    _, e, _ = corrected_across(follower.arm, target, x[None], np.eye(len(q))[None])
    weighed = None if follower.reached(e[0]) else weighed_otherwise(arm, follower, q)
    return follower if weighed is None else weighed


def weighed_otherwise(arm: Arm, follower: Follower, q: Array) -> Follower | None:
    """Return a follower that weighs distance against angle so that the error is least at a solution.

    A rounded pose may be missed by so much that only this weight keeps it within the tolerance. None if
    the error is least as it is.
    """
    e, J = errors_and_jacobians(arm, q[None] / arm.units, follower.target)
    pull, turn = J[0, :3].T @ e[0, :3], J[0, 3:].T @ e[0, 3:]
    size = float(np.linalg.norm(pull))
    if np.linalg.norm(pull + turn) <= LEVEL * max(size, float(np.linalg.norm(turn))) + ROUNDED:
        return None
    weight = float(-pull @ turn) / max(size * size, 1e-300)
    if not 1.0 / HEAVIEST**2 <= weight <= HEAVIEST**2:
        return None
    weighed = replace(arm, size=arm.size / math.sqrt(weight))
    return Follower(weighed, follower.target, follower.tolerance, as_it_is=True)
