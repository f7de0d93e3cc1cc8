"""A POST that is sent again with its Idempotency-Key."""

import threading
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from service.settings import Settings
from tests.live_service import running

ROWS = [{"theta": "q1", "d": 0, "a": "L1", "alpha": 0}, {"theta": "q2", "d": 0, "a": "L2", "alpha": 0}]
TABLE = {"convention": "standard", "rows": ROWS}
RECEIPTS = "/api/v1/exercises/twolink/receipts"


@pytest.fixture(scope="module")
def caller() -> Iterator[httpx.Client]:
    settings = Settings(cost_per_minute=100_000, cors_origins=("https://course.example",))
    with running(settings) as url, httpx.Client(base_url=url, timeout=120) as client:
        yield client


def receipt(caller: httpx.Client, key: str | None, name: str = "Ada", **headers: str) -> httpx.Response:
    given = {"Idempotency-Key": key} if key is not None else {}
    return caller.post(RECEIPTS, json={"table": TABLE, "name": name}, headers={**given, **headers})


def test_a_receipt_is_issued_once_for_each_key(caller: httpx.Client) -> None:
    first, again, other, without = (receipt(caller, key) for key in ("k1", "k1", "k2", None))
    assert first.status_code == again.status_code == 200
    assert first.content == again.content
    assert again.headers["idempotency-replayed"] == "true"
    assert not any("idempotency-replayed" in answer.headers for answer in (first, other, without))


def test_a_key_belongs_to_one_request(caller: httpx.Client) -> None:
    assert receipt(caller, "mine").status_code == 200
    reused = receipt(caller, "mine", name="Bob")
    assert reused.status_code == 422
    assert reused.json()["code"] == "idempotency_key_reused"
    assert reused.json()["errors"][0]["name"] == "Idempotency-Key"
    elsewhere = caller.post(
        "/api/v1/grade", json={"reference": TABLE, "submission": TABLE}, headers={"Idempotency-Key": "mine"}
    )
    assert elsewhere.json()["correct"] is True


def test_another_caller_may_use_the_same_key(caller: httpx.Client) -> None:
    one, two = (receipt(caller, "common", Authorization=f"Bearer {who}") for who in ("a", "b"))
    assert not any("idempotency-replayed" in answer.headers for answer in (one, two))


def test_another_language_is_another_answer(caller: httpx.Client) -> None:
    wrong: dict[str, Any] = {
        "reference": TABLE,
        "submission": {**TABLE, "rows": [{**ROWS[0], "alpha": 1}, ROWS[1]]},
    }
    told = [
        caller.post(
            "/api/v1/grade", json=wrong, headers={"Idempotency-Key": "l", "Accept-Language": language}
        )
        for language in ("en", "fr", "en")
    ]
    assert [answer.headers.get("idempotency-replayed") for answer in told] == [None, None, "true"]
    assert told[0].content == told[2].content != told[1].content


def test_what_was_refused_for_good_stays_refused(caller: httpx.Client) -> None:
    refused = [caller.post(RECEIPTS, json={"table": 5}, headers={"Idempotency-Key": "r"}) for _ in range(2)]
    assert [answer.status_code for answer in refused] == [422, 422]
    assert refused[1].headers["idempotency-replayed"] == "true"


@pytest.mark.parametrize("key", ["", "x" * 256])
def test_a_key_has_a_length(caller: httpx.Client, key: str) -> None:
    answer = receipt(caller, key)
    assert answer.status_code == 400
    assert answer.json()["code"] == "idempotency_key_length"


def test_streams_are_kept_as_well(caller: httpx.Client) -> None:
    body = {"reference": TABLE, "submissions": [TABLE] * 3}
    headers = {"Idempotency-Key": "s", "Accept": "application/x-ndjson"}
    first, again = (caller.post("/api/v1/grade", json=body, headers=headers) for _ in range(2))
    assert first.content == again.content
    assert len(first.content.splitlines()) == 3
    assert again.headers["idempotency-replayed"] == "true"


def test_at_the_same_time_one_is_answered_and_the_others_wait_their_turn(caller: httpx.Client) -> None:
    """All get the one receipt, at once or after they were told that it is under way."""
    answers: list[httpx.Response] = []

    def ask() -> None:
        answers.append(receipt(caller, "together"))

    threads = [threading.Thread(target=ask) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert {answer.status_code for answer in answers} <= {200, 409}
    for answer in answers:
        if answer.status_code == 409:
            assert answer.json()["code"] == "idempotency_key_in_use"
            assert answer.headers["retry-after"] == "1"
    assert len({answer.content for answer in answers if answer.status_code == 200}) == 1
    assert receipt(caller, "together").headers["idempotency-replayed"] == "true"
