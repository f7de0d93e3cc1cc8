"""A Jacobian in numbers, and the joint forces that hold a wrench.

Beside a table they are those of the student's own table, at the joint values of its own variables, and earn
their marks if they follow from it; alone they are those of the key, which is then given.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from fractions import Fraction
from random import Random
from typing import Annotated, ClassVar

import numpy as np

from exercises.definition import Exercise, Part
from exercises.draws import Draw, Picker
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.definition_keys import (
    COMPONENTS,
    TOLERANCE,
    DefinitionKey,
    KeyShape,
    Start,
    choice,
    choices,
    joint_keys,
    sequence_keys,
    usual_joints,
)
from exercises.parts.drawn_orientations import read_sequence
from exercises.parts.given_table import given_table
from exercises.parts.joint_draws import drawn_joints, in_radians, key_numbers, read_joints
from exercises.parts.number_cells import read_numbers_of
from exercises.parts.pose import joints_at
from exercises.parts.protocol import (
    TABLE,
    FieldShape,
    FormField,
    GivenNumbers,
    Length,
    PartTask,
    PartType,
    Reading,
    RobotFacts,
)
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, judged
from exercises.reading import Reader
from kinematics.answers.jacobian_answers import (
    JacobianMistake,
    jacobian_at,
    joint_forces_at,
    judge_forces,
    judge_jacobian,
)
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.cells import AngleUnit, Cell
from kinematics.cells.meaning import Position
from kinematics.chain import Chain, chain_of_table
from kinematics.errors import JointValueError
from kinematics.jacobian import JacobianFrame
from kinematics.joint_values import wrong_length
from kinematics.keys import ValueKind
from kinematics.rotations.sequences import EulerSequence
from kinematics.se3 import Floats
from kinematics.table import JointType, bind

DECIMALS = 4
JointRow = Annotated[tuple[Cell, ...], Length(least=1, most=64)]
SixRows = Annotated[tuple[JointRow, ...], Length(least=6, most=6)]


OF_FORCES = (
    JacobianMistake.SIGN,
    JacobianMistake.OTHER_FRAME,
    JacobianMistake.ROWS_EXCHANGED,
    JacobianMistake.SPATIAL,
)
"""What wrong joint forces may look like."""
DISCLOSURES = {
    "jacobian_wrong": Disclosure(level=HelpLevel.ROW),
    "forces_wrong": Disclosure(level=HelpLevel.ROW),
    **{
        f"jacobian_{mistake.value}": Disclosure(level=HelpLevel.REPAIR)
        for mistake in JacobianMistake
        if mistake is not JacobianMistake.SIGN
    },
    **{f"forces_{mistake.value}": Disclosure(level=HelpLevel.REPAIR) for mistake in OF_FORCES},
}
"""Help at which each word on a Jacobian, in numbers or in closed form, is said."""


class JacobianAsk(StrEnum):
    """What is asked."""

    JACOBIAN = "jacobian"
    FORCES = "forces"


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianCells:
    """A Jacobian and joint forces.

    Attributes:
        order: which rows stand first: linear_first (v, ω) or angular_first (ω, v); needed beside a Jacobian.
        jacobian: 6×n, row by row; per radian.
        forces: one for each joint: torque of a revolute one, force of a prismatic one.
    """

    order: ScrewOrder | None = None
    jacobian: SixRows | None = None
    forces: JointRow | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class JacobianNumbers:
    """The same in numbers, linear rows first."""

    jacobian: Floats | None
    forces: tuple[float, ...] | None


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianPart(Part):
    """A Jacobian, joint forces, or both.

    Attributes:
        joints: the joint values where no seed is given [the exercise's units].
        draws: per joint, from where a student's own value is drawn, or None.
        frame: in whose axes.
        angles: whose rates the analytic Jacobian gives; None for the geometric one.
        ask: what is asked.
        wrench: force and moment on the tool.
        tolerance: of an entry; where it is a length, as a share of the robot's size.
    """

    joints: tuple[Fraction, ...]
    draws: tuple[Draw | None, ...]
    frame: JacobianFrame
    angles: EulerSequence | None
    ask: tuple[JacobianAsk, ...]
    wrench: tuple[float, ...]
    tolerance: float


class JacobianPartType(PartType[JacobianPart, JacobianCells, JacobianNumbers]):
    """Jacobian and statics."""

    kind = "jacobian"
    raw: ClassVar = JacobianCells
    meaning = "the Jacobian in numbers, and the joint forces that hold a wrench"
    follows_table = True
    disclosures: ClassVar = DISCLOSURES

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> JacobianPart:
        """Return the part with its joint values and what is asked."""
        joints, draws = read_joints(reader, robot)
        asked = reader.choices("ask", JacobianAsk, (JacobianAsk.JACOBIAN.value,))
        wrench = reader.exacts("wrench", (0, 0, 0, 0, 0, 0))
        forces = JacobianAsk.FORCES in asked
        if len(wrench) != 6:
            reader.mistyped(ValueKind.NUMBERS, "wrench", count=6)
        elif forces and not any(wrench):
            reader.fault("wrench_missing", "wrench")
        return JacobianPart(
            kind=self.kind,
            points=points,
            joints=joints,
            draws=draws,
            frame=reader.choice("frame", JacobianFrame, JacobianFrame.BASE),
            angles=read_angles(reader),
            ask=asked,
            wrench=tuple(float(value) for value in wrench),
            tolerance=reader.number("tolerance", 0.005),
        )

    def keys(self, robot: RobotFacts) -> tuple[DefinitionKey, ...]:
        """Return the keys of the joint values, of what is asked, and of the angles."""
        return (
            *joint_keys(robot),
            choices("ask", JacobianAsk),
            choice("frame", JacobianFrame),
            *sequence_keys("axes", "turning"),
            DefinitionKey(name="wrench", shape=KeyShape.NUMBERS, labels=COMPONENTS),
            TOLERANCE,
        )

    def start(self, robot: RobotFacts) -> Start:
        """Return joint values to begin with."""
        return {"joints": usual_joints(robot)}

    def draw(self, part: JacobianPart, exercise: Exercise, picker: Picker) -> tuple[Fraction, ...]:
        """Return the student's joint values [the exercise's units]."""
        return drawn_joints(part.joints, part.draws, picker, self.kind)

    def task(self, part: JacobianPart, instance: Instance) -> PartTask:
        """Show the configuration, the wrench, and the key if no table is asked."""
        exercise = instance.exercise
        types = exercise.reference.table.joint_types
        unit = "°" if exercise.angle_unit is AngleUnit.DEG else "rad"
        names = tuple(f"q{i}" for i in range(1, len(types) + 1))
        labels = tuple(
            f"{name} [{exercise.length_unit.value if kind is JointType.PRISMATIC else unit}]"
            for name, kind in zip(names, types, strict=True)
        )
        drawn: tuple[Fraction, ...] = instance.drawn[self.kind]
        values = tuple(float(value) for value in drawn)
        numbers = [GivenNumbers(name="configuration", labels=labels, rows=(values,))]
        if exercise.part(TABLE) is None:
            numbers.insert(0, given_table(instance))
        form: list[FormField] = []
        if JacobianAsk.JACOBIAN in part.ask:
            orders = tuple(order.value for order in ScrewOrder)
            form.append(FormField(name="order", shape=FieldShape.CHOICE, options=orders))
            form.append(FormField(name="jacobian", shape=FieldShape.MATRIX, labels=names, rows=6))
        if JacobianAsk.FORCES in part.ask:
            shown = ("fx", "fy", "fz", "mx", "my", "mz")
            numbers.append(GivenNumbers(name="wrench", labels=shown, rows=(part.wrench,)))
            form.append(FormField(name="forces", shape=FieldShape.VECTOR, labels=names))
        return PartTask(
            message="task-jacobian" if part.angles is None else "task-jacobian-analytic",
            values={
                **told_angles(part.angles),
                "frame": part.frame.value,
                "ask": "both" if len(part.ask) > 1 else part.ask[0].value,
                "variables": "given" if exercise.part(TABLE) is None else "own",
                "unit": exercise.length_unit.value,
            },
            form=tuple(form),
            numbers=tuple(numbers),
        )

    def read(self, raw: JacobianCells, reading: Reading) -> JacobianNumbers | None:
        """Return the matrix, linear rows first, and the forces."""
        before = len(reading.faults)
        n = len(reading.joint_types)
        rows: list[tuple[float, ...] | None] = []
        for i, row in enumerate(raw.jacobian or ()):
            if len(row) != n:
                params = {"expected": n, "given": len(row)}
                reading.fault("joint_row_length", self.kind, "jacobian", i, **params)
            else:
                rows.append(read_numbers_of(row, Position.LENGTH, reading, self.kind, "jacobian", i))
        if raw.jacobian is not None and raw.order is None:
            reading.fault("row_order_missing", self.kind, "order")
        forces = None
        if raw.forces is not None and len(raw.forces) != n:
            params = {"expected": n, "given": len(raw.forces)}
            reading.fault("joint_row_length", self.kind, "forces", **params)
        elif raw.forces is not None:
            forces = read_numbers_of(raw.forces, Position.LENGTH, reading, self.kind, "forces")
        if raw.jacobian is None and raw.forces is None:
            reading.fault("jacobian_empty", self.kind)
        if len(reading.faults) > before:
            return None
        jacobian = np.array(rows, dtype=np.float64) if rows else None
        if jacobian is not None and raw.order is ScrewOrder.ANGULAR_FIRST:
            jacobian = np.vstack([jacobian[3:], jacobian[:3]])
        return JacobianNumbers(jacobian=jacobian, forces=forces)

    def grade(self, part: JacobianPart, answer: JacobianNumbers, context: Context) -> PartReport:
        """Judge column by column, and force by force; what is asked counts the same."""
        chain, joints = _arm(part, context)
        with_table = context.instance.exercise.part(TABLE) is not None
        if with_table and (context.own is None or len(chain.axes) != len(joints)):
            return judged(part, 0.0, Credit.NONE, feedback=(Feedback(code="jacobian_needs_table"),))
        facts: list[Fact] = []
        feedback: list[Feedback] = []
        total = 0.0
        for question in part.ask:
            if question is JacobianAsk.JACOBIAN:
                share, found, told = _jacobian(part, answer, chain, joints)
            else:
                share, found, told = _forces(part, answer, chain, joints)
            total += share
            facts += found
            feedback += told
        score = total / len(part.ask)
        credit = context.own_credit if with_table else Credit.KEY
        if score == 1.0:
            code = "jacobian_right" if credit is Credit.KEY else "jacobian_follows_table"
            feedback.append(Feedback(code=code))
        return judged(part, score, credit, facts=facts, feedback=feedback)

    def right(self, part: JacobianPart, context: Context) -> JacobianCells:
        """Return what follows from the student's own table, or from the key, rounded as on paper.

        Raises:
            JointValueError: the student's own table has not as many joints as there are values.
        """
        chain, joints = _arm(part, context)
        if len(chain.axes) != len(joints):
            raise wrong_length(len(chain.axes), len(joints))
        written = JacobianCells()
        if JacobianAsk.JACOBIAN in part.ask:
            rows = np.round(jacobian_at(chain, joints, part.frame, part.angles), DECIMALS) + 0.0
            cells = tuple(tuple(row) for row in rows.tolist())
            written = replace(written, order=ScrewOrder.LINEAR_FIRST, jacobian=cells)
        if JacobianAsk.FORCES in part.ask:
            forces = joint_forces_at(chain, joints, part.wrench, part.frame)
            written = replace(written, forces=tuple((np.round(forces, DECIMALS) + 0.0).tolist()))
        return written

    def wrong(self, part: JacobianPart, context: Context, rng: Random) -> Iterator[tuple[str, JacobianCells]]:
        """Yield the matrix with its halves exchanged but not so called, and forces of the wrong sign."""
        right = self.right(part, context)
        if right.jacobian is not None:
            yield "jacobian_wrong", replace(right, order=ScrewOrder.ANGULAR_FIRST)
        if right.forces is not None and any(abs(float(value)) > 1.0 for value in right.forces):
            yield "forces_wrong", replace(right, forces=tuple(-float(value) for value in right.forces))


def read_angles(reader: Reader) -> EulerSequence | None:
    """Return the sequence of an analytic Jacobian, from `axes` and `turning`; None if no axes are named."""
    if not reader.given("axes"):
        return None
    return read_sequence(reader, "axes", "turning", EulerSequence(axes="ZYX"))


def told_angles(angles: EulerSequence | None) -> dict[str, str]:
    """Return what a task says of the angles."""
    if angles is None:
        return {}
    return {"axes": " ".join(angles.axes), "turning": angles.turning.value}


def _arm(part: JacobianPart, context: Context) -> tuple[Chain, Sequence[float]]:
    """Return the arm that the answer is about, and its configuration: the student's own, or the key."""
    drawn: tuple[Fraction, ...] = context.instance.drawn[part.kind]
    if context.instance.exercise.part(TABLE) is None or context.own is None:
        return chain_of_table(key_numbers(context.instance)), in_radians(context.instance.exercise, drawn)
    table = bind(context.own.table, context.values(context.own_names()))
    return chain_of_table(table), joints_at(context, drawn)


