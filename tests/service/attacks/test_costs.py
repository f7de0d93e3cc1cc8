"""No request of the corpus costs the event loop much work or memory: counted, not timed."""

import asyncio
import ctypes
import gc
import json
import sys
import threading
import tracemalloc
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from kinematics.cells import Limits
from kinematics.cells.grammar import parse
from service.app import create_app
from service.settings import Settings
from tests.conftest import EXPLORE
from tests.document import DOCUMENT
from tests.service.attacks.corpus import FIELDS, Attack, attacks, in_each_field

CALLS = 70_000
"""Python calls that answering may take in the event loop: about 25 ms."""
MEMORY = 50 * 1024 * 1024
LARGE = 1_100_000
"""Longer bodies are batches, of which a limit says how many there are."""


@pytest.fixture(scope="module")
def corpus() -> list[Attack]:
    return [attack for attack in attacks() if len(attack.body) < 4 * 1024 * 1024]


@pytest.fixture(scope="module")
def app() -> Iterator[Any]:
    made = create_app(Settings(symbolic_seconds=0.5, queue_seconds=120))
    answered(made, Attack("to read the message files", "/api/v1/understand", b"{}"))
    parse("2*L1", Limits())  # a service that has begun has the tables of the cells' grammar
    yield made
    made.state.resources.workers.close()


def answered(app: Any, attack: Attack) -> httpx.Response:
    async def ask() -> httpx.Response:
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://test", timeout=300) as client:
            headers = {"Content-Type": "application/json"}
            return await client.post(attack.path, content=attack.body, headers=headers)

    return asyncio.run(ask())


def counted(app: Any, attack: Attack) -> tuple[httpx.Response, int]:
    """The answer, and how many Python functions were called for it in the thread of the event loop."""
    calls = 0
    loop_thread = threading.get_ident()

    def count(_frame: Any, event: str, _argument: Any) -> None:
        nonlocal calls
        if event == "call" and threading.get_ident() == loop_thread:
            calls += 1

    sys.setprofile(count)
    try:
        return answered(app, attack), calls
    finally:
        sys.setprofile(None)


def test_the_corpus_reaches_every_kind_of_call(corpus: list[Attack]) -> None:
    assert len(corpus) > 200
    assert len({attack.path for attack in corpus}) >= 8


def test_no_attack_takes_much_work_of_the_event_loop_or_memory(app: Any, corpus: list[Attack]) -> None:
    for attack in corpus[:3]:
        answered(app, attack)
    expensive = []
    for attack in corpus:
        before = least_memory()
        response, calls = counted(app, attack)
        grown = most_memory() - before
        assert response.status_code in (200, 400, 413, 415, 422), (attack.name, response.text[:200])
        if calls > CALLS:
            expensive.append(f"{attack.name}: {calls} calls")
        if len(attack.body) <= LARGE and grown > MEMORY:
            expensive.append(f"{attack.name}: {grown} bytes")
    assert not expensive


def test_no_field_of_any_call_takes_much_work_of_the_event_loop(app: Any) -> None:
    expensive, fields = [], list(in_each_field(DOCUMENT, every=EXPLORE))
    for attack in fields:
        response, calls = counted(app, attack)
        assert response.status_code in (200, 400, 413, 415, 422), (attack.name, response.text[:200])
        if calls > CALLS:
            expensive.append(f"{attack.name}: {calls} calls")
    assert not expensive
    assert len(fields) > 300


FEW_FINDINGS = 600
"""Findings of one refusal: each costs some microseconds, in one stretch that lets no other thread run."""
NESTED = ("lists of texts", "lists of objects", "objects of fields", "rows", "fields")
LISTED = (
    ("grade", "reference", "rows"),
    ("understand", "table", "rows"),
    ("check-dynamics", "links", ""),
    ("inverse-kinematics", "target", ""),
    ("inverse-kinematics", "targets", ""),
    ("check-frames", "tool", ""),
    ("check-screws", "home", ""),
    ("forward-kinematics", "joints", ""),
)
"""Calls, and fields of theirs, that take lists of objects or lists of lists."""


@pytest.mark.parametrize("kind", NESTED)
@pytest.mark.parametrize(("call", "field", "below"), LISTED)
def test_no_more_is_found_wrong_than_anybody_reads(
    app: Any, kind: str, call: str, field: str, below: str
) -> None:
    value = {"convention": "standard", below: FIELDS[kind]} if below else FIELDS[kind]
    body = json.dumps({field: value}).encode()
    refusal = answered(app, Attack(kind, f"/api/v1/{call}", body)).json()
    assert refusal.get("errors_total", len(refusal["errors"])) <= FEW_FINDINGS


@pytest.mark.parametrize("rows", [16, 64])
def test_each_wrong_row_of_a_usual_table_is_told(app: Any, rows: int) -> None:
    """Of a longer one the first is."""
    row = {"alpha": 0, "a": 0, "d": 0}
    body = {"reference": {"convention": "standard", "rows": [row] * rows}}
    refusal = answered(app, Attack("rows", "/api/v1/grade", json.dumps(body).encode())).json()
    found = [error["pointer"] for error in refusal["errors"] if error["pointer"].startswith("/reference")]
    assert found == [f"/reference/rows/{i}/theta" for i in range(rows if rows == 16 else 1)]


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="needs Linux's peak of memory")
def test_memory_that_was_held_for_a_moment_is_seen() -> None:
    before = least_memory()
    held = [bytes(1000) for _ in range(MEMORY // 500)]
    del held
    assert most_memory() - before > MEMORY


def least_memory() -> int:
    """What this process holds [byte], after it gave back what it does not use; its peak begins anew."""
    if not Path("/proc/self/clear_refs").exists():
        return 0
    if trim := getattr(ctypes.CDLL(None), "malloc_trim", None):  # glibc's
        trim(0)
    Path("/proc/self/clear_refs").write_text("5")
    return _told("VmRSS")


def most_memory() -> int:
    """The most that it has held since [byte]; 0 where the system does not tell."""
    return _told("VmHWM") if Path("/proc/self/clear_refs").exists() else 0


def _told(name: str) -> int:
    lines = Path("/proc/self/status").read_text().splitlines()
    return 1024 * int(next(line for line in lines if line.startswith(name)).split()[1])


def test_names_that_callers_choose_are_not_hoarded(app: Any) -> None:
    """Refused sentences hold what the caller sent: sixty long ones, 30 MB, must not stay."""
    tracemalloc.start()
    try:
        for number in range(60):
            body = json.dumps({"table": f"{number:02}" * 250_000}).encode()
            answered(app, Attack("long value", "/api/v1/jacobian", body))
            body = json.dumps(
                {"robot": "puma560", "joints": [0] * 6, f"{number}" + "x" * 500_000: 1}
            ).encode()
            answered(app, Attack("long name", "/api/v1/jacobian", body))
        gc.unfreeze()  # a server of another test may run, and put aside what this one's client leaves
        gc.collect()
        held, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert held < 20 * 1024 * 1024
