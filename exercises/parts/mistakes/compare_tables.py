"""Two tables: the same robot or not, and why.

The second table is the key in other frames, or that with a mistake of the catalogue in it. Any true reason is
right: of the same robot, whatever in the second table's frames differs from the first's by the certificate;
of another one, a fact of the robot that the diagnosis finds wrong.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from random import Random
from typing import ClassVar

from exercises.definition import Exercise, Part
from exercises.draws import Picker
from exercises.grading import Feedback, Finding, HelpLevel, Verdict, grade
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.given_table import given_table
from exercises.parts.mistakes.planting import FACTS, PLANTABLE, plantable
from exercises.parts.protocol import TABLE, PartType, Reading
from exercises.parts.report import Credit, PartReport, fact, judged, told_from
from exercises.parts.task import PartTask, choice_field
from exercises.selftest.variants import some_lengths, variant
from kinematics.cells import ReadTable
from kinematics.equivalence.decision import mechanism_only

VARIANTS = 64  # Other frames of one key that are drawn from: more than a class has seats in a row.


class ComparisonReason(StrEnum):
    """Why two tables are the same robot, or are not."""

    AXIS_REVERSED = "axis_reversed"
    X_TURNED = "x_turned"
    ORIGIN_MOVED = "origin_moved"
    OTHER_CONVENTION = "other_convention"
    TWIST = "twist"
    LENGTH = "length"
    OFFSET = "offset"


_TOLD = {
    "axis_reversed": ComparisonReason.AXIS_REVERSED,
    "end_axis_reversed": ComparisonReason.AXIS_REVERSED,
    "variable_reversed": ComparisonReason.AXIS_REVERSED,
    "x_turned": ComparisonReason.X_TURNED,
    "variable_offset": ComparisonReason.X_TURNED,
    "origin_slid": ComparisonReason.ORIGIN_MOVED,
    "axis_moved": ComparisonReason.ORIGIN_MOVED,
    "frame_elsewhere": ComparisonReason.ORIGIN_MOVED,
    "other_convention": ComparisonReason.OTHER_CONVENTION,
}
"""What the explanation of a right table says, as a reason."""
_PLACES = ("origin_slid", "axis_moved")


class SameRobot(StrEnum):
    """What is said of two tables."""

    SAME = "same"
    DIFFERENT = "different"


@dataclass(frozen=True, kw_only=True, slots=True)
class ComparisonCells:
    """Whether two tables are the same robot, and why.

    Attributes:
        verdict: same or different.
        reason: of the same robot what differs in the frames (axis_reversed, x_turned, origin_moved,
            other_convention); of another one what differs in the robot (twist, length, offset).
    """

    verdict: SameRobot
    reason: ComparisonReason | None = None


class CompareTablesType(PartType[Part, ComparisonCells, ComparisonCells]):
    """Two tables beside each other."""

    kind = "compare_tables"
    gives_away: ClassVar = (TABLE,)
    raw: ClassVar = ComparisonCells
    meaning = "whether two tables are the same robot, and why"
    disclosures: ClassVar = told_from(
        HelpLevel.ROW, "tables_same", "tables_different", "tables_reason_wrong", "tables_reason_missing"
    )

    def draw(self, part: Part, exercise: Exercise, picker: Picker) -> ReadTable:
        """Return the student's second table."""
        number = picker.choice(tuple(range(VARIANTS)), f"{self.kind} frames")
        other = _variant(exercise, number)
        if picker.choice(tuple(SameRobot), f"{self.kind} verdict") is SameRobot.SAME:
            return other
        harmful = _spoilt(exercise, number)
        return picker.choice(harmful, f"{self.kind} mistake") if harmful else other

    def task(self, part: Part, instance: Instance) -> PartTask:
        """Show both tables."""
        return PartTask(
            message="task-compare-tables",
            form=(choice_field("verdict", SameRobot), choice_field("reason", ComparisonReason)),
            numbers=(
                given_table(instance, None, "first-table"),
                given_table(instance, instance.drawn[self.kind], "second-table"),
            ),
        )

    def read(self, raw: ComparisonCells, reading: Reading) -> ComparisonCells:
        """Return the answer as it is."""
        return raw

    def grade(self, part: Part, answer: ComparisonCells, context: Context) -> PartReport:
        """Return half of the points for the verdict, and half for a true reason."""
        verdict = _verdict(context)
        same = SameRobot.SAME if verdict.correct else SameRobot.DIFFERENT
        reasons = true_reasons(verdict)
        told = answer.verdict is same
        why = told and answer.reason in reasons
        feedback: list[Feedback] = []
        if not told:
            feedback.append(Feedback(code="tables_same" if verdict.correct else "tables_different"))
        elif not why:
            code = "tables_reason_missing" if answer.reason is None else "tables_reason_wrong"
            feedback.append(Feedback(code=code))
        else:
            feedback.append(Feedback(code="tables_right"))
        facts = (fact(told, "verdict"), fact(why, "reason"))
        return judged(part, 0.5 * (told + why), Credit.KEY, facts=facts, feedback=feedback)

    def right(self, part: Part, context: Context) -> ComparisonCells:
        """Return the verdict of the grader, with one of its reasons."""
        verdict = _verdict(context)
        reason = min(true_reasons(verdict), default=None)
        return ComparisonCells(
            verdict=SameRobot.SAME if verdict.correct else SameRobot.DIFFERENT, reason=reason
        )

    def wrong(self, part: Part, context: Context, rng: Random) -> Iterator[tuple[str, ComparisonCells]]:
        """Yield the other verdict, and the right one without a reason."""
        right = self.right(part, context)
        same = right.verdict is SameRobot.SAME
        other = SameRobot.DIFFERENT if same else SameRobot.SAME
        yield "tables_same" if same else "tables_different", replace(right, verdict=other)
        yield "tables_reason_missing", replace(right, reason=None)


