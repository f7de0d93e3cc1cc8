"""What takes long to write is written in a thread, while the event loop answers others."""

import asyncio
import sys
import threading
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from service.app import create_app
from service.settings import Settings
from tests.service.attacks.test_costs import CALLS

RECEIPT = {
    "name": "Ada",
    "table": {
        "convention": "standard",
        "rows": [
            {"theta": "q1", "d": 0, "a": "L1", "alpha": 0},
            {"theta": "q2", "d": 0, "a": "L2", "alpha": 0},
        ],
    },
}


@pytest.fixture
def app() -> Iterator[Any]:
    """A service that has answered nothing yet, and so has derived nothing."""
    made = create_app(Settings(storage="off"))
    yield made
    made.state.resources.workers.close()


def calls_by_thread(app: Any, method: str, path: str, body: Any) -> tuple[int, int]:
    """How many Python functions a request calls in the thread of the event loop, and in others."""
    loop_thread, here, elsewhere = threading.get_ident(), 0, 0

    def count(_frame: Any, event: str, _argument: Any) -> None:
        nonlocal here, elsewhere
        if event == "call" and threading.get_ident() == loop_thread:
            here += 1
        elif event == "call":
            elsewhere += 1

    async def ask() -> httpx.Response:
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://test", timeout=300) as client:
            return await client.request(method, f"/api/v1/{path}", json=body)

    threading.setprofile(count)
    sys.setprofile(count)
    try:
        response = asyncio.run(ask())
    finally:
        sys.setprofile(None)
        threading.setprofile(None)
    assert response.status_code == 200, response.text[:200]
    return here, elsewhere


@pytest.mark.parametrize("path", ["openapi.json", "docs"])
def test_the_description_of_the_api(app: Any, path: str) -> None:
    here, elsewhere = calls_by_thread(app, "GET", path, None)
    assert here < CALLS < elsewhere


def test_the_picture_of_a_receipt(app: Any) -> None:
    other = create_app(
        Settings(storage="off")
    )  # reads what all share; threads that run already cannot be seen
    calls_by_thread(other, "POST", "exercises/twolink/receipts", RECEIPT)
    other.state.resources.workers.close()
    here, elsewhere = calls_by_thread(app, "POST", "exercises/twolink/receipts", RECEIPT)
    assert here < CALLS / 10 < elsewhere
