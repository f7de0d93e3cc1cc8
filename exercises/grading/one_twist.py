"""Whether all that is wrong with an answer is one twist, whatever entries it takes with it."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from exercises.grading.edits.changes import with_row
from exercises.grading.edits.work import WORK_OF_ONE_EDIT, Work
from kinematics.chain import Axis
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.decision import is_certified
from kinematics.equivalence.invariants import axes_of
from kinematics.equivalence.meter import Meter
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.search import Effort
from kinematics.se3 import Floats, angle_between
from kinematics.table import Convention, JointType, NumericTable


def has_one_other_twist(work: Work) -> bool:
    """Return whether the key is the answer's robot if one of its twists is another."""
    if not work.has_the_joints():
        return False
    table, answer = work.reference.table, work.chain
    ours, theirs = (_cosines(chain.axes) for chain in (work.reference.chain, answer))
    other = np.flatnonzero(np.abs(np.abs(ours) - np.abs(theirs)) > work.policy.tolerance.angle)
    if len(other) != 1 or not _has_every_twist_but(work, int(other[0])):
        return False
    joints = [i for i, row in enumerate(table.rows) if row.joint is not JointType.FIXED]
    before, behind = joints[other[0]], joints[other[0] + 1]
    between = (
        range(before, behind) if table.convention is Convention.STANDARD else range(before + 1, behind + 1)
    )
    # by its cosine, an axis parallel to the one before it would be turned by the root of a rounding error
    angle = angle_between(answer.axes[other[0]].direction, answer.axes[other[0] + 1].direction)
    others = [
        _twisted(table, row, alpha)
        for row in between
        for alpha in (angle, -angle, np.pi - angle, angle - np.pi)
    ]
    meter = Meter(WORK_OF_ONE_EDIT)
    with meter.at_most(WORK_OF_ONE_EDIT):
        return any(
            is_certified((prepared(other),), (answer,), work.policy, Effort.PLAIN, meter) for other in others
        )
    return False


def _has_every_twist_but(work: Work, joint: int) -> bool:
    """Whether the angles between all other neighbouring axes are the key's, to their digits."""
    facts, axes = work.facts, axes_of(work.chain, work.policy)
    off = (facts.strains(facts.measured(axis_batch([axes]))) > 1.0) & facts.arrays.twists
    # the base's place stands before the first joint
    across = (facts.arrays.first <= joint + 1) & (facts.arrays.last >= joint + 2)
    return not bool((off & ~across).any())


def _cosines(axes: Sequence[Axis]) -> Floats:
    """(n - 1,) the cosines of the angles between neighbouring axes."""
    directions = np.array([axis.direction for axis in axes]).reshape(-1, 3)
    return np.asarray((directions[:-1] * directions[1:]).sum(axis=1), dtype=np.float64)


def _twisted(table: NumericTable, row: int, alpha: float) -> NumericTable:
    return with_row(table, row, replace(table.rows[row], alpha=alpha))
