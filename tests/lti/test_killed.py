"""`kill -9` under load: what was acknowledged is stored once, on both databases.

`make kill-campaign` is the whole campaign; the suite kills twice on SQLite and once on PostgreSQL, where
`test_regrading_killed` has a service that starts after another one was killed.
"""

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
import time
import uuid
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import httpx
import sqlalchemy as sa

from courses.model import Role
from courses.people.enrolment import Arrival, arrive
from courses.storage import records
from courses.storage.database import Store, open_store
from service.course_resources import now
from service.resources import MANY_ANSWERS
from tests.courses.classroom import platform
from tests.lti.test_launches import RIGHT

KILLS = int(os.environ.get("KILLS", "0"))
STUDENTS = 4
CROWD = 4 * (MANY_ANSWERS + 1)
"""Students, so many that in each of two processes their attempts are gathered for a transaction."""


def test_what_was_acknowledged_is_stored_once(database: str, tmp_path: Path) -> None:
    store = open_store(database, tmp_path)
    tokens = _students(store, STUDENTS)
    acknowledged: set[str] = set()
    for _ in range(KILLS or (1 if database else 2)):
        with killed(database, tmp_path) as (origin, process), _handing_in(origin, tokens, acknowledged):
            _wait_for_more(acknowledged, 2 * STUDENTS, process)
            process.send_signal(signal.SIGKILL)
    _assert_stored_once(store, acknowledged)


def test_what_a_crowd_hands_in_while_processes_end_is_stored_once(tmp_path: Path) -> None:
    """One of two is killed, then all are told to end.

    Their attempts are stored many at a time, and those of a moment may have been judged and not stored.
    """
    store = open_store("", tmp_path)
    tokens = _students(store, CROWD)
    acknowledged: set[str] = set()
    with killed("", tmp_path, {"FRAMEWISE_WORKERS": "2"}) as (origin, process):
        with _handing_in(origin, tokens, acknowledged):
            _wait_for_more(acknowledged, CROWD, process)
            os.kill(_servers(process.pid)[0], signal.SIGKILL)
            _wait_for_more(acknowledged, 2 * CROWD, process)
            process.send_signal(signal.SIGTERM)
            process.wait(timeout=120)
        assert process.poll() == 0
    _assert_stored_once(store, acknowledged)


def _students(store: Store, count: int) -> list[str]:
    """The tokens of so many students."""
    told = {"deployment": "1", "context": "c", "resource": "r", "exercise_id": "puma560"}
    arrivals = (
        Arrival(platform=platform(store), subject=f"s{n}", role=Role.LEARNER, **told)  # type: ignore[arg-type]
        for n in range(count)
    )
    return [arrive(store, arrival, now())[0] for arrival in arrivals]


@contextlib.contextmanager
def _handing_in(origin: str, tokens: Sequence[str], acknowledged: set[str]) -> Iterator[None]:
    """Have students hand in, one answer after another, until the end."""
    stop = threading.Event()
    threads = [threading.Thread(target=_submit, args=(origin, token, acknowledged, stop)) for token in tokens]
    for thread in threads:
        thread.start()
    try:
        yield
    finally:
        stop.set()
        for thread in threads:
            thread.join()


def _wait_for_more(acknowledged: set[str], count: int, process: subprocess.Popen[bytes]) -> None:
    """Until so many more answers have been acknowledged."""
    known = len(acknowledged)
    while len(acknowledged) < known + count and process.poll() is None:
        time.sleep(0.02)


def _servers(supervisor: int) -> list[int]:
    """The processes that serve, started by one that looks after them."""
    children = Path(f"/proc/{supervisor}/task/{supervisor}/children").read_text().split()
    return [int(pid) for pid in children if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes()]


def _assert_stored_once(store: Store, acknowledged: set[str]) -> None:
    with store.reading() as connection:
        keys = list(connection.scalars(sa.select(records.attempt.c.key)))
        made = connection.scalar(sa.select(sa.func.sum(records.participation.c.made)))
    store.close()
    assert acknowledged
    assert acknowledged <= set(keys)
    assert len(keys) == len(set(keys)) == made


def _submit(origin: str, token: str, acknowledged: set[str], stop: threading.Event) -> None:
    """Hand in until told to stop; what is not answered is sent again with its key, as the page does."""
    key = uuid.uuid4().hex
    with httpx.Client(trust_env=False, timeout=120) as client:
        while not stop.is_set():
            headers = {"Authorization": f"Bearer {token}", "Idempotency-Key": key}
            try:
                answer = client.post(f"{origin}/api/v1/session/attempts", json=RIGHT, headers=headers)
            except httpx.HTTPError:
                stop.wait(0.25)
                continue
            if answer.status_code == 200:
                acknowledged.add(key)
                key = uuid.uuid4().hex


class killed:
    """A service in a process of its own, killed at the end."""

    def __init__(
        self,
        database: str,
        folder: Path,
        told: Mapping[str, str] = {},
        port: int = 0,
        program: Sequence[str] = ("-m", "service"),
    ) -> None:
        environment = {
            **os.environ,
            **told,
            "FRAMEWISE_STORAGE": "on",
            "FRAMEWISE_DATABASE_URL": database,
            "FRAMEWISE_DATA_FOLDER": str(folder),
        }
        command = [sys.executable, *program, "serve", "--port", str(port)]
        pipes = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
        self.process = subprocess.Popen(command, env=environment, start_new_session=True, **pipes)

    def __enter__(self) -> tuple[str, subprocess.Popen[bytes]]:
        """Wait until it listens."""
        assert self.process.stderr
        said = []
        for line in self.process.stderr:
            said.append(line.decode())
            found = re.search(r"running on (http://\S+)", said[-1])
            if found:
                return found[1], self.process
        raise AssertionError("".join(said))

    def __exit__(self, *_: object) -> None:
        """End it with its workers."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        assert self.process.stderr
        self.process.stderr.close()
