"""Some of the campaigns on answers as students type them; `make campaign` runs many more."""

import pytest

from exercises.grading import HelpLevel, Policy, explanation, grade
from exercises.grading import grade as grading
from kinematics.equivalence.reference import prepared
from tests.exercises.grading.answers_campaign import (
    accused_rows,
    hostile_answers,
    rounded_answers,
    wrong_names,
)
from tests.exercises.grading.campaign import repeated_entries, score_chains
from tests.exercises.grading.test_grade import KEY, PUMA, USUAL, VALUES, Rows, with_cells
from tests.exercises.grading.written import read


def test_rounded_answers_are_accepted_under_any_rules() -> None:
    outcome = rounded_answers(0, 60)
    assert (outcome.accepted, outcome.failures) == (60, [])


def test_a_wrong_name_gets_one_verdict() -> None:
    outcome = wrong_names(0, 5)
    assert outcome.failures == []


def test_no_answer_raises() -> None:
    outcome = hostile_answers(0, 12)
    assert [failure for failure in outcome.failures if not failure.startswith("takes")] == []


@pytest.mark.logs_errors
def test_a_lost_explanation_is_a_failure_of_the_campaign(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(explanation, "find_repairs", fails)
    failures = hostile_answers(1, 3).failures
    assert any(failure.startswith("explanation lost, no repairs: ZeroDivisionError") for failure in failures)


def test_the_score_never_rises_with_one_more_mistake() -> None:
    outcome = score_chains(0, 3)
    assert outcome.failures == []


def test_cells_that_no_fact_asks_for_change_no_mark() -> None:
    outcome = repeated_entries(0, 5)
    assert outcome.failures == []


def test_the_row_of_a_mistake_is_accused() -> None:
    outcome = accused_rows(0, 20)
    assert outcome.right_row >= 19, outcome.failures


def test_a_score_owes_nothing_to_caches_help_or_rows_of_zeros() -> None:
    zeros: Rows = [(0, 0, 0, 0)] * 20
    rows = with_cells(PUMA, (2, 1, "a3"), (5, 0, 0))
    scores = set()
    for level in HelpLevel:
        for table in (rows, [*rows, *zeros], [*zeros, *rows]):
            grading.__globals__["_grade"].cache_clear()
            grading.__globals__["_decided"].cache_clear()
            prepared.cache_clear()
            scores.add(grade(KEY, read("standard", table), USUAL, VALUES, level).score)
    assert len(scores) == 1


def test_what_mistakes_cost() -> None:
    """A slipped sign costs least, a missing joint most; every further fact costs more."""

    def score(rows: Rows) -> float:
        return grade(KEY, read("standard", rows), Policy(), VALUES).score

    sign = score(with_cells(PUMA, (3, 2, "-d3")))
    length = score(with_cells(PUMA, (2, 1, "d4")))
    two = score(with_cells(PUMA, (2, 1, "d4"), (3, 1, 0)))
    three = score(with_cells(PUMA, (2, 1, "d4"), (3, 1, 0), (4, 2, 0)))
    missing = score([PUMA[0], *[(*row[:3], f"q{k}") for k, row in enumerate(PUMA[2:], 2)]])
    assert 1.0 > sign > length > two > three > 0.0
    assert sign > missing
    assert score([(0, 0, 0, f"q{k}") for k in range(1, 7)]) == 0.0


@pytest.mark.parametrize(
    "changes",
    [
        [(2, 1, "d4"), (4, 2, "a2")],
        [(2, 1, "d4")],
        [(4, 2, "a2"), (5, 0, "pi/4")],
    ],
)
def test_what_is_told_of_names_does_not_depend_on_values_that_are_equal(
    changes: list[tuple[int, int, str]],
) -> None:
    answer = read("standard", with_cells(PUMA, *changes))
    apart, equal = (grade(KEY, answer, USUAL, {**VALUES, "d4": d4}) for d4 in (0.35, VALUES["a2"]))
    assert not equal.correct
    assert (equal.score, equal.links, equal.feedback, equal.repairs) == (
        apart.score,
        apart.links,
        apart.feedback,
        apart.repairs,
    )


def test_a_slip_among_rounded_numbers_is_mended() -> None:
    """Of two decimals, 0.02 for 0.0203 is off by more than a per cent, and right."""
    rounded: Rows = [
        (90, 0, 0, "q1"),
        (0, 0.43, 0, "q2"),
        (-90, 0.02, 0.15, "q3"),
        (90, 0, 0.35, "q4"),
        (-90, 0, 0, "q5"),
        (0, 0, 0, "q6"),
    ]
    assert grade(KEY, read("standard", rounded, "deg"), USUAL, VALUES).correct
    verdict = grade(KEY, read("standard", with_cells(rounded, (5, 0, -60)), "deg"), USUAL, VALUES)
    (repair,) = verdict.repairs
    assert [(edit.code, edit.row) for edit in repair.edits] == [("alpha_value", 5)]
