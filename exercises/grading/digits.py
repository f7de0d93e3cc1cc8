"""Whether the lengths and angles of an answer in numbers are those of the key, each by itself.

The tolerance bounds poses, as a share of the whole robot; a small dimension of a large arm would be
unchecked. So every length and angle that no choice of frames changes is held to what the typed digits allow,
or to a per cent of itself if that is more.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from exercises.grading.typed import Place
from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy
from kinematics.equivalence.invariants import FLOOR, Invariant, Measure, axes_of, invariants_of
from kinematics.equivalence.reference import Reference
from kinematics.table import DHTable, NumericTable

PER_CENT = 0.01
"""The share of itself by which a length or an angle may be off, whatever its digits."""
ANGULAR = (Measure.ANGLE, Measure.TURN)
SECOND_ORDER = 1.25
"""What the digits do at first order, and room for what they do beyond it."""


def beyond_digits(
    reference: Reference, table: NumericTable, steps: Mapping[Place, float], policy: Policy, share: float
) -> list[Invariant]:
    """The invariants of the key that the typed digits of a table do not explain.

    Args:
        reference: the key.
        table: the answer, as it was meant.
        steps: half a unit of the last place of its decimals.
        policy: what the answer is held to.
        share: by which part of itself an invariant may be off.
    """
    axes = axes_of(chain_of_table(table), policy)
    off = {
        invariant: abs(invariant.measured(axes) - invariant.value) - floor_of(invariant, reference)
        for invariant in invariants_of(reference, policy)
    }
    far = [invariant for invariant, excess in off.items() if excess > share * abs(invariant.value)]
    if not far or not steps:
        return far
    reaches = _reaches(far, table, steps, policy)
    return [
        invariant
        for invariant, reach in zip(far, reaches, strict=True)
        if off[invariant] > SECOND_ORDER * reach
    ]


def floor_of(invariant: Invariant, reference: Reference) -> float:
    """What the arithmetic may do to an invariant."""
    return FLOOR * (1.0 if invariant.measure in ANGULAR else reference.size)


def tightened(
    reference: Reference,
    table: NumericTable | None,
    steps: Mapping[Place, float],
    policy: Policy,
    share: float,
) -> tuple[Invariant, ...]:
    """The invariants of the key, each with the slack that the digits of an answer leave it.

    Args:
        reference: the key.
        table: the answer; None for one that is exact.
        steps: half a unit of the last place of its decimals.
        policy: what the answer is held to.
        share: by which part of itself an invariant may be off.
    """
    invariants = invariants_of(reference, policy)
    reaches = [0.0] * len(invariants)
    if table is not None and steps:
        alike = table.joint_types == reference.table.joint_types
        reaches = (
            _reaches(invariants, table, steps, policy) if alike else _largest(invariants, reference, steps)
        )
    found = []
    for invariant, reach in zip(invariants, reaches, strict=True):
        slack = max(share * abs(invariant.value), SECOND_ORDER * reach) + floor_of(invariant, reference)
        found.append(replace(invariant, slack=min(invariant.slack, slack)))
    return tuple(found)


def _largest(
    invariants: Sequence[Invariant], reference: Reference, steps: Mapping[Place, float]
) -> list[float]:
    """How far invariants may move at the most, whatever the table: angles at the longest of levers."""
    lengths = sum(step for (_, cell), step in steps.items() if cell in ("a", "d"))
    angles = sum(step for (_, cell), step in steps.items() if cell in ("alpha", "theta"))
    return [
        angles if invariant.measure in ANGULAR else lengths + angles * reference.size
        for invariant in invariants
    ]


def _reaches(
    invariants: Sequence[Invariant], table: NumericTable, steps: Mapping[Place, float], policy: Policy
) -> list[float]:
    """How far invariants may move when every decimal moves by half a unit of its last place."""

    def measured(of: NumericTable) -> NDArray[np.float64]:
        axes = axes_of(chain_of_table(of), policy)
        return np.array([invariant.measured(axes) for invariant in invariants])

    here = measured(table)
    total = np.zeros(len(invariants))
    for (i, cell), step in steps.items():
        moved = [np.abs(measured(_with(table, i, cell, sign * step)) - here) for sign in (1.0, -1.0)]
        total += np.maximum(*moved)
    found: list[float] = total.tolist()
    return found


def _with(table: NumericTable, row: int, cell: str, change: float) -> NumericTable:
    rows = list(table.rows)
    rows[row] = replace(rows[row], **{cell: getattr(rows[row], cell) + change})
    return DHTable(convention=table.convention, rows=tuple(rows))
