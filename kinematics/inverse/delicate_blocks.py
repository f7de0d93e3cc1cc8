"""Which of many targets need care: where solutions may be families, or one across a fold.

What `components` decides for the solutions of one target, by steps that are corrected back to it, is done
here for those of many targets in the same array operations, as far as it says that all stand alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.components import LONG, fold_length, lost_value, merging_value
from kinematics.inverse.distinct import differences
from kinematics.inverse.families import LOST, corrected, weighing_alike
from kinematics.inverse.goals import LEAST_TOLERANCE
from kinematics.inverse.residuals import are_solutions

Indices = NDArray[np.intp]

OF_A_FAMILY = max(LOST, 2.0 * LEAST_TOLERANCE / LONG)
"""Least singular value up to which an exact solution may be of a family. Those of a double root may have
more, and are told by the other root beside them."""

REGULAR = 1e-14
"""Determinants up to this, lengths in units of the size, are as good as zero: nothing is inverted."""


def delicate_targets(arm: Arm, targets: Array, joints: Array, volume: Array, counts: Indices) -> Indices:
    """Targets of which a solution may belong to a family, or two may be one across a fold.

    Args:
        arm: of six joints.
        targets: (m, 4, 4).
        joints: (k, 6) solutions, in order of the targets.
        volume: (k,) |det J| of each.
        counts: (m,) how many each target has.
    """
    suspects = _suspects(arm, joints, volume, counts)
    if not len(suspects):
        return suspects
    owner = np.repeat(np.arange(len(counts)), counts)
    rows = np.flatnonzero(np.isin(owner, suspects))
    J = arm.jacobians(arm.frames(joints[rows])) * arm.units
    rows = rows[np.linalg.svd(J, compute_uv=False)[:, -1] <= merging_value(LEAST_TOLERANCE)]
    moving = rows[_move(arm, targets[owner[rows]], joints[rows])]
    return np.unique(owner[np.concatenate((moving, _joined(arm, targets, joints, owner, rows)))])


def _suspects(arm: Arm, joints: Array, volume: Array, counts: Indices) -> Indices:
    """Targets with a solution so near to a singularity that it has to be looked at.

    The least singular value is the volume divided by the product of the others, at least.
    """
    scaled = volume / (arm.larger_five * arm.size**3)
    near = np.flatnonzero(~(scaled > merging_value(LEAST_TOLERANCE)))
    if not len(near):
        return near
    owner = np.repeat(np.arange(len(counts)), counts)
    lost = near[~(scaled[near] > OF_A_FAMILY)]
    lost = lost[_least_values(arm, joints[lost], OF_A_FAMILY) <= OF_A_FAMILY]
    first = (np.cumsum(counts) - counts)[owner[near]]
    close = np.zeros(len(near), dtype=bool)
    for k in range(int(counts.max())):
        other = np.minimum(first + k, len(joints) - 1)
        theirs = (k < counts[owner[near]]) & (other != near)
        apart = np.abs(differences(joints[other], joints[near], arm)).max(axis=1)
        close |= theirs & (apart <= fold_length(LEAST_TOLERANCE))
    beside = near[close]
    merging = merging_value(LEAST_TOLERANCE)
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


def _move(arm: Arm, targets: Array, joints: Array) -> NDArray[np.bool_]:
    """(k,) whether a solution can be moved as far as one of a family, or in more than one direction."""
    alike = weighing_alike(arm)
    x = joints / alike.units
    J = alike.jacobians(alike.frames(joints)) * alike.units
    _, values, directions = np.linalg.svd(J)
    blind = (values <= lost_value(LEAST_TOLERANCE)).sum(axis=1)
    found = blind > 1
    one = np.flatnonzero(blind == 1)
    way = fold_length(LEAST_TOLERANCE) * directions[one, -1]
    ways, both = np.concatenate((way, -way)), np.concatenate((one, one))
    found[both[_reach(alike, targets[both], x[both] + ways, ways, fold_length(LEAST_TOLERANCE))]] = True
    return np.asarray(found)


def _joined(arm: Arm, targets: Array, joints: Array, owner: Indices, rows: Indices) -> Indices:
    """Rows whose solution may be joined to another of the same target."""
    alike = weighing_alike(arm)
    pairs = [(rows[:-k], rows[k:]) for k in range(1, int(np.bincount(owner[rows]).max(initial=1)))]
    one, other = (np.concatenate([pair[i] for pair in pairs] or [rows[:0]]) for i in (0, 1))
    same = owner[one] == owner[other]
    one, other = one[same], other[same]
    apart = differences(joints[other], joints[one], arm)
    near = np.abs(apart).max(axis=1) <= fold_length(LEAST_TOLERANCE)
    one, way = one[near], apart[near]
    middle, half = joints[one] / alike.units + 0.5 * way, 0.5 * np.linalg.norm(way, axis=1)
    return np.asarray(one[_reach(alike, targets[owner[one]], middle, way, half)])


def _reach(arm: Arm, targets: Array, x: Array, way: Array, farthest: Array | float) -> NDArray[np.bool_]:
    """(k,) whether what is beside solutions reaches their targets, corrected across the way by so much."""
    if not len(x):
        return np.empty(0, dtype=bool)
    unit = way / np.maximum(np.linalg.norm(way, axis=1), 1e-300)[:, None]
    there, e, _ = corrected(arm, targets, x, unit[:, None])
    near = np.linalg.norm(there - x, axis=1) <= farthest
    return np.asarray(near & are_solutions(e, arm, LEAST_TOLERANCE))
