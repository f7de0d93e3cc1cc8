"""Requests go on in the order of their clients' use: counted, not timed."""

import asyncio
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi import FastAPI

from courses.model import CourseSession
from courses.people.enrolment import arrive
from courses.people.sessions import session_of
from service.app import create_app
from service.course_resources import SESSIONS_KNOWN, now
from service.resources import TURNS
from service.settings import Settings
from service.work.fair_queue import FairQueue, current_client
from tests.courses.classroom import arrival
from tests.lti.test_launches import RIGHT

MANY = 40
HOSTILE, HONEST = "192.0.2.1", "192.0.2.2"
CAMPUS = "192.0.2.3"
SESSION = "/api/v1/session"
POSE = "/api/v1/forward-kinematics"


@pytest.fixture
def course(tmp_path: Path) -> Iterator[FastAPI]:
    """A service with storage."""
    app = create_app(Settings(storage="on", data_folder=tmp_path))
    yield app
    app.state.resources.close()


def session(app: FastAPI, subject: str) -> str:
    """The token of a session of a student who has just come."""
    store = app.state.resources.courses.store
    return arrive(store, arrival(store, subject), now())[0]


def pose(port: int) -> bytes:
    return json.dumps({"robot": "puma560", "joints": [port / 1000] * 6}).encode()


def test_who_sends_one_request_does_not_wait_behind_who_sends_many() -> None:
    app = create_app(Settings(storage="off"))
    answered: list[str] = []

    async def ask(address: str, port: int) -> None:
        assert await asked(app, (address, port), POSE, pose(port)) == 200
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
    assert answered.index(HONEST) <= 2 * TURNS  # those that have begun, and as many again
    assert len(answered) == MANY + 1


def test_a_student_waits_for_nobody_else_behind_the_same_address(course: FastAPI) -> None:
    """Not for strangers who make up sessions, nor twice for another student who has two."""
    one, other, quiet = session(course, "busy"), session(course, "busy"), session(course, "quiet")
    answered: list[str] = []

    async def ask(token: str, port: int) -> None:
        assert await asked(course, (CAMPUS, port), POSE, pose(port), token) == 200
        answered.append(token)

    async def scene() -> None:
        for token in (one, other, quiet):
            assert await asked(course, (CAMPUS, 1), SESSION, b"", token) == 200
        assert await asked(course, (CAMPUS, 1), SESSION, b"", "made up") == 401
        strangers = [asyncio.create_task(ask(f"made up {n}", 100 + n)) for n in range(MANY)]
        busy = [asyncio.create_task(ask((one, other)[n % 2], 200 + n)) for n in range(MANY)]
        await asyncio.gather(*strangers, *busy, ask(quiet, 300))

    asyncio.run(scene())
    assert answered.index(quiet) <= 2 * TURNS
    assert len(answered) == 2 * MANY + 1


def test_who_hands_in_does_not_wait_behind_what_they_have_typed(
    course: FastAPI, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A verdict waited as long as all that its student, and others, had read while they typed."""
    busy, quiet = session(course, "typing"), session(course, "another")
    courses, turns = course.state.resources.courses, course.state.resources.turns
    had_turns: list[str] = []

    async def signed_in(token: str) -> CourseSession:
        return session_of(courses.store, token, now())

    async def turn() -> None:
        await FairQueue.turn(turns)
        had_turns.append(getattr(current_client.get()[0], "kind", "stranger"))

    async def scene() -> None:
        for token in (busy, quiet):
            assert await asked(course, (CAMPUS, 1), SESSION, b"", token) == 200
        await asyncio.gather(*(asked(course, (CAMPUS, 100 + n), POSE, pose(n), busy) for n in range(MANY)))
        had_turns.clear()
        monkeypatch.setattr(courses, "sign_in", signed_in)
        monkeypatch.setattr(turns, "turn", turn)
        typed = [asked(course, (CAMPUS, 200 + n), POSE, pose(n), (busy, quiet)[n % 2]) for n in range(MANY)]
        hands_in = asked(course, (CAMPUS, 300), f"{SESSION}/attempts", json.dumps(RIGHT).encode(), busy)
        assert set(await asyncio.gather(*typed, hands_in)) == {200}

    asyncio.run(scene())
    assert len(had_turns) == MANY + 1
    assert had_turns.index("hand-in") <= TURNS + 2


@pytest.mark.usefixtures("one_minute")
def test_students_behind_one_address_have_a_limit_each(tmp_path: Path) -> None:
    """Those whom nobody knows share the one of their address, whatever sessions they make up."""
    app = create_app(Settings(storage="on", data_folder=tmp_path, cost_per_minute=MANY))
    one, other = session(app, "one"), session(app, "other")

    async def statuses(count: int, token: str | None) -> list[int]:
        return [await asked(app, (CAMPUS, n), POSE, pose(n), token) for n in range(count)]

    async def scene() -> None:
        for token in (one, other):
            assert await asked(app, (CAMPUS, 1), SESSION, b"", token) == 200
        assert await statuses(MANY + 1, one) == [200] * MANY + [429]
        assert await statuses(MANY, other) == [200] * MANY
        strangers = [await asked(app, (CAMPUS, n), POSE, pose(n), f"made up {n}") for n in range(MANY)]
        assert strangers == [200] * (MANY - 2) + [429] * 2  # the first visit of each student was theirs, too

    try:
        asyncio.run(scene())
    finally:
        app.state.resources.close()


def test_remembered_sessions_are_bounded(course: FastAPI) -> None:
    courses = course.state.resources.courses

    async def scene() -> None:
        first, second = session(course, "first"), session(course, "second")
        await courses.signed_in(first)
        for n in range(SESSIONS_KNOWN - 1):
            courses._people[str(n)] = courses.person(f"Bearer {first}")
        await courses.signed_in(second)
        assert len(courses._people) == SESSIONS_KNOWN
        assert courses.person(f"bearer {second}") is not None
        assert courses.person(f"Basic {second}") is courses.person(f"Bearer {first}") is None

    asyncio.run(scene())


async def asked(app: Any, client: tuple[str, int], path: str, body: bytes, token: str | None = None) -> int:
    """Send a request from an address; return the status of its answer."""
    statuses: list[int] = []
    scope = {
        "type": "http",
        "asgi": {"version": "3.0"},
        "http_version": "1.1",
        "method": "POST" if body else "GET",
        "scheme": "http",
        "path": path,
        "query_string": b"",
        "root_path": "",
        "client": client,
        "server": ("test", 80),
        "headers": [(b"host", b"test"), (b"content-type", b"application/json")],
    }
    if token is not None:
        scope["headers"].append((b"authorization", b"Bearer " + token.encode()))

    async def receive() -> dict[str, Any]:
        return {"type": "http.request", "body": body, "more_body": False}

    async def send(message: dict[str, Any]) -> None:
        if message["type"] == "http.response.start":
            statuses.append(message["status"])

    await app(scope, receive, send)
    return statuses[0]
