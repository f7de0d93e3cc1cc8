"""A Jacobian in closed form, and the joint forces that hold a wrench, as functions of the joint variables.

Beside a table they are those of the student's own table, in its own joint variables, and earn their marks if
they follow from it; alone they are those of the key, which is then given.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import ClassVar

import numpy as np

from exercises.definition import Exercise, Part
from exercises.grading import Feedback, Finding
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.definition_keys import TOLERANCE, DefinitionKey, KeyShape, choice, choices, sequence_keys
from exercises.parts.given_table import given_table
from exercises.parts.jacobians import (
    DISCLOSURES,
    JacobianAsk,
    JacobianCells,
    read_angles,
    told_angles,
)
from exercises.parts.matrix_cells import read_row, write_matrix
from exercises.parts.protocol import (
    TABLE,
    FieldShape,
    FormField,
    GivenNumbers,
    PartTask,
    PartType,
    Reading,
    RobotFacts,
)
from exercises.parts.report import Credit, Fact, PartReport, judged
from exercises.reading import Reader
from kinematics.answers.jacobian_forms import (
    FormRobot,
    force_form,
    jacobian_form,
    judge_force_form,
    judge_jacobian_form,
)
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.cells import ParameterKind, ReadTable
from kinematics.errors import Fault, JointValueError
from kinematics.expressions import Expression, Number, Parameter, parameters_in
from kinematics.jacobian import JacobianFrame
from kinematics.keys import ValueKind
from kinematics.rotations.sequences import EulerSequence

LOADS = ("fx", "fy", "fz", "mx", "my", "mz")
"""What the components of a force and a moment may be called instead of having a value."""


@dataclass(frozen=True, kw_only=True, eq=False)
class JacobianForm:
    """A Jacobian and joint forces as functions, linear rows first."""

    jacobian: tuple[tuple[Expression, ...], ...] | None
    forces: tuple[Expression, ...] | None


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianFormPart(Part):
    """A Jacobian, joint forces, or both, in closed form.

    Attributes:
        frame: in whose axes.
        angles: whose rates the analytic Jacobian gives; None for the geometric one.
        ask: what is asked.
        wrench: force and moment on the tool, each component a number or its own name.
        tolerance: of an entry that is not proved; where it is a length, as a share of the robot's size.
    """

    frame: JacobianFrame
    angles: EulerSequence | None
    ask: tuple[JacobianAsk, ...]
    wrench: tuple[Expression, ...]
    tolerance: float


class JacobianFormType(PartType[JacobianFormPart, JacobianCells, JacobianForm]):
    """Jacobian and statics in closed form."""

    kind = "jacobian_form"
    raw: ClassVar = JacobianCells
    meaning = "the Jacobian and the joint forces that hold a wrench, as functions of the joint variables"
    follows_table = True
    disclosures: ClassVar = DISCLOSURES

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> JacobianFormPart:
        """Return the part with what is asked."""
        asked = reader.choices("ask", JacobianAsk, (JacobianAsk.JACOBIAN.value,))
        angles = read_angles(reader)
        wrench: list[Expression] = []
        load = reader.values.get("wrench") if reader.given("wrench") else None
        for i, entry in enumerate(load if isinstance(load, list) else ()):
            if isinstance(entry, str) and entry in LOADS:
                wrench.append(Parameter(entry))
            elif isinstance(entry, int | float) and not isinstance(entry, bool) and math.isfinite(entry):
                wrench.append(Number(Fraction(repr(entry))))
            else:
                reader.fault("exercise_value_unknown", "wrench", i, key="wrench", known=", ".join(LOADS))
        if JacobianAsk.FORCES in asked and len(wrench) != 6:
            reader.mistyped(ValueKind.NUMBERS, "wrench", count=6)
        elif JacobianAsk.FORCES in asked and wrench == [Number(Fraction(0))] * 6:
            reader.fault("wrench_missing", "wrench")
        return JacobianFormPart(
            kind=self.kind,
            points=points,
            frame=reader.choice("frame", JacobianFrame, JacobianFrame.BASE),
            angles=angles,
            ask=asked,
            wrench=tuple(wrench),
            tolerance=reader.number("tolerance", 0.005),
        )

    def keys(self, robot: RobotFacts) -> tuple[DefinitionKey, ...]:
        """Return the keys of what is asked, the angles and the load."""
        return (
            choices("ask", JacobianAsk),
            choice("frame", JacobianFrame),
            *sequence_keys("axes", "turning"),
            DefinitionKey(name="wrench", shape=KeyShape.CELLS, labels=LOADS),
            TOLERANCE,
        )

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
        names = tuple(f"q{i}" for i in range(1, exercise.reference.table.n_joints + 1))
        numbers = [] if own else [given_table(instance)]
        form: list[FormField] = []
        if JacobianAsk.JACOBIAN in part.ask:
            orders = tuple(order.value for order in ScrewOrder)
            form.append(FormField(name="order", shape=FieldShape.CHOICE, options=orders))
            form.append(FormField(name="jacobian", shape=FieldShape.MATRIX, labels=names, rows=6))
        if JacobianAsk.FORCES in part.ask:
            load = tuple(
                float(entry.value) if isinstance(entry, Number) else entry.name
                for entry in part.wrench
                if isinstance(entry, Number | Parameter)
            )
            numbers.append(GivenNumbers(name="wrench", labels=LOADS, rows=(load,)))
            form.append(FormField(name="forces", shape=FieldShape.VECTOR, labels=names))
        return PartTask(
            message="task-jacobian-form" if part.angles is None else "task-jacobian-form-analytic",
            values={
                **told_angles(part.angles),
                "frame": part.frame.value,
                "ask": "both" if len(part.ask) > 1 else part.ask[0].value,
                "variables": "own" if own else "given",
            },
            form=tuple(form),
            numbers=tuple(numbers),
        )

    def read(self, raw: JacobianCells, reading: Reading) -> JacobianForm | None:
        """Return the functions, linear rows first."""
        before = len(reading.faults)
        n = len(reading.joint_types)
        rows = list(raw.jacobian or ())
        for i, row in enumerate(rows):
            if len(row) != n:
                params = {"expected": n, "given": len(row)}
                reading.fault("joint_row_length", self.kind, "jacobian", i, **params)
        if raw.forces is not None and len(raw.forces) != n:
            params = {"expected": n, "given": len(raw.forces)}
            reading.fault("joint_row_length", self.kind, "forces", **params)
        if raw.jacobian is not None and raw.order is None:
            reading.fault("row_order_missing", self.kind, "order")
        if raw.jacobian is None and raw.forces is None:
            reading.fault("jacobian_empty", self.kind)
        if len(reading.faults) > before:
            return None
        read = [read_row(row, reading, self.kind, "jacobian", i) for i, row in enumerate(rows)]
        forces = None
        if raw.forces is not None:
            forces = read_row(raw.forces, reading, self.kind, "forces", names=LOADS)
        if len(reading.faults) > before:
            return None
        jacobian = tuple(row for row in read if row is not None)
        if raw.order is ScrewOrder.ANGULAR_FIRST:
            jacobian = (*jacobian[3:], *jacobian[:3])
        return JacobianForm(jacobian=jacobian or None, forces=forces)

    def grade(self, part: JacobianFormPart, answer: JacobianForm, context: Context) -> PartReport:
        """Judge column by column, and force by force; what is asked counts the same."""
        with_table = context.instance.exercise.part(TABLE) is not None
        n = context.reference.table.n_joints
        if with_table and (context.own is None or context.own.table.n_joints != n):
            return judged(part, 0.0, Credit.NONE, feedback=(Feedback(code="jacobian_needs_table"),))
        robot = _robot(context, answer)
        facts: list[Fact] = []
        feedback: list[Feedback] = []
        total = 0.0
        for question in part.ask:
            judge = _jacobian if question is JacobianAsk.JACOBIAN else _forces
            share, found, told = judge(part, answer, robot)
            total += share
            facts += found
            feedback += told
        score = total / len(part.ask)
        credit = context.own_credit if with_table else Credit.KEY
        if score == 1.0:
            code = "jacobian_right" if credit is Credit.KEY else "jacobian_follows_table"
            feedback.append(Feedback(code=code))
        return judged(part, score, credit, facts=facts, feedback=feedback)

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
            written = replace(written, forces=tuple(write_matrix((forces,), n, (*names, *LOADS))[0]))
        return written

    def wrong(
        self, part: JacobianFormPart, context: Context, rng: Random
    ) -> Iterator[tuple[str, JacobianCells]]:
        """Yield the matrix with its halves exchanged but not so called, and forces of the wrong sign."""
        right = self.right(part, context)
        if right.jacobian is not None:
            yield "jacobian_wrong", replace(right, order=ScrewOrder.ANGULAR_FIRST)
        if right.forces is not None:
            yield "forces_wrong", replace(right, forces=tuple(f"-({cell})" for cell in right.forces))


def _table(context: Context) -> ReadTable:
    """Return the table that the answer is about: the student's own where one is asked, else the key."""
    asked = context.instance.exercise.part(TABLE) is not None
    return context.own if asked and context.own is not None else context.reference


