"""Removes what has been kept long enough: once a day, by one thread of each process.

Several processes do it at the same time without harm: what one has removed the other does not find.
"""

import logging
import random
from datetime import timedelta

from courses.people.privacy import purge
from courses.refusals import StorageUnavailableError
from courses.storage.database import Store
from service.course_resources import now
from service.work.threads import BackgroundThread

FIRST = 600.0
"""So long after the start the first look is taken [s]: a process that restarts often still takes it."""
DAY = 86400.0

_log = logging.getLogger("framewise.retention")


class Retention(BackgroundThread):
    """The end of what is old."""

    def __init__(self, store: Store, *, people: timedelta, log: timedelta, first: float = FIRST) -> None:
        super().__init__("retention")
        self._store, self._people, self._log, self._first = store, people, log, first

    def _run(self) -> None:
        pause = self._first * random.uniform(0.5, 1.5)  # noqa: S311
        while not self.stopping.wait(pause):
            pause = DAY
            try:
                removed = purge(self._store, now(), people=self._people, log=self._log)
            except StorageUnavailableError:
                pause = self._first
                continue
            except Exception:
                _log.exception("what is old could not be removed")
                continue
            if any(removed.values()):
                told = ", ".join(f"{count} {what}" for what, count in removed.items())
                _log.info("removed what was kept long enough: %s", told)
