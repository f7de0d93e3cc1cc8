"""The smallest edits that make a wrong table right: one from the catalogue of misconceptions, else two."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import chain

from exercises.grading.cell_edits import any_cell
from exercises.grading.misconceptions import changes_of
from exercises.grading.row_edits import any_row_left_out
from exercises.grading.work import Change, Work
from kinematics.equivalence.search import Effort
from kinematics.table import NumericTable

MOST_DECISIONS = 400
MOST_FIRST_EDITS = 24
MOST_REPAIRS = 6
SECONDS = 0.25


@dataclass(frozen=True, slots=True)
class Repaired:
    """Changes that together make the table right."""

    changes: tuple[Change, ...]


@dataclass(slots=True)
class Budget:
    """What a search may still spend; the count makes it reproducible, the thread's clock keeps it short."""

    decisions: int
    until: float

    @property
    def spent(self) -> bool:
        """Nothing is left."""
        return self.decisions <= 0 or time.thread_time() > self.until


@dataclass(frozen=True, slots=True)
class Trial:
    """A change tried on the first draw: the table it leads to, and how many invariants still fail."""

    change: Change
    table: NumericTable
    failing: int | None


def find_repairs(work: Work) -> tuple[Repaired, ...]:
    """The repairs of a wrong table, smallest and likeliest first; of two edits only if no one edit helps."""
    trials = list(_tried(work, changes_of(work)))
    budget = Budget(MOST_DECISIONS, time.thread_time() + SECONDS)
    trials.sort(key=lambda trial: (trial.change.extent.value, trial.change.rank))
    for effort in Effort:
        singles = [Repaired((change,)) for change in _helping(work, trials, budget, effort)]
        if singles:
            return tuple(singles[:MOST_REPAIRS])
    fitted = _tried(work, chain(any_cell(work), any_row_left_out(work)))
    singles = [Repaired((change,)) for change in _helping(work, fitted, budget, Effort.REFINED)]
    return tuple(singles or _pairs(work, trials, budget))[:MOST_REPAIRS]


def _tried(work: Work, changes: Iterable[Change]) -> Iterator[Trial]:
    """The changes, tried on the first draw."""
    known: dict[NumericTable, int | None] = {}
    for change in changes:
        for table in change.apply(work.tables[0], 0):
            if table == work.tables[0]:
                continue
            if table not in known:
                known[table] = work.failing(table)
            yield Trial(change, table, known[table])


def _helping(work: Work, trials: Iterable[Trial], budget: Budget, effort: Effort) -> Iterator[Change]:
    """The changes that make the table right at every draw; each place of an edit once."""
    told: set[tuple[str, int | None, str | None]] = set()
    for trial in trials:
        edit = trial.change.edit
        place = (edit.code, edit.row, edit.cell)
        if trial.failing == 0 and place not in told:
            budget.decisions -= 1
            if work.accepts(trial.table, 0, effort) and _at_other_draws(work, (trial.change,), effort):
                told.add(place)
                yield trial.change
        if budget.spent:
            return


def _at_other_draws(work: Work, changes: tuple[Change, ...], effort: Effort) -> bool:
    return all(
        any(work.accepts(table, draw, effort) for table in _applied(changes, work.tables[draw], draw))
        for draw in range(1, len(work.tables))
    )


def _applied(changes: tuple[Change, ...], table: NumericTable, draw: int) -> Iterator[NumericTable]:
    if not changes:
        yield table
        return
    for edited in changes[0].apply(table, draw):
        yield from _applied(changes[1:], edited, draw)


def _pairs(work: Work, trials: list[Trial], budget: Budget) -> Iterator[Repaired]:
    """Two edits: first one that brings the table nearer to the key, then each that might finish."""
    before = work.failing(work.tables[0])
    first = [trial for trial in trials if _is_nearer(trial.failing, before)]
    first.sort(key=lambda trial: (trial.failing, trial.change.rank))
    told: set[frozenset[tuple[str, int | None, str | None]]] = set()
    for trial in first[:MOST_FIRST_EDITS]:
        half = replace(work, tables=(trial.table, *work.tables[1:]))
        rest = [
            other
            for other in _tried(half, changes_of(half))
            if other.failing == 0 and not set(other.change.touched) & set(trial.change.touched)
        ]
        for other in rest:
            places = frozenset((c.edit.code, c.edit.row, c.edit.cell) for c in (trial.change, other.change))
            if places in told:
                continue
            if budget.spent:
                return
            budget.decisions -= 1
            changes = (trial.change, other.change)
            if work.accepts(other.table, 0, Effort.PLAIN) and _at_other_draws(work, changes, Effort.PLAIN):
                told.add(places)
                yield Repaired(tuple(sorted(changes, key=lambda c: c.edit.row or 0)))
                if len(told) == MOST_REPAIRS:
                    return


def _is_nearer(failing: int | None, before: int | None) -> bool:
    if failing is None:
        return False
    return before is None or failing < before or failing == before == 0
