"""The equations of motion of a robot whose links have weights: M(q), C(q, q̇) and g(q) as functions.

The robot's table is given, with names and values for what its links weigh. Every C with the right C q̇ is
right; whether Ṁ − 2C is skew-symmetric is asked for separately (`kinematics.answers.dynamics_answers`).
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from random import Random
from typing import ClassVar

from exercises.definition import DrawnParameter, Exercise, Part
from exercises.draws import Picker
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.instance import Instance, generate
from exercises.parts.cells.matrix_cells import write_matrix
from exercises.parts.context import Context
from exercises.parts.first_values import Start, joint_names
from exercises.parts.given_table import given_table
from exercises.parts.motion.motion_cells import MotionAsk, MotionCells, read_motion
from exercises.parts.motion.weighed_links import (
    given_links,
    read_links,
    read_three,
    read_weights,
    units_of_names,
)
from exercises.parts.protocol import PartType, Reading, RobotFacts
from exercises.parts.report import Credit, Fact, PartReport, fact, judged, share_earned, told_from
from exercises.parts.task import FieldShape, FormField, GivenNumbers, PartTask
from exercises.reading import Reader
from kinematics.answers.dynamics_answers import judge_dynamics
from kinematics.answers.dynamics_verdicts import (
    DynamicsMistake,
    DynamicsQuestion,
    DynamicsVerdict,
    EquationsAnswer,
)
from kinematics.cells import Cell, LengthUnit, ReadTable
from kinematics.dynamics import rate_name
from kinematics.dynamics.equations import Derivation
from kinematics.dynamics.reading import RawBody, ReadBodies, read_bodies
from kinematics.errors import Fault, KinematicsError
from kinematics.expressions import ZERO, evaluate
from kinematics.poses import transform_from_rpy
from kinematics.symbolic import Matrix
from kinematics.table import JointType

MOST_OF_WRONG = 0.8
"""Of a matrix with a wrong entry no more than this is earned, however many entries are right."""
DOWN = 0.999  # Cosine of how far from the vertical gravity may point in the figure: 2.6°.


@dataclass(frozen=True, kw_only=True, slots=True)
class MotionPart(Part):
    """Equations of motion.

    Attributes:
        links: one for each row of the table; lengths in the exercise's unit.
        gravity: acceleration of free fall in frame 0.
        weights: the names in these that the table does not hold, and their values.
        tolerance: of an entry that is not proved.
    """

    ask: tuple[MotionAsk, ...]
    links: tuple[RawBody, ...]
    gravity: tuple[Cell, ...]
    weights: tuple[DrawnParameter, ...]
    tolerance: float


class MotionType(PartType[MotionPart, MotionCells, EquationsAnswer]):
    """M, C and g as functions."""

    kind = "equations_of_motion"
    raw: ClassVar = MotionCells
    meaning = (
        "the mass matrix, Coriolis and gravity terms as functions of the joint variables and their rates"
    )
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, *(f"motion_{question.value}_wrong" for question in MotionAsk)),
        **told_from(HelpLevel.REPAIR, *(f"motion_{mistake.value}" for mistake in DynamicsMistake)),
    }

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> MotionPart:
        """Return the part with what is asked and what the links weigh."""
        return MotionPart(
            kind=self.kind,
            points=points,
            ask=reader.choices("ask", MotionAsk, ("mass", "coriolis", "gravity")),
            links=read_links(reader),
            gravity=read_three(reader, "gravity"),
            weights=read_weights(reader),
            tolerance=reader.tolerance("tolerance", 0.005),
        )

    def start(self, robot: RobotFacts) -> Start:
        """Return a mass and a moment of inertia about z for each joint, in names, under gravity."""
        numbers = range(1, len(robot.joint_types) + 1)
        masses, moments = {f"m{i}": {"value": 1} for i in numbers}, {f"I{i}": {"value": 0.1} for i in numbers}
        moved = ({"mass": m, "moments": [0, 0, j]} for m, j in zip(masses, moments, strict=True))
        return {
            "links": [{"mass": 0} if kind is JointType.FIXED else next(moved) for kind in robot.row_types],
            "gravity": [0, 0, "-g"],
            "weights": {**masses, **moments, "g": {"value": 9.81}},
        }

    def inconsistencies(self, part: MotionPart, exercise: Exercise) -> Iterator[Fault]:
        """Yield what is wrong with the links, and names without a value or without a use."""
        try:
            bodies = _bodies(part, exercise.reference)
        except KinematicsError as error:
            yield from error.faults
            return
        used = set(bodies.kinds) - set(exercise.reference.parameters)
        given = {weight.name for weight in part.weights}
        for name in sorted(used - given):
            yield Fault.at("parameter_missing", "weights", name, name=name)
        for name in sorted(given - used):
            yield Fault.at("parameter_unused", "weights", name, name=name)
        for joint in range(1, exercise.reference.table.n_joints + 1):
            if rate_name(joint) in bodies.kinds:
                yield Fault.at("name_of_rate", "links", name=rate_name(joint))

    def warnings(self, part: MotionPart, exercise: Exercise) -> Iterable[str]:
        """Return a code where things do not fall down in the figure."""
        values = {weight.name: float(weight.value) for weight in part.weights}
        bodies = _bodies(part, exercise.reference)
        fall = [evaluate(entry, generate(exercise).values | values) for entry in bodies.gravity]
        x, y, z = transform_from_rpy(exercise.figure.upright)[:3, :3] @ fall
        return ("gravity_not_down",) if -z < DOWN * math.hypot(x, y, z) else ()

    def draw(self, part: MotionPart, exercise: Exercise, picker: Picker) -> Mapping[str, Fraction]:
        """Return the student's values of what the links weigh."""
        return {
            weight.name: picker.value(weight.value, weight.draw, f"{self.kind}.{weight.name}")
            for weight in part.weights
        }

    def task(self, part: MotionPart, instance: Instance) -> PartTask:
        """Show the table, the links, gravity and the values."""
        n = instance.exercise.reference.table.n_joints
        names = joint_names(n)
        unit = instance.exercise.length_unit.value
        form = []
        if MotionAsk.MASS in part.ask:
            form.append(FormField(name="mass", shape=FieldShape.MATRIX, labels=names, rows=n))
        if _asks_matrix(part):
            form.append(FormField(name="coriolis", shape=FieldShape.MATRIX, labels=names, rows=n))
        elif MotionAsk.VELOCITY in part.ask:
            form.append(FormField(name="velocity", shape=FieldShape.VECTOR, labels=names))
        if MotionAsk.GRAVITY in part.ask:
            form.append(FormField(name="gravity", shape=FieldShape.VECTOR, labels=names))
        weights: Mapping[str, Fraction] = instance.drawn[self.kind]
        numbers = [given_table(instance), given_links(part.links, unit)]
        gravity = tuple(entry if isinstance(entry, str) else float(entry) for entry in part.gravity)
        told = {"unit": unit}
        numbers.append(
            GivenNumbers(name="gravity-vector", labels=("x", "y", "z"), rows=(gravity,), values=told)
        )
        if weights:
            values = tuple(float(value) for value in weights.values())
            units = units_of_names(part.links, part.gravity, unit)
            labels = tuple(f"{name} [{units[name]}]" if name in units else name for name in weights)
            numbers.append(GivenNumbers(name="weights", labels=labels, rows=(values,)))
        return PartTask(
            message="task-equations-of-motion",
            values={"unit": unit, "skew": "yes" if MotionAsk.SKEW in part.ask else "no"},
            form=tuple(form),
            numbers=tuple(numbers),
        )

    def read(self, raw: MotionCells, reading: Reading) -> EquationsAnswer | None:
        """Return the functions."""
        part = reading.instance.exercise.part(self.kind)
        assert isinstance(part, MotionPart)
        return read_motion(raw, part.ask, reading, {weight.name for weight in part.weights})

    def grade(self, part: MotionPart, answer: EquationsAnswer, context: Context) -> PartReport:
        """Judge M entry by entry, C q̇ and g row by row; what is asked counts the same.

        Zeros that the robot's own equations have are known for nothing.
        """
        asked = _question(part, context)
        verdict, equations = judge_dynamics(asked, answer, part.tolerance), asked.equations
        facts: list[Fact] = []
        feedback: list[Feedback] = []
        total = 0.0
        for question in part.ask:
            right = _findings(question, verdict)
            if right is None:
                facts.append(Fact(where=(question.value,), finding=Finding.MISSING))
                feedback.append(Feedback(code="motion_missing", params={"what": question.value}))
                continue
            good = all(right.values())
            nothing = [_vanishes(question, equations, place) for place in right]
            total += 1.0 if good else min(MOST_OF_WRONG, share_earned([*right.values()], nothing))
            if not good:
                feedback.append(Feedback(code=f"motion_{question.value}_wrong"))
                facts += [fact(False, question.value, *place) for place, good in right.items() if not good]
        feedback += [Feedback(code=f"motion_{mistake.value}") for mistake in verdict.mistakes]
        if not feedback:
            feedback.append(Feedback(code="motion_right"))
        return judged(part, total / len(part.ask), Credit.KEY, facts=facts, feedback=feedback)

    def right(self, part: MotionPart, context: Context) -> MotionCells:
        """Return the equations with the C that is made of Christoffel symbols."""
        found = _question(part, context).equations
        n = context.reference.table.n_joints
        names = (*found.names, *(rate_name(i) for i in range(1, n + 1)))

        def rows(matrix: Matrix) -> tuple[tuple[Cell, ...], ...]:
            return tuple(tuple(row) for row in write_matrix(matrix, n, names))

        def row(matrix: Matrix) -> tuple[Cell, ...]:
            return tuple(entry for (entry,) in write_matrix(matrix, n, names))

        return MotionCells(
            mass=rows(found.mass) if MotionAsk.MASS in part.ask else None,
            coriolis=rows(found.coriolis) if _asks_matrix(part) else None,
            velocity=row(found.velocity)
            if MotionAsk.VELOCITY in part.ask and not _asks_matrix(part)
            else None,
            gravity=row(found.gravity) if MotionAsk.GRAVITY in part.ask else None,
        )

    def wrong(self, part: MotionPart, context: Context, rng: Random) -> Iterator[tuple[str, MotionCells]]:
        """Yield gravity of the wrong sign, and an M with a wrong corner."""
        right = self.right(part, context)
        if right.gravity is not None and any(cell != "0" for cell in right.gravity):
            yield "motion_gravity_sign", replace(right, gravity=tuple(f"-({cell})" for cell in right.gravity))
        if right.mass is not None:
            first, *rest = right.mass
            yield "motion_mass_wrong", replace(right, mass=((f"2*({first[0]})", *first[1:]), *rest))


