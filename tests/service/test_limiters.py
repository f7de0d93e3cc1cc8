"""Places for work in threads, and how threads take turns."""

from __future__ import annotations

import gc
import sys

import anyio
import pytest

from service.http.problems import BusyError
from service.settings import Settings
from service.work.limiters import Limiter, WorkKind, limiters
from service.work.thread_switching import SWITCH_SECONDS


def test_so_many_at_a_time_so_many_waiting_and_the_next_is_refused() -> None:
    async def scene() -> None:
        limiter = Limiter(threads=1, waiting=1)
        first, second = limiter.acquire(), limiter.acquire()
        with pytest.raises(BusyError) as refused:
            limiter.acquire()
        assert refused.value.faults[0].code == "busy"
        assert refused.value.headers["Retry-After"] == "2"
        first.release()
        first.release()
        assert await limiter.run(lambda: 42) == 42
        third = limiter.acquire()
        with pytest.raises(BusyError):
            await limiter.run(lambda: 42)
        second.release()
        third.release()

    anyio.run(scene)


def test_work_that_fails_leaves_its_place() -> None:
    async def scene() -> None:
        limiter = Limiter(threads=1, waiting=0)
        for _ in range(3):
            with pytest.raises(ZeroDivisionError):
                await limiter.run(lambda: 1 / 0)
        assert await limiter.run(lambda: 42) == 42

    anyio.run(scene)


def test_a_figure_does_not_wait_behind_wrong_answers() -> None:
    async def scene() -> None:
        found = limiters(Settings(grading_threads=1, grading_queue=0, batch_threads=1, batch_queue=0))
        for work in (WorkKind.GRADING, WorkKind.BATCH):
            found[work].acquire()
            with pytest.raises(BusyError):
                found[work].acquire()
        assert await found[WorkKind.DRAWING].run(lambda: "figure") == "figure"

    anyio.run(scene)


def test_a_server_has_its_threads_take_short_turns(base_url: str) -> None:
    assert base_url
    assert sys.getswitchinterval() <= SWITCH_SECONDS * 1.01
    assert gc.get_freeze_count() > 0
