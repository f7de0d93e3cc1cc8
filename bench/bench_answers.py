"""Answers of every kind of part but the table, judged in process, beside what was promised."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable, Iterator
from random import Random
from typing import TYPE_CHECKING, Any

from bench import Better, Outcome, measured

if TYPE_CHECKING:
    from exercises.instance import Instance

TITLE = "Answers of other kinds"
ABOUT = """
Processor time of judging one answer: its cells are read, it is decided, and the feedback is found, in
codes and parameters. For each kind of part the exercises of the catalogue that ask for it, with the
values of six students, and the right and the wrong answers that the kind makes for its self-test; where
the exercise asks for a table, it is the key, and its verdict is known. Each answer is judged once before,
so its cells are known; then the least of five times counts, and the median of all answers is reported. The
peer is the bar: 1 ms for a right answer, 10 ms for a wrong one with its explanation.
"""

STUDENTS = 6
TIMES = 5
BARS = {"right": 1e-3, "wrong, explained": 1e-2}


def rows() -> list[Outcome]:
    """Measure."""
    from exercises.library import packaged
    from exercises.parts.registry import part_types

    library = packaged()
    found: list[Outcome] = []
    asking = [library.exercise(name) for name in library.ids]
    for kind in part_types():
        if kind == "table":
            continue
        seconds: dict[str, list[float]] = {name: [] for name in BARS}
        for exercise in asking:
            if exercise.part(kind) is not None:
                for seed in range(STUDENTS):
                    for name, work in _answers(exercise, kind, str(seed)):
                        seconds[name].append(_least(work))
        found += [
            measured(
                f"`{kind}`, {name}",
                peer="the bar",
                ours=statistics.median(times),
                theirs=BARS[name],
                unit="s",
                better=Better.LESS,
                bar=1.0,
            )
            for name, times in seconds.items()
            if times
        ]
    return found


def _answers(exercise: Any, kind: str, seed: str) -> Iterator[tuple[str, Callable[[], object]]]:
    """Yield what judges the answers of one student, right and wrong."""
    from exercises.instance import generate
    from exercises.parts.registry import part_type
    from exercises.selftest.answers import context_of

    instance, part, judge = generate(exercise, seed), exercise.part(kind), part_type(kind)
    context = context_of(instance, exercise.reference)
    yield "right", _judging(instance, kind, judge.right(part, context))
    for _, raw in judge.wrong(part, context, Random(seed)):
        yield "wrong, explained", _judging(instance, kind, raw)


def _judging(instance: Instance, kind: str, raw: Any) -> Callable[[], object]:
    from exercises import grading
    from exercises.answers import RawAnswer, parse
    from exercises.parts.context import Context
    from exercises.parts.registry import part_type
    from exercises.written_table import written_table

    exercise, judge = instance.exercise, part_type(kind)
    key, part = exercise.reference, exercise.part(kind)
    beside = {"table": written_table(key)} if exercise.part("table") is not None else {}
    answer = RawAnswer(**beside, **{kind: raw})
    verdict = grading.grade(key, key, exercise.policy, instance.parameters) if beside else None

    def work() -> object:
        read = parse(instance, answer)
        return judge.grade(part, read.get(kind), Context(instance=instance, answer=read, verdict=verdict))

    return work


def _least(work: Callable[[], object]) -> float:
    """Return the least processor time of one call [s], after a first one."""
    work()
    least = math.inf
    for _ in range(TIMES):
        start = time.process_time()
        work()
        least = min(least, time.process_time() - start)
    return least
