"""Places for work in threads, and how threads take turns."""

import asyncio
import itertools
import sys
import threading
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any
from unittest.mock import patch

import httpx
import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises.instance import Instance, cached_instance
from service.app import create_app
from service.http.problems import BusyError, busy, located
from service.routes.exercises import exercises
from service.settings import Settings
from service.wire.exercises import exercise_views
from service.work import fair_queue
from service.work.fair_queue import AHEAD, CLIENTS, FIRST, Client, FairQueue, Name, Proven, current_client
from service.work.heaps import SWITCH_SECONDS
from service.work.limiters import DONE, LIGHT, TRIED, Limiter, WorkKind, limiters

TABLE = {"convention": "standard", "rows": [{"alpha": 0, "a": "1", "d": 0, "theta": f"q{i}"} for i in (1, 2)]}


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


def test_a_line_that_is_never_empty_does_not_grow() -> None:
    """Whose turn it is is found as fast after an hour of many requests from one address as at its start."""

    async def scene() -> None:
        queue = FairQueue(slots=1, capacity=10, timeout=60)
        current_client.set(("a class", 0))
        slot = await queue.acquire()
        waiting = [asyncio.create_task(queue.acquire())]
        await asyncio.sleep(0)
        for port in range(200):
            current_client.set(("a class", port % 7))
            waiting.append(asyncio.create_task(queue.acquire()))
            await asyncio.sleep(0)
            slot.release()
            done, _ = await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
            (task,) = done
            waiting.remove(task)
            slot = task.result()
        assert len(queue._line._names) < 10
        for task in waiting:
            task.cancel()

    asyncio.run(scene())


def test_a_server_has_its_threads_take_short_turns(base_url: str) -> None:
    assert base_url
    assert sys.getswitchinterval() <= SWITCH_SECONDS * 1.01


@pytest.mark.parametrize(
    ("worker", "stranger"),
    [(("person", 1), ("stranger", 2)), (("one address", 1), ("one address", 2))],
    ids=["names", "connections of one name"],
)
def test_who_used_much_while_nobody_waited_does_not_stand_still_for_a_stranger(
    worker: Client, stranger: Client
) -> None:
    """A stranger comes first, as having used less, and from then on the two take turns."""

    async def scene() -> list[Client]:
        clock = SimpleNamespace(now=1000.0, monotonic=lambda: clock.now)
        with patch.object(fair_queue, "time", clock):
            queue = FairQueue(slots=1, capacity=100, timeout=60)

            def wait(client: Client) -> asyncio.Task[fair_queue.Slot]:
                current_client.set(client)
                return asyncio.create_task(queue.acquire())

            for seconds in (100.0, 0.0):
                slot = await wait(worker)
                clock.now += seconds
                slot.release()
            slot = await wait(worker)
            waiting = {client: wait(client) for client in (worker, stranger)}
            await asyncio.sleep(0)
            served = []
            for _ in range(20):
                clock.now += AHEAD / 2
                slot.release()
                await asyncio.wait(waiting.values(), return_when=asyncio.FIRST_COMPLETED)
                (client,) = (client for client, task in waiting.items() if task.done())
                served.append(client)
                slot = waiting[client].result()
                waiting[client] = wait(client)
                await asyncio.sleep(0)
            for task in waiting.values():
                task.cancel()
            return served

    served = asyncio.run(scene())
    assert served[0] == stranger
    assert 8 <= served.count(worker) <= 10
    assert all(worker in served[i : i + 4] for i in range(17))


@pytest.mark.parametrize(("used", "place"), [(0.0, 0), (FIRST / 2, 0), (2 * FIRST, 10)])
def test_what_is_handed_in_goes_first_until_a_person_has_handed_in_much(used: float, place: int) -> None:
    """Once somebody had used much, all who came after that waited in the order in which they came."""
    student: Client = (Proven("hand-in", 1), 1)

    async def scene() -> int:
        clock = SimpleNamespace(now=1000.0, monotonic=lambda: clock.now)
        with patch.object(fair_queue, "time", clock):
            queue = FairQueue(slots=1, capacity=100, timeout=60)

            def wait(client: Client) -> asyncio.Task[fair_queue.Slot]:
                current_client.set(client)
                return asyncio.create_task(queue.acquire())

            for client, seconds in ((student, used), (("hostile", 1), 100.0)):
                slot = await wait(client)
                clock.now += seconds
                slot.release()
                clock.now -= seconds
            slot = await wait(("hostile", 1))
            readers = [wait((Proven("person", number), number)) for number in range(10)]
            handed_in = wait(student)
            await asyncio.sleep(0)
            before = 0
            while True:
                clock.now += 0.001
                slot.release()
                await asyncio.sleep(0)
                if handed_in.done():
                    break
                (slot,) = [task.result() for task in readers if task.done() and task.result().held]
                before += 1
            for task in readers:
                task.cancel()
            return before

    assert asyncio.run(scene()) == place


