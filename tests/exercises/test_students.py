"""Simulated students: hints lead to full marks and tell no key; marks fall with every fact that is wrong."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest

from exercises.definition import LANGUAGES
from tests.exercises.students import falling, revealed, sentences, students, walk

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


@pytest.mark.parametrize("name", SOME)
def test_marks_fall_with_every_fact_that_is_wrong(name: str) -> None:
    chains = list(falling(name, count=8))
    for slips, scores in chains:
        assert scores[0] == 1
        assert all(score < 1 for score in scores[1:])
        assert all(after <= before for before, after in pairwise(scores)), (slips, scores)
    steps = [before > after for _, scores in chains for before, after in pairwise(scores) if before > 0]
    assert sum(steps) > 0.75 * len(steps)
