"""⁰T_N in numbers, at given values of the joint variables.

Where a table's variables are zero and which way they count is the student's choice (unless the policy fixes
both), so the pose is the one of the student's own table. It earns its points if it follows from that table,
right or wrong.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from random import Random
from typing import ClassVar, TypeAlias

import numpy as np

from exercises.definition import Exercise, Part
from exercises.draws import Draw, Picker
from exercises.grading import BaseRule, DirectionRule, Feedback, HelpLevel, Policy, ToolRule, ZeroRule
from exercises.instance import Instance
from exercises.parts.cells.comparison import (
    agreeing,
    cell_facts,
    halves_right,
    has_last_row,
    transposed_cells,
    transposed_rotation,
)
from exercises.parts.cells.matrix_cells import CellMatrix, read_numbers
from exercises.parts.cells.number_cells import on_paper
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.context import Context
from exercises.parts.first_values import Start, usual_joints
from exercises.parts.following import ENOUGH
from exercises.parts.forward.transform import transform_is_robot
from exercises.parts.joint_draws import JointDraws, in_radians, read_joints, told_units
from exercises.parts.protocol import TABLE, PartType, Reading, RobotFacts
from exercises.parts.report import Credit, PartReport, judged, told_from
from exercises.parts.task import PartTask
from exercises.reading import Reader
from kinematics.equivalence import Tolerance
from kinematics.errors import Fault, ParameterError
from kinematics.forward import forward_kinematics
from kinematics.se3 import Floats, inverse_transform
from kinematics.table import JointType

USUAL_TURNS = Draw(start=Fraction(-120), stop=Fraction(120), step=Fraction(15), without=(Fraction(0),))
"""From where the angles of a numeric pose are drawn, in degrees."""

ScoredPose: TypeAlias = tuple[float, Floats, Floats, Credit]
"""What an answer earns beside a pose, the answer in its unit, the pose, and on what the points rest."""


def policy_fixes_pose(policy: Policy) -> bool:
    """Return whether every table that keeps the policy gives the same pose at the same joint values."""
    return (
        policy.zero is ZeroRule.FIGURE
        and policy.direction is DirectionRule.FIGURE
        and policy.base is BaseRule.FRAME
        and policy.tool is ToolRule.FRAME
    )


@dataclass(frozen=True, kw_only=True, slots=True)
class PosePart(Part):
    """⁰T_N in numbers.

    Attributes:
        tolerance: largest error of a position as a fraction of the robot's size, and of a direction cosine.
    """

    joints: JointDraws
    tolerance: float


@dataclass(frozen=True, kw_only=True, slots=True)
class PoseTask:
    """At which joint values a pose is asked for.

    Attributes:
        joints: joint values of the numeric pose, in the exercise's units.
    """

    joints: tuple[float, ...]


class PosePartType(PartType[PosePart, CellMatrix, Floats]):
    """⁰T_N in numbers, at given joint values."""

    kind = "pose"
    raw: ClassVar = CellMatrix
    meaning = "⁰T_N in numbers, at the exercise's joint values"
    given: ClassVar = PoseTask
    follows_table = True
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "pose_last_row", "pose_rotation_right", "pose_position_right"),
        **told_from(HelpLevel.REPAIR, "pose_inverse", "pose_rotation_transposed", "pose_degrees_as_radians"),
    }

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> PosePart:
        """Return the part with its joint values and from where students' own are drawn."""
        usual = USUAL_TURNS if robot.degrees else None
        joints = read_joints(reader, robot, single=False, usual_turns=usual)
        tolerance = reader.tolerance("tolerance", 0.005)
        return PosePart(kind=self.kind, points=points, joints=joints, tolerance=tolerance)

    def start(self, robot: RobotFacts) -> Start:
        """Return joint values to begin with."""
        return {"joints": usual_joints(robot)}

    def inconsistencies(self, part: PosePart, exercise: Exercise) -> Iterator[Fault]:
        """Yield a fault where nothing says whose pose it is."""
        asked = exercise.part(TABLE) is not None or exercise.part("transform") is not None
        if not asked and not policy_fixes_pose(exercise.policy):
            yield Fault.at("pose_without_table", "kind")

    def draw(self, part: PosePart, exercise: Exercise, picker: Picker) -> tuple[Fraction, ...]:
        """Return the student's joint values [the exercise's units]."""
        return part.joints.drawn(picker, self.kind)

    def task(self, part: PosePart, instance: Instance) -> PartTask:
        """Ask for the pose at the student's joint values."""
        found = instance.exercise
        drawn: tuple[Fraction, ...] = instance.drawn[self.kind]
        units = (unit if unit == "°" else f" {unit}" for unit in told_units(found))
        joints = zip(drawn, units, strict=True)
        text = ", ".join(f"q{i} = {float(value):g}{unit}" for i, (value, unit) in enumerate(joints, 1))
        return PartTask(
            message="task-pose",
            values={"joints": text, "unit": found.length_unit.value},
            given=PoseTask(joints=tuple(float(value) for value in drawn)),
        )

    def read(self, raw: CellMatrix, reading: Reading) -> Floats | None:
        """Return (4, 4) numbers, lengths in the student's unit."""
        fixed = policy_fixes_pose(reading.instance.exercise.policy)
        if not fixed and reading.raw.get(TABLE) is None and reading.raw.get("transform") is None:
            reading.fault("pose_needs_table")
        return read_numbers(raw, reading)

    def grade(self, part: PosePart, answer: Floats, context: Context) -> PartReport:
        """Judge a pose: its rotation and its position count half each."""
        joints = joints_at(context, context.instance.drawn[self.kind])
        allowed = Tolerance(length=part.tolerance, angle=part.tolerance)
        ways = (
            (_score(given, pose, context.size, allowed), given, pose, credit)
            for pose, credit in _expected(context, joints, context.answer.get("transform"))
            for given in _in_either_unit(context, answer)
        )
        score, answer, pose, credit = _first_best(ways, (0.0, answer, np.full((4, 4), np.nan), Credit.NONE))
        cells = agreeing(answer[None], pose[None], context.size, allowed)
        feedback = _feedback(context, answer, pose, score, credit, joints, allowed)
        return judged(part, score, credit, facts=cell_facts(cells), feedback=feedback)

    def right(self, part: PosePart, context: Context) -> CellMatrix:
        """Return the pose of the student's own table, rounded as on paper."""
        joints = joints_at(context, context.instance.drawn[self.kind])
        pose = context.own_poses(context.values(context.own_names()), joints).transform
        rounded: CellMatrix = on_paper(pose).tolist()
        return rounded

    def wrong(self, part: PosePart, context: Context, rng: Random) -> Iterator[tuple[str, CellMatrix]]:
        """Yield the pose with its rotation transposed, and with another position."""
        right = self.right(part, context)
        turned = transposed_cells(right)
        apart = 0.0 if turned is None else np.abs(np.array(turned, float) - np.array(right, float)).max()
        if turned is not None and apart > 2 * part.tolerance:
            yield "pose_rotation_transposed", turned
        moved = [list(row) for row in right]
        moved[0][3] = float(moved[0][3]) + context.size
        yield "pose_wrong", moved


