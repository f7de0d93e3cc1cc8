"""Removes what has been kept long enough: once a day, by one thread of each process.

Several processes do it at the same time without harm: what one has removed the other does not find.
"""

from __future__ import annotations

import logging
import random
import threading
from datetime import timedelta

from sqlalchemy.exc import SQLAlchemyError

from courses.privacy import purge
from courses.refusals import StorageUnavailableError
from courses.storage import Store
from service.course_resources import now

FIRST = 600.0
"""So long after the start the first look is taken [s]: a process that restarts often still takes it."""
DAY = 86400.0

_log = logging.getLogger("framewise.retention")


class Retention:
    """The end of what is old."""

    def __init__(self, store: Store, *, people: timedelta, log: timedelta, first: float = FIRST) -> None:
        self._store = store
        self._people = people
        self._log = log
        self._first = first
        self._stop = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """Begin to look."""
        self._thread = threading.Thread(target=self._run, name="retention", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Finish what is being removed, and end."""
        self._stop.set()
        if self._thread is not None:
            self._thread.join(timeout=30.0)

    def _run(self) -> None:
        pause = self._first * random.uniform(0.5, 1.5)  # noqa: S311
        while not self._stop.wait(pause):
            pause = DAY
            try:
                removed = purge(self._store, now(), people=self._people, log=self._log)
            except StorageUnavailableError:
                pause = self._first
                continue
            except SQLAlchemyError:
                _log.exception("what is old could not be removed")
                continue
            if any(removed.values()):
                told = ", ".join(f"{count} {what}" for what, count in removed.items())
                _log.info("removed what was kept long enough: %s", told)
