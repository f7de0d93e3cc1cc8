"""Answers that every process gives alike: kept in memory up to a number of bytes, and in the database.

What one process has made is written down within a second and found by all others on the same database; a
process without storage makes what it has not made itself. Nothing depends on it but time: where the database
does not answer, the answer is made again.
"""

import hashlib
import logging
import threading

from sqlalchemy.exc import SQLAlchemyError

from courses.refusals import StorageUnavailableError
from courses.storage.database import Store
from courses.storage.prepared_answers import keep_prepared, prepared
from service.course_resources import now
from service.wire.answer_cache import AnswerCache
from service.work.threads import BackgroundThread

PAUSE = 1.0  # So long new answers are gathered before they are written down [s]: they share a transaction.
WAITING_BYTES = 8 * 1024 * 1024
"""What waits to be written down; beyond it an answer stays in its own process."""

_log = logging.getLogger("framewise.answers")


def address_of(kind: str, *origins: str | bytes) -> str:
    """Return the address of an answer of a kind that follows from some texts: their digest."""
    digest = hashlib.sha256(kind.encode())
    for origin in origins:
        data = origin.encode() if isinstance(origin, str) else origin
        digest.update(b"%d:" % len(data) + data)
    return digest.hexdigest()[:40]


class SharedAnswers(BackgroundThread):
    """The answers of one kind."""

    def __init__(self, kind: str, store: Store | None) -> None:
        super().__init__(f"shared-{kind}")
        self.kind, self._store = kind, store
        self._cache = AnswerCache()
        self._waiting: dict[str, bytes] = {}
        self._waiting_bytes = 0
        self._lock = threading.Lock()

    def address(self, *origins: str | bytes) -> str:
        """Return the address of what follows from some texts: their digest."""
        return address_of(self.kind, *origins)

    def known(self, address: str) -> bytes | None:
        """Return what this process has in memory."""
        with self._lock:
            return self._cache.get(address.encode())

    def stored(self, address: str) -> bytes | None:
        """Return what some process has written down; None where there is none, or no database."""
        if self._store is None:
            return None
        try:
            found = prepared(self._store, address)
        except (StorageUnavailableError, SQLAlchemyError):
            return None
        if found is not None:
            with self._lock:
                self._cache.put(address.encode(), found)
        return found

    def remember(self, address: str, answer: bytes) -> None:
        """Cache an answer in memory alone: it is quickly made again from others."""
        with self._lock:
            self._cache.put(address.encode(), answer)

    def keep(self, address: str, answer: bytes) -> None:
        """Cache an answer in memory, and have it stored."""
        with self._lock:
            self._cache.put(address.encode(), answer)
            if self._store is None or address in self._waiting:
                return
            if self._waiting_bytes + len(answer) <= WAITING_BYTES:
                self._waiting[address] = answer
                self._waiting_bytes += len(answer)

    def write_down(self) -> None:
        """Store the pending answers."""
        with self._lock:
            waiting, self._waiting = self._waiting, {}
            self._waiting_bytes = 0
        if self._store is None or not waiting:
            return
        try:
            keep_prepared(self._store, waiting, now())
        except StorageUnavailableError:
            return
        except SQLAlchemyError:
            _log.exception("what was made could not be written down for the other processes")

    def _run(self) -> None:
        while not self.stopping.wait(PAUSE):
            self.write_down()
        self.write_down()