def _asks_matrix(part: MotionPart) -> bool:
    return MotionAsk.CORIOLIS in part.ask or MotionAsk.SKEW in part.ask


@lru_cache(maxsize=64)
def _bodies(part: MotionPart, read: ReadTable) -> ReadBodies:
    """Return the links; all lengths stay in the exercise's unit, so a unit is read as it stands."""
    return read_bodies(replace(read, length_unit=LengthUnit.M), part.links, part.gravity)


def _question(part: MotionPart, context: Context) -> DynamicsQuestion:
    weights: Mapping[str, Fraction] = context.instance.drawn[part.kind]
    bodies = _bodies(part, context.reference)
    values = {**context.reference_values, **{name: float(value) for name, value in weights.items()}}
    return DynamicsQuestion(
        table=context.reference.table, links=bodies.links, gravity=bodies.gravity, values=values
    )


def _findings(question: MotionAsk, verdict: DynamicsVerdict) -> dict[tuple[int, ...], bool] | None:
    """Return what is right of one question, by place; None if it was not answered."""
    if question is MotionAsk.SKEW:
        return None if verdict.skew is None else {(): verdict.skew}
    if question is MotionAsk.MASS:
        if verdict.mass is None:
            return None
        return {(i, j): good for i, row in enumerate(verdict.mass) for j, good in enumerate(row)}
    rows = verdict.gravity if question is MotionAsk.GRAVITY else verdict.velocity
    return None if rows is None else {(i,): good for i, good in enumerate(rows)}


def _vanishes(question: MotionAsk, equations: Derivation, place: tuple[int, ...]) -> bool:
    """Return whether what is asked for is zero."""
    if question is MotionAsk.SKEW:
        return False
    if question is MotionAsk.MASS:
        i, j = place
        return equations.mass[i][j] == ZERO
    rows = equations.gravity if question is MotionAsk.GRAVITY else equations.velocity
    (i,) = place
    return rows[i][0] == ZERO


PART = MotionType()
