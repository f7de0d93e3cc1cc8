"""A whole class graded without a server: file by file, on all cores, in the order of the files."""

import os
from collections import Counter, OrderedDict, deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import lru_cache
from hashlib import blake2b
from pathlib import Path

from exercises.errors import UnknownExerciseError
from exercises.library import Library
from kinematics.errors import Fault
from service.adapters.gradebook import GradebookEntry
from service.adapters.hand_ins import HandIn
from service.adapters.judging import JudgedAnswer, exercise_named, judge, told_fault, with_joint_types

_CHUNK = 8
"""Tables that travel to a worker together: a message costs as much as grading one right table, and a worker
that is last takes no longer than eight wrong ones."""
_AHEAD = 64
"""Hand-ins in flight for each worker, so that none is idle and memory does not grow with the class."""
_CACHED_ANSWERS = 1024
"""Tables that are known again when another student hands in the same; one takes a few kilobytes."""


@dataclass(frozen=True, kw_only=True, slots=True)
class ClassSettings:
    """How a class is graded.

    Attributes:
        exercise: the exercise; None where each file names its own.
        help_level: how much is told, never more than the exercise allows; None for all of that.
        per_student: whether every student has values of their own, see `_seed`.
        folders: folders with exercises of one's own.
    """

    exercise: str | None = None
    language: str = "en"
    help_level: str | None = None
    per_student: bool = False
    folders: tuple[Path, ...] = ()


def exercise_meant(name: str, library: Library) -> str:
    """Return the id of the exercise of a name, which holds for a whole class.

    Raises:
        UnknownExerciseError: there is none.
    """
    return library.exercise(exercise_named(name, library) or name).id


def grade_class(
    found: Iterable[HandIn], settings: ClassSettings, jobs: int | None
) -> Iterator[GradebookEntry]:
    """Yield the entry of every hand-in, in their order.

    All cores are used if the number of jobs is None; for 1 this process alone.
    """
    _library.cache_clear()  # a folder may have changed since another class was graded in this process
    jobs = jobs or os.cpu_count() or 1
    with ProcessPoolExecutor(jobs) if jobs > 1 else _ThisProcess() as pool:
        waiting: deque[tuple[HandIn, _Chunk, int]] = deque()
        known: OrderedDict[bytes, tuple[_Chunk, int]] = OrderedDict()
        chunk = _Chunk()
        for hand_in in found:
            key = _meaning(hand_in, settings)
            if key not in known:
                known[key] = chunk, chunk.add(hand_in)
                if len(known) > _CACHED_ANSWERS:
                    known.popitem(last=False)
            known.move_to_end(key)
            waiting.append((hand_in, *known[key]))
            overdue = len(waiting) > jobs * _AHEAD
            if chunk.is_full or (overdue and waiting[0][1] is chunk):
                chunk.send(pool, settings)
                chunk = _Chunk()
            if overdue:
                yield _entry_of(*waiting.popleft())
        chunk.send(pool, settings)
        while waiting:
            yield _entry_of(*waiting.popleft())


def misconceptions(entries: Iterable[GradebookEntry]) -> Counter[str]:
    """Count what was found, over all wrong answers."""
    return Counter(code for entry in entries if not entry.correct for code in entry.codes)


class _Chunk:
    """Tables that are graded together."""

    def __init__(self) -> None:
        self._hand_ins: list[HandIn] = []
        self._entries: Future[list[GradebookEntry]] = Future()

    def add(self, hand_in: HandIn) -> int:
        """Take in a table, and return its place."""
        self._hand_ins.append(hand_in)
        return len(self._hand_ins) - 1

    @property
    def is_full(self) -> bool:
        return len(self._hand_ins) == _CHUNK

    def send(self, pool: Executor, settings: ClassSettings) -> None:
        """Have the tables graded."""
        self._entries = pool.submit(_graded, self._hand_ins, settings)
        self._hand_ins = []

    def entry(self, place: int) -> GradebookEntry:
        """Return the entry of the table at a place, once there is one."""
        return self._entries.result()[place]


class _ThisProcess(Executor):
    """Grades where it is called, at once."""

    def submit(self, function, /, *arguments, **named):  # type: ignore[no-untyped-def]
        done: Future[object] = Future()
        done.set_result(function(*arguments, **named))
        return done


def _meaning(hand_in: HandIn, settings: ClassSettings) -> bytes:
    """Return all that an entry depends on: two students with the same of it get the same entry."""
    found = hand_in.found
    asked = (found.exercise, found.table) if found else hand_in.faults
    told = repr((asked, _seed(hand_in) if settings.per_student else None))
    return blake2b(told.encode("utf-8", "surrogatepass")).digest()


def _seed(hand_in: HandIn) -> str:
    """Return what a student's values are drawn by: the identifier in a column of theirs, or else the name.

    A number that an LMS has put into a file's name is none: nobody knew it when the values were handed out.
    """
    own = hand_in.found.identifier if hand_in.found else None
    return own or hand_in.student


def _entry_of(hand_in: HandIn, chunk: _Chunk, place: int) -> GradebookEntry:
    return replace(
        chunk.entry(place), student=hand_in.student, source=hand_in.source, identifier=hand_in.identifier
    )


@lru_cache(maxsize=4)
def _library(folders: tuple[Path, ...]) -> Library:
    """Return the exercises that a worker grades by; it reads them once."""
    return Library(folders)


def _graded(chunk: list[HandIn], settings: ClassSettings) -> list[GradebookEntry]:
    return [_entry(hand_in, settings) for hand_in in chunk]


def _entry(hand_in: HandIn, settings: ClassSettings) -> GradebookEntry:
    if hand_in.found is None:
        return _ungraded(hand_in, settings.exercise or "", hand_in.faults, settings)
    named = settings.exercise or hand_in.found.exercise
    if named is None:
        return _ungraded(hand_in, "", (Fault.at("exercise_not_named"),), settings)
    library = _library(settings.folders)
    exercise_id = exercise_named(named, library) or named
    answer: dict[str, object] = {}
    try:
        answer["table"] = with_joint_types(exercise_id, hand_in.found.table, library)
        if settings.per_student:
            answer["seed"] = _seed(hand_in)
        if settings.help_level:
            answer["help"] = settings.help_level
        judged = judge(exercise_id, answer, settings.language, library)
    except UnknownExerciseError as error:
        return _ungraded(hand_in, named, error.faults, settings)
    if not isinstance(judged, JudgedAnswer):
        return _ungraded(hand_in, exercise_id, judged.faults, settings)
    return GradebookEntry(
        student=hand_in.student,
        exercise=exercise_id,
        points=judged.points,
        max_points=judged.max_points,
        correct=judged.correct,
        codes=judged.codes,
        feedback=" ".join(judged.sentences()),
        source=hand_in.source,
    )


def _ungraded(
    hand_in: HandIn, exercise_id: str, faults: tuple[Fault, ...], settings: ClassSettings
) -> GradebookEntry:
    return GradebookEntry(
        student=hand_in.student,
        exercise=exercise_id,
        codes=tuple(fault.code for fault in faults),
        feedback=" ".join(told_fault(fault, settings.language) for fault in faults),
        source=hand_in.source,
    )
