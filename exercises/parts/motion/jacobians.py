"""A Jacobian in numbers, and the joint torques and forces for a wrench.

Beside a table they are those of the student's own table, at the joint values of its own variables, and earn
their points if they follow from it; alone they are those of the key, which is then given. Lengths are in the
exercise's unit, as the task says; those of an answer beside a table in another unit may be in that one.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from exercises.definition import Exercise
from exercises.draws import Picker
from exercises.instance import Instance
from exercises.parts.cells.number_cells import on_paper, read_numbers_of
from exercises.parts.context import Context
from exercises.parts.first_values import Start, usual_joints
from exercises.parts.forward.value import scaled_chain
from exercises.parts.given_table import given_table
from exercises.parts.joint_draws import JointDraws, in_radians, joint_labels, key_numbers, read_joints
from exercises.parts.motion.jacobian_cells import (
    JacobianAsk,
    JacobianCells,
    JacobianScore,
    JacobianTerms,
    JacobianType,
    Scoring,
    answer_fields,
    forces_score,
    is_well_shaped,
    load_labels,
    matrix_score,
    read_terms,
    told_question,
)
from exercises.parts.protocol import TABLE, Reading, RobotFacts
from exercises.parts.task import GivenNumbers, PartTask
from exercises.reading import KeyShape, Reader
from kinematics.answers.jacobian_answers import jacobian_at, joint_forces_at, judge_forces, judge_jacobian
from kinematics.answers.jacobian_verdicts import JacobianMistake, JacobianVerdict
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.cells import Cell, parameters_in_radians
from kinematics.cells.meaning import Position
from kinematics.chain import Chain, chain_of_table
from kinematics.errors import Fault, JointValueError
from kinematics.joint_values import wrong_length
from kinematics.keys import ValueKind
from kinematics.se3 import Floats
from kinematics.table import bind

CONFIGURATIONS = 4
"""Configurations in which rates of the angles are looked for: not all of them are singular by chance."""


@dataclass(frozen=True, kw_only=True, eq=False)
class JacobianNumbers:
    """A Jacobian and joint forces in numbers, linear rows first."""

    jacobian: Floats | None
    forces: tuple[float, ...] | None


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianPart(JacobianTerms):
    """A Jacobian, joint forces, or both, in numbers.

    Attributes:
        joints: of the configuration.
        wrench: force and moment that the tool exerts.
    """

    joints: JointDraws
    wrench: tuple[float, ...]


class JacobianPartType(JacobianType[JacobianPart, JacobianNumbers]):
    """Jacobian and statics."""

    kind = "jacobian"
    meaning = "the Jacobian in numbers, and the joint torques and forces for a wrench"

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> JacobianPart:
        """Return the part with its joint values and what is asked."""
        joints = read_joints(reader, robot)
        terms = read_terms(reader, KeyShape.NUMBERS)
        wrench = reader.exacts("wrench", (0, 0, 0, 0, 0, 0))
        if len(wrench) != 6:
            reader.mistyped(ValueKind.NUMBERS, "wrench", count=6)
        elif JacobianAsk.FORCES in terms["ask"] and not any(wrench):
            reader.fault("wrench_missing", "wrench")
        return JacobianPart(
            kind=self.kind,
            points=points,
            joints=joints,
            wrench=tuple(float(value) for value in wrench),
            **terms,
        )

    def inconsistencies(self, part: JacobianPart, exercise: Exercise) -> Iterator[Fault]:
        """Yield a fault where the angles have rates in no configuration."""
        if part.angles is None:
            return
        key = exercise.reference
        values = parameters_in_radians(exercise.usual_values, key.parameters, key.angle_unit)
        chain = chain_of_table(bind(key.table, values))
        for k in range(CONFIGURATIONS):
            with suppress(JointValueError):
                joints = [0.7 + 1.3 * k + 0.9 * i for i in range(len(chain.axes))]
                jacobian_at(chain, joints, part.frame, part.angles)
                return
        yield Fault.at("angles_locked", "axes", axes=part.angles.axes)

    def start(self, robot: RobotFacts) -> Start:
        """Return joint values to begin with."""
        return {"joints": usual_joints(robot)}

    def draw(self, part: JacobianPart, exercise: Exercise, picker: Picker) -> tuple[Fraction, ...]:
        """Return the student's joint values [the exercise's units]."""
        return part.joints.drawn(picker, self.kind)

    def task(self, part: JacobianPart, instance: Instance) -> PartTask:
        """Show the configuration, the wrench, and the key if no table is asked."""
        exercise = instance.exercise
        labels = joint_labels(exercise)
        drawn: tuple[Fraction, ...] = instance.drawn[self.kind]
        values = tuple(float(value) for value in drawn)
        numbers = [GivenNumbers(name="configuration", labels=labels, rows=(values,))]
        if exercise.part(TABLE) is None:
            numbers.insert(0, given_table(instance))
        if JacobianAsk.FORCES in part.ask:
            numbers.append(GivenNumbers(name="wrench", labels=load_labels(exercise), rows=(part.wrench,)))
        return PartTask(
            message="task-jacobian" if part.angles is None else "task-jacobian-analytic",
            values={
                **told_question(part, own=exercise.part(TABLE) is not None),
                "unit": exercise.length_unit.value,
            },
            form=answer_fields(part.ask, exercise),
            numbers=tuple(numbers),
        )

    def read(self, raw: JacobianCells, reading: Reading) -> JacobianNumbers | None:
        """Return the matrix, linear rows first, and the forces."""
        if not is_well_shaped(self.kind, raw, reading):
            return None
        rows = [
            read_numbers_of(row, Position.LENGTH, reading, "jacobian", i)
            for i, row in enumerate(raw.jacobian or ())
        ]
        forces = None
        if raw.forces is not None:
            forces = read_numbers_of(raw.forces, Position.LENGTH, reading, "forces")
        if reading.faults:
            return None
        jacobian = None
        if rows and raw.order is not None:
            jacobian = np.array(raw.order.linear_first(rows), dtype=np.float64)
        return JacobianNumbers(jacobian=jacobian, forces=forces)

    def scoring(self, part: JacobianPart, answer: JacobianNumbers, context: Context) -> Scoring:
        """Return how an answer is scored at the joint values of the question."""
        chain, joints = _arm(part, context)
        per_joint = np.array([1.0 if axis.prismatic else 1.0 / context.unit_ratio for axis in chain.axes])

        def judge_matrix(jacobian: Floats) -> JacobianVerdict:
            readings = _readings(jacobian, np.vstack([per_joint] * 3 + [np.ones_like(per_joint)] * 3))
            found = (
                judge_jacobian(chain, joints, reading, part.frame, part.tolerance, part.angles)
                for reading in readings
            )
            return max(found, key=lambda verdict: verdict.share)

        def judge_statics(forces: Sequence[float]) -> tuple[Sequence[bool], JacobianMistake | None]:
            found = (
                judge_forces(chain, joints, part.wrench, reading.tolist(), part.frame, part.tolerance)
                for reading in _readings(np.array(forces), per_joint)
            )
            return max(found, key=lambda verdict: sum(verdict[0]))

        def scored(question: JacobianAsk) -> JacobianScore:
            if question is JacobianAsk.JACOBIAN:
                return matrix_score(answer.jacobian, judge_matrix)
            return forces_score(answer.forces, [0.0] * len(joints), judge_statics)

        return scored

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
            rows = on_paper(jacobian_at(chain, joints, part.frame, part.angles))
            cells = tuple(tuple(row) for row in rows.tolist())
            written = replace(written, order=ScrewOrder.LINEAR_FIRST, jacobian=cells)
        if JacobianAsk.FORCES in part.ask:
            forces = joint_forces_at(chain, joints, part.wrench, part.frame)
            written = replace(written, forces=tuple(on_paper(forces).tolist()))
        return written

    def opposite(self, forces: tuple[Cell, ...]) -> tuple[Cell, ...] | None:
        """Return the forces of the other sign; None where all of them are about zero."""
        values = [float(value) for value in forces]
        return tuple(-value for value in values) if any(abs(value) > 1.0 for value in values) else None


def _arm(part: JacobianPart, context: Context) -> tuple[Chain, Sequence[float]]:
    """Return the arm that the answer is about, and its configuration: the student's own, or the key.

    Lengths are in the exercise's unit.
    """
    drawn: tuple[Fraction, ...] = context.instance.drawn[part.kind]
    joints = in_radians(context.instance.exercise, drawn)
    if context.instance.exercise.part(TABLE) is None or context.own is None:
        return chain_of_table(key_numbers(context.instance)), joints
    table = bind(context.own.table, context.values(context.own_names()))
    return scaled_chain(chain_of_table(table), 1.0 / context.unit_ratio), joints


def _readings(entries: Floats, factors: Floats) -> tuple[Floats, ...]:
    """Return entries as they stand and, if that differs, with their lengths taken from the table's unit."""
    return (entries,) if (factors == 1.0).all() else (entries, entries * factors)


PART = JacobianPartType()
