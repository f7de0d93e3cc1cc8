"""What is wrong throughout a table beside many other mistakes: its units, or that its digits are too few.

No search could try all the others with it. But if several facts become right by it, that is evidence enough.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.table_edits import all_in_degrees, all_in_other_length_unit, all_in_radians
from exercises.grading.edits.work import LENGTHS, Work
from exercises.grading.facts import Facts, fixed_ends
from exercises.grading.judging.comparison import Comparison
from exercises.grading.judging.digits import PER_CENT
from exercises.grading.judging.judgement import share_of
from exercises.grading.judging.typed import SAME, says_enough
from kinematics.chain import chain_of_table
from kinematics.equivalence.invariants import axes_of
from kinematics.table import NumericTable

ROUNDED = "lengths_rounded"
LEAST_FACTS = 2
"""So many facts become right by one change only if what it undoes was done; one may do so by chance."""
FAR_APART = 500.0
"""No length is wrong by so much but for its unit, so that one fact is enough: metres for millimetres."""


class Throughout(NamedTuple):
    """A change of the whole table, and the answer as it is then compared."""

    change: Change
    comparison: Comparison


def seen_throughout(work: Work) -> Throughout | None:
    """Return the change throughout that brings most facts of an answer in numbers right, if it is several."""
    if len(work.comparison.drawn) > 1 or not work.has_the_joints():
        return None
    ways = (all_in_degrees, all_in_radians, all_in_other_length_unit, lengths_rounded)
    changes = [change for way in ways for change in way(work)]
    right = [_facts_right(work, change.of(work.table)) for change in changes]
    more = max(right, default=0) - _facts_right(work, work.table)
    if more < 1:
        return None
    change = changes[right.index(max(right))]
    row, cell, value = change.cells[0]
    ratio = value / getattr(work.table.rows[row], cell)
    is_telling = more >= LEAST_FACTS or (cell in LENGTHS and not 1.0 / FAR_APART < ratio < FAR_APART)
    return Throughout(change, _undone(work.comparison, change)) if is_telling else None


def _facts_right(work: Work, table: NumericTable) -> int:
    """How many facts a table has, but for signs."""
    key, known = axes_of(work.reference.chain, work.policy), work.facts
    facts = Facts(key, known, fixed_ends(len(key), work.policy), np.ones(len(known.shapes)), sign=1.0)
    return int(facts.shared(axes_of(chain_of_table(table), work.policy)).sum())


def lengths_rounded(work: Work) -> Iterator[Change]:
    """Give lengths that were rounded to too few digits all those of the key's."""
    lengths = {abs(length) for row in work.reference.table.rows for length in (row.a, row.d)} - {0.0}
    cells = []
    for (i, cell), step in work.comparison.steps.items():
        here = getattr(work.table.rows[i], cell)
        if cell in LENGTHS and says_enough(step, here) and lengths:
            nearest = min(lengths, key=lambda length: abs(length - abs(here)))
            if PER_CENT * nearest < abs(nearest - abs(here)) <= step * (1.0 + SAME):
                cells.append((i, cell, math.copysign(nearest, here)))
    if len(cells) > 1 and share_of(work.comparison):
        yield Change(ROUNDED, Extent.TABLE, cells=tuple(cells))


def _undone(comparison: Comparison, change: Change) -> Comparison:
    """The comparison with a change made; digits are as exact as they were, in the other unit."""
    (drawn,) = comparison.drawn
    table, steps = change.of(drawn.meant), dict(comparison.steps)
    for row, cell, value in change.cells:
        if (row, cell) in steps and change.code != ROUNDED:
            steps[row, cell] *= abs(value / getattr(drawn.meant.rows[row], cell))
        elif change.code == ROUNDED:
            del steps[row, cell]
    one = drawn._replace(submission=table, meant=table)
    return replace(comparison, drawn=(one,), steps=steps, typed_steps=steps)
