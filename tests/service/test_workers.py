"""Worker processes: what runs out of time or memory ends, and nothing else does."""

import asyncio
import os
import signal
import subprocess
import sys
import threading
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from kinematics.errors import FormSizeError
from service.http.problems import BusyError, RequestError, UnavailableError
from service.settings import Settings
from service.work.fair_queue import current_client
from service.work.processes import WorkerProcess
from service.work.workers import Lane, Workers
from tests.service.tasks import (
    asleep,
    crash,
    double,
    doubled_in_time,
    doubled_whatever_is_caught,
    endless,
    greedy,
    imported,
    noted,
    pid,
    refuse,
    refused_in_time,
    until_there,
)

KILLS = int(os.environ.get("KILLS", "0"))
"""Times that worker processes are killed, in turns of all combinations; the suite kills each once."""


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


def test_of_a_list_of_tasks_what_was_done_in_time_is_kept() -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=30.0) as pool:
            process = await pool.run(Lane.SLOW, pid)
            assert await pool.run(Lane.SLOW, doubled_in_time, [1, 2, -1, 3], 0.3) == [2, 4]
            assert await pool.run(Lane.SLOW, doubled_in_time, [-1], 0.3) == []
            assert await pool.run(Lane.SLOW, doubled_in_time, [1, 2, 3], 0.3) == [2, 4, 6]
            assert await pool.run(Lane.SLOW, pid) == process

    run(test)


@pytest.mark.parametrize("goes_on", [False, True])
def test_time_is_over_whatever_a_library_catches(goes_on: bool) -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=30.0) as pool:
            process = await pool.run(Lane.SLOW, pid)
            for _ in range(3):
                numbers = [1, 2, -1, 3]
                assert await pool.run(Lane.SLOW, doubled_whatever_is_caught, numbers, 0.1, goes_on) == [2, 4]
            assert await pool.run(Lane.SLOW, pid) == process

    run(test)


def test_what_is_refused_in_time_is_refused() -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=30.0) as pool:
            with pytest.raises(FormSizeError):
                await pool.run(Lane.SLOW, refused_in_time, [1, 2, 3], 0.3)

    run(test)


def test_what_runs_out_of_time_is_killed_and_the_lane_goes_on() -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=1.0) as pool:
            await pool.run(Lane.SLOW, double, 1)
            started = asyncio.create_task(pool.run(Lane.SLOW, endless))
            await asyncio.sleep(0)
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
            with pytest.raises(UnavailableError) as refused:
                await pool.run(Lane.SLOW, crash)
            assert refused.value.faults[0].code == "computation_aborted"
            assert await pool.run(Lane.SLOW, double, 6) == 12

    run(test)


def test_time_that_other_programs_take_does_not_count() -> None:
    async def test() -> None:
        async with workers(symbolic_seconds=0.2) as pool:
            assert await pool.run(Lane.SLOW, asleep, 0.5) == 0.5

    run(test)


def test_a_full_queue_is_refused_at_once_with_a_time_to_retry(tmp_path: Path) -> None:
    go = tmp_path / "go"

    async def test() -> None:
        async with workers(symbolic_queue=1, symbolic_workers=1, queue_seconds=120) as pool:
            tasks = (until_there, str.upper)
            running = [asyncio.create_task(pool.run(Lane.SLOW, task, str(go))) for task in tasks]
            while pool.lanes[Lane.SLOW].queue.waiting < 1:
                await asyncio.sleep(0.01)
            with pytest.raises(BusyError) as refused:
                await pool.run(Lane.SLOW, double, 1)
            assert refused.value.headers["Retry-After"] == "2"
            go.touch()
            assert await asyncio.gather(*running) == [None, str(go).upper()]

    run(test)


def test_who_waits_too_long_is_told_to_come_back(tmp_path: Path) -> None:
    go = tmp_path / "go"

    async def test() -> None:
        async with workers(queue_seconds=0.2) as pool:
            first = asyncio.create_task(pool.run(Lane.SLOW, until_there, str(go)))
            await asyncio.sleep(0)
            with pytest.raises(BusyError):
                await pool.run(Lane.SLOW, double, 1)
            go.touch()
            await first
            assert await pool.run(Lane.SLOW, double, 2) == 4

    run(test)


def test_the_same_question_is_computed_once(tmp_path: Path) -> None:
    notes = str(tmp_path / "notes")

    async def test() -> None:
        async with workers(symbolic_queue=0) as pool:
            answers = await asyncio.gather(*(pool.run(Lane.SLOW, noted, notes, "x") for _ in range(30)))
            assert answers == ["x"] * 30

    run(test)
    assert Path(notes).read_text() == "x"


