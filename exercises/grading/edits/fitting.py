"""The values of one cell with which a table would share an invariant of the key.

In a length cell the square of every invariant length is a quadratic polynomial, in an angle cell the cosine
between two axes is A + B cos x + C sin x: three evaluations give the function, and it is solved in closed
form. All cells of all tables are evaluated at once.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from exercises.grading.edits.work import Work
from exercises.grading.judging.typed import SAME, Place
from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy
from kinematics.equivalence.batches import CellChange, Variation
from kinematics.equivalence.cell_fitting import fitted_cells
from kinematics.equivalence.diagnosis import likely_signs
from kinematics.equivalence.invariants import Invariants
from kinematics.equivalence.measures import Measure
from kinematics.equivalence.meter import PER_ALIGNMENT, per_batch
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.row_measures import measured_of_tables
from kinematics.se3 import cross, dot, subtract
from kinematics.table import ANGLES, VARIABLE_CELLS, NumericTable

INFLUENCE = 1e-6  # A cell that changes an invariant by a smaller share has nothing to do with it.
OFF = 0.1  # In units of an invariant’s slack: what is off by less needs no mending.
MOST_STRAINED = 4  # Invariants that are solved for: a cell shows in the worst of them if in any.
MOST_SIGNS = 4  # Choices of the axes’ directions that are tried, the best first.
DISTANT = 2.0
"""Parts of the robot's size: from farther off than this, squares of lengths lose what they differ by."""
THIRD = math.tau / 3.0  # [rad] Three evaluations round the circle give A + B cos x + C sin x.
SMALL_TURN = 1e-3  # [rad] By how much a turn about a prismatic joint is tried to change.


class Unsolved(NamedTuple):
    """A table, and the cells for which values are wanted that fit.

    Attributes:
        number: the table's number among those at hand.
        cells: what has been changed in it.
        places: the cells to be solved for, each by itself.
    """

    number: int
    cells: tuple[CellChange, ...]
    places: Sequence[Place]


def measured(
    work: Work,
    tables: Sequence[NumericTable],
    variations: Sequence[Variation],
    angles_alone: Sequence[int] = (),
) -> NDArray[np.float64]:
    """Return (q, k) the invariants of tables in which some cells are changed; see `measured_of_tables`."""
    invariants = work.invariants
    rows = max(len(table.rows) for table in tables)
    work.meter.charge(per_batch(len(variations), rows, len(invariants.shapes)))
    return measured_of_tables(invariants.shapes, tables, variations, work.fixing, angles_alone)


def fitting_values(
    work: Work, tables: Sequence[NumericTable], wanted: Sequence[Unsolved]
) -> list[dict[Place, list[float]]]:
    """Return the values of cells, other than those they have, that make an invariant fit which does not.

    Args:
        work: the key and its invariants.
        tables: the tables, with the key's types of joints.
        wanted: the cells.
    """
    invariants, scale = work.invariants, work.reference.size
    turns = any(shape.measure is Measure.TURN for shape in invariants.shapes)
    variations: list[Variation] = []
    counts: list[int] = []
    owns: list[int] = []
    turned: list[int] = []
    for unsolved in wanted:
        owns.append(len(variations))
        variations.append((unsolved.number, unsolved.cells))
        for place in unsolved.places:
            here = _entry(tables, unsolved, place)
            if place[1] in ANGLES:
                around = [0.0, THIRD, -THIRD, *([here + SMALL_TURN] if turns else ())]
            elif abs(here) <= DISTANT * scale:
                around = [here - scale, here + scale]
            else:
                around = [-scale, scale, 0.0]
            if place[1] in ANGLES:
                turned += range(len(variations), len(variations) + len(around))
            counts.append(len(around))
            variations += [(unsolved.number, (*unsolved.cells, (*place, value))) for value in around]
    found = measured(work, tables, variations, turned)
    functions = _Functions(invariants, found, scale)
    strained_in = _strained(invariants, work.n_facts, found[:, owns])
    solved: list[dict[Place, list[float]]] = []
    each = iter(counts)
    for unsolved, own, (facts, misplaced) in zip(wanted, owns, strained_in, strict=True):
        column = own + 1
        solved.append({})
        for row, cell in unsolved.places:
            place, angular, count = (row, cell), cell in ANGLES, next(each)
            moves = cell == VARIABLE_CELLS.get(tables[unsolved.number].rows[row].joint)
            if strained := misplaced if moves else facts or misplaced:
                distant = count == 3 and not angular
                here = 0.0 if distant else _entry(tables, unsolved, place)
                middle = column + 2 if distant else own
                values = functions.solved(strained, middle, column, here, angular=angular)
                solved[-1][place] = [0.0 if abs(x) < SAME * scale else x for x in values]
            column += count
    return solved


def _entry(tables: Sequence[NumericTable], unsolved: Unsolved, place: Place) -> float:
    row, name = place
    for i, cell, value in reversed(unsolved.cells):
        if (i, cell) == place:
            return value
    entry: float = getattr(tables[unsolved.number].rows[row], name)
    return entry


