"""Threads share the C library's heaps: what a crowd has needed at once does not stay reserved."""

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


_COMPRESSED = """
import gzip, resource
from service.work.heaps import share_heaps

share_heaps()
page = bytes(range(256)) * 40
before = 0
for round in range(220):
    if round == 20:
        before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    gzip.compress(page, 3, mtime=0)
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""
_glibc = pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="glibc's settings")


def heaps(how: str) -> int:
    """How many heaps a process has after twelve threads took memory at once."""
    run = subprocess.run([sys.executable, "-c", _COUNTED, how], capture_output=True, text=True, check=True)
    return int(run.stdout)


@_glibc
def test_threads_share_heaps() -> None:
    assert heaps("shared") <= HEAPS < heaps("alone")


@_glibc
def test_what_compresses_pages_is_not_given_back_in_between() -> None:
    run = subprocess.run([sys.executable, "-c", _COMPRESSED], capture_output=True, text=True, check=True)
    assert int(run.stdout) < 200, "page faults of 200 pages"
