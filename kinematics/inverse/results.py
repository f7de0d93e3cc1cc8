"""What inverse kinematics returns. Unreachable and singular are results, not errors."""

import math
from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from kinematics.se3 import Transform


class IKStatus(StrEnum):
    """What is to be said about a target.

    SOLVED: at least one solution. SINGULAR: families of solutions of more dimensions than the arm has joints
    to spare, the Jacobian's rank being below its generic rank. UNREACHABLE: none within the limits; the
    nearest pose is returned.
    """

    SOLVED = "solved"
    SINGULAR = "singular"
    UNREACHABLE = "unreachable"


class UnreachableReason(StrEnum):
    """Why no solution is returned.

    OUT_OF_REACH: no configuration reaches the target. JOINT_LIMITS: some do, all of them outside the limits.
    """

    OUT_OF_REACH = "out_of_reach"
    JOINT_LIMITS = "joint_limits"


class Method(StrEnum):
    """How solutions were found: by a decomposition that yields all of them, or by search."""

    CLOSED_FORM = "closed_form"
    SEARCH = "search"


class Isolation(StrEnum):
    """Whether a solution stands alone or belongs to a family."""

    ISOLATED = "isolated"
    CONTINUUM = "continuum"


@dataclass(frozen=True, kw_only=True, slots=True)
class FamilyParameter:
    """A joint that may be chosen within a family; the others follow from it.

    Attributes:
        joint: number of the joint, from 1.
        least: least value of the joint in the family [rad, or m].
        greatest: greatest value.
        full_turn: whether it turns fully, and the interval is closed to a circle.
    """

    joint: int
    least: float
    greatest: float
    full_turn: bool


@dataclass(frozen=True, kw_only=True, slots=True)
class Family:
    """Solutions joined by a path on which the target stays reached.

    Attributes:
        dimension: number of joints that may be chosen.
        parameters: these joints, if the family was followed; the interval of each holds while the others keep
            the values that they have in the solution.
        direction: (n,) joint velocities along the family, if it is straight, the parameter's being 1: then
            joints + t·direction reaches the target within three tolerances, for every value of the parameter
            in its interval. Of a family of more than one dimension none.
        members: members in order along the family, ends included [rad, or m].
    """

    dimension: int
    parameters: tuple[FamilyParameter, ...] = ()
    direction: tuple[float, ...] | None = None
    members: tuple[tuple[float, ...], ...] = ()


class IKSolution(NamedTuple):
    """One way to reach the target.

    Attributes:
        joints: q_1 … q_n [rad, or m]; turns in (-π, π], or the value within the limits that is nearest to 0.
        position_error: distance from the target [m], from the forward kinematics of these joints.
        orientation_error: angle from the target [rad], likewise.
        isolation: whether it stands alone.
        family: what it is a member of, if it does not.
    """

    joints: tuple[float, ...]
    position_error: float
    orientation_error: float
    isolation: Isolation = Isolation.ISOLATED
    family: Family | None = None

    @property
    def residual(self) -> float:
        """√(position_error² + orientation_error²)."""
        return math.hypot(self.position_error, self.orientation_error)


@dataclass(frozen=True, kw_only=True, slots=True)
class NearestPose:
    """The configuration within the limits that comes nearest to an unreachable target.

    Nearest is what makes (distance / size)² + angle² least.

    Attributes:
        joints: q_1 … q_n [rad, or m].
        transform: (4, 4) the pose there.
        position_error: its distance from the target [m].
        orientation_error: its angle from the target [rad].
        size: the sum of the arm's offsets [m].
    """

    joints: tuple[float, ...]
    transform: Transform
    position_error: float
    orientation_error: float
    size: float


class InverseKinematics(NamedTuple):
    """The answer for one target.

    Attributes:
        status: solved, singular or unreachable.
        complete: whether `solutions` are all there are within the limits, turns of 2π not counted twice.
        method: how they were found.
        solutions: distinct solutions, the one with the smallest joint values first.
        nearest: the nearest pose, if unreachable.
        reason: why it is unreachable.
        outside_limits: number of solutions, or families, that were found outside the limits.
        tolerance: distance [m] and angle [rad] within which the target counts as reached.
    """

    status: IKStatus
    complete: bool
    method: Method
    solutions: tuple[IKSolution, ...]
    nearest: NearestPose | None = None
    reason: UnreachableReason | None = None
    outside_limits: int = 0
    tolerance: float = 0.0