@given(
    taken=st.lists(st.tuples(st.integers(0, 2), st.integers(0, 3), st.sampled_from([0.0, 1.0])), max_size=12),
    waiting=st.lists(st.tuples(st.integers(0, 2), st.integers(0, 3)), max_size=12),
    leaving=st.sets(st.integers(0, 11)),
)
def test_the_next_is_who_used_least(
    taken: list[tuple[int, int, float]], waiting: list[tuple[int, int]], leaving: set[int]
) -> None:
    """The heaps give the order that the rule gives: least use by name, then of the connection."""

    async def scene() -> None:
        queue = FairQueue(slots=1, capacity=100, timeout=60)
        used: dict[object, float] = {}
        first = await queue.acquire()
        order: list[int] = []

        async def wait(number: int, client: Client) -> None:
            current_client.set(client)
            await queue.acquire()
            order.append(number)

        names: list[Name] = ["192.0.2.1", Proven("person", 1), Proven("key", 1)]
        clients: list[Client] = [(names[name], port) for name, port in waiting]
        tasks = [asyncio.create_task(wait(number, client)) for number, client in enumerate(clients)]
        await asyncio.sleep(0)
        gone = {number for number in leaving if number < len(tasks)}
        for number in gone:
            tasks[number].cancel()
        await asyncio.sleep(0)
        left = [number for number in range(len(tasks)) if number not in gone]
        for name, port, seconds in taken:
            client = (names[name], port)
            for key in (client[0], client):
                used[key] = used.get(key, 0.0) + seconds

            def rule(n: int) -> tuple[float, float]:
                return used.get(clients[n][0], 0.0), used.get(clients[n], 0.0)

            expected = min(left, key=rule, default=None)
            queue.release(client, seconds)
            for _ in range(3):
                await asyncio.sleep(0)
            if expected is None:
                queue.running += 1
                continue
            left.remove(expected)
            assert order[-1] == expected
            assert queue.waiting == len(left)
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        first.release()

    clock = itertools.repeat(0.0)
    with patch.object(fair_queue, "time", SimpleNamespace(monotonic=lambda: next(clock))):
        asyncio.run(scene())


def test_only_the_first_to_ask_waits_for_a_thread() -> None:
    async def scene() -> None:
        limiter = Limiter(threads=1, capacity=0, timeout=1)
        here = threading.get_ident()
        assert await limiter.run_first("asked", threading.get_ident, "asked") != here
        with pytest.raises(ZeroDivisionError):
            await limiter.run_first("failed", lambda: 1 // 0, "failed")
        slot = await limiter.acquire()
        assert await limiter.run_first("asked", threading.get_ident, "asked") == here
        for question in ("new", "failed"):
            with pytest.raises(BusyError):
                await limiter.run_first(question, threading.get_ident, question)
        slot.release()
        for number in range(DONE):
            await limiter.run_first(number, threading.get_ident, number)
        assert await limiter.run_first("asked", threading.get_ident, "asked") != here

    asyncio.run(scene())


@pytest.mark.parametrize(
    ("method", "path", "body"),
    [
        ("GET", "/exercises/twolink", None),
        ("GET", "/api/v1/exercises/twolink", None),
        ("GET", "/api/v1/exercises/twolink/figure.svg", None),
        ("GET", "/api/v1/exercises/twolink/figures/old.svg", None),
        ("POST", "/api/v1/exercises/twolink/grade", {"table": TABLE}),
        ("POST", "/api/v1/exercises/twolink/receipts", {"table": TABLE, "name": "A"}),
    ],
)
def test_a_students_values_are_drawn_beside_the_event_loop(
    method: str, path: str, body: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To draw them takes a part that seeks a mistake to plant a tenth of a second."""
    threads: list[int] = []

    def noted(*asked: Any) -> Instance:
        threads.append(threading.get_ident())
        return cached_instance(*asked)

    for module in (exercise_views, exercises):
        monkeypatch.setattr(module, "cached_instance", noted)
    app = create_app(Settings())

    async def scene() -> int:
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
            return (await client.request(method, path, json=body)).status_code

    try:
        assert asyncio.run(scene()) in (200, 307)
    finally:
        app.state.resources.close()
    assert threads
    assert threading.get_ident() not in threads


def test_work_of_a_kind_that_takes_little_needs_no_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = SimpleNamespace(now=0.0)
    monkeypatch.setattr("service.work.limiters.time", SimpleNamespace(thread_time=lambda: clock.now))

    def taking(seconds: float) -> Callable[[], bool]:
        def work() -> bool:
            clock.now += seconds
            return threading.current_thread() is threading.main_thread()

        return work

    async def scene() -> None:
        limiter = Limiter(threads=1, capacity=8, timeout=60)
        asked = itertools.count()

        async def at_once(seconds: float, kind: str) -> bool:
            return await limiter.run_first(next(asked), taking(seconds), kind)

        assert [await at_once(0.001, "light") for _ in range(TRIED + 2)] == [False] * TRIED + [True] * 2
        assert not any([await at_once(2 * LIGHT, "heavy") for _ in range(TRIED + 2)])
        assert await at_once(2 * LIGHT, "light")
        assert not await at_once(0.001, "light")
        for number in range(DONE):
            await at_once(0.001, str(number))
        assert len(limiter._kinds) == DONE
        await asyncio.gather(*(at_once(0.001, "light") for _ in range(8)))
        await asyncio.sleep(0)
        assert limiter.queue.running == 0

    asyncio.run(scene())


def test_that_no_slot_is_free_stands_nowhere_in_the_request() -> None:
    with pytest.raises(BusyError) as refused, located("answer"):
        raise busy()
    assert refused.value.faults[0].where == ()
