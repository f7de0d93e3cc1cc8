"""The decision and the verdict, beside what is usually done and beside what was promised."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable
from random import Random
from typing import TYPE_CHECKING

import numpy as np

from bench import Better, Outcome, measured, race

if TYPE_CHECKING:
    from exercises.grading import Policy, Verdict
    from kinematics.cells import ReadTable

TITLE = "The checker"
ABOUT = """
Six-joint robots of the catalogue. *Deciding* is from two parsed tables in numbers to a verified certificate;
each table is another random valid one, drawn from the axes. Its peer is what an automatic grader usually
does: compare ⁰T_N with the key's at 64 configurations, which accepts only the key's own frames. *Verdicts
with repairs* are on wrong tables, each with one mistake of the catalogue, or two; there the peer is the bar,
and garbage is collected as the service does it, which looks at all objects only while nobody waits.
"""

TABLES = 300


def rows() -> list[Outcome]:
    """Measure."""
    return [*_deciding(), *_explaining()]


def _deciding() -> list[Outcome]:
    from kinematics.equivalence import Policy, Tolerance, ToolRule, decide
    from kinematics.equivalence.reference import prepared
    from kinematics.forward import forward_kinematics
    from tests.kinematics.equivalence.campaign import catalogue
    from tests.kinematics.equivalence.generators import random_valid_table

    policy = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=1e-9, angle=1e-9))
    rng = Random(1)
    keys = [table for _, table in catalogue() if table.n_joints == 6]
    pairs = [
        (key, random_valid_table(key, rng, dummies=0.0)) for key in keys for _ in range(TABLES // len(keys))
    ]
    joints = np.random.default_rng(1).uniform(-math.pi, math.pi, (64, 6))

    def ours() -> None:
        for key, table in pairs:
            assert decide(key, table, policy).accepted

    def naive() -> None:
        for key, table in pairs:
            for q in joints:
                np.allclose(forward_kinematics(key, q).transform, forward_kinematics(table, q).transform)

    for key in keys:
        prepared(key)
    ours()
    times = _times([lambda key=key, table=table: decide(key, table, policy) for key, table in pairs])
    return [
        *race(
            "a valid table with six joints, decided",
            ours,
            {"⁰T_N compared": naive},
            items=len(pairs),
            rounds=5,
        ),
        _against_the_bar("a valid table with six joints, decided: median", _median(times), 0.5e-3),
        _against_the_bar("a valid table with six joints, decided: 99th percentile", _percentile(times), 2e-3),
    ]


def _explaining() -> list[Outcome]:
    from exercises.grading import Policy, ToolRule, grade
    from service.work.collection import new_objects_alone
    from tests.exercises.grading.campaign import drawn_by_hand, is_mended
    from tests.exercises.grading.written import written
    from tests.kinematics.equivalence.campaign import catalogue
    from tests.kinematics.equivalence.mutations import mutations

    policy = Policy(tool=ToolRule.FREE)
    rng = Random(2)
    once: list[float] = []
    twice: list[float] = []
    mended = wrong = 0
    with new_objects_alone():
        for _, key in [robot for robot in catalogue() if robot[1].n_joints == 6] * 3:
            table = drawn_by_hand(key, rng)
            assert table is not None
            reference = written(key)
            for mutation in rng.sample(made := mutations(table, rng), min(8, len(made))):
                seconds, verdict = _graded(grade, reference, written(mutation.table), policy)
                if not verdict.correct:
                    once.append(seconds)
                    wrong += 1
                    mended += is_mended(mutation, verdict.repairs)
                second = rng.choice(mutations(mutation.table, rng))
                seconds, verdict = _graded(grade, reference, written(second.table), policy)
                if not verdict.correct:
                    twice.append(seconds)
    share = 100.0 * mended / wrong
    return [
        _against_the_bar("verdict with repairs, six joints, one mistake: mean", statistics.mean(once), 2e-3),
        _against_the_bar(
            "verdict with repairs, six joints, two mistakes: mean", statistics.mean(twice), 8e-3
        ),
        _against_the_bar(
            "verdict with repairs, six joints: 99th percentile of both", _percentile(once + twice), 40e-3
        ),
        measured(
            f"{wrong} single mistakes mended, in the right row",
            peer="the bar",
            ours=share,
            theirs=99.0,
            unit="%",
            better=Better.MORE,
            bar=1.0,
        ),
    ]


def _graded(
    grade: Callable[..., Verdict], reference: ReadTable, answer: ReadTable, policy: Policy
) -> tuple[float, Verdict]:
    start = time.perf_counter()
    verdict = grade(reference, answer, policy)
    return time.perf_counter() - start, verdict


def _times(works: list[Callable[[], object]]) -> list[float]:
    found = []
    for work in works:
        start = time.perf_counter()
        work()
        found.append(time.perf_counter() - start)
    return found


def _median(times: list[float]) -> float:
    return statistics.median(times)


def _percentile(times: list[float]) -> float:
    return sorted(times)[int(0.99 * len(times))]


def _against_the_bar(work: str, seconds: float, bar: float) -> Outcome:
    return measured(work, peer="the bar", ours=seconds, theirs=bar, unit="s", better=Better.LESS, bar=1.0)
