"""The scene in space: what a specification makes of a reference."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from exercises.errors import DefinitionError
from exercises.figures.points import Points
from exercises.figures.specification import DimensionMark, FigureGripper, FigureSpecification, JointMark
from kinematics.se3 import Vector, cross, norm, position, rejection, scale, subtract, unit, z_axis
from kinematics.table import JointType, SymbolicTable

ON_AXIS = 1e-6
"""How far a body may stand off its axis, and a dimension off its value, relative to the robot's size."""


@dataclass(frozen=True, kw_only=True, slots=True)
class FigureJointAxis:
    """The axis of a joint, as drawn.

    Attributes:
        joint: its number, from 1.
        type: revolute or prismatic.
        point: where the joint's body stands.
        direction: unit vector along the axis; its sense means nothing unless `signed`.
        signed: the sense is that of the positive joint variable, and the figure shows it.
        scale: size of the body relative to the others.
        reach: how far the axis is drawn, relative to the others.
        label_end: the end of the axis at which the number prefers to stand.
    """

    joint: int
    type: JointType
    point: Vector
    direction: Vector
    signed: bool
    scale: float
    reach: float
    label_end: int


@dataclass(frozen=True, kw_only=True, slots=True)
class Dimension:
    """A named length between two points, and where its line prefers to stand."""

    name: str
    start: Vector
    end: Vector
    offset: Vector | None
    distance: float


@dataclass(frozen=True, kw_only=True, slots=True)
class NamedPoint:
    """A point that is marked in the figure."""

    name: str
    at: Vector


@dataclass(frozen=True, kw_only=True, slots=True)
class GroundPlate:
    """Where the robot is fixed."""

    at: Vector
    normal: Vector


@dataclass(frozen=True, kw_only=True, slots=True)
class GripperPose:
    """A gripper: where it ends, where it points to, how its jaws lie (None: as they are seen best)."""

    at: Vector
    direction: Vector
    jaws: Vector | None


@dataclass(frozen=True, kw_only=True, slots=True)
class Scene:
    """A robot in space, in the directions of the figure (z up) and in the exercise's length unit.

    Its size is the diagonal of the box that holds the robot; it is to scale if no length was drawn otherwise.
    """

    axes: tuple[FigureJointAxis, ...]
    links: tuple[tuple[Vector, ...], ...]
    dimensions: tuple[Dimension, ...]
    points: tuple[NamedPoint, ...]
    ground: GroundPlate | None
    gripper: GripperPose | None
    size: float
    to_scale: bool


def build_scene(
    specification: FigureSpecification,
    reference: SymbolicTable,
    parameters: Mapping[str, float],
    *,
    signed_axes: bool,
    drawn: bool,
) -> Scene:
    """Return the scene of a robot at the specification's posture.

    Args:
        specification: points, links, dimensions; what it leaves out follows from the table.
        reference: the table whose geometry is drawn.
        parameters: value of every parameter [length unit of the exercise, or rad].
        signed_axes: show the positive sense of the joint variables (a policy may fix it).
        drawn: use the lengths that the specification draws otherwise than they are.

    Raises:
        DefinitionError: a point is not known, a joint's body is off its axis, a dimension is not the length
            that it names; all faults at once, each with its place in the figure's specification.
    """
    values = {**parameters, **specification.lengths} if drawn else dict(parameters)
    points = Points(specification, reference, values)
    spec = points.specification
    links = tuple(
        tuple(points.point(name, "links", i, k) for k, name in enumerate(chain))
        for i, chain in enumerate(spec.links)
    )
    size = _diagonal([point for chain in links for point in chain])
    scene = Scene(
        axes=tuple(
            _axis(points, joint, mark, size, signed=signed_axes)
            for joint, mark in sorted(spec.joints.items())
        ),
        links=tuple(tuple(scene_vector(point) for point in chain) for chain in links),
        dimensions=tuple(_dimension(points, mark, i, size) for i, mark in enumerate(spec.dimensions)),
        points=tuple(
            NamedPoint(name=name, at=scene_vector(points.point(name, "marks", i)))
            for i, name in enumerate(spec.marks)
        ),
        ground=_ground(points),
        gripper=_gripper(points, spec.gripper) if spec.gripper else None,
        size=size,
        to_scale=values == dict(parameters),
    )
    if points.faults:
        raise DefinitionError(points.faults)
    return scene


