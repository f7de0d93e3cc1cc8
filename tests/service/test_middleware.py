"""What every answer has, whatever the call: ids, headers, methods, prefixes, and no stack trace."""

import asyncio
import errno
import http.client
import json
import logging
import socket
from contextlib import suppress

import httpx
import pytest
from fastapi import APIRouter, Request
from starlette.requests import ClientDisconnect

import service.routes
from service.app import create_app
from service.settings import Settings
from tests.live_service import running
from tests.service.test_bad_input import check_problem

patient = httpx.Client(timeout=120, headers={"Connection": "close"})
"""Machines that run tests may be busy."""


def test_alive(client: httpx.Client) -> None:
    response = client.get("/healthz")
    assert response.json() == {"status": "ok"}
    assert response.headers["cache-control"] == "no-store"


@pytest.mark.parametrize("path", ["/healthz", "/api/v1/openapi.json", "/api/v1/problems/parameter_missing"])
def test_head_is_get_without_its_body(client: httpx.Client, path: str) -> None:
    head, get = client.head(path), client.get(path)
    assert head.status_code == get.status_code == 200
    assert head.content == b""
    assert head.headers["content-length"] == get.headers["content-length"]


@pytest.mark.parametrize(
    ("path", "allowed"),
    [("/healthz", "GET, HEAD, OPTIONS"), ("/api/v1/forward-kinematics", "OPTIONS, POST")],
)
def test_options_and_wrong_methods_say_what_is_allowed(client: httpx.Client, path: str, allowed: str) -> None:
    options = client.options(path)
    assert options.status_code == 204
    assert options.headers["allow"] == allowed
    refused = client.delete(path)
    problem = check_problem(refused, 405, "method_not_allowed")
    assert refused.headers["allow"] == allowed
    assert problem["errors"][0]["params"]["method"] == "DELETE"


@pytest.mark.parametrize(
    "path", ["/api/v1/nothing", "/api", "/healthz/", "/%00", "/..%2f..%2fetc/passwd", "/api/v1/jacobian/"]
)
def test_nothing_is_at_other_addresses(client: httpx.Client, path: str) -> None:
    check_problem(client.get(path), 404, "address_unknown")


def test_every_answer_can_be_named(client: httpx.Client) -> None:
    own = client.get("/healthz", headers={"X-Request-Id": "my-request.1"})
    assert own.headers["x-request-id"] == "my-request.1"
    first, second = (client.get("/healthz").headers["x-request-id"] for _ in range(2))
    assert first != second
    strange = client.get("/healthz", headers={"X-Request-Id": "<script>" + "x" * 100})
    assert "<" not in strange.headers["x-request-id"]


def test_answers_are_not_sniffed_framed_or_run(client: httpx.Client) -> None:
    for path in ("/healthz", "/nothing", "/api/v1/openapi.json"):
        headers = client.get(path).headers
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["referrer-policy"] == "same-origin"
        assert "default-src 'none'" in headers["content-security-policy"]
        assert "frame-ancestors 'self'" in headers["content-security-policy"]


def test_the_meaning_of_a_code_can_be_asked_for(client: httpx.Client) -> None:
    problem = client.post("/api/v1/jacobian", json={}, headers={"Accept-Language": "ro"}).json()
    meaning = client.get(problem["type"], headers={"Accept-Language": "ro"})
    assert meaning.json()["code"] == problem["code"]
    assert meaning.json()["language"] == "ro"
    check_problem(client.get("/api/v1/problems/no_such_code"), 404, "problem_unknown")


