"""The radii of the workspace: how near and how far a point of the last link can be brought."""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from random import Random
from typing import ClassVar

import numpy as np

from exercises.definition import Exercise, Part
from exercises.errors import DefinitionError
from exercises.figures.points import Points
from exercises.grading import DirectionRule, Feedback, HelpLevel
from exercises.instance import Instance, generate
from exercises.names import in_own_names
from exercises.parts.cells.by_name import ByName, read_by_name
from exercises.parts.context import Context
from exercises.parts.first_values import Start, joint_names
from exercises.parts.forward.joint_limits import (
    JointLimits,
    read_limits,
    told_limits,
    with_one_joint_reversed,
)
from exercises.parts.forward.reach import Reach, reach
from exercises.parts.protocol import Answer, PartType, Reading, RobotFacts
from exercises.parts.report import Credit, PartReport, fact, judged, told_from
from exercises.parts.task import PartTask
from exercises.reading import KeyShape, Reader
from kinematics.cells import AngleUnit, Cell, ParameterKind, read_cell
from kinematics.chain import chain_of_table
from kinematics.errors import CellError, Fault, KinematicsError
from kinematics.expressions import evaluate
from kinematics.se3 import Floats, Vector, inverse_transform, triple
from kinematics.table import JointType

AXIS = "axis"
"""In the place of a point: the radii are measured from the axis of the first joint, square to it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class WorkspacePart(Part):
    """Inner and outer radius of the workspace.

    Attributes:
        point: name of the point of the figure whose workspace is meant.
        origin: name of the point from which the radii are measured, one that no joint moves, or only joint 1
            about itself; None: from the axis of the first joint.
        limits: per joint its lowest and highest value [units of the exercise]; None leaves it unlimited
            (a revolute joint turns fully).
        tolerance: largest error of a radius, as a fraction of the outer radius.
    """

    point: str
    origin: str | None
    limits: JointLimits
    tolerance: float


@dataclass(frozen=True, kw_only=True, slots=True)
class RadiiCells:
    """The radii of a workspace.

    Attributes:
        inner: least distance.
        outer: greatest distance.
    """

    inner: Cell
    outer: Cell


@dataclass(frozen=True, kw_only=True, slots=True)
class WorkspaceTask:
    """Whose workspace is asked for.

    Attributes:
        point: whose workspace is asked for.
        reach_from: from where radii are measured: axis, or a point of the figure.
    """

    point: str
    reach_from: str


def workspace_of(context: Context, part: WorkspacePart) -> Reach:
    """Return the radii of the robot's workspace, in the exercise's unit."""
    table = context.reference_numbers
    points = Points(context.instance.exercise.figure, context.reference.table, context.reference_values)
    to_base, to_last = inverse_transform(points.frames[0]), inverse_transform(points.frames[-1])
    point = to_last[:3, :3] @ points.point(part.point) + to_last[:3, 3]
    if part.origin is not None:
        origin = to_base[:3, :3] @ points.point(part.origin) + to_base[:3, 3]
        axis = None
    else:
        first = chain_of_table(table).axes[0]
        origin, axis = np.array(first.point), np.array(first.direction)
    unit = context.reference.angle_unit
    limits = tuple(
        None if limit is None else _interval(limit, unit if joint_type is JointType.REVOLUTE else None)
        for limit, joint_type in zip(part.limits, table.joint_types, strict=True)
    )
    return reach(table, _rounded(point), _rounded(origin), None if axis is None else _rounded(axis), limits)


def _rounded(vector: Floats) -> Vector:
    return triple(np.round(vector, 12).tolist())


class WorkspacePartType(PartType[WorkspacePart, RadiiCells, ByName[Reach]]):
    """Inner and outer radius of the workspace."""

    kind = "workspace"
    raw: ClassVar = RadiiCells
    meaning = "inner and outer radius"
    given: ClassVar = WorkspaceTask
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "workspace_inner_wrong", "workspace_outer_wrong"),
        **told_from(HelpLevel.KIND, "workspace_swapped", "workspace_other_length_unit"),
        **told_from(HelpLevel.REPAIR, "workspace_diameters"),
    }

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> WorkspacePart:
        """Return the part with its point, limits and tolerance."""
        reader.note("point", KeyShape.POINT)
        reader.note("from", KeyShape.POINT, options=(AXIS,))
        reader.note("limits", KeyShape.RANGES, joint_names(len(robot.joint_types)))
        origin = reader.text("from", AXIS)
        return WorkspacePart(
            kind=self.kind,
            points=points,
            point=reader.text("point"),
            origin=None if origin == AXIS else origin,
            limits=read_limits(reader, len(robot.joint_types), robot.limits),
            tolerance=reader.tolerance("tolerance", 0.01),
        )

    def start(self, robot: RobotFacts) -> Start:
        """Return a point by its usual name."""
        return {"point": "P", "from": AXIS}

    def inconsistencies(self, part: WorkspacePart, exercise: Exercise) -> Iterator[Fault]:
        """Yield the points that the figure does not mark."""
        for key, name in (("point", part.point), ("from", part.origin)):
            if name is not None and name not in exercise.figure.marks:
                yield Fault.at("unknown_point", key, name=name, known=", ".join(exercise.figure.marks))

    def warnings(self, part: WorkspacePart, exercise: Exercise) -> Iterable[str]:
        """Return a code where the radii depend on the sense of a joint with limits, which is free."""
        if exercise.policy.direction is DirectionRule.FIGURE:
            return ()
        nothing = Answer(parts={}, angle_unit=exercise.angle_unit, length_unit=exercise.length_unit)
        usual = Context(instance=generate(exercise), answer=nothing, verdict=None)
        key = workspace_of(usual, part)
        others = (replace(part, limits=one) for one in with_one_joint_reversed(part.limits, exercise))
        off = part.tolerance * key.outer
        for radii in (workspace_of(usual, other) for other in others):
            if abs(radii.inner - key.inner) > off or abs(radii.outer - key.outer) > off:
                return ("limits_ambiguous",)
        return ()

    def task(self, part: WorkspacePart, instance: Instance) -> PartTask:
        """Ask for the least and the greatest distance."""
        ranges, drawn = told_limits(part.limits, instance.exercise)
        values = {
            "point": part.point,
            "origin": part.origin or "",
            "limits": "some" if ranges else "none",
            "ranges": ranges,
            "drawn": drawn,
            "unit": instance.exercise.length_unit.value,
        }
        given = WorkspaceTask(point=part.point, reach_from=part.origin or AXIS)
        measured = AXIS if part.origin is None else "point"
        return PartTask(message=f"task-workspace-{measured}", values=values, given=given)

    def read(self, raw: RadiiCells, reading: Reading) -> ByName[Reach] | None:
        """Return the radii in the student's unit."""
        return read_by_name(raw, reading, self._read, lambda read: (read.inner, read.outer))

    def _read(self, raw: RadiiCells, reading: Reading) -> Reach | None:
        inner, outer = (
            reading.keep(partial(_radius, getattr(raw, name), name, reading)) for name in ("inner", "outer")
        )
        return None if inner is None or outer is None else Reach(inner=inner, outer=outer)

    def grade(self, part: WorkspacePart, answer: ByName[Reach], context: Context) -> PartReport:
        """Judge the radii at the student's lengths and, if they are right there and in names, at others."""
        report = self._judged(part, answer.here, context)
        elsewhere = answer.elsewhere(context) if report.correct else None
        if elsewhere is None:
            return report
        named, there = elsewhere
        exact = replace(part, tolerance=min(part.tolerance, there.policy.tolerance.length))
        # a figure that other lengths spoil says nothing
        with suppress(DefinitionError):
            if not answer.here.inner:  # a least distance of zero is one of these lengths
                named = replace(named, inner=workspace_of(there, exact).inner * there.unit_ratio)
            return self._judged(exact, named, there)
        return report

    def _judged(self, part: WorkspacePart, answer: Reach, context: Context) -> PartReport:
        """Judge the radii: each counts half, but a least distance of zero only beside the greatest."""
        key = workspace_of(context, part)
        scaled = Reach(inner=key.inner * context.unit_ratio, outer=key.outer * context.unit_ratio)
        if abs(answer.outer - key.outer) <= part.tolerance * key.outer:
            scaled = key  # beside a table in another unit, radii may be in the exercise's own
        limit = part.tolerance * scaled.outer
        right = {
            "inner": abs(answer.inner - scaled.inner) <= limit,
            "outer": abs(answer.outer - scaled.outer) <= limit,
        }
        feedback = [Feedback(code=f"workspace_{name}_wrong") for name, fits in right.items() if not fits]
        other = _what_is_off(answer, scaled, context, limit)
        if feedback and other is not None:
            feedback.insert(0, other)
        facts = [fact(fits, name) for name, fits in right.items()]
        told = feedback or [Feedback(code="workspace_right")]
        known_for_nothing = scaled.inner <= limit and not right["outer"]
        score = 0.0 if known_for_nothing else sum(right.values()) / 2
        return judged(part, score, Credit.KEY, facts=facts, feedback=told)

    def right(self, part: WorkspacePart, context: Context) -> RadiiCells:
        """Return the robot's radii: they do not follow from a table."""
        radii, ratio = workspace_of(context, part), context.unit_ratio
        return RadiiCells(inner=radii.inner * ratio, outer=radii.outer * ratio)

    def wrong(self, part: WorkspacePart, context: Context, rng: Random) -> Iterator[tuple[str, RadiiCells]]:
        """Yield diameters, and the radii in each other's place."""
        radii = workspace_of(context, part)
        inner, outer = radii.inner * context.unit_ratio, radii.outer * context.unit_ratio
        yield "workspace_diameters", RadiiCells(inner=2 * inner, outer=2 * outer)
        yield "workspace_swapped", RadiiCells(inner=outer, outer=inner)


