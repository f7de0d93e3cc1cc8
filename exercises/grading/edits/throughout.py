"""What is wrong throughout a table beside many other mistakes: its units, or that its digits are too few.

No search could try all the others with it. But if several facts become right by it, or several entries become
the key's, that is evidence enough.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from exercises.grading.axis_directions import fixed_ends
from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.own_table import is_length_of
from exercises.grading.edits.table_edits import all_in_degrees, all_in_other_length_unit, all_in_radians
from exercises.grading.edits.work import Work
from exercises.grading.facts import Facts
from exercises.grading.judging.comparison import Comparison
from exercises.grading.judging.digits import PER_CENT
from exercises.grading.judging.judgement import share_of
from exercises.grading.judging.typed import SAME, says_enough
from kinematics.chain import chain_of_table
from kinematics.equivalence.batches import CellChange
from kinematics.equivalence.invariants import axes_of
from kinematics.table import LENGTHS, NumericTable

ROUNDED = "lengths_rounded"
LEAST = 2
"""So many facts or entries become right by one change only if it undoes what was done; one may by chance."""
FAR_APART = 500.0
"""No length is wrong by so much but for its unit, so that one is enough: metres for millimetres."""


class Throughout(NamedTuple):
    """A change of the whole table, and the answer as it is then compared."""

    change: Change
    comparison: Comparison


def seen_throughout(work: Work) -> Throughout | None:
    """Return the change throughout that brings most of an answer right, if that is several.

    Facts are counted; where it brings none right, or the joints are not the key's, entries.
    """
    named = {place for place, *_ in work.comparison.named_entries}
    ways = (all_in_degrees, all_in_radians, all_in_other_length_unit, lengths_rounded)
    changes = [change for way in ways for change in way(work)]
    changes = [change for change in changes if named.isdisjoint((row, cell) for row, cell, _ in change.cells)]
    more = [0]
    if work.has_the_joints():
        known = _facts_right(work, work.table)
        more = [_facts_right(work, change.of(work.table)) - known for change in changes]
    if max(more, default=0) < 1:
        more = [_entries_right(work, change) for change in changes]
    if max(more, default=0) < 1:
        return None
    change = changes[more.index(max(more))]
    row, cell, value = change.cells[0]
    ratio = value / getattr(work.table.rows[row], cell)
    is_telling = max(more) >= LEAST or (cell in LENGTHS and not 1.0 / FAR_APART < ratio < FAR_APART)
    return Throughout(change, _undone(work.comparison, change)) if is_telling else None


def _entries_right(work: Work, change: Change) -> int:
    """How many more lengths and twists stand in the key after a change of their unit."""
    key = work.reference.table

    def is_of_key(cell: str, value: float) -> bool:
        if cell in LENGTHS:
            return is_length_of(key, value)
        return cell == "alpha" and any(
            row.alpha and abs(abs(value) - abs(row.alpha)) <= PER_CENT * abs(row.alpha) for row in key.rows
        )

    before = ((cell, getattr(work.table.rows[row], cell)) for row, cell, _ in change.cells)
    after = ((cell, value) for _, cell, value in change.cells)
    counted = () if change.code == ROUNDED else change.cells
    return len(counted) and sum(is_of_key(*one) for one in after) - sum(is_of_key(*one) for one in before)


def _facts_right(work: Work, table: NumericTable) -> int:
    """How many facts a table has, but for signs."""
    key, known = axes_of(work.reference.chain, work.policy), work.facts
    facts = Facts(key, known, fixed_ends(len(key), work.policy), np.ones(len(known.shapes)), sign=1.0)
    return int(facts.shared(axes_of(chain_of_table(table), work.policy)).sum())


def lengths_rounded(work: Work) -> Iterator[Change]:
    """Give lengths that were rounded to too few digits all those of the key's."""
    cells = _rounded_lengths(work, PER_CENT)
    if len(cells) > 1 and share_of(work.comparison):
        yield Change(ROUNDED, Extent.TABLE, cells=cells)


def _rounded_lengths(work: Work, share: float) -> tuple[CellChange, ...]:
    """Lengths of the key that typed ones are within their digits, if these are off by more than a share."""
    lengths = {abs(length) for row in work.reference.table.rows for length in (row.a, row.d)} - {0.0}
    cells = []
    for (i, cell), step in work.comparison.steps.items() if lengths else ():
        here = getattr(work.table.rows[i], cell)
        if cell in LENGTHS and says_enough(step, here):
            nearest = min(lengths, key=lambda length: abs(length - abs(here)))
            if share * nearest < abs(nearest - abs(here)) <= step * (1.0 + SAME):
                cells.append((i, cell, math.copysign(nearest, here)))
    return tuple(cells)


def as_the_key_has_them(work: Work) -> Comparison | None:
    """Return the answer with the key's lengths for those that they are within their digits; None if none."""
    cells = _rounded_lengths(work, SAME)
    return _undone(work.comparison, Change(ROUNDED, Extent.TABLE, cells=cells)) if cells else None


def _undone(comparison: Comparison, change: Change) -> Comparison:
    """The comparison with a change made; digits are as exact as they were, in the other unit."""
    drawn = tuple(
        one._replace(submission=table, meant=table)
        for one in comparison.drawn
        for table in [change.of(one.meant)]
    )
    steps = dict(comparison.steps)
    for row, cell, value in change.cells:
        if (row, cell) in steps and change.code != ROUNDED:
            steps[row, cell] *= abs(value / getattr(comparison.meant[0].rows[row], cell))
        elif change.code == ROUNDED:
            del steps[row, cell]
    return replace(comparison, drawn=drawn, steps=steps, typed_steps=steps)
