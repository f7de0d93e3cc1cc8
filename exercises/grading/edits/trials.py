"""Every edit of the catalogue tried on a table, all at once, against what no choice of frames changes."""

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from math import cos, sin
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from exercises.grading.edits.certainty import surely_right
from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.fitting import Unsolved, fitting_values, measured
from exercises.grading.edits.joint_places import joint_places
from exercises.grading.edits.misfits import Misfits
from exercises.grading.edits.scope import EVERYWHERE, EditScope
from exercises.grading.edits.sieve import Sieve
from exercises.grading.edits.wanted_changes import changes_of
from exercises.grading.edits.work import Work
from exercises.grading.judging.digits import measured_as_typed
from kinematics.equivalence import ZeroRule
from kinematics.equivalence.batches import Variation
from kinematics.table import ANGLES, LENGTHS, VARIABLE_CELLS, NumericTable

DIGITS = 9  # Lengths that agree so far are the same solution.
DIGITS_OF_ANGLES = 7
"""The same of sines and cosines: of parallel axes, an angle is the root of a rounding error."""
Catalogue: TypeAlias = Callable[[Work], Iterator[Change]]


class Trial(NamedTuple):
    """A change, and what of the key the table it leads to does not have; see `Misfit`."""

    change: Change
    failing: int
    misplaced: int
    scope: EditScope


class Finish(NamedTuple):
    """An edit after which a table might be the robot.

    Attributes:
        change: the edit.
        found: (q,) the invariants of the table that it leads to; None where key's lines are among them.
        sure: it is seen to make the table right, as `surely_right` says.
    """

    change: Change
    found: NDArray[np.float64] | None
    sure: bool = False


UNCHANGED = Change("", Extent.CELL)


def finishing(
    works: Sequence[Work], catalogue: Catalogue = changes_of, *, alone: bool = False
) -> list[list[Finish]]:
    """Return for every table the edits of a catalogue after which it might be the robot.

    No fact fails then, and the axes can be turned so that their signs agree.

    Args:
        works: tables for one key, at the same draw.
        catalogue: the edits that may be made to a table.
        alone: the one table is the answer itself: where an edit surely mends it, others of the same kind are
            not solved for.
    """
    sieves = [Sieve(work) for work in works]
    works = [sieve.narrowed() for sieve in sieves]
    made: list[list[Finish]] = [[] for _ in works]
    for batch in _batches(works, catalogue, finishing_reaches(works), sieves, finishing=True):
        some = []
        for k in batch.misfits.might_be_none():
            number, change = batch.made[k]
            some.append((number, Finish(change, None if works[number].lines else batch.misfits.found[:, k])))
        if alone and any(one.change.unsolved for _, one in some):
            seen = surely_right(works[0], [((one.change,), one.found) for _, one in some])
            some = [(0, one._replace(sure=sure)) for (_, one), sure in zip(some, seen, strict=True)]
            batch.settled = {(one.change.code, one.change.row) for _, one in some if one.sure}
        for number, one in some:
            made[number].append(one)
    return made


def tried(work: Work, catalogue: Catalogue = changes_of, *, most_failing: int | None = None) -> list[Trial]:
    """Return what came of the edits of a catalogue with which a table's joints are those of the key.

    Args:
        work: the table.
        catalogue: the edits that may be made to it.
        most_failing: after others that are not wanted either more facts than these fail; None: any may.
    """
    sieves = [] if most_failing is None else [Sieve(work, most_failing)]
    works = [sieve.concerned() for sieve in sieves] or [work]
    batches = _batches(works, catalogue, [works[0].scope.reach], sieves, finishing=False)
    return [
        Trial(change, *misfit)
        for batch in batches
        for (_, change), misfit in zip(batch.made, batch.misfits.told, strict=True)
    ]


def _batches(
    works: Sequence[Work],
    catalogue: Catalogue,
    reaches: Sequence[tuple[int, int]],
    sieves: Sequence[Sieve],
    *,
    finishing: bool,
) -> "Iterator[_Batch]":
    """The edits of a catalogue; then those in which one more of their unsolved cells has a value."""
    fits = _fits(works)
    made = [
        (number, change)
        for number, (work, (start, end)) in enumerate(zip(works, reaches, strict=True))
        if start <= end or not work.excess  # nowhere else is there a joint to put in or take out
        for change in _wanted(replace(work.within((start, end)), fits=fits[number]), catalogue)
    ]
    while made:
        if sieves:
            made = [(number, change) for number, change in made if not sieves[number].holds_back(change)]
        if not made:
            return
        batch = _Batch(works, made)
        yield batch
        made = batch.solved(finishing=finishing)


def _wanted(work: Work, catalogue: Catalogue) -> list[Change]:
    """The changes of a catalogue that lead to the key's joints and leave alone what is kept."""
    alike, slip, kept = work.has_the_joints(), work.only, work.kept
    return [
        change
        for change in catalogue(work)
        if (slip is None or change.slip == slip)
        and (alike if change.table is None else work.has_the_joints(change.table))
        and (not kept or kept.isdisjoint(change.places))
    ]


def tried_unchanged(work: Work) -> Trial | None:
    """Return the answer as it stands; None if its joints are not those of the key."""
    if not work.has_the_joints():
        return None
    invariants = work.invariants
    found = measured_as_typed(invariants, work.table, work.comparison.steps, work.fixing)[:, :1]
    (misfit,) = Misfits(work, found).told
    return Trial(UNCHANGED, *misfit)


