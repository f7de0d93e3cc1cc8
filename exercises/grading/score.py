"""How much of a wrong answer is right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from exercises.grading.across_prismatic import across_prismatic
from exercises.grading.edits.changes import Change, Extent, with_joints_mended
from exercises.grading.edits.repairs import Repaired
from exercises.grading.edits.table_edits import hides_an_entry
from exercises.grading.edits.work import WORK_OF_ONE_EDIT, Work
from exercises.grading.facts import Facts, Floats, Weights, fixed_ends
from exercises.grading.judging.digits import measured_as_typed, tightened
from exercises.grading.judging.typed import NOTHING_TYPED, SAME
from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.chain import Axis, chain_of_table
from kinematics.equivalence import Decision, DirectionRule, Kind, Policy, ZeroRule
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.decision import convention_fits, is_certified
from kinematics.equivalence.invariants import axes_of
from kinematics.equivalence.meter import Meter
from kinematics.equivalence.reference import Reference, prepared
from kinematics.equivalence.search import Effort
from kinematics.se3 import ORIGIN, Z_AXIS
from kinematics.table import Convention, JointType, NumericTable

HIGHEST_PARTIAL = 0.95
"""What a wrong answer earns at the most."""
DECIMALS = 2
"""What is shown of a score."""
RULES = frozenset({Kind.ZERO, Kind.DIRECTION, Kind.CONVENTION})
OF_A_TYPE = 2.0
"""How often the weight of a joint its type counts: an arm with another joint there is another kind of arm."""
MOST_OF_A_JOINT = 0.5
"""What a joint takes at the most of what is right beside it: a short arm has no more facts than joints."""
CELL = 1.0
"""What a slip in a cell costs, in facts of weight 1."""
SIGNS = frozenset({"alpha_sign", "a_sign", "d_sign", "variable_sign"})


def score_of(decision: Decision, repairs: Sequence[Repaired], work: Work, weights: Weights) -> float:
    """Return the partial credit of a wrong answer, in [0, 0.95].

    The facts that the answer has wrong, over those that a table of zeros has wrong, taken from 1. Where one
    named slip explains everything, or one of a joint and another, the answer loses no more than they cost;
    nor where its robot is the key's but for one twist: among prismatic joints it takes lengths with it, and
    one edit undoes it in some frames only.

    Args:
        decision: what was decided.
        repairs: what mends the answer, the likeliest first.
        work: the answer as it was meant, and the key.
        weights: what facts and slips are worth.
    """
    standard = _standard(work.reference, work.policy, weights)
    nothing = standard.nothing
    slip = repairs[0].changes[0] if repairs and len(repairs[0].changes) == 1 else None
    throughout = slip is not None and _is_throughout(slip) and not hides_an_entry(work, slip)
    if not nothing or not standard.facts.axes or (not throughout and _has_no_more_than_zeros(work, standard)):
        return 0.0
    singles = [repair.changes for repair in repairs if len(repair.changes) == 1]
    if slip is not None and all(_is_nothing_beside_a_row(work, change, standard) for change in singles):
        return 0.0
    off = max(weights.sign, lost(decision, work, weights))
    if off > CELL:
        off -= _shared_across_prismatic(work, standard)
    if slip is not None and not _is_of_length_or_turn(slip):
        off = min(off, max(_cost(slip, weights, nothing), _size_across_prismatic(work, standard, slip)))
    elif slip is not None:
        off = min(off, max(CELL, _wrong(work, standard) - _shared_across_prismatic(work, standard)))
    elif not work.has_the_joints():
        pairs = [repair.changes for repair in repairs if _is_something(work, repair.changes, standard)]
        off = min([off, *(sum(_cost(change, weights, nothing) for change in pair) for pair in pairs)])
    if off > CELL and _has_one_other_twist(work):
        off = CELL
    return round(min(max(1.0 - off / nothing, 0.0), HIGHEST_PARTIAL), DECIMALS)


def marks_to_earn(key: NumericTable, policy: Policy, weights: Weights) -> float:
    """Return the weight of what a table of zeros has wrong; without any, no wrong answer earns anything."""
    return _standard(prepared(key), policy, weights).nothing


def _cost(change: Change, weights: Weights, nothing: float) -> float:
    """What the slip costs that a change undoes, in facts.

    One in a row or throughout the table leaves half of what a table of zeros loses, which has not one such
    thing right: two names exchanged are all the facts of a SCARA, those of a joint and its neighbours all of
    a short arm, and still it is one slip.
    """
    if change.code in SIGNS:
        return weights.sign
    if change.extent is Extent.CELL:
        return CELL
    return min(weights.row if change.extent is Extent.ROW else weights.table, nothing / 2.0)


def _is_of_length_or_turn(change: Change) -> bool:
    """Whether a change is of one cell that does not turn an axis against the one before it."""
    return (
        change.code not in SIGNS
        and change.extent is Extent.CELL
        and all(cell != "alpha" for _, cell in change.places)
    )


@lru_cache(maxsize=32)
def _shared_across_prismatic(work: Work, standard: _Standard) -> float:
    """By how much less the facts weigh if what is wrong across one group of prismatic joints counts as one.

    How two axes with prismatic joints between them lie to each other is up to three facts: a distance, an
    offset and a turn. One edit mends all of them in some frames, in others two do; the mark is the same.
    """
    wrong, least = _wrong(work, standard), 0.0
    for without in _without_each_gap(standard):
        least = max(least, wrong - _wrong(work, without) - CELL)
    return least


def _size_across_prismatic(work: Work, standard: _Standard, slip: Change) -> float:
    """What another sign of a length costs where it changes a distance across prismatic joints.

    In what rows that distance stands depends on where the prismatic joints were drawn, and whether a sign
    mends it.
    """
    if slip.code not in ("a_sign", "d_sign"):
        return 0.0
    wrong = _wrong(work, standard)
    across = [wrong - _wrong(work, without) for without in _without_each_gap(standard)]
    return min(CELL, max(across, default=0.0))


def _without_each_gap(standard: _Standard) -> list[_Standard]:
    """The standard without what lies across prismatic joints, for each group of them."""
    facts = standard.facts
    return [
        standard._replace(facts=replace(facts, worth=np.where(of_gap, 0.0, facts.worth)))
        for of_gap in across_prismatic(facts)
    ]


def _is_throughout(change: Change) -> bool:
    return change.extent is Extent.TABLE or change.code == "parameters_swapped"


def _has_one_other_twist(work: Work) -> bool:
    """Whether the key is the answer's robot if one of its twists is another."""
    table, answer = work.reference.table, chain_of_table(work.table)
    if not work.has_the_joints():
        return False
    ours, theirs = (_cosines(chain.axes) for chain in (work.reference.chain, answer))
    other = np.flatnonzero(np.abs(np.abs(ours) - np.abs(theirs)) > work.policy.tolerance.angle)
    if len(other) != 1:
        return False
    joints = [i for i, row in enumerate(table.rows) if row.joint is not JointType.FIXED]
    before, behind = joints[other[0]], joints[other[0] + 1]
    between = (
        range(before, behind) if table.convention is Convention.STANDARD else range(before + 1, behind + 1)
    )
    angle = float(np.arccos(np.clip(theirs[other[0]], -1.0, 1.0)))
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


