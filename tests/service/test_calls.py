"""Calls are functions: they can be asked without HTTP, and ask for what they need by name."""

import asyncio
import threading
from typing import Any

import httpx
import pytest
from fastapi import FastAPI
from fastapi.routing import APIRoute

from service.app import OFTEN, create_app
from service.http.calls import CallRouter
from service.routes.checks.check_rotation import CheckRotationRequest, check_rotation
from service.schemas.base import Wire

CHECK: dict[str, Any] = {"expected": {"angles": [30, 45, 60]}, "answer": {"angles": [60, 45, 30]}}


class Ping(Wire):
    """A body."""

    text: str


class Pong(Wire):
    """An answer."""

    text: str
    thread: str


def test_a_call_is_a_function_that_answers_without_http(client: httpx.Client) -> None:
    body = {**CHECK, "angle_unit": "deg"}
    told = client.post("/api/v1/check-rotation", json=body, headers={"Accept-Language": "uk"}).json()
    found = check_rotation(CheckRotationRequest.model_validate(body), "uk")
    assert found.model_dump(mode="json") == told
    assert not found.correct


def test_a_name_that_nobody_can_give_is_noticed_when_the_call_is_declared() -> None:
    def wants_too_much(body: Ping, weather: str) -> Pong:
        raise NotImplementedError

    with pytest.raises(KeyError, match="weather"):
        CallRouter("kinematics").call("/ping", "Ping")(wants_too_much)


@pytest.mark.parametrize("way", ["call", "judge"])
def test_answers_are_judged_in_threads_and_short_work_is_done_at_once(way: str) -> None:
    router = CallRouter("kinematics")

    def pong(body: Ping, language: str) -> Pong:
        return Pong(text=f"{body.text} {language}", thread=threading.current_thread().name)

    getattr(router, way)("/pong", "Pong")(pong)
    application = FastAPI()
    application.include_router(router)
    application.state.resources = create_app().state.resources

    async def asked() -> Any:
        async with httpx.AsyncClient(
            transport=httpx.ASGITransport(application), base_url="http://x"
        ) as asking:
            return (await asking.post("/api/v1/pong?lang=fr", json={"text": "ping"})).json()

    told = asyncio.run(asked())
    assert told["text"] == "ping fr"
    assert (told["thread"] == threading.current_thread().name) == (way == "call")


def test_calls_that_are_asked_for_often_are_looked_for_first() -> None:
    """A path that is written wrongly among them would be no route's."""
    app = create_app()
    first = [route.path for route in app.routes[: len(OFTEN)] if isinstance(route, APIRoute)]
    assert sorted(first) == sorted(OFTEN)