def _fits(works: Sequence[Work]) -> list[dict[tuple[int, str], list[float]]]:
    """Values that fit, for the cells of the tables that have the key's joints, where any fact is off."""
    found: list[dict[tuple[int, str], list[float]]] = [{} for _ in works]
    wanted: list[Unsolved] = []
    for number, work in enumerate(works):
        places = []
        angles, lengths, misplaced = work.scope.off
        for row, cell in _cells(work) if work.has_the_joints() else ():
            moves = cell == VARIABLE_CELLS.get(work.table.rows[row].joint)
            of_facts = angles if cell in ANGLES else lengths
            if misplaced if moves or not (angles or lengths) else of_facts:
                places.append((row, cell))
            elif not moves and (angles or lengths):
                found[number][row, cell] = []
        if places:
            wanted.append(Unsolved(number, (), places))
    if wanted:
        tables = [work.table if work.has_the_joints() else works[wanted[0].number].table for work in works]
        for unsolved, values in zip(wanted, fitting_values(works[0], tables, wanted), strict=True):
            found[unsolved.number] |= values
    return found


def finishing_reaches(works: Sequence[Work]) -> list[tuple[int, int]]:
    """Return what an edit has to do with in each table, so that it may make it the robot."""
    found = [work.scope.reach for work in works]
    for excess in (-1, 1):
        off = [k for k, work in enumerate(works) if work.excess == excess and work.scope.reach is EVERYWHERE]
        if off:
            for k, places in zip(off, joint_places([works[k] for k in off]), strict=True):
                found[k] = places
    return found


def _cells(work: Work) -> list[tuple[int, str]]:
    """The cells that are no variable's, may mend all that fails, and are not kept as they are."""
    if (work.only is not None and work.only.code is not None) or len(work.scope.lacking) > 1:
        return []
    return [
        (i, cell)
        for i, row in work.rows
        for cell in work.scope.lacking or (ANGLES if work.scope.angular else (*LENGTHS, *ANGLES))
        if (work.only is None or cell == work.only.cell)
        and (i, cell) not in work.kept
        and (work.policy.zero is ZeroRule.FIGURE or cell != VARIABLE_CELLS.get(row.joint))
    ]


class _Batch:
    """Changes of tables, measured all at once.

    Attributes:
        made: the number of the table that each is made in, and the change.
        misfits: what came of them.
        settled: codes and rows of changes that need not be solved for.
    """

    settled: Collection[tuple[str, int | None]] = ()

    def __init__(self, works: Sequence[Work], made: Sequence[tuple[int, Change]]) -> None:
        self._works, self.made = works, made
        self._tables: list[NumericTable] = []
        numbers: dict[int, int] = {}
        self._variations: list[Variation] = []
        for number, change in made:
            table = works[number].table if change.table is None else change.table
            if id(table) not in numbers:
                numbers[id(table)] = len(self._tables)
                self._tables.append(table)
            self._variations.append((numbers[id(table)], change.cells))
        self.misfits = Misfits(works[0], measured(works[0], self._tables, self._variations))

    def _fits_elsewhere(self, k: int, change: Change) -> bool:
        """Whether everything fits that has nothing to do with the row put in and its neighbours."""
        assert change.row is not None
        failing, _, scope = self.misfits.told[k]
        joint = self._tables[self._variations[k][0]].joint_rows.index(change.row) + 1
        return not failing or scope.is_place(joint)

    def solved(self, *, finishing: bool) -> list[tuple[int, Change]]:
        """Return the changes that put a value that fits in one more of their unsolved cells; each table once.

        Angles are solved for before lengths; with a length first, an angle that fails is never mended. A row
        put in that is to finish, and leaves something elsewhere, is given up.
        """
        unsolved: list[int] = []
        wanted: list[Unsolved] = []
        for k, (_, change) in enumerate(self.made):
            if not change.unsolved or (change.code, change.row) in self.settled:
                continue
            if finishing and change.code == "row_missing" and not self._fits_elsewhere(k, change):
                continue
            angles_first = finishing and self.misfits.told[k].scope.angular
            cells = [cell for cell in change.unsolved if cell in ANGLES or not angles_first]
            if cells:
                unsolved.append(k)
                places = [(change.row or 0, cell) for cell in cells]
                wanted.append(Unsolved(self._variations[k][0], change.cells, places))
        if not wanted:
            return []
        filled = {id(self.made[k][1].table) for k in unsolved}
        known = {self._content(*made) for made in self.made if id(made[1].table) in filled}
        made = []
        for k, values in zip(unsolved, fitting_values(self._works[0], self._tables, wanted), strict=True):
            number, change = self.made[k]
            for (row, cell), found in values.items():
                left = tuple(c for c in change.unsolved if c != cell and (cell in ANGLES or c not in ANGLES))
                for value in found:
                    solved = change._replace(cells=(*change.cells, (row, cell, value)), unsolved=left)
                    content = self._content(number, solved)
                    if content not in known:
                        known.add(content)
                        made.append((number, solved))
        return made

    @staticmethod
    def _content(number: int, change: Change) -> tuple[object, ...]:
        """What a change leads to, in whatever order its cells were solved for, but for rounding and turns."""
        values = {(row, cell): value for row, cell, value in change.cells}
        cells = (
            (*place, round(cos(value), DIGITS_OF_ANGLES), round(sin(value), DIGITS_OF_ANGLES))
            if place[1] in ANGLES
            else (*place, round(value, DIGITS))
            for place, value in values.items()
        )
        return number, id(change.table), frozenset(cells)
