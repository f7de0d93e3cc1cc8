"""Whoever waits to write to an SQLite file comes next, whatever else its process or another one writes."""

import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from courses.refusals import StorageUnavailableError
from courses.storage import database as storage
from courses.storage.turns import TurnError, Turns

OTHER = """
import sys
from pathlib import Path
from courses.storage.turns import Turns

turns = Turns(Path(sys.argv[1]), 60.0)
for line in sys.stdin:
    print("waiting", flush=True)
    with turns.taken():
        print("taken", flush=True)
        sys.stdin.readline()
    print("given back", flush=True)
"""


@pytest.fixture
def turns(tmp_path: Path) -> Iterator[Turns]:
    """Turns of this process."""
    with closing(Turns(tmp_path / "turns", 60.0)) as own:
        yield own


@contextmanager
def other_process(file: Path) -> Iterator[subprocess.Popen[str]]:
    """Another writer: told to take its turn by a line, and to give it back by another."""
    command = [sys.executable, "-c", OTHER, str(file)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()


def told(process: subprocess.Popen[str]) -> None:
    """Send a line."""
    assert process.stdin is not None
    process.stdin.write("\n")
    process.stdin.flush()


def heard(process: subprocess.Popen[str]) -> str:
    """Return the next line."""
    assert process.stdout is not None
    return process.stdout.readline().strip()


@contextmanager
def held(file: Path) -> Iterator[subprocess.Popen[str]]:
    """A turn of another process, which gives it back at the end unless it was killed."""
    with other_process(file) as other:
        told(other)
        assert [heard(other), heard(other)] == ["waiting", "taken"]
        yield other
        if other.poll() is None:
            told(other)
            assert heard(other) == "given back"


def is_next_taken(turns: Turns) -> bool:
    """Whether another process is the next one."""
    if turns._is_locked(0):
        turns._unlock(0)
        return False
    return True


def test_a_process_that_waits_comes_before_one_that_has_just_written(turns: Turns, tmp_path: Path) -> None:
    with other_process(tmp_path / "turns") as other:
        for _ in range(5):
            with turns.taken():
                told(other)
                assert heard(other) == "waiting"
                while not is_next_taken(turns):
                    pass
            told(other)
            with turns.taken():
                assert heard(other) == "taken"
                assert heard(other) == "given back"


def test_nobody_else_can_lock(turns: Turns, tmp_path: Path) -> None:
    assert (tmp_path / "turns").stat().st_mode & 0o077 == 0


def test_what_a_killed_process_held_is_free(turns: Turns, tmp_path: Path) -> None:
    with held(tmp_path / "turns") as other:
        other.kill()
        with turns.taken():
            assert other.wait()


def test_patience_ends(tmp_path: Path) -> None:
    with closing(Turns(tmp_path / "turns", 0.01)) as turns:
        with held(tmp_path / "turns"):
            for _ in range(2):  # who gave up holds nothing that the next one would wait for
                with pytest.raises(TurnError), turns.taken():
                    pass
        with turns.taken():
            pass


def test_whoever_writes_after_the_end_opens_the_locks_again(turns: Turns) -> None:
    """As SQLAlchemy opens connections: a thread may still store what it has when all is being closed."""
    turns.close()
    with turns.taken():
        turns.close()
    with turns.taken():
        pass


def test_locks_that_are_gone_are_said_to_be(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    turns = Turns(tmp_path / "folder" / "turns", 60.0)
    turns.close()
    (tmp_path / "folder" / "turns").unlink()
    (tmp_path / "folder").rmdir()
    with pytest.raises(TurnError), turns.taken():
        pass


def test_threads_write_one_after_another(turns: Turns) -> None:
    inside, most = [0], [0]

    def write() -> None:
        for _ in range(50):
            with turns.taken():
                inside[0] += 1
                most[0] = max(most[0], inside[0])
                time.sleep(0.0005)  # another thread runs
                inside[0] -= 1

    threads = [threading.Thread(target=write) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert most == [1]


def test_a_turn_that_does_not_come_is_a_database_that_does_not_answer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(storage, "BUSY_SECONDS", 0.01)
    store = storage.open_store("", tmp_path)
    with held(tmp_path / "framewise.turns"), pytest.raises(StorageUnavailableError), store.writing():
        pass
    with store.writing():
        pass
    store.close()
