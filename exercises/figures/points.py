"""The points of a figure: names resolved to places in space, and every fault on the way."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property, lru_cache

from exercises.figures.skeleton import completed, says_all
from exercises.figures.specification import (
    FigureSpecification,
    Point,
    PointAlongAxis,
    PointBeside,
    PointBetween,
    PointInFrame,
    Triple,
)
from kinematics.chain import frames_at
from kinematics.errors import Fault, ParameterError
from kinematics.expressions import Expression, evaluate
from kinematics.poses import transform_from_rpy
from kinematics.se3 import (
    ORIGIN,
    Motion,
    Transform,
    Vector,
    along,
    move,
    plus,
    position,
    subtract,
    to_matrix,
    triple,
    z_axis,
)
from kinematics.table import SymbolicTable, bind


class Points:
    """Resolves the names of a specification at its posture; collects what is wrong with it.

    Attributes:
        specification: completed from the table where it says nothing, or names a point that it does not say.
        reference: the table whose geometry is drawn.
        motions: poses of frame 0 … N of the reference in the figure.
        faults: what was found wrong, each with its place in the figure's specification.
    """

    def __init__(
        self, specification: FigureSpecification, reference: SymbolicTable, values: Mapping[str, float]
    ) -> None:
        self.values = values
        self.faults: list[Fault] = []
        self.reference = reference
        self.motions = frames_in_figure(specification, reference, values)
        self.specification = specification
        self._is_completed = False
        if not says_all(specification, reference):
            self._complete()
        self._resolved: dict[str, Vector] = {}

    @cached_property
    def frames(self) -> list[Transform]:
        """The same poses as (4, 4) arrays."""
        return [to_matrix(frame) for frame in self.motions]

    def axis_pose(self, joint: int) -> Motion:
        """Return the frame whose z axis is the axis of a joint."""
        return self.motions[self.reference.axis_frames[joint - 1]]

    def point(self, name: str, *where: str | int) -> Vector:
        """Return the point of that name; O0, O1, … are the origins of the reference's frames."""
        if name in self._resolved:
            return self._resolved[name]
        self._resolved[name] = ORIGIN  # a circle of names ends here
        is_origin = name[:1] == "O" and name[1:].isdecimal() and int(name[1:]) < len(self.motions)
        if name not in self.specification.points and not is_origin and not self._is_completed:
            self._complete()
        point = self.specification.points.get(name)
        if point is not None:
            value = self._locate(point, "points", name)
        elif is_origin:
            value = position(self.motions[int(name[1:])])
        else:
            origins = (f"O{i}" for i in range(len(self.motions)))
            known = ", ".join([*self.specification.points, *origins])
            self.fault("unknown_point", where, name=name, known=known)
            value = ORIGIN
        self._resolved[name] = value
        return value

    def number(self, expression: Expression, *where: str | int) -> float:
        """Return the value of a length."""
        try:
            return evaluate(expression, self.values)
        except ParameterError as error:
            self.faults.extend(replace(fault, where=where) for fault in error.faults)
            return 0.0

    def fault(self, code: str, where: tuple[str | int, ...], **params: str | float) -> None:
        """Keep a fault."""
        self.faults.append(Fault.at(code, *where, **params))

    def _complete(self) -> None:
        """Add what follows from the table: what is left out, and the usual points."""
        self._is_completed = True
        self.specification = completed(self.specification, self.reference, self.values, self.frames)

    def _locate(self, point: Point, *where: str | int) -> Vector:
        match point:
            case PointInFrame(frame=frame, at=at):
                return self._in_frame(frame, at, *where)
            case PointBetween(start=start, end=end, ratio=ratio):
                a, b = self.point(start, *where, "between", 0), self.point(end, *where, "between", 1)
                return along(a, ratio, subtract(b, a))
            case PointBeside(origin=origin, by=by):
                return plus(self.point(origin, *where, "from"), self._numbers(by, *where, "by"))
            case PointAlongAxis(origin=origin, joint=joint, distance=distance):
                if not 1 <= joint <= self.reference.n_joints:
                    self.fault("unknown_joint", (*where, "joint"), joint=joint, last=self.reference.n_joints)
                    return ORIGIN
                length = self.number(distance, *where, "distance")
                return along(self.point(origin, *where, "from"), length, z_axis(self.axis_pose(joint)))

    def _in_frame(self, frame: int, at: Triple, *where: str | int) -> Vector:
        if not 0 <= frame < len(self.motions):
            self.fault("unknown_frame", (*where, "frame"), last=len(self.motions) - 1)
            return ORIGIN
        return move(self.motions[frame], self._numbers(at, *where, "at"))

    def _numbers(self, entries: Triple, *where: str | int) -> Vector:
        return triple(self.number(entry, *where, i) for i, entry in enumerate(entries))


def frames_in_figure(
    specification: FigureSpecification, reference: SymbolicTable, values: Mapping[str, float]
) -> list[Motion]:
    """Return the poses of frame 0 … N of a reference in the figure, at the figure's posture."""
    posture = posture_in_figure(specification, reference)
    return frames_at(bind(reference, values), posture, _upright(specification.upright))


@lru_cache(maxsize=64)
def _upright(turns: Vector) -> Transform:
    return transform_from_rpy(turns)


def posture_in_figure(specification: FigureSpecification, reference: SymbolicTable) -> tuple[float, ...]:
    """Return the reference's joint values in the figure [rad, or the exercise's length unit]."""
    return specification.posture or (0.0,) * reference.n_joints
