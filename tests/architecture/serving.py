"""Start the service as a person would, in a process of its own."""

import contextlib
import os
import re
import signal
import socket
import subprocess
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

LISTENING = re.compile(r"running on (http://[^\s]+)")
PATIENCE = 300.0
"""Seconds until what should happen counts as not happening; much, because machines may be busy."""


@contextlib.contextmanager
def reserved_port() -> Iterator[int]:
    """A port of the loopback that a server may listen on, and that nobody else is given meanwhile."""
    with socket.socket() as held:
        held.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        held.bind(("127.0.0.1", 0))
        port: int = held.getsockname()[1]
        yield port


@contextlib.contextmanager
def serving(
    command: Sequence[str],
    *,
    cwd: Path,
    environment: Mapping[str, str] = MappingProxyType({}),
    bare: bool = False,
    user: int | None = None,
    patience: float = PATIENCE,
) -> Iterator[str]:
    """Run a command that serves on a free port (0); yields the address that it prints.

    The environment is added to this process's, or, when bare, stands instead of it.
    """
    process = subprocess.Popen(
        command,
        cwd=cwd,
        env=dict(environment) if bare else {**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
        user=user,
        group=user,
        extra_groups=[] if user is not None else None,
    )
    printed: list[str] = []
    reader = threading.Thread(target=_collect, args=(process, printed), daemon=True)
    reader.start()
    try:
        yield _address(process, printed, patience)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGTERM)
        try:
            process.wait(timeout=60)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        reader.join()
        assert process.stdout is not None
        process.stdout.close()


def fetched(address: str, path: str) -> tuple[int, bytes]:
    """Status and body of a GET."""
    try:
        with urllib.request.urlopen(address + path, timeout=PATIENCE) as response:
            return response.status, response.read()
    except urllib.error.HTTPError as error:
        with error:
            return error.code, error.read()


def received(connection: socket.socket) -> bytes:
    """All that comes until the server closes."""
    found = b""
    with contextlib.suppress(ConnectionError):
        while piece := connection.recv(65536):
            found += piece
    return found


def _collect(process: subprocess.Popen[str], printed: list[str]) -> None:
    assert process.stdout is not None
    printed.extend(iter(process.stdout.readline, ""))


def _address(process: subprocess.Popen[str], printed: list[str], patience: float) -> str:
    deadline = time.monotonic() + patience
    while time.monotonic() < deadline:
        found = LISTENING.search("".join(printed))
        if found:
            return found.group(1).replace("0.0.0.0", "127.0.0.1")
        if process.poll() is not None:
            break
        time.sleep(0.02)
    raise AssertionError("the service did not start:\n" + "".join(printed))
