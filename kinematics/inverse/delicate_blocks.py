"""Which of many targets need care: where solutions may be families, or one across a fold.

What `components` decides for the solutions of one target, by steps that are corrected back to it, is done
here for those of many targets in the same array operations, as far as it says that all stand alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.distinct import differences
from kinematics.inverse.self_motions.families import LOST
from kinematics.inverse.self_motions.isolation import (
    LONG,
    can_move,
    fold_length,
    joined_rows,
    merging_value,
)

Indices = NDArray[np.intp]

REGULAR = 1e-14
"""Determinants up to this, lengths in units of the size, are as good as zero: nothing is inverted."""


def delicate_targets(
    arm: Arm, targets: Array, joints: Array, volume: Array, counts: Indices, tolerance: float
) -> Indices:
    """Targets of which a solution may belong to a family, or two may be one across a fold.

    Args:
        arm: of six joints.
        targets: (m, 4, 4).
        joints: (k, 6) solutions, in order of the targets.
        volume: (k,) |det J| of each.
        counts: (m,) how many each target has.
        tolerance: distance [m] and angle [rad] within which the targets are reached.
    """
    suspects = _suspects(arm, joints, volume, counts, tolerance)
    if not len(suspects):
        return suspects
    owner = np.repeat(np.arange(len(counts)), counts)
    rows = np.flatnonzero(np.isin(owner, suspects))
    J = arm.jacobians(arm.frames(joints[rows])) * arm.units
    rows = rows[np.linalg.svd(J, compute_uv=False)[:, -1] <= merging_value(tolerance)]
    moving = rows[can_move(arm, targets[owner[rows]], joints[rows], tolerance)]
    joined = joined_rows(arm, targets, joints, owner, rows, tolerance)
    return np.unique(owner[np.concatenate((moving, joined))])


def _suspects(arm: Arm, joints: Array, volume: Array, counts: Indices, tolerance: float) -> Indices:
    """Targets with a solution so near to a singularity that it has to be looked at.

    The least singular value is the volume divided by the product of the others, at least.
    """
    scaled = volume / (arm.larger_five * arm.size**3)
    near = np.flatnonzero(~(scaled > merging_value(tolerance)))
    if not len(near):
        return near
    owner = np.repeat(np.arange(len(counts)), counts)
    # Double roots may have more, and are told by the other root beside them.
    of_a_family = max(LOST, 2.0 * tolerance / LONG)
    lost = near[~(scaled[near] > of_a_family)]
    lost = lost[_least_values(arm, joints[lost], of_a_family) <= of_a_family]
    first = (np.cumsum(counts) - counts)[owner[near]]
    close = np.zeros(len(near), dtype=bool)
    for k in range(int(counts.max())):
        other = np.minimum(first + k, len(joints) - 1)
        theirs = (k < counts[owner[near]]) & (other != near)
        apart = np.abs(differences(joints[other], joints[near], arm)).max(axis=1)
        close |= theirs & (apart <= fold_length(tolerance))
    beside = near[close]
    merging = merging_value(tolerance)
    beside = beside[_least_values(arm, joints[beside], merging) <= merging]
    return np.unique(owner[np.concatenate((lost, beside))])


def _least_values(arm: Arm, joints: Array, enough: float) -> Array:
    """Least singular values of the Jacobian, or less where they are above what is enough."""
    if not len(joints):
        return np.empty(0)
    J = arm.jacobians(arm.frames(joints))
    # The least singular value is at least 1 / ‖J⁻¹‖, and the inverse costs a tenth.
    regular = np.abs(np.linalg.det(J)) > REGULAR
    J[~regular] = np.eye(6)
    inverse = np.linalg.inv(J)
    least = np.where(regular, 1.0 / np.sqrt(np.einsum("mij,mij->m", inverse, inverse)), 0.0)
    unsure = np.flatnonzero(regular & (least <= enough))
    if len(unsure):
        least[unsure] = np.linalg.svd(J[unsure], compute_uv=False)[:, -1]
    return np.asarray(least)
