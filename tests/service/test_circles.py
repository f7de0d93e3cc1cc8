"""What a request made goes with its answer, and is no garbage in circles that has to be looked for."""

import asyncio
import gc
import json
from collections import Counter
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any

import pytest

from service.app import create_app
from service.settings import Settings
from service.work.batcher import Batcher
from service.work.threads import in_thread
from service.work.workers import LaneProcesses
from tests.document import DOCUMENT

EXERCISE = "puma560"
Request = tuple[str, str, bytes]


def requests() -> Iterator[Request]:
    """Each example of each call, and with nothing for its first member; and what is refused on the way."""
    for path, methods in DOCUMENT["paths"].items():
        for method, call in methods.items():
            content = call.get("requestBody", {}).get("content", {}).get("application/json", {})
            for example in content.get("examples", {}).values():
                whole = example["value"]
                spoilt = [{**whole, next(iter(whole)): None}] if isinstance(whole, dict) and whole else []
                for body in (whole, *spoilt):
                    yield method.upper(), path.format(exercise_id=EXERCISE), json.dumps(body).encode()
    unread = {"convention": "standard", "rows": [{"theta": "q1", "d": "sin(", "a": 1, "alpha": 0}]}
    yield "POST", "/api/v1/symbolic", json.dumps({"table": unread}).encode()
    yield "POST", f"/api/v1/exercises/{EXERCISE}/grade", json.dumps({"table": unread}).encode()
    yield "GET", "/api/v1/exercises/unknown", b""


async def status_of(app: Any, request: Request) -> int:
    """Ask as a server does, and keep nothing."""
    method, path, body = request
    statuses: list[int] = []
    messages = iter([{"type": "http.request", "body": body, "more_body": False}])

    async def receive() -> dict[str, Any]:
        for message in messages:
            return message
        await asyncio.Event().wait()
        raise AssertionError

    async def send(message: Any) -> None:
        if message["type"] == "http.response.start":
            statuses.append(message["status"])

    headers = [(b"host", b"test"), (b"content-type", b"application/json")]
    await app(
        {
            "type": "http",
            "asgi": {"version": "3.0"},
            "http_version": "1.1",
            "method": method,
            "scheme": "http",
            "path": path,
            "query_string": b"",
            "root_path": "",
            "client": ("192.0.2.1", 1),
            "server": ("test", 80),
            "headers": headers,
        },
        receive,
        send,
    )
    return statuses[0]


@contextmanager
def garbage_alone() -> Iterator[None]:
    """Have the collector look at what is made from now on, when it is told to."""
    enabled = gc.isenabled()
    gc.collect()
    gc.freeze()
    gc.disable()
    try:
        yield
    finally:
        gc.unfreeze()
        if enabled:
            gc.enable()


PAUSES = (0.005, 0.02, 0.1, 0.5)
"""Seconds for what runs in threads to end: usually it has, and on a busy machine it takes longer."""


async def circles_of(do: Callable[[], Awaitable[object]]) -> Counter[str]:
    """Types of the objects that are left in circles when something is done again."""
    for pause in PAUSES:  # the first time makes what is kept; what runs in threads may end a little later
        gc.collect()
        gc.freeze()
        await do()
        await asyncio.sleep(pause)
        gc.set_debug(gc.DEBUG_SAVEALL)
        try:
            gc.collect()
        finally:
            gc.set_debug(0)
        found = Counter(type(each).__qualname__ for each in gc.garbage)
        gc.garbage.clear()
        if not found:
            break
    return found


def test_no_request_leaves_circles() -> None:
    """Or its body stays until garbage is looked for, and for good if it is put aside before that."""
    asked = list(dict.fromkeys(requests()))
    app = create_app(Settings(symbolic_seconds=5.0))
    found: list[tuple[str, int, Counter[str]]] = []
    statuses: Counter[int] = Counter()

    async def ask_all() -> None:
        for request in asked:
            told: list[int] = []

            async def ask(request: Request = request, told: list[int] = told) -> None:
                told.append(await status_of(app, request))

            if circles := await circles_of(ask):
                found.append((request[1], told[-1], circles))
            statuses[told[-1]] += 1

    with garbage_alone():
        try:
            asyncio.run(ask_all())
        finally:
            app.state.resources.workers.close()
    # A sheet of receipts leaves types of arrays, which ctypes makes: small, and nothing of the request.
    assert not [each for each in found if "PyCArrayType" not in each[2] or "frame" in each[2]]
    assert statuses[200] > 80
    assert statuses[422] > 50


def fails(*_: object) -> Any:
    raise ValueError("as it is meant to")


def left_by(do: Callable[[], Awaitable[object]]) -> Counter[str]:
    async def fail() -> None:
        with suppress(ValueError):
            await do()
            raise AssertionError("it did not fail")

    with garbage_alone():
        return asyncio.run(circles_of(fail))


def test_what_fails_in_a_thread_leaves_no_circles() -> None:
    assert not left_by(lambda: in_thread(fails))


def test_what_fails_in_a_batch_leaves_no_circles() -> None:
    batcher: Batcher[int, int] = Batcher(fails, capacity=4)
    try:
        assert not left_by(lambda: batcher(1))
    finally:
        batcher.close()


@pytest.mark.parametrize("raised", [ValueError("one"), ValueError("another")])
def test_what_fails_in_a_lane_leaves_no_circles(raised: ValueError, monkeypatch: pytest.MonkeyPatch) -> None:
    lane = LaneProcesses(Settings(), processes=1, capacity=4, niceness=0)

    def performs(*_: object) -> bytes:
        raise ValueError(str(raised))

    monkeypatch.setattr("service.work.processes.WorkerProcess.perform", performs)
    try:
        assert not left_by(lambda: lane.run(abs, 1))
    finally:
        lane.close()