def joints_at(context: Context, drawn: Sequence[Fraction]) -> list[float]:
    """Return joint values of the exercise in [rad] and in the student's length unit."""
    exercise = context.instance.exercise
    return [
        value * context.unit_ratio if kind is JointType.PRISMATIC else value
        for value, kind in zip(in_radians(exercise, drawn), exercise.reference.table.joint_types, strict=True)
    ]


def _score(given: Floats, pose: Floats, size: float, allowed: Tolerance) -> float:
    return halves_right(agreeing(given[None], pose[None], size, allowed), pose[None], size, allowed)


def _in_either_unit(context: Context, answer: Floats) -> Iterator[Floats]:
    """The pose in the unit of the student's table; it may have been given in the exercise's."""
    yield answer
    if context.unit_ratio != 1.0:
        converted = answer.copy()
        converted[:3, 3] *= context.unit_ratio
        yield converted


def _first_best(ways: Iterator[ScoredPose], otherwise: ScoredPose) -> ScoredPose:
    """The first way with the highest score; those after a perfect one are not looked at, for they cost."""
    best = None
    for way in ways:
        if best is None or way[0] > best[0]:
            best = way
        if best[0] == 1.0:
            break
    return best or otherwise


def _expected(
    context: Context, joints: Sequence[float], transform: SymbolicMatrix | None
) -> Iterator[tuple[Floats, Credit]]:
    """The poses that earn points, and what the points rest on then."""
    if policy_fixes_pose(context.policy):
        q = in_radians(context.instance.exercise, context.instance.drawn[PosePartType.kind])
        pose = forward_kinematics(context.reference_numbers, q).transform.copy()
        pose[:3, 3] *= context.unit_ratio
        yield pose, Credit.KEY
    if context.own is not None and len(context.own.table.joint_types) == len(joints):
        credit = Credit.KEY if context.own_correct else Credit.OWN_TABLE
        with suppress(ParameterError):
            yield context.own_poses(context.values(context.own_names()), joints).transform, credit
    if transform is not None and len(context.joint_types) == len(joints):
        if transform_is_robot(context, transform):
            yield transform.at(context.values(transform.names()), joints), Credit.KEY
        elif context.own is None and _moves(transform, context, joints):
            yield transform.at(context.values(transform.names()), joints), Credit.OWN_TABLE