SOON = (str.casefold, str.capitalize, str.title, str.swapcase)
"""Tasks that are not the same question."""


def test_one_client_of_many_tasks_does_not_keep_another_out(tmp_path: Path) -> None:
    order: list[str] = []
    go = tmp_path / "go"

    async def ask(pool: Workers, client: tuple[str, int], name: str, task: Callable[..., object]) -> None:
        current_client.set(client)
        await pool.run(Lane.SLOW, task, str(go))
        order.append(name)

    async def test() -> None:
        async with workers() as pool:
            greedy = [asyncio.create_task(ask(pool, ("192.0.2.1", 1), "greedy", until_there))]
            greedy += [asyncio.create_task(ask(pool, ("192.0.2.1", 1), "greedy", task)) for task in SOON]
            others = [
                asyncio.create_task(ask(pool, ("192.0.2.1", 2), "same address", str.upper)),
                asyncio.create_task(ask(pool, ("192.0.2.2", 1), "other", str.lower)),
            ]
            while pool.lanes[Lane.SLOW].queue.waiting < len(SOON) + len(others):
                await asyncio.sleep(0)
            go.touch()
            await asyncio.gather(*greedy, *others)

    run(test)
    assert order[:3] == ["greedy", "other", "same address"]


def test_killed_processes_are_replaced_and_nothing_is_refused() -> None:
    async def test() -> None:
        async with workers() as pool:
            combinations = 2 ** len(Lane) - 1
            for kill in range(max(KILLS, combinations)):
                lanes = [lane for bit, lane in enumerate(Lane) if (kill % combinations + 1) >> bit & 1]
                for lane in lanes:
                    os.kill(await pool.run(lane, pid), signal.SIGKILL)
                for number, lane in enumerate(Lane):
                    assert await pool.run(lane, double, number) == 2 * number
            for lane in Lane:  # while a task is being done
                victim = await pool.run(lane, pid)
                doing = asyncio.create_task(pool.run(lane, asleep, 0.3))
                await asyncio.sleep(0.1)
                os.kill(victim, signal.SIGKILL)
                assert await doing == 0.3

    run(test)


def test_a_lane_says_whether_its_processes_are_there() -> None:
    async def test() -> None:
        async with workers() as pool:
            lane = pool.lanes[Lane.SLOW]
            victim = await pool.run(Lane.SLOW, pid)
            assert lane.heal()
            os.kill(victim, signal.SIGKILL)
            while lane.heal():
                await asyncio.sleep(0.01)
            assert lane.heal()
            assert await pool.run(Lane.SLOW, pid) != victim

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
            assert await asyncio.wait_for(pool.run(Lane.SLOW, double, 7), 120) == 14

    run(test)


def test_a_connection_stays_open_until_its_thread_has_left_it(monkeypatch: pytest.MonkeyPatch) -> None:
    entered, proceed = threading.Event(), threading.Event()
    held: list[WorkerProcess] = []
    was_open: list[bool] = []
    perform = WorkerProcess.perform

    def late(process: WorkerProcess, task: bytes, timeout: float) -> bytes:
        held.append(process)
        entered.set()
        assert proceed.wait(120)
        was_open.append(not process._connection.closed)
        return perform(process, task, timeout)

    async def test() -> None:
        async with workers(symbolic_seconds=30.0) as pool:
            monkeypatch.setattr(WorkerProcess, "perform", late)
            task = asyncio.create_task(pool.run(Lane.SLOW, endless))
            assert await asyncio.to_thread(entered.wait, 120)
            monkeypatch.setattr(WorkerProcess, "perform", perform)
            task.cancel()
            with pytest.raises(asyncio.CancelledError):
                await task
            proceed.set()
            assert await asyncio.wait_for(pool.run(Lane.SLOW, double, 7), 120) == 14
        assert was_open == [True]
        assert held[0]._connection.closed

    run(test)


def test_the_main_module_is_never_run_again_nor_needed() -> None:
    """A script without the usual guard, read from standard input, where there is no file to import."""
    program = """
from starlette.testclient import TestClient
from service.app import create_app
from tests.examples import PUMA_LENGTHS
print("begin")
print(TestClient(create_app()).post("/api/v1/symbolic", json={"table": PUMA_LENGTHS}).status_code)
"""
    command = [sys.executable, "-"]
    done = subprocess.run(command, input=program, capture_output=True, text=True, check=True, timeout=300)
    assert done.stdout.split() == ["begin", "200"]
