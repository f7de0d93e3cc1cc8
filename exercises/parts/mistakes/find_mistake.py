"""Find the mistake: one error of the catalogue is planted in the table; find it, name it, mend it.

Whatever mends the table is right: the mended table is judged as any other, so a mistake that several repairs
undo may be mended by any of them. The place is right when it is the planted row or one whose repair does; so
is the name.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from exercises.definition import Exercise
from exercises.draws import Picker
from exercises.grading import grade, is_accepted
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.given_table import columns_of, given_table
from exercises.parts.mistakes.found_mistakes import FoundStep, MistakePart, MistakeType, MistakeWords
from exercises.parts.mistakes.planting import PLANTABLE, REPAIRS, Planted, as_given, planted, usable
from exercises.parts.protocol import Reading
from exercises.parts.report import PartReport
from exercises.parts.task import FieldShape, FormField, PartTask, choice_field
from exercises.written_table import written_table
from kinematics.cells import Cell, RawTable, ReadTable, read_table
from kinematics.errors import Fault
from kinematics.expressions import Expression, Number, Parameter, pi_fraction
from kinematics.table import ANGLES, LENGTHS, SymbolicTable


@dataclass(frozen=True, kw_only=True, slots=True)
class FoundMistakeCells:
    """Where a mistake stands, what it is, and the row as it should be.

    Attributes:
        row: number of the row, from 1.
        name: the mistake, a code of the catalogue.
        mended: the row as it should be, in the order of the table's columns.
    """

    row: int | str | None = None
    name: str | None = None
    mended: tuple[Cell, Cell, Cell, Cell] | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class FoundMistake:
    """A mistake that was found: its row, counted from 0, and the table with the mended row in it."""

    row: int | None
    name: str | None
    mended: ReadTable | None


class FindMistakeType(MistakeType[MistakePart, FoundMistakeCells, FoundMistake]):
    """Find the mistake in a table."""

    kind = "find_mistake"
    raw: ClassVar = FoundMistakeCells
    meaning = "the planted mistake: its row, its name, and the row as it should be"
    words: ClassVar = MistakeWords(
        "mistake_row_wrong", "mistake_name_wrong", "mistake_not_mended", "mistake_missing"
    )
    disclosures: ClassVar = words.told()
    fields: ClassVar = ("row", "name", "mended")
    catalogue: ClassVar = PLANTABLE

    def can_be_planted(self, part: MistakePart, exercise: Exercise) -> bool:
        """Return whether one of the mistakes makes the key another robot."""
        return usable(exercise, part.mistakes)

    def draw(self, part: MistakePart, exercise: Exercise, picker: Picker) -> Planted:
        """Return the student's table."""
        return planted(exercise, part.mistakes, picker, self.kind)

    def task(self, part: MistakePart, instance: Instance) -> PartTask:
        """Show the table."""
        found: Planted = instance.drawn[self.kind]
        labels = tuple(label for _, label in columns_of(found.table))
        return PartTask(
            message="task-find-mistake",
            form=(
                choice_field("row", tuple(str(i) for i in range(1, len(found.table.table.rows) + 1))),
                self.name_field(PLANTABLE),
                FormField(name="mended", shape=FieldShape.VECTOR, labels=labels),
            ),
            numbers=(given_table(instance, found.table, "table-with-mistake"),),
        )

    def read(self, raw: FoundMistakeCells, reading: Reading) -> FoundMistake | None:
        """Return the answer with the mended table."""
        if self.is_empty(raw, reading):
            return None
        found: Planted = reading.instance.drawn[self.kind]
        count = len(found.table.table.rows)
        row = self.number(raw.row, "row", range(1, count + 1), reading, "row_unknown")
        given = None if raw.mended is None or all(cell == "" for cell in raw.mended) else raw.mended
        if raw.row in (None, "") and given is not None:
            reading.fault("row_unknown", "row", count=count)
        name = self.known_name(raw.name, reading, PLANTABLE)
        if reading.faults:
            return None
        mended = None
        if given is not None and row is not None:
            mended = _mended(found.table, row - 1, given, reading)
            if mended is None:
                return None
        return FoundMistake(row=None if row is None else row - 1, name=name, mended=mended)

    def grade(self, part: MistakePart, answer: FoundMistake, context: Context) -> PartReport:
        """Grade place, name and repair, a third each; a repair that works shows the place, too."""
        found: Planted = context.instance.drawn[self.kind]
        key, policy, values = context.reference, as_given(context.policy), context.parameters
        pairs = {(found.row, found.code)}
        if answer.row not in (None, found.row) or answer.name not in (None, found.code):
            verdict = grade(key, found.table, policy, values)
            single = [repair.edits[0] for repair in verdict.repairs if len(repair.edits) == 1]
            pairs |= {(edit.row - 1, REPAIRS.get(edit.code, "")) for edit in single if edit.row is not None}
        mended = answer.mended is not None and (
            _same_links(key.table, answer.mended.table, values)
            or is_accepted(key, answer.mended, policy, values)
        )
        rows = {row for row, _ in pairs}
        here = {name for row, name in pairs if answer.row == row or answer.row not in rows}
        named = answer.name in here - {""} and not (mended and not _changes(found.table, answer))
        return self.report(
            part,
            FoundStep(mended or answer.row in rows, answer.row),
            FoundStep(named, answer.name),
            FoundStep(mended, answer.mended),
        )

    def right(self, part: MistakePart, context: Context) -> FoundMistakeCells:
        """Return the planted mistake and the key's row."""
        found: Planted = context.instance.drawn[self.kind]
        mended = _written_row(context.reference, found.row)
        return FoundMistakeCells(row=found.row + 1, name=found.code, mended=mended)

    def left_as_shown(self, right: FoundMistakeCells, instance: Instance) -> FoundMistakeCells:
        """Return the row as it was."""
        found: Planted = instance.drawn[self.kind]
        return replace(right, mended=_written_row(found.table, found.row))


