"""The server ends when it is told to, whatever callers do, and answers what it can before."""

import contextlib
import os
import re
import signal
import socket
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx
import pytest

from courses.storage.database import FILE_NAME
from tests.architecture.serving import received
from tests.architecture.sources import ROOT

patient = httpx.Client(timeout=120, headers={"Connection": "close"})
"""Machines that run tests may be busy."""

COMMAND = [sys.executable, "-m", "service", "--port", "0"]
HASTY = [
    *(sys.executable, "-c"),
    "from service.cli import serve; serve._ENDING_SECONDS = 3; from service.__main__ import main; main()",
    *("--port", "0"),
]
"""Ends a process that does not end by itself nine seconds sooner."""
PATIENT = [
    *(sys.executable, "-c"),
    "from courses.storage import engines; engines.BUSY_SECONDS = 600.0; "
    "from service.__main__ import main; main()",
    *("--port", "0"),
]
"""Waits for a database longer than any test for its end."""


@contextmanager
def server(
    log: list[str] | None = None, command: list[str] = COMMAND, **environment: str
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Start a server; what it logs from then on is added to `log` when it has ended."""
    log = [] if log is None else log
    process = subprocess.Popen(
        command,
        cwd=ROOT,
        env={**os.environ, **environment},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stderr is not None
    found = None
    while not found:
        line = process.stderr.readline()
        assert line, "the server did not start"
        found = re.search(r"running on (http://\S+)", line)
    reader = threading.Thread(target=lambda: log.append(process.stderr.read()), daemon=True)
    reader.start()
    try:
        _wait_for(found[1])
        yield process, found[1]
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        reader.join()
        process.stderr.close()


def _wait_for(address: str) -> None:
    """With several processes the address is printed before one of them listens."""
    for _ in range(15_000):
        try:
            patient.get(f"{address}/healthz")
        except httpx.ConnectError:
            time.sleep(0.02)
        else:
            return
    raise AssertionError("the server does not listen")


def connected(address: str) -> socket.socket:
    host, _, port = address.removeprefix("http://").partition(":")
    return socket.create_connection((host, int(port)), timeout=60)


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Lock the database in a folder as another program may."""
    with contextlib.closing(sqlite3.connect(folder / FILE_NAME, isolation_level=None, timeout=60)) as other:
        other.execute("BEGIN IMMEDIATE")
        yield


@pytest.mark.parametrize("workers", ["1", "2"])
def test_half_a_body_does_not_keep_it_alive_nor_the_door_open(workers: str) -> None:
    """It is refused as by a busy service; it got a bare 500, and the log a traceback.

    Until then who comes is refused: the process that looks after others kept the door open, and nobody
    behind it.
    """
    # with little time the end may come while this process stands still and does not see who is refused
    assert any(refuses_before_the_end(workers, seconds) for seconds in ("4", "20", "60")), (
        "nobody was refused while a request was in progress"
    )


def refuses_before_the_end(workers: str, seconds: str) -> bool:
    """Whether a server that has so long for half a body was seen to refuse others before it ended."""
    log: list[str] = []
    environment = {"FRAMEWISE_SHUTDOWN_SECONDS": seconds, "FRAMEWISE_READ_SECONDS": "600"}
    environment["FRAMEWISE_WORKERS"] = workers
    with server(log, **environment) as (process, address), connected(address) as half:
        half.sendall(b"POST /api/v1/jacobian HTTP/1.1\r\nHost: here\r\nContent-Length: 900\r\n"
                     b"Content-Type: application/json\r\nExpect: 100-continue\r\n\r\n")  # fmt: skip
        assert half.recv(64).startswith(b"HTTP/1.1 100 ")  # this request is in progress
        half.sendall(b"{")
        process.send_signal(signal.SIGTERM)
        while not refuses(address):
            time.sleep(0.05)
        meanwhile = process.poll() is None
        half.settimeout(120)
        answer = received(half)
        assert process.wait(timeout=120) == 0
    assert answer.startswith(b"HTTP/1.1 503 ")
    assert b"retry-after: 2" in answer.lower()
    assert b'"code":"busy"' in answer
    assert "Traceback" not in "".join(log)
    return meanwhile


def refuses(address: str) -> bool:
    try:
        connected(address).close()
    except ConnectionRefusedError:
        return True
    return False


def test_what_has_begun_is_answered() -> None:
    with server(FRAMEWISE_SHUTDOWN_SECONDS="120") as (process, address), connected(address) as begun:
        body = b'{"robot":"puma560","joints":[0,0,0,0,0,0]}'
        head = b"POST /api/v1/jacobian HTTP/1.1\r\nHost: here\r\nContent-Type: application/json\r\n"
        begun.sendall(head + b"Content-Length: %d\r\n\r\n" % len(body) + body[:10])
        patient.get(f"{address}/healthz")
        process.send_signal(signal.SIGTERM)
        begun.sendall(body[10:])
        assert begun.recv(64).startswith(b"HTTP/1.1 200 ")
        assert process.wait(timeout=60) == 0


def test_a_database_that_does_not_answer_does_not_keep_it_alive(tmp_path: Path) -> None:
    """Threads that waited for the lock were waited for one after the other, as long as they liked."""
    environment = {"FRAMEWISE_STORAGE": "on", "FRAMEWISE_DATA_FOLDER": str(tmp_path)}
    log: list[str] = []
    environment["FRAMEWISE_SHUTDOWN_SECONDS"] = "1"
    with server(log, PATIENT, **environment) as (process, _), locked(tmp_path):
        time.sleep(3.0)  # the sender of scores looks for some each second, and waits
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=120) == 0
    assert "Traceback" not in "".join(log)


def test_a_process_that_stands_still_does_not_keep_several_alive() -> None:
    """The end was waited for without end, and the signal not heard for as long as a minute."""
    with server(command=HASTY, FRAMEWISE_SHUTDOWN_SECONDS="1", FRAMEWISE_WORKERS="2") as (process, _):
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        serving = [
            int(each) for each in children if b"spawn_main" in Path(f"/proc/{each}/cmdline").read_bytes()
        ]
        os.kill(serving[0], signal.SIGSTOP)
        time.sleep(1.2)  # it is asked twice a second, and answers no more
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=120) == 0


def test_nothing_is_left_in_the_folder_for_temporary_files(tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("temporary")
    with server(TMPDIR=str(folder)) as (process, address):
        table = {"convention": "standard", "rows": [{"alpha": 0, "a": "L1", "d": 0, "theta": "q1"}]}
        assert patient.post(f"{address}/api/v1/symbolic", json={"table": table}).status_code == 200
        process.send_signal(signal.SIGTERM)
        process.wait(timeout=60)
    assert list(folder.iterdir()) == []
