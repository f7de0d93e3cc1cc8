"""What a caller may leave undone: heads, bodies, answers and connections."""

import contextlib
import http.client
import json
import socket
import threading
import time
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from service.http.problems import busy
from service.settings import Settings
from service.work.batches import BatchResponse
from service.work.fair_queue import FairQueue, Slot
from tests.architecture.serving import received
from tests.live_service import running

patient = httpx.Client(timeout=120, headers={"Connection": "close"})
"""Machines that run tests may be busy."""


@contextlib.contextmanager
def connected(url: str) -> Iterator[socket.socket]:
    host, _, port = url.removeprefix("http://").partition(":")
    with socket.create_connection((host, int(port)), timeout=60) as connection:
        yield connection


def status_of(connection: socket.socket) -> int:
    """The status of the next answer, read whole: its body may come in a packet of its own."""
    with http.client.HTTPResponse(connection) as answer:
        answer.begin()
        answer.read()
        return answer.status


@pytest.mark.parametrize(
    "field", [b"X-Long: " + b"a" * 70_000, b"\r\n".join(b"X-%d: 1" % i for i in range(200))]
)
def test_a_long_head_is_refused(base_url: str, field: bytes) -> None:
    with connected(base_url) as connection:
        with contextlib.suppress(ConnectionError):  # it may be refused before all of it is sent
            connection.sendall(b"GET /healthz HTTP/1.1\r\nHost: here\r\n" + field + b"\r\n\r\n")
        assert received(connection).startswith(b"HTTP/1.1 431 ")


@pytest.mark.parametrize(
    ("head", "status"),
    [
        (b"GET /livez HTTP/1.1", b"400"),
        (b"GET /livez HTTP/1.1\r\nHost: here\r\nHost: there", b"400"),
        (b"GET /livez HTTP/1.0\r\nHost: here\r\nHost: here", b"400"),
        (b"GET /livez HTTP/1.0", b"200"),
        (b"POST /api/v1/jacobian HTTP/1.1\r\nHost: here\r\nTransfer-Encoding: gzip, chunked", b"501"),
        (b"POST / HTTP/1.1\r\nHost: here\r\nTransfer-Encoding: gzip\r\nTransfer-Encoding: chunked", b"501"),
    ],
)
def test_a_head_that_two_servers_could_read_in_two_ways_is_refused(
    base_url: str, head: bytes, status: bytes
) -> None:
    with connected(base_url) as connection:
        connection.sendall(head + b"\r\n\r\n")
        answer = received(connection)
    assert answer.startswith(b"HTTP/1.1 " + status)
    assert answer.count(b"HTTP/1.1 ") == 1


def test_an_offer_of_another_protocol_is_answered_in_this_one(
    base_url: str, caplog: pytest.LogCaptureFixture
) -> None:
    offer = b"Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
    with connected(base_url) as connection:
        connection.sendall(b"GET /livez HTTP/1.1\r\nHost: here\r\n" + offer + b"\r\n")
        assert status_of(connection) == 200
    assert "pip install" not in caplog.text


UNFINISHED = b"POST /api/v1/jacobian HTTP/1.1\r\nHost: here\r\nContent-Type: application/json\r\n"


@pytest.mark.parametrize(
    "beginning",
    [
        b"GET /healthz HTTP/1.1\r\nX-Long: ",
        b"GET /healthz HTTP/1.1\r\nHost: here\r\n\r\nGET /healthz HTTP/1.1\r\nX-Long: ",
        UNFINISHED + b"Transfer-Encoding: chunked\r\n\r\n1\r\n{\r\n0\r\nX-Long: ",
        UNFINISHED + b"Transfer-Encoding: chunked\r\n\r\n1;long=",
    ],
    ids=["head", "head behind a request", "field behind a body", "extension of a chunk"],
)
def test_an_endless_head_costs_no_more_than_the_limit(base_url: str, beginning: bytes) -> None:
    assert taken(base_url, beginning) < 50 * 1024 * 1024


def test_an_endless_head_behind_a_request_in_progress_costs_no_more(base_url: str) -> None:
    rows = [{"theta": f"q{i}", "d": f"d{i} + 0.{i}7", "a": f"a{i}", "alpha": 17 * i} for i in range(1, 9)]
    table = {"convention": "standard", "angle_unit": "deg", "rows": rows}
    body = json.dumps({"table": table}).encode()
    head = UNFINISHED.replace(b"jacobian", b"symbolic") + b"Content-Length: %d\r\n\r\n" % len(body)
    assert taken(base_url, head + body + b"GET /healthz HTTP/1.1\r\nX-Long: ") < 50 * 1024 * 1024