def scene_points(scene: Scene) -> Iterator[Vector]:
    """Yield every point that must be visible."""
    for chain in scene.links:
        yield from chain
    for axis in scene.axes:
        yield axis.point
    for point in scene.points:
        yield point.at


def _axis(points: Points, joint: int, mark: JointMark, size: float, *, signed: bool) -> FigureJointAxis:
    pose = points.axis_pose(joint)
    direction = z_axis(pose)
    point = points.point(mark.at, "joints", joint, "at")
    joint_type = points.reference.joint_types[joint - 1]
    distance = norm(cross(subtract(point, position(pose)), direction))
    if joint_type is JointType.REVOLUTE and distance > ON_AXIS * size:
        points.fault("joint_off_axis", ("joints", joint, "at"), joint=joint, point=mark.at)
    sense = points.reference.rows[points.reference.joint_rows[joint - 1]].sign
    return FigureJointAxis(
        joint=joint,
        type=joint_type,
        point=scene_vector(point),
        direction=scene_vector(scale(direction, sense if signed else shown_sense(direction))),
        signed=signed,
        scale=mark.scale,
        reach=mark.reach,
        label_end=mark.label_end,
    )


def _dimension(points: Points, mark: DimensionMark, index: int, size: float) -> Dimension:
    start = points.point(mark.start, "dimensions", index, "from")
    end = points.point(mark.end, "dimensions", index, "to")
    value = abs(points.number(mark.value, "dimensions", index, "value"))
    length = norm(subtract(end, start))
    least = ON_AXIS * size
    if abs(length - value) > least:
        points.fault("dimension_disagrees", ("dimensions", index), name=mark.name, length=length, value=value)
    elif length < least:
        points.fault("dimension_too_short", ("dimensions", index), name=mark.name, length=length, least=least)
    return Dimension(
        name=mark.name,
        start=scene_vector(start),
        end=scene_vector(end),
        offset=mark.offset,
        distance=mark.distance,
    )


def _ground(points: Points) -> GroundPlate | None:
    ground = points.specification.ground
    if ground is None:
        return None
    return GroundPlate(at=scene_vector(points.point(ground.at, "ground", "at")), normal=_unit(ground.normal))


def _gripper(points: Points, gripper: FigureGripper) -> GripperPose | None:
    at = points.point(gripper.at, "gripper", "at")
    origin = points.point(gripper.away_from, "gripper", "away_from")
    if close(at, origin):
        points.fault("gripper_without_direction", ("gripper",))
        return None
    direction = unit(subtract(at, origin))
    if gripper.jaws is None:
        return GripperPose(at=scene_vector(at), direction=scene_vector(direction), jaws=None)
    across = rejection(gripper.jaws, direction)
    if norm(across) < ON_AXIS:
        points.fault("jaws_along_gripper", ("gripper", "jaws"))
        return None
    return GripperPose(at=scene_vector(at), direction=scene_vector(direction), jaws=_unit(across))


def close(a: Vector, b: Vector) -> bool:
    """Return whether two points are one, but for rounding."""
    return all(abs(one - two) <= 1e-8 + 1e-5 * abs(two) for one, two in zip(a, b, strict=True))


def _diagonal(points: list[Vector]) -> float:
    if not points:
        return 1.0
    x, y, z = (max(values) - min(values) for values in zip(*points, strict=True))
    return norm((x, y, z)) or 1.0


def shown_sense(direction: Sequence[float]) -> int:
    """Return the sign in which an axis of no told sense is drawn: its largest component is positive."""
    return 1 if max((_rounded(value, 1e9) for value in direction), key=abs) > 0 else -1


def _unit(vector: Vector) -> Vector:
    return scene_vector(unit(vector))


def scene_vector(vector: Vector) -> Vector:
    """Return a point or a direction for a scene, without what arithmetic leaves in the last digits."""
    x, y, z = vector
    try:
        return round(x * 1e12) / 1e12 + 0.0, round(y * 1e12) / 1e12 + 0.0, round(z * 1e12) / 1e12 + 0.0
    except (OverflowError, ValueError):  # of what is not finite
        return _rounded(x, 1e12) + 0.0, _rounded(y, 1e12) + 0.0, _rounded(z, 1e12) + 0.0


def _rounded(value: float, ones: float) -> float:
    """A number to a power of ten of decimals, as numpy rounds: a scene has too few for its arrays to pay."""
    scaled = value * ones
    return round(scaled) / ones if math.isfinite(scaled) else value
