"""How much of a wrong answer is right."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from exercises.grading.digits import measured_as_typed, tightened
from exercises.grading.facts import Facts, Weights
from exercises.grading.repairs import Repaired
from exercises.grading.work import Change, Extent, Work
from kinematics.chain import Axis, chain_of_table
from kinematics.equivalence import BaseRule, Decision, DirectionRule, Kind, Policy, ToolRule, ZeroRule
from kinematics.equivalence.decision import convention_fits
from kinematics.equivalence.invariants import Invariants, axes_of
from kinematics.equivalence.reference import Reference
from kinematics.se3 import ORIGIN, Z_AXIS

HIGHEST_PARTIAL = 0.95
"""What a wrong answer earns at the most."""
MOST_OF_A_SLIP = 0.5
"""The share of the facts to be earned that a named slip in more than one cell costs at the most."""
DECIMALS = 2
"""What is shown of a score."""
RULES = frozenset({Kind.ZERO, Kind.DIRECTION, Kind.CONVENTION})
SIGNS = frozenset({"alpha_sign", "a_sign", "d_sign", "variable_sign"})


def score_of(decision: Decision, repairs: Sequence[Repaired], work: Work, weights: Weights) -> float:
    """Partial credit of a wrong answer, in [0, 0.95].

    The facts that the answer has wrong, over those that a table of zeros has wrong, taken from 1. Where one
    named slip explains everything, the answer loses no more than that costs.

    Args:
        decision: what was decided.
        repairs: what mends the answer, the likeliest first.
        work: the answer as it was meant, and the key.
        weights: what facts and slips are worth.
    """
    reference = work.reference
    nothing = _of_nothing(reference, work.policy, weights)
    if not nothing:
        return 0.0
    off = max(weights.sign, lost(decision, work, weights))
    if repairs and len(repairs[0].changes) == 1:
        off = min(off, _cost(repairs[0].changes[0], work, weights, nothing))
    return round(min(max(1.0 - off / nothing, 0.0), HIGHEST_PARTIAL), DECIMALS)


def _cost(change: Change, work: Work, weights: Weights, nothing: float) -> float:
    """What the slip costs that a change undoes, in facts.

    A robot of two lengths has no more facts to earn than the slip of a row costs; where some of them are
    right, a slip in more than one cell costs half of them at the most.
    """
    if change.extent is Extent.CELL:
        return weights.sign if change.code in SIGNS else 1.0
    cost = weights.row if change.extent is Extent.ROW else weights.table
    most = MOST_OF_A_SLIP * nothing
    return most if cost > most and _earns(work, weights) else cost


def _earns(work: Work, weights: Weights) -> bool:
    """Whether an answer has a fact that a table of zeros does not have."""
    facts = _facts(work.reference, work.invariants[0], work.policy, weights)
    axes = axes_of(chain_of_table(work.table), work.policy)
    if not axes:
        return False
    has = facts.shared(axes)
    return bool((has & ~facts.shared(_zeros(facts))).any())


def lost(decision: Decision, work: Work, weights: Weights) -> float:
    """The weight of the facts that are wrong, and of the rules that are not kept."""
    policy, reference, table = work.policy, work.reference, work.table
    facts = _facts(reference, work.invariants[0], policy, weights)
    axes = axes_of(chain_of_table(table), policy)
    found = None
    if len(axes) == len(facts.axes):
        found = measured_as_typed(facts.invariants, table, work.comparison.steps, policy)[:, :1]
    wrong = facts.wrong(axes, found) if axes else _of_nothing(reference, policy, weights)
    if decision.same_robot:
        broken = {mismatch.kind for mismatch in decision.mismatches}
        ends = bool(broken & {Kind.BASE, Kind.TOOL})
        return max(wrong, weights.rule * (len(broken & RULES) + ends))
    rules = _unconfirmed(policy) + (not convention_fits(table.convention, policy.convention))
    return wrong + weights.rule * (rules)


def _facts(reference: Reference, invariants: Invariants, policy: Policy, weights: Weights) -> Facts:
    fixed = policy.base is BaseRule.FRAME, policy.tool is ToolRule.FRAME
    return Facts(axes_of(reference.chain, policy), invariants, fixed, weights)


def _unconfirmed(policy: Policy) -> int:
    """How many rules only the right robot can be seen to keep."""
    return (policy.zero is ZeroRule.FIGURE) + (policy.direction is DirectionRule.FIGURE)


@lru_cache(maxsize=256)
def _of_nothing(reference: Reference, policy: Policy, weights: Weights) -> float:
    """The weight of the facts that a table of zeros has wrong, the types of its joints being right."""
    facts = _facts(reference, tightened(reference, None, {}, policy, 0.0), policy, weights)
    wrong = facts.wrong(_zeros(facts)) if facts.axes else 0.0
    return wrong + weights.rule * _unconfirmed(policy)


def _zeros(facts: Facts) -> list[Axis]:
    """The axes of a table of zeros with the key's types of joints."""
    return [Axis(axis.prismatic, Z_AXIS, ORIGIN) for axis in facts.axes]
