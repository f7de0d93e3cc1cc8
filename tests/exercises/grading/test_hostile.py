"""Answers nobody expects: no answer raises, none is expensive, and none is judged by a rounding error."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import islice
from random import Random

import pytest

from exercises.grading import (
    BaseRule,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
    grade,
)
from exercises.grading.edits.repairs import MOST_WORK, find_repairs
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from kinematics.equivalence import row_measures
from kinematics.equivalence.batches import AxisBatch, Variation, axes_of_tables
from kinematics.equivalence.meter import OVERDRAFT, PER_ROUND, Meter, WorkExhaustedError
from kinematics.table import NumericTable
from tests.exercises.grading.answers_campaign import hostile_answers, hostile_tables
from tests.exercises.grading.test_grade import KEY, PUMA, USUAL, VALUES, Rows, with_cells
from tests.exercises.grading.written import read, written
from tests.kinematics.equivalence.campaign import catalogue
from tests.kinematics.equivalence.mutations import mutations

EVERYTHING_FIXED = Policy(
    base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
)


def without_row(rows: Rows, row: int) -> Rows:
    """The rows without one (counted from 1), the later variables renumbered."""
    kept = [*rows[: row - 1], *rows[row:]]
    return [(*cells[:3], f"q{k}") for k, cells in enumerate(kept, 1)]


@pytest.mark.parametrize("base", list(BaseRule))
@pytest.mark.parametrize("tool", list(ToolRule))
@pytest.mark.parametrize("twist", [0.7854, 0.785, 0.79])
def test_a_rounded_twist_keeps_every_rule(base: BaseRule, tool: ToolRule, twist: float) -> None:
    """The marked point is on the last axis: how far it is to be turned about that is no rounding error's."""
    key = read("standard", [("pi/4", 0.3, 0.4, "q1"), (0, 0, 0.3, "q2")])
    answer = read("standard", [(twist, 0.3, 0.4, "q1"), (0, 0, 0.3, "q2")])
    assert grade(key, answer, Policy(base=base, tool=tool)).correct


def test_mistakes_where_nothing_is_left_to_refine() -> None:
    """Both frames and the zeros are fixed: B, E and δ are given, and there is nothing to fit."""
    rng = Random(1)
    for _, robot in catalogue():
        made = mutations(robot, rng)
        for mutation in rng.sample(made, min(4, len(made))):
            verdict = grade(written(robot), written(mutation.table), EVERYTHING_FIXED)
            assert 0.0 <= verdict.score <= 1.0


@pytest.mark.parametrize("missing", [2, 4])
def test_a_row_missing_and_one_more_mistake(missing: int) -> None:
    """Rows are told as the student numbered them, although the first edit moves them."""
    for row in range(1, 7):
        if row == missing:
            continue
        rows = without_row(with_cells(PUMA, (row, 1, "d4")), missing)
        verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
        assert not verdict.correct
        assert all(1 <= link.row <= len(rows) + 1 for link in verdict.links)
        mistaken = row - (row > missing)
        for repair in verdict.repairs:
            if {edit.code for edit in repair.edits} == {"row_missing", "a_not_zero"}:
                assert mistaken in {edit.row for edit in repair.edits if edit.code == "a_not_zero"}


def test_the_zero_of_a_variable_in_a_missing_row() -> None:
    """A second edit may be in a row that the first has added: only the missing row is told."""
    key: Rows = [("pi/2", 0.75, -0.66, "q1"), ("pi", 0.89, 0.15, "q2 + pi/2")]
    answer: Rows = [("pi/2", 0.75, 0.66, "q1")]
    policy = Policy(tool=ToolRule.FRAME, zero=ZeroRule.FIGURE)
    verdict = grade(read("modified", key), read("modified", answer), policy)
    assert {"row_missing", "theta_offset"} <= {edit.code for edit in verdict.repairs[0].edits}
    assert "row_missing" in {entry.code for entry in verdict.feedback}
    assert all(entry.row in (None, 1, 2) for entry in verdict.feedback)


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_two_joints_too_many_where_the_key_has_one(convention: str) -> None:
    """One axis leaves nothing to compare, whichever convention the answer is read in."""
    key = read(convention, [("pi/2", 0.3, 0.1, "q1")])
    answer = read("standard", [("pi/2", 0.3, 0.1, "q1"), (0, 0.2, 0, "q2"), (0, 0.2, 0.1, "q3")])
    verdict = grade(key, answer, Policy(tool=ToolRule.FREE))
    assert (verdict.correct, verdict.score) == (False, 0.0)


