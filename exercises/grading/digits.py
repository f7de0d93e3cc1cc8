"""Whether the lengths and angles of an answer in numbers are those of the key, each by itself.

The tolerance bounds poses, as a share of the whole robot; a small dimension of a large arm would be
unchecked. So every length and angle that no choice of frames changes is held to what the typed digits allow,
or to a per cent of itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from exercises.grading.typed import Place
from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy
from kinematics.equivalence.invariants import FLOOR, Invariant, Measure, axes_of, invariants_of
from kinematics.equivalence.reference import Reference
from kinematics.table import DHTable, NumericTable

PER_CENT = 0.01
"""The share of itself by which a length or an angle may be off, whatever its digits."""
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
    far = []
    for invariant in invariants_of(reference, policy):
        off = abs(invariant.measured(axes) - invariant.value)
        allowed = share * abs(invariant.value) + floor_of(invariant, reference)
        if off > allowed and off > allowed + SECOND_ORDER * _reach(invariant, table, steps, policy):
            far.append(invariant)
    return far


def floor_of(invariant: Invariant, reference: Reference) -> float:
    """What the arithmetic may do to an invariant."""
    return FLOOR * (1.0 if invariant.measure in (Measure.ANGLE, Measure.TURN) else reference.size)


def tightened(
    reference: Reference, steps: Mapping[Place, float], policy: Policy, share: float
) -> tuple[Invariant, ...]:
    """The invariants of the key, each with the slack that the digits of an answer leave it at the most."""
    lengths = sum(step for (_, cell), step in steps.items() if cell in ("a", "d"))
    angles = sum(step for (_, cell), step in steps.items() if cell in ("alpha", "theta"))
    found = []
    for invariant in invariants_of(reference, policy):
        angular = invariant.measure in (Measure.ANGLE, Measure.TURN)
        digits = angles if angular else lengths + angles * reference.size
        slack = share * abs(invariant.value) + SECOND_ORDER * digits + floor_of(invariant, reference)
        found.append(replace(invariant, slack=min(invariant.slack, slack)))
    return tuple(found)


def _reach(invariant: Invariant, table: NumericTable, steps: Mapping[Place, float], policy: Policy) -> float:
    """How far an invariant may move when every decimal moves by half a unit of its last place."""
    here = invariant.measured(axes_of(chain_of_table(table), policy))
    total = 0.0
    for (i, cell), step in steps.items():
        moved = (_with(table, i, cell, sign * step) for sign in (1.0, -1.0))
        total += max(abs(invariant.measured(axes_of(chain_of_table(t), policy)) - here) for t in moved)
    return total


def _with(table: NumericTable, row: int, cell: str, change: float) -> NumericTable:
    rows = list(table.rows)
    rows[row] = replace(rows[row], **{cell: getattr(rows[row], cell) + change})
    return DHTable(convention=table.convention, rows=tuple(rows))
