"""The smallest edits that make a wrong table right: one from the catalogue of misconceptions, else two."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, islice

from exercises.grading.cell_edits import any_cell
from exercises.grading.misconceptions import changes_of
from exercises.grading.row_edits import any_row_left_out
from exercises.grading.work import Change, Extent, Work, after
from kinematics.equivalence.meter import WorkExhaustedError
from kinematics.equivalence.search import Effort
from kinematics.table import NumericTable

# Some three tenths of a second: see `kinematics.equivalence.meter`. The first round, and fitting cells to the
# whole robot, may use no more than their share, so that what comes after is tried as well.
MOST_WORK = 260_000
WORK_OF_FIRST_EDITS = 120_000
WORK_OF_FITTING = 100_000
# A bound of the work: every one of them is followed by all the edits there are.
MOST_FIRST_EDITS = 24
# More explanations than these explain nothing.
MOST_REPAIRS = 6
# a single edit adds or removes one joint
MOST_JOINTS_APART = 2


@dataclass(frozen=True, slots=True)
class Repaired:
    """Changes that together make the table right."""

    changes: tuple[Change, ...]


@dataclass(frozen=True, slots=True)
class Trial:
    """A change tried on the first draw: the table it leads to, and how many invariants still fail."""

    change: Change
    table: NumericTable
    failing: int | None


def find_repairs(work: Work) -> tuple[Repaired, ...]:
    """The repairs of a wrong table, smallest and likeliest first; of two edits only if no one edit helps.

    The search is bounded by the work that the meter of `work` grants.
    """
    apart = abs(work.tables[0].n_joints - work.references[0].table.n_joints)
    if apart > MOST_JOINTS_APART:
        return ()
    found: list[Repaired] = []
    with suppress(WorkExhaustedError):
        for repaired in islice(_found(work), MOST_REPAIRS):
            found.append(repaired)  # noqa: PERF402 - what was found before the work ran out counts
    return tuple(found)


def _found(work: Work) -> Iterator[Repaired]:
    """Single edits, by growing effort; if there are none, pairs."""
    trials: list[Trial] = []
    with work.meter.at_most(WORK_OF_FIRST_EDITS):
        for trial in _tried(work, changes_of(work)):
            trials.append(trial)  # noqa: PERF402 - those made before the work runs out count
    trials.sort(
        key=lambda trial: (
            trial.change.extent.value,
            _fills_a_zero(trial.change, work.tables[0]),
            trial.change.rank,
        )
    )
    found = False
    for effort in Effort:
        for change in _helping(work, trials, effort):
            found = True
            yield Repaired((change,))
        if found:
            return
    if work.one_edit_might_mend(work.tables[0]):
        for change in _fitted(work):
            found = True
            yield Repaired((change,))
    if not found:
        yield from _pairs(work, trials)


def _fitted(work: Work) -> Iterator[Change]:
    """Single edits found by fitting a cell to the whole robot."""
    with work.meter.at_most(WORK_OF_FITTING):
        fitted = _tried(work, chain(any_cell(work), any_row_left_out(work)))
        yield from _helping(work, fitted, Effort.REFINED)


def _fills_a_zero(change: Change, table: NumericTable) -> bool:
    """Whether a change of one cell puts a length where none was typed; a typed one is likelier wrong."""
    if change.extent is not Extent.CELL or len(change.touched) != 1:
        return False
    row, cell = change.touched[0]
    return cell in ("a", "d") and row < len(table.rows) and getattr(table.rows[row], cell) == 0.0


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


def _helping(work: Work, trials: Iterable[Trial], effort: Effort) -> Iterator[Change]:
    """The changes that make the table right at every draw; each place of an edit once."""
    told: set[tuple[str, int | None, str | None]] = set()
    for trial in trials:
        edit = trial.change.edit
        place = (edit.code, edit.row, edit.cell)
        if trial.failing or trial.failing is None or place in told:
            continue
        if work.accepts(trial.table, 0, effort) and _at_other_draws(work, (trial.change,), effort):
            told.add(place)
            yield trial.change


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


def _pairs(work: Work, trials: list[Trial]) -> Iterator[Repaired]:
    """Two edits: first one that brings the table nearer to the key, then each that might finish."""
    before = work.failing(work.tables[0])
    first = [trial for trial in trials if _is_nearer(trial.failing, before)]
    first.sort(key=lambda trial: (trial.failing, trial.change.rank))
    told: set[frozenset[tuple[str, int | None, str | None]]] = set()
    for trial in first[:MOST_FIRST_EDITS]:
        if not work.one_edit_might_mend(trial.table):
            continue
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
            changes = (trial.change, other.change)
            if work.accepts(other.table, 0, Effort.PLAIN) and _at_other_draws(work, changes, Effort.PLAIN):
                told.add(places)
                shown = (trial.change, after(trial.change, other.change))
                yield Repaired(tuple(sorted(shown, key=lambda c: c.edit.row or 0)))


def _is_nearer(failing: int | None, before: int | None) -> bool:
    if failing is None:
        return False
    return before is None or failing < before or failing == before == 0
