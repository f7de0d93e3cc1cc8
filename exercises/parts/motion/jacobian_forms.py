"""A Jacobian in closed form, and the joint forces for a wrench, as functions of the joint variables.

Beside a table they are those of the student's own table, in its own joint variables, and earn their points if
they follow from it; alone they are those of the key, which is then given.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import chain as in_turn

from exercises.definition import Exercise
from exercises.instance import Instance
from exercises.parts.cells.matrix_cells import read_row, roundings_in, write_matrix
from exercises.parts.context import Context
from exercises.parts.given_table import given_table
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
from kinematics.answers.form_samples import COMPONENTS, FormRobot, loaded_robot
from kinematics.answers.jacobian_forms import force_form, jacobian_form, judge_force_form, judge_jacobian_form
from kinematics.answers.jacobian_verdicts import JacobianMistake, JacobianVerdict
from kinematics.answers.left_open import Rounded
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.cells import Cell, ReadTable
from kinematics.errors import Fault, JointValueError
from kinematics.expressions import ZERO, Expression, Number, Parameter, parameters_in
from kinematics.keys import ValueKind
from kinematics.symbolic import Matrix


@dataclass(frozen=True, kw_only=True, eq=False)
class JacobianForm:
    """A Jacobian and joint forces as functions, linear rows first.

    Attributes:
        jacobian: (6, n).
        forces: n, one for each joint.
        rounded: of entries with names and decimals.
    """

    jacobian: tuple[tuple[Expression, ...], ...] | None
    forces: tuple[Expression, ...] | None
    rounded: Rounded = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianFormPart(JacobianTerms):
    """A Jacobian, joint forces, or both, in closed form.

    Attributes:
        wrench: force and moment that the tool exerts, each component a number or its own name.
    """

    wrench: tuple[Expression, ...]


class JacobianFormType(JacobianType[JacobianFormPart, JacobianForm]):
    """Jacobian and statics in closed form."""

    kind = "jacobian_form"
    meaning = "the Jacobian, and torques and forces for a wrench, as functions of the joint variables"

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> JacobianFormPart:
        """Return the part with what is asked."""
        terms = read_terms(reader, KeyShape.CELLS)
        forces = JacobianAsk.FORCES in terms["ask"]
        wrench: list[Expression] = []
        load = reader.values.get("wrench") if reader.given("wrench") else None
        for i, entry in enumerate(load if isinstance(load, list) else ()):
            if isinstance(entry, str) and entry in COMPONENTS:
                wrench.append(Parameter(entry))
            elif isinstance(entry, int | float) and not isinstance(entry, bool) and math.isfinite(entry):
                wrench.append(Number(Fraction(repr(entry))))
            else:
                reader.fault("exercise_value_unknown", "wrench", i, key="wrench", known=", ".join(COMPONENTS))
        if forces and len(wrench) != 6:
            reader.mistyped(ValueKind.NUMBERS, "wrench", count=6)
        elif forces and wrench == [Number(Fraction(0))] * 6:
            reader.fault("wrench_missing", "wrench")
        return JacobianFormPart(kind=self.kind, points=points, wrench=tuple(wrench), **terms)

    def inconsistencies(self, part: JacobianFormPart, exercise: Exercise) -> Iterator[Fault]:
        """Yield a fault where the angles have rates in no configuration."""
        try:
            jacobian_form(exercise.reference.table, part.frame, part.angles)
        except JointValueError as error:
            yield from (replace(fault, where=("axes",)) for fault in error.faults)

    def task(self, part: JacobianFormPart, instance: Instance) -> PartTask:
        """Show the wrench, and the key if no table is asked."""
        exercise = instance.exercise
        own = exercise.part(TABLE) is not None
        numbers = [] if own else [given_table(instance)]
        if JacobianAsk.FORCES in part.ask:
            load = tuple(
                float(entry.value) if isinstance(entry, Number) else entry.name
                for entry in part.wrench
                if isinstance(entry, Number | Parameter)
            )
            numbers.append(GivenNumbers(name="wrench", labels=load_labels(exercise), rows=(load,)))
        return PartTask(
            message="task-jacobian-form" if part.angles is None else "task-jacobian-form-analytic",
            values=told_question(part, own=own),
            form=answer_fields(part.ask, exercise),
            numbers=tuple(numbers),
        )

    def read(self, raw: JacobianCells, reading: Reading) -> JacobianForm | None:
        """Return the functions, linear rows first."""
        if not is_well_shaped(self.kind, raw, reading):
            return None
        read = [read_row(row, reading, "jacobian", i) for i, row in enumerate(raw.jacobian or ())]
        forces = None
        if raw.forces is not None:
            forces = read_row(raw.forces, reading, "forces", names=COMPONENTS)
        if reading.faults:
            return None
        jacobian = tuple(row for row in read if row is not None)
        typed = in_turn.from_iterable((*(raw.jacobian or ()), raw.forces or ()))
        meant = in_turn.from_iterable((*jacobian, forces or ()))
        rounded = roundings_in(zip(typed, meant, strict=True), reading, COMPONENTS, COMPONENTS)
        if raw.order is not None:
            jacobian = raw.order.linear_first(jacobian)
        return JacobianForm(jacobian=jacobian or None, forces=forces, rounded=rounded)

    def scoring(self, part: JacobianFormPart, answer: JacobianForm, context: Context) -> Scoring:
        """Return how an answer is scored as functions of the joint variables."""
        robot = _robot(context, answer)

        def judge_matrix(jacobian: Matrix) -> JacobianVerdict:
            return judge_jacobian_form(
                robot, jacobian, part.frame, part.tolerance, part.angles, answer.rounded
            )

        def judge_statics(forces: Sequence[Expression]) -> tuple[Sequence[bool], JacobianMistake | None]:
            right, _, mistake = judge_force_form(
                robot, forces, part.wrench, part.frame, part.tolerance, answer.rounded
            )
            return right, mistake

        def scored(question: JacobianAsk) -> JacobianScore:
            if question is JacobianAsk.JACOBIAN:
                return matrix_score(answer.jacobian, judge_matrix)
            return forces_score(answer.forces, [ZERO] * robot.table.n_joints, judge_statics)

        return scored

    def right(self, part: JacobianFormPart, context: Context) -> JacobianCells:
        """Return what follows from the student's own table, or from the key."""
        read = _table(context)
        n, names = read.table.n_joints, tuple(read.parameters)
        written = JacobianCells()
        if JacobianAsk.JACOBIAN in part.ask:
            rows = jacobian_form(read.table, part.frame, part.angles)
            cells = tuple(tuple(row) for row in write_matrix(rows, n, names))
            written = replace(written, order=ScrewOrder.LINEAR_FIRST, jacobian=cells)
        if JacobianAsk.FORCES in part.ask:
            forces = force_form(read.table, part.wrench, part.frame)
            written = replace(written, forces=tuple(write_matrix((forces,), n, (*names, *COMPONENTS))[0]))
        return written

    def opposite(self, forces: tuple[Cell, ...]) -> tuple[Cell, ...]:
        """Return the forces of the other sign."""
        return tuple(f"-({cell})" for cell in forces)


def _table(context: Context) -> ReadTable:
    """Return the table that the answer is about: the student's own where one is asked, else the key."""
    asked = context.instance.exercise.part(TABLE) is not None
    return context.own if asked and context.own is not None else context.reference


def _robot(context: Context, answer: JacobianForm) -> FormRobot:
    """Return the robot that the answer is about, with a value for every name."""
    read = _table(context)
    entries = [entry for row in answer.jacobian or () for entry in row] + list(answer.forces or ())
    names = frozenset[str](read.parameters).union(*map(parameters_in, entries))
    values = context.values(names - set(COMPONENTS))
    return loaded_robot(read.table, values, {**context.reference.parameters, **read.parameters})


PART = JacobianFormType()
