"""Requests go on in the order of their clients' use: counted, not timed."""

from __future__ import annotations

import asyncio
import json
from typing import Any

from service.app import create_app
from service.settings import Settings

MANY = 40
HOSTILE, HONEST = "192.0.2.1", "192.0.2.2"


def test_who_sends_one_request_does_not_wait_behind_who_sends_many() -> None:
    app = create_app(Settings(storage="off"))
    answered: list[str] = []

    async def ask(address: str, port: int) -> None:
        body = json.dumps({"robot": "puma560", "joints": [port / 1000] * 6}).encode()
        status = await asked(app, (address, port), body)
        assert status == 200
        answered.append(address)

    async def scene() -> None:
        await ask(HOSTILE, 0)
        answered.clear()
        hostile = [asyncio.create_task(ask(HOSTILE, 1 + n)) for n in range(MANY)]
        await asyncio.gather(ask(HONEST, 1), *hostile)
        assert app.state.resources.turns.running == app.state.resources.turns.waiting == 0

    try:
        asyncio.run(scene())
    finally:
        app.state.resources.close()
    assert answered.index(HONEST) <= 1
    assert len(answered) == MANY + 1


async def asked(app: Any, client: tuple[str, int], body: bytes) -> int:
    """Send a request from an address; return the status of its answer."""
    statuses: list[int] = []
    scope = {
        "type": "http",
        "asgi": {"version": "3.0"},
        "http_version": "1.1",
        "method": "POST",
        "scheme": "http",
        "path": "/api/v1/forward-kinematics",
        "query_string": b"",
        "root_path": "",
        "client": client,
        "server": ("test", 80),
        "headers": [(b"host", b"test"), (b"content-type", b"application/json")],
    }

    async def receive() -> dict[str, Any]:
        return {"type": "http.request", "body": body, "more_body": False}

    async def send(message: dict[str, Any]) -> None:
        if message["type"] == "http.response.start":
            statuses.append(message["status"])

    await app(scope, receive, send)
    return statuses[0]
