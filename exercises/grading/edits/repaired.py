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
    """Return repairs without those that say more than cells which would do as well."""
    return [one for one in repairs if len(one.changes) == 1 or not _says_more_than_a_cell(one, repairs)]


def _says_more_than_a_cell(repaired: Repaired, repairs: Sequence[Repaired]) -> bool:
    """Whether two edits say more than cells that would do as well.

    Of an exchange within a row, what stands in the other cell may be anything, or is wrong by itself. A slip
    throughout the table beside a row that was left out is none where two cells are all that is wrong.
    """
    rows = {one.row for one in repaired.changes if one.code == "a_d_swapped"}
    throughout = any(one.row is None for one in repaired.changes)
    of_cells = any(one.extent is Extent.CELL for one in repaired.changes)
    return (bool(rows) or (throughout and not of_cells)) and any(
        all(change.extent is Extent.CELL for change in other.changes)
        and rows <= {change.row for change in other.changes}
        for other in repairs
    )
