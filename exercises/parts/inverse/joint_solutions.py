"""Joint values that reach a pose: one solution, all of them, infinitely many with their condition, or none.

Without a table among the parts the key is given, and the pose is that of its frames. With one, the pose is
given in the frames that the policy fixes, and the joint values are those of the student's own variables: they
are carried over to the key's by the certificate of the accepted table.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import ClassVar

from exercises.definition import Exercise
from exercises.draws import Picker
from exercises.grading import BaseRule, Feedback, Finding, HelpLevel, ToolRule, accept
from exercises.instance import Instance, generate
from exercises.parts import first_values as defined
from exercises.parts.cells.number_cells import on_paper, read_numbers_of
from exercises.parts.context import Context
from exercises.parts.given_table import given_table
from exercises.parts.inverse.joint_cells import (
    MOST_ROWS,
    JointAnswerCells,
    joint_feedback,
    kept_combination,
    written_answer,
)
from exercises.parts.inverse.pose_question import DrawnPose, InverseKinematicsPart, question_of, target_of
from exercises.parts.joint_draws import PoseCase, SolutionsAsked, joint_labels, read_joints
from exercises.parts.protocol import TABLE, PartType, Reading, RobotFacts
from exercises.parts.report import Credit, Fact, PartReport, fact, judged, told_from
from exercises.parts.task import FieldShape, FormField, GivenNumbers, PartTask, choice_field
from exercises.reading import KeyShape, Reader
from kinematics.answers.joint_answers import in_other_frames, judge_joints
from kinematics.answers.joint_questions import USUAL_TOLERANCE
from kinematics.answers.joint_verdicts import Branch, JointAnswer, JointClaim, JointMistake
from kinematics.cells.meaning import Position
from kinematics.errors import Fault
from kinematics.inverse import ArmReach
from kinematics.table import JointType


class InverseKinematicsType(PartType[InverseKinematicsPart, JointAnswerCells, JointAnswer]):
    """Inverse kinematics."""

    kind = "inverse_kinematics"
    raw: ClassVar = JointAnswerCells
    meaning = "the joint values that reach the pose of the task"
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "joints_wrong", "joints_twice", "joints_missing", "joints_taken_off"),
        **told_from(HelpLevel.ROW, "claim_wrong"),
        **told_from(HelpLevel.KIND, "joints_family_missing", *(f"branch_{branch}" for branch in Branch)),
        **told_from(
            HelpLevel.REPAIR, *(f"joints_{mistake.value}" for mistake in JointMistake), instead="joints_wrong"
        ),
        **told_from(HelpLevel.ROW, *(f"joints_combination_{said}" for said in ("wrong", "loose", "zero"))),
    }

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> InverseKinematicsPart:
        """Return the part with its pose and what is asked of it."""
        joints, cases = read_joints(reader, robot), reader.choices("cases", PoseCase, ())
        solutions = reader.choice("solutions", SolutionsAsked, SolutionsAsked.ALL)
        reader.note("reach", KeyShape.CHOICE, options=(ArmReach.POSE, ArmReach.POSITION))
        return InverseKinematicsPart(
            kind=self.kind,
            points=points,
            joints=joints,
            cases=cases or (PoseCase.REACHED,),
            every=solutions is SolutionsAsked.ALL,
            reach=reader.choice("reach", ArmReach, ArmReach.POSE),
            tolerance=reader.tolerance("tolerance", USUAL_TOLERANCE),
        )

    def start(self, robot: RobotFacts) -> defined.Start:
        """Return joint values to begin with."""
        return {"joints": defined.usual_joints(robot)}

    def inconsistencies(self, part: InverseKinematicsPart, exercise: Exercise) -> Iterator[Fault]:
        """Yield what the policy does not fix of the pose, and a pose out of reach of an arm that has none."""
        policy = exercise.policy
        free = policy.base is not BaseRule.FRAME or policy.tool is not ToolRule.FRAME
        if exercise.part(TABLE) is not None and free:
            yield Fault.at("pose_frames_free", "kind")
        if part.reach is ArmReach.AXIS:
            yield Fault.at("exercise_value_unknown", "reach", key="reach", known="pose, position")
        elif PoseCase.OUT_OF_REACH in part.cases:
            far = replace(part, cases=(PoseCase.OUT_OF_REACH,))
            asked = question_of(far, generate(replace(exercise, parts=(far,))))
            if asked.expected is not JointClaim.OUT_OF_REACH:
                yield Fault.at("pose_within_reach", "cases")

    def draw(self, part: InverseKinematicsPart, exercise: Exercise, picker: Picker) -> DrawnPose:
        """Return the student's joint values, and what becomes of their pose."""
        joints = part.joints.drawn(picker, self.kind)
        return DrawnPose(joints=joints, case=picker.choice(part.cases, f"{self.kind} case"))

    def task(self, part: InverseKinematicsPart, instance: Instance) -> PartTask:
        """Show the pose, and the key if no table is asked; ask for joint values."""
        exercise = instance.exercise
        labels = joint_labels(exercise)
        pose = on_paper(target_of(part, instance))
        position = part.reach is ArmReach.POSITION
        shown = [tuple(row) for row in pose.tolist()]
        numbers = GivenNumbers(
            name="target-position" if position else "target",
            labels=("x", "y", "z") if position else (),
            rows=(tuple(row[3] for row in shown[:3]),) if position else tuple(shown),
        )
        own = exercise.part(TABLE) is not None
        claims = [claim for claim in JointClaim if claim is not JointClaim.JOINT_LIMITS]
        names = defined.joint_names(len(labels))
        return PartTask(
            message="task-inverse-kinematics",
            values={
                "solutions": "all" if part.every else "one",
                "reach": part.reach.value,
                "variables": "own" if own else "given",
                "unit": exercise.length_unit.value,
            },
            form=(
                choice_field("claim", claims, "position_claim" if position else "pose_claim"),
                FormField(
                    name="solutions",
                    shape=FieldShape.LIST,
                    labels=labels,
                    rows=MOST_ROWS if part.every else 1,
                ),
                FormField(name="combinations", shape=FieldShape.LIST, labels=names, rows=4),
            ),
            numbers=(numbers,) if own else (given_table(instance), numbers),
        )

    def read(self, raw: JointAnswerCells, reading: Reading) -> JointAnswer | None:
        """Return the rows in [rad] and in the exercise's length unit."""
        types = reading.instance.exercise.reference.table.joint_types
        positions = [Position.LENGTH if kind is JointType.PRISMATIC else Position.ANGLE for kind in types]
        rows, combinations = [], []
        for i, row in enumerate(raw.solutions):
            if reading.is_row_of(len(types), row, "solutions", i):
                rows.append(read_numbers_of(row, positions, reading, "solutions", i) or ())
        for i, row in enumerate(raw.combinations):
            if reading.is_row_of(len(types), row, "combinations", i):
                combinations.append(read_numbers_of(row, Position.RATIO, reading, "combinations", i) or ())
        if raw.claim in (JointClaim.FINITE, JointClaim.INFINITE) and not raw.solutions:
            reading.fault("joint_rows_empty", "solutions")
        if reading.faults:
            return None
        return JointAnswer(claim=raw.claim, rows=tuple(rows), combinations=tuple(combinations))

    def grade(self, part: InverseKinematicsPart, answer: JointAnswer, context: Context) -> PartReport:
        """Judge the rows by the robot, carried over from the student's own variables if there is a table."""
        if context.instance.exercise.part(TABLE) is not None and not context.own_correct:
            return judged(part, 0.0, Credit.NONE, feedback=(Feedback(code="joints_need_table"),))
        own = _certified(context)
        in_key = answer if own is None else in_other_frames(answer, *own)
        found = judge_joints(question_of(part, context.instance), in_key)
        facts = [fact(row.right, "solutions", i) for i, row in enumerate(found.rows)]
        facts += [fact(holds, "combinations", i) for i, holds in enumerate(found.combinations)]
        if found.missing or (found.share < 1.0 and answer.claim is not found.expected):
            facts.append(Fact(where=("claim",), finding=Finding.MISSING if found.missing else Finding.WRONG))
        feedback = tuple(joint_feedback(found, answer))
        return judged(part, found.share, Credit.KEY, correct=found.right, facts=facts, feedback=feedback)

    def right(self, part: InverseKinematicsPart, context: Context) -> JointAnswerCells:
        """Return every solution with the condition of each family, in the student's own variables."""
        question = question_of(part, context.instance)
        expected = question.expected
        if expected in (JointClaim.OUT_OF_REACH, JointClaim.JOINT_LIMITS):
            return JointAnswerCells(claim=expected)
        own = _certified(context)
        rows = [found.joints for found in question.found.solutions[: None if part.every else 1]]
        combinations = {
            tuple(combination)
            for found in question.found.solutions
            if found.family is not None and found.family.direction is not None
            for combination in [kept_combination(found.family.direction)]
            if combination is not None
        }
        answer = JointAnswer(claim=expected, rows=tuple(rows), combinations=tuple(sorted(combinations)))
        if own is not None:
            signs, offsets = own
            answer = replace(
                answer,
                rows=tuple(map(replace(answer, signs=signs, offsets=offsets).own, rows)),
                combinations=tuple(
                    tuple(s * c for s, c in zip(signs, row, strict=True)) for row in answer.combinations
                ),
            )
        return written_answer(answer, context.instance)

    def wrong(
        self, part: InverseKinematicsPart, context: Context, rng: Random
    ) -> Iterator[tuple[str, JointAnswerCells]]:
        """Yield an answer with a joint half a turn off, one that lacks a solution, and one that says none."""
        right = self.right(part, context)
        if not right.solutions:
            return
        first = right.solutions[0]
        question = question_of(part, context.instance)
        reaching = question.found.solutions[0].joints
        half = context.instance.exercise.angle_unit.from_radians(math.pi)
        for i, kind in enumerate(context.reference.table.joint_types):
            over = [value + math.pi * (j == i) for j, value in enumerate(reaching)]
            if kind is JointType.REVOLUTE and not question.reaches(over):
                off = (*first[:i], float(first[i]) + half, *first[i + 1 :])
                yield "joints_quadrant", replace(right, solutions=(off, *right.solutions[1:]))
                break
        if part.every and len(right.solutions) > 1 and right.claim is JointClaim.FINITE:
            yield "joints_missing", replace(right, solutions=right.solutions[1:])
        yield "claim_wrong", JointAnswerCells(claim=JointClaim.OUT_OF_REACH)


def _certified(context: Context) -> tuple[tuple[int, ...], tuple[float, ...]] | None:
    """Return σ and δ of the student's accepted table [rad, the exercise's length unit]; None without one."""
    verdict = context.verdict
    if verdict is None and context.own is not None and context.instance.exercise.part(TABLE) is not None:
        verdict = accept(context.reference, context.own, context.policy, context.parameters)
    certificate = None if verdict is None else verdict.certificate
    if certificate is None:
        return None
    offsets = tuple(
        offset / context.unit_ratio if kind is JointType.PRISMATIC else context.angle_unit.in_radians(offset)
        for offset, kind in zip(certificate.joint_offsets, context.reference.table.joint_types, strict=True)
    )
    return certificate.joint_signs, offsets


PART = InverseKinematicsType()
