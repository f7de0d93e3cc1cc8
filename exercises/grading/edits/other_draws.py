"""An edit at another draw: the same cells, with what is there what the new values are here."""

from typing import TypeAlias

import numpy as np

from exercises.grading.edits.changes import Change
from exercises.grading.judging.typed import SAME
from kinematics.equivalence.batches import CellChange
from kinematics.se3 import Floats
from kinematics.table import ANGLES, LENGTHS, NumericTable

Draws: TypeAlias = tuple[NumericTable, NumericTable]  # A table at two draws.


def alike_at(change: Change, own: Draws, keys: Draws) -> Change | None:
    """Return a change of cells as it is at another draw: an entry of the answer or the key stays that entry.

    So does the sum of two lengths. Another angle is itself; of another length, None. `own` is the table that
    it is made in.
    """
    if change.table is not None:
        return None
    cells: list[CellChange] = []
    for row, cell, value in change.cells:
        there = _elsewhere(value, own, keys, row, cell) if value else 0.0
        if there is None and cell in LENGTHS:
            return None
        cells.append((row, cell, value if there is None else there))
    return change._replace(cells=tuple(cells))


def _elsewhere(value: float, own: Draws, keys: Draws, row: int, cell: str) -> float | None:
    """What a new value of a cell is at the other draw; None if it is no entry of the answer or the key.

    A length may be the sum or the difference of two as well: an offset that makes up for another.
    """
    kinds = LENGTHS if cell in LENGTHS else ANGLES
    entries = [(getattr(own[0].rows[row], cell), getattr(own[1].rows[row], cell))]
    entries += [
        (getattr(mine, kind), getattr(its, kind))
        for one, other in (keys, own)
        for mine, its in zip(one.rows, other.rows, strict=True)
        for kind in kinds
    ]
    known = np.array(list(dict.fromkeys(pair for pair in entries if pair[0]))).reshape(-1, 2)
    there = _scaled(value, known)
    if there is None and cell in LENGTHS:
        first, second = np.triu_indices(len(known), 1)
        there = _scaled(value, np.concatenate((known[first] + known[second], known[first] - known[second])))
    return there


def _scaled(value: float, pairs: Floats) -> float | None:
    """Return the second of the first pair (k, 2) whose first one the value is, with the value's sign."""
    sizes = np.abs(pairs[:, 0])
    (found,) = np.nonzero((sizes > 0.0) & (np.abs(abs(value) - sizes) <= SAME * sizes))
    return float(pairs[found[0], 1] * value / pairs[found[0], 0]) if found.size else None