def _jacobian(
    part: JacobianPart, answer: JacobianNumbers, chain: Chain, joints: Sequence[float]
) -> tuple[float, list[Fact], list[Feedback]]:
    if answer.jacobian is None:
        missing = Feedback(code="jacobian_missing", params={"what": "jacobian"})
        return 0.0, [Fact(where=("jacobian",), finding=Finding.MISSING)], [missing]
    try:
        found = judge_jacobian(chain, joints, answer.jacobian, part.frame, part.tolerance, part.angles)
    except JointValueError:
        return 0.0, [], [Feedback(code="jacobian_angles_locked")]
    wrong = np.argwhere(~found.entries).tolist()
    facts = [Fact(where=("jacobian", r, c), finding=Finding.WRONG) for r, c in wrong]
    told = [] if found.right else [Feedback(code="jacobian_wrong")]
    told += [
        Feedback(code=f"jacobian_{mistake.value}", params={"joint": joint or 0})
        for mistake, joint in found.mistakes
    ]
    return (1.0 if found.right else min(found.share, 0.8)), facts, told


def _forces(
    part: JacobianPart, answer: JacobianNumbers, chain: Chain, joints: Sequence[float]
) -> tuple[float, list[Fact], list[Feedback]]:
    if answer.forces is None:
        missing = Feedback(code="jacobian_missing", params={"what": "forces"})
        return 0.0, [Fact(where=("forces",), finding=Finding.MISSING)], [missing]
    right, mistake = judge_forces(chain, joints, part.wrench, answer.forces, part.frame, part.tolerance)
    facts = [Fact(where=("forces", i), finding=Finding.WRONG) for i, good in enumerate(right) if not good]
    if all(right):
        return 1.0, facts, []
    told = [Feedback(code="forces_wrong")]
    if mistake is not None:
        told.append(Feedback(code=f"forces_{mistake.value}"))
    return min(sum(right) / len(right), 0.8), facts, told


PART = JacobianPartType()
