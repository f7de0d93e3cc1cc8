"""Walks from one solution to another, by steps that keep the target reached."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Array
from kinematics.inverse.residuals import are_solutions
from kinematics.inverse.self_motions.corrections import corrected_across
from kinematics.inverse.self_motions.families import Follower
from kinematics.inverse.self_motions.paths import FIRST_STEP, MOST_STEPS

WALK, SHORTEST_WALK = 0.2, 1e-2
"""Steps of a walk from one solution to another [rad, or parts of the size]: longest and shortest."""

NEARER = 0.01  # Part of its step by which a walk has to come nearer.

ASTRAY = 0.01
"""A walk ends where less than this part of the way to its end lies in directions that it may take."""

HALVINGS = 14
"""How often a step is halved to see whether it jumped: what lies between the ends of two families is as wide
as the square root of a tolerance, 1e-5 and more, and WALK halved so often is that."""


def leads(follower: Follower, starts: Array, ends: Array, lost: float) -> NDArray[np.bool_]:
    """Return whether steps in the null space, corrected across it, lead from solutions to others.

    Of all ways the one is tried that comes nearer with every step: over a surface, or within the width
    that a tolerance gives to families that cross.

    Args:
        follower: of the target.
        starts: (m, n) solutions, in units.
        ends: (m, n) the others.
        lost: singular values up to this are zero.
    """
    arrived, taken = _walked(follower, starts, ends, lost)
    if arrived.any() and not follower.arm.redundancy:
        arrived[_jumped(follower, taken, arrived)] = False
    return arrived


def lead_to_one(follower: Follower, starts: Array, places: Array, lost: float) -> NDArray[np.bool_]:
    """Return whether such steps lead from solutions, (m, n), to one of their places each, (k, m, n).

    Of the walks that arrive from a solution one after another is asked for jumps, until one has none.
    """
    tiled = np.tile(starts, (len(places), 1))
    walked, taken = _walked(follower, tiled, places.reshape(tiled.shape), lost)
    arrived = walked.reshape(places.shape[:2])
    if follower.arm.redundancy:
        return np.asarray(arrived.any(axis=0))
    found = np.zeros(len(starts), dtype=bool)
    while arrived.any():
        asked = arrived & (arrived.cumsum(axis=0) == 1)
        sound = asked.ravel()  # the same array, walk by walk
        arrived &= ~asked
        sound[_jumped(follower, taken, sound)] = False
        found |= asked.any(axis=0)
        arrived &= ~found
    return found


def _walked(
    follower: Follower, starts: Array, ends: Array, lost: float
) -> "tuple[NDArray[np.bool_], list[_Steps]]":
    """Which walks arrive; and their steps, unless joints are redundant: some may have jumped."""
    arrived = np.zeros(len(starts), dtype=bool)
    x, longest, going = starts.copy(), np.full(len(starts), WALK), np.arange(len(starts))
    taken: list[_Steps] = []
    for _ in range(MOST_STEPS):
        way = follower.back_to(ends[going], x[going])
        left = np.linalg.norm(way, axis=1)
        close = left <= FIRST_STEP
        last, end = x[going[close]], x[going[close]] + way[close]
        arrived[going[close]] = follower.joined_each(last, end)
        if not follower.arm.redundancy:
            across = np.eye(x.shape[1]) - _null_projections(follower, last, lost)
            taken.append(_Steps(going[close], last, end, across))
        going, way, left = going[~close], way[~close], left[~close]
        null = _null_projections(follower, x[going], lost)
        along = (null @ way[:, :, None])[:, :, 0]
        length = np.linalg.norm(along, axis=1)
        ahead = length >= ASTRAY * left
        going, left, length, null = going[ahead], left[ahead], length[ahead], null[ahead]
        if not len(going) or follower.is_spent:
            break
        step = np.minimum(longest[going], length)
        aim = x[going] + along[ahead] * (step / length)[:, None]
        follower.count(len(going))
        across = np.eye(len(x[0])) - null
        there, e, _ = corrected_across(follower.arm, follower.target, aim, across)
        near = np.linalg.norm(there - aim, axis=1) <= step
        nearer = np.linalg.norm(follower.back_to(ends[going], there), axis=1) <= left - NEARER * step
        moved = near & nearer & are_solutions(e, follower.arm, follower.tolerance)
        moved[moved] = _keeps(follower, x[going[moved]], aim[moved], across[moved])
        if not follower.arm.redundancy:
            taken.append(_Steps(going[moved], x[going[moved]], there[moved], across[moved]))
        x[going[moved]] = there[moved]
        longest[going] = np.where(moved, np.minimum(2.0 * step, WALK), 0.5 * step)
        going = going[longest[going] >= SHORTEST_WALK]
    return arrived, taken


class _Steps(NamedTuple):
    """Steps of walks side by side: whose each is, (k,), from where and to where, (k, n), and across what."""

    walk: NDArray[np.intp]
    start: Array
    end: Array
    across: Array

    def of(self, some: NDArray[np.bool_]) -> "_Steps":
        """Return those of some of the walks."""
        these = some[self.walk]
        return _Steps(self.walk[these], self.start[these], self.end[these], self.across[these])


def _jumped(follower: Follower, taken: Sequence[_Steps], arrived: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The walks among those that arrived of which a step jumped to another family.

    Two families with the end-effector the one way and the other, half a turn of the wrist apart, may come as
    near to each other as their ends are wide. Between points of one family the middle is on it, however near
    they are; a step over a gap is halved, the half with the wider gap next, until its middle is in the gap.
    """
    asked = [steps.of(arrived) for steps in taken]
    walk = np.concatenate([steps.walk for steps in asked])
    low = np.concatenate([steps.start for steps in asked])
    high = np.concatenate([steps.end for steps in asked])
    across = np.concatenate([steps.across for steps in asked])
    jumped = np.zeros(len(walk), dtype=bool)
    for _ in range(HALVINGS):
        follower.count(len(walk))
        middle, e, _ = corrected_across(follower.arm, follower.target, 0.5 * (low + high), across)
        jumped |= ~are_solutions(e, follower.arm, follower.tolerance)
        upper = np.linalg.norm(high - middle, axis=1) > np.linalg.norm(middle - low, axis=1)
        low, high = np.where(upper[:, None], middle, low), np.where(upper[:, None], high, middle)
    return np.unique(walk[jumped])


def _keeps(follower: Follower, x: Array, aim: Array, across: Array) -> NDArray[np.bool_]:
    """Whether steps of a walk keep the target half way too, where another solution is no longer joined.

    With two redundant joints there are ways around such a place, and each step is taken as it is.
    """
    if follower.arm.redundancy > 1 or not len(x):
        return np.ones(len(x), dtype=bool)
    follower.count(len(x))
    middle = 0.5 * (x + aim)
    there, e, _ = corrected_across(follower.arm, follower.target, middle, across)
    near = np.linalg.norm(there - middle, axis=1) <= np.linalg.norm(aim - x, axis=1)
    return np.asarray(near & are_solutions(e, follower.arm, follower.tolerance))


def _null_projections(follower: Follower, x: Array, lost: float) -> Array:
    """(m, n, n) projections onto the null spaces of the Jacobians at x, singular values up to `lost`."""
    _, values, rows = np.linalg.svd(follower.jacobians(x))
    seen = np.zeros(rows.shape[:2])
    seen[:, : values.shape[1]] = values > lost
    rows = np.where(seen[:, :, None] > 0.0, 0.0, rows)
    return np.asarray(rows.transpose(0, 2, 1) @ rows)
