"""A running service and a client of it, for every test of the HTTP side."""

from collections.abc import Iterator, Mapping
from types import SimpleNamespace

import httpx
import pytest

from service.messages import sentence
from service.settings import Settings
from tests.live_service import running


@pytest.fixture(scope="session", autouse=True)
def every_refusal_has_a_sentence() -> Iterator[None]:
    """In tests, a code without a message, or a message that lacks a parameter, is an unforeseen error."""

    def strict(language: str, identifier: str, params: Mapping[str, object] | None = None) -> str:
        text = sentence(language, identifier, params)
        assert text is not None, f"{identifier} has no message"
        return text

    def refuse(message: str, *arguments: object) -> None:
        raise AssertionError(message % arguments)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("service.http.problems.sentence", strict)
        patch.setattr("service.messages._log.warning", refuse)
        yield


@pytest.fixture
def one_minute(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have no other minute begin, in which what was used in this one counts less."""
    monkeypatch.setattr("service.http.cost_window.time", SimpleNamespace(monotonic=lambda: 1000.0))


@pytest.fixture(scope="session")
def base_url() -> Iterator[str]:
    with running(Settings(queue_seconds=300.0)) as url:  # on a busy machine a turn comes late
        yield url


@pytest.fixture(scope="session")
def client(base_url: str) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=base_url, timeout=120) as connected:
        yield connected