def _robot(context: Context, answer: JacobianForm) -> FormRobot:
    """Return the robot that the answer is about, with a value for every name."""
    read = _table(context)
    entries = [entry for row in answer.jacobian or () for entry in row] + list(answer.forces or ())
    names = frozenset[str](read.parameters).union(*map(parameters_in, entries))
    values = context.values(names - set(LOADS))
    kinds = {**context.reference.parameters, **read.parameters}
    lengths = {name for name in values if kinds.get(name, ParameterKind.LENGTH) is ParameterKind.LENGTH}
    loads = {name: 7.0 + 3.0 * i for i, name in enumerate(LOADS)}
    return FormRobot(
        table=read.table, values={**loads, **values}, lengths=frozenset(lengths) | set(LOADS[3:])
    )


def _jacobian(
    part: JacobianFormPart, answer: JacobianForm, robot: FormRobot
) -> tuple[float, list[Fact], list[Feedback]]:
    if answer.jacobian is None:
        missing = Feedback(code="jacobian_missing", params={"what": "jacobian"})
        return 0.0, [Fact(where=("jacobian",), finding=Finding.MISSING)], [missing]
    try:
        found = judge_jacobian_form(robot, answer.jacobian, part.frame, part.tolerance, part.angles)
    except JointValueError:
        return 0.0, [], [Feedback(code="jacobian_angles_locked")]
    if found.right:
        return 1.0, [], []
    wrong = np.argwhere(~found.entries).tolist()
    facts = [Fact(where=("jacobian", r, c), finding=Finding.WRONG) for r, c in wrong]
    told = [Feedback(code="jacobian_wrong")]
    told += [
        Feedback(code=f"jacobian_{mistake.value}", params={"joint": joint or 0})
        for mistake, joint in found.mistakes
    ]
    return min(found.share, 0.8), facts, told


def _forces(
    part: JacobianFormPart, answer: JacobianForm, robot: FormRobot
) -> tuple[float, list[Fact], list[Feedback]]:
    if answer.forces is None:
        missing = Feedback(code="jacobian_missing", params={"what": "forces"})
        return 0.0, [Fact(where=("forces",), finding=Finding.MISSING)], [missing]
    right, _, mistake = judge_force_form(robot, answer.forces, part.wrench, part.frame, part.tolerance)
    if all(right):
        return 1.0, [], []
    facts = [Fact(where=("forces", i), finding=Finding.WRONG) for i, good in enumerate(right) if not good]
    told = [Feedback(code="forces_wrong")]
    if mistake is not None:
        told.append(Feedback(code=f"forces_{mistake.value}"))
    return min(sum(right) / len(right), 0.8), facts, told


PART = JacobianFormType()
