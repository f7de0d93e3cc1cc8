"""What callers have cost in the last minute, by two counts for each: of this minute and of the one before.

The minute before counts as far as the sliding minute still reaches into it. Time is monotonic: a clock that
is set forward frees nobody, and one that is set back holds nobody up.
"""

import math
import time
from collections import OrderedDict
from collections.abc import Hashable
from typing import NamedTuple

MINUTE = 60.0
CALLERS = 16_384  # Callers whose cost is stored; the one that called longest ago is dropped first.


class Charged(NamedTuple):
    """What came of a call: whether it was allowed, what is left, and how long until as much is free [s]."""

    allowed: bool
    left: int
    wait: float


class CostWindow:
    """Counts cost."""

    def __init__(self) -> None:
        self._counts: OrderedDict[Hashable, tuple[int, int, int]] = OrderedDict()

    def charge(self, caller: Hashable, cost: int, most: int) -> Charged:
        """Count a call, unless it would cost more than is left of `most` in a minute."""
        minute, passed = divmod(time.monotonic() / MINUTE, 1.0)
        began, current, before = self._counts.get(caller, (int(minute), 0, 0))
        if began != int(minute):
            current, before = 0, current if began == int(minute) - 1 else 0
        used = before * (1.0 - passed) + current
        allowed = used + cost <= most
        current += cost if allowed else 0
        self._counts[caller] = int(minute), current, before
        self._counts.move_to_end(caller)
        while len(self._counts) > CALLERS:
            self._counts.popitem(last=False)
        left = math.floor(most - used - (cost if allowed else 0))
        return Charged(allowed, max(0, left), _wait(before, current, passed, most - cost))


def _wait(before: int, current: int, passed: float, free: int) -> float:
    """Seconds until no more than `free` is used, if nothing is used until then."""
    if before * (1.0 - passed) + current <= free:
        return 0.0
    if current <= free:  # what is left of the minute before has to fade
        return MINUTE * (1.0 - (free - current) / before - passed)
    return MINUTE * (1.0 - passed + 1.0 - free / current)
