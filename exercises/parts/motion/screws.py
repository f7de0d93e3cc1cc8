"""Joint screws and the home pose: right if they are the robot, whatever frames, senses, points and zeros.

An answer is held to the exercise's policy exactly as a table is (`kinematics.answers.screw_answers`).
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from random import Random
from typing import Annotated, ClassVar

import numpy as np

from exercises.definition import Part
from exercises.grading import Feedback, HelpLevel
from exercises.grading.findings import rule_broken
from exercises.instance import Instance
from exercises.parts.cells.by_name import ByName, read_by_name
from exercises.parts.cells.matrix_cells import CellMatrix, read_numbers
from exercises.parts.cells.number_cells import on_paper, read_numbers_of
from exercises.parts.context import Context
from exercises.parts.joint_draws import key_numbers
from exercises.parts.protocol import Length, PartType, Reading
from exercises.parts.report import Credit, PartReport, fact, judged, share_earned, told_from
from exercises.parts.task import FieldShape, FormField, PartTask, choice_field
from kinematics.answers.axis_pairs import pairs_on_one_line
from kinematics.answers.screw_answers import (
    ScrewAnswer,
    ScrewFrame,
    ScrewMistake,
    ScrewOrder,
    ScrewVerdict,
    adjoint,
    judge_screws,
)
from kinematics.cells import Cell
from kinematics.cells.meaning import Position
from kinematics.equivalence import Policy
from kinematics.screws import product_of_exponentials
from kinematics.se3 import inverse_transform

DECIMALS = 6  # Decimals of a student's screws: they are held to a policy, whose tolerance may be small.
RULES_BROKEN = (
    *(f"base_{rule}_missed" for rule in ("axis", "origin", "frame")),
    *(f"tool_{rule}_missed" for rule in ("axis", "point", "frame")),
    "zero_missed",
    "direction_missed",
)
"""What is told of an answer that is the robot and breaks a rule."""
ScrewRow = tuple[Cell, Cell, Cell, Cell, Cell, Cell]


@dataclass(frozen=True, kw_only=True, slots=True)
class ScrewsCells:
    """A product of exponentials.

    Attributes:
        frame: screws in the fixed frame (space), or in the tool's at the zero position (body).
        order: which half of a screw stands first: linear_first (v, ω) or angular_first (ω, v).
        screws: one row for each joint; lengths in the exercise's unit.
        home: 4×4, the pose of the last frame at the zero position.
    """

    frame: ScrewFrame
    order: ScrewOrder
    screws: Annotated[tuple[ScrewRow, ...], Length(least=1, most=64)]
    home: CellMatrix


class ScrewsPart(PartType[Part, ScrewsCells, ByName[ScrewAnswer]]):
    """Screws and home pose of the robot."""

    kind = "screws"
    raw: ClassVar = ScrewsCells
    meaning = "the joint screws and the home pose"
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "screws_wrong", "screws_right_robot", *RULES_BROKEN),
        **told_from(HelpLevel.REPAIR, *(f"screw_{mistake.value}" for mistake in ScrewMistake)),
        **told_from(HelpLevel.KIND, "screws_relation_wrong"),
    }

    def task(self, part: Part, instance: Instance) -> PartTask:
        """Ask for a screw of each joint, and the home pose."""
        n = instance.exercise.reference.table.n_joints
        return PartTask(
            message="task-screws",
            values={"n": n, "unit": instance.exercise.length_unit.value},
            form=(
                choice_field("frame", ScrewFrame),
                choice_field("order", ScrewOrder),
                FormField(
                    name="screws", shape=FieldShape.MATRIX, labels=("1", "2", "3", "4", "5", "6"), rows=n
                ),
                FormField(name="home", shape=FieldShape.MATRIX, labels=("x", "y", "z", "p"), rows=4),
            ),
        )

    def read(self, raw: ScrewsCells, reading: Reading) -> ByName[ScrewAnswer] | None:
        """Return screws (v, ω) and home pose in numbers, lengths in the exercise's unit."""
        return read_by_name(raw, reading, self._read, _lengths)

    def _read(self, raw: ScrewsCells, reading: Reading) -> ScrewAnswer | None:
        n = reading.instance.exercise.reference.table.n_joints
        if len(raw.screws) != n:
            reading.fault("screw_count", "screws", expected=n, given=len(raw.screws))
        rows = [
            read_numbers_of(row, Position.LENGTH, reading, "screws", i) for i, row in enumerate(raw.screws)
        ]
        home = read_numbers(raw.home, reading, "home")
        if reading.faults or home is None:
            return None
        screws = np.array([raw.order.linear_first(row or ()) for row in rows], dtype=np.float64)
        return ScrewAnswer(screws=screws, home=home, frame=raw.frame)

    def grade(self, part: Part, answer: ByName[ScrewAnswer], context: Context) -> PartReport:
        """Judge an answer at the student's lengths and, if it is right there and in names, at others."""
        report = self._judged(part, answer.here, context)
        elsewhere = answer.elsewhere(context) if report.correct else None
        return self._judged(part, *elsewhere) if elsewhere else report

    def _judged(self, part: Part, answer: ScrewAnswer, context: Context) -> PartReport:
        """Judge the whole; of a wrong answer axes that lie to each other as they should earn up to half.

        What is right of axes that all lie on one line is known for nothing.
        """
        key = key_numbers(context.instance)
        found = judge_screws(key, answer, context.policy)
        if found.right:
            return judged(part, 1.0, Credit.KEY, feedback=screw_feedback(found, context.policy))
        off = {pair.second - 1 for pair in found.pairs if not pair.alike}
        facts = [fact(i not in off, "screws", i) for i in range(1, len(answer.screws))]
        feedback = screw_feedback(found, context.policy)
        feedback += [
            Feedback(code=f"screw_{mistake.value}", params={"joint": joint or 0})
            for mistake, joint in found.mistakes
        ]
        if not found.mistakes:
            feedback += [
                Feedback(code="screws_relation_wrong", params={"joint": pair.first, "next": pair.second})
                for pair in found.pairs
                if not pair.alike
            ]
        nothing = [pair.alike for pair in pairs_on_one_line(key, context.policy)]
        share = share_earned([pair.alike for pair in found.pairs], nothing) if not all(nothing) else 0.0
        return judged(part, 0.5 * share, Credit.KEY, facts=facts, feedback=feedback)

    def right(self, part: Part, context: Context) -> ScrewsCells:
        """Return the key's screws in space, linear part first."""
        return _cells(_key(context))

    def wrong(self, part: Part, context: Context, rng: Random) -> Iterator[tuple[str, ScrewsCells]]:
        """Yield body screws called space screws, one ω of another length, and another joint's type."""
        right = _key(context)
        turning = [i for i, row in enumerate(right.screws) if row[3:].any()]
        if turning:
            longer = right.screws.copy()
            longer[rng.choice(turning)] *= 2
            yield "screw_not_unit", _cells(replace(right, screws=longer))
        body = replace(right, screws=right.screws @ adjoint(inverse_transform(right.home)).T)
        found = judge_screws(key_numbers(context.instance), body, context.policy)
        if not found.right:
            yield _code(found), _cells(body)


