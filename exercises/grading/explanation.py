"""What a wrong answer gets: where, what and why, as far as the help level goes, and its partial credit.

An explanation is optional: if it fails, the verdict remains, the failure is logged, and less is told.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import NamedTuple

from exercises.grading.coarse import is_right_with_more_digits, is_rounded_too_much
from exercises.grading.edits.accused import accused, own_table_first
from exercises.grading.edits.changes import Change
from exercises.grading.edits.repaired import Repaired
from exercises.grading.edits.repairs import MOST_WORK, find_repairs
from exercises.grading.edits.table_edits import hides_an_entry
from exercises.grading.edits.throughout import ROUNDED, seen_throughout
from exercises.grading.edits.work import Work
from exercises.grading.facts import Weights
from exercises.grading.findings import feedback_of, link_findings, told_repairs, told_throughout, wrong_facts
from exercises.grading.judging.comparison import Comparison
from exercises.grading.judging.digits import measured_as_typed, steps_of_wrong, tightened
from exercises.grading.judging.end_lines import end_invariants, lines_at_ends
from exercises.grading.judging.judgement import (
    IMPRECISE,
    REFUTED,
    diagnosed,
    lacks_precision,
    policy_of,
    share_of,
)
from exercises.grading.judging.typed import NOTHING_TYPED, SAME
from exercises.grading.score import DECIMALS, lost, score_of
from exercises.grading.standard import standard_of
from exercises.grading.verdict import Feedback, HelpLevel, LinkFinding, Repair
from kinematics.cells import ReadTable
from kinematics.equivalence import Decision, Kind, Policy
from kinematics.equivalence.home_invariants import home_invariants_of
from kinematics.equivalence.invariants import Invariants
from kinematics.equivalence.meter import Meter
from kinematics.equivalence.reference import prepared_for

_LOG = logging.getLogger(__name__)
WORK_OF_READINGS = 90_000
"""What telling readings apart by their repairs may cost: a third of what repairing one of them may."""
CACHED_WAYS = 32  # More than the ways in which one answer may be meant.


@dataclass(frozen=True, kw_only=True, slots=True)
class Explanation:
    """What is said of a wrong answer; see `Verdict`."""

    score: float
    links: tuple[LinkFinding, ...]
    feedback: tuple[Feedback, ...]
    repairs: tuple[Repair, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Diagnosis:
    """What is wrong with an answer and what it earns, however much of it may be told.

    Attributes:
        decision: what was decided, with what does not fit.
        repairs: what would mend the answer.
        score: what it still earns.
        work: what it was found on.
        throughout: what is wrong in the whole table, where the rest is told as if that were undone.
    """

    decision: Decision
    repairs: tuple[Repaired, ...]
    score: float
    work: Work
    throughout: Change | None = None


class Refused(NamedTuple):
    """What was decided of a wrong answer.

    Attributes:
        decision: the decision.
        comparison: in which way the answer was taken.
        repairs: all that mends it, where they were found in telling that way from others.
    """

    decision: Decision
    comparison: Comparison
    repairs: tuple[Repaired, ...] | None


def diagnosis(
    refused: Refused, tables: tuple[ReadTable, ReadTable], policy: Policy, weights: Weights
) -> Diagnosis:
    """Find what is wrong with an answer, by a counted amount of work.

    Args:
        refused: what was decided.
        tables: the key and the answer as read.
        policy: what the answer is held to.
        weights: what facts and slips are worth.
    """
    decision, comparison, known = refused
    work, meter = work_on(comparison, tables, policy), Meter(MOST_WORK)
    repairs: tuple[Repaired, ...] = known or ()
    score = 0.0
    try:
        if decision is not IMPRECISE and known is None:
            repairs = find_repairs(replace(work, meter=meter))
        if decision.same_robot and is_right_with_more_digits(work, repairs):
            decision, repairs = IMPRECISE, ()
    except Exception:
        _LOG.exception("no repairs")
    try:
        if decision is REFUTED and not repairs:
            decision = diagnosed(comparison, policy)
    except Exception:
        _LOG.exception("no diagnosis")
    try:
        score = score_of(decision, repairs, work, weights)
    except Exception:
        _LOG.exception("no score")
    found = Diagnosis(decision=decision, repairs=repairs, score=score, work=work)
    if repairs or decision.same_robot or lacks_precision(decision):
        return found
    try:
        return _beside_throughout(found, tables, policy, weights, Meter(min(meter.left, MOST_WORK // 2)))
    except Exception:
        _LOG.exception("it is not known what is wrong throughout")
        return found


def _beside_throughout(
    found: Diagnosis, tables: tuple[ReadTable, ReadTable], policy: Policy, weights: Weights, meter: Meter
) -> Diagnosis:
    """What is wrong throughout, a unit or too few digits, and what is found beside it, by the work left."""
    seen = seen_throughout(found.work)
    if seen is None:
        return found
    change, comparison = seen
    rest, score = work_on(comparison, tables, policy), found.score
    decision = found.decision if rest.excess else diagnosed(comparison, policy)
    repairs = find_repairs(replace(rest, meter=meter))
    if change.code == ROUNDED:
        digits = weights.sign / standard_of(rest.reference, policy, weights).nothing
        score = max(score, round(score_of(decision, repairs, rest, weights) - digits, DECIMALS))
    else:
        repairs = tuple(Repaired((change, *repaired.changes)) for repaired in repairs)
    return Diagnosis(decision=decision, repairs=repairs, score=score, work=found.work, throughout=change)


def explanation(found: Diagnosis, policy: Policy, level: HelpLevel) -> Explanation:
    """Explain why an answer is wrong, as far as may be told."""
    work = found.work
    repairs: Sequence[Repaired] = found.repairs
    links: tuple[LinkFinding, ...] = ()
    feedback: tuple[Feedback, ...] = (Feedback(code="not_equivalent"),)
    try:
        repairs = sorted(repairs, key=lambda one: any(hides_an_entry(work, change) for change in one.changes))
        repairs = own_table_first(repairs, work.table, work.reference.table)
        links, feedback = _told(found.decision, repairs, work, policy, level)
        first = found.throughout
        if first is not None and not any(first in repaired.changes for repaired in repairs):
            feedback, repairs = (*feedback[:1], *told_throughout(first, level), *feedback[1:]), ()
    except Exception:
        _LOG.exception("no findings")
        repairs = ()
    return Explanation(
        score=found.score, links=links, feedback=feedback, repairs=told_repairs(repairs, level)
    )


def clearest(
    decisions: Sequence[Decision],
    ways: Sequence[Comparison],
    tables: tuple[ReadTable, ReadTable],
    policy: Policy,
) -> Refused:
    """Return the best reading of a wrong answer: one of the right robot, else the one with least wrong.

    One that is only imprecise has nothing wrong. One wrong name among numbers so leaves the numbers what they
    are: values of names. Where the facts are as wrong in several, as with the wrong convention in all, it is
    the one that the fewest edits mend.

    Args:
        decisions: what was decided.
        ways: the ways in which the answer may be meant.
        tables: the key and the answer as read.
        policy: what the answer is held to.
    """
    right = [i for i, decision in enumerate(decisions) if decision.same_robot]
    right = right or [i for i, decision in enumerate(decisions) if decision is IMPRECISE]
    best, which, repairs = min(right, default=0), 0, None
    if not right and len(ways) > 1:
        try:
            works = [work_on(way, tables, policy) for way in ways]
            off = [lost(*one, Weights()) for one in zip(decisions, works, strict=True)]
            least = [i for i, weight in enumerate(off) if weight <= min(off) + SAME]
            if len(least) > 1:
                which, repairs = _soonest_mended([works[i] for i in least])
            best = least[which]
        except Exception:
            _LOG.exception("no way is clearer than another")
    return Refused(decisions[best], ways[best], repairs)


def _soonest_mended(works: Sequence[Work]) -> tuple[int, tuple[Repaired, ...] | None]:
    """Return which reading the fewest edits mend: the first of them, if several are as near; and these.

    They are all that mends it; None where the work ran out, or two edits were not looked for.
    """
    best, fewest = 0, math.inf
    known: tuple[Repaired, ...] | None = None
    for i, work in enumerate(works):
        meter, pairs = Meter(WORK_OF_READINGS // len(works)), math.isinf(fewest)
        repairs = find_repairs(replace(work, meter=meter), pairs=pairs)
        edits = len(repairs[0].changes) if repairs else math.inf
        if edits < fewest or not i:
            best, fewest = i, edits
            known = repairs if pairs and not meter.ran_out else None
        if fewest == 1:
            break
    return best, known


def as_typed(
    decision: Decision, comparison: Comparison, tables: tuple[ReadTable, ReadTable], policy: Policy
) -> Decision:
    """Return what is decided of a wrong answer: that its digits are too few, where they explain the rest.

    Args:
        decision: what was decided.
        comparison: in which way the answer was taken.
        tables: the key and the answer as read.
        policy: what the answer is held to.
    """
    if decision is REFUTED or decision.same_robot or not comparison.steps:
        return decision
    try:
        return IMPRECISE if is_rounded_too_much(work_on(comparison, tables, policy)) else decision
    except Exception:
        _LOG.exception("it is not known how the answer was rounded")
        return decision


@lru_cache(maxsize=CACHED_WAYS)
def work_on(comparison: Comparison, tables: tuple[ReadTable, ReadTable], policy: Policy) -> Work:
    """Return the key and an answer, with what edits of it are tried against.

    Remembered: ways in which an answer may be meant are compared by it, and the clearest is repaired.
    """
    strict = policy_of(comparison, policy)
    share = share_of(comparison)
    references = tuple(
        prepared_for(key, answer) for key, answer in zip(comparison.references, comparison.meant, strict=True)
    )

    @cache
    def at(draw: int, lines: frozenset[Kind]) -> Invariants:
        key, table = references[draw], comparison.meant[draw]
        steps = steps_of_wrong(comparison.steps, table, key, strict.tolerance)
        facts = tightened(key, table, steps, strict, share)
        found = facts.beside(home_invariants_of(references[draw], strict))
        if not lines:
            return found
        fixing = lines_at_ends(strict, lines)
        for typed in (steps, NOTHING_TYPED):
            known = tightened(key, table, typed, fixing, share).beside(home_invariants_of(key, fixing))
            ends = end_invariants(known, table.n_joints, lines)
            if (ends.strains(measured_as_typed(ends, table, NOTHING_TYPED, fixing)) > 1.0).any():
                break
        return found.beside(ends)

    return Work(
        key=tables[0],
        answer=tables[1],
        comparison=comparison,
        policy=strict,
        table=comparison.meant[0],
        references=references,
        tightened=at,
        meter=Meter(MOST_WORK),
    )


def _told(
    decision: Decision, repairs: Sequence[Repaired], work: Work, policy: Policy, level: HelpLevel
) -> tuple[tuple[LinkFinding, ...], tuple[Feedback, ...]]:
    key, answer = work.reference.table, work.table
    told = accused(repairs, answer, key)
    wrong = wrong_facts(decision, told, answer)
    feedback = feedback_of(decision, told, wrong, key, answer, policy, level)
    return link_findings(answer, wrong, decision, told, level), feedback
