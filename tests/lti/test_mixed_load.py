"""The mixed load, for a moment: honest clients are served beside hostile ones."""

import pytest

from tests.lti.mixed_load import run


def test_honest_clients_are_served_beside_hostile_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    """By one process: `test_exam` has two."""
    monkeypatch.setattr("tests.lti.mixed_load.WORKERS", 1)
    monkeypatch.setenv("FRAMEWISE_QUEUE_SECONDS", "300")  # on a busy machine a turn comes late
    seen = run(minutes=0.02, seek=0.2, students=8)
    assert {name for name in seen.answers if not name.endswith((" 200", " 204"))} == set()
    assert seen.requests
    assert all(seen.memory)
