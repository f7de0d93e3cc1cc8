"""The service over HTTP beside an empty endpoint of the same application and beside the library."""

import contextlib
import http.client
import io
import json
import re
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from bench import Better, Outcome, Skipped, measured, race

TITLE = "The service over HTTP"
ABOUT = """
One worker, 32 connections kept open, `wrk` on the same machine, rounds in turns, medians. The *empty
endpoint* is a route of the same application, `async def empty(): return {}`, sent the same body. The *bare
endpoint* is the least that the application can answer with: the body is read and two bytes are written, past
FastAPI's own handling. Our figure is the same in both rows. The answer to `/forward-kinematics` is all of it
(⁰T_6, six links, six frames, position, orientation in four notations; 3 kB), computed anew for each request.

The npy row is a client's whole round trip on one connection: 4.8 MB of joint values there, 12.8 MB of poses
back.
"""

PATH = "/api/v1/forward-kinematics"
ROUNDS = 5
SECONDS = 3
CONNECTIONS = 32
MANY = 100_000
ROOT = Path(__file__).resolve().parent.parent

PUMA = {
    "convention": "standard",
    "rows": [
        {"joint": "revolute", "alpha": "pi/2", "a": 0, "d": 0, "theta": "q1"},
        {"joint": "revolute", "alpha": 0, "a": 0.4318, "d": 0, "theta": "q2"},
        {"joint": "revolute", "alpha": "-pi/2", "a": 0.0203, "d": 0.15005, "theta": "q3"},
        {"joint": "revolute", "alpha": "pi/2", "a": 0, "d": 0.4318, "theta": "q4"},
        {"joint": "revolute", "alpha": "-pi/2", "a": 0, "d": 0, "theta": "q5"},
        {"joint": "revolute", "alpha": 0, "a": 0, "d": 0, "theta": "q6"},
    ],
}


def rows() -> list[Outcome]:
    """Measure."""
    with _serving() as port:
        return [*_requests(port), *_batch(port)]


def _requests(port: int) -> list[Outcome]:
    work = "`POST /forward-kinematics`, one configuration"
    if shutil.which("wrk") is None:
        return [Skipped(work=work, reason="needs wrk (Debian: the package wrk)")]
    body = json.dumps({"table": PUMA, "joints": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]})
    rates: dict[str, list[float]] = {PATH: [], "/empty": [], "/bare": []}
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "post.lua"
        script.write_text(
            "wrk.method = 'POST'\n"
            "wrk.headers['Content-Type'] = 'application/json'\n"
            f"wrk.body = {json.dumps(body)}\n"
        )
        for path in rates:
            _wrk(port, path, script, 1)
        for _ in range(ROUNDS):
            for path, found in rates.items():
                found.append(_wrk(port, path, script, SECONDS))
    ours, empty, bare = (statistics.median(found) for found in rates.values())
    return [
        measured(work, peer=peer, ours=ours, theirs=theirs, unit="requests/s", better=Better.MORE, bar=bar)
        for peer, theirs, bar in (
            ("an empty endpoint of the same application", empty, 0.6),
            ("a bare endpoint of the same application", bare, None),
        )
    ]


def _wrk(port: int, path: str, script: Path, seconds: int) -> float:
    report = subprocess.run(
        ["wrk", "-t1", f"-c{CONNECTIONS}", f"-d{seconds}", "-s", script, f"http://127.0.0.1:{port}{path}"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    if "Non-2xx" in report:
        raise AssertionError(report)
    return float(re.findall(r"Requests/sec:\s+([\d.]+)", report)[0])


def _batch(port: int) -> list[Outcome]:
    from kinematics.cells import AngleUnit, RawRow, RawTable, bind_parameters, read_table
    from kinematics.forward import end_poses
    from kinematics.table import Convention, JointType

    raw = RawTable(
        convention=Convention.STANDARD,
        rows=tuple(RawRow(**{**row, "joint": JointType(row["joint"])}) for row in PUMA["rows"]),
        angle_unit=AngleUnit.RAD,
    )
    table = bind_parameters(read_table(raw), {})
    batch = np.random.default_rng(560).uniform(-np.pi, np.pi, (MANY, 6))
    connection = http.client.HTTPConnection("127.0.0.1", port)
    saved = io.BytesIO()
    np.save(saved, batch)
    address = f"{PATH}?request={json.dumps({'table': PUMA}, separators=(',', ':')).replace('+', '%2B')}"
    headers = {"Content-Type": "application/x-npy", "Accept": "application/x-npy"}

    def over_http() -> np.ndarray:
        connection.request("POST", address, body=saved.getbuffer(), headers=headers)
        response = connection.getresponse()
        body = response.read()
        assert response.status == 200, body[:300]
        return np.load(io.BytesIO(body), allow_pickle=False)

    np.testing.assert_allclose(over_http(), end_poses(table, batch), atol=1e-14)
    return race(
        "100 000 configurations over HTTP as npy, all of them",
        over_http,
        {"the same batch in process": lambda: end_poses(table, batch)},
        bars={"the same batch in process": 0.25},
        rounds=9,
    )


@contextlib.contextmanager
def _serving() -> Iterator[int]:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    command = [sys.executable, "-m", "uvicorn", "bench.empty_endpoint:application", "--factory"]
    options = ["--port", str(port), "--no-access-log", "--log-level", "warning", "--no-server-header"]
    process = subprocess.Popen([*command, *options], cwd=ROOT)
    try:
        _wait(port)
        yield port
    finally:
        process.terminate()
        process.wait(timeout=10)


def _wait(port: int) -> None:
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline:
        with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port), timeout=1):
            return
        time.sleep(0.05)
    raise AssertionError("the service did not start")
