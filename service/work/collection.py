"""How the collector of cyclic garbage goes over the objects of a server process.

What a process keeps (modules, exercises, instances, verdicts, figures) grows to hundreds of thousands of
objects, and a full collection looks at each of them while all threads wait: a tenth of a second and more.
What has outlived two collections stands in a cache, nearly always, and goes by its reference count when the
cache forgets it. It is put aside at once, and looked at again once in a while if more is held by then: what a
request of many values holds is put aside as well, and gone with its answer.
"""

from __future__ import annotations

import gc
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

YOUNG = 2_000
"""Net new objects between two collections: a millisecond of work."""
ROUNDS = 5
"""Collections of the youngest after which those that outlived one are looked at, and put aside."""
FULL_AFTER = 100
"""Times that objects were put aside until it is seen how much is held: at most a million new objects."""
GROWN = 1.25
"""Times the memory held when all objects were looked at, beyond which all are looked at again."""
FULL_SECONDS = 600.0
"""Time after which all objects are looked at again if any were put aside [s]."""
_NEVER = 1_000_000_000
"""Collections after which all objects would be looked at unasked: more than a process lives to see."""


class Collection:
    """Puts aside what has outlived two collections.

    Attributes:
        times: how often that was, since all objects were looked at.
    """

    def __init__(self) -> None:
        self._looked()

    def _looked(self) -> None:
        self.times, self._due = 0, FULL_AFTER
        self._since, self._held = time.monotonic(), sys.getallocatedblocks()

    def __call__(self, phase: str, info: dict[str, Any]) -> None:
        """Take note of a collection, as `gc.callbacks` asks for."""
        if phase == "stop" and info["generation"] > 0:
            self.times += 1
            gc.freeze()

    def look_at_all(self) -> bool:
        """Look at all objects, if it is time to; return whether it was."""
        if not (self._is_late() or self._has_grown()):
            return False
        gc.unfreeze()
        gc.collect()
        gc.freeze()
        self._looked()
        return True

    def _is_late(self) -> bool:
        return self.times > 0 and time.monotonic() - self._since > FULL_SECONDS

    def _has_grown(self) -> bool:
        if self.times < self._due:
            return False
        self._due = self.times + FULL_AFTER
        return sys.getallocatedblocks() > GROWN * self._held


@contextmanager
def new_objects_alone() -> Iterator[Collection]:
    """Have the collector look at new objects alone, while an application runs; switch it on if it is off."""
    found, thresholds = Collection(), gc.get_threshold()
    if not gc.get_freeze_count():
        gc.collect()
    gc.freeze()
    gc.set_threshold(YOUNG, ROUNDS, _NEVER)
    gc.callbacks.append(found)
    gc.enable()
    try:
        yield found
    finally:
        gc.callbacks.remove(found)
        gc.set_threshold(*thresholds)
        gc.unfreeze()
