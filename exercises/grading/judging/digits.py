"""Whether the lengths and angles of an answer in numbers are those of the key, each by itself.

The tolerance bounds poses, as a share of the whole robot; a small dimension of a large arm would be
unchecked. So every length and angle that no choice of frames changes is held to what the typed digits allow,
or to a per cent of itself if that is more.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache

import numpy as np

from exercises.grading.judging.typed import Place, says_enough
from kinematics.equivalence import BaseRule, Policy, Tolerance, ToolRule
from kinematics.equivalence.batches import Variation
from kinematics.equivalence.invariants import FLOOR, Invariants, invariants_of
from kinematics.equivalence.measures import Shape
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.row_measures import measured_of_tables
from kinematics.se3 import Floats
from kinematics.table import ANGLES, LENGTHS, NumericTable

PER_CENT = 0.01  # The share of itself by which a length or an angle may be off, whatever its digits.
CACHED_TABLES = 64
"""Tables at hand: each is asked for when it is judged, when edits are tried on it and when it is scored."""
FINEST = 1e-15
"""[rad], or a share of the longest entry: finer digits are lost among the errors of the arithmetic."""
SECOND_ORDER = 1.25  # What the digits do at first order, and room for what they do beyond it.


def beyond_digits(
    reference: Reference, table: NumericTable, steps: Mapping[Place, float], policy: Policy, share: float
) -> Invariants | None:
    """Return the key's invariants that the typed digits do not explain; None if they explain all.

    Args:
        reference: the key.
        table: the answer, as it was meant, with as many joints.
        steps: half a unit of the last place of its decimals.
        policy: what the answer is held to.
        share: by which part of itself an invariant may be off.
    """
    return not_explained(invariants_of(reference, policy), reference, table, steps, policy, share)


def not_explained(
    invariants: Invariants,
    reference: Reference,
    table: NumericTable,
    steps: Mapping[Place, float],
    policy: Policy,
    share: float,
) -> Invariants | None:
    """Return those of some invariants that the typed digits do not explain; None if they explain all.

    Args:
        invariants: of the key.
        reference: the key.
        table: the answer, as it was meant, with as many joints.
        steps: half a unit of the last place of its decimals.
        policy: what the invariants take as fixed at the ends.
        share: by which part of itself an invariant may be off.
    """
    own = invariants.own_sizes[:, 0]
    floor = floors(invariants, reference)
    sizes = invariants.sizes(measured_as_typed(invariants, table, steps, policy))
    off = np.abs(sizes[:, 0] - own) - floor
    far = off > share * own
    if far.any() and steps:
        far &= off > _largest_moves(sizes)
    return invariants.some(np.flatnonzero(far).tolist()) if far.any() else None


def digits_and_angles(
    reference: Reference, table: NumericTable, steps: Mapping[Place, float], policy: Policy
) -> float:
    """Return by which share of its size an answer's poses may be off for its digits and for wrong angles.

    Args:
        reference: the key.
        table: the answer, with as many joints.
        steps: half a unit of the last place of its decimals.
        policy: what the answer is held to.
    """
    invariants = invariants_of(reference, policy)
    sizes = invariants.sizes(measured_as_typed(invariants, table, {}, policy))
    angles = np.abs(sizes - invariants.own_sizes)[invariants.angular].sum()
    typed = [step if cell in ANGLES else step / reference.size for (_, cell), step in steps.items()]
    return float(SECOND_ORDER * (sum(typed) + angles))


@lru_cache(maxsize=256)
def floors(invariants: Invariants, reference: Reference) -> Floats:
    """Return what the arithmetic may do to invariants, (q,)."""
    return FLOOR * np.where(invariants.angular[:, 0], 1.0, reference.size)


def tightened(
    reference: Reference,
    table: NumericTable | None,
    steps: Mapping[Place, float],
    policy: Policy,
    share: float,
) -> Invariants:
    """Return the invariants of the key, each with the slack that the digits of an answer leave it.

    Args:
        reference: the key.
        table: the answer; None for one that is exact.
        steps: half a unit of the last place of its decimals.
        policy: what the answer is held to.
        share: by which part of itself an invariant may be off.
    """
    invariants = invariants_of(reference, policy)
    reaches = np.zeros(len(invariants.shapes))
    if table is not None and steps:
        alike = table.joint_types == reference.table.joint_types
        reaches = (
            _largest_moves(invariants.sizes(measured_as_typed(invariants, table, steps, policy)))
            if alike
            else SECOND_ORDER * _largest(invariants, reference, steps)
        )
    own = invariants.own_sizes[:, 0]
    slacks = np.maximum(share * own, reaches) + floors(invariants, reference)
    return invariants.held_to(slacks[:, None])


def steps_of_wrong(
    steps: Mapping[Place, float], table: NumericTable, reference: Reference, tolerance: Tolerance
) -> dict[Place, float]:
    """Return how exactly a wrong answer was typed: what says too little, at least to within the tolerance.

    Beside lengths typed to the metre, what was left out would else count as right, and 0.1 for 0.05 anywhere.

    Args:
        steps: half a unit of the last place of its decimals.
        table: the answer.
        reference: the key.
        tolerance: what its poses are held to.
    """
    lengths, angles = tolerance.length * reference.size, tolerance.angle
    return {
        (i, cell): step
        if says_enough(step, getattr(table.rows[i], cell), cell)
        else min(step, angles if cell in ANGLES else lengths)
        for (i, cell), step in steps.items()
    }


def explained_by_digits(
    invariants: Invariants,
    reference: Reference,
    table: NumericTable,
    steps: Mapping[Place, float],
    policy: Policy,
    share: float,
) -> Invariants:
    """Return some invariants of the key, each with the slack that the digits of an answer explain.

    Args:
        invariants: of the key.
        reference: the key.
        table: the answer, with the key's joints.
        steps: half a unit of the last place of its decimals.
        policy: what the answer is held to.
        share: by which part of itself an invariant may be off.
    """
    reaches = _reaches(invariants.sizes(measured_as_typed(invariants, table, steps, policy)))
    slacks = np.maximum(share * invariants.own_sizes[:, 0], reaches) + floors(invariants, reference)
    return replace(invariants, slacks=slacks[:, None])


def _largest(invariants: Invariants, reference: Reference, steps: Mapping[Place, float]) -> Floats:
    """How far invariants may move at the most, whatever the table: angles at the longest of levers."""
    lengths = sum(step for (_, cell), step in steps.items() if cell in LENGTHS)
    angles = sum(step for (_, cell), step in steps.items() if cell in ANGLES)
    return np.array(
        [angles if shape.is_angle else lengths + angles * reference.size for shape in invariants.shapes]
    )


def measured_as_typed(
    invariants: Invariants, table: NumericTable, steps: Mapping[Place, float], policy: Policy
) -> Floats:
    """Return (q, 1 + 2·steps) invariants of a table as typed, and with each decimal half a unit up and down.

    Digits that are finer than the arithmetic are left out.
    """
    longest = FINEST * max(max(abs(row.a), abs(row.d)) for row in table.rows) if steps else 0.0
    seen = tuple(one for one in steps.items() if one[1] > (FINEST if one[0][1] in ANGLES else longest))
    return _measured_as_typed(invariants.shapes, table, seen, fixing_frames(policy))


@lru_cache(maxsize=256)
def fixing_frames(policy: Policy) -> Policy:
    """Return a policy that fixes what another one does of frames 0 and N: all that invariants depend on."""
    return Policy(
        base=BaseRule.FRAME if policy.base is BaseRule.FRAME else BaseRule.FREE,
        tool=ToolRule.FRAME if policy.tool is ToolRule.FRAME else ToolRule.FREE,
    )


@lru_cache(maxsize=CACHED_TABLES)
def _measured_as_typed(
    shapes: tuple[Shape, ...], table: NumericTable, steps: tuple[tuple[Place, float], ...], policy: Policy
) -> Floats:
    variations: list[Variation] = [(0, ())]
    for (i, cell), step in steps:
        here = getattr(table.rows[i], cell)
        variations += (0, ((i, cell, here + step),)), (0, ((i, cell, here - step),))
    return measured_of_tables(shapes, (table,), variations, policy)


def _reaches(sizes: Floats) -> Floats:
    """How far invariants may move when every decimal moves by half a unit of its last place."""
    return np.asarray(_moves(sizes).sum(axis=1), dtype=np.float64)


def _largest_moves(sizes: Floats) -> Floats:
    """The same with what they do together; what the one that matters most does alone is measured exactly."""
    moves = _moves(sizes)
    alone = moves.max(axis=1, initial=0.0)
    return np.asarray(alone + SECOND_ORDER * (moves.sum(axis=1) - alone), dtype=np.float64)


def _moves(sizes: Floats) -> Floats:
    """(q, steps) how far each decimal moves invariants, half a unit of its last place up or down."""
    moved = np.abs(sizes[:, 1:] - sizes[:, :1])
    return np.asarray(np.maximum(moved[:, 0::2], moved[:, 1::2]), dtype=np.float64)
