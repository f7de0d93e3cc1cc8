"""Reads the packaged exercises after the start, so that a service is ready before it has read them."""

from __future__ import annotations

from exercises.library import Library
from service.work.background import BackgroundThread


class ReadingAhead(BackgroundThread):
    """Reads each exercise once; one that is asked for before its turn is read for who asks."""

    def __init__(self, library: Library) -> None:
        super().__init__("reading-ahead")
        self._library = library

    def _run(self) -> None:
        for exercise_id in self._library.ids:
            if self.stopping.is_set():
                return
            self._library.exercise(exercise_id)
