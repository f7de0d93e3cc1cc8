"""The values of one cell with which a table would share an invariant of the key.

In a length cell the square of every invariant length is a quadratic polynomial, in an angle cell the cosine
between two axes is A + B cos x + C sin x: three evaluations give the function, and it is solved in closed
form.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache

from exercises.grading.work import Work, with_cell
from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy
from kinematics.equivalence.cell_fitting import fitted_cells
from kinematics.equivalence.diagnosis import likely_signs
from kinematics.equivalence.invariants import Invariant, Measure
from kinematics.equivalence.meter import PER_ALIGNMENT, PER_INVARIANT
from kinematics.equivalence.reference import Reference
from kinematics.table import NumericTable

# A cell that changes an invariant by a smaller share has nothing to do with it.
INFLUENCE = 1e-6
# In units of an invariant’s slack: what is off by less needs no mending.
OFF = 0.1
# A share of the robot: solutions that are zero but for the arithmetic.
NEGLIGIBLE = 1e-9
# Invariants that are solved for: a cell shows in the worst of them if in any.
MOST_STRAINED = 4
# Choices of the axes’ directions that are tried, the best first.
MOST_SIGNS = 4


def fitting_values(work: Work, table: NumericTable, draw: int, row: int, cell: str) -> list[float]:
    """Values of a cell, other than the one it has, that make an invariant fit which does not.

    Args:
        work: the key and its invariants.
        table: the table.
        draw: number of the parameter draw.
        row: the row, counted from 0.
        cell: "a", "d", "alpha" or "theta".
    """
    if table.joint_types != work.references[draw].table.joint_types:
        return []
    axes = work.axes(table)
    work.meter.charge(PER_INVARIANT * len(work.invariants[draw]))
    strained = sorted(
        (
            (strain, k)
            for k, invariant in enumerate(work.invariants[draw])
            if (strain := invariant.strain(axes)) > OFF
        ),
        reverse=True,
    )
    scale = work.references[draw].size
    for _, k in strained[:MOST_STRAINED]:
        solutions = _solutions(work, table, work.invariants[draw][k], row, cell, scale)
        found = [0.0 if abs(value) < NEGLIGIBLE * scale else value for value in solutions]
        if found:
            return found
    return []


def fitted_tables(
    work: Work, table: NumericTable, draw: int, places: Sequence[tuple[int, str]]
) -> list[NumericTable]:
    """The table with some cells changed so that it fits the key as a whole.

    Args:
        work: the key.
        table: the table.
        draw: number of the parameter draw.
        places: rows, counted from 0, and cells.
    """
    reference = work.references[draw]
    if table.joint_types != reference.table.joint_types:
        return []
    work.meter.charge(PER_ALIGNMENT * 16 * len(table.joint_rows))
    for signs in _likely_signs(reference, table, work.policy)[:MOST_SIGNS]:
        found = fitted_cells(reference, table, places, signs, work.policy.tolerance, work.meter)
        if found is not None:
            return [found]
    return []


@lru_cache(maxsize=256)
def _likely_signs(reference: Reference, table: NumericTable, policy: Policy) -> list[tuple[int, ...]]:
    return likely_signs(reference, chain_of_table(table), policy)


def _solutions(
    work: Work, table: NumericTable, invariant: Invariant, row: int, cell: str, scale: float
) -> Iterator[float]:
    def value(x: float) -> float:
        return invariant.signed(work.axes(with_cell(table, row, cell, x)))

    if cell in ("alpha", "theta"):
        if invariant.measure is Measure.ANGLE:
            yield from _angles(value, math.cos(invariant.value))
        elif invariant.measure is Measure.TURN:
            yield from _turns(value, getattr(table.rows[row], cell), invariant.value)
    elif invariant.measure in (Measure.DISTANCE, Measure.OFFSET):
        yield from _lengths(value, invariant.value, getattr(table.rows[row], cell), scale)


def _lengths(value: Callable[[float], float], target: float, here: float, scale: float) -> Iterator[float]:
    """Solutions of value(x) = target², value being a quadratic polynomial."""
    below, middle, above = value(here - scale), value(here), value(here + scale)
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


def _angles(value: Callable[[float], float], target: float) -> Iterator[float]:
    """Solutions of value(x) = ±target, value being A + B cos x + C sin x."""
    third = 2.0 * math.pi / 3.0
    y = [value(0.0), value(third), value(-third)]
    a = sum(y) / 3.0
    b = (2.0 * y[0] - y[1] - y[2]) / 3.0
    c = (y[1] - y[2]) / math.sqrt(3.0)
    size = math.hypot(b, c)
    if size < INFLUENCE:
        return
    phase = math.atan2(c, b)
    for goal in (target, -target):
        cosine = (goal - a) / size
        if abs(cosine) > 1.0 + INFLUENCE:
            continue
        spread = math.acos(max(-1.0, min(1.0, cosine)))
        for x in {phase + spread, phase - spread}:
            yield math.remainder(x, 2.0 * math.pi)


def _turns(value: Callable[[float], float], here: float, target: float) -> Iterator[float]:
    """Angles about a slider, found from the present one: it enters the turn as plus or minus itself."""
    now, step = math.sqrt(value(here)), 1e-3
    if abs(math.sqrt(value(here + step)) - now) < INFLUENCE:
        return
    for change in (target - now, -target - now, target + now, now - target):
        for half in (0.0, math.pi):
            yield math.remainder(here + change + half, 2.0 * math.pi)