def _cosines(axes: Sequence[Axis]) -> Floats:
    """(n - 1,) the cosines of the angles between neighbouring axes."""
    directions = np.array([axis.direction for axis in axes]).reshape(-1, 3)
    return np.asarray((directions[:-1] * directions[1:]).sum(axis=1), dtype=np.float64)


def _twisted(table: NumericTable, row: int, alpha: float) -> NumericTable:
    rows = list(table.rows)
    rows[row] = replace(rows[row], alpha=alpha)
    return replace(table, rows=tuple(rows))


def _has_no_more_than_zeros(work: Work, standard: _Standard) -> bool:
    """Whether a table of zeros has as many facts: that one length would mend it is no merit of it."""
    if not standard.of_zeros or not work.has_the_joints():
        return False
    return _wrong(work, standard) >= standard.of_zeros - SAME


def _is_nothing_beside_a_row(work: Work, changes: Sequence[Change], standard: _Standard) -> bool:
    """Whether an answer lacks a row and the others have no more than zeros: it would bring all facts."""
    return changes[0].code == "row_missing" and not _is_something(work, changes, standard)


def _is_something(work: Work, changes: Sequence[Change], standard: _Standard) -> bool:
    """Whether an answer of which one joint is wrong has more than zeros, once that joint stands there."""
    table = with_joints_mended(work.table, changes, work.reference.table.joint_types)
    completed = replace(work, table=table, comparison=replace(work.comparison, steps=NOTHING_TYPED))
    return completed.has_the_joints() and not _has_no_more_than_zeros(completed, standard)


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
    if not axes or not facts.axes:
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


@cached_by_size(
    lambda reference, policy, weights: len(reference.table.rows), longest=USUAL_ROWS, most=1024, few=32
)
def _standard(reference: Reference, policy: Policy, weights: Weights) -> _Standard:
    """The facts of a key; those that a table of zeros has for nothing weigh no more than the others together.

    A SCARA has two facts to earn, its lengths, and seven for nothing: if each of these cost as much as a
    length, a forgotten row would leave nothing of the other three.
    """
    invariants = tightened(reference, None, {}, policy, 0.0)
    worth = np.array([weights.of(shape.measure) for shape in invariants.shapes], dtype=np.float64)
    axes = axes_of(reference.chain, policy)
    facts = Facts(axes, invariants, fixed_ends(len(axes), policy), worth, weights.sign)
    rules = weights.rule * _unconfirmed(policy)
    if not facts.axes:
        return _Standard(facts, 0.0, rules)
    zeros = [Axis(axis.prismatic, Z_AXIS, ORIGIN) for axis in facts.axes]
    found = invariants.measured(axis_batch([zeros]))
    given = facts.shared(zeros, found)
    all_given = float(worth[given].sum()) + weights.joint * len(reference.chain.axes)
    share = min(1.0, (facts.wrong(zeros, found) + rules) / all_given) if all_given else 1.0
    facts = replace(facts, worth=np.where(given, share * worth, worth))
    wrong = facts.wrong(zeros, found)
    if wrong:
        joint, other = (
            min(cost / wrong, MOST_OF_A_JOINT) for cost in (weights.joint, OF_A_TYPE * weights.joint)
        )
        facts = replace(facts, to_earn=wrong, joint=joint, type=other)
    return _Standard(facts, wrong, wrong + rules)
