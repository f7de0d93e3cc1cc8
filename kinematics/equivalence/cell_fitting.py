"""Lengths of a table with which it would describe the reference, found together with the certificate.

Where sliders let the axes between them be drawn anywhere, no single invariant shows which length is wrong.
F_s is an affine function of every length in the table, so the unknown ones join δ, B and E in the least
squares.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.equivalence.certificates import Candidate, candidate_from
from kinematics.equivalence.chains import chain_of, poses
from kinematics.equivalence.policy import BaseRule, Tolerance, ZeroRule
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.refinement import FREE_TWISTS, Problem
from kinematics.equivalence.search import forced_path
from kinematics.equivalence.verification import joint_values
from kinematics.table import DHTable, NumericTable

Place: TypeAlias = tuple[int, str]
"""A row, counted from 0, and "a" or "d"."""

ROUNDS = 8
SETTLED = 1e-6
CLOSE_ENOUGH = 0.5


def fitted_lengths(
    reference: Reference,
    table: NumericTable,
    places: Sequence[Place],
    signs: Sequence[int],
    tolerance: Tolerance,
) -> NumericTable | None:
    """The table with some lengths changed so that it describes the reference, as nearly as they can do that.

    Args:
        reference: the reference.
        table: a table with the same types of joints.
        places: which lengths may change.
        signs: σ.
        tolerance: what counts as near.

    Returns:
        None if the mean error stays above the tolerance.
    """
    candidate = _start(reference, table, signs, tolerance)
    for _ in range(ROUNDS):
        chain = chain_of(table)
        scaled = np.repeat((1.0, reference.size), 3)[:, None] * FREE_TWISTS
        problem = Problem(reference, chain, tolerance, scaled, scaled, offsets_free=True)
        columns = [_column(reference, table, place, candidate) for place in places]
        model = problem.linearised(candidate, *columns)
        if model.mean_square() < CLOSE_ENOUGH**2:
            return table
        step = model.least_squares()
        candidate = problem.moved(candidate, step)
        changes = step[-len(places) :] * reference.size
        table = _changed(table, places, changes.tolist())
        if np.abs(step).max() < SETTLED:
            return None
    return None


def _start(
    reference: Reference, table: NumericTable, signs: Sequence[int], tolerance: Tolerance
) -> Candidate:
    near = reference.nearnesses(tolerance)[0]
    plan = reference.plans(BaseRule.FREE, ZeroRule.FREE, near)[0]
    chain = chain_of(table)
    path = forced_path(plan, chain, plan.starts[0], signs)
    return candidate_from((reference.chain, chain), plan, path, ZeroRule.FREE, tool_turns=True)


def _column(
    reference: Reference, table: NumericTable, place: Place, candidate: Candidate
) -> NDArray[np.float64]:
    """How frame N moves when a length grows by the robot's size: (samples, 6); it does not turn."""
    joints = joint_values(reference, candidate)
    longer = _changed(table, (place,), (reference.size,))
    shift = poses(chain_of(longer), joints)[:, :3, 3] - poses(chain_of(table), joints)[:, :3, 3]
    return np.concatenate([np.zeros_like(shift), shift], axis=1)


def _changed(table: NumericTable, places: Sequence[Place], changes: Sequence[float]) -> NumericTable:
    rows = list(table.rows)
    for (row, cell), change in zip(places, changes, strict=True):
        rows[row] = replace(rows[row], **{cell: getattr(rows[row], cell) + change})
    return DHTable(convention=table.convention, rows=tuple(rows))
