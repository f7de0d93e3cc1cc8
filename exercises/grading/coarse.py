"""Answers that are right as far as they were typed, but rounded more than the exercise allows."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from exercises.grading.axis_directions import fixed_ends
from exercises.grading.edits.own_table import is_length_of
from exercises.grading.edits.repaired import Repaired
from exercises.grading.edits.throughout import as_the_key_has_them
from exercises.grading.edits.work import WORK_OF_ONE_EDIT, Work
from exercises.grading.facts import Facts
from exercises.grading.judging.digits import SECOND_ORDER, explained_by_digits
from exercises.grading.judging.judgement import judged, share_of
from exercises.grading.judging.typed import SAME, Place, says_enough
from kinematics.chain import chain_of_table
from kinematics.equivalence import Tolerance
from kinematics.equivalence.decision import is_certified
from kinematics.equivalence.invariants import axes_of
from kinematics.equivalence.meter import Meter
from kinematics.equivalence.search import Effort
from kinematics.table import ANGLES, NumericTable


def is_rounded_too_much(work: Work) -> bool:
    """Whether the digits of a wrong answer explain all that is wrong in it.

    Every decimal may be off by half a unit of its last place, up to a quarter of itself. A zero stands for
    itself, so that what was left out is not taken for rounded, and so does a lone 1: it is no 0.8.

    Args:
        work: the answer as it was meant, and the key.
    """
    steps = _telling_steps(work)
    if not steps or not work.has_the_joints():
        return False
    draws = range(len(work.references))
    return all(_has_the_facts(work.at(draw), steps) for draw in draws) and _keeps_rules(work, steps)


def is_right_with_more_digits(work: Work, repairs: Sequence[Repaired]) -> bool:
    """Return whether a table that rounds to a wrong answer is right.

    Where the right robot breaks a rule, all half units together say too little: a point at the end may be
    off by the sum of them for another reason. So a table is found: a repair that moves decimals by no more
    than half a unit of their last place, or the answer with all the digits of the key's lengths. What is one
    of these to its last digit is not rounded.

    Args:
        work: the answer as it was meant, and the key.
        repairs: what mends the answer.
    """
    if work.comparison.in_names:
        return False
    rows, key = work.table.rows, work.reference.table
    steps = {
        (i, cell): step
        for (i, cell), step in _telling_steps(work).items()
        if cell in ANGLES or not is_length_of(key, getattr(rows[i], cell), SAME)
    }
    if any(_adds_digits(repair, work.table, steps) for repair in repairs):
        return True
    exact = as_the_key_has_them(work)
    return exact is not None and judged(exact, work.policy).accepted


def _adds_digits(repair: Repaired, table: NumericTable, steps: Mapping[Place, float]) -> bool:
    """Whether a repair changes nothing but decimals, by no more than half a unit of their last place."""
    if any(change.table is not None or not change.cells for change in repair.changes):
        return False
    return all(
        abs(value - getattr(table.rows[i], cell)) <= steps.get((i, cell), 0.0) * (1.0 + SAME)
        for change in repair.changes
        for i, cell, value in change.cells
    )


def _telling_steps(work: Work) -> dict[Place, float]:
    """Half a unit of the last place of the decimals beside which that is small."""
    rows = work.table.rows
    return {
        (i, cell): step
        for (i, cell), step in work.comparison.steps.items()
        if says_enough(step, getattr(rows[i], cell), cell)
    }


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
