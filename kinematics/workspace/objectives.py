"""What is to be made as great as possible: a quadratic function of a place."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.se3 import Floats


@dataclass(frozen=True, kw_only=True, slots=True)
class Objective:
    """rᵀ W r + c · r with r = p − origin, for a place p.

    Attributes:
        origin: (3,) from where the place is seen.
        W: (3, 3) symmetric.
        c: (3,).
    """

    origin: Floats
    W: Floats
    c: Floats


def distance_objectives(
    origin: Sequence[float] | Floats, axis: Sequence[float] | Floats | None
) -> tuple[Objective, Objective]:
    """Return the objectives of being near, and of being far.

    Args:
        origin: (3,) from where the distance is measured.
        axis: (3,) unit direction of a line through the origin; then the distance is that from the line.
    """
    across = np.eye(3)
    if axis is not None:
        across -= np.outer(axis, axis)
    place, nothing = np.asarray(origin, dtype=np.float64), np.zeros(3)
    return (Objective(origin=place, W=-across, c=nothing), Objective(origin=place, W=across, c=nothing))


def direction_objective(direction: Floats) -> Objective:
    """Return the objective of being far along a direction."""
    return Objective(origin=np.zeros(3), W=np.zeros((3, 3)), c=direction)


@dataclass(frozen=True, slots=True)
class Objectives:
    """Objectives of several ascents: every field with a leading axis."""

    origin: Floats
    W: Floats
    c: Floats

    def values(self, p: Floats) -> Floats:
        """Return (m,) values at the places p, (m, 3)."""
        r = p - self.origin
        return np.asarray(np.einsum("mi,mij,mj->m", r, self.W, r) + np.einsum("mi,mi->m", self.c, r))


def stacked(objectives: Sequence[Objective], times: int) -> Objectives:
    """Return each objective so many times, one after another."""
    return Objectives(
        np.repeat(np.array([objective.origin for objective in objectives]), times, axis=0),
        np.repeat(np.array([objective.W for objective in objectives]), times, axis=0),
        np.repeat(np.array([objective.c for objective in objectives]), times, axis=0),
    )
