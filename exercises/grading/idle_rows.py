"""An answer without fixed rows of zeros, which change nothing, and what was said of it in its own rows."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from exercises.grading.explanation import Explanation
from exercises.grading.verdict import Edit, Feedback, ParamValue, Repair
from kinematics.cells import ReadTable
from kinematics.expressions import ZERO
from kinematics.table import CELLS, DHTable, JointType

_ROW_PARAMS = ("row", "other", "place")


def without_idle_rows(read: ReadTable, but: Collection[int] = ()) -> tuple[ReadTable, tuple[int, ...]]:
    """Return a table without the fixed rows of zeros, which change nothing, and the rows that are left.

    Args:
        read: the table.
        but: rows that stay nevertheless, from 0.

    Returns:
        The table, with at least one row, and the number of each of its rows in the original, from 0.
    """
    rows = read.table.rows
    kept = tuple(
        i
        for i, row in enumerate(rows)
        if row.joint is not JointType.FIXED or i in but or any(getattr(row, cell) != ZERO for cell in CELLS)
    ) or (0,)
    if len(kept) == len(rows):
        return read, kept
    table = DHTable(convention=read.table.convention, rows=tuple(rows[i] for i in kept))
    number = {old: new for new, old in enumerate(kept)}
    places = {(number[i], cell): unit for (i, cell), unit in read.last_places.items() if i in number}
    return replace(read, table=table, last_places=places), kept


def renumbered(told: Explanation, kept: Sequence[int], rows: int) -> Explanation:
    """Return what was said of a table without its idle rows, in the numbers of the whole table.

    Args:
        told: what was said.
        kept: the number of each row in the whole table, from 0.
        rows: how many rows that has.
    """
    if len(kept) == rows:
        return told

    def number(row: int) -> int:
        return kept[row - 1] + 1 if row <= len(kept) else rows + row - len(kept)

    def params(given: Mapping[str, ParamValue]) -> dict[str, ParamValue]:
        changed = {name: number(value) for name in _ROW_PARAMS if isinstance(value := given.get(name), int)}
        if isinstance(after := given.get("after"), int) and after > 0:
            changed["after"] = number(after)
        return {**given, **changed}

    def of(entry: Feedback | Edit) -> dict[str, object]:
        row = None if entry.row is None else number(entry.row)
        return {"row": row, "params": params(entry.params)}

    return replace(
        told,
        links=tuple(replace(link, row=number(link.row)) for link in told.links),
        feedback=tuple(replace(entry, **of(entry)) for entry in told.feedback),  # type: ignore[arg-type]
        repairs=tuple(
            Repair(edits=tuple(replace(edit, **of(edit)) for edit in repair.edits))  # type: ignore[arg-type]
            for repair in told.repairs
        ),
    )