def taken(base_url: str, beginning: bytes) -> int:
    """How many bytes of something without an end the server takes, of a hundred megabytes."""
    sent = 0
    with connected(base_url) as connection, contextlib.suppress(ConnectionError):
        connection.sendall(beginning)
        while sent < 100 * 1024 * 1024:
            connection.sendall(b"a" * 65536)
            sent += 65536
    return sent


def test_requests_that_come_at_once_are_counted_by_themselves(base_url: str) -> None:
    fields = b"".join(b"X-%d: 1\r\n" % i for i in range(20))
    with connected(base_url) as connection:
        connection.sendall((b"GET /livez HTTP/1.1\r\nHost: here\r\n" + fields + b"\r\n") * 12)
        connection.sendall(b"GET /livez HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n")
        assert received(connection).count(b"HTTP/1.1 200 ") == 13


def test_a_body_in_small_chunks_may_be_longer_than_a_head() -> None:
    body = b'{"robot":"puma560","joints":[0,0,0,0,0,0]}' + b" " * 30_000
    chunks = b"".join(b"1\r\n%c\r\n" % byte for byte in body) + b"0\r\n\r\n"
    with running(Settings(read_seconds=600)) as url, connected(url) as connection:
        connection.settimeout(600)  # a busy machine may read thirty thousand chunks slowly
        connection.sendall(UNFINISHED + b"Connection: close\r\nTransfer-Encoding: chunked\r\n\r\n" + chunks)
        assert received(connection).startswith(b"HTTP/1.1 200 ")


def test_a_large_ordinary_head_is_served(client: httpx.Client) -> None:
    headers = {f"X-{number}": "a" * 400 for number in range(80)}
    assert client.get("/healthz", headers=headers).status_code == 200


