"""Singularities: where an arm loses a motion, as conditions that count as a set, and which one it loses."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import ClassVar

from exercises.definition import Exercise, Part
from exercises.draws import Picker
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.grading.verdict import ParamValue
from exercises.instance import Instance
from exercises.parts.cells.number_cells import DECIMALS
from exercises.parts.context import Context
from exercises.parts.first_values import Start
from exercises.parts.given_table import given_table
from exercises.parts.joint_draws import JointDraws, in_radians, joint_labels, read_joints, told_units
from exercises.parts.motion.singularity_cells import (
    MOST,
    SingularityAnswer,
    SingularityCells,
    read_singularities,
)
from exercises.parts.protocol import TABLE, PartType, Reading, RobotFacts
from exercises.parts.report import Credit, Fact, PartReport, fact, judged, told_from
from exercises.parts.task import FieldShape, FormField, GivenNumbers, PartTask
from exercises.reading import Reader
from kinematics.answers.lost_motions import lost_motion_is_right, lost_motions_at
from kinematics.answers.singular_arms import SingularArm, arm_of
from kinematics.answers.singularity_answers import is_sine_for_cosine, judge_singularities
from kinematics.answers.singularity_verdicts import ConditionStatus
from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import joint_variables_in
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.symbolic.determinants import MotionRows, largest_minor


@dataclass(frozen=True, kw_only=True, slots=True)
class SingularitiesPart(Part):
    """Where the key's robot is singular.

    Attributes:
        rows: which motion counts.
        joints: a singular configuration in which the lost motion is asked, or None.
    """

    rows: MotionRows
    joints: JointDraws | None


class SingularitiesType(PartType[SingularitiesPart, SingularityCells, SingularityAnswer]):
    """Where an arm is singular, and which motion it loses there."""

    kind = "singularities"
    raw: ClassVar = SingularityCells
    meaning = "the conditions for a singularity, and a motion that is lost"
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "singularities_missing", "singularity_invented", "singularity_everywhere"),
        **told_from(HelpLevel.ROW, "lost_motion_wrong", "lost_motion_zero"),
        **told_from(HelpLevel.REPAIR, "singularity_missing_at", "singularity_invented_at"),
        **told_from(HelpLevel.REPAIR, "singularity_sine_for_cosine", "singularity_rounded"),
        **told_from(HelpLevel.REPAIR, "singularity_half"),
        **told_from(
            HelpLevel.REPAIR, "lost_motion_is_kept", "lost_motion_never", instead="lost_motion_wrong"
        ),
    }

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> SingularitiesPart:
        """Return the part with the motion that counts, and the configuration of the lost one."""
        rows = reader.choice("motion", MotionRows, MotionRows.TWIST)
        joints = read_joints(reader, robot) if reader.given("joints") else None
        return SingularitiesPart(kind=self.kind, points=points, rows=rows, joints=joints)

    def start(self, robot: RobotFacts) -> Start:
        """Return the motion of which an arm of so few joints can lose a direction."""
        few = len(robot.joint_types) < 6
        return {"motion": (MotionRows.TRANSLATION if few else MotionRows.TWIST).value}

    def inconsistencies(self, part: SingularitiesPart, exercise: Exercise) -> Iterator[Fault]:
        """Yield a fault where conditions cannot say all, where there are none, or where nothing is lost."""
        try:
            minor, only = largest_minor(exercise.reference.table, part.rows)
        except FormSizeError as error:
            yield from error.faults
            return
        if not only or not joint_variables_in(minor.expression()):
            yield Fault.at("singularities_no_families", "motion")
        arm = _arm(part, exercise, exercise.usual_values)
        if part.joints is not None and not lost_motions_at(arm, in_radians(exercise, part.joints.usual)):
            yield Fault.at("not_singular", "joints")

    def draw(
        self, part: SingularitiesPart, exercise: Exercise, picker: Picker
    ) -> tuple[Fraction, ...] | None:
        """Return the student's singular configuration [the exercise's units]."""
        return None if part.joints is None else part.joints.drawn(picker, self.kind)

    def task(self, part: SingularitiesPart, instance: Instance) -> PartTask:
        """Show the key, and the configuration of the lost motion."""
        exercise = instance.exercise
        numbers = [given_table(instance)] if exercise.part(TABLE) is None else []
        form = [FormField(name="conditions", shape=FieldShape.LIST, labels=("g(q) = 0",), rows=MOST)]
        if part.joints is not None:
            drawn: tuple[Fraction, ...] = instance.drawn[self.kind]
            row = tuple(float(value) for value in drawn)
            numbers.append(GivenNumbers(name="configuration", labels=joint_labels(exercise), rows=(row,)))
            form.append(FormField(name="lost", shape=FieldShape.VECTOR, labels=_labels(part)))
        return PartTask(
            message="task-singularities",
            values={
                "motion": part.rows.value,
                "lost": "no" if part.joints is None else "yes",
                "unit": exercise.length_unit.value,
            },
            form=tuple(form),
            numbers=tuple(numbers),
        )

    def read(self, raw: SingularityCells, reading: Reading) -> SingularityAnswer | None:
        """Return the functions that vanish, row by row, and the motion."""
        part = reading.instance.exercise.part(self.kind)
        assert isinstance(part, SingularitiesPart)
        if raw.conditions is None and raw.lost is not None and part.joints is None:
            reading.fault("part_not_asked", "lost", part="lost", known=("conditions",))
        return read_singularities(raw, reading, len(_labels(part)))

    def grade(self, part: SingularitiesPart, answer: SingularityAnswer, context: Context) -> PartReport:
        """Judge the conditions as a set; the lost motion counts a quarter, if it is asked."""
        arm = _arm(part, context.instance.exercise, context.reference_values)
        facts: list[Fact] = []
        feedback: list[Feedback] = []
        score = _conditions(arm, answer, facts, feedback, told_units(context.instance.exercise))
        if part.joints is not None:
            drawn: tuple[Fraction, ...] = context.instance.drawn[self.kind]
            joints = in_radians(context.instance.exercise, drawn)
            score = 0.75 * score + 0.25 * _lost(arm, joints, answer, facts, feedback)
        if score == 1.0:
            feedback.insert(0, Feedback(code="singularities_right"))
        return judged(part, score, Credit.KEY, facts=facts, feedback=feedback)

    def right(self, part: SingularitiesPart, context: Context) -> SingularityCells:
        """Return a condition for each family, and a motion that is lost."""
        arm = _arm(part, context.instance.exercise, context.reference_values)
        n, names = arm.table.n_joints, tuple(context.reference.parameters)
        printer = MatrixPrinter(n_joints=n, parameters=names, notation=Notation.FULL)
        purpose = Purpose(name="conditions", meaning="Conditions.")
        written = printer.write(tuple((family,) for family in arm.families), (Format.TEXT,), purpose)["text"]
        answer = SingularityCells(conditions=tuple((row[0],) for row in written))
        if part.joints is None:
            return answer
        drawn: tuple[Fraction, ...] = context.instance.drawn[self.kind]
        motion = lost_motions_at(arm, in_radians(context.instance.exercise, drawn))[0]
        return replace(answer, lost=tuple(round(value, DECIMALS) + 0.0 for value in motion))

    def wrong(
        self, part: SingularitiesPart, context: Context, rng: Random
    ) -> Iterator[tuple[str, SingularityCells]]:
        """Yield the conditions without one of them, with one too many, and one that always holds."""
        right = self.right(part, context)
        rows = list(right.conditions or ())
        k = rng.randrange(len(rows))
        yield "singularities_missing", replace(right, conditions=tuple(rows[:k] + rows[k + 1 :]))
        yield "singularity_invented", replace(right, conditions=(*rows, ("sin(q1) = 1/3",)))
        yield "singularity_everywhere", replace(right, conditions=(*rows, ("sin(q1)^2 + cos(q1)^2 - 1",)))
        if right.lost is not None:
            yield "lost_motion_is_kept", replace(right, lost=(1, 2, -3, *right.lost[3:]))


def _arm(part: SingularitiesPart, exercise: Exercise, values: dict[str, float]) -> SingularArm:
    """Return the key's arm with a student's values [rad, the exercise's length]."""
    return arm_of(exercise.reference.table, part.rows, tuple(sorted(values.items())))


def _labels(part: SingularitiesPart) -> tuple[str, ...]:
    translation = ("vx", "vy", "vz")
    return translation if part.rows is MotionRows.TRANSLATION else (*translation, "ωx", "ωy", "ωz")


def _configuration(joints: Sequence[float], units: Sequence[str]) -> str:
    """Return a configuration as a person reads it, angles within half a turn."""
    parts = []
    for i, (value, unit) in enumerate(zip(joints, units, strict=True), 1):
        shown = value if unit not in ("°", "rad") else math.remainder(value, math.tau)
        number = f"{round(math.degrees(shown), 1) if unit == '°' else round(shown, 3):g}".replace("-", "−")
        parts.append(f"q{i} = {'0' if number == '−0' else number}{'' if unit == '°' else ' '}{unit}")
    return ", ".join(parts)


def _conditions(
    arm: SingularArm,
    answer: SingularityAnswer,
    facts: list[Fact],
    feedback: list[Feedback],
    units: Sequence[str],
) -> float:
    """Judge the conditions; note what is found, and return their share."""
    if answer.conditions is None:
        facts.append(Fact(where=("conditions",), finding=Finding.MISSING))
        feedback.append(Feedback(code="conditions_missing"))
        return 0.0
    flat = [(i, function) for i, row in enumerate(answer.conditions) for function in row]
    found = judge_singularities(arm, [function for _, function in flat], answer.rounded)
    for (i, function), entry in zip(flat, found.conditions, strict=True):
        if entry.status is ConditionStatus.SINGULAR:
            continue
        params: dict[str, ParamValue] = {"condition": i + 1}
        feedback.append(Feedback(code=f"singularity_{entry.status.value}", params=params))
        if entry.status is not ConditionStatus.NOWHERE:
            facts.append(fact(False, "conditions", i, 0))
        if entry.example is not None:
            at = _configuration(entry.example, units)
            feedback.append(Feedback(code="singularity_invented_at", params={**params, "at": at}))
            if entry.is_close:
                feedback.append(Feedback(code="singularity_rounded", params=params))
            elif is_sine_for_cosine(arm, function):
                feedback.append(Feedback(code="singularity_sine_for_cosine", params=params))
    missing = [family for family in found.families if family.found < 1.0]
    if missing:
        params = {"found": len(found.families) - len(missing), "count": len(found.families)}
        feedback.append(Feedback(code="singularities_missing", params=params))
        if missing[0].found > 0.0:
            feedback.append(Feedback(code="singularity_half"))
        vacuous = any(entry.status is ConditionStatus.EVERYWHERE for entry in found.conditions)
        if missing[0].example is not None and not vacuous:
            at = _configuration(missing[0].example, units)
            feedback.append(Feedback(code="singularity_missing_at", params={"at": at}))
    return 1.0 if found.right else min(found.share, 0.8)


def _lost(
    arm: SingularArm,
    joints: Sequence[float],
    answer: SingularityAnswer,
    facts: list[Fact],
    feedback: list[Feedback],
) -> float:
    """Judge the lost motion; note what is found, and return its share."""
    if answer.lost is None:
        facts.append(Fact(where=("lost",), finding=Finding.MISSING))
        feedback.append(Feedback(code="lost_motion_missing"))
        return 0.0
    right = lost_motion_is_right(arm, joints, answer.lost)
    if right:
        return 1.0
    facts.append(fact(False, "lost"))
    never = "never" if any(answer.lost) else "zero"
    feedback.append(Feedback(code=f"lost_motion_{'is_kept' if right is False else never}"))
    return 0.0


PART = SingularitiesType()
