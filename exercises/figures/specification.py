"""What a definition says of its figure."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TypeAlias

from kinematics.expressions import Expression

Triple: TypeAlias = tuple[Expression, Expression, Expression]


@dataclass(frozen=True, kw_only=True, slots=True)
class PointInFrame:
    """A point with coordinates `at` in frame `frame` of the reference, 0 being the base frame."""

    frame: int
    at: Triple


@dataclass(frozen=True, kw_only=True, slots=True)
class PointBetween:
    """The point start + ratio·(end − start)."""

    start: str
    end: str
    ratio: float


@dataclass(frozen=True, kw_only=True, slots=True)
class PointBeside:
    """A point displaced from another one by a vector in the directions of the figure (z points up)."""

    origin: str
    by: Triple


@dataclass(frozen=True, kw_only=True, slots=True)
class PointAlongAxis:
    """A point displaced from another one along the axis of a joint, positive as the reference has it."""

    origin: str
    joint: int
    distance: Expression


Point: TypeAlias = PointInFrame | PointBetween | PointBeside | PointAlongAxis


@dataclass(frozen=True, kw_only=True, slots=True)
class JointMark:
    """Where the body of a joint is drawn.

    Attributes:
        at: name of a point on the joint's axis.
        scale: size of the body relative to the others.
        reach: how far the axis is drawn to either side, relative to the others.
        label_end: the end of the axis at which the joint's number prefers to stand: +1, -1 or 0 (either).
    """

    at: str
    scale: float = 1.0
    reach: float = 1.0
    label_end: int = 0


@dataclass(frozen=True, kw_only=True, slots=True)
class DimensionMark:
    """A dimension of the figure.

    Attributes:
        name: as a student would write it, such as L1.
        value: the length that the two points must lie apart [length unit of the exercise].
        start: name of the first point.
        end: name of the second point.
        offset: direction in which the dimension line is moved off its points, or None to choose one.
        distance: how far it is moved, relative to the usual distance.
    """

    name: str
    value: Expression
    start: str
    end: str
    offset: tuple[float, float, float] | None = None
    distance: float = 1.0


@dataclass(frozen=True, kw_only=True, slots=True)
class Ground:
    """Where the robot is fixed: a point and the direction away from the ground."""

    at: str
    normal: tuple[float, float, float] = (0.0, 0.0, 1.0)


@dataclass(frozen=True, kw_only=True, slots=True)
class FigureGripper:
    """A gripper drawn at a point, opening away from another, its jaws beside each other along `jaws`."""

    at: str
    away_from: str
    jaws: tuple[float, float, float] | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class View:
    """From where the robot is seen, in parallel projection [rad].

    Attributes:
        azimuth: direction of the eye in the horizontal plane, from the figure's x axis towards y.
        elevation: height of the eye above the horizontal plane.
    """

    azimuth: float
    elevation: float


@dataclass(frozen=True, kw_only=True, slots=True)
class FigureSpecification:
    """Everything that a definition says of its figure; what is left out follows from the DH table.

    Attributes:
        posture: values of the reference's joint variables at which the robot is drawn [rad or length unit].
        view: from where it is seen.
        upright: roll, pitch, yaw of the reference's frame 0 in the figure [rad]; the figure's z is up.
        lengths: lengths that are drawn otherwise than they are, so that small ones can be seen.
        points: named points.
        joints: where each joint's body stands.
        links: chains of names of points, drawn as thick lines.
        marks: names of the points that are marked and named in the figure.
        ground: where the robot is fixed.
        gripper: the gripper, if one is drawn.
        width: width of the paper; names are 18 high.
    """

    posture: tuple[float, ...] = ()
    view: View = View(azimuth=-1.05, elevation=0.44)
    upright: tuple[float, float, float] = (0.0, 0.0, 0.0)
    lengths: Mapping[str, float] = field(default_factory=dict)
    points: Mapping[str, Point] = field(default_factory=dict)
    joints: Mapping[int, JointMark] = field(default_factory=dict)
    links: tuple[tuple[str, ...], ...] = ()
    dimensions: tuple[DimensionMark, ...] = ()
    marks: tuple[str, ...] = ()
    ground: Ground | None = None
    gripper: FigureGripper | None = None
    width: float = 480.0
