"""How much of a wrong answer is right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.repairs import Repaired
from exercises.grading.edits.work import Work
from exercises.grading.facts import Facts, Weights, fixed_ends
from exercises.grading.judging.digits import measured_as_typed, tightened
from kinematics.chain import Axis, chain_of_table
from kinematics.equivalence import Decision, DirectionRule, Kind, Policy, ZeroRule
from kinematics.equivalence.decision import convention_fits
from kinematics.equivalence.invariants import axes_of
from kinematics.equivalence.reference import Reference
from kinematics.remembering import USUAL_ROWS, remembered
from kinematics.se3 import ORIGIN, Z_AXIS

HIGHEST_PARTIAL = 0.95
"""What a wrong answer earns at the most."""
DECIMALS = 2
"""What is shown of a score."""
RULES = frozenset({Kind.ZERO, Kind.DIRECTION, Kind.CONVENTION})
SAME = 1e-9
SIGNS = frozenset({"alpha_sign", "a_sign", "d_sign", "variable_sign"})


def score_of(decision: Decision, repairs: Sequence[Repaired], work: Work, weights: Weights) -> float:
    """Return the partial credit of a wrong answer, in [0, 0.95].

    The facts that the answer has wrong, over those that a table of zeros has wrong, taken from 1. Where one
    named slip explains everything, the answer loses no more than that costs.

    Args:
        decision: what was decided.
        repairs: what mends the answer, the likeliest first.
        work: the answer as it was meant, and the key.
        weights: what facts and slips are worth.
    """
    standard = _standard(work.reference, work.policy, weights)
    nothing = standard.nothing
    slip = repairs[0].changes[0] if repairs and len(repairs[0].changes) == 1 else None
    throughout = slip is not None and _is_throughout(slip)
    if not nothing or (not throughout and _has_no_more_than_zeros(work, standard)):
        return 0.0
    off = max(weights.sign, lost(decision, work, weights))
    if slip is not None:
        off = min(off, _cost(slip, weights, nothing))
    return round(min(max(1.0 - off / nothing, 0.0), HIGHEST_PARTIAL), DECIMALS)


def _cost(change: Change, weights: Weights, nothing: float) -> float:
    """What the slip costs that a change undoes, in facts.

    One throughout the table leaves half of what a table of zeros loses, which has not one such thing right:
    two names exchanged are all the facts of a SCARA, and still one slip.
    """
    if change.code in SIGNS:
        return weights.sign
    cost = {Extent.CELL: 1.0, Extent.ROW: weights.row, Extent.TABLE: weights.table}[change.extent]
    return min(cost, nothing / 2.0) if _is_throughout(change) else cost


def _is_throughout(change: Change) -> bool:
    return change.extent is Extent.TABLE or change.code == "parameters_swapped"


def _has_no_more_than_zeros(work: Work, standard: _Standard) -> bool:
    """Whether a table of zeros has as many facts: that one length would mend it is no merit of it."""
    if not standard.of_zeros or not work.has_the_joints():
        return False
    return _wrong(work, standard) >= standard.of_zeros - SAME


def lost(decision: Decision, work: Work, weights: Weights) -> float:
    """Return the weight of the facts that are wrong, and of the rules that are not kept.

    A rule that the right robot does not keep costs at most half of what a table of zeros loses: where the
    rule `axis` has the second length of two links decide about the tool, the first one is still right.
    """
    policy, table = work.policy, work.table
    standard = _standard(work.reference, policy, weights)
    wrong = _wrong(work, standard)
    if decision.same_robot:
        broken = {mismatch.kind for mismatch in decision.mismatches}
        ends = bool(broken & {Kind.BASE, Kind.TOOL})
        return max(wrong, min(weights.rule, standard.nothing / 2.0) * (len(broken & RULES) + ends))
    rules = _unconfirmed(policy) + (not convention_fits(table.convention, policy.convention))
    return wrong + weights.rule * rules


@lru_cache(maxsize=32)
def _wrong(work: Work, standard: _Standard) -> float:
    """The weight of the facts that are wrong; asked for by what compares ways, and twice by the score."""
    facts = replace(standard.facts, invariants=work.facts)
    axes = axes_of(chain_of_table(work.table), work.policy)
    if not axes:
        return standard.nothing
    found = None
    if len(axes) == len(facts.axes):
        found = measured_as_typed(facts.invariants, work.table, work.comparison.steps, work.policy)[:, :1]
    return facts.wrong(axes, found)


def _unconfirmed(policy: Policy) -> int:
    """How many rules only the right robot can be seen to keep."""
    return (policy.zero is ZeroRule.FIGURE) + (policy.direction is DirectionRule.FIGURE)


class _Standard(NamedTuple):
    """What answers are measured by.

    Attributes:
        facts: the key's facts and what they are worth.
        of_zeros: the weight of those that a table of zeros has wrong, the types of its joints being right.
        nothing: that, and of the rules that nobody can see it keep.
    """

    facts: Facts
    of_zeros: float
    nothing: float


@remembered(
    lambda reference, policy, weights: len(reference.table.rows), longest=USUAL_ROWS, most=256, few=32
)
def _standard(reference: Reference, policy: Policy, weights: Weights) -> _Standard:
    """The facts of a key; those that a table of zeros has for nothing weigh no more than the others together.

    A SCARA has two facts to earn, its lengths, and seven for nothing: if each of these cost as much as a
    length, a forgotten row would leave nothing of the other three.
    """
    invariants = tightened(reference, None, {}, policy, 0.0)
    worth = np.array([weights.of(shape.measure) for shape in invariants.shapes], dtype=np.float64)
    axes = axes_of(reference.chain, policy)
    facts = Facts(axes, invariants, fixed_ends(len(axes), policy), worth, weights.joint, weights.sign)
    rules = weights.rule * _unconfirmed(policy)
    if not facts.axes:
        return _Standard(facts, 0.0, rules)
    zeros = [Axis(axis.prismatic, Z_AXIS, ORIGIN) for axis in facts.axes]
    given = facts.shared(zeros)
    all_given = float(worth[given].sum()) + weights.joint * len(reference.chain.axes)
    share = min(1.0, (facts.wrong(zeros) + rules) / all_given) if all_given else 1.0
    facts = replace(facts, worth=np.where(given, share * worth, worth), joint=share * weights.joint)
    wrong = facts.wrong(zeros)
    return _Standard(facts, wrong, wrong + rules)