def true_reasons(verdict: Verdict) -> frozenset[ComparisonReason]:
    """Return every reason that a verdict bears out."""
    if verdict.correct:
        return frozenset(_TOLD[entry.code] for entry in verdict.feedback if entry.code in _TOLD)
    found = {
        ComparisonReason(fact)
        for link in verdict.links
        for fact in ("twist", "length", "offset")
        if getattr(link, fact) in (Finding.WRONG, Finding.MISSING)
    }
    edits = [repair.edits[0] for repair in verdict.repairs if len(repair.edits) == 1]
    found |= {ComparisonReason(FACTS[edit.code]) for edit in edits if edit.code in FACTS}
    return frozenset(found)


def _verdict(context: Context) -> Verdict:
    second: ReadTable = context.instance.drawn[CompareTablesType.kind]
    return grade(context.reference, second, mechanism_only(context.policy), context.parameters)


@lru_cache(maxsize=1024)
def _variant(exercise: Exercise, number: int) -> ReadTable:
    """Return the key as somebody with other frames would have written it; the same one for a number."""
    usual = exercise.usual_values
    longest = max(usual.values(), default=1.0)
    lengths = some_lengths(exercise.reference.table, longest / 4)
    policy = mechanism_only(exercise.policy)
    for trial in range(20):
        rng = Random(f"{exercise.id} {number} {trial}")  # noqa: S311 - the same frames for a number, for ever
        table = variant(exercise.reference.table, policy, lengths, rng)
        read = replace(exercise.reference, table=table)
        verdict = grade(exercise.reference, read, policy, usual)
        if verdict.correct and true_reasons(_of_joints_and_ends(exercise.reference, read, verdict)):
            return read
    return exercise.reference


def _of_joints_and_ends(key: ReadTable, read: ReadTable, verdict: Verdict) -> Verdict:
    """Return a verdict without what it tells of frames between the ends where these do not correspond.

    Which tables are drawn for a student has always rested on the rest.
    """
    ours, theirs = key.table, read.table
    if [row.joint for row in ours.rows] == [row.joint for row in theirs.rows]:
        return verdict
    ends = (0, len(theirs.rows))
    kept = [said for said in verdict.feedback if said.code not in _PLACES or said.params["frame"] in ends]
    return replace(verdict, feedback=tuple(kept))


@lru_cache(maxsize=1024)
def _spoilt(exercise: Exercise, number: int) -> tuple[ReadTable, ...]:
    """Return the ways to spoil a variant."""
    usual = exercise.usual_values
    read = _variant(exercise, number)
    policy = mechanism_only(exercise.policy)
    return tuple(found.table for code in PLANTABLE for found in plantable(read, code, policy, usual))


PART = CompareTablesType()