def _written_row(read: ReadTable, row: int) -> tuple[Cell, Cell, Cell, Cell]:
    cells = written_table(read).rows[row]
    first, second, third, fourth = (getattr(cells, cell) for cell, _ in columns_of(read))
    return first, second, third, fourth


def _mended(
    read: ReadTable, row: int, cells: tuple[Cell, Cell, Cell, Cell], reading: Reading
) -> ReadTable | None:
    """Return the table with one row written anew; faults go to the reading, at the cells of the row."""
    raw = written_table(read)
    names = [cell for cell, _ in columns_of(read)]
    typed: dict[str, Any] = dict(zip(names, cells, strict=True))
    changed = replace(raw.rows[row], joint=None, **typed)
    whole: RawTable = replace(raw, rows=(*raw.rows[:row], changed, *raw.rows[row + 1 :]))
    found = reading.keep(lambda: read_table(whole, reading.limits))
    own = None if found is None else reading.own_table(found)
    placed = [_placed(fault, names) for fault in reading.faults]
    reading.faults[:] = sorted(placed, key=lambda fault: [str(step) for step in fault.where])
    return own


def _changes(shown: ReadTable, answer: FoundMistake) -> bool:
    """Return whether the mended row is another one in each cell that the named mistake is about."""
    assert answer.mended is not None
    assert answer.row is not None
    before, after = shown.table.rows[answer.row], answer.mended.table.rows[answer.row]
    cells = [cell for cell in ("alpha", "a", "d") if cell in (answer.name or "").split("_")]
    return all(
        not _same_angle(before.alpha, after.alpha)
        if cell == "alpha"
        else getattr(before, cell) != getattr(after, cell)
        for cell in cells
    )


def _same_links(key: SymbolicTable, table: SymbolicTable, values: Mapping[str, float]) -> bool:
    """Return whether a table is the key but for full turns and values in the place of names."""
    if (key.convention, len(key.rows)) != (table.convention, len(table.rows)):
        return False
    return all(
        (one.joint, one.sign) == (other.joint, other.sign)
        and all(_same_length(getattr(one, cell), getattr(other, cell), values) for cell in LENGTHS)
        and all(_same_angle(getattr(one, cell), getattr(other, cell)) for cell in ANGLES)
        for one, other in zip(key.rows, table.rows, strict=True)
    )


def _same_length(one: Expression, other: Expression, values: Mapping[str, float]) -> bool:
    if isinstance(one, Parameter) and isinstance(other, Number):
        return values.get(one.name) == float(other.value)
    return one == other


def _same_angle(one: Expression, other: Expression) -> bool:
    a, b = pi_fraction(one), pi_fraction(other)
    return one == other if a is None or b is None else (a - b) % 2 == 0


def _placed(fault: Fault, names: list[str]) -> Fault:
    """Return a fault of a table's cell as one of the mended row."""
    cell = fault.where[-1] if fault.where else ""
    column = (names.index(str(cell)),) if cell in names else ()
    return replace(fault, where=("mended", *column))


PART = FindMistakeType()
