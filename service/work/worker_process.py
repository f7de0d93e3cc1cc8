"""The program of a worker process: does one task after another, until its parent is gone.

A task is a pickled function with its arguments, and comes from the parent alone. The process ends itself by
the kernel's hand (SIGPROF) when a task takes more processor time than it may, wherever it is at that
moment; time that other programs take does not count.
"""

import gc
import importlib
import os
import pickle
import resource
import signal
import sys
from enum import StrEnum
from multiprocessing.connection import Connection
from typing import Any

PRELOADED = (
    "kinematics.inverse",
    "kinematics.workspace",
    "service.wire.kinematics.chain_forms",
    "service.wire.kinematics.symbolic_forms",
)
"""What nearly every task needs: imported before the first one comes."""


class WorkOutcome(StrEnum):
    """How a task ended."""

    RESULT = "result"
    ERROR = "error"
    OUT_OF_MEMORY = "out_of_memory"


def main() -> None:
    """Serve the parent.

    The command line says: descriptor of the connection, largest address space [byte], niceness, processor
    time of a task [s].
    """
    descriptor, memory, niceness, seconds = sys.argv[1:]
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's business
    os.nice(int(niceness))
    for name in PRELOADED:
        importlib.import_module(name)
    gc.freeze()  # what was imported stays: it need not be looked through
    _bound_memory(int(memory))
    with Connection(int(descriptor)) as connection:
        while True:
            try:
                task = connection.recv_bytes()
            except (EOFError, ConnectionError):
                return
            signal.setitimer(signal.ITIMER_PROF, float(seconds))
            reply = _done(task)
            signal.setitimer(signal.ITIMER_PROF, 0.0)
            connection.send_bytes(reply)


def _bound_memory(memory: int) -> None:
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    limit = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))


def _done(task: bytes) -> bytes:
    """The pickled outcome of a task and what belongs to it."""
    try:
        function, arguments = pickle.loads(task)  # noqa: S301  from the parent
        return _pickled(WorkOutcome.RESULT, function(*arguments))
    except MemoryError:
        return _pickled(WorkOutcome.OUT_OF_MEMORY, None)
    except Exception as error:
        try:
            return _pickled(WorkOutcome.ERROR, error)
        except Exception:
            return _pickled(WorkOutcome.ERROR, RuntimeError(repr(error)))


def _pickled(outcome: WorkOutcome, value: Any) -> bytes:
    return pickle.dumps((outcome.value, value), pickle.HIGHEST_PROTOCOL)


if __name__ == "__main__":
    main()
