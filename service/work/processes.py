"""A worker process, as its parent sees it."""

import multiprocessing
import os
import signal
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]
_ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
"""Matrices are small here: threads of the linear algebra would only spin."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Confinement:
    """What a worker process may take.

    Attributes:
        memory: address space [byte].
        seconds: processor time of a task [s].
        niceness: how far it stands back behind other processes.
    """

    memory: int
    seconds: float
    niceness: int


class ProcessDiedError(Exception):
    """The process ended before its answer came."""

    def __init__(self, status: int) -> None:
        super().__init__(f"exit status {status}")
        self.ran_out_of_time = status == -signal.SIGPROF


class UnansweredError(Exception):
    """The process has neither answered nor used up its processor time: this machine is overloaded."""


class WorkerProcess:
    """A process that does one task at a time; while it waits for the first, it imports what tasks need."""

    def __init__(self, confinement: Confinement) -> None:
        self._connection, theirs = multiprocessing.Pipe()
        number = theirs.fileno()
        options = (number, confinement.memory, confinement.niceness, confinement.seconds)
        path = [str(_ROOT), *(entry or os.getcwd() for entry in sys.path)]
        with theirs:
            self._process = subprocess.Popen(  # noqa: S603  this program, with numbers
                [sys.executable, "-P", "-m", "service.work.worker_process", *map(str, options)],
                pass_fds=[number],
                stdin=subprocess.DEVNULL,
                env={**os.environ, **_ONE_THREAD, "PYTHONPATH": os.pathsep.join(path)},
            )

    @property
    def identifier(self) -> int:
        """Return its process id."""
        return self._process.pid

    @property
    def is_alive(self) -> bool:
        """Return whether it is running."""
        return self._process.poll() is None

    def perform(self, task: bytes, timeout: float) -> bytes:
        """Send a task, and wait for its reply.

        Raises:
            ProcessDiedError: the process ended, of itself or by somebody's hand.
            UnansweredError: nothing came for so many seconds.
        """
        try:
            self._connection.send_bytes(task)
            if not self._connection.poll(timeout):
                raise UnansweredError
            return self._connection.recv_bytes()
        except (EOFError, OSError):
            self.kill()
            raise ProcessDiedError(self._process.returncode) from None

    def kill(self) -> None:
        """End the process, whatever it is doing."""
        with suppress(ProcessLookupError):
            self._process.kill()
        self._process.wait()

    def close(self) -> None:
        """End the process, and let go of it; no other thread may be in `perform`."""
        self.kill()
        self._connection.close()
