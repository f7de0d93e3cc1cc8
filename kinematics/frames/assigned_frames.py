"""Frames that the procedure assigns: the rule that placed each, what was free, and the table they make."""

from dataclasses import dataclass
from enum import StrEnum

from kinematics.errors import Fault
from kinematics.frames.normals import Relation
from kinematics.se3 import Transform, Vector
from kinematics.table import NumericTable


class Rule(StrEnum):
    """The rule by which a frame was placed.

    FIRST, LAST: chosen so that parameters vanish. GIVEN: the caller's own frame 0 or N.
    SKEW … COINCIDENT: by the common normal of the two axes. PRISMATIC: by a normal that depends on where the
    line of a prismatic joint was drawn.
    """

    FIRST = "first"
    LAST = "last"
    GIVEN = "given"
    SKEW = "skew"
    INTERSECTING = "intersecting"
    PARALLEL = "parallel"
    ANTIPARALLEL = "antiparallel"
    COINCIDENT = "coincident"
    PRISMATIC = "prismatic"


class Freedom(StrEnum):
    """What the rules left free at a frame; each choice leaves fewest parameters different from zero.

    FRAME: frame 0 may stand anywhere its convention allows; it is put on frame 1 at zero (standard: on axis 1
    where d_1 and θ_1 vanish). ORIGIN: the origin may slide along the axis; put where d vanishes.
    X_SIGN: x may point either way across two intersecting axes; turned so that θ vanishes, or the twist is
    positive. X_DIRECTION: x may point anywhere across the axis; put along the x before it. LINE: the line of
    a prismatic joint may be drawn anywhere; drawn through the neighbouring origin.
    """

    FRAME = "frame"
    ORIGIN = "origin"
    X_SIGN = "x_sign"
    X_DIRECTION = "x_direction"
    LINE = "line"


@dataclass(frozen=True, kw_only=True, slots=True)
class AssignedFrame:
    """One frame at the robot's zero position, in the coordinates of the axes.

    Attributes:
        x: direction of x.
        y: direction of y.
        z: direction of z.
        rule: the rule that placed it.
        relation: how the two axes lie that it belongs to; None at the first and the last frame.
    """

    origin: Vector
    x: Vector
    y: Vector
    z: Vector
    rule: Rule
    relation: Relation | None
    free: tuple[Freedom, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class FrameAssignment:
    """A DH table with the frames that it came from.

    Attributes:
        table: the table; at q = 0 its frames are `frames`.
        base: (4, 4) pose of frame 0 in the coordinates of the axes.
        tool: (4, 4) pose of the given tool in frame N; the identity if none was given.
        frames: frame 0 … N.
        warnings: near-parallel axes, and a given frame that the convention cannot take as frame 0 or N.
    """

    table: NumericTable
    base: Transform
    tool: Transform
    frames: tuple[AssignedFrame, ...]
    warnings: tuple[Fault, ...]
