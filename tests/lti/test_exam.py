"""An exam of two small classes: nothing is refused, nothing lost, and right is right."""

from pathlib import Path

import pytest

from tests.lti.exam import run

STUDENTS = 5


def test_nothing_is_refused_and_nothing_lost(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each student of one class has values of their own; those of the other share three sets."""
    monkeypatch.setenv("FRAMEWISE_QUEUE_SECONDS", "300")  # on a busy machine a turn comes late
    outcome = run(STUDENTS, [None, 3], tmp_path, within=(0.2, 0.2))
    assert outcome.answers == {200: 5 * 2 * STUDENTS}
    assert (outcome.errors, outcome.lost) == (0, 0)
    assert outcome.right == outcome.expected == 2 * STUDENTS * 2 // 5
