"""Families in pieces: what lies on the way of a family behind a gap in which the target is lost.

A wrist beside its line that is known to within a tolerance may turn by an interval, and half a turn on by
another; a fold between the two may come as near without reaching the target exactly. Between the pieces the
pose is off by some tolerances, so the way is followed with as much allowed, and where it comes near is tried.
"""

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Array
from kinematics.inverse.newton import polish
from kinematics.inverse.residuals import are_solutions, errors_at
from kinematics.inverse.self_motions.families import FamilyPath, Follower, nearest_on
from kinematics.inverse.self_motions.paths import path_through

WIDEST = 0.05
"""A way is followed no farther from its target than this [rad, and parts of the size]: corrections from there
may lead to another."""


def way_through_gaps(follower: Follower, joints: Array, path: FamilyPath, gap: float) -> FamilyPath:
    """Return the path on which a family lies, followed through gaps.

    In a gap the pose may be off by `gap` tolerances.
    """
    arm = follower.arm
    wide = Follower(arm, follower.target, min(gap * follower.tolerance, WIDEST * min(arm.size, 1.0)))
    _, chord = nearest_on(arm, path, joints)
    length = float(np.linalg.norm(chord))
    if length == 0.0 or wide.tolerance <= follower.tolerance:
        return path
    way = path_through(wide, joints / arm.units, chord / length)
    follower.spent += wide.spent
    return way


def nearest_places(follower: Follower, way: FamilyPath) -> list[Array]:
    """Return configurations that reach the target: one of each piece of a way, and where it comes nearest."""
    arm, points = follower.arm, way.points
    errors = errors_at(arm, points, follower.target)
    off = np.linalg.norm(errors, axis=1)
    around = (
        np.concatenate((off[-1:], off, off[:1])) if way.closed else np.pad(off, 1, constant_values=np.inf)
    )
    there = are_solutions(errors, arm, follower.tolerance)
    asked = ~there & (off <= around[:-2]) & (off <= around[2:])
    piece = _pieces(follower, way, there)
    order = np.flatnonzero(there)[np.argsort(off[there], kind="stable")]
    asked[order[np.unique(piece[order], return_index=True)[1]]] = True
    nearest = points[asked]
    found = np.stack((polish(arm, follower.target, nearest), nearest), axis=1)
    return [
        next(q for q, there in zip(pair, reached, strict=True) if there)
        for pair, reached in zip(found, _reached(follower, found), strict=True)
        if reached.any()
    ]


def _pieces(follower: Follower, way: FamilyPath, there: NDArray[np.bool_]) -> NDArray[np.intp]:
    """(m,) the piece of each point of a way; one ends where the target is lost, if only between points."""
    x = way.points / follower.arm.units
    both = np.flatnonzero(there & np.roll(there, -1))
    both = both if way.closed else both[both < len(x) - 1]
    after = (both + 1) % len(x)
    ends = x[both] - follower.back_to(x[both], x[after])
    joined = np.zeros(len(x), dtype=bool)
    joined[both[follower.joined_each(x[both], ends)]] = True
    piece = np.concatenate(([0], np.cumsum(~joined[:-1])))
    piece[piece == piece[-1]] = piece[0] if joined[-1] else piece[-1]
    return np.asarray(piece)


def _reached(follower: Follower, pairs: Array) -> Array:
    arm = follower.arm
    errors = errors_at(arm, pairs.reshape(-1, arm.n_joints), follower.target)
    return np.array([follower.reached(e) for e in errors]).reshape(-1, 2)