def screw_feedback(found: ScrewVerdict, policy: Policy) -> list[Feedback]:
    """Return what is said of an answer as a whole, and the rule that the right robot breaks."""
    broken = [Feedback(code=rule_broken(rule, policy)) for rule in found.broken or ()]
    return [Feedback(code=_code(found)), *broken]


def _code(found: ScrewVerdict) -> str:
    if found.right:
        return "screws_right"
    return "screws_wrong" if found.broken is None else "screws_right_robot"


def _key(context: Context) -> ScrewAnswer:
    """The key's screws in space."""
    found = product_of_exponentials(key_numbers(context.instance))
    rows = np.array([[*screw.linear, *screw.angular] for screw in found.screws])
    return ScrewAnswer(screws=rows, home=found.home)


def _lengths(answer: ScrewAnswer) -> list[float]:
    """Return the lengths in an answer: v of each revolute joint, and the position at home."""
    turning = answer.screws[answer.screws[:, 3:].any(axis=1), :3]
    found: list[float] = [*turning.ravel().tolist(), *answer.home[:3, 3].tolist()]
    return found


def _cells(answer: ScrewAnswer) -> ScrewsCells:
    rows = on_paper(answer.screws, DECIMALS)
    home: CellMatrix = on_paper(answer.home, DECIMALS).tolist()
    return ScrewsCells(
        frame=answer.frame,
        order=ScrewOrder.LINEAR_FIRST,
        screws=tuple((a, b, c, d, e, f) for a, b, c, d, e, f in rows.tolist()),
        home=home,
    )


PART = ScrewsPart()
