"""Edits that are held back without measuring: every one of them would have failed."""

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest

from exercises.grading import Policy, ToolRule
from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.misconceptions import CATALOGUE
from exercises.grading.edits.sieve import LegibleFact, LegibleFacts, Sieve, legible_facts
from exercises.grading.edits.wanted_changes import changes_of
from exercises.grading.edits.work import Work
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from kinematics.equivalence.batches import axes_of_tables
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericRow, NumericTable
from tests.conftest import EXPLORE
from tests.exercises.grading.campaign import drawn_by_hand
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import references
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.mutations import mutations

FREE = Policy(tool=ToolRule.FREE)
ANSWERS = 40 if EXPLORE else 20
"""Robots of whose wrong tables every edit is measured."""


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


@pytest.mark.parametrize("number", range(ANSWERS))
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


@pytest.mark.parametrize("number", range(ANSWERS))
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
    """Its `a` and d are solved for later, whatever stands there at first; α where it is no right angle."""
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
    sine = abs(math.sin(table.rows[left_out].alpha))
    for change in changes_of(work):
        if change.code == "row_missing" and change.row == left_out and sieve.holds_back(change):
            assert min(sine, 1.0 - sine) < 1e-9 < abs(abs(math.sin(change.cells[0][2])) - sine)


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


@pytest.mark.parametrize(
    ("row", "cell", "angular", "lacking"),
    [(1, "a", False, {"a"}), (2, "alpha", True, {"alpha"}), (3, "d", False, {"d"})],
)
def test_a_table_is_narrowed_to_the_row_and_the_column_that_are_wrong(
    row: int, cell: str, angular: bool, lacking: set[str]
) -> None:
    rows = [turning(alpha=0.4 + 0.1 * i, a=0.3, d=0.2) for i in range(6)]
    wrong = [
        replace(each, **{cell: getattr(each, cell) + 0.5}) if i == row else each
        for i, each in enumerate(rows)
    ]
    key, answer = (
        written(DHTable(convention=Convention.STANDARD, rows=tuple(each))) for each in (rows, wrong)
    )
    work = work_on(comparisons(key, answer, {})[0], (key, answer), FREE)
    narrowed = Sieve(work).narrowed()
    known = narrowed.scope
    assert (known.angular, known.lacking) == (angular, frozenset(lacking))
    start, end = known.reach
    assert row <= start <= end <= row + 2
    exchanged = [change for change in changes_of(narrowed) if change.code == "rows_swapped"]
    assert all(row in {place for place, _ in change.places} for change in exchanged)
    right = work_on(comparisons(key, key, {})[0], (key, key), FREE)
    assert Sieve(right).narrowed() == right


@pytest.mark.parametrize("wrong", range(4))
@pytest.mark.parametrize("most", range(4))
def test_an_edit_may_leave_as_many_facts_wrong_as_is_said(wrong: int, most: int) -> None:
    """Whether it brings a table of its own or changes cells, and whether it touches what is wrong or not."""
    rows = tuple(turning(a=2.0 if i < wrong else 1.0) for i in range(3))
    stand = [LegibleFact(i, "a", (i,), (), frozenset({(i, "a")})) for i in range(3)]
    facts = LegibleFacts(stand, {(i, "a"): [fact] for i, fact in enumerate(stand)}, [(1.0, 0.1)] * 3)
    nothing, first = Change("", Extent.CELL), Change("a_value", Extent.CELL, 0, "a", ((0, "a", 1.0),))
    assert facts.leave_wrong(nothing, rows, facts.wrong(rows), most) is (wrong > most)
    left = max(wrong - 1, 0)
    assert facts.leave_wrong(first, rows, facts.wrong(rows), most) is (left > most)
    worse = first._replace(cells=((0, "a", 3.0),))
    left = max(wrong, 1)
    assert facts.leave_wrong(worse, rows, facts.wrong(rows), most) is (left > most)


def turning(alpha: float = 0.0, a: float = 0.0, d: float = 0.0) -> NumericRow:
    return DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha)


@pytest.mark.parametrize(
    ("alphas", "ds", "wrong"),
    [
        ((0.0, 0.0), (1.0, 2.0, 3.0), False),
        ((math.pi, 0.0), (1.0, -2.0, -3.0), False),
        ((0.0, math.pi), (1.0, 2.0, -3.0), False),
        ((math.pi, math.pi), (-1.0, 2.0, -3.0), False),
        ((math.pi, math.pi), (1.0, 2.0, 3.0), True),
        ((0.0, 0.0), (1.0, 2.0, 2.0), True),
        ((0.3, 0.0), (1.0, 2.0, 2.0), False),
        ((0.0, 0.3), (1.0, 2.0, 2.0), False),
    ],
)
def test_offsets_along_parallel_axes_add_up(
    alphas: tuple[float, float], ds: tuple[float, float, float], wrong: bool
) -> None:
    """Each as its axis points; nothing is said where one of the axes is not parallel."""
    places = frozenset({(0, "d"), (1, "d"), (2, "d"), (0, "alpha"), (1, "alpha")})
    fact = LegibleFact(0, "d", (0, 1, 2), (0, 1), places)
    rows = [turning(alpha, 0.0, d) for alpha, d in zip((*alphas, 0.0), ds, strict=True)]
    assert fact.is_wrong([(6.0, 0.1)], rows, {}) is wrong


def test_where_the_facts_of_an_arm_stand() -> None:
    """Between two skew axes, along two parallel ones in the middle, and beside the axes that meet."""
    half = math.pi / 2
    rows = (turning(half), turning(0.0, 0.4), turning(-half, 0.02, 0.15), turning(half, 0.0, 0.35), turning())
    key = written(DHTable(convention=Convention.STANDARD, rows=rows))
    work = work_on(comparisons(key, key, {})[0], (key, key), FREE)
    facts = legible_facts(
        work.invariants, work.n_facts, work.table.convention, tuple(row.joint for row in work.table.rows)
    )
    places = {(fact.column, fact.rows, fact.links): facts.bounds[fact.number][0] for fact in facts.facts}
    assert {place: round(target, 9) for place, target in places.items() if place[0] == "d"} == {
        ("d", (1, 2), (1,)): 0.15,
        ("d", (3,), ()): 0.35,
    }
    assert places["alpha", (0,), ()] == pytest.approx(half)
    assert places["a", (1,), (1,)] == pytest.approx(0.4)
