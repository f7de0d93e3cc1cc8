"""What an exercise leaves free and what it fixes, when it asks whether two tables are the same robot."""

from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property


class ConventionRule(StrEnum):
    """Which convention the submission may be written in."""

    ANY = "any"
    STANDARD = "standard"
    MODIFIED = "modified"


class BaseRule(StrEnum):
    """Where frame 0 of the submission must lie.

    FREE: anywhere.
    AXIS: z_0 on the first joint's axis or on the reference's z_0, either way round, its origin anywhere along
        it (parallel to it, if the first joint is prismatic).
    ORIGIN: its origin at the reference's frame 0, turned as it likes.
    FRAME: exactly on the reference's frame 0.
    """

    FREE = "free"
    AXIS = "axis"
    ORIGIN = "origin"
    FRAME = "frame"


class ToolRule(StrEnum):
    """Where the last frame N of the submission must lie, as seen from the last link.

    FREE: anywhere.
    POINT: its origin at the origin of the reference's frame N (the marked tool point).
    AXIS: z_N on the last joint's axis or on the reference's z_N, either way round, its origin anywhere along
        it (parallel to it, if the last joint is prismatic).
    FRAME: exactly on the reference's frame N.
    """

    FREE = "free"
    POINT = "point"
    AXIS = "axis"
    FRAME = "frame"


class ZeroRule(StrEnum):
    """Where the joint variables must be zero.

    FREE: anywhere.
    FIGURE: where the reference's are zero, which is the configuration that the figure shows.
    """

    FREE = "free"
    FIGURE = "figure"


class DirectionRule(StrEnum):
    """Which way the joint variables must count.

    FREE: either way.
    FIGURE: as the reference's do, which is the way that the figure's arrows show.
    """

    FREE = "free"
    FIGURE = "figure"


@dataclass(frozen=True, kw_only=True, slots=True)
class Tolerance:
    """How far the poses of two tables may be apart, at any configuration, and still count as the same.

    The usual figures are what right angles typed as 1.57 need; `rounding_tolerance` gives those for others.

    Attributes:
        length: largest distance of the two end frames' origins, as a fraction of the robot's size [1].
        angle: largest rotation between the two end frames [rad].
    """

    length: float = 5e-3
    angle: float = 5e-3


@dataclass(frozen=True, kw_only=True)
class Policy:
    """What the submission is held to, beyond being the same mechanism; the defaults are an exercise's."""

    convention: ConventionRule = ConventionRule.ANY
    base: BaseRule = BaseRule.FREE
    tool: ToolRule = ToolRule.AXIS
    zero: ZeroRule = ZeroRule.FREE
    direction: DirectionRule = DirectionRule.FREE
    tolerance: Tolerance = field(default_factory=Tolerance)

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        """Computed once: most of what is known of a key is looked up by a policy as well."""
        return hash(((self.convention, self.base, self.tool, self.zero, self.direction), self.tolerance))