def test_a_slow_head_is_given_up(base_url: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.http.connections.HEAD_SECONDS", 0.2)
    with connected(base_url) as silent, connected(base_url) as slow:
        slow.sendall(b"GET /healthz HTTP/1.1\r\n")
        assert received(silent) == b""
        assert received(slow) == b""


def test_a_connection_rests_between_requests_longer_than_a_head_may_take(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    request = b"GET /livez HTTP/1.1\r\nHost: here\r\n\r\n"
    with running(Settings()) as url, connected(url) as connection:
        connection.sendall(request)
        assert status_of(connection) == 200
        # not before: a busy server may be late to read the first head, which comes after the connection
        monkeypatch.setattr("service.http.connections.HEAD_SECONDS", 0.2)
        connection.sendall(request)
        assert status_of(connection) == 200
        time.sleep(0.6)
        connection.sendall(request)
        assert status_of(connection) == 200
        connection.sendall(request[:9])
        assert received(connection) == b""


def test_a_connection_that_rests_for_too_long_is_closed() -> None:
    with running(Settings(keep_alive_seconds=1)) as url, connected(url) as connection:
        connection.sendall(b"GET /livez HTTP/1.1\r\nHost: here\r\n\r\n")
        assert received(connection).startswith(b"HTTP/1.1 200 ")


def test_a_slow_body_is_refused_with_the_time_it_had() -> None:
    with running(Settings(read_seconds=0.2)) as url, connected(url) as slow:
        slow.sendall(b"POST /api/v1/jacobian HTTP/1.1\r\nHost: here\r\nContent-Length: 90\r\n"
                     b"Content-Type: application/json\r\n\r\n{")  # fmt: skip
        answer = received(slow)
    assert answer.startswith(b"HTTP/1.1 408 ")
    assert b'"body_timed_out"' in answer


def test_who_does_not_read_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.http.connections.UNREAD_SECONDS", 0.2)
    with running(Settings(batch_threads=1, batch_queue=0)) as url:
        body = b'{"robot":"puma560","joints":[' + b",".join([b"[0,0,0,0,0,0]"] * 20_000) + b"]}"
        head = b"POST /api/v1/forward-kinematics HTTP/1.1\r\nHost: here\r\nContent-Type: application/json\r\n"
        with connected(url) as deaf:
            deaf.sendall(head + b"Content-Length: %d\r\n\r\n" % len(body) + body)
            with httpx.Client(base_url=url, timeout=120) as client:
                for _ in range(1200):  # the one slot for batches is free, once the deaf caller is given up
                    batch = {"robot": "puma560", "joints": [[0] * 6] * 100}
                    if client.post("/api/v1/forward-kinematics", json=batch).status_code == 200:
                        return
                    threading.Event().wait(0.1)
    raise AssertionError("the slot is still held")


def test_who_reads_slowly_keeps_nobody_from_their_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two callers who read just fast enough held both slots for batches as long as they liked."""
    monkeypatch.setattr("service.work.batches.PATIENCE", 0.1)
    body = b'{"robot":"puma560","joints":[' + b",".join([b"[0,0,0,0,0,0]"] * 20_000) + b"]}"
    with running(Settings(batch_threads=1, batch_queue=1)) as url, connected(url) as slow:
        slow.sendall(UNFINISHED.replace(b"jacobian", b"forward-kinematics"))
        slow.sendall(b"Connection: close\r\nContent-Length: %d\r\n\r\n" % len(body) + body)
        begun = slow.recv(1000)
        assert begun.startswith(b"HTTP/1.1 200 ")
        batch = {"robot": "puma560", "joints": [[0] * 6] * 100}
        assert patient.post(f"{url}/api/v1/forward-kinematics", json=batch).status_code == 200
        assert (begun + received(slow)).endswith(b"}\r\n0\r\n\r\n")  # and is answered in full


def test_who_reads_slowly_and_finds_no_place_again_is_not_told_that_this_is_all(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("service.work.batches.PATIENCE", 0.1)
    responses: list[BatchResponse] = []
    answer = BatchResponse.__call__

    async def noted(response: BatchResponse, *asgi: Any) -> None:
        responses.append(response)
        await answer(response, *asgi)

    async def full(_: FairQueue) -> Slot:
        raise busy()

    monkeypatch.setattr(BatchResponse, "__call__", noted)

    body = b'{"robot":"puma560","joints":[' + b",".join([b"[0,0,0,0,0,0]"] * 20_000) + b"]}"
    with running(Settings()) as url, connected(url) as slow:
        slow.sendall(UNFINISHED.replace(b"jacobian", b"forward-kinematics"))
        slow.sendall(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        begun = slow.recv(1000)
        assert begun.startswith(b"HTTP/1.1 200 ")
        monkeypatch.setattr(FairQueue, "acquire", full)
        while responses[0]._slot._slot.held:
            time.sleep(0.01)
        assert not (begun + received(slow)).endswith(b"0\r\n\r\n")


def test_idle_connections_make_room_for_new_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.http.connections.connection_limit", lambda: 20)
    with running(Settings()) as url, contextlib.ExitStack() as stack:
        idle = [stack.enter_context(connected(url)) for _ in range(30)]
        for _ in range(5):
            assert patient.get(f"{url}/healthz").status_code == 200
        closed = 0
        for connection in idle:
            connection.settimeout(0.05)
            with contextlib.suppress(TimeoutError):
                closed += received(connection) == b""
        assert closed >= 10


def test_bodies_that_stand_still_make_room_for_new_connections(monkeypatch: pytest.MonkeyPatch) -> None:
    """The one that has stood still longest goes first, and none that still moves."""
    monkeypatch.setattr("service.http.connections.connection_limit", lambda: 20)
    head = UNFINISHED + b"Expect: 100-continue\r\nContent-Length: 90\r\n\r\n"
    with running(Settings(read_seconds=600)) as url, contextlib.ExitStack() as stack:

        def begun() -> socket.socket:
            connection = stack.enter_context(connected(url))
            connection.sendall(head)
            assert connection.recv(300).startswith(b"HTTP/1.1 100 ")  # the body is being waited for
            return connection

        moving, still = begun(), []
        for _ in range(30):
            still.append(begun())
            moving.sendall(b" ")
            time.sleep(0.01)
        for _ in range(5):
            assert patient.get(f"{url}/healthz").status_code == 200
        for connection in still[:10]:
            assert received(connection) == b""
        for connection in (moving, still[-1]):
            connection.settimeout(0.2)
            with pytest.raises(TimeoutError):
                connection.recv(1)
