"""Worker processes: what runs out of time or memory ends, and nothing else does."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from typing import Any

import pytest

from kinematics.errors import Fault, FormSizeError
from service.http.problems import BusyError, RequestError
from service.settings import Settings
from service.work.processes import process_context
from service.work.workers import Lane, Workers


def double(value: int) -> int:
    return 2 * value


def endless() -> None:
    while True:
        time.sleep(0.01)


def greedy() -> int:
    return len(bytearray(3 * 1024**3))


def crash() -> None:
    os.abort()


def refuse() -> None:
    raise FormSizeError(Fault(code="form_too_large", where=("rows", 1), params={"limit": 3}))


def imported(name: str) -> bool:
    return name in sys.modules


@asynccontextmanager
async def workers(**settings: Any) -> AsyncIterator[Workers]:
    pool = Workers(Settings(**settings))
    try:
        yield pool
    finally:
        await asyncio.to_thread(pool.close)


def run(test: Callable[[], Coroutine[Any, Any, None]]) -> None:
    asyncio.run(test())


def test_a_result_comes_back_and_errors_keep_their_faults() -> None:
    async def test() -> None:
        async with workers() as pool:
            assert await pool.run(Lane.QUICK, double, 21) == 42
            with pytest.raises(FormSizeError) as refused:
                await pool.run(Lane.SLOW, refuse)
            assert refused.value.faults[0].where == ("rows", 1)
            assert refused.value.faults[0].params == {"limit": 3}

    run(test)


def test_a_worker_has_no_computer_algebra_system() -> None:
    async def test() -> None:
        async with workers() as pool:
            assert await pool.run(Lane.QUICK, imported, "kinematics.symbolic")
            assert not await pool.run(Lane.QUICK, imported, "sympy")

    run(test)


def test_what_runs_out_of_time_is_killed_and_the_lane_goes_on() -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=1.0) as pool:
            await pool.run(Lane.SLOW, double, 1)
            started = asyncio.create_task(pool.run(Lane.SLOW, endless))
            await asyncio.sleep(0.1)
            assert await pool.run(Lane.QUICK, double, 4) == 8
            with pytest.raises(RequestError) as refused:
                await started
            assert refused.value.faults[0].code == "computation_out_of_time"
            assert await pool.run(Lane.SLOW, double, 5) == 10

    run(test)


def test_what_needs_too_much_memory_or_crashes_is_refused() -> None:
    async def test() -> None:
        async with workers() as pool:
            with pytest.raises(RequestError) as refused:
                await pool.run(Lane.SLOW, greedy)
            assert refused.value.faults[0].code == "computation_out_of_memory"
            with pytest.raises(RequestError) as refused:
                await pool.run(Lane.SLOW, crash)
            assert refused.value.faults[0].code == "computation_aborted"
            assert await pool.run(Lane.SLOW, double, 6) == 12

    run(test)


def test_a_full_queue_is_refused_at_once_with_a_time_to_retry() -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=2.0, symbolic_queue=1, symbolic_workers=1) as pool:
            running = [asyncio.create_task(pool.run(Lane.SLOW, endless)) for _ in range(2)]
            await asyncio.sleep(0.05)
            with pytest.raises(BusyError) as refused:
                await pool.run(Lane.SLOW, double, 1)
            assert refused.value.headers["Retry-After"] == "2"
            outcomes = await asyncio.gather(*running, return_exceptions=True)
            assert [type(outcome) for outcome in outcomes] == [RequestError, BusyError]

    run(test)


def test_a_caller_who_goes_away_frees_the_process() -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=30.0) as pool:
            await pool.run(Lane.SLOW, double, 1)
            task = asyncio.create_task(pool.run(Lane.SLOW, endless))
            await asyncio.sleep(0.2)
            task.cancel()
            with pytest.raises(asyncio.CancelledError):
                await task
            assert await asyncio.wait_for(pool.run(Lane.SLOW, double, 7), 15) == 14

    run(test)


def test_the_main_module_is_never_run_again_nor_needed() -> None:
    """A script without the usual guard, read from standard input, where there is no file to import."""
    program = """
from starlette.testclient import TestClient
from service.app import create_app
from service.schemas.symbolic_request import PUMA_LENGTHS
print("begin")
print(TestClient(create_app()).post("/api/v1/symbolic", json={"table": PUMA_LENGTHS}).status_code)
"""
    for command in ([sys.executable, "-"], [sys.executable, "-c", program]):
        done = subprocess.run(command, input=program, capture_output=True, text=True, check=True, timeout=60)
        assert done.stdout.split() == ["begin", "200"]


def test_without_a_folder_for_temporary_files_processes_are_spawned(monkeypatch: pytest.MonkeyPatch) -> None:
    def nowhere() -> str:
        raise FileNotFoundError

    monkeypatch.setattr(tempfile, "gettempdir", nowhere)
    assert process_context().get_start_method() == "spawn"
    monkeypatch.undo()
    assert process_context().get_start_method() == "forkserver"
