"""A wrong answer on the workbench: what an edit is tried on, and what it is tried against."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import TypeAlias

from exercises.grading.comparison import Comparison
from exercises.grading.verdict import Edit, ParamValue
from kinematics.cells import ReadTable
from kinematics.chain import Axis, chain_of_table
from kinematics.equivalence import Policy
from kinematics.equivalence.decision import certify, convention_fits
from kinematics.equivalence.invariants import Invariant, axes_of
from kinematics.equivalence.meter import PER_INVARIANT, PER_ROW, Meter
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.search import Effort
from kinematics.table import DHTable, NumericRow, NumericTable

WORK_OF_ONE_EDIT = 30_000
"""What deciding whether one edit mends the table may cost: no single one uses up the search."""
REACH_OF_A_ROW = 1
"""Two rows exchanged, the widest of the edits in a row, change the links before, between and after them."""
Apply: TypeAlias = Callable[[NumericTable, int], Iterable[NumericTable]]
"""From a table and the number of the parameter draw to the tables that the edit may lead to; mostly one."""


class Extent(Enum):
    """How much of a table a misconception spoils, as a share of the rows."""

    CELL = 0.5
    ROW = 1.0
    TABLE = 1.5


@dataclass(frozen=True, kw_only=True, slots=True)
class Change:
    """A misconception undone in one place.

    Attributes:
        edit: what to tell.
        apply: the edit itself.
        extent: how much it spoiled.
        touched: the rows (counted from 0) and cells that it changes.
        rank: place of the misconception in the catalogue; the earlier, the likelier.
    """

    edit: Edit
    apply: Apply
    extent: Extent
    touched: tuple[tuple[int, str], ...]
    rank: int = 0


@dataclass(frozen=True, kw_only=True, eq=False)
class Work:
    """The tables that edits are tried on.

    Attributes:
        key: the key as read.
        answer: the answer as read.
        comparison: both with numbers.
        policy: what the answer is held to.
        tables: the answer at each draw, as it was meant, perhaps with an edit made already.
        references: the key at each draw, prepared; at the answer's size, if it has none.
        invariants: what no choice of frames changes, at each draw, as nearly as the answer must have it.
        meter: counts what trying edits costs.
    """

    key: ReadTable
    answer: ReadTable
    comparison: Comparison
    policy: Policy
    tables: tuple[NumericTable, ...]
    references: tuple[Reference, ...]
    invariants: tuple[tuple[Invariant, ...], ...]
    meter: Meter

    def axes(self, table: NumericTable) -> list[Axis]:
        """The axes that the invariants are measured between."""
        self.meter.charge(PER_ROW * len(table.rows))
        return axes_of(chain_of_table(table), self.policy)

    def failing(self, table: NumericTable, draw: int = 0) -> int | None:
        """How many invariants a table does not share with the key; None if its joints are others already."""
        if table.joint_types != self.references[draw].table.joint_types:
            return None
        axes = self.axes(table)
        self.meter.charge(PER_INVARIANT * len(self.invariants[draw]))
        return sum(not invariant.fits(axes) for invariant in self.invariants[draw])

    def one_edit_might_mend(self, table: NumericTable, draw: int = 0) -> bool:
        """Whether all invariants that a table does not share with the key meet at one place of the chain.

        An edit in a row changes how the axes before it lie to those after it; what it leaves alone, it cannot
        mend.
        """
        if table.joint_types != self.references[draw].table.joint_types:
            return True
        axes = self.axes(table)
        self.meter.charge(PER_INVARIANT * len(self.invariants[draw]))
        failing = [invariant.axes for invariant in self.invariants[draw] if not invariant.fits(axes)]
        first, last = max(map(min, failing), default=0), min(map(max, failing), default=0)
        return first - last <= REACH_OF_A_ROW

    def accepts(self, table: NumericTable, draw: int, effort: Effort) -> bool:
        """Whether a table is right, at one draw."""
        if not convention_fits(table.convention, self.policy.convention):
            return False
        self.meter.charge(PER_ROW * len(table.rows))
        chain = chain_of_table(table)
        with self.meter.at_most(WORK_OF_ONE_EDIT):
            return certify((self.references[draw],), (chain,), self.policy, effort, self.meter) is not None
        return False


def change(
    code: str,
    apply: Apply,
    *,
    extent: Extent,
    row: int | None = None,
    cell: str | None = None,
    touched: Sequence[tuple[int, str]] = (),
    params: Mapping[str, ParamValue] | None = None,
) -> Change:
    """A change; rows counted from 0 here, and from 1 in what is told."""
    if not touched and row is not None:
        touched = ((row, cell),) if cell else tuple((row, name) for name in ("alpha", "a", "d", "joint"))
    shown: dict[str, ParamValue] = dict(params or {})
    if row is not None:
        shown.setdefault("row", row + 1)
    edit = Edit(code=code, row=None if row is None else row + 1, cell=cell, params=shown)
    return Change(edit=edit, apply=apply, extent=extent, touched=tuple(touched))


def after(first: Change, second: Change) -> Change:
    """A second change as it concerns the answer, of which the first one may have moved the rows.

    Args:
        first: the change made before.
        second: a change of the table that the first one led to.
    """

    def origin(row: int) -> int:
        place = first.touched[0][0] if first.touched else 0
        if first.edit.code in ("row_missing", "fixed_row_missing"):
            return row - 1 if row > place else row
        if first.edit.code == "row_extra":
            return row + 1 if row >= place else row
        if first.edit.code == "rows_swapped":
            swapped = tuple(dict.fromkeys(row for row, _ in first.touched))
            return dict(zip(swapped, swapped[::-1], strict=True)).get(row, row)
        return row

    params = dict(second.edit.params)
    for name in ("row", "other", "place"):
        if isinstance(number := params.get(name), int):
            params[name] = origin(number - 1) + 1
    if isinstance(number := params.get("after"), int) and number:
        params["after"] = origin(number - 1) + 1
    row = None if second.edit.row is None else origin(second.edit.row - 1) + 1
    return replace(
        second,
        edit=replace(second.edit, row=row, params=params),
        touched=tuple((origin(row), cell) for row, cell in second.touched),
    )


def with_row(table: NumericTable, index: int, row: NumericRow) -> NumericTable:
    """The table with one row exchanged."""
    rows = table.rows
    return DHTable(convention=table.convention, rows=(*rows[:index], row, *rows[index + 1 :]))


def with_cell(table: NumericTable, index: int, cell: str, value: float) -> NumericTable:
    """The table with one cell exchanged."""
    return with_row(table, index, replace(table.rows[index], **{cell: value}))  # type: ignore[arg-type]


def with_rows(table: NumericTable, rows: Iterable[NumericRow]) -> NumericTable:
    """A table of the same convention with these rows."""
    return DHTable(convention=table.convention, rows=tuple(rows))
