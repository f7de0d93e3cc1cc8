"""What several equally small repairs have in common, where none is likelier than the others."""

from collections.abc import Sequence

from exercises.grading.verdict import Feedback, Repair


def in_common(repairs: Sequence[Repair]) -> Feedback | None:
    """Return what the smallest repairs share: a cell, a row, a column or the misconception; None if nothing.

    Two or more repairs are asked for: a single one is told by itself.
    """
    least = min((len(repair.edits) for repair in repairs), default=0)
    smallest = [repair for repair in repairs if len(repair.edits) == least]
    if len(smallest) < 2:
        return None
    edits = [edit for repair in smallest for edit in repair.edits]
    rows = {edit.row for edit in edits}
    cells = {edit.cell for edit in edits}
    codes = {edit.code for edit in edits}
    row, cell = next(iter(rows)), next(iter(cells))
    one_row = len(rows) == 1 and row is not None
    one_cell = len(cells) == 1 and cell is not None
    if one_row and one_cell:
        return Feedback(code="repairs_one_cell", row=row, params={"cell": cell or ""})
    if one_row:
        return Feedback(code="repairs_one_row", row=row)
    if one_cell:
        return Feedback(code="repairs_one_column", params={"cell": cell or ""})
    if len(codes) == 1:
        return Feedback(code="repairs_one_kind", params={"count": len(smallest)})
    return None
