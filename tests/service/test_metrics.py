"""Figures for the operator count what happened, name nobody, and are those of all processes of a server."""

import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import httpx
import pytest
import sqlalchemy as sa
from opentelemetry.sdk.trace import TracerProvider
from opentelemetry.sdk.trace.export import BatchSpanProcessor, SimpleSpanProcessor
from opentelemetry.sdk.trace.export.in_memory_span_exporter import InMemorySpanExporter
from prometheus_client.parser import text_string_to_metric_families

from courses.grades.outbox import outbox_state
from courses.storage import records
from courses.storage.database import open_store
from service.app import create_app
from service.http.tracing import TracingMiddleware
from service.settings import Settings
from tests.architecture.sources import ROOT
from tests.courses.classroom import NOW, joined, submitted
from tests.live_service import running
from tests.lti.classes import eventually
from tests.web.driving import PUMA

RIGHT = {"table": {"convention": "modified", "angle_unit": "deg", "length_unit": "m", "rows": PUMA["rows"]}}
GRADE = "/api/v1/exercises/puma560/grade"


@pytest.fixture
def client(tmp_path: Path) -> Iterator[httpx.Client]:
    settings = Settings(storage="on", data_folder=tmp_path)
    with running(settings) as url, httpx.Client(base_url=url, timeout=120, trust_env=False) as found:
        yield found


def figures(client: httpx.Client) -> dict[tuple[str, frozenset[tuple[str, str]]], float]:
    """Every sample by its name and labels."""
    answer = client.get("/metrics")
    assert answer.status_code == 200
    assert answer.headers["content-type"].startswith("text/plain")
    return {
        (sample.name, frozenset(sample.labels.items())): sample.value
        for family in text_string_to_metric_families(answer.text)
        for sample in family.samples
    }


def figure(found: dict[tuple[str, frozenset[tuple[str, str]]], float], name: str, **labels: str) -> float:
    """The sum of the samples that have these labels."""
    return sum(
        value for (known, given), value in found.items() if known == name and set(labels.items()) <= given
    )


def test_requests_judgements_and_refusals_are_counted(client: httpx.Client) -> None:
    wrong = {"table": {**RIGHT["table"], "rows": [{**row, "alpha": "0"} for row in PUMA["rows"]]}}
    for body in (RIGHT, RIGHT, wrong, {"table": {}}):
        client.post(GRADE, json=body)
    client.get("/nothing/here/of/ann")
    found = figures(client)
    route = {"route": "/api/v1/exercises/{exercise_id}/grade", "method": "POST"}
    assert figure(found, "framewise_request_seconds_count", **route, status="200") == 3
    assert figure(found, "framewise_request_seconds_count", **route, status="422") == 1
    assert figure(found, "framewise_request_seconds_sum", **route) > 0
    assert figure(found, "framewise_grades_total", outcome="right", kept="no") == 2
    assert figure(found, "framewise_grades_total") == 3
    assert figure(found, "framewise_refusals_total", code="field_missing") == 1
    assert figure(found, "framewise_refusals_total", code="address_unknown") == 1
    assert figure(found, "framewise_storage_up") == 1
    assert {dict(labels)["lane"] for name, labels in found if name == "framewise_lane_waiting"} >= {
        "grading",
        "courses",
        "processes-quick",
    }


def test_what_is_answered_before_the_routes_counts_for_its_route(tmp_path: Path) -> None:
    settings = Settings(
        storage="off", data_folder=tmp_path, cost_per_minute=5, cors_origins=("https://a.example",)
    )
    with running(settings) as url, httpx.Client(base_url=url, timeout=120, trust_env=False) as client:
        asks = {"Origin": "https://a.example", "Access-Control-Request-Method": "POST"}
        assert client.options(GRADE, headers=asks).status_code == 200
        assert [client.post(GRADE, json=RIGHT).status_code for _ in range(2)] == [200, 429]
        assert client.post("/api/v1/nothing", json={}).status_code == 429
        found = figures(client)
    route = "/api/v1/exercises/{exercise_id}/grade"
    assert figure(found, "framewise_request_seconds_count", route=route, method="OPTIONS", status="200") == 1
    assert figure(found, "framewise_request_seconds_count", route=route, method="POST", status="429") == 1
    assert figure(found, "framewise_request_seconds_count", route="none") == 1


def test_replays_and_their_refusals_count_for_their_route(client: httpx.Client) -> None:
    headers = {"Idempotency-Key": "k"}
    answers = [client.post(GRADE, json=RIGHT, headers=headers) for _ in range(2)]
    answers.append(client.post(GRADE, json={}, headers=headers))
    assert [answer.status_code for answer in answers] == [200, 200, 422]
    assert figure(figures(client), "framewise_request_seconds_count", route="none") == 0


def test_callers_cannot_make_series_of_their_own(client: httpx.Client) -> None:
    before = len(figures(client))
    for n in range(20):
        client.request(f"METHOD{n}", f"/made/up/{n}")
        client.get(f"/api/v1/exercises/puma560?seed=ann{n}")
    found = figures(client)
    assert len(found) - before < 200
    assert "ann" not in "".join(f"{name}{sorted(labels)}" for name, labels in found)


