"""The packaged exercises are read after the start, or when they are asked for."""

import threading
import time
from typing import Any

import pytest

from exercises import library
from exercises.definition import Exercise
from exercises.library import Library
from exercises.loader import exercise_of_files
from service.app import create_app
from service.settings import Settings
from service.work.drawing_ahead import ReadingAhead
from tests.live_service import running

PATIENCE = 120.0


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The exercises that were read, in their order; by now every service of other tests has read its own."""
    for thread in threading.enumerate():
        if thread.name == "reading-ahead":
            thread.join(PATIENCE)
    found: list[str] = []

    def noting(exercise_id: str, files: Any, **options: bool) -> Exercise:
        found.append(exercise_id)
        return exercise_of_files(exercise_id, files, **options)

    monkeypatch.setattr(library, "exercise_of_files", noting)
    return found


def test_making_a_service_reads_no_packaged_exercise(read: list[str]) -> None:
    """That took a fifth of a second of each start."""
    app = create_app(Settings(storage="off"))
    try:
        assert not read
        assert app.state.resources.exercises.exercise("rx90").id == "rx90"
        assert read == ["rx90"]
    finally:
        app.state.resources.close()


def test_a_service_that_runs_reads_them_all(read: list[str]) -> None:
    with running(Settings(storage="off"), ahead=True):
        until = time.monotonic() + PATIENCE
        while set(read) != set(Library().ids) and time.monotonic() < until:
            time.sleep(0.05)
    assert sorted(read) == list(Library().ids)


def test_what_was_asked_for_before_its_turn_stays_the_one_there_is(read: list[str]) -> None:
    library = Library()
    asked = library.exercise("puma560")
    reading = ReadingAhead(library)
    reading.stop()  # before it began: nothing is read
    reading._run()
    assert read == ["puma560"]
    reading.stopping.clear()
    reading._run()
    assert library.exercise("puma560") is asked
    assert sorted(read) == list(library.ids)
