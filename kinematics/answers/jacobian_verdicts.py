"""What is said of a Jacobian, in numbers or in closed form, and what a wrong one looks like."""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from kinematics.symbolic import ProofStatus


class JacobianMistake(StrEnum):
    """What a wrong Jacobian, or wrong joint forces, look like.

    NEXT_AXIS: a column is formed with the axis of the next joint, z_i for z_{i−1} or the reverse.
    POINT_SWAPPED: with p_i − p_n for p_n − p_i. PRISMATIC: the column of a prismatic joint is that of a
    revolute joint, or the reverse. OTHER_FRAME: in the axes of the other frame. ROWS_EXCHANGED: linear and
    angular rows have changed places. SPATIAL: the velocity of the point at frame 0's origin. SIGN: every
    joint force has the wrong sign. OTHER_POINT: the velocities of some other point of the last link.
    REVERSED: a column of the opposite sign. GEOMETRIC: with the angular velocity where rates of angles are
    asked. PER_DEGREE: the columns of revolute joints are per degree. OTHER_UNIT: lengths are in another unit.
    """

    NEXT_AXIS = "next_axis"
    POINT_SWAPPED = "point_swapped"
    PRISMATIC = "prismatic"
    OTHER_FRAME = "other_frame"
    ROWS_EXCHANGED = "rows_exchanged"
    SPATIAL = "spatial"
    GEOMETRIC = "geometric"
    PER_DEGREE = "per_degree"
    OTHER_UNIT = "other_unit"
    SIGN = "sign"
    OTHER_POINT = "other_point"
    REVERSED = "reversed"


@dataclass(frozen=True, kw_only=True, eq=False)
class JacobianVerdict:
    """What is said of a Jacobian.

    Attributes:
        entries: (6, n) which entries are right, linear rows first.
        mistakes: what wrong columns look like, each with the joint, from 1; of a mistake in all of them None.
    """

    entries: NDArray[np.bool_]
    mistakes: tuple[tuple[JacobianMistake, int | None], ...] = ()

    @property
    def right(self) -> bool:
        """Every entry is right."""
        return bool(self.entries.all())

    @property
    def share(self) -> float:
        """Share of the columns that are right."""
        return float(self.entries.all(axis=0).mean())


@dataclass(frozen=True, kw_only=True, eq=False)
class FormVerdict(JacobianVerdict):
    """What is said of a Jacobian in closed form.

    Attributes:
        proof: PROVED: every entry is the same function; UNDECIDED: some were compared at samples only;
            REFUTED: some differ, if only by what is rounded.
    """

    proof: ProofStatus
