"""No explanation fails unseen: what is logged for operators fails the tests."""

import logging
from collections.abc import Iterator

import pytest


@pytest.fixture(autouse=True)
def _no_explanation_fails(request: pytest.FixtureRequest, caplog: pytest.LogCaptureFixture) -> Iterator[None]:
    yield
    if request.node.get_closest_marker("logs_errors") is None:
        failed = [record.message for record in caplog.get_records("call") if record.levelno >= logging.ERROR]
        assert failed == []
