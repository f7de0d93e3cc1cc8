"""Settles regradings whose request ended before its time: its process was killed, or the database gone."""

import logging
import random
from datetime import timedelta

from courses.refusals import StorageUnavailableError
from courses.storage.database import Store
from courses.teaching.settling import settle, unsettled
from service.course_resources import now
from service.work.threads import BackgroundThread

AGAIN = 60.0  # Time from one look to the next [s].
PATIENCE = timedelta(minutes=5)  # So long a request has to itself; the largest classes take a minute or two.

_log = logging.getLogger("framewise.settling")


class Settling(BackgroundThread):
    """Brings to its end what nobody waits for any more."""

    def __init__(self, store: Store) -> None:
        super().__init__("settling")
        self._store = store

    def _run(self) -> None:
        while not self.stopping.wait(AGAIN * random.uniform(0.5, 1.5)):  # noqa: S311
            try:
                for run in unsettled(self._store, now() - PATIENCE):
                    settle(self._store, run, now())
                    _log.info("settled what a regrading has left")
            except StorageUnavailableError:
                continue
            except Exception:
                _log.exception("what a regrading has left could not be settled")
