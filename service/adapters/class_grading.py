"""A whole class graded without a server: file by file, on all cores, in the order of the files."""

from __future__ import annotations

import os
from collections import Counter, deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from exercises.errors import UnknownExerciseError
from exercises.loader import Library, packaged
from kinematics.errors import Fault
from service.adapters.gradebook import Mark
from service.adapters.hand_ins import HandIn
from service.adapters.judging import JudgedAnswer, judge, told_fault, with_joint_types

_CHUNK = 16
"""Tables that travel to a worker together: a message costs as much as grading one right table."""
_CHUNKS_AHEAD = 4
"""Chunks waiting for each worker, so that none is idle and memory does not grow with the class."""


@dataclass(frozen=True, kw_only=True, slots=True)
class ClassSettings:
    """How a class is graded.

    Attributes:
        exercise: the exercise; None where each file names its own.
        language: of the feedback.
        help_level: how much is told, never more than the exercise allows; None for all of that.
        per_student: whether the student's name is the seed of the values.
        folders: folders with exercises of one's own.
    """

    exercise: str | None = None
    language: str = "en"
    help_level: str | None = None
    per_student: bool = False
    folders: tuple[Path, ...] = ()


def grade_class(found: Iterable[HandIn], settings: ClassSettings, jobs: int | None = None) -> Iterator[Mark]:
    """Yield the mark of every hand-in, in their order.

    Args:
        found: what was handed in.
        settings: the exercise and what is told.
        jobs: processes; all cores if left out, none besides this one for 1.
    """
    jobs = jobs or os.cpu_count() or 1
    chunks = _chunks(found)
    if jobs == 1:
        for chunk in chunks:
            yield from _graded(chunk, settings)
        return
    with ProcessPoolExecutor(jobs) as pool:
        waiting: deque[Future[list[Mark]]] = deque()
        for chunk in chunks:
            waiting.append(pool.submit(_graded, chunk, settings))
            if len(waiting) >= jobs * _CHUNKS_AHEAD:
                yield from waiting.popleft().result()
        while waiting:
            yield from waiting.popleft().result()


def misconceptions(marks: Iterable[Mark]) -> Counter[str]:
    """Count what was found, over all wrong answers."""
    return Counter(code for mark in marks if not mark.correct for code in mark.codes)


def exercise_named(name: str, library: Library | None = None) -> str | None:
    """Return the exercise that a file means by a robot's name: its id, whatever the case and the spaces."""
    bare = "".join(letter for letter in name.lower() if letter.isalnum())
    return next((known for known in (library or packaged()).ids if known.replace("-", "") == bare), None)


def _chunks(found: Iterable[HandIn]) -> Iterator[list[HandIn]]:
    chunk: list[HandIn] = []
    for hand_in in found:
        chunk.append(hand_in)
        if len(chunk) == _CHUNK:
            yield chunk
            chunk = []
    if chunk:
        yield chunk


@lru_cache(maxsize=4)
def _library(folders: tuple[Path, ...]) -> Library:
    """Return the exercises that a worker grades by; it reads them once."""
    return Library(folders)


def _graded(chunk: list[HandIn], settings: ClassSettings) -> list[Mark]:
    return [_mark(hand_in, settings) for hand_in in chunk]


def _mark(hand_in: HandIn, settings: ClassSettings) -> Mark:
    if hand_in.found is None:
        return _ungraded(hand_in, settings.exercise or "", hand_in.faults, settings)
    named = settings.exercise or hand_in.found.exercise
    if named is None:
        return _ungraded(hand_in, "", (Fault(code="exercise_not_named"),), settings)
    library = _library(settings.folders)
    exercise_id = exercise_named(named, library) or named
    answer: dict[str, object] = {}
    try:
        answer["table"] = with_joint_types(exercise_id, hand_in.found.table, library)
        if settings.per_student:
            answer["seed"] = hand_in.student
        if settings.help_level:
            answer["help"] = settings.help_level
        judged = judge(exercise_id, answer, settings.language, library)
    except UnknownExerciseError as error:
        return _ungraded(hand_in, named, error.faults, settings)
    if not isinstance(judged, JudgedAnswer):
        return _ungraded(hand_in, exercise_id, judged.faults, settings)
    return Mark(
        student=hand_in.student,
        exercise=exercise_id,
        points=judged.points,
        max_points=judged.max_points,
        correct=judged.correct,
        codes=judged.codes,
        feedback=" ".join(judged.sentences()),
        source=hand_in.source,
    )


def _ungraded(hand_in: HandIn, exercise_id: str, faults: tuple[Fault, ...], settings: ClassSettings) -> Mark:
    return Mark(
        student=hand_in.student,
        exercise=exercise_id,
        points=None,
        max_points=None,
        correct=False,
        codes=tuple(fault.code for fault in faults),
        feedback=" ".join(told_fault(fault, settings.language) for fault in faults),
        source=hand_in.source,
    )
