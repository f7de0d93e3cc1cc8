"""How the threads of a server process take turns."""

from __future__ import annotations

import sys
from functools import cache

SWITCH_SECONDS = 0.001
"""Seconds for which a thread keeps the interpreter while others wait: a fifth of the default, so that the
event loop is not kept waiting by threads that judge."""


@cache
def switch_threads_often() -> None:
    """Have threads that compute give way soon; done once for the process.

    While a wrong answer is explained in a thread, the event loop waits up to this long whenever it wakes, and
    it wakes several times for every request.
    """
    sys.setswitchinterval(SWITCH_SECONDS)
