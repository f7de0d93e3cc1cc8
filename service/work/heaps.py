"""How the threads of a server process share memory, and take turns."""

import ctypes
import sys
from contextlib import suppress
from functools import cache

HEAPS = 2
"""Heaps of the C library that all threads take turns at. It would give each thread its own (up to eight for a
core), in each of which some of the largest bodies and answers ever read stay reserved."""
LARGE = 256 * 1024
"""Blocks from this size on [byte] are given back to the system when they are freed. The C library raises this
bound by itself, to as much as 32 MiB."""
SPARE = 1024 * 1024
"""What may stay free at the end of a heap [byte]: four times what compressing an answer takes, which would be
given back and asked for again with every page."""
_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8  # names of glibc's malloc.h


@cache
def share_heaps() -> None:
    """Give back what has been freed, once for the process; other C libraries than glibc are left alone."""
    with suppress(AttributeError, OSError):
        library = ctypes.CDLL(None)
        for option, value in ((_ARENA_MAX, HEAPS), (_MMAP_THRESHOLD, LARGE), (_TRIM_THRESHOLD, SPARE)):
            library.mallopt(option, value)


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