def test_metrics_can_be_switched_off(tmp_path: Path) -> None:
    with running(Settings(data_folder=tmp_path, metrics="off")) as url:
        answer = httpx.get(f"{url}/metrics", timeout=120, trust_env=False)
    assert (answer.status_code, answer.json()["code"]) == (404, "address_unknown")


def test_the_outbox_has_an_age(tmp_path: Path) -> None:
    store = open_store("", tmp_path)
    session = joined(store)
    assert outbox_state(store, NOW).waiting == 0
    submitted(store, session, 0.5)
    found = outbox_state(store, NOW + timedelta(seconds=90))
    assert (found.waiting, found.dead, found.oldest) == (1, 0, 90.0)
    with store.writing() as connection:
        connection.execute(sa.update(records.score_to_send).values(dead=True))
    found = outbox_state(store, datetime.now(UTC))
    assert (found.waiting, found.dead, found.oldest) == (0, 1, 0.0)
    store.close()


def test_a_server_of_several_processes_tells_the_figures_of_all(tmp_path: Path) -> None:
    environment = {**os.environ, "FRAMEWISE_DATA_FOLDER": str(tmp_path), "FRAMEWISE_STORAGE": "on"}
    command = [sys.executable, "-m", "service", "serve", "--port", "0", "--workers", "2"]
    process = subprocess.Popen(command, cwd=ROOT, env=environment, stderr=subprocess.PIPE, text=True)
    try:
        assert process.stderr
        said = iter(process.stderr.readline, "")
        url = next(found[1] for line in said if (found := re.search(r"running on (http://\S+)", line)))
        asked = 0
        deadline = time.monotonic() + 120
        while asked < 20 and time.monotonic() < deadline:
            try:  # a connection of its own each time, so that both processes are asked
                asked += httpx.get(f"{url}/version", timeout=120, trust_env=False).status_code == 200
            except httpx.HTTPError:
                time.sleep(0.1)
        with httpx.Client(base_url=url, timeout=120, trust_env=False) as client:

            def counted() -> bool:
                return figure(figures(client), "framewise_request_seconds_count", route="/version") == 20

            # a process counts a request once it is over: its answer may have come a little before
            assert eventually(counted)
    finally:
        process.terminate()
        process.communicate(timeout=120)


def test_traces_name_routes_and_nobody(tmp_path: Path) -> None:
    kept = InMemorySpanExporter()
    provider = TracerProvider()
    provider.add_span_processor(SimpleSpanProcessor(kept))
    app = create_app(Settings(data_folder=tmp_path))
    app.add_middleware(TracingMiddleware, provider=provider)
    trace = "4bf92f3577b34da6a3ce929d0e0e4736"

    async def asked() -> None:
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://t", timeout=120) as client:
            headers = {"traceparent": f"00-{trace}-00f067aa0ba902b7-01", "X-Request-Id": "r-1"}
            await client.get("/api/v1/exercises/puma560?seed=ann", headers=headers)
            await client.get("/of/ann")

    import asyncio

    asyncio.run(asked())
    app.state.resources.close()
    first, second = kept.get_finished_spans()
    assert first.name == "GET /api/v1/exercises/{exercise_id}"
    assert format(first.context.trace_id, "032x") == trace
    assert first.attributes == {
        "http.request.method": "GET",
        "http.route": "/api/v1/exercises/{exercise_id}",
        "http.response.status_code": 200,
        "framewise.request_id": "r-1",
    }
    assert second.attributes["http.response.status_code"] == 404
    assert "ann" not in second.to_json()


def test_the_last_traces_are_sent_when_the_server_ends(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Those of the last five seconds were lost with each process."""
    kept = InMemorySpanExporter()
    provider = TracerProvider()
    provider.add_span_processor(BatchSpanProcessor(kept, schedule_delay_millis=3_600_000))
    monkeypatch.setattr("service.app.exporting", lambda _: provider)
    settings = Settings(storage="off", data_folder=tmp_path, traces="http://collector.example:4318/v1/traces")
    with running(settings) as url:
        assert httpx.get(f"{url}/version", timeout=120, trust_env=False).status_code == 200
    assert [span.name for span in kept.get_finished_spans()] == ["GET /version"]


def test_the_dashboard_asks_for_figures_that_there_are(client: httpx.Client) -> None:
    client.post(GRADE, json=RIGHT)
    client.get("/nothing")
    known = {name for name, _ in figures(client)}
    board = json.loads((ROOT / "deploy/grafana/framewise.json").read_text(encoding="utf-8"))
    asked = [target["expr"] for panel in board["panels"] for target in panel.get("targets", ())]
    assert len(asked) >= 8
    for expression in asked:
        named = set(re.findall(r"(?:framewise|process)_\w+", expression))
        assert named, expression
        assert named <= known, expression
