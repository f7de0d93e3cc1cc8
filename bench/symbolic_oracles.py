"""Closed forms held against oracles that know nothing of them: counts of what agrees, not times."""

import gc
import random
import time
from collections import Counter
from typing import Any

import numpy as np

from bench import Better, Outcome, measured


def random_tables(count: int) -> list[Outcome]:
    """Tables of seven general rows: the written NumPy function beside SymPy's link matrices, multiplied."""
    from kinematics.printing import Format, MatrixPrinter, Purpose
    from kinematics.symbolic import closed_form
    from tests.kinematics.symbolic.tables import general_table, sympy_poses

    purpose = Purpose(name="pose", meaning="The pose.")
    agreeing, slowest = 0, 0.0
    for seed in range(count):
        table = general_table(random.Random(seed))
        gc.disable()  # a collection would be of the peers' objects, and fall on one table
        start = time.process_time()
        printer = MatrixPrinter(n_joints=7, parameters=())
        matrix = closed_form(table).transform
        printer.write(matrix, (Format.LATEX,), purpose)
        slowest = max(slowest, time.process_time() - start)
        gc.enable()
        written = printer.write(matrix, (Format.NUMPY,), purpose)
        scope: dict[str, Any] = {}
        exec(written["numpy"], scope)
        configurations = np.random.default_rng(seed).uniform(-np.pi, np.pi, (100, 7))
        theirs = sympy_poses(table, configurations)
        agreeing += bool(np.abs(scope["pose"](configurations) - theirs).max() <= 1e-12)
    return [
        measured(
            f"{count} random tables of 7 general rows that agree with SymPy to 1e-12 at 100 configurations",
            peer="all of them",
            ours=agreeing,
            theirs=count,
            unit="tables",
            better=Better.MORE,
            bar=1,
        ),
        measured(
            "the slowest of them, closed form with LaTeX",
            peer="a bar of 50 ms",
            ours=slowest,
            theirs=50e-3,
            unit="s",
            better=Better.LESS,
            bar=1,
        ),
    ]


def pairs(count: int) -> list[Outcome]:
    """The canonical form beside pairs of which it is known whether they are one function."""
    from kinematics.symbolic import ProofStatus, compare
    from tests.kinematics.symbolic.pairs import equal_pair, unequal_pair

    equal = Counter(compare(*equal_pair(random.Random(f"equal {seed}"))) for seed in range(count))
    unequal = Counter(compare(*unequal_pair(random.Random(f"unequal {seed}"))) for seed in range(count))
    rows = (
        ("equal, proved", equal[ProofStatus.PROVED], 1.0),
        ("unequal, not proved", count - unequal[ProofStatus.PROVED], 1.0),
        ("unequal, refuted (the rest undecided)", unequal[ProofStatus.REFUTED], None),
    )
    return [
        measured(
            f"{count} pairs made {what}",
            peer="all of them",
            ours=right,
            theirs=count,
            unit="pairs",
            better=Better.MORE,
            bar=bar,
        )
        for what, right, bar in rows
    ]
