"""Places for work in threads, and how threads take turns."""

from __future__ import annotations

import asyncio
import gc
import sys

import pytest

from service.http.problems import BusyError
from service.settings import Settings
from service.work.fair_queue import CLIENTS, FairQueue
from service.work.limiters import Limiter, WorkKind, limiters
from service.work.thread_switching import SWITCH_SECONDS


def test_so_many_at_a_time_so_many_waiting_and_the_next_is_refused() -> None:
    async def scene() -> None:
        limiter = Limiter(threads=1, capacity=1, timeout=60)
        first = await limiter.acquire()
        second = asyncio.create_task(limiter.acquire())
        await asyncio.sleep(0)
        with pytest.raises(BusyError) as refused:
            await limiter.acquire()
        assert refused.value.faults[0].code == "busy"
        assert refused.value.headers["Retry-After"] == "2"
        first.release()
        first.release()
        (await second).release()
        assert await limiter.run(lambda: 42) == 42
        assert (limiter.queue.running, limiter.queue.waiting) == (0, 0)

    asyncio.run(scene())


def test_who_gives_up_waiting_leaves_no_trace() -> None:
    async def scene() -> None:
        limiter = Limiter(threads=1, capacity=2, timeout=0.05)
        first = await limiter.acquire()
        with pytest.raises(BusyError):
            await limiter.acquire()
        gone = asyncio.create_task(limiter.acquire())
        await asyncio.sleep(0)
        first.release()
        gone.cancel()  # in the very moment in which it was granted
        with pytest.raises(asyncio.CancelledError):
            await gone
        assert (limiter.queue.running, limiter.queue.waiting) == (0, 0)

    asyncio.run(scene())


def test_work_that_fails_releases_its_slot() -> None:
    async def scene() -> None:
        limiter = Limiter(threads=1, capacity=0, timeout=1)
        for _ in range(3):
            with pytest.raises(ZeroDivisionError):
                await limiter.run(lambda: 1 / 0)
        assert await limiter.run(lambda: 42) == 42

    asyncio.run(scene())


def test_a_figure_does_not_wait_behind_wrong_answers() -> None:
    async def scene() -> None:
        found = limiters(Settings(grading_threads=1, grading_queue=0, batch_threads=1, batch_queue=0))
        for kind in (WorkKind.GRADING, WorkKind.BATCH):
            await found[kind].acquire()
            with pytest.raises(BusyError):
                await found[kind].acquire()
        assert await found[WorkKind.DRAWING].run(lambda: "figure") == "figure"

    asyncio.run(scene())


def test_use_is_forgotten_and_its_memory_bounded() -> None:
    async def scene() -> None:
        queue = FairQueue(slots=1, capacity=1, timeout=1)
        for number in range(CLIENTS):
            queue.running += 1
            queue.release((str(number), number), 1.0)
        assert len(queue._used) == CLIENTS

    asyncio.run(scene())


def test_a_server_has_its_threads_take_short_turns(base_url: str) -> None:
    assert base_url
    assert sys.getswitchinterval() <= SWITCH_SECONDS * 1.01
    assert gc.get_freeze_count() > 0
