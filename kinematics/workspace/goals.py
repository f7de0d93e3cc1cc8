"""What is to be made as great as possible: a quadratic function of a place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, slots=True)
class ReachGoal:
    """rᵀ W r + c · r with r = p − origin, for a place p.

    Attributes:
        origin: (3,) from where the place is seen.
        W: (3, 3) symmetric.
        c: (3,).
    """

    origin: Array
    W: Array
    c: Array


def distance_goals(
    origin: Sequence[float] | Array, axis: Sequence[float] | Array | None
) -> tuple[ReachGoal, ReachGoal]:
    """Return the goals of being near, and of being far.

    Args:
        origin: (3,) from where the distance is measured.
        axis: (3,) unit direction of a line through the origin; then the distance is that from the line.
    """
    across = np.eye(3)
    if axis is not None:
        across -= np.outer(axis, axis)
    place, nothing = np.asarray(origin, dtype=np.float64), np.zeros(3)
    return (
        ReachGoal(origin=place, W=-across, c=nothing),
        ReachGoal(origin=place, W=across, c=nothing),
    )


def direction_goal(direction: Array) -> ReachGoal:
    """Return the goal of being far along a direction."""
    return ReachGoal(origin=np.zeros(3), W=np.zeros((3, 3)), c=direction)


@dataclass(frozen=True, slots=True)
class Goals:
    """Goals of several climbers: every field with a leading axis."""

    origin: Array
    W: Array
    c: Array

    def values(self, p: Array) -> Array:
        """Return (m,) values at the places p, (m, 3)."""
        r = p - self.origin
        return np.asarray(np.einsum("mi,mij,mj->m", r, self.W, r) + np.einsum("mi,mi->m", self.c, r))


def stacked(goals: Sequence[ReachGoal], times: int) -> Goals:
    """Return each goal so many times, one after another."""
    return Goals(
        np.repeat(np.array([goal.origin for goal in goals]), times, axis=0),
        np.repeat(np.array([goal.W for goal in goals]), times, axis=0),
        np.repeat(np.array([goal.c for goal in goals]), times, axis=0),
    )
