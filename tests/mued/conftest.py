"""The service that is asked: at `MUED_URL` (its header in `MUED_AUTHORIZATION`), or else one of our own."""

import os
from collections.abc import Iterator

import httpx
import pytest

from service.settings import Settings
from tests.live_service import running


@pytest.fixture(scope="session")
def mued_url() -> Iterator[str]:
    if url := os.environ.get("MUED_URL"):
        yield url.rstrip("/")
        return
    with running(Settings(queue_seconds=300.0)) as own:
        yield own


@pytest.fixture(scope="session")
def mued_headers() -> dict[str, str]:
    authorization = os.environ.get("MUED_AUTHORIZATION")
    return {"Authorization": authorization} if authorization else {}


@pytest.fixture(scope="session")
def platform(mued_url: str, mued_headers: dict[str, str]) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=mued_url, headers=mued_headers, timeout=120) as connected:
        yield connected
