"""Simulated students: hints lead to full marks and tell no key; marks fall with every fact that is wrong."""

import re
from collections.abc import Sequence
from itertools import pairwise

import pytest

from exercises.answers import RawAnswer, parse
from exercises.definition import LANGUAGES
from exercises.grader import grade
from exercises.grading import Verdict
from exercises.instance import Instance
from exercises.written_table import written_table
from kinematics.cells import ReadTable
from tests.exercises.students import (
    Slip,
    falling,
    miscounted,
    revealed,
    sentences,
    students,
    table_with,
    walk,
)

SOME = ("scara", "stanford", "puma560")
PLACEABLE = re.compile(r"[{}]|\[(feedback|repair)-")
"""What a sentence shows that was not written in a language, or not filled in."""


@pytest.mark.parametrize("name", SOME)
def test_hints_lead_every_student_to_full_marks_and_tell_no_value_of_the_key(name: str) -> None:
    walked = 0
    for instance, truth, slips in students(name, pairs=4):
        found = walk(instance, truth, slips)
        if found is None:
            continue
        walked += 1
        assert found.correct, (slips, found.scores)
        assert found.scores[-1] == 1
        for language in LANGUAGES:
            assert not revealed(found, truth, language)
            told = [text for report, _ in found.hints for text in sentences(report, language)]
            assert told
            assert not any(PLACEABLE.search(text) for text in told), told
    assert walked >= 12


def test_one_more_slip_beside_a_wrong_count_of_joints_is_told() -> None:
    """Where columns were moved a row on, what stood in the last one is lost: no edit brings it back."""
    told: list[bool] = []
    for instance, truth, slips in miscounted("uw"):
        found = walk(instance, truth, slips)
        if found is None:
            continue
        verdict = repaired(instance, truth, slips)
        in_one = any(len(repair.edits) < len(slips) for repair in verdict.repairs)
        assert found.correct or in_one, (slips, found.scores)
        codes = {slip.code for slip in slips}
        if not codes & {"columns_late", "columns_early"}:
            told.append(bool(verdict.repairs))
            assert verdict.repairs or "joint_fixed" not in codes, slips
    assert len(told) > 30
    assert sum(told) >= 0.95 * len(told)


def test_a_row_without_its_variable_is_named_though_a_row_put_in_would_do() -> None:
    """Along parallel axes a row put in mends both slips; whoever made them finds nothing there."""
    slips = (Slip("d_sign", 7), Slip("joint_fixed", 3))
    instance, truth, _ = next(students("uw", pairs=0, seed=7))
    found = [[edit.code for edit in repair.edits] for repair in repaired(instance, truth, slips).repairs]
    assert ["row_missing"] in found
    assert ["joint_fixed", "d_sign"] in found
    walked = walk(instance, truth, slips)
    assert walked is not None
    assert walked.correct


def repaired(instance: Instance, truth: ReadTable, slips: Sequence[Slip]) -> Verdict:
    """The verdict on a student's first table, with everything told."""
    table = table_with(truth, slips)
    assert table is not None
    answer = parse(instance, RawAnswer(table=written_table(table)))
    verdict = grade(instance, answer, attempt=3).verdict
    assert verdict is not None
    return verdict


@pytest.mark.parametrize("name", SOME)
def test_marks_fall_with_every_fact_that_is_wrong(name: str) -> None:
    chains = list(falling(name, count=8))
    for slips, scores in chains:
        assert scores[0] == 1
        assert all(score < 1 for score in scores[1:])
        assert all(after <= before for before, after in pairwise(scores)), (slips, scores)
    steps = [before > after for _, scores in chains for before, after in pairwise(scores) if before > 0]
    assert sum(steps) > 0.75 * len(steps)
