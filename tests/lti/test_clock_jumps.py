"""The clock jumps: forwards and backwards by hours, while students are signed in and scores wait."""

import errno
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx
import pytest
import sqlalchemy as sa
from pydantic import SecretStr

import service.course_resources
import service.routes.exercises.receipts
from courses.model import LinkSettings, Role
from courses.people.enrolment import Arrival, arrive
from courses.policies import AttemptPolicy, Mode
from courses.refusals import StorageUnavailableError
from courses.storage import records
from courses.storage.database import Store, open_store
from courses.teaching.link_changes import change_settings
from service.course_resources import now
from service.http.problems import busy
from service.routes.courses import course_sessions
from service.settings import Settings
from tests.courses.classroom import platform
from tests.live_service import running
from tests.lti.test_launches import RIGHT, WRONG


class Clock:
    """The system's clock, with a jump; one that was stopped at a time only jumps."""

    jump = timedelta()
    stopped: datetime | None = None

    @classmethod
    def now(cls, zone: Any) -> datetime:
        return (cls.stopped or datetime.now(UTC)).astimezone(zone) + cls.jump


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> type[Clock]:
    monkeypatch.setattr(Clock, "jump", timedelta())
    monkeypatch.setattr(service.course_resources, "datetime", Clock)
    return Clock


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    opened = open_store("", tmp_path)
    yield opened
    opened.close()


@pytest.fixture
def student(store: Store, clock: type[Clock], tmp_path: Path) -> Iterator[httpx.Client]:
    """Somebody who is signed in; their scores go to a gradebook."""
    told = {"deployment": "1", "context": "c", "resource": "r", "exercise_id": "puma560"}
    item = "https://lms.example.edu/items/1"
    arrival = Arrival(platform=platform(store), subject="s", role=Role.LEARNER, line_item=item, **told)
    token, _ = arrive(store, arrival, now())
    with (
        running(Settings(storage="on", data_folder=tmp_path)) as origin,
        httpx.Client(
            base_url=f"{origin}/api/v1/",
            headers={"Authorization": f"Bearer {token}"},
            trust_env=False,
            timeout=120,
        ) as client,
    ):
        yield client


def test_backwards_nobody_is_signed_out_and_nothing_is_lost(
    student: httpx.Client, clock: type[Clock]
) -> None:
    assert student.post("session/attempts", json=WRONG).status_code == 200
    clock.jump = timedelta(hours=-5)
    assert student.get("session").status_code == 200
    again = student.post("session/attempts", json=RIGHT)
    assert (again.status_code, again.json()["attempt"]) == (200, 2)
    clock.jump = timedelta()
    session = student.get("session").json()
    assert [attempt["number"] for attempt in session["attempts"]] == [1, 2]
    assert session["grade"]["attempt"] == 2


def test_forwards_a_session_ends_and_another_finds_everything(
    student: httpx.Client, store: Store, clock: type[Clock]
) -> None:
    assert student.post("session/attempts", json=RIGHT).status_code == 200
    clock.jump = timedelta(hours=5)
    refused = student.get("session")
    assert (refused.status_code, refused.json()["code"]) == (401, "session_expired")
    told = {"deployment": "1", "context": "c", "resource": "r", "exercise_id": "puma560"}
    token, _ = arrive(store, Arrival(platform=platform(store), subject="s", role=Role.LEARNER, **told), now())
    student.headers["Authorization"] = f"Bearer {token}"
    assert len(student.get("session").json()["attempts"]) == 1


def test_what_came_before_the_end_of_an_exam_counts_however_long_it_waits(
    student: httpx.Client, store: Store, clock: type[Clock], monkeypatch: pytest.MonkeyPatch
) -> None:
    """It was refused as late once it was its turn: at the end of an exam that takes seconds."""
    examine(store)
    judge = course_sessions.judged_submission

    def late(*told: Any) -> Any:
        clock.jump = timedelta(minutes=20)
        return judge(*told)

    monkeypatch.setattr(course_sessions, "judged_submission", late)
    assert student.post("session/attempts", json=RIGHT).status_code == 200
    refused = student.post("session/attempts", json=RIGHT)
    assert (refused.status_code, refused.json()["code"]) == (409, "attempts_closed")
    assert student.get("session").json()["grade"]["attempt"] == 1


def examine(store: Store) -> None:
    """Make an exam of the link, which ends in ten minutes."""
    rules = AttemptPolicy(mode=Mode.EXAM, closes=now() + timedelta(minutes=10))
    with store.reading() as connection:
        link = int(connection.execute(sa.select(records.link.c.id)).scalar_one())
    change_settings(store, link, LinkSettings(exercise_id="puma560", policy=rules), now())


