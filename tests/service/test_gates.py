"""Places for work in threads, and how threads take turns."""

from __future__ import annotations

import gc
import sys

import anyio
import pytest

from service.http.problems import BusyError
from service.settings import Settings
from service.work.limiters import Gate, Work, gates
from service.work.thread_switching import SWITCH_SECONDS


def test_so_many_at_a_time_so_many_waiting_and_the_next_is_refused() -> None:
    async def scene() -> None:
        gate = Gate(threads=1, waiting=1)
        first, second = gate.enter(), gate.enter()
        with pytest.raises(BusyError) as refused:
            gate.enter()
        assert refused.value.faults[0].code == "busy"
        assert refused.value.headers["Retry-After"] == "2"
        first.leave()
        first.leave()
        assert await gate.run(lambda: 42) == 42
        third = gate.enter()
        with pytest.raises(BusyError):
            await gate.run(lambda: 42)
        second.leave()
        third.leave()

    anyio.run(scene)


def test_work_that_fails_leaves_its_place() -> None:
    async def scene() -> None:
        gate = Gate(threads=1, waiting=0)
        for _ in range(3):
            with pytest.raises(ZeroDivisionError):
                await gate.run(lambda: 1 / 0)
        assert await gate.run(lambda: 42) == 42

    anyio.run(scene)


def test_a_figure_does_not_wait_behind_wrong_answers() -> None:
    async def scene() -> None:
        found = gates(Settings(grading_threads=1, grading_queue=0, batch_threads=1, batch_queue=0))
        for work in (Work.GRADING, Work.BATCH):
            found[work].enter()
            with pytest.raises(BusyError):
                found[work].enter()
        assert await found[Work.DRAWING].run(lambda: "figure") == "figure"

    anyio.run(scene)


def test_a_server_has_its_threads_take_short_turns(base_url: str) -> None:
    assert base_url
    assert sys.getswitchinterval() <= SWITCH_SECONDS * 1.01
    assert gc.get_freeze_count() > 0