def _moves(transform: SymbolicMatrix, context: Context, joints: Sequence[float]) -> bool:
    """Whether ⁰T_N depends on half of the joints at least: that it was evaluated rightly says little else."""
    values = context.values(transform.names())
    here = transform.at(values, joints)
    others = ([*joints[:i], joint + 1.0, *joints[i + 1 :]] for i, joint in enumerate(joints))
    moving = sum(not np.array_equal(transform.at(values, other), here) for other in others)
    return moving >= ENOUGH * len(joints)


def _feedback(
    context: Context,
    answer: Floats,
    pose: Floats,
    score: float,
    credit: Credit,
    joints: Sequence[float],
    allowed: Tolerance,
) -> Iterator[Feedback]:
    if score == 1.0:
        yield Feedback(code="pose_right" if credit is Credit.KEY else "pose_follows_table")
        return

    def looks_like(other: Floats) -> bool:
        return bool(agreeing(answer[None], other[None], context.size, allowed).all())

    yield Feedback(code="pose_wrong")
    if not has_last_row(answer):
        yield Feedback(code="pose_last_row")
    if score:
        rotation = agreeing(answer[None], pose[None], context.size, allowed)[:3, :3].all()
        yield Feedback(code="pose_rotation_right" if rotation else "pose_position_right")
    if looks_like(inverse_transform(pose)):
        yield Feedback(code="pose_inverse")
    elif looks_like(transposed_rotation(pose)):
        yield Feedback(code="pose_rotation_transposed")
    elif context.own is not None and _degrees_as_radians(context, joints, looks_like):
        yield Feedback(code="pose_degrees_as_radians")


def _degrees_as_radians(
    context: Context, joints: Sequence[float], looks_like: Callable[[Floats], bool]
) -> bool:
    """Whether the sines and cosines were taken of the degrees as if they were radians."""
    assert context.own is not None
    types = context.own.table.joint_types
    if len(types) != len(joints):
        return False
    q = [math.degrees(v) if t is JointType.REVOLUTE else v for v, t in zip(joints, types, strict=True)]
    try:
        pose = context.own_poses(context.values(context.own_names()), q).transform
    except ParameterError:
        return False
    return looks_like(pose)


PART = PosePartType()