def _what_is_off(answer: Reach, key: Reach, context: Context, limit: float) -> Feedback | None:
    def near(inner: float, outer: float, allowed: float) -> bool:
        return abs(answer.inner - inner) <= allowed and abs(answer.outer - outer) <= allowed

    if near(key.outer, key.inner, limit):
        return Feedback(code="workspace_swapped")
    if near(2 * key.inner, 2 * key.outer, 2 * limit):
        return Feedback(code="workspace_diameters")
    for factor in (1000.0, 0.001, 100.0, 0.01, 10.0, 0.1):
        if near(factor * key.inner, factor * key.outer, factor * limit):
            return Feedback(code="workspace_other_length_unit", params={"unit": context.length_unit.value})
    return None


def _interval(limit: tuple[Fraction, Fraction], unit: AngleUnit | None) -> tuple[float, float]:
    low, high = (float(value) if unit is None else unit.in_radians(float(value)) for value in limit)
    return low, high


def _radius(cell: Cell, name: str, reading: Reading) -> float:
    try:
        typed = read_cell(cell, ParameterKind.LENGTH, angle_unit=reading.angle_unit, variable=lambda _: None)
        value = evaluate(in_own_names(typed, reading.instance.exercise, is_constant=True), reading.values)
    except KinematicsError as error:
        raise type(error)(Fault.at(fault.code, name, **fault.params) for fault in error.faults) from None
    if value < 0:
        raise CellError(Fault.at("radius_negative", name))
    return value


PART = WorkspacePartType()
