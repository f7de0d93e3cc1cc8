"""The 24 sequences of three angles: which rotation they make, and all triples that make a rotation.

Twelve orders of axes (six with the first axis again at the end, called Euler angles proper, six with three
different axes, called Tait–Bryan or roll–pitch–yaw), each about current axes or about fixed ones:

    current   R = Rot_i(α) Rot_j(β) Rot_k(γ)         fixed   R = Rot_k(γ) Rot_j(β) Rot_i(α)

Every rotation has exactly two triples modulo 2π, (α, β, γ) and its partner

    proper        (α + π, −β, γ + π)                 Tait–Bryan   (α + π, π − β, γ + π)

unless the first and the last axis fall together (gimbal lock: sin β = 0 of a proper sequence, cos β = 0 of
the others). Then only α + γ or α − γ is determined, and the triples form one family.

Source: J. J. Craig, Introduction to Robotics, sec. 2.8 and appendix B; M. D. Shuster, A survey of attitude
representations, J. Astronautical Sciences 41 (1993) 439, sec. on Euler angles.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import product as all_choices

from kinematics.errors import Fault, PoseError
from kinematics.poses import GIMBAL_LOCK
from kinematics.rotations.matrices import Matrix3, Triple, product, rotation_about_axis, transposed

AXES = "XYZ"


class Turning(StrEnum):
    """About which axes the second and third rotation turn.

    CURRENT: those of the frame as the rotations before have left it. FIXED: those of the first frame.
    """

    CURRENT = "current"
    FIXED = "fixed"


class Combination(StrEnum):
    """What of the first and the last angle a gimbal lock leaves determined."""

    SUM = "sum"
    DIFFERENCE = "difference"


@dataclass(frozen=True, kw_only=True, slots=True)
class EulerSequence:
    """An order of three axes, and what they are fixed to.

    Attributes:
        axes: three of X, Y, Z in the order of the angles; neighbours differ.
        turning: about current or fixed axes.
    """

    axes: str
    turning: Turning = Turning.CURRENT

    def __post_init__(self) -> None:
        """Refuse orders of axes that do not reach every rotation.

        Raises:
            PoseError: not three of X, Y, Z, or the same axis twice running.
        """
        i, j, k = (*self.axes, "", "", "")[:3]
        if len(self.axes) != 3 or not set(self.axes) <= set(AXES) or i == j or j == k:
            raise PoseError(Fault.at("euler_axes_unknown", "axes", axes=self.axes))

    @property
    def proper(self) -> bool:
        """Whether the first axis comes again at the end."""
        return self.axes[0] == self.axes[2]

    def matrix(self, angles: Sequence[float]) -> Matrix3:
        """Return the rotation that three angles [rad] make."""
        turns = [rotation_about_axis(AXES.index(a), t) for a, t in zip(self.axes, angles, strict=True)]
        return product(*(turns if self.turning is Turning.CURRENT else reversed(turns)))

    def partner(self, angles: Triple) -> Triple:
        """Return the other triple that makes the same rotation, in (−π, π]."""
        first, middle, last = angles
        other = -middle if self.proper else math.pi - middle
        return wrapped(first + math.pi), wrapped(other), wrapped(last + math.pi)


SEQUENCES: tuple[EulerSequence, ...] = tuple(
    EulerSequence(axes=i + j + k, turning=turning)
    for turning in Turning
    for i, j, k in all_choices(AXES, repeat=3)
    if i != j and j != k
)
"""All 24."""


@dataclass(frozen=True, kw_only=True, slots=True)
class GimbalFamily:
    """All triples of a locked rotation: the middle angle, and one relation of the other two.

    Attributes:
        middle: β [rad].
        combination: whether first + last or first − last is determined.
        value: of it [rad, in (−π, π]].
    """

    middle: float
    combination: Combination
    value: float

    def last(self, first: float) -> float:
        """Return the last angle that belongs to a first one."""
        return self.value - first if self.combination is Combination.SUM else first - self.value


@dataclass(frozen=True, kw_only=True, slots=True)
class EulerSolutions:
    """Every triple of a sequence that makes a rotation.

    Attributes:
        triples: (first, middle, last) [rad, in (−π, π]]: the two of them, first that of textbooks, with its
            middle angle from 0 to π in proper sequences and from −π/2 to π/2 in the others; of a locked
            rotation one member of the family, with the last angle 0.
        family: of a locked rotation.
    """

    triples: tuple[Triple, ...]
    family: GimbalFamily | None = None


def euler_solutions(rotation: Matrix3, sequence: EulerSequence, lock: float = GIMBAL_LOCK) -> EulerSolutions:
    """Return all triples of angles that make a rotation.

    Args:
        rotation: a rotation matrix.
        lock: sine of the angle between first and last axis below which they count as one.
    """
    if sequence.turning is Turning.FIXED:
        found = euler_solutions(rotation, EulerSequence(axes=sequence.axes[::-1]), lock)
        return _reversed(found)
    i, j, k = (AXES.index(axis) for axis in sequence.axes)
    third = 3 - i - j
    sign = 1.0 if (j - i) % 3 == 1 else -1.0
    r = rotation
    if sequence.proper:
        y, x, level = sign * r[j][i], -sign * r[third][i], math.hypot(r[j][i], r[third][i])
        middle = math.atan2(level, r[i][i])
    else:
        y, x, level = -r[j][k], r[k][k], math.hypot(r[j][k], r[k][k])
        middle = sign * math.atan2(r[i][k], level)
    if level < lock:
        return _locked(rotation, sequence, (i, j, k), middle)
    first = sign * math.atan2(y, x)
    rest = product(transposed(rotation_about_axis(i, first)), r)
    # what is left is Rot_j(β) Rot_k(γ): its row j is that of Rot_k(γ)
    other = 3 - j - k
    turn = 1.0 if (j - k) % 3 == 1 else -1.0
    last = math.atan2(-turn * rest[j][other], rest[j][j])
    triple = (wrapped(first), wrapped(middle), wrapped(last))
    return EulerSolutions(triples=(triple, sequence.partner(triple)))


def wrapped(angle: float) -> float:
    """Return an angle in (−π, π]."""
    turned = math.remainder(angle, math.tau)
    return math.pi if turned <= -math.pi else turned + 0.0


def _locked(
    rotation: Matrix3, sequence: EulerSequence, axes: tuple[int, int, int], middle: float
) -> EulerSolutions:
    """One family: turning about the first axis alone takes Rot_j(β) to the rotation."""
    i, j, k = axes
    if sequence.proper:
        middle = 0.0 if abs(middle) < 1.0 else math.pi
    else:
        middle = math.copysign(math.pi / 2, middle)
    alone = product(rotation, transposed(rotation_about_axis(j, middle)))
    p, q = (i + 1) % 3, (i + 2) % 3
    first = wrapped(math.atan2(alone[q][p], alone[p][p]))
    along = rotation_about_axis(j, middle)[i][k]  # Rot_j(β) carries the last axis onto ± the first
    combined = Combination.SUM if along > 0.0 else Combination.DIFFERENCE
    family = GimbalFamily(middle=middle, combination=combined, value=first)
    return EulerSolutions(triples=((first, middle, 0.0),), family=family)


def _reversed(found: EulerSolutions) -> EulerSolutions:
    family = found.family
    if family is not None:
        summed = family.combination is Combination.SUM
        value = family.value if summed else wrapped(-family.value)
        family = GimbalFamily(middle=family.middle, combination=family.combination, value=value)
        return EulerSolutions(triples=((family.value, family.middle, 0.0),), family=family)
    a, b = ((last, middle, first) for first, middle, last in found.triples)
    return EulerSolutions(triples=(a, b), family=None)
