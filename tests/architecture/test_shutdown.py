"""The server ends when it is told to, whatever callers do, and answers what it can before."""

from __future__ import annotations

import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

import httpx
import pytest

from tests.architecture.sources import ROOT

patient = httpx.Client(timeout=120, headers={"Connection": "close"})
"""Machines that run tests may be busy."""

COMMAND = [sys.executable, "-m", "service", "--port", "0"]


@contextmanager
def server(**environment: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    process = subprocess.Popen(
        COMMAND,
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
    reader = threading.Thread(target=process.stderr.read, daemon=True)
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
    for _ in range(3000):
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


@pytest.mark.parametrize("workers", ["1", "2"])
def test_half_a_body_does_not_keep_it_alive(workers: str) -> None:
    environment = {"FRAMEWISE_SHUTDOWN_SECONDS": "1", "FRAMEWISE_READ_SECONDS": "600"}
    with server(**environment, FRAMEWISE_WORKERS=workers) as (process, address), connected(address) as half:
        patient.get(f"{address}/healthz")
        half.sendall(b"POST /api/v1/jacobian HTTP/1.1\r\nHost: here\r\nContent-Length: 900\r\n"
                     b"Content-Type: application/json\r\n\r\n{")  # fmt: skip
        patient.get(f"{address}/healthz")
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=60) in (0, -signal.SIGTERM)


def test_what_has_begun_is_answered() -> None:
    with server() as (process, address), connected(address) as begun:
        body = b'{"robot":"puma560","joints":[0,0,0,0,0,0]}'
        head = b"POST /api/v1/jacobian HTTP/1.1\r\nHost: here\r\nContent-Type: application/json\r\n"
        begun.sendall(head + b"Content-Length: %d\r\n\r\n" % len(body) + body[:10])
        patient.get(f"{address}/healthz")
        process.send_signal(signal.SIGTERM)
        begun.sendall(body[10:])
        assert begun.recv(64).startswith(b"HTTP/1.1 200 ")
        assert process.wait(timeout=60) in (0, -signal.SIGTERM)


def test_nothing_is_left_in_the_folder_for_temporary_files(tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("temporary")
    with server(TMPDIR=str(folder)) as (process, address):
        table = {"convention": "standard", "rows": [{"alpha": 0, "a": "L1", "d": 0, "theta": "q1"}]}
        assert patient.post(f"{address}/api/v1/symbolic", json={"table": table}).status_code == 200
        process.send_signal(signal.SIGTERM)
        process.wait(timeout=60)
    assert list(folder.iterdir()) == []
