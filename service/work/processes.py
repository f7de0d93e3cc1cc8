"""How worker processes are made."""

from __future__ import annotations

import sys
import tempfile
import threading
import types
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from multiprocessing import popen_forkserver, popen_spawn_posix
from multiprocessing.context import (
    BaseContext,
    ForkServerContext,
    ForkServerProcess,
    SpawnContext,
    SpawnProcess,
)
from multiprocessing.process import BaseProcess
from typing import Any

PRELOADED = ("service.wire.symbolic_forms",)
"""What tasks need; imported once, by the process that the workers are forked from."""

_LOCK = threading.Lock()


def process_context() -> BaseContext:
    """How processes are made: from a server that has imported what tasks need, or each anew.

    The server listens on a socket in the folder for temporary files, which a container may not have. Neither
    way imports the program's main module, as multiprocessing usually does: it may be a script that does not
    expect to be run twice, or no file at all.
    """
    with suppress(FileNotFoundError):
        tempfile.gettempdir()
        context = _ForkServerContext()
        context.set_forkserver_preload(list(PRELOADED))
        return context
    return _SpawnContext()


@contextmanager
def _without_main() -> Iterator[None]:
    with _LOCK:
        main = sys.modules["__main__"]
        sys.modules["__main__"] = types.ModuleType("__main__")
        try:
            yield
        finally:
            sys.modules["__main__"] = main


class _ForkServerPopen(popen_forkserver.Popen):
    def _launch(self, process_obj: Any) -> None:
        with _without_main():
            super()._launch(process_obj)  # type: ignore[misc]


class _SpawnPopen(popen_spawn_posix.Popen):
    def _launch(self, process_obj: Any) -> None:
        with _without_main():
            super()._launch(process_obj)  # type: ignore[misc]


class _ForkServerProcess(ForkServerProcess):
    @staticmethod
    def _Popen(process_obj: BaseProcess) -> Any:
        return _ForkServerPopen(process_obj)


class _SpawnProcess(SpawnProcess):
    @staticmethod
    def _Popen(process_obj: BaseProcess) -> Any:
        return _SpawnPopen(process_obj)


class _ForkServerContext(ForkServerContext):
    Process = _ForkServerProcess


class _SpawnContext(SpawnContext):
    Process = _SpawnProcess
