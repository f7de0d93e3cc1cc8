"""A Jacobian in numbers, and the joint forces that hold a wrench.

Beside a table they are those of the student's own table, at the joint values of its own variables, and earn
their marks if they follow from it; alone they are those of the key, which is then given.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import ClassVar

import numpy as np

from exercises.definition import Exercise
from exercises.draws import Draw, Picker
from exercises.instance import Instance
from exercises.parts.cells.number_cells import read_numbers_of
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
    joint_names,
    sequence_keys,
    usual_joints,
)
from exercises.parts.forward.pose import joints_at
from exercises.parts.given_table import given_table
from exercises.parts.joint_draws import (
    drawn_joints,
    in_radians,
    joint_labels,
    key_numbers,
    read_joints,
)
from exercises.parts.motion.jacobian_cells import (
    DISCLOSURES,
    JacobianAsk,
    JacobianCells,
    JacobianMark,
    JacobianTerms,
    angles_locked,
    answer_fields,
    forces_mark,
    is_well_shaped,
    matrix_mark,
    missing,
    needs_table,
    read_angles,
    report,
    told_question,
)
from exercises.parts.protocol import TABLE, GivenNumbers, PartTask, PartType, Reading, RobotFacts
from exercises.parts.report import PartReport
from exercises.reading import Reader
from kinematics.answers.jacobian_answers import (
    jacobian_at,
    joint_forces_at,
    judge_forces,
    judge_jacobian,
)
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.cells.meaning import Position
from kinematics.chain import Chain, chain_of_table
from kinematics.errors import JointValueError
from kinematics.jacobian import JacobianFrame
from kinematics.joint_values import wrong_length
from kinematics.keys import ValueKind
from kinematics.se3 import Floats
from kinematics.table import bind

DECIMALS = 4


@dataclass(frozen=True, kw_only=True, eq=False)
class JacobianNumbers:
    """The same in numbers, linear rows first."""

    jacobian: Floats | None
    forces: tuple[float, ...] | None


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianPart(JacobianTerms):
    """A Jacobian, joint forces, or both, in numbers.

    Attributes:
        joints: the joint values where no seed is given [the exercise's units].
        draws: per joint, from where a student's own value is drawn, or None.
        wrench: force and moment on the tool.
    """

    joints: tuple[Fraction, ...]
    draws: tuple[Draw | None, ...]
    wrench: tuple[float, ...]


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
        names = joint_names(exercise.reference.table.n_joints)
        labels = joint_labels(exercise)
        drawn: tuple[Fraction, ...] = instance.drawn[self.kind]
        values = tuple(float(value) for value in drawn)
        numbers = [GivenNumbers(name="configuration", labels=labels, rows=(values,))]
        if exercise.part(TABLE) is None:
            numbers.insert(0, given_table(instance))
        if JacobianAsk.FORCES in part.ask:
            numbers.append(GivenNumbers(name="wrench", labels=COMPONENTS, rows=(part.wrench,)))
        return PartTask(
            message="task-jacobian" if part.angles is None else "task-jacobian-analytic",
            values={
                **told_question(part, own=exercise.part(TABLE) is not None),
                "unit": exercise.length_unit.value,
            },
            form=answer_fields(part.ask, names),
            numbers=tuple(numbers),
        )

    def read(self, raw: JacobianCells, reading: Reading) -> JacobianNumbers | None:
        """Return the matrix, linear rows first, and the forces."""
        if not is_well_shaped(raw, reading, self.kind):
            return None
        before = len(reading.faults)
        rows = [
            read_numbers_of(row, Position.LENGTH, reading, self.kind, "jacobian", i)
            for i, row in enumerate(raw.jacobian or ())
        ]
        forces = None
        if raw.forces is not None:
            forces = read_numbers_of(raw.forces, Position.LENGTH, reading, self.kind, "forces")
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
            return needs_table(part)

        def mark(question: JacobianAsk) -> JacobianMark:
            if question is JacobianAsk.JACOBIAN:
                return _matrix(part, answer, chain, joints)
            return _forces(part, answer, chain, joints)

        return report(part, context, mark)

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


def _arm(part: JacobianPart, context: Context) -> tuple[Chain, Sequence[float]]:
    """Return the arm that the answer is about, and its configuration: the student's own, or the key."""
    drawn: tuple[Fraction, ...] = context.instance.drawn[part.kind]
    if context.instance.exercise.part(TABLE) is None or context.own is None:
        return chain_of_table(key_numbers(context.instance)), in_radians(context.instance.exercise, drawn)
    table = bind(context.own.table, context.values(context.own_names()))
    return chain_of_table(table), joints_at(context, drawn)


def _matrix(
    part: JacobianPart, answer: JacobianNumbers, chain: Chain, joints: Sequence[float]
) -> JacobianMark:
    if answer.jacobian is None:
        return missing(JacobianAsk.JACOBIAN)
    try:
        found = judge_jacobian(chain, joints, answer.jacobian, part.frame, part.tolerance, part.angles)
    except JointValueError:
        return angles_locked()
    return matrix_mark(found)


def _forces(
    part: JacobianPart, answer: JacobianNumbers, chain: Chain, joints: Sequence[float]
) -> JacobianMark:
    if answer.forces is None:
        return missing(JacobianAsk.FORCES)
    right, mistake = judge_forces(chain, joints, part.wrench, answer.forces, part.frame, part.tolerance)
    zeros = [0.0] * len(joints)
    nothing, _ = judge_forces(chain, joints, part.wrench, zeros, part.frame, part.tolerance)
    return forces_mark(right, mistake, nothing)


PART = JacobianPartType()
