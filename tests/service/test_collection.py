"""Caches are not gone over again and again, and garbage in cycles goes all the same."""

import gc
import sys
import time
import weakref
from collections import deque
from collections.abc import Iterator
from types import SimpleNamespace

import pytest

from service.metrics import Metrics
from service.work.collection import (
    IDLE_SECONDS,
    LOOKS,
    OLD_ROUNDS,
    ROUNDS,
    YOUNG,
    Collection,
    new_objects_alone,
    with_large_lists,
)

LONG = 1e6
"""Time since anybody asked that is longer than any look takes a hundred times [s]."""


class Knot:
    """Something in a cycle."""

    def __init__(self) -> None:
        self.itself = self


@pytest.fixture
def alone(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Have applications that other tests left running look at nothing meanwhile."""
    others = [one for one in gc.callbacks if isinstance(one, Collection)]
    for other in others:
        gc.callbacks.remove(other)
        monkeypatch.setattr(other, "look_at_new", lambda: None)
        monkeypatch.setattr(other, "look_at_all", lambda _: False)
    yield
    gc.callbacks.extend(others)


@pytest.fixture
def collection(alone: None) -> Iterator[Collection]:
    enabled = gc.isenabled()
    with new_objects_alone() as found:
        yield found
    if not enabled:
        gc.disable()


def aged() -> Knot:
    """Something that has outlived three collections."""
    knot = Knot()
    gc.collect()
    return knot


@pytest.fixture
def looks() -> Iterator[list[tuple[int, int]]]:
    """The generation of each collection, with how many objects it looked at."""
    found: list[tuple[int, int]] = []

    def note(phase: str, info: dict[str, int]) -> None:
        if phase == "start":
            oldest = info["generation"]
            found.append((oldest, sum(len(gc.get_objects(age)) for age in range(oldest + 1))))

    gc.callbacks.insert(0, note)
    yield found
    gc.callbacks.remove(note)


def test_what_outlives_the_collections_is_put_aside(collection: Collection) -> None:
    gc.collect(1)
    assert collection.times == 0
    before = gc.get_freeze_count()
    kept = [Knot() for _ in range(1000)]
    gc.collect()
    assert collection.times == 1
    assert gc.get_freeze_count() - before >= len(kept)


def test_a_start_looks_at_no_object(looks: list[tuple[int, int]]) -> None:
    """There are two hundred thousand, and hardly any is garbage."""
    with new_objects_alone():
        pass
    assert looks
    assert max(seen for _, seen in looks) < YOUNG


def test_no_collection_looks_at_many_objects(collection: Collection, looks: list[tuple[int, int]]) -> None:
    """However many are held: what a process started with, caches that fill, and what is under way."""
    kept: list[Knot] = []
    under_way: list[Knot] = []
    for _ in range(300_000):
        kept.append(Knot())
        under_way = [*under_way[-500:], Knot()]
    assert len(kept) == 300_000
    assert {generation for generation, _ in looks} == {0, 1, 2}
    assert max(seen for _, seen in looks) <= 1.1 * YOUNG * (ROUNDS + 1) * (OLD_ROUNDS + 1)


def test_what_a_full_cache_takes_is_looked_at_a_little_at_a_time(
    collection: Collection, looks: list[tuple[int, int]]
) -> None:
    """Each new object comes with the end of an old one, so that the collector itself sees nothing new."""
    kept: deque[list[object]] = deque(([object()] for _ in range(50_000)), maxlen=50_000)
    gc.collect()
    looks.clear()
    before = gc.get_freeze_count()
    made = 1_000
    for number in range(50_000):
        kept.append([object()])
        if number % made == 0:
            collection.look_at_new()
    assert len(looks) >= 50
    assert max(seen for _, seen in looks) <= 1.5 * LOOKS * made
    assert gc.get_freeze_count() >= before - 2 * LOOKS * made


def test_garbage_that_outlives_two_collections_goes(collection: Collection) -> None:
    """As of a request that was under way meanwhile."""
    knot = Knot()
    watched = weakref.ref(knot)
    gc.collect(1)
    del knot
    gc.collect(1)
    assert watched() is not None
    for _ in range(2 * OLD_ROUNDS):
        gc.collect(1)
    kept = [Knot() for _ in range(2 * YOUNG * ROUNDS * OLD_ROUNDS)]
    assert collection.times > 0
    assert watched() is None
    del kept


def test_garbage_that_was_put_aside_goes_when_all_is_looked_at(
    collection: Collection, monkeypatch: pytest.MonkeyPatch
) -> None:
    watched = weakref.ref(aged())
    gc.collect()
    assert watched() is not None
    assert not collection.look_at_all(LONG)
    monkeypatch.setattr("service.work.collection.GROWN", 0.0)
    assert not collection.look_at_all(0.0)  # somebody would wait
    assert watched() is not None
    assert collection.look_at_all(LONG)
    assert watched() is None
    assert collection.times == 0
    assert not collection.look_at_all(LONG)


def test_what_a_large_body_makes_is_not_looked_at(
    collection: Collection, looks: list[tuple[int, int]]
) -> None:
    """A list of a million numbers was gone over for 20 ms, time and again while the request lasted."""
    made = with_large_lists(lambda: [[number] for number in range(300_000)])
    assert [generation for generation, _ in looks] == [1]
    later = [[number] for number in range(YOUNG * ROUNDS)]
    assert gc.is_tracked(made)
    assert not any(one is made for age in range(3) for one in gc.get_objects(age))
    assert max(seen for _, seen in looks) < 2 * YOUNG * ROUNDS
    assert collection.times > 0
    assert len(later) == YOUNG * ROUNDS


def test_garbage_is_not_put_aside_with_what_a_large_body_makes(collection: Collection) -> None:
    watched = weakref.ref(Knot())
    with_large_lists(list)
    assert watched() is None


def test_the_collector_rests_until_the_last_of_several_large_bodies_is_read(collection: Collection) -> None:
    def outer() -> None:
        with pytest.raises(ZeroDivisionError):
            with_large_lists(lambda: 1 / 0)
        assert not gc.isenabled()

    with_large_lists(outer)
    assert gc.isenabled()


def test_what_a_large_body_makes_is_not_looked_at_by_the_clock_either(
    collection: Collection, looks: list[tuple[int, int]]
) -> None:
    with_large_lists(lambda: collection.look_at_new())
    assert len(looks) == 1  # before it
    collection.look_at_new()
    assert len(looks) == 2


def test_outside_of_an_application_nothing_is_put_aside(alone: None) -> None:
    before = gc.get_freeze_count()
    assert with_large_lists(lambda: [[], []]) == [[], []]
    assert gc.get_freeze_count() <= before  # what earlier tests put aside may end meanwhile


def test_what_is_gone_with_its_request_does_not_make_all_be_looked_at(collection: Collection) -> None:
    for _ in range(2 * OLD_ROUNDS * ROUNDS):
        values: list[list[int]] = [[] for _ in range(2 * YOUNG)]
        del values
    gc.collect()
    assert not collection.look_at_all(LONG)


def test_what_stays_makes_all_be_looked_at(collection: Collection, monkeypatch: pytest.MonkeyPatch) -> None:
    held = sys.getallocatedblocks()
    gc.collect()
    for blocks, is_due in ((1.2 * held, False), (1.4 * held, True)):
        monkeypatch.setattr(
            "service.work.collection.sys", SimpleNamespace(getallocatedblocks=lambda n=blocks: n)
        )
        assert not collection.look_at_all(0.0)  # somebody has asked meanwhile
        assert collection.look_at_all(LONG) == is_due


def test_what_is_held_is_counted_once_while_nobody_asks(
    collection: Collection, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Counting visits all memory: on a virtual machine it took up to 0.2 s after two seconds without."""
    counts = 0
    held = sys.getallocatedblocks()

    def counted() -> int:
        nonlocal counts
        counts += 1
        return held

    gc.collect()
    monkeypatch.setattr("service.work.collection.sys", SimpleNamespace(getallocatedblocks=counted))
    for idle, expected in ((0.0, 0), (4.0, 0), (6.0, 1), (8.0, 1), (LONG, 1), (0.0, 1), (6.0, 2)):
        assert not collection.look_at_all(idle)
        assert counts == expected


@pytest.mark.parametrize(
    ("took", "grown", "idle", "is_due"),
    [
        (0.4, 1.4, IDLE_SECONDS, False),
        (0.4, 1.4, 39.0, False),
        (0.4, 1.4, 41.0, True),
        (0.4, 2.1, IDLE_SECONDS, True),
        (0.4, 2.1, 4.0, False),
        (0.01, 1.4, IDLE_SECONDS, True),
    ],
)
def test_a_long_look_waits_until_hardly_anybody_is_likely_to_ask_meanwhile(
    took: float, grown: float, idle: float, is_due: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    blocks = 1000

    def held() -> int:
        return blocks

    monkeypatch.setattr("service.work.collection.sys", SimpleNamespace(getallocatedblocks=held))
    monkeypatch.setattr("service.work.collection._put_all_aside", lambda: took)
    collection = Collection(took)
    collection.times, blocks = 1, int(1000 * grown)
    assert collection.look_at_all(idle) == is_due


def test_a_process_is_idle_when_nobody_asks_and_nothing_runs() -> None:
    running = {"grading": (0, 0)}
    metrics = Metrics(lambda: running, None)
    before = metrics.idle_seconds
    time.sleep(0.001)
    assert metrics.idle_seconds > before
    running["grading"] = (1, 0)
    assert metrics.idle_seconds == 0.0


def test_an_application_leaves_the_collector_as_it_found_it() -> None:
    before = gc.get_threshold()
    gc.disable()  # as while the application is loaded
    with new_objects_alone() as found:
        assert gc.isenabled()
        assert found in gc.callbacks
        assert gc.get_threshold()[0] == YOUNG
        assert gc.get_freeze_count() > 0
    assert found not in gc.callbacks
    assert gc.get_threshold() == before
