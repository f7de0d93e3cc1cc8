"""What waits together is done together, and each gets its own result."""

import asyncio
import threading
from collections.abc import Sequence

import pytest

from service.http.problems import BusyError
from service.work.batcher import MOST, Batcher


class Work:
    """Doubles numbers, once it is let go; odd ones are refused, and 13 breaks whatever it is done with."""

    def __init__(self) -> None:
        self.batches: list[list[int]] = []
        self.go = threading.Event()

    def __call__(self, numbers: Sequence[int]) -> list[int | Exception]:
        self.batches.append(list(numbers))
        assert self.go.wait(60)
        if 13 in numbers:
            raise RuntimeError("13")
        return [ValueError(str(number)) if number % 2 else 2 * number for number in numbers]


async def asked(batcher: Batcher[int, int], work: Work, numbers: Sequence[int]) -> list[object]:
    """Ask for the first number, and for the others while it is worked on."""
    tasks = [asyncio.create_task(batcher(numbers[0]))]
    while not work.batches:
        await asyncio.sleep(0.01)
    tasks += [asyncio.create_task(batcher(number)) for number in numbers[1:]]
    await asyncio.sleep(0)
    work.go.set()
    return list(await asyncio.gather(*tasks, return_exceptions=True))


def test_what_comes_while_one_batch_is_worked_on_makes_the_next() -> None:
    work = Work()
    batcher = Batcher(work, capacity=100)
    numbers = list(range(0, 40, 2))
    assert asyncio.run(asked(batcher, work, numbers)) == [2 * number for number in numbers]
    batcher.close()
    assert [number for batch in work.batches for number in batch] == numbers
    assert len(work.batches) == 2


def test_each_gets_its_own_error_and_a_broken_batch_is_done_one_by_one() -> None:
    work = Work()
    batcher = Batcher(work, capacity=100)
    found = asyncio.run(asked(batcher, work, [2, 3, 13, 4]))
    batcher.close()
    assert [str(each) for each in found] == ["4", "3", "13", "8"]
    assert [type(each) for each in found] == [int, ValueError, RuntimeError, int]


class Pause:
    """Stands for sleep: tells for how long, and lasts until it is ended."""

    def __init__(self) -> None:
        self.seconds: list[float] = []
        self.over = threading.Event()

    def sleep(self, seconds: float) -> None:
        self.seconds.append(seconds)
        assert self.over.wait(60)


@pytest.fixture
def pause(monkeypatch: pytest.MonkeyPatch) -> Pause:
    stands_for_sleep = Pause()
    monkeypatch.setattr("service.work.batcher.time", stands_for_sleep)
    return stands_for_sleep


async def asked_within(
    batcher: Batcher[int, int], pause: Pause, numbers: Sequence[int]
) -> list[int | BaseException]:
    """Ask for the first number, and for the others while the batcher pauses for more to come."""
    tasks = [asyncio.create_task(batcher(numbers[0]))]
    while not pause.seconds:
        await asyncio.sleep(0.01)
    tasks += [asyncio.create_task(batcher(number)) for number in numbers[1:]]
    await asyncio.sleep(0)
    pause.over.set()
    return list(await asyncio.gather(*tasks, return_exceptions=True))


def test_what_comes_within_a_pause_is_of_the_same_batch(pause: Pause) -> None:
    work = Work()
    work.go.set()
    batcher = Batcher(work, capacity=100, pause=lambda: 0.25)
    numbers = list(range(0, 40, 2))
    assert asyncio.run(asked_within(batcher, pause, numbers)) == [2 * number for number in numbers]
    batcher.close()
    assert work.batches == [numbers]
    assert pause.seconds == [0.25]


def test_a_full_batch_is_not_kept_waiting_for_more(pause: Pause) -> None:
    work = Work()
    work.go.set()
    batcher = Batcher(work, capacity=3 * MOST, pause=lambda: 0.25)
    numbers = list(range(0, 2 * 2 * MOST, 2))
    assert asyncio.run(asked_within(batcher, pause, numbers)) == [2 * number for number in numbers]
    batcher.close()
    assert work.batches == [numbers[:MOST], numbers[MOST:]]
    assert pause.seconds == [0.25], "before the first, when one waited"


def test_whether_a_batch_may_grow_is_asked_before_each(pause: Pause) -> None:
    work = Work()
    seconds = iter((0.0, 0.25))
    batcher = Batcher(work, capacity=9, pause=lambda: next(seconds))
    assert asyncio.run(asked(batcher, work, [2])) == [4]
    assert pause.seconds == []
    assert asyncio.run(asked_within(batcher, pause, [6, 8])) == [12, 16]
    batcher.close()
    assert work.batches == [[2], [6, 8]]
    assert pause.seconds == [0.25]


def test_nobody_waits_without_a_place() -> None:
    work = Work()
    batcher = Batcher(work, capacity=2)

    async def crowded() -> list[object]:
        first = asyncio.create_task(batcher(0))
        while not work.batches:
            await asyncio.sleep(0.01)
        others = [asyncio.create_task(batcher(number)) for number in (2, 4, 6)]
        await asyncio.sleep(0.01)
        work.go.set()
        return list(await asyncio.gather(first, *others, return_exceptions=True))

    *served, refused = asyncio.run(crowded())
    batcher.close()
    assert served == [0, 4, 8]
    assert isinstance(refused, BusyError)


def test_who_goes_away_keeps_nobody_from_their_result() -> None:
    work = Work()
    batcher = Batcher(work, capacity=9)

    async def gone() -> int:
        first = asyncio.create_task(batcher(2))
        while not work.batches:
            await asyncio.sleep(0.01)
        second, third = asyncio.create_task(batcher(4)), asyncio.create_task(batcher(6))
        await asyncio.sleep(0.01)
        second.cancel()
        work.go.set()
        await first
        return await third

    assert asyncio.run(gone()) == 12
    batcher.close()


def test_closing_finishes_what_waits() -> None:
    work = Work()
    work.go.set()
    batcher = Batcher(work, capacity=9)
    assert asyncio.run(asked(batcher, work, [2])) == [4]
    batcher.close()
    with pytest.raises(RuntimeError):
        asyncio.run(batcher(2))
