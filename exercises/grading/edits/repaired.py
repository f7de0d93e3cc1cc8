"""Edits that together make a table right."""

from collections.abc import Sequence
from dataclasses import dataclass

from exercises.grading.edits.changes import Change, Extent
from kinematics.table import NumericTable


@dataclass(frozen=True, slots=True)
class Repaired:
    """Changes that together make the table right."""

    changes: tuple[Change, ...]

    @property
    def is_of_signs(self) -> bool:
        """Whether nothing is changed but signs."""
        return all(change.code.endswith(("_sign", "_all_reversed")) for change in self.changes)

    def of(self, table: NumericTable) -> NumericTable | None:
        """Return the table that a table becomes; None where one of two edits is of more than cells."""
        if len(self.changes) > 1 and any(change.table is not None for change in self.changes):
            return None
        for change in self.changes:
            table = change.of(table)
        return table


def without_exchanges(repairs: Sequence[Repaired]) -> list[Repaired]:
    """Return repairs without those that exchange two cells of a row where one of these alone would do."""
    return [one for one in repairs if len(one.changes) == 1 or not _says_more_than_a_cell(one, repairs)]


def _says_more_than_a_cell(repaired: Repaired, repairs: Sequence[Repaired]) -> bool:
    """Whether one of two edits is an exchange within a row, of which one cell would do as well.

    What stands in the other cell of the row may be anything, or is wrong by itself.
    """
    rows = {one.row for one in repaired.changes if one.code == "a_d_swapped"}
    return bool(rows) and any(
        all(change.extent is Extent.CELL for change in other.changes)
        and rows <= {change.row for change in other.changes}
        for other in repairs
    )
