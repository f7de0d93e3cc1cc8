"""A misconception undone in a table: how much it spoiled, where, and the table that it leads to."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from enum import Enum
from typing import NamedTuple

from exercises.grading.judging.typed import SAME, Place
from exercises.grading.verdict import Edit, ParamValue
from kinematics.equivalence.batches import CellChange
from kinematics.table import LENGTHS, DHRow, DHTable, JointType, NumericRow, NumericTable

_OF_JOINTS = frozenset({"row_missing", "row_extra", "joint_fixed", "joint_moving", "joint_type"})
ROW_CELLS = ("alpha", "a", "d", "joint")


class Extent(Enum):
    """How much of a table a misconception spoils, as a share of the rows."""

    CELL = 0.5
    ROW = 1.0
    TABLE = 1.5


class TableSlip(NamedTuple):
    """What a student did wrong, whatever numbers stand in the table.

    Attributes:
        row: the row that it concerns, counted from 0, if it is one.
        cell: the cell, if it is one.
        code: the misconception; none where it is told by what stands in the cell.
        params: values for the sentence.
    """

    row: int | None
    cell: str | None
    code: str | None = None
    params: tuple[tuple[str, ParamValue], ...] = ()


class Change(NamedTuple):
    """A misconception undone in one place of a table.

    Attributes:
        code: the misconception, as it is told.
        extent: how much it spoiled.
        row: the row that it concerns, counted from 0, if it is one.
        cell: the cell, if it is one.
        cells: what stands in which cells afterwards.
        table: what they are changed in, if it is no longer the table itself.
        touched: the places that it changes, if not just that row or cell.
        params: values for the sentence.
        unsolved: cells of the row that may be given values that fit.
    """

    code: str
    extent: Extent
    row: int | None = None
    cell: str | None = None
    cells: tuple[CellChange, ...] = ()
    table: NumericTable | None = None
    touched: tuple[Place, ...] = ()
    params: tuple[tuple[str, ParamValue], ...] = ()
    unsolved: tuple[str, ...] = ()

    @property
    def places(self) -> tuple[Place, ...]:
        """The rows, counted from 0, and cells that it changes."""
        if self.touched or self.row is None:
            return self.touched
        return ((self.row, self.cell),) if self.cell else tuple((self.row, name) for name in ROW_CELLS)

    @property
    def edit(self) -> Edit:
        """What to tell; rows are counted from 1 there."""
        params: dict[str, ParamValue] = dict(self.params)
        if self.row is not None:
            params.setdefault("row", self.row + 1)
        return Edit(
            code=self.code, row=None if self.row is None else self.row + 1, cell=self.cell, params=params
        )

    @property
    def slip(self) -> TableSlip:
        """What is the same at every draw: the cell; or the misconception and where."""
        if self.extent is Extent.CELL and self.row is not None:
            return TableSlip(self.row, self.cell)
        return TableSlip(self.row, self.cell, self.code, self.params)

    def is_nearly(self, other: Change) -> bool:
        """Return whether it puts the same values in the same cells, but for rounding errors."""
        same = [(row, cell) for row, cell, _ in self.cells] == [(row, cell) for row, cell, _ in other.cells]
        pairs = zip(self.cells, other.cells, strict=same)
        return (
            same
            and self.slip == other.slip
            and all(math.isclose(one[2], two[2], rel_tol=SAME, abs_tol=SAME) for one, two in pairs)
        )

    def fills_a_zero(self, table: NumericTable) -> bool:
        """Return whether it puts a length where none was typed; a typed one is likelier wrong."""
        if self.extent is not Extent.CELL or self.row is None or self.cell not in LENGTHS:
            return False
        return self.row < len(table.rows) and getattr(table.rows[self.row], self.cell) == 0.0

    def of(self, table: NumericTable) -> NumericTable:
        """Return the table that a table becomes."""
        found = table if self.table is None else self.table
        changed: dict[int, dict[str, float]] = {}
        for row, cell, value in self.cells:
            changed.setdefault(row, {})[cell] = value
        if not changed:
            return found
        rows = list(found.rows)
        for row, values in changed.items():
            rows[row] = _with_cells(rows[row], values)
        return with_rows(found, rows)


def after(first: Change, second: Change) -> Change:
    """Return a second change as it concerns the answer, of which the first one may have moved the rows.

    Args:
        first: the change made before.
        second: a change of the table that the first one led to.
    """

    def origin(row: int) -> int:
        place = first.row
        if place is None:
            return row
        if first.code in ("row_missing", "fixed_row_missing"):
            return row - 1 if row > place else row
        if first.code == "row_extra":
            return row + 1 if row >= place else row
        if first.code == "rows_swapped":
            swapped = tuple(dict.fromkeys(row for row, _ in first.places))
            return dict(zip(swapped, swapped[::-1], strict=True)).get(row, row)
        return row

    def number(name: str, value: ParamValue) -> ParamValue:
        moves = name in ("other", "place") or (name == "after" and value)
        return origin(value - 1) + 1 if moves and isinstance(value, int) else value

    return second._replace(
        row=None if second.row is None else origin(second.row),
        touched=tuple((origin(row), cell) for row, cell in second.places),
        params=tuple((name, number(name, value)) for name, value in second.params),
    )


def with_joints_mended(
    table: NumericTable, changes: Iterable[Change], wanted: Sequence[JointType]
) -> NumericTable:
    """Return a table with the joints that changes give it, and with cells as they are: zeros in a new row.

    Args:
        table: the answer.
        changes: of the answer, by their rows, which are those of the answer.
        wanted: the types of the key's joints.
    """
    rows = list(table.rows)
    shift = 0
    for change in changes:
        if change.row is None or change.code not in _OF_JOINTS:
            continue
        place = change.row + shift
        if change.code == "row_extra":
            del rows[place]
            shift -= 1
            continue
        if change.code == "row_missing":
            rows.insert(place, DHRow(joint=JointType.FIXED, theta=0.0, d=0.0, a=0.0, alpha=0.0))
            shift += 1
        joint = sum(row.joint is not JointType.FIXED for row in rows[:place])
        moves = change.code != "joint_moving" and joint < len(wanted)
        rows[place] = replace(rows[place], joint=wanted[joint] if moves else JointType.FIXED)
    return with_rows(table, rows)


def _with_cells(row: NumericRow, values: Mapping[str, float]) -> NumericRow:
    """Return a row with some cells changed: what `replace` does, at a third of its cost."""
    of = values.get
    return DHRow(
        joint=row.joint,
        theta=of("theta", row.theta),
        d=of("d", row.d),
        a=of("a", row.a),
        alpha=of("alpha", row.alpha),
        sign=row.sign,
    )


def with_row(table: NumericTable, index: int, row: NumericRow) -> NumericTable:
    """Return the table with one row exchanged."""
    rows = table.rows
    return DHTable(convention=table.convention, rows=(*rows[:index], row, *rows[index + 1 :]))


def with_rows(table: NumericTable, rows: Iterable[NumericRow]) -> NumericTable:
    """Return a table of the same convention with these rows."""
    return DHTable(convention=table.convention, rows=tuple(rows))
