"""Judging stored attempts again in several processes, each answer once."""

import os
import pickle
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import lru_cache
from queue import SimpleQueue

from courses.model import Attempt, LinkSettings
from courses.teaching.regrading import Rejudged
from exercises.library import Library
from kinematics.cells import Limits
from service.settings import Settings
from service.work.processes import Confinement, ProcessDiedError, UnansweredError, WorkerProcess
from service.work.session_grading import UNREAD, Grader
from service.work.worker_process import WorkOutcome

CHUNK = 8  # Answers that travel to a process together, as when a class is graded from files.
FEW = 32  # So few answers are judged here before a process would have started.
CACHED_ANSWERS = 4096
"""Answers that are known again when another student hands in the same; one takes a few kilobytes."""
NICENESS = 10  # Students who hand in meanwhile come first.
PATIENCE = 300.0  # A process that has not answered for so long [s] is given up; its answers are judged here.


class RegradingProcesses:
    """Judges batches by the exercises as they are now; processes start with the first large batch.

    Args:
        grader: what judges here, and where an exercise stands in no folder.
        asked: what the link asks.
        settings: of the service: what a process may take.
    """

    def __init__(self, grader: Grader, asked: LinkSettings, settings: Settings) -> None:
        self._grader, self._asked, self._settings = grader, asked, settings
        self._known: dict[object, Rejudged] = {}
        self._idle: SimpleQueue[WorkerProcess] = SimpleQueue()
        self._processes: list[WorkerProcess] = []
        self._threads: ThreadPoolExecutor | None = None

    def __enter__(self) -> "RegradingProcesses":
        return self

    def __exit__(self, *_: object) -> None:
        if self._threads is not None:
            self._threads.shutdown()
        for process in self._processes:
            process.close()

    def __call__(self, batch: Sequence[Attempt]) -> list[Rejudged]:
        """Return what the attempts of a batch are worth now, in their order."""
        keys = [self._grader.question(attempt, self._asked) for attempt in batch]
        new = {key: attempt for key, attempt in zip(keys, batch, strict=True) if key not in self._known}
        new.pop(None, None)
        found = {None: UNREAD, **self._known}
        found.update(zip(new, self._judged(list(new.values())), strict=True))
        self._known = dict(list(found.items())[-CACHED_ANSWERS:])
        return [replace(found[key], attempt_id=attempt.id) for key, attempt in zip(keys, batch, strict=True)]

    def _judged(self, attempts: Sequence[Attempt]) -> list[Rejudged]:
        files = self._grader.library.files
        if len(attempts) <= FEW or any(files(attempt.exercise_id) is None for attempt in attempts):
            return self._grader.rejudge(attempts, self._asked)
        chunks = [attempts[i : i + CHUNK] for i in range(0, len(attempts), CHUNK)]
        return [item for found in self._started().map(self._elsewhere, chunks) for item in found]

    def _started(self) -> ThreadPoolExecutor:
        if self._threads is None:
            count = os.cpu_count() or 1
            settings = self._settings
            confinement = Confinement(
                memory=settings.symbolic_memory, seconds=settings.symbolic_seconds, niceness=NICENESS
            )
            self._threads = ThreadPoolExecutor(count, thread_name_prefix="regrading")
            self._processes = [WorkerProcess(confinement) for _ in range(count)]
            for process in self._processes:
                self._idle.put(process)
        return self._threads

    def _elsewhere(self, attempts: Sequence[Attempt]) -> list[Rejudged]:
        """Judge a chunk in a process, by exercises as they were read here; here, where it cannot."""
        ids = {attempt.exercise_id for attempt in attempts}
        files = {name: dict(self._grader.library.files(name) or {}) for name in ids}
        task = (_judged_there, (files, self._grader.limits, self._asked, tuple(attempts)))
        process = self._idle.get()
        try:
            reply = process.perform(pickle.dumps(task, pickle.HIGHEST_PROTOCOL), PATIENCE)
            outcome, value = pickle.loads(reply)  # noqa: S301  from our own process
        except (ProcessDiedError, UnansweredError):
            outcome, value = WorkOutcome.OUT_OF_MEMORY, None
        finally:
            self._idle.put(process)
        if outcome == WorkOutcome.RESULT:
            judged: list[Rejudged] = value
            return judged
        return self._grader.rejudge(attempts, self._asked)


def _judged_there(
    files: Mapping[str, Mapping[str, bytes]], limits: Limits, asked: LinkSettings, attempts: Sequence[Attempt]
) -> list[Rejudged]:
    library = _library()
    for exercise_id, read in files.items():
        library.take(exercise_id, read)
    return Grader(library=library, limits=limits).rejudge(attempts, asked)


@lru_cache(maxsize=1)
def _library() -> Library:
    """Return the exercises that a process grades by; it takes each once."""
    return Library()
