"""How the collector of cyclic garbage goes over the objects of a server process.

A process starts with two hundred thousand objects (modules, routes, schemas), and keeps some ten thousand
more (exercises, verdicts, figures). All threads wait while the collector looks at objects: for a tenth of a
second and more if it looks at all. So it looks at few at a time, thrice at each, and puts aside what is left
after that: it stands in a cache, nearly always, and goes by its reference count when the cache forgets it.
What a large body makes is put aside at once: it would look at each of its million numbers, time and again.
All are looked at again only if much more is held than the last time, and while nobody asks for anything.

The collector itself counts net new objects: what a full cache forgets counts against what it takes, and many
may be new before it looks. So new ones are looked at by the clock, too.
"""

import gc
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

YOUNG = 2_000  # Net new objects between two collections: a millisecond of work.
ROUNDS = 5
"""Collections of the youngest after which those that outlived one are looked at again: 10 000 at most."""
OLD_ROUNDS = 4
"""Collections of those after which what outlived two is looked at, and put aside: 50 000 at most, 30 ms."""
LOOK_SECONDS = 0.1
"""Time between two looks at what is new [s]: what is made in it is looked at in some milliseconds."""
LOOKS = 4
"""Looks after which what is left is put aside: what a request held meanwhile is gone, nearly always."""
GROWN = 1.25  # Times the memory held when all objects were looked at, beyond which all are looked at again.
IDLE_SECONDS = 5.0  # Least time that nobody has asked for anything before all objects are looked at [s].
IDLE_TIMES = 100.0
"""How many times as long as the last such look took nobody must have asked: then about one look in a hundred
delays a request."""
DOUBLED = 2.0  # Times the memory held at the last look, beyond which the least time is enough.
USUAL_LOOK = 0.2  # How long a look at all objects takes, as far as is known before one has been taken [s].
_OLDEST = 2
_Result = TypeVar("_Result")


class Collection:
    """Puts aside what has outlived three collections.

    Attributes:
        times: how often that was, since all objects were looked at.
    """

    def __init__(self, took: float = 0.0) -> None:
        """Begin after a look at all objects that took so long [s]."""
        self._lock = threading.Lock()
        self._large = 0
        self._looked(took)

    def _looked(self, took: float) -> None:
        self.times, self._held, self._took = 0, sys.getallocatedblocks(), took
        self._looks, self._grown = 0, 0.0

    def __call__(self, phase: str, info: dict[str, Any]) -> None:
        """Take note of a collection, as `gc.callbacks` asks for."""
        if phase == "stop" and info["generation"] == _OLDEST:
            self._put_aside()

    def _put_aside(self) -> None:
        self.times += 1
        gc.freeze()

    def large(self, work: Callable[[], _Result]) -> _Result:
        """Do work that makes large lists, and look at none of them; what is new before is looked at first."""
        gc.collect(1)
        with self._lock:
            self._large += 1
            gc.disable()
        try:
            return work()
        finally:
            with self._lock:
                self._large -= 1
                self._put_aside()
                if not self._large:
                    gc.enable()

    def look_at_new(self) -> None:
        """Look at what is new, and every fourth time put aside what is left; not beside a large body."""
        if self._large:
            return
        gc.collect(1)
        self._looks += 1
        if self._looks % LOOKS == 0:
            self._put_aside()

    def look_at_all(self, idle_seconds: float) -> bool:
        """Look at all objects if much has been put aside, and nobody waits; return whether it was so.

        What is held is counted once in a time that nobody asks: the interpreter visits all its memory for it.
        On a virtual machine that took 0.04 ms at once, and 40 to 210 ms after two seconds without a visit.

        Args:
            idle_seconds: time since anybody asked for anything [s].
        """
        if idle_seconds < IDLE_SECONDS:
            self._grown = 0.0
        elif self.times and not self._grown:
            self._grown = sys.getallocatedblocks() / self._held
        least = IDLE_SECONDS if self._grown > DOUBLED else max(IDLE_SECONDS, IDLE_TIMES * self._took)
        if idle_seconds < least or self._grown <= GROWN:
            return False
        gc.unfreeze()
        self._looked(_put_all_aside())
        return True


@contextmanager
def new_objects_alone() -> Iterator[Collection]:
    """Have the collector look at new objects alone, while an application runs; switch it on if it is off.

    What is there is put aside without a look: hardly any of it is garbage, and an application that starts is
    ready a tenth of a second sooner.
    """
    thresholds = gc.get_threshold()
    _put_aside()
    found = Collection(USUAL_LOOK)
    gc.set_threshold(YOUNG, ROUNDS, OLD_ROUNDS)
    gc.callbacks.append(found)
    gc.enable()
    try:
        yield found
    finally:
        gc.callbacks.remove(found)
        gc.set_threshold(*thresholds)
        gc.unfreeze()


def with_large_lists(work: Callable[[], _Result]) -> _Result:
    """Do work that makes large lists; while an application runs, the collector does not look at them."""
    found = next((one for one in gc.callbacks if isinstance(one, Collection)), None)
    return work() if found is None else found.large(work)


def _put_all_aside() -> float:
    """Put aside all objects that are no garbage; return how long it took [s]."""
    begun = time.perf_counter()
    gc.collect()
    _put_aside()
    return time.perf_counter() - begun


def _put_aside() -> None:
    """Put aside all objects, and show the collector that there are none.

    It looks at the oldest only when a quarter as many are new as it found the last time.
    """
    gc.freeze()
    gc.collect()