@pytest.mark.parametrize(
    "error",
    [
        pytest.param(busy(), id="busy"),
        pytest.param(StorageUnavailableError(is_gone=True), id="no database"),
        pytest.param(MemoryError(), id="no memory"),
        pytest.param(OSError(errno.EMFILE, "Too many open files"), id="no files"),
        pytest.param(RuntimeError("can't start new thread"), id="no threads"),
    ],
)
def test_what_was_sent_in_time_and_refused_as_busy_counts_when_it_is_sent_again(
    student: httpx.Client,
    store: Store,
    clock: type[Clock],
    monkeypatch: pytest.MonkeyPatch,
    error: Exception,
) -> None:
    """It was refused as late: who hands in at the end of an exam meets the crowd."""
    monkeypatch.setattr(clock, "stopped", datetime.now(UTC))
    examine(store)

    def refuse(*_: Any) -> Any:
        raise error

    with monkeypatch.context() as crowded:
        crowded.setattr(course_sessions, "judged_submission", refuse)
        refused = student.post("session/attempts", json=RIGHT)
        assert (refused.status_code, refused.headers["retry-after"]) == (503, "2")
        ticket = {"Framewise-Arrival": refused.headers["framewise-arrival"]}
        clock.jump = timedelta(minutes=20)
        again = student.post("session/attempts", json=RIGHT, headers=ticket)
        assert again.status_code == 503
        assert again.headers["framewise-arrival"] == ticket["Framewise-Arrival"]
    forged = {"Framewise-Arrival": "0" + ticket["Framewise-Arrival"][1:]}
    other = {**RIGHT, "table": {**RIGHT["table"], "rows": RIGHT["table"]["rows"][::-1]}}
    for answer, headers in (
        (RIGHT, {}),
        (RIGHT, forged),
        (other, ticket),
        (RIGHT, {"Framewise-Arrival": "1.2"}),
    ):
        late = student.post("session/attempts", json=answer, headers=headers)
        assert (late.status_code, late.json()["code"]) == (409, "attempts_closed")
    clock.jump = timedelta(minutes=59)
    assert student.post("session/attempts", json=RIGHT, headers=ticket).status_code == 200
    found = student.get("session").json()
    assert found["grade"]["attempt"] == 1
    clock.jump = timedelta(minutes=61)
    assert student.post("session/attempts", json=RIGHT, headers=ticket).status_code == 409


def test_what_was_sent_in_time_and_cost_too_much_counts_when_it_is_sent_again(
    store: Store, clock: type[Clock], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It was refused as late: a class behind one address may use up what the address has in a minute."""
    told = {"deployment": "1", "context": "c", "resource": "r", "exercise_id": "puma560"}
    arrival = Arrival(platform=platform(store), subject="s", role=Role.LEARNER, **told)
    headers = {"Authorization": f"Bearer {arrive(store, arrival, now())[0]}"}
    examine(store)
    settings = Settings(storage="on", data_folder=tmp_path, cost_per_minute=3, secret=SecretStr("s" * 32))
    monkeypatch.setattr("service.http.cost_window.time", SimpleNamespace(monotonic=lambda: 1000.0))

    def client() -> httpx.Client:
        return httpx.Client(base_url=f"{origin}/api/v1/", headers=headers, trust_env=False, timeout=120)

    with running(settings) as origin, client() as student:
        refusals = []
        while len(refusals) < 4:
            answer = student.post("session/attempts", json=RIGHT)
            refusals += [answer] if answer.status_code == 429 else []
        assert all(int(refused.headers["retry-after"]) >= 1 for refused in refusals)
        tickets = [refused.headers.get("framewise-arrival") for refused in refusals]
        assert tickets[0]
        assert tickets[3] is None  # who sends so many hands in nothing
        assert "framewise-arrival" not in student.post("session/open", json={}).headers
        large = student.post("session/attempts", json={**RIGHT, "form": "x" * 70_000})
        assert (large.status_code, large.headers.get("framewise-arrival")) == (429, None)
    clock.jump = timedelta(minutes=20)
    with running(settings) as origin, client() as student:  # the next minute
        late = student.post("session/attempts", json=RIGHT)
        assert (late.status_code, late.json()["code"]) == (409, "attempts_closed")
        ticket = {"Framewise-Arrival": str(tickets[0])}
        assert student.post("session/attempts", json=RIGHT, headers=ticket).status_code == 200


def test_a_ticket_makes_no_attempt_earlier_than_need_be(
    student: httpx.Client, store: Store, clock: type[Clock], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: Any) -> Any:
        raise busy()

    with monkeypatch.context() as crowded:
        crowded.setattr(course_sessions, "judged_submission", refuse)
        refused = student.post("session/attempts", json=RIGHT)
    clock.jump = timedelta(minutes=5)
    ticket = {"Framewise-Arrival": refused.headers["framewise-arrival"]}
    assert student.post("session/attempts", json=RIGHT, headers=ticket).status_code == 200
    at = datetime.fromisoformat(student.get("session").json()["attempts"][0]["at"])
    assert now() - at < timedelta(minutes=5)


def test_a_receipt_holds_whatever_the_clock_says(
    student: httpx.Client, clock: type[Clock], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(service.routes.exercises.receipts, "datetime", Clock)
    clock.jump = timedelta(hours=5)
    made = student.post("exercises/puma560/receipts", json={**RIGHT, "name": "Ann"}).json()["receipt"]
    for hours in (0, -5, 24 * 365):
        clock.jump = timedelta(hours=hours)
        (checked,) = student.post("receipts/verify", json={"receipts": [made]}).json()["receipts"]
        assert checked["valid"]
