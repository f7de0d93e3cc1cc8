"""The invariants are as many as there are numbers of a robot that no choice of frames changes.

The screws S_1 … S_n of a chain stand for its robot, but for motions of the base, ad_ξ S_i of all of them,
and for offsets of its variables, which carry the screws behind a joint along: ad_{S_j} S_i, i > j. A tool
point that is fixed goes with them. What cells change beside that, at first order, is the robot; the
invariants must see all of it.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from random import Random

import numpy as np
import pytest
from numpy.typing import NDArray

from kinematics.chain import chain_of_table
from kinematics.equivalence import BaseRule, Policy, ToolRule
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.invariants import axes_of, invariants_of
from kinematics.equivalence.measures import Measure, Shape
from kinematics.equivalence.reference import prepared
from kinematics.se3 import position
from kinematics.table import NumericTable
from tests.conftest import EXPLORE
from tests.kinematics.equivalence.tables import P, R, standard

FREE = Policy(tool=ToolRule.FREE)
POLICIES = [
    Policy(base=base, tool=tool)
    for base in (BaseRule.FREE, BaseRule.ORIGIN)
    for tool in (ToolRule.FREE, ToolRule.POINT)
]
STEP = 1e-6
INDEPENDENT = 1e-5
"""Singular values above this are not those of differences that should be zero."""
TWISTS = {"skew": (None,), "some parallel": (0.0, None), "also at right angles": (0.0, math.pi / 2, None)}
"""What twists are drawn from; None: at random."""


def arms(joints: int, twists: str) -> Iterator[tuple[str, NumericTable]]:
    kinds = list(product((R, P), repeat=joints))
    for types in kinds if EXPLORE or joints < 5 else kinds[::3]:
        name = "".join("R" if kind is R else "P" for kind in types)
        rng = Random(f"{name} {twists}")
        rows = []
        for kind in types:
            twist = rng.choice(TWISTS[twists])
            alpha = rng.choice((-1, 1)) * rng.uniform(0.5, 1.2) if twist is None else twist
            rows.append((kind, alpha, *(rng.uniform(0.2, 0.6) for _ in range(2)), rng.uniform(0.4, 1.2)))
        yield name, standard(*rows)


def screws(table: NumericTable) -> NDArray[np.float64]:
    """(n, 6) direction and moment of every axis; of a slider, zero and its direction."""
    found = []
    for axis in chain_of_table(table).axes:
        z, p = np.array(axis.direction), np.array(axis.point)
        found.append(np.concatenate((np.zeros(3), z) if axis.prismatic else (z, np.cross(p, z))))
    return np.array(found)


def ad(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    """The Lie bracket of two screws."""
    w, v = one[:3], one[3:]
    return np.concatenate((np.cross(w, other[:3]), np.cross(w, other[3:]) + np.cross(v, other[:3])))


def carried_along(xi: NDArray[np.float64], p: NDArray[np.float64]) -> NDArray[np.float64]:
    """What a twist does to a point."""
    return np.cross(xi[:3], p) + xi[3:]


def state(table: NumericTable, policy: Policy) -> NDArray[np.float64]:
    """(6 n) the screws, or (6 n + 3) these and the tool point."""
    point = position(chain_of_table(table).end) if policy.tool is ToolRule.POINT else ()
    return np.concatenate((screws(table).ravel(), point))


def changes_of_frames(table: NumericTable, policy: Policy) -> NDArray[np.float64]:
    """What motions of the base, or turns about its origin, and offsets of variables do to the state."""
    S, p = screws(table), np.array(position(chain_of_table(table).end))
    twists = np.eye(6)[: 6 if policy.base is BaseRule.FREE else 3]
    free = [(xi, -1) for xi in twists] + [(s, j) for j, s in enumerate(S)]
    return np.array(
        [
            np.concatenate(
                (
                    *(ad(xi, s) if i > j else np.zeros(6) for i, s in enumerate(S)),
                    *((carried_along(xi, p),) if policy.tool is ToolRule.POINT else ()),
                )
            )
            for xi, j in free
        ]
    )


def changed(table: NumericTable, row: int, cell: str, by: float) -> NumericTable:
    rows = list(table.rows)
    rows[row] = replace(rows[row], **{cell: getattr(rows[row], cell) + by})
    return replace(table, rows=tuple(rows))


def rank(vectors: NDArray[np.float64]) -> int:
    return int(np.linalg.matrix_rank(vectors, tol=INDEPENDENT))


@pytest.mark.parametrize("policy", POLICIES, ids=lambda policy: f"{policy.base.value}-{policy.tool.value}")
@pytest.mark.parametrize("twists", TWISTS)
@pytest.mark.parametrize("joints", [2, 3, 4, 5])
def test_nothing_that_no_choice_of_frames_changes_is_unseen(joints: int, twists: str, policy: Policy) -> None:
    unseen = {}
    for name, key in arms(joints, twists):
        invariants = invariants_of(prepared(key), policy)
        cells = [
            (i, cell)
            for i, row in enumerate(key.rows)
            for cell in ("theta", "d", "a", "alpha")
            if cell != "alpha" or row.alpha  # whether axes are parallel is seen, but not at first order
        ]
        sides = [[changed(key, *cell, by) for cell in cells] for by in (STEP, -STEP)]
        on, back = (np.array([state(table, policy) for table in side]) for side in sides)
        frames = changes_of_frames(key, policy)
        both = np.concatenate((frames, (on - back) / (2.0 * STEP)))
        axes = axis_batch([axes_of(chain_of_table(table), policy) for side in sides for table in side])
        measured = invariants.measured(axes)
        seen = (measured[:, : len(cells)] - measured[:, len(cells) :]) / (2.0 * STEP)
        missing = rank(both) - rank(frames) - (rank(seen) if seen.size else 0)
        if missing:
            unseen[name] = missing
    assert not unseen


def test_sliders_side_by_side_are_turned_about_as_one() -> None:
    key = standard(
        (R, 1.0, 0.2, 0.3, 0.4), (P, 0.0, 0.2, 0.3, 0.5), (P, 0.7, 0.2, 0.3, 0.4), (R, 0.9, 0.2, 0.3, 0.4)
    )
    assert Shape(Measure.TURN, (1, 2, 4)) in invariants_of(prepared(key), FREE).shapes
