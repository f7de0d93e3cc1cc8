"""Edits that are held back without measuring: every one of them would have failed."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest

from exercises.grading import Policy, ToolRule
from exercises.grading.comparison import comparisons
from exercises.grading.explanation import work_on
from exercises.grading.misconceptions import CATALOGUE
from exercises.grading.sieve import Sieve
from exercises.grading.wanted_changes import changes_of
from exercises.grading.work import Work
from kinematics.equivalence.batches import axes_of_tables
from kinematics.table import DHTable, NumericRow, NumericTable
from tests.exercises.grading.campaign import drawn_by_hand
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import references
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.mutations import mutations

FREE = Policy(tool=ToolRule.FREE)


def wrong_answers(number: int) -> list[Work]:
    rng = Random(f"entries {number}")
    _, reference = rng.choice(references())
    table = drawn_by_hand(reference, rng)
    if table is None:
        return []
    made = mutations(table, rng)
    twice = [mutations(one.table, rng) for one in rng.sample(made, 2)]
    tables = [one.table for one in (*rng.sample(made, 2), *map(rng.choice, twice))]
    key = written(reference)
    answers = [written(wrong) for wrong in tables]
    return [work_on(comparisons(key, answer, {})[0], (key, answer), FREE) for answer in answers]


def failing(work: Work, table: NumericTable) -> int:
    """How many facts of a table fail, measured between its axes."""
    facts = work.facts
    return int((facts.strains(facts.measured(axes_of_tables([table], [(0, ())], FREE))) > 1.0).sum())


@pytest.mark.parametrize("number", range(40))
def test_what_is_held_back_fails(number: int) -> None:
    for work in wrong_answers(number):
        before = failing(work, work.table) if work.has_the_joints() else 0
        sieves = [(most, Sieve(work, most)) for most in {0, max(before - 1, 0)}]
        for change in changes_of(work):
            table = change.of(work.table)
            if not work.has_the_joints(table) or change.unsolved:
                continue
            for most, sieve in sieves:
                if sieve.holds_back(change):
                    assert failing(work, table) > most, change


@pytest.mark.parametrize("number", range(40))
def test_what_may_mend_all_is_within_reach(number: int) -> None:
    """Edits that leave no fact wrong are found where the table is narrowed as well."""
    for work in wrong_answers(number):
        if not work.has_the_joints():
            continue
        mended = [
            (change.code, change.row, change.cells)
            for change in changes_of(work)
            if work.has_the_joints(change.of(work.table)) and not failing(work, change.of(work.table))
        ]
        narrowed = Sieve(work).narrowed()
        found = {(change.code, change.row, change.cells) for change in changes_of(narrowed)}
        assert all(one in found for one in mended)


@pytest.mark.parametrize("number", range(40))
def test_a_row_that_was_left_out_is_not_held_back(number: int) -> None:
    """Its α, `a` and d are solved for later, whatever stands there at first."""
    rng = Random(f"left out {number}")
    _, reference = rng.choice(references())
    table = drawn_by_hand(reference, rng)
    if table is None or len(table.rows) < 3:
        return
    left_out = rng.randrange(1, len(table.rows) - 1)
    rows = (*table.rows[:left_out], *table.rows[left_out + 1 :])
    key, answer = written(reference), written(DHTable(convention=table.convention, rows=rows))
    work = work_on(comparisons(key, answer, {})[0], (key, answer), FREE)
    sieve = Sieve(work)
    for change in changes_of(work):
        if change.code == "row_missing" and change.row == left_out:
            assert not sieve.holds_back(change)


@pytest.mark.parametrize("number", range(80))
def test_a_joint_that_changed_places_with_a_fixed_row_is_not_held_back(number: int) -> None:
    """What is before the two rows and behind them changes too, and may be all that is seen to be wrong."""
    rng = Random(f"places {number}")
    _, reference = rng.choice(references())
    table = random_valid_table(reference, rng, dummies=0.6)
    rows = list(table.rows)
    places = [i for i in range(len(rows) - 1) if rows[i].joint is not rows[i + 1].joint]
    if not places:
        return
    i = rng.choice(places)
    rows[i], rows[i + 1] = rows[i + 1], rows[i]
    key, answer = written(reference), written(DHTable(convention=table.convention, rows=tuple(rows)))
    work = work_on(comparisons(key, answer, {})[0], (key, answer), FREE)
    if not work.has_the_joints():
        return
    sieve = Sieve(work)
    mending = ("rows_swapped", i, (("other", i + 2),))
    found = {(one.code, one.row, one.params): one for one in changes_of(sieve.narrowed())}
    assert not sieve.holds_back(found[mending])


@pytest.mark.parametrize("number", range(20))
def test_a_misconception_changes_sizes_in_no_other_columns_than_it_says(number: int) -> None:
    def size(row: NumericRow, column: str) -> float:
        entry: float = getattr(row, column)
        twist = abs(math.remainder(entry, 2.0 * math.pi))
        return min(twist, math.pi - twist) if column == "alpha" else abs(entry)

    for work in wrong_answers(number):
        for misconception in CATALOGUE:
            kept = {"alpha", "a", "d"} - misconception.sizes
            for change in misconception.changes(work) if kept else ():
                pairs = zip(work.table.rows, change.of(work.table).rows, strict=False)
                for before, after in pairs:
                    for column in kept:
                        assert size(after, column) == pytest.approx(size(before, column)), change


def test_most_edits_of_an_arm_with_a_row_for_every_joint_are_held_back() -> None:
    arms = [
        work
        for number in range(60)
        for work in wrong_answers(number)
        if work.has_the_joints() and work.table.n_joints == len(work.table.rows) > 4 and Sieve(work).wrong
    ]
    shares = [
        np.mean([sieve.holds_back(change) for change in changes_of(work) if change.table is None])
        for work in arms
        for sieve in [Sieve(work)]
    ]
    assert len(shares) > 10
    assert np.mean(shares) > 0.9