def test_the_work_of_a_search_is_bounded() -> None:
    """Sixty-four rows and a mistake: the meter, and no clock, ends the search."""
    junk: Rows = [(0, 0.01 * k, 0.02, 0.3) for k in range(58)]
    answer = read("standard", [*with_cells(PUMA, (4, 1, 0.2)), *junk])
    way = comparisons(KEY, answer, {})[0]
    work = work_on(way, (KEY, answer), USUAL)
    find_repairs(work)
    assert -PER_ROUND <= work.meter.left < MOST_WORK / 2


def test_long_tables_are_tried_less_often(monkeypatch: pytest.MonkeyPatch) -> None:
    """What an edit of fifty-eight rows costs is counted by the rows that are carried along for it."""
    carried = []

    def counted(tables: Sequence[NumericTable], variations: Sequence[Variation], policy: Policy) -> AxisBatch:
        carried.append(len(variations) * max(len(table.rows) for table in tables))
        return axes_of_tables(tables, variations, policy)

    monkeypatch.setattr(row_measures, "axes_of_tables", counted)
    hostile_answers(25, 2)
    assert 10**5 < sum(carried) < 10**6


@pytest.mark.parametrize(("block", "number"), [(41003, 17), (41007, 77)])
def test_a_step_that_costs_far_more_than_is_left_is_not_begun(
    block: int, number: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Arms of two and three joints in 58 rows: one batch of edits cost more than the whole search may."""
    spent = []
    charge = Meter.charge

    def counted(meter: Meter, units: int) -> None:
        charge(meter, units)
        spent.append(units)

    monkeypatch.setattr(Meter, "charge", counted)
    _, key, answer, policy = next(islice(hostile_tables(block), number - 1, None))
    assert not grade(key, answer, policy).correct
    assert sum(spent) <= MOST_WORK + OVERDRAFT


@pytest.mark.logs_errors
@pytest.mark.parametrize("step", ["find_repairs", "score_of", "wrong_facts"])
def test_where_an_explanation_fails_the_verdict_stands(step: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The failure is logged, and the student is told less."""

    def fails(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(f"exercises.grading.explanation.{step}", fails)
    answer = read("standard", with_cells(PUMA, (2, 1, f"a3*1.23{len(step)}")))
    verdict = grade(KEY, answer, replace(USUAL, tolerance=Tolerance(length=0.004)), VALUES)
    assert not verdict.correct
    assert verdict.feedback[0].code == "not_equivalent"
    assert (verdict.score == 0.0) is (step == "score_of")


def test_a_meter_refuses_when_it_is_empty() -> None:
    meter = Meter(10)
    meter.charge(7)
    with meter.at_most(2):
        meter.charge(2)
        meter.charge(1)
        pytest.fail("the step has spent its share")
    assert meter.left == 1
    with meter.at_most(5):
        meter.charge(5)
    with pytest.raises(WorkExhaustedError):
        meter.charge(1)


def test_a_tolerance_that_vanishes_is_explained() -> None:
    """A share of a size next to nothing is no number any more; the distance is then judged by itself."""
    key = read("modified", [(0, 0, 0, "q1"), ("1e-11", 0, "1e-13", "q2")])
    answer = read("standard", [("pi/4", 0.4, -1e15, "q1"), ("-pi/2", 0, -1e15, "q2")])
    none = Tolerance(length=1e-300, angle=1e-300)
    assert not grade(key, answer, Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, tolerance=none)).correct
