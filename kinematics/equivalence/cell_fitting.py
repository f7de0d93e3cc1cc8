"""Cells of a table with which it would describe the reference, found together with the certificate.

Where prismatic joints let the axes between them be drawn anywhere, no single invariant shows which cell is
wrong. So the unknown cells join δ, B and E in the least squares, and what comes out is tried like any other
edit.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.chain import chain_of_table
from kinematics.equivalence.certificates import CertificateCandidate, candidate_from
from kinematics.equivalence.meter import PER_ROUND, Meter
from kinematics.equivalence.policy import BaseRule, Tolerance, ZeroRule
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.refinement import FREE_TWISTS, Model, RefinementProblem
from kinematics.equivalence.search import forced_path
from kinematics.equivalence.verification import joint_values
from kinematics.se3 import Transform, cross_arrays
from kinematics.table import ANGLES, Convention, DHTable, NumericTable

Place: TypeAlias = tuple[int, str]  # A row, counted from 0, and the name of a cell.

ROUNDS = 10  # Gauss–Newton doubles the digits every round; what has not settled after ten does not.
SETTLED = 1e-6  # A step below this [rad, or the robot’s size] changes nothing any more.
CLOSE_ENOUGH = 0.5  # In units of the tolerance: half is left for what the certificate does besides.
WORTHWHILE = 0.8  # A round that takes less than a fifth off the mean square leads nowhere.
FEWER_SAMPLES = 24
"""Four configurations of six equations each are enough for a cell, δ, B and E of six joints; six times
that."""


def fitted_cells(
    reference: Reference,
    table: NumericTable,
    places: Sequence[Place],
    signs: Sequence[int],
    tolerance: Tolerance,
    meter: Meter,
) -> NumericTable | None:
    """Change some cells of a table so that it describes the reference as nearly as they can.

    Returns:
        None if the mean error stays above half the tolerance.
    """
    reference, candidate, here = _start(reference, table, tuple(signs), tolerance)
    scales = [1.0 if cell in ANGLES else reference.size for _, cell in places]
    for _ in range(ROUNDS):
        meter.charge(PER_ROUND)
        columns = [motion_with_cell(table, place, here.frames) for place in places]
        model = here.problem.with_columns(
            here.model, [column * scale for column, scale in zip(columns, scales, strict=True)]
        )
        if (now := model.mean_square()) < CLOSE_ENOUGH**2:
            return table
        step = model.least_squares()
        if model.mean_square(step) > WORTHWHILE * now or np.abs(step).max() < SETTLED:
            return None
        candidate = here.problem.moved(candidate, step)
        cells = zip(step[-len(places) :].tolist(), scales, strict=True)
        table = _changed(table, places, [change * scale for change, scale in cells])
        here = _linearised(reference, table, candidate, tolerance)
    return None


class _Linearised(NamedTuple):
    """A table beside the reference, with a certificate that nearly stands.

    Attributes:
        problem: what may change of the certificate.
        model: the errors, and how they change with it.
        frames: (samples, rows + 1, 4, 4) the table's frames at the samples.
    """

    problem: RefinementProblem
    model: Model
    frames: Transform


@lru_cache(maxsize=64)
def _start(
    reference: Reference, table: NumericTable, signs: tuple[int, ...], tolerance: Tolerance
) -> tuple[Reference, CertificateCandidate, _Linearised]:
    """Where the fit of any cell starts, at fewer configurations: enough for a handful of numbers."""
    near = reference.nearnesses(tolerance)[0]
    plan = reference.plans(BaseRule.FREE, ZeroRule.FREE, near)[0]
    chain = chain_of_table(table)
    path = forced_path(plan, chain, plan.starts[0], signs)
    candidate = candidate_from((reference.chain, chain), plan, path, ZeroRule.FREE, tool_turns=True)
    some = reference.joints[:, :FEWER_SAMPLES], reference.poses[:FEWER_SAMPLES]
    fewer = replace(reference, samples=some)
    return fewer, candidate, _linearised(fewer, table, candidate, tolerance)


def _linearised(
    reference: Reference, table: NumericTable, candidate: CertificateCandidate, tolerance: Tolerance
) -> _Linearised:
    chain = chain_of_table(table)
    twists = np.repeat((1.0, reference.size), 3)[:, None] * FREE_TWISTS
    problem = RefinementProblem(reference, chain, tolerance, twists, twists, offsets_free=True)
    frames = chain.frames(joint_values(reference, candidate).T)
    return _Linearised(problem, problem.linearised(candidate), frames)


def motion_with_cell(table: NumericTable, place: Place, frames: Transform) -> NDArray[np.float64]:
    """Return how frame N turns and moves with a cell, (samples, 6).

    α and a turn about and move along x, θ and d about and along z: of the frame before the row, or of the one
    behind it where the row ends with that.
    """
    row, cell = place
    along_x = cell in ("alpha", "a")
    behind = along_x is (table.convention is Convention.STANDARD)
    frame = frames[:, row + behind]
    axis = frame[:, :3, 0 if along_x else 2]
    if cell in ANGLES:
        arm = frames[:, -1, :3, 3] - frame[:, :3, 3]
        return np.concatenate([axis, cross_arrays(axis, arm)], axis=1)
    return np.concatenate([np.zeros_like(axis), axis], axis=1)


def _changed(table: NumericTable, places: Sequence[Place], changes: Sequence[float]) -> NumericTable:
    rows = list(table.rows)
    for (row, cell), change in zip(places, changes, strict=True):
        value = getattr(rows[row], cell) + change
        value = math.remainder(value, math.tau) if cell in ANGLES else value
        rows[row] = replace(rows[row], **{cell: value})  # type: ignore[arg-type]
    return DHTable(convention=table.convention, rows=tuple(rows))
