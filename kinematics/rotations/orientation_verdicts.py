"""What is said of an orientation in one notation, and what a wrong one looks like."""

from dataclasses import dataclass
from enum import StrEnum

from kinematics.rotations.matrices import Triple
from kinematics.rotations.properties import RotationProperty
from kinematics.rotations.sequences import EulerSequence


class ComponentOrder(StrEnum):
    """Where the scalar of a quaternion stands."""

    SCALAR_FIRST = "wxyz"
    SCALAR_LAST = "xyzw"


class RotationMistake(StrEnum):
    """What a wrong orientation is, where it is what a usual slip makes.

    TRANSPOSED: the inverse rotation. ORDER_REVERSED: the factors in reverse order, or fixed axes taken for
    current ones. DEGREES: degrees taken for radians or the reverse. HANDEDNESS: turned the other way, by the
    left-hand rule. HALF_ANGLE: a quaternion with the sine and cosine of the whole angle. COMPONENT_ORDER: the
    scalar at the other end. NOT_UNIT: a quaternion that is not of length 1. NO_AXIS: an axis of length zero.
    SOLUTION_MISSING: one triple of two. SOLUTION_TWICE: the same triple again. FAMILY_MISSING: single triples
    for a locked rotation. COMBINATION: its sum for the difference, or the reverse. NOT_LOCKED: a family for a
    rotation that has two triples. QUADRANT: an angle is off by half a turn, as atan gives it for atan2.
    ANGLE_SIGN: an angle, or what is fixed of a family, has the wrong sign. ROUNDED: a matrix with too few
    decimals.
    """

    TRANSPOSED = "transposed"
    ORDER_REVERSED = "order_reversed"
    DEGREES = "degrees"
    HANDEDNESS = "handedness"
    HALF_ANGLE = "half_angle"
    COMPONENT_ORDER = "component_order"
    NOT_UNIT = "not_unit"
    NO_AXIS = "no_axis"
    SOLUTION_MISSING = "solution_missing"
    SOLUTION_TWICE = "solution_twice"
    FAMILY_MISSING = "family_missing"
    COMBINATION = "combination"
    NOT_LOCKED = "not_locked"
    QUADRANT = "quadrant"
    ANGLE_SIGN = "angle_sign"
    ROUNDED = "rounded"
    UNIT_COLUMNS = RotationProperty.UNIT_COLUMNS.value
    PERPENDICULAR_COLUMNS = RotationProperty.PERPENDICULAR_COLUMNS.value
    RIGHT_HANDED = RotationProperty.RIGHT_HANDED.value


@dataclass(frozen=True, kw_only=True, slots=True)
class OrientationVerdict:
    """What is said of one notation of an orientation.

    Attributes:
        right: it denotes the expected rotation, and is all that was asked.
        share: of what was asked that is right, 0 … 1.
        mistakes: what the wrong part looks like; empty if no usual slip explains it.
    """

    right: bool
    share: float
    mistakes: tuple[RotationMistake, ...] = ()


@dataclass(frozen=True, kw_only=True, slots=True)
class Built:
    """How the expected rotation was described: the slips in following the description are known.

    Attributes:
        sequence: the order of the axes.
        angles: the three angles [rad].
    """

    sequence: EulerSequence
    angles: Triple


RIGHT = OrientationVerdict(right=True, share=1.0)
