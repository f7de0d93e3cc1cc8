"""What answers are measured by: the facts of a key, and what those weigh that an answer has wrong."""

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from exercises.grading.across_prismatic import across_prismatic
from exercises.grading.axis_directions import fixed_ends
from exercises.grading.edits.changes import Change
from exercises.grading.edits.joint_places import from_both_ends
from exercises.grading.edits.work import Work
from exercises.grading.facts import Facts, Weights
from exercises.grading.judging.digits import fixing_frames, measured_as_typed, tightened
from exercises.grading.judging.typed import NOTHING_TYPED
from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.chain import Axis
from kinematics.equivalence import DirectionRule, Policy, ZeroRule
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.invariants import axes_of
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.row_measures import measured_of_tables
from kinematics.se3 import ORIGIN, Z_AXIS
from kinematics.table import JointType

OF_A_TYPE = 2.0
"""How often the weight of a joint its type counts: an arm with another joint there is another kind of arm."""
MOST_OF_A_JOINT = 0.5
"""What a joint takes at the most of what is right beside it: a short arm has no more facts than joints."""
CELL = 1.0  # What a slip in a cell costs, in facts of weight 1.


class Standard(NamedTuple):
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
def standard_of(reference: Reference, policy: Policy, weights: Weights) -> Standard:
    """Return a key's facts; those that a table of zeros has right weigh no more than the others together.

    A SCARA has two facts to earn, its lengths, and seven for nothing: if each of these cost as much as a
    length, a forgotten row would leave nothing of the other three.
    """
    invariants = tightened(reference, None, {}, policy, 0.0)
    worth = np.array([weights.of(shape.measure) for shape in invariants.shapes], dtype=np.float64)
    axes = axes_of(reference.chain, policy)
    facts = Facts(axes, invariants, fixed_ends(len(axes), policy), worth, weights.sign)
    rules = weights.rule * unconfirmed(policy)
    if not facts.axes:
        return Standard(facts, 0.0, rules)
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
        earned = np.where(given, 0.0, worth)
        facts = replace(facts, to_earn=wrong, earned=earned, joint=joint, type=other)
    return Standard(facts, wrong, wrong + rules)


@lru_cache(maxsize=32)
def wrong_of(work: Work, standard: Standard) -> float:
    """Return the weight of the wrong facts; the score asks for it twice."""
    facts = replace(standard.facts, invariants=work.facts)
    axes = axes_of(work.chain, work.policy)
    if not axes or not facts.axes:
        return standard.nothing
    found = None
    if len(axes) == len(facts.axes):
        is_answer = work.table is work.comparison.meant[work.draw]  # of which it is known with each digit off
        steps = work.comparison.steps if is_answer else NOTHING_TYPED
        found = measured_as_typed(facts.invariants, work.table, steps, work.policy)[:, :1]
    elif abs(work.excess) == 1:
        counted = from_both_ends(facts.invariants.shapes, (work.table,), work.excess, work.policy)
        found = counted[:, :: -work.excess]  # by growing shift
    return facts.wrong(axes, found)


def at_least_lost(work: Work, changes: Sequence[Change], standard: Standard) -> list[float]:
    """Return the least that the facts weigh which a table has wrong after each of some changes.

    They leave it as many joints as the key has. What is wrong across one group of prismatic joints counts as
    no more than one.
    """
    facts = replace(standard.facts, invariants=work.facts)
    tables, variations = [work.table], []
    for change in changes:
        tables += () if change.table is None else (change.table,)
        variations.append((0 if change.table is None else len(tables) - 1, change.cells))
    joints = [tables[number].joint_types for number, _ in variations]
    types = [[False, *(joint is JointType.PRISMATIC for joint in each), False] for each in joints]
    found = measured_of_tables(facts.invariants.shapes, tables, variations, fixing_frames(work.policy))
    least = facts.at_least_wrong(found, types)
    spare = max((float(facts.worth[of_gap].sum()) for of_gap in across_prismatic(facts)), default=0.0)
    lost: list[float] = (least - max(spare - CELL, 0.0)).tolist()
    return lost


def unconfirmed(policy: Policy) -> int:
    """Return how many rules only the right robot can be seen to keep."""
    return (policy.zero is ZeroRule.FIGURE) + (policy.direction is DirectionRule.FIGURE)


@lru_cache(maxsize=32)
def shared_across_prismatic(work: Work, standard: Standard) -> float:
    """Return how much less the facts weigh if all wrong ones across a group of prismatic joints are one.

    How two axes with prismatic joints between them lie to each other is up to three facts: a distance, an
    offset and a turn. One edit mends all of them in some frames, in others two do; the score is the same.
    """
    wrong, least = wrong_of(work, standard), 0.0
    for without in _without_each_gap(standard):
        least = max(least, wrong - wrong_of(work, without) - CELL)
    return least


def _without_each_gap(standard: Standard) -> list[Standard]:
    """The standard without what lies across prismatic joints, for each group of them."""
    facts = standard.facts
    return [
        standard._replace(
            facts=replace(facts, worth=np.where(of_gap, 0.0, facts.worth), earned=facts.earned * ~of_gap)
        )
        for of_gap in across_prismatic(facts)
    ]
