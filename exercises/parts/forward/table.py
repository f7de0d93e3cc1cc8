"""The DH table: judged by `exercises.grading`, whatever frames it was written in."""

from collections.abc import Iterator
from random import Random
from typing import ClassVar

from exercises.definition import Part
from exercises.grading import HelpLevel
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.protocol import TABLE, PartType, Reading
from exercises.parts.report import Credit, PartReport, judged
from exercises.parts.task import PartTask
from exercises.selftest.mistakes import MISTAKES
from exercises.written_table import written_table
from kinematics.cells import RawTable, ReadTable, read_table


class DHTablePart(PartType[Part, RawTable, ReadTable]):
    """The DH table."""

    kind = TABLE
    raw: ClassVar = RawTable
    meaning = "the DH table"

    def task(self, part: Part, instance: Instance) -> PartTask:
        """Ask for a table in the robot's dimensions."""
        values = {"n": instance.exercise.reference.table.n_joints, "names": ", ".join(instance.exact)}
        return PartTask(message="task-table", values=values)

    def read(self, raw: RawTable, reading: Reading) -> ReadTable | None:
        """Return the table in exact expressions and in the exercise's own names."""
        read = reading.keep(lambda: read_table(raw, reading.limits))
        return None if read is None else reading.own_table(read)

    def grade(self, part: Part, answer: ReadTable, context: Context) -> PartReport:
        """Return the verdict's score; what there is to tell stands in the verdict."""
        verdict = context.verdict
        assert verdict is not None
        return judged(part, verdict.score, Credit.KEY, correct=verdict.correct)

    def shown(self, report: PartReport, level: HelpLevel) -> PartReport:
        """Return the report as it is: it tells nothing beside the verdict."""
        return report

    def right(self, part: Part, context: Context) -> RawTable:
        """Return the student's own table."""
        assert context.own is not None
        return written_table(context.own)

    def wrong(self, part: Part, context: Context, rng: Random) -> Iterator[tuple[str, RawTable]]:
        """Yield the misconceptions that the exercise lists, each made in one place."""
        assert context.own is not None
        for code in context.instance.exercise.misconceptions:
            ways = list(MISTAKES[code](context.own))
            if ways:
                yield code, written_table(rng.choice(ways))

    @property
    def misconceptions(self) -> tuple[str, ...]:
        """The misconceptions that an exercise can list."""
        return tuple(MISTAKES)


PART = DHTablePart()
