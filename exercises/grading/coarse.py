"""Answers that are right as far as they were typed, but rounded more than the exercise allows."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from exercises.grading.axis_directions import fixed_ends
from exercises.grading.edits.work import WORK_OF_ONE_EDIT, Work
from exercises.grading.facts import Facts
from exercises.grading.judging.digits import SECOND_ORDER, explained_by_digits
from exercises.grading.judging.judgement import share_of
from exercises.grading.judging.typed import Place, says_enough
from kinematics.chain import chain_of_table
from kinematics.equivalence import Tolerance
from kinematics.equivalence.decision import is_certified
from kinematics.equivalence.invariants import axes_of
from kinematics.equivalence.meter import Meter
from kinematics.equivalence.search import Effort
from kinematics.table import ANGLES


def is_rounded_too_much(work: Work) -> bool:
    """Whether the digits of a wrong answer explain all that is wrong in it.

    Every decimal may be off by half a unit of its last place, up to a quarter of itself. A zero stands for
    itself, so that what was left out is not taken for rounded, and so does a lone 1: it is no 0.8.

    Args:
        work: the answer as it was meant, and the key.
    """
    rows = work.table.rows
    steps = {
        (i, cell): step
        for (i, cell), step in work.comparison.steps.items()
        if says_enough(step, getattr(rows[i], cell))
    }
    if not steps or not work.has_the_joints():
        return False
    draws = range(len(work.references))
    return all(_has_the_facts(work.at(draw), steps) for draw in draws) and _keeps_rules(work, steps)


def _has_the_facts(work: Work, steps: Mapping[Place, float]) -> bool:
    """Whether the answer has the key's facts, with their signs, as far as its digits go."""
    reference, policy = work.reference, work.policy
    invariants = explained_by_digits(
        work.invariants, reference, work.table, steps, policy, share_of(work.comparison)
    )
    axes = axes_of(reference.chain, policy)
    worth = np.ones(len(invariants.shapes))
    facts = Facts(axes, invariants, fixed_ends(len(axes), policy), worth, sign=1.0)
    return not facts.wrong(axes_of(work.chain, policy))


def _keeps_rules(work: Work, steps: Mapping[Place, float]) -> bool:
    """Whether the answer is the robot under all rules, at the tolerance that matches its digits."""
    angle = SECOND_ORDER * sum(step for (_, cell), step in steps.items() if cell in ANGLES)
    length = SECOND_ORDER * sum(step for (_, cell), step in steps.items() if cell not in ANGLES)
    usual, size = work.policy.tolerance, work.reference.size
    tolerance = Tolerance(length=max(usual.length, length / size + angle), angle=max(usual.angle, angle))
    chains = [chain_of_table(table) for table in work.comparison.meant]
    policy, meter = replace(work.policy, tolerance=tolerance), Meter(WORK_OF_ONE_EDIT)
    with meter.at_most(WORK_OF_ONE_EDIT):
        return is_certified(work.references, chains, policy, Effort.REFINED, meter)
    return False
