"""The decision and the verdict, beside what is usually done and beside what was promised."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable
from random import Random

import numpy as np

from bench import Better, Outcome, measured, race

TITLE = "The checker"
ABOUT = """
Six-joint robots of the catalogue. *Deciding* is from two parsed tables in numbers to a verified certificate;
each table is another random valid one, drawn from the axes. Its peer is what an automatic grader usually
does: compare ⁰T_N with the key's at 64 configurations, which accepts only the key's own frames. *Verdicts
with repairs* are on wrong tables, each with one mistake of the catalogue; there the peer is the bar.
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
    from tests.exercises.grading.campaign import drawn_by_hand, is_mended
    from tests.exercises.grading.written import written
    from tests.kinematics.equivalence.campaign import catalogue
    from tests.kinematics.equivalence.mutations import mutations

    policy = Policy(tool=ToolRule.FREE)
    rng = Random(2)
    times: list[float] = []
    mended = wrong = 0
    for _, key in catalogue() * 3:
        table = drawn_by_hand(key, rng)
        assert table is not None
        for mutation in rng.sample(made := mutations(table, rng), min(8, len(made))):
            answer, reference = written(mutation.table), written(key)
            start = time.perf_counter()
            verdict = grade(reference, answer, policy)
            if not verdict.correct:
                times.append(time.perf_counter() - start)
                wrong += 1
                mended += is_mended(mutation, verdict.repairs)
    share = 100.0 * mended / wrong
    return [
        _against_the_bar("verdict with repairs on a wrong table: median", _median(times), 50e-3),
        _against_the_bar(
            "verdict with repairs on a wrong table: 99th percentile", _percentile(times), 300e-3
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
