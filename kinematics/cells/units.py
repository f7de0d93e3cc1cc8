"""Units that a DH table is written in, and kinds of parameter."""

import math
from enum import StrEnum
from fractions import Fraction


class AngleUnit(StrEnum):
    """Unit of the angles of a table."""

    RAD = "rad"
    DEG = "deg"

    @property
    def sign(self) -> str:
        """What stands behind a number."""
        return "°" if self is AngleUnit.DEG else "rad"

    @property
    def radians(self) -> float:
        """One unit [rad]."""
        return math.radians(1.0) if self is AngleUnit.DEG else 1.0

    def in_radians(self, angle: float) -> float:
        """Return an angle of this unit in [rad]."""
        return math.radians(angle) if self is AngleUnit.DEG else angle

    def from_radians(self, angle: float) -> float:
        """Return an angle [rad] in this unit."""
        return math.degrees(angle) if self is AngleUnit.DEG else angle


class LengthUnit(StrEnum):
    """Unit of the lengths of a table."""

    M = "m"
    CM = "cm"
    MM = "mm"
    IN = "in"

    @property
    def metres_per_unit(self) -> Fraction:
        """Length of one unit [m], exact."""
        return _METRES[self]


class ParameterKind(StrEnum):
    """What a parameter, or the value of a cell, measures."""

    LENGTH = "length"
    ANGLE = "angle"


_METRES = {
    LengthUnit.M: Fraction(1),
    LengthUnit.CM: Fraction(1, 100),
    LengthUnit.MM: Fraction(1, 1000),
    LengthUnit.IN: Fraction(254, 10000),
}
