"""Threads share the C library's heaps: what a crowd has needed at once does not stay reserved."""

from __future__ import annotations

import platform
import subprocess
import sys

import pytest

from service.work.heaps import HEAPS

_COUNTED = """
import ctypes, os, sys, tempfile, threading
from service.work.heaps import share_heaps

if sys.argv[1] == "shared":
    share_heaps()
library = ctypes.CDLL(None)
library.fopen.restype = ctypes.c_void_p
library.malloc.restype = ctypes.c_void_p
all_here = threading.Barrier(12)

def work():
    all_here.wait()
    library.malloc(5000)
    all_here.wait()

threads = [threading.Thread(target=work) for _ in range(12)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
with tempfile.TemporaryDirectory() as folder:
    told = os.path.join(folder, "told")
    file = ctypes.c_void_p(library.fopen(told.encode(), b"w"))
    library.malloc_info(0, file)
    library.fclose(file)
    print(open(told).read().count("<heap nr="))
"""


def heaps(how: str) -> int:
    """How many heaps a process has after twelve threads took memory at once."""
    run = subprocess.run([sys.executable, "-c", _COUNTED, how], capture_output=True, text=True, check=True)
    return int(run.stdout)


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="malloc_info is glibc's")
def test_threads_share_heaps() -> None:
    assert heaps("shared") <= HEAPS < heaps("alone")
