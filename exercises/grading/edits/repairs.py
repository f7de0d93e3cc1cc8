"""The smallest edits that make a wrong table right: one from the catalogue of misconceptions, else two.

Three only where the number of joints is wrong, and one of them is the convention, which spoils all facts.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import islice

from exercises.grading.edits.cell_edits import any_cell
from exercises.grading.edits.certainty import rows_of_missed_ends, surely_misses, surely_right
from exercises.grading.edits.changes import Change, Extent, after
from exercises.grading.edits.fitting import MOST_SIGNS
from exercises.grading.edits.misconceptions import RANKS
from exercises.grading.edits.repaired import Repaired, without_exchanges
from exercises.grading.edits.row_edits import any_row_left_out, joint_left_out, row_left_out, twists_of
from exercises.grading.edits.scope import ANY_EDIT
from exercises.grading.edits.sieve import Sieve
from exercises.grading.edits.table_edits import hides_an_entry, other_convention
from exercises.grading.edits.trials import (
    Catalogue,
    Finish,
    Trial,
    finishing,
    finishing_reaches,
    tried,
    tried_unchanged,
)
from exercises.grading.edits.wanted_changes import changes_beforehand, changes_of
from exercises.grading.edits.work import Work
from kinematics.equivalence.meter import WorkExhaustedError
from kinematics.equivalence.search import Effort
from kinematics.table import NumericTable

# Some three tenths of a second: see `kinematics.equivalence.meter`. Each way to a single
# edit may use no more than its share, so that what comes after is tried as well; fitting cells to the whole
# robot leaves some of it for deciding on what was found.
MOST_WORK = 270_000
WORK_OF_ONE_WAY = 190_000
WORK_OF_FITTING = 120_000
# A bound of the work: every one of them is followed by all the edits there are.
MOST_FIRST_EDITS = 24
MOST_BEFOREHAND = 48
MOST_ROWS_TOGETHER = 160
"""A bound of what is held in memory at once: tables that are tried together, times their rows."""
MOST_REPAIRS = 6  # More explanations than these explain nothing.
DECLARED = (Extent.CELL.value + Extent.ROW.value) / 2
"""A convention is declared once: likelier wrong than a row, less likely than a cell."""
RANKS_BESIDE = {**RANKS, "a_d_swapped": len(RANKS)}  # Beside another edit it says more than a cell does.
FEWEST_JOINTS = 3  # Of fewer, three edits make almost anything.
MOST_JOINTS_APART = 2  # A single edit adds or removes one joint.


def find_repairs(work: Work, *, pairs: bool = True) -> tuple[Repaired, ...]:
    """Return the repairs of a wrong table, likeliest first; of two edits only if no one edit helps.

    The search is bounded by the work that the meter of `work` grants.

    Args:
        work: the table.
        pairs: whether two edits are looked for.
    """
    if abs(work.excess) > MOST_JOINTS_APART:
        return ()
    found: list[Repaired] = []
    with suppress(WorkExhaustedError):
        for repaired in _found(work, pairs=pairs):
            found.append(repaired)  # what was found before the work ran out counts
            exchanged = next(_twists_exchanged(work, repaired), None)
            if exchanged is not None:
                return (Repaired((exchanged,)),)
            if len(without_exchanges(found)) == MOST_REPAIRS:
                break
    if not found and pairs and work.excess and work.table.n_joints >= FEWEST_JOINTS:
        found += _in_the_other_convention(work)
    return tuple(without_exchanges(found))


def _twists_exchanged(work: Work, repaired: Repaired) -> Iterator[Change]:
    """The one edit that mends as much as new twists in two neighbouring rows: each has the other's.

    As a single edit it was not tried: by what no choice of frames changes, one of the twists alone seemed to
    mend all, but the other one breaks a rule about an end.
    """
    first, second = repaired.changes[0], repaired.changes[-1]
    if first.code == second.code == "alpha_value" and _row_of(second) == _row_of(first) + 1:
        for change in twists_of(work, _row_of(first)):
            if _is_right(work, work, (change,), Effort.PLAIN):
                yield change


def _row_of(change: Change) -> int:
    return -1 if change.row is None else change.row


def _in_the_other_convention(work: Work) -> Iterator[Repaired]:
    """What mends the table if its rows are meant in the other convention, after that has been declared."""
    for declared in other_convention(work):
        comparison = work.comparison.declared(declared.of(work.table).convention)
        other = replace(work, comparison=comparison, table=comparison.meant[work.draw])
        if other.wrong_facts >= work.wrong_facts:
            continue
        with suppress(WorkExhaustedError):
            for repaired in islice(_found(other, pairs=True), MOST_REPAIRS):
                yield Repaired((declared, *repaired.changes))


def _found(work: Work, *, pairs: bool) -> Iterator[Repaired]:
    """Single edits, by growing effort; if there are none, pairs."""
    here, near = _seen_from_here(work)
    (made,) = finishing([near], alone=True)
    lined = work.for_lines()
    to_the_letter = lined or (work.for_lines(to_the_letter=True) if here and not here.failing else None)
    if to_the_letter is not None:
        made += finishing([_seen_from_here(to_the_letter)[1]])[0]
    made.sort(key=lambda one: _likelihood(one.change, work.table))
    ways = [_helping(work, made, Effort.PLAIN)]
    if _says_little(work, here):
        ways.append(_fitted(near))
    ways.append(_helping(work, made, Effort.REFINED))
    for way in ways:
        found: list[Change] = []
        with work.meter.at_most(WORK_OF_ONE_WAY):
            for change in way:
                found.append(change)
                yield Repaired((change,))
        if found:
            if pairs and all(change.code == "row_missing" for change in found):
                yield from _pairs(work, _nearer(work, here, joint_left_out))
            elif pairs and all(one.code == "rows_swapped" and hides_an_entry(work, one) for one in found):
                others = [trial for trial in _nearer(work, here) if trial.change.code != "rows_swapped"]
                yield from _pairs(work, others)
            return
    if pairs and lined is not None:
        for repaired in _pairs(lined, _nearer(lined, tried_unchanged(lined))):
            pairs = False
            yield repaired
    if pairs:
        yield from _pairs(work, [*_nearer(work, here), *_beforehand(work)])


def _seen_from_here(work: Work) -> tuple[Trial | None, Work]:
    """The table as it stands, and with what an edit has to do that mends all that is wrong."""
    here = tried_unchanged(work)
    if here is None:
        return None, work
    return here, replace(work, scope=here.scope)


def _says_little(work: Work, here: Trial | None) -> bool:
    """Whether a wrong cell may show in no single invariant: beside prismatic joints, and at fixed ends."""
    if here is not None and not here.scope.meet:
        return False
    prismatic = any(axis.prismatic for axis in work.reference.chain.axes)
    return prismatic or (here is not None and here.failing == here.misplaced == 0)


def _fitted(work: Work) -> Iterator[Change]:
    """Single edits found by fitting a cell to the whole robot; those made before the work runs out count."""
    made: list[Change] = []
    with work.meter.at_most(WORK_OF_FITTING):
        work = Sieve(work).narrowed()
        work = work.within(finishing_reaches([work])[0])
        places = frozenset(trial.change.row for trial in tried(work, row_left_out))
        for choice in range(MOST_SIGNS):
            made += any_cell(work, choice)
            made += any_row_left_out(work, choice, places)
    yield from _helping(work, finishing([work], lambda _: iter(made))[0], Effort.REFINED)


def _likelihood(change: Change, table: NumericTable) -> tuple[float, bool, int]:
    """What edits are sorted by, the likeliest first."""
    extent = DECLARED if change.code == "convention" else change.extent.value
    return extent, change.fills_a_zero(table), RANKS[change.code]


def _helping(work: Work, made: Iterable[Finish], effort: Effort) -> Iterator[Change]:
    """The single changes that make the table right."""
    ends = rows_of_missed_ends(work)
    edits = ((work, (one.change,), one) for one in made if not surely_misses(ends, one.change))
    for (change,) in _mending(work, edits, effort):
        yield change


def _mending(
    work: Work, edits: Iterator[tuple[Work, tuple[Change, ...], Finish]], effort: Effort
) -> Iterator[tuple[Change, ...]]:
    """Of edits those that mend the table; each place once.

    Args:
        work: the table.
        edits: each with the table that its last is made in, and that last one.
        effort: how hard to try.
    """
    told: set[frozenset[tuple[str, int | None, str | None]]] = set()
    placed = ((frozenset((one.code, one.row, one.cell) for one in edit[1]), *edit) for edit in edits)
    untold = (edit for edit in placed if edit[0] not in told)
    while some := list(islice(untold, MOST_REPAIRS)):
        seen = surely_right(work, [(changes, None if one.sure else one.found) for *_, changes, one in some])
        for (places, edited, changes, one), sure in zip(some, seen, strict=True):
            if places not in told and (one.sure or sure or _is_right(work, edited, changes, effort)):
                told.add(places)
                yield changes


def _is_right(work: Work, edited: Work, changes: Sequence[Change], effort: Effort) -> bool:
    """Whether edits make a table right at every draw, the last one made in what the others led to."""
    draws = work.draws_at_hand
    if len(draws) == 1:
        return edited.accepts(changes[-1], effort)
    if effort is Effort.PLAIN and work.accepts_alike(changes, effort, draws):
        return True
    return edited.accepts(changes[-1], effort) and _at_other_draws(work, changes, effort)


def _at_other_draws(work: Work, changes: Sequence[Change], effort: Effort) -> bool:
    others = work.draws_at_hand[1:]
    if work.accepts_alike(changes, effort, others):
        return True
    return all(_mends(work.at(draw), changes, effort) for draw in others)


def _mends(work: Work, changes: Sequence[Change], effort: Effort) -> bool:
    """Whether the slips undone here make the table right, with the values that fit here."""
    work = replace(work, only=changes[0].slip)
    if len(changes) > 1:
        first = [*tried(work), *_beforehand(work)]
        return any(_mends(half, changes[1:], effort) for half in _halves(work, first))
    if any(work.accepts(one.change, effort) for one in finishing([work])[0]):
        return True
    return effort is Effort.REFINED and any(True for _ in _fitted(work))


def _pairs(work: Work, first: Sequence[Trial]) -> Iterator[Repaired]:
    """Two edits: one of the first, then each that might finish; in whichever order, each pair once."""
    told = set()
    for changes in _mending(work, _pairs_to_try(work, first), Effort.PLAIN):
        shown = sorted((changes[0], after(*changes)), key=_row_of)
        edits = frozenset((change.code, change.row, change.cell, change.params) for change in shown)
        if edits not in told:
            told.add(edits)
            yield Repaired(tuple(shown))


def _pairs_to_try(work: Work, first: Sequence[Trial]) -> Iterator[tuple[Work, tuple[Change, Change], Finish]]:
    """The same before they are judged, as `_mending` takes them.

    Where an end is missed, one of the two is there: these are tried first.
    """
    ends = rows_of_missed_ends(work)
    first = sorted(first, key=lambda trial: surely_misses(ends, trial.change))
    together = max(MOST_ROWS_TOGETHER // len(work.table.rows), 1)
    for start in range(0, len(first), together):
        some = first[start : start + together]
        halves = _halves(work, some, keeping=True)
        for trial, half, rest in zip(some, halves, finishing(halves), strict=True):
            still = rows_of_missed_ends(half) if ends else []
            for one in rest:
                if not surely_misses(still, one.change):
                    yield half, (trial.change, one.change), one


def _halves(work: Work, trials: Iterable[Trial], *, keeping: bool = False) -> list[Work]:
    """The table with each of some edits made; what one has changed is kept, unless that was all there is."""
    halves = []
    for change, _, _, scope in trials:
        keeps = keeping and not (change.row is None and work.excess)
        kept = frozenset(change.places if keeps else ())
        halves.append(work.edited(change, scope, kept))
    return halves


def _nearer(work: Work, here: Trial | None, catalogue: Catalogue = changes_of) -> list[Trial]:
    """The edits of a catalogue that bring the table nearer to the key, so that one more may mend it."""
    most = None if here is None else max(here.failing - 1, int(here.scope.angular))
    made = tried(work, catalogue, most_failing=most)
    first = [trial for trial in made if trial.scope.meet and _is_nearer(trial, here)]
    first.sort(key=lambda trial: (trial.failing, trial.misplaced, RANKS_BESIDE[trial.change.code]))
    return first[:MOST_FIRST_EDITS]


def _is_nearer(trial: Trial, before: Trial | None) -> bool:
    if before is None or trial.failing < before.failing:
        return True
    if before.failing == trial.failing == 1 and before.scope.angular and not trial.scope.angular:
        return True  # axes that are parallel by mistake have no offset: a wrong one shows once they are not
    return trial.failing == before.failing == 0 and trial.misplaced <= before.misplaced


def _beforehand(work: Work) -> list[Trial]:
    """The edits after which one that mends the count of the joints might finish; they cannot be tried."""
    changes = islice(changes_beforehand(work), MOST_BEFOREHAND)
    return [Trial(change, 0, 0, ANY_EDIT) for change in changes]
