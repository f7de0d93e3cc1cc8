"""Turns of those who write to one SQLite file: its own lock knows no order.

SQLite lets one transaction write at a time. Whoever finds the file locked looks again after pauses that grow
to a tenth of a second, and whoever looks at the right moment goes first: with many short transactions one
writer in a hundred waits for half a second, and one in a thousand for more than one, while others pass.

So writers take turns before they ask SQLite: the threads of a process among each other, and processes by two
locks beside the file. Who holds the first waits for the second; a process that has just written finds the
first one taken, so that two processes alternate however busy they are.
"""

import fcntl
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

LOOK = 0.0005
"""Pause between two looks at a lock that another process holds [s]: short beside a transaction, which takes
some milliseconds."""
_NEXT, _NOW = 0, 1  # Bytes of the file that stand for the locks: of who is next, of whose turn it is.


class TurnError(Exception):
    """A turn did not come."""


class Turns:
    """Who writes next to a file.

    The kernel takes back what a process held that was killed. Programs that know nothing of turns are kept
    out by SQLite itself.
    """

    def __init__(self, file: Path, patience: float) -> None:
        """Open the locks.

        Args:
            file: stands for the locks; made if it is not there.
            patience: how long a writer waits for its turn [s].

        Raises:
            OSError: it cannot be opened.
        """
        file.touch(mode=0o600)  # whoever could read it could keep all writers waiting
        self._path = file
        self._file = file.open("a")
        self._patience = patience
        self._threads = threading.Lock()

    @contextmanager
    def taken(self) -> Iterator[None]:
        """Wait for one's turn, and hold it.

        Raises:
            TurnError: it did not come in time, or the locks are gone.
        """
        until = time.monotonic() + self._patience
        if not self._threads.acquire(timeout=self._patience):
            raise TurnError
        try:
            self._take(until)
            try:
                yield
            finally:
                self._unlock(_NOW)
        finally:
            self._threads.release()

    def _take(self, until: float) -> None:
        try:
            if self._file.closed:
                self._file = self._path.open("a")
            self._lock(_NEXT, until)
            try:
                self._lock(_NOW, until)
            finally:
                self._unlock(_NEXT)
        except OSError as error:
            raise TurnError from error

    def close(self) -> None:
        """Close the file; whoever writes after that opens it again."""
        self._file.close()

    def _lock(self, byte: int, until: float) -> None:
        while not self._is_locked(byte):
            if time.monotonic() > until:
                raise TurnError
            time.sleep(LOOK)

    def _is_locked(self, byte: int) -> bool:
        """Try to lock; return whether it is."""
        try:
            fcntl.lockf(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, byte)
        except (BlockingIOError, PermissionError):
            return False
        return True

    def _unlock(self, byte: int) -> None:
        if not self._file.closed:  # the end of the program gave it back
            fcntl.lockf(self._file, fcntl.LOCK_UN, 1, byte)
