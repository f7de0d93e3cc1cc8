"""Whether the service is alive and ready, and which version it is."""

import os
import signal
import time

import httpx

from service import __version__
from service.app import create_app
from service.settings import Settings
from tests.live_service import running


def test_alive_and_which_version(client: httpx.Client) -> None:
    for path in ("/livez", "/healthz"):
        assert client.get(path).json() == {"status": "ok"}
    assert client.get("/version").json() == {"name": "framewise", "version": __version__}


def test_ready_is_true_to_the_worker_processes() -> None:
    with running(Settings(), ahead=True) as url, httpx.Client(base_url=url, timeout=120) as client:
        assert client.get("/readyz").status_code == 200
        table = {"convention": "standard", "rows": [{"alpha": 0, "a": "L1", "d": 0, "theta": "q1"}]}
        assert client.post("/api/v1/symbolic", json={"table": table}).status_code == 200
        children = [pid for pid in _children() if b"worker_process" in _command(pid)]
        assert len(children) >= 2
        for pid in children:
            os.kill(pid, signal.SIGKILL)
        states = set()
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline:
            answer = client.get("/readyz")
            states.add((answer.status_code, answer.json()["status"]))
            if answer.status_code == 200 and (503, "starting") in states:
                break
            time.sleep(0.01)
        assert states <= {(200, "ready"), (503, "starting")}
        assert (503, "starting") in states
        again = {"table": {**table, "convention": "modified"}}
        assert client.post("/api/v1/symbolic", json=again).status_code == 200


def _children() -> list[int]:
    found = []
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                with open(f"/proc/{name}/stat") as file:
                    if int(file.read().rpartition(")")[2].split()[1]) == os.getpid():
                        found.append(int(name))
            except (FileNotFoundError, ProcessLookupError):  # it has ended meanwhile
                continue
    return found


def _command(pid: int) -> bytes:
    try:
        with open(f"/proc/{pid}/cmdline", "rb") as file:
            return file.read()
    except (FileNotFoundError, ProcessLookupError):
        return b""


def test_two_applications_have_each_their_own_processes() -> None:
    first, second = create_app(Settings()), create_app(Settings())
    assert first.state.resources.workers is not second.state.resources.workers