def test_an_unforeseen_error_is_a_problem_with_an_id_and_stays_in_the_log(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    router = APIRouter()

    @router.get("/broken")
    async def broken() -> None:
        raise ZeroDivisionError("a secret")

    monkeypatch.setattr(service.app, "routers", lambda: [*service.routes.routers(), router])
    with running(Settings()) as url, caplog.at_level(logging.ERROR, "framewise"):
        response = patient.get(f"{url}/broken")
    problem = check_problem(response, 500, "internal_error")
    assert "secret" not in response.text
    assert problem["request_id"] in problem["detail"]
    (record,) = [record for record in caplog.records if record.name == "framewise"]
    assert problem["request_id"] in record.getMessage()
    assert record.exc_info


def test_a_prefix_from_the_settings() -> None:
    with running(Settings(prefix="/dh")) as url:
        assert (
            patient.get(f"{url}/healthz").status_code == patient.get(f"{url}/dh/healthz").status_code == 200
        )
        document = patient.get(f"{url}/dh/api/v1/openapi.json").json()
        assert document["servers"] == [{"url": "/dh"}]
        problem = patient.post(f"{url}/api/v1/jacobian", json={}).json()
        assert problem["type"].startswith("/dh/api/v1/problems/")
        assert patient.get(url + problem["type"]).status_code == 200


def test_a_prefix_from_a_trusted_proxy(client: httpx.Client) -> None:
    forwarded = {"X-Forwarded-Prefix": "/dh"}
    problem = client.post("/api/v1/jacobian", json={}, headers=forwarded).json()
    assert problem["type"].startswith("/dh/api/v1/problems/")
    for nonsense in ("//evil.example", "dh", "/a b", "/<x>"):
        problem = client.post("/api/v1/jacobian", json={}, headers={"X-Forwarded-Prefix": nonsense}).json()
        assert problem["type"].startswith("/api/v1/problems/")


def test_a_prefix_from_a_stranger_is_not_believed() -> None:
    with running(Settings(trusted_proxies=("192.0.2.1",))) as url:
        problem = patient.post(
            f"{url}/api/v1/jacobian", json={}, headers={"X-Forwarded-Prefix": "/dh"}
        ).json()
        assert problem["type"].startswith("/api/v1/problems/")


def test_other_origins_may_call_only_where_that_is_set(client: httpx.Client) -> None:
    wish = {"Origin": "https://lms.example", "Access-Control-Request-Method": "POST"}
    assert "access-control-allow-origin" not in client.options("/api/v1/jacobian", headers=wish).headers
    with running(Settings(cors_origins=("https://lms.example",))) as url:
        allowed = patient.options(f"{url}/api/v1/jacobian", headers=wish)
        assert allowed.status_code == 200
        assert allowed.headers["access-control-allow-origin"] == "https://lms.example"
        refused = patient.post(f"{url}/api/v1/jacobian", json={}, headers={"Origin": "https://lms.example"})
        assert refused.headers["access-control-allow-origin"] == "https://lms.example"
        ended = {"Origin": "https://lms.example", "X-Framewise-Context": "of another time"}
        refused = patient.post(f"{url}/api/v1/jacobian", json={}, headers=ended)
        assert refused.json()["code"] == "context_invalid"
        assert refused.headers["access-control-allow-origin"] == "https://lms.example"
        stranger = patient.options(
            f"{url}/api/v1/jacobian", headers={**wish, "Origin": "https://evil.example"}
        )
        assert "access-control-allow-origin" not in stranger.headers


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE"])
def test_a_course_in_a_sandboxed_frame_may_do_what_its_page_does(method: str) -> None:
    """It could store no draft, and not read since when an answer counts that was refused as busy."""
    with running(Settings(frame_ancestors=("https://lms.example",))) as url:
        wish = {"Origin": "null", "Access-Control-Request-Method": method}
        assert patient.options(f"{url}/api/v1/session/draft", headers=wish).status_code == 200
        answer = patient.get(f"{url}/api/v1/session", headers={"Origin": "null"})
        assert "Framewise-Arrival" in answer.headers["access-control-expose-headers"]


@pytest.mark.parametrize(
    "error", [MemoryError(), RuntimeError("can't start new thread"), OSError(errno.ENOMEM, "no memory")]
)
def test_a_machine_that_is_short_of_something_is_busy_and_has_no_error(
    error: Exception, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """The caller was to report it, and the log held a traceback, of which a crowd makes thousands."""

    def fail(*_: object) -> object:
        raise error

    monkeypatch.setattr("service.http.routing.decode_json", fail)
    with running(Settings()) as url:
        refused = patient.post(f"{url}/api/v1/jacobian", json={})
    assert (refused.status_code, refused.json()["code"]) == (503, "busy")
    assert refused.headers["retry-after"]
    assert "short of" in caplog.text
    assert "Traceback" not in caplog.text


def test_large_answers_are_compressed_for_those_who_take_it(client: httpx.Client) -> None:
    body = {"robot": "puma560", "joints": [[0.0] * 6] * 60}
    plain = client.post("/api/v1/forward-kinematics", json=body, headers={"Accept-Encoding": "identity"})
    packed = client.post("/api/v1/forward-kinematics", json=body, headers={"Accept-Encoding": "br, gzip"})
    assert "content-encoding" not in plain.headers
    assert packed.headers["content-encoding"] == "gzip"
    assert "Accept-Encoding" in packed.headers["vary"]
    assert int(packed.headers["content-length"]) < len(plain.content) / 4
    assert packed.content == plain.content


@pytest.mark.parametrize("accepted", ["gzip;q=0", "br", "gzip;q=0.000, br"])
def test_nothing_is_compressed_for_others(client: httpx.Client, accepted: str) -> None:
    answer = client.get("/api/v1/openapi.json", headers={"Accept-Encoding": accepted})
    assert "content-encoding" not in answer.headers


def test_small_answers_and_arrays_are_not_compressed(client: httpx.Client) -> None:
    body = {"robot": "puma560", "joints": [[0.0] * 6] * 60}
    small = client.post("/api/v1/forward-kinematics", json={**body, "joints": [0] * 6})
    array = client.post("/api/v1/forward-kinematics", json=body, headers={"Accept": "application/x-npy"})
    assert "content-encoding" not in small.headers
    assert "content-encoding" not in array.headers


@pytest.mark.parametrize(("path", "root"), [("/nothing", "./"), ("/nothing/here/at/all", "../../../")])
def test_a_browser_is_shown_a_page_where_there_is_none(client: httpx.Client, path: str, root: str) -> None:
    headers = {"Accept": "text/html,application/xhtml+xml,*/*;q=0.8", "Accept-Language": "fr"}
    page = client.get(path, headers=headers)
    assert page.status_code == 404
    assert page.headers["content-type"].startswith("text/html")
    assert '<html lang="fr"' in page.text
    assert f'src="{root}static/' in page.text
    check_problem(client.get(path), 404, "address_unknown")
    check_problem(client.get("/api/v1/nothing", headers=headers), 404, "address_unknown")
    check_problem(client.post(path, headers=headers), 404, "address_unknown")


@pytest.mark.parametrize(
    ("path", "media_type", "status", "code"),
    [
        ("/api/v1/forward-kinematics", "application/json", 413, "body_too_large"),
        ("/api/v1/symbolic", "application/json", 413, "body_too_large"),
        ("/api/v1/symbolic", "text/plain", 415, "media_type_unsupported"),
        ("/api/v1/nothing", "application/json", 404, "address_unknown"),
    ],
)
@pytest.mark.parametrize("chunked", [False, True], ids=["announced", "chunked"])
def test_a_caller_that_closes_reads_why_a_long_body_was_refused(
    base_url: str,
    path: str,
    media_type: str,
    status: int,
    code: str,
    chunked: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("service.http.uploads.SECONDS", 300.0)  # a busy machine sends slowly
    long = b" " * (33 * 1024 * 1024)
    body = iter([long[:20_000_000], long[20_000_000:]]) if chunked else long
    headers = {"Content-Type": media_type, "Connection": "close"}
    connection = http.client.HTTPConnection(base_url.removeprefix("http://"), timeout=300)
    connection.request("POST", path, body=body, headers=headers, encode_chunked=chunked)
    answer = connection.getresponse()
    assert answer.status == status
    assert json.loads(answer.read())["code"] == code
    connection.close()


def test_a_caller_that_stops_sending_is_answered_all_the_same(
    base_url: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("service.http.uploads.SECONDS", 0.1)
    host, _, port = base_url.removeprefix("http://").partition(":")
    with socket.create_connection((host, int(port)), timeout=60) as connection:
        connection.sendall(b"POST /api/v1/nothing HTTP/1.1\r\nHost: here\r\nContent-Length: 9000000\r\n\r\n{")
        assert connection.recv(64).startswith(b"HTTP/1.1 404 ")


def test_requests_are_counted_while_they_are_under_way() -> None:
    """Also those that fail or whose callers go away: a count that only grows would slow all others."""
    app = create_app(Settings())
    resources, seen = app.state.resources, []

    @app.get("/counted")
    async def counted(request: Request) -> dict[str, bool]:
        seen.append(resources.under_way)
        raise {"fails": KeyError("x"), "leaves": ClientDisconnect()}[request.query_params["how"]]

    async def ask() -> None:
        transport = httpx.ASGITransport(app, raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url="http://test") as asking:
            for path in ("/counted?how=fails", "/counted?how=leaves", "/healthz", "/nothing"):
                with suppress(AssertionError):  # nothing has been answered to whoever went away
                    await asking.get(path)

    asyncio.run(ask())
    assert seen == [1, 1]
    assert resources.under_way == 0
    resources.close()
