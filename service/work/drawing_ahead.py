"""Reads the packaged exercises, and draws what the students of links will be shown, while nobody waits.

The students of a class open an exercise at the same moment, each with values of their own; the values that
there may be are known from the day on which the link was made. Each process draws in an order of its own, and
takes from the database what another one has drawn.
"""

import logging
import random
import time
from collections.abc import Callable, Iterator

from courses.links.course_links import newest_links
from courses.refusals import StorageUnavailableError
from courses.storage.database import Store
from exercises.definition import Exercise
from exercises.errors import ExerciseError
from exercises.instance import Instance, possible_instances
from exercises.library import Library
from exercises.parts.mistakes.frame_mistake import FrameMistakeType
from kinematics.errors import KinematicsError
from service.course_resources import now
from service.messages import languages
from service.wire.exercises.figure_files import draw_ahead
from service.work.shared_answers import SharedAnswers
from service.work.threads import BackgroundThread

FIRST = 1.0  # Time from the start to the first look at the links [s].
AGAIN = 60.0  # Time from one look to the next [s]: a link is made longer before its class comes.
LINKS = 200  # Links that are looked at, the newest.
MOST = 1000
"""Sets of values of an exercise that are drawn ahead: where there are more, hardly two students share one."""
BUSY = 0.05  # Time that others are left to themselves before it is looked whether somebody waits [s].

_log = logging.getLogger("framewise.drawing")


class DrawingAhead(BackgroundThread):
    """Draws ahead, half of the time at the most."""

    def __init__(
        self, store: Store, library: Library, figures: SharedAnswers, is_busy: Callable[[], bool]
    ) -> None:
        """Make the thread."""
        super().__init__("drawing-ahead")
        self._store, self._library, self._figures, self._is_busy = store, library, figures, is_busy
        self._done: set[tuple[Exercise, str]] = set()

    def _run(self) -> None:
        pause = FIRST
        while not self.stopping.wait(pause):
            pause = AGAIN
            try:
                self.draw_all()
            except StorageUnavailableError:
                continue
            except Exception:
                _log.exception("nothing more is drawn ahead")
                return

    def draw_all(self) -> None:
        """Draw what the links ask for and nobody has drawn."""
        asked = list(dict.fromkeys(self._asked()))
        for exercise, language in asked:
            if (exercise, language) not in self._done and self._draw(exercise, language):
                self._done.add((exercise, language))
        self._done.intersection_update(asked)

    def _asked(self) -> Iterator[tuple[Exercise, str]]:
        """The exercises that students have values of their own of, with the languages of their pages."""
        for settings in newest_links(self._store, LINKS):
            closes = settings.policy.closes
            ended = closes is not None and closes < now()
            if ended or not settings.per_student or settings.exercise_id is None:
                continue
            try:
                exercise = self._library.exercise(settings.exercise_id)
            except ExerciseError:
                continue
            if exercise.part(FrameMistakeType.kind) is None:  # frames are drawn as well, others for each
                spoken = languages() if settings.language is None else (settings.language,)
                yield from ((exercise, each) for each in spoken)

    def _draw(self, exercise: Exercise, language: str) -> bool:
        """Draw an exercise with all sets of values; return whether it came to the end."""
        instances = list(possible_instances(exercise, exercise.figure.lengths, MOST))
        random.shuffle(instances)  # every process in an order of its own
        for instance in instances:
            begun = time.monotonic()
            if self._drawn(instance, language) and self.stopping.wait(time.monotonic() - begun):
                return False
            while self._is_busy():
                if self.stopping.wait(BUSY):
                    return False
        return True

    def _drawn(self, instance: Instance, language: str) -> bool:
        try:
            return draw_ahead(self._figures, instance, language)
        except (ExerciseError, KinematicsError):  # whoever asks for it is told
            return False


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
