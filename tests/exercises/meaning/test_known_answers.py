"""Some of the answers of `make campaign-answers`: no right one is refused, no wrong one is accepted."""

from __future__ import annotations

import pytest

from tests.exercises.meaning.campaign_of_answers import CAMPAIGNS, judged_answers

FEW = 120


@pytest.mark.parametrize("name", CAMPAIGNS)
def test_answers_are_judged_as_they_are(name: str) -> None:
    found = judged_answers(name, 0, FEW)
    assert not found.misjudged
    assert min(found.right, found.wrong) > FEW / 8
