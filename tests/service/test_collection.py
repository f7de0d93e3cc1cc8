"""Caches are not gone over again and again, and garbage in cycles goes all the same."""

from __future__ import annotations

import gc
import sys
import weakref
from collections.abc import Iterator
from types import SimpleNamespace

import pytest

from service.work.collection import FULL_AFTER, FULL_SECONDS, ROUNDS, YOUNG, Collection, new_objects_alone


class Knot:
    """Something in a cycle."""

    def __init__(self) -> None:
        self.itself = self


@pytest.fixture
def collection() -> Iterator[Collection]:
    found, thresholds, enabled = Collection(), gc.get_threshold(), gc.isenabled()
    gc.callbacks.append(found)
    yield found
    gc.callbacks.remove(found)
    if not enabled:
        gc.disable()
    gc.unfreeze()
    gc.set_threshold(*thresholds)


def aged() -> Knot:
    """Something that has outlived two collections."""
    knot = Knot()
    gc.collect(1)
    return knot


def test_what_outlives_two_collections_is_put_aside(collection: Collection) -> None:
    gc.collect(0)
    assert collection.times == 0
    before = gc.get_freeze_count()
    kept = [Knot() for _ in range(1000)]
    gc.collect(1)
    assert collection.times == 1
    assert gc.get_freeze_count() - before >= len(kept)


def test_garbage_among_it_goes_when_all_is_looked_at(
    collection: Collection, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("service.work.collection.GROWN", 0.0)
    watched = weakref.ref(aged())
    gc.collect()
    assert watched() is not None
    collection.times = FULL_AFTER
    assert collection.look_at_all()
    assert watched() is None
    assert collection.times == 0
    assert not collection.look_at_all()


def test_what_is_gone_with_its_request_does_not_make_all_be_looked_at(collection: Collection) -> None:
    """Or a caller who sends many values has all threads wait for a fifth of a second, again and again."""
    gc.enable()
    gc.set_threshold(YOUNG, ROUNDS, 1_000_000_000)
    for _ in range(2 * FULL_AFTER * ROUNDS):
        values: list[list[int]] = [[] for _ in range(2 * YOUNG)]
        del values
    assert collection.times >= FULL_AFTER
    assert not collection.look_at_all()


def test_what_stays_makes_all_be_looked_at(collection: Collection, monkeypatch: pytest.MonkeyPatch) -> None:
    held = sys.getallocatedblocks()
    for times, blocks in ((FULL_AFTER, 1.2 * held), (FULL_AFTER + 1, 2 * held)):
        monkeypatch.setattr(
            "service.work.collection.sys", SimpleNamespace(getallocatedblocks=lambda n=blocks: n)
        )
        collection.times = times
        assert not collection.look_at_all()  # the second time, because it was just seen how much is held
    collection.times = 2 * FULL_AFTER
    assert collection.look_at_all()


def test_a_quiet_process_looks_at_all_after_a_time(
    collection: Collection, monkeypatch: pytest.MonkeyPatch
) -> None:
    watched = weakref.ref(aged())
    assert not collection.look_at_all()
    monkeypatch.setattr("service.work.collection.FULL_SECONDS", -FULL_SECONDS)
    assert collection.look_at_all()
    assert watched() is None


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
