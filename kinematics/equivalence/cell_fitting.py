"""Cells of a table with which it would describe the reference, found together with the certificate.

Where sliders let the axes between them be drawn anywhere, no single invariant shows which cell is wrong. So
the unknown cells join δ, B and E in the least squares, and what comes out is tried like any other edit.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.chain import chain_of_table
from kinematics.equivalence.certificates import CertificateCandidate, candidate_from
from kinematics.equivalence.meter import Meter
from kinematics.equivalence.policy import BaseRule, Tolerance, ZeroRule
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.refinement import FREE_TWISTS, RefinementProblem
from kinematics.equivalence.search import forced_path
from kinematics.equivalence.verification import joint_values
from kinematics.se3 import turns_between
from kinematics.table import DHTable, NumericTable

Place: TypeAlias = tuple[int, str]
"""A row, counted from 0, and the name of a cell."""

# Gauss–Newton doubles the digits every round; what has not settled after ten does not.
ROUNDS = 10
# A step below this [rad, or the robot’s size] changes nothing any more.
SETTLED = 1e-6
# In units of the tolerance: half is left for what the certificate does besides.
CLOSE_ENOUGH = 0.5
# A round that takes less than a fifth off the mean square leads nowhere.
WORTHWHILE = 0.8
# Four configurations of six equations each are enough for a cell, δ, B and E of six joints; six times that.
FEWER_SAMPLES = 24
ANGLES = ("alpha", "theta")
# [rad] For a central difference: its error, the square, is that of the arithmetic divided by it.
SMALL_ANGLE = 1e-4


def fitted_cells(
    reference: Reference,
    table: NumericTable,
    places: Sequence[Place],
    signs: Sequence[int],
    tolerance: Tolerance,
    meter: Meter | None = None,
) -> NumericTable | None:
    """The table with some cells changed so that it describes the reference, as nearly as they can do that.

    Args:
        reference: the reference.
        table: a table with the same types of joints.
        places: which cells may change.
        signs: σ.
        tolerance: what counts as near.
        meter: counts the work, if it is bounded.

    Returns:
        None if the mean error stays above half the tolerance.
    """
    candidate = _start(reference, table, signs, tolerance)
    reference = _sampled_less(reference)
    scales = np.array([1.0 if cell in ANGLES else reference.size for _, cell in places])
    twists = np.repeat((1.0, reference.size), 3)[:, None] * FREE_TWISTS
    for _ in range(ROUNDS):
        chain = chain_of_table(table)
        problem = RefinementProblem(
            reference, chain, tolerance, twists, twists, offsets_free=True, meter=meter
        )
        joints = joint_values(reference, candidate)
        columns = [_column(table, place, joints, scale) for place, scale in zip(places, scales, strict=True)]
        model = problem.linearised(candidate, *columns)
        if model.mean_square() < CLOSE_ENOUGH**2:
            return table
        step = model.least_squares()
        if model.mean_square(step) > WORTHWHILE * model.mean_square() or np.abs(step).max() < SETTLED:
            return None
        candidate = problem.moved(candidate, step)
        table = _changed(table, places, (step[-len(places) :] * scales).tolist())
    return None


def _sampled_less(reference: Reference) -> Reference:
    """The reference with fewer configurations: enough to solve for a handful of numbers."""
    return replace(
        reference, joints=reference.joints[:, :FEWER_SAMPLES], poses=reference.poses[:FEWER_SAMPLES]
    )


def _start(
    reference: Reference, table: NumericTable, signs: Sequence[int], tolerance: Tolerance
) -> CertificateCandidate:
    near = reference.nearnesses(tolerance)[0]
    plan = reference.plans(BaseRule.FREE, ZeroRule.FREE, near)[0]
    chain = chain_of_table(table)
    path = forced_path(plan, chain, plan.starts[0], signs)
    return candidate_from((reference.chain, chain), plan, path, ZeroRule.FREE, tool_turns=True)


def _column(
    table: NumericTable, place: Place, joints: NDArray[np.float64], scale: float
) -> NDArray[np.float64]:
    """How frame N turns and moves with a cell, per unit of the step: (samples, 6).

    F_s is an affine function of every length, so its difference is exact.
    """
    step = SMALL_ANGLE if place[1] in ANGLES else scale
    before = chain_of_table(_changed(table, (place,), (-step / 2,))).poses(joints.T)
    after = chain_of_table(_changed(table, (place,), (step / 2,))).poses(joints.T)
    turn = turns_between(before, after)
    shift = after[:, :3, 3] - before[:, :3, 3]
    return np.concatenate([turn, shift], axis=1) * (scale / step)


def _changed(table: NumericTable, places: Sequence[Place], changes: Sequence[float]) -> NumericTable:
    rows = list(table.rows)
    for (row, cell), change in zip(places, changes, strict=True):
        value = getattr(rows[row], cell) + change
        value = math.remainder(value, 2 * math.pi) if cell in ANGLES else value
        rows[row] = replace(rows[row], **{cell: value})  # type: ignore[arg-type]
    return DHTable(convention=table.convention, rows=tuple(rows))
