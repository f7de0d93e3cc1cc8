"""Where along the chain a joint may have been left out, or be one too many."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from exercises.grading.edits.scope import FAR
from exercises.grading.edits.work import Work
from kinematics.equivalence import Policy
from kinematics.equivalence.batches import AxisBatch, axes_of_tables
from kinematics.equivalence.measures import Shape, measured
from kinematics.equivalence.meter import per_batch
from kinematics.table import NumericTable


def joint_places(works: Sequence[Work]) -> list[tuple[int, int]]:
    """Return the range of places for the one joint that a table has more or less than the key.

    What lies before the joint must fit as the axes are counted from the base, what lies behind it as they are
    counted from the tool: an edit there moves everything behind it as one. No place will do if the first is
    behind the last.

    Args:
        works: tables for one key, at the same draw, that all have one joint more than it, or all one less.

    Returns:
        For every table the places, counted from 1 among the key's joints or, with one too many, the table's.
    """
    (excess,) = {work.excess for work in works}
    work = works[0]
    invariants = work.invariants
    rows = max(len(work.table.rows) for work in works)
    work.meter.charge(per_batch(2 * len(works), rows, len(invariants.shapes)))
    tables = tuple(work.table for work in works)
    failing = invariants.strains(from_both_ends(invariants.shapes, tables, excess, work.policy)) > 1.0
    first, last = invariants.spans
    before, behind = failing[:, : len(works)], failing[:, len(works) :]
    ends = np.where(before, last, FAR).min(axis=0, initial=FAR)
    starts = np.where(behind, first + (excess > 0), 0).max(axis=0, initial=0)
    return list(zip(starts.tolist(), ends.tolist(), strict=True))


@lru_cache(maxsize=32)
def from_both_ends(
    shapes: tuple[Shape, ...], tables: tuple[NumericTable, ...], excess: int, policy: Policy
) -> NDArray[np.float64]:
    """Return (q, 2k) invariants of the key in tables with one joint more or less: from base, then from tool.

    Remembered, for what is left of the answer is seen in the same numbers.
    """
    axes = axes_of_tables(tables, [(number, ()) for number in range(len(tables))], policy)
    return measured(shapes, _counted_from_both_ends(axes, excess))


def _counted_from_both_ends(axes: AxisBatch, excess: int) -> AxisBatch:
    """As many axes as the key has: (…, 2k), first counted from the base, then counted from the tool."""
    tool = len(axes.points) - 1
    joints, missing, spare = list(range(1, tool)), [0] * max(-excess, 0), max(excess, 0)
    from_base = [0, *joints[: len(joints) - spare], *missing, tool]
    from_tool = [0, *missing, *joints[spare:], tool]
    return AxisBatch(*(_side_by_side(part, from_base, from_tool) for part in axes))


def _side_by_side(part: NDArray[np.float64], one: list[int], other: list[int]) -> NDArray[np.float64]:
    return np.concatenate((part[one], part[other]), axis=2)
