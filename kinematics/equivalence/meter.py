"""Work counted, not timed: a search that is bounded so ends at the same point on every machine."""

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass

# What the steps cost, in units of about a microsecond of the processor on which they were measured (2026);
# only their ratios matter for what a bound means.
PER_ROW = 3
PER_ALIGNMENT = 60
PER_CERTIFICATE = 150
PER_FURTHER_JOINT = 30
USUAL_JOINTS = 7  # a certificate of so many or fewer costs the same
PER_ROUND = 1500
PER_DESCENT = 3000
PER_BATCH = 400
PER_TABLE = 4
ROWS_TOGETHER = 16  # rows of a batch that cost one unit
OVERDRAFT = 20_000
"""What one step may cost beyond what is left: more than any step on a table with the rows of a robot."""
# No robot needs more rows. Arrays of longer tables outgrow the processor's cache, and every row has edits.
MOST_ROWS_OF_A_ROBOT = 16
FURTHER_ROWS_TOGETHER = 2


def per_batch(tables: int, rows: int, invariants: int) -> int:
    """Return what it costs to try tables all at once, with so many rows and invariants each."""
    further = max(rows - MOST_ROWS_OF_A_ROBOT, 0) // FURTHER_ROWS_TOGETHER
    return PER_BATCH + tables * (PER_TABLE + further) + tables * (rows + invariants) // ROWS_TOGETHER


def per_certificate(joints: int) -> int:
    """Return what it costs to make a certificate of an arm and to look at it."""
    return PER_CERTIFICATE + PER_FURTHER_JOINT * max(joints - USUAL_JOINTS, 0)


class WorkExhaustedError(Exception):
    """The work that was granted is used up."""


@dataclass(slots=True)
class Meter:
    """Counts the work of a search down.

    Attributes:
        left: units that may still be spent.
        ran_out: a step was ended, or the search: with more to spend, other things might be found.
    """

    left: int
    ran_out: bool = False

    def charge(self, units: int) -> None:
        """Spend some units.

        Raises:
            WorkExhaustedError: none are left, or far too few for so large a step.
        """
        if self.left <= 0 or units > self.left + OVERDRAFT:
            self.ran_out = True
            raise WorkExhaustedError
        self.left -= units

    @contextmanager
    def at_most(self, units: int) -> Iterator[None]:
        """Let a step spend no more than some units; it ends where they are used up, and the rest goes on."""
        reserved = max(self.left - units, 0)
        self.left -= reserved
        try:
            with suppress(WorkExhaustedError):
                yield
        finally:
            self.left = max(self.left, 0) + reserved