class _Functions:
    """How invariants depend on cells, from their values at a few."""

    def __init__(self, invariants: Invariants, found: NDArray[np.float64], scale: float) -> None:
        self._scale = scale
        self._measures = [shape.measure for shape in invariants.shapes]
        self._targets: list[float] = invariants.own_sizes[:, 0].tolist()
        values = np.where(invariants.arrays.twists, np.cos(found), found * found)
        self._values: list[list[float]] = values.tolist()

    def solved(
        self, strained: Sequence[int], own: int, first: int, here: float, *, angular: bool
    ) -> list[float]:
        """Return the values of a cell with which the worst of the strained invariants that it changes fits.

        Args:
            strained: the invariants.
            own: the column in which the cell is what it is, or, if that is a distant length, zero.
            first: the first of those in which it is something else.
            here: what it is in the one column.
            angular: it is an angle.
        """
        for k in strained:
            measure, target = self._measures[k], self._targets[k]
            if (measure in (Measure.ANGLE, Measure.TURN)) is not angular:
                continue
            values = self._values[k]
            around, middle = values[first : first + 4], values[own]
            if not angular:
                found = list(_lengths(around[0], middle, around[1], target, here, self._scale))
            elif measure is Measure.ANGLE:
                found = list(_angles(around, math.cos(target)))
            else:
                found = list(_turns(middle, around[3], here, target))
            if found:
                return found
        return []


def _strained(
    invariants: Invariants, facts: int, found: NDArray[np.float64]
) -> list[tuple[list[int], list[int]]]:
    """Of every table the invariants that fit least, the worst first: facts; and where joints are zero."""

    def worst(own: Sequence[float], numbers: range) -> list[int]:
        return sorted((k for k in numbers if own[k] > OFF), key=lambda k: -own[k])[:MOST_STRAINED]

    every = range(len(invariants.shapes))
    return [
        (worst(own, every[:facts]), worst(own, every[facts:])) for own in invariants.strains(found).T.tolist()
    ]


def _lengths(
    below: float, middle: float, above: float, target: float, here: float, scale: float
) -> Iterator[float]:
    """Solutions of y(x) = target², y being quadratic, from its values a scale below, here and above."""
    a = (above - 2.0 * middle + below) / (2.0 * scale * scale)
    b = (above - below) / (2.0 * scale)
    if abs(a) < INFLUENCE:
        return
    c = middle - target * target
    root = math.sqrt(max(b * b - 4.0 * a * c, 0.0))
    root = root if root > INFLUENCE * scale else 0.0
    for numerator in (-b + root, -b - root):
        yield here + numerator / (2.0 * a)
        if root == 0.0:
            return


def _angles(around: Sequence[float], target: float) -> Iterator[float]:
    """Solutions of y(x) = ±target, y being A + B cos x + C sin x, from its values at 0 and ±120°."""
    a = (around[0] + around[1] + around[2]) / 3.0
    b = (2.0 * around[0] - around[1] - around[2]) / 3.0
    c = (around[1] - around[2]) / math.sqrt(3.0)
    size = math.hypot(b, c)
    if size < INFLUENCE:
        return
    phase = math.atan2(c, b)
    for goal in (target, -target):
        cosine = (goal - a) / size
        if abs(cosine) > 1.0 + INFLUENCE:
            continue
        spread = math.acos(max(-1.0, min(1.0, cosine)))
        for x in dict.fromkeys((phase + spread, phase - spread)):
            yield math.remainder(x, math.tau)


def _turns(square: float, beside: float, here: float, target: float) -> Iterator[float]:
    """Angles about a prismatic joint, found from the present one: it enters as plus or minus itself."""
    now = math.sqrt(square)
    changed = abs(math.sqrt(beside) - now)
    if not INFLUENCE <= changed <= SMALL_TURN * (1.0 + INFLUENCE):
        return  # by more it changes only where axes were parallel, which have no turn
    for change in (target - now, -target - now, target + now, now - target):
        for half in (0.0, math.pi):
            yield math.remainder(here + change + half, math.tau)


def fitted_table(
    work: Work, table: NumericTable, places: Sequence[Place], choice: int
) -> NumericTable | None:
    """Return the table with some cells changed so that it fits the key as a whole; None if they cannot.

    Args:
        work: the key.
        table: the table.
        places: rows, counted from 0, and cells.
        choice: which of the choices of the axes' directions is taken, the best first; below MOST_SIGNS.
    """
    if not work.has_the_joints(table):
        return None
    signs = _likely_signs(work.reference, table, work.policy)
    if choice >= len(signs):
        return None
    work.meter.charge(PER_ALIGNMENT * len(table.joint_rows))
    return fitted_cells(work.reference, table, places, signs[choice], work.policy.tolerance, work.meter)


@lru_cache(maxsize=256)
def _likely_signs(reference: Reference, table: NumericTable, policy: Policy) -> list[tuple[int, ...]]:
    """The choices of signs to be tried, the best first.

    A last axis that meets the one before it at a right angle is turned round by half a turn about that one:
    with the other sign the last joint makes the same motions, and the tool makes up for the rest.
    """
    chain = chain_of_table(table)
    signs = likely_signs(reference, chain, policy)[:MOST_SIGNS]
    if len(chain.axes) < 2 or any(axis.prismatic for axis in chain.axes[-2:]):
        return signs
    axis, last = chain.axes[-2:]
    apart = abs(dot(subtract(last.point, axis.point), cross(axis.direction, last.direction)))
    if abs(dot(axis.direction, last.direction)) > SAME or apart > SAME * reference.size:
        return signs
    return [choice for i, choice in enumerate(signs) if all(choice[:-1] != other[:-1] for other in signs[:i])]
