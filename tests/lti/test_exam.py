"""An exam of a small class: nothing is refused, nothing lost, and right is right."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.lti.exam import run

STUDENTS = 10


@pytest.mark.parametrize("variants", [None, 3])
def test_nothing_is_refused_and_nothing_lost(variants: int | None, tmp_path: Path) -> None:
    outcome = run(STUDENTS, variants, tmp_path, within=(0.2, 0.2))
    assert outcome.answers == {200: 5 * STUDENTS}
    assert (outcome.errors, outcome.lost) == (0, 0)
    assert outcome.right == outcome.expected == 2 * STUDENTS // 5
