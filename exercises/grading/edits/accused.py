"""Which of the repairs found explains a wrong answer: the likeliest, and what is as good as it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.own_table import is_length_of, is_own_table
from exercises.grading.edits.repaired import Repaired
from exercises.grading.judging.typed import Place
from kinematics.table import CELLS, LENGTHS, NumericRow, NumericTable


def own_table_first(
    repairs: Sequence[Repaired], table: NumericTable, key: NumericTable
) -> tuple[Repaired, ...]:
    """Return the repairs, first those as small as any that make an answer the key's own table.

    Who forgets the key's last fixed row has made that slip, though a sign in the row before it might lead to
    the frame of the tool as well. Where the likeliest repair is two edits, and not both of cells, it stays
    the first, unless in another only signs are wrong, or where it fills a zero and a typed length would do.
    Beside a cell, columns exchanged in its row alone are no other story.
    """
    if repairs and len(repairs[0].changes) > 1:
        repairs = sorted(repairs, key=lambda repaired: not repaired.is_of_signs)
        zeros = _zeros_passed_over(repairs, table)
        repairs = sorted(repairs, key=lambda one: any(zeros & {*edit.places} for edit in one.changes))
    if len(repairs) < 2 or repairs[0].of(table) is None:
        return tuple(repairs)

    def leads_elsewhere(repaired: Repaired) -> bool:
        made = repaired.of(table)
        return len(repaired.changes) > len(repairs[0].changes) or made is None or not is_own_table(made, key)

    def is_of_one_row(repaired: Repaired) -> bool:
        rows = {row for row, *_ in repaired.changes[0].cells}
        return repaired.changes[0].extent is Extent.TABLE and len(rows) == 1 and leads_elsewhere(repaired)

    of_a_cell = len(repairs[0].changes) == 1 and repairs[0].changes[0].extent is Extent.CELL
    told = [one for one in repairs if not (of_a_cell and len(one.changes) == 1 and is_of_one_row(one))]
    return tuple(sorted(told, key=leads_elsewhere))


def _zeros_passed_over(repairs: Sequence[Repaired], table: NumericTable) -> set[Place]:
    """Where an edit of two puts a length before a zero and, beside the other one, a typed length would do."""
    return {
        one.places[0]
        for repaired in repairs
        for one in repaired.changes
        if one.fills_a_zero(table)
        and any(
            other.cell == one.cell and not other.fills_a_zero(table)
            for other in _beside([change for change in repaired.changes if change is not one], repairs)
        )
    }


class Accused(NamedTuple):
    """The changes by which a wrong answer is explained.

    Attributes:
        sure: those of the likeliest repair that the equally good ones make as well.
        alike: besides them one of these is needed, and nobody can say which; none, if there is no choice.
    """

    sure: tuple[Change, ...]
    alike: tuple[Change, ...]

    @property
    def changes(self) -> tuple[Change, ...]:
        """All of them."""
        return self.sure + self.alike


def accused(repairs: Sequence[Repaired], table: NumericTable, key: NumericTable) -> Accused:
    """Return what the likeliest repair and the equally good ones accuse.

    Of two edits of cells one is held while the other is compared with what might stand in its stead: the one
    for which there are most.
    """
    if not repairs:
        return Accused((), ())
    best = repairs[0].changes
    if len(best) == 1:
        alike = _equally_good(
            [repair.changes[0] for repair in repairs if len(repair.changes) == 1], table, key
        )
        return Accused((), alike) if alike else Accused(best, ())
    if repairs[0].of(table) is None:
        return _choice_of_places(repairs)
    choices = [(held, _beside((held,), repairs)) for held in best]
    held, others = max(choices, key=lambda choice: len(choice[1]))
    alike = _equally_good(others, held.of(table), key) if len(others) > 1 else ()
    return Accused((held,), alike) if alike else Accused(best, ())


def _choice_of_places(repairs: Sequence[Repaired]) -> Accused:
    """Of edits of which one is of more than cells those that may stand elsewhere, if all the others are made.

    Of two rows of a wrist nobody can say which one is missing, whatever else is wrong.
    """
    best = repairs[0].changes
    for one in best:
        held = tuple(change for change in best if change is not one)
        alike = tuple(other for other in _beside(held, repairs) if other.code == one.code)
        if one.row is not None and len({other.row for other in alike}) > 1:
            return Accused(held, alike)
    return Accused(best, ())


def _beside(held: Sequence[Change], repairs: Sequence[Repaired]) -> list[Change]:
    """The other edit of those repairs of which all edits but one are these."""
    found = []
    for repair in repairs:
        others = [change for change in repair.changes if not any(map(change.is_nearly, held))]
        if len(others) == len(repair.changes) - len(held) == 1:
            found.append(others[0])
    return found


def _equally_good(singles: Sequence[Change], table: NumericTable, key: NumericTable) -> tuple[Change, ...]:
    """Return the single edits that explain an answer as well as the first and likeliest one, and that one.

    A mirrored arm has one handedness that is wrong, and as many signs that set it right, in one row or in
    several; an offset along parallel axes may be wrong in any of their rows. Edits of a cell are as good as
    one another, and edits of a row; what concerns the table throughout is told as the likeliest alone. A
    length that was typed is likelier wrong than a zero, where with that the frames are the key's own, and
    where it becomes a length of the key and the zero doesn't. An offset is so only in the key's own table to
    the letter: along parallel axes, what is missing in one row makes it any number in another. A variable was
    forgotten, rather than a row left out, where there is a row for every joint; and a row is not needed,
    rather than its variable, where the table does without it, nor that of another, where every row of the
    key has one or the row holds nothing else.
    """
    if singles[0].row is None:
        return ()
    best, is_offset = singles[0], singles[0].cell == "d"
    alike = tuple(change for change in singles if change.extent is best.extent and change.row is not None)
    not_needed = [change.row for change in alike if change.code == "row_extra" and change.row is not None]
    all_move = bool(not_needed) and len(key.rows) == key.n_joints
    one_too_many = all_move or any(_is_of_zeros(table.rows[row]) for row in not_needed)
    alike = tuple(
        one for one in alike if one.code != "joint_moving" or not (one_too_many or one.row in not_needed)
    )
    forgotten = tuple(change for change in alike if change.code == "joint_fixed")
    if forgotten and len(table.rows) >= key.n_joints:
        return forgotten
    typed = tuple(change for change in alike if not change.fills_a_zero(table))
    if best not in typed or len(typed) == len(alike):
        return alike
    if is_own_table(best.of(table), key, either_way=not is_offset):
        return typed
    if not is_offset and any(_is_of_the_key(change, key) for change in typed):
        return tuple(change for change in alike if change in typed or _is_of_the_key(change, key))
    return alike


def _is_of_zeros(row: NumericRow) -> bool:
    return not any(getattr(row, cell) for cell in CELLS)


def _is_of_the_key(change: Change, key: NumericTable) -> bool:
    """Whether an edit of a cell puts a length there that stands in the key, whatever the frames."""
    return any(cell in LENGTHS and is_length_of(key, value) for _, cell, value in change.cells)
