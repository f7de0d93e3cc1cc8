"""How one of several processes takes connections."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from typing import Any

import pytest

from service.http.accepting import SharingLoop

CALLERS = 5


def listener() -> socket.socket:
    found = socket.socket()
    found.bind(("127.0.0.1", 0))
    found.listen(CALLERS)
    return found


class Noting(asyncio.Protocol):
    """Notes when it was made; sends back what it is sent."""

    def __init__(self, note: Callable[[], None]) -> None:
        self._note = note

    def connection_made(self, transport: Any) -> None:
        self._note()
        self._transport = transport

    def data_received(self, data: bytes) -> None:
        self._transport.write(data)


def test_one_connection_is_taken_between_two_looks_so_that_others_get_theirs() -> None:
    shared = listener()
    callers = [socket.create_connection(shared.getsockname()) for _ in range(CALLERS)]
    taken: list[int] = []
    looks = 0

    async def scene() -> None:
        nonlocal looks
        loop = asyncio.get_running_loop()

        def look() -> None:
            nonlocal looks
            looks += 1
            if len(taken) < CALLERS:
                loop.call_soon(look)

        server = await loop.create_server(lambda: Noting(lambda: taken.append(looks)), sock=shared)
        look()
        while len(taken) < CALLERS:
            await asyncio.sleep(0.001)
        for caller in callers:
            caller.setblocking(False)
            await loop.sock_sendall(caller, b"hello")
            assert await loop.sock_recv(caller, 9) == b"hello"
            caller.close()
        server.close()
        await server.wait_closed()
        server.close()
        late = socket.create_connection(shared.getsockname())
        await asyncio.sleep(0.01)
        assert len(taken) == CALLERS
        late.close()
        await asyncio.sleep(0.01)  # the callers have gone

    with asyncio.Runner(loop_factory=SharingLoop) as runner:
        runner.run(scene())
    assert len(set(taken)) == CALLERS
    shared.close()


def test_without_descriptors_none_is_taken_for_a_moment(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr("service.http.accepting.PAUSE", 0.01)
    refused = 0

    class Full(socket.socket):
        def accept(self) -> tuple[socket.socket, object]:
            nonlocal refused
            refused += 1
            if refused == 1:
                raise OSError(24, "Too many open files")
            return super().accept()

    shared = Full()
    shared.bind(("127.0.0.1", 0))
    made: list[int] = []

    async def scene() -> None:
        loop = asyncio.get_running_loop()
        server = await loop.create_server(lambda: Noting(lambda: made.append(refused)), sock=shared)
        with socket.create_connection(shared.getsockname()):
            while not made:
                await asyncio.sleep(0.001)
        server.close()
        await asyncio.sleep(0.01)  # the caller has gone

    with asyncio.Runner(loop_factory=SharingLoop) as runner:
        runner.run(scene())
    assert made == [2]
    assert "Too many open files" in caplog.text
    shared.close()


def test_an_address_is_listened_on_as_by_any_loop() -> None:
    async def scene() -> bytes:
        server = await asyncio.get_running_loop().create_server(lambda: Noting(lambda: None), "127.0.0.1", 0)
        reader, writer = await asyncio.open_connection(*server.sockets[0].getsockname())
        writer.write(b"hello")
        found = await reader.read(5)
        writer.close()
        server.close()
        return found

    with asyncio.Runner(loop_factory=SharingLoop) as runner:
        assert runner.run(scene()) == b"hello"
