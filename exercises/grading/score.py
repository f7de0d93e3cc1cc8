"""How much of a wrong answer is right."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from exercises.grading.edits.changes import Change, Extent, with_joints_mended
from exercises.grading.edits.misconceptions import CATALOGUE
from exercises.grading.edits.repaired import Repaired
from exercises.grading.edits.table_edits import hides_an_entry
from exercises.grading.edits.work import Work
from exercises.grading.facts import Weights
from exercises.grading.judging.judgement import lacks_precision
from exercises.grading.judging.typed import SAME
from exercises.grading.one_twist import has_one_other_twist
from exercises.grading.standard import (
    CELL,
    Standard,
    at_least_lost,
    shared_across_prismatic,
    standard_of,
    unconfirmed,
    wrong_of,
)
from kinematics.equivalence import Decision, Kind, Policy
from kinematics.equivalence.decision import convention_fits
from kinematics.equivalence.reference import prepared
from kinematics.table import CELLS, JointType, NumericTable

HIGHEST_PARTIAL = 0.95  # What a wrong answer earns at the most.
DECIMALS = 2  # What is shown of a score.
RULES = frozenset({Kind.ZERO, Kind.DIRECTION, Kind.CONVENTION})
SIGNS = frozenset({"alpha_sign", "a_sign", "d_sign", "variable_sign"})


def score_of(decision: Decision, repairs: Sequence[Repaired], work: Work, weights: Weights) -> float:
    """Return the partial credit of a wrong answer, in [0, 0.95].

    The facts that the answer has wrong, over those that a table of zeros has wrong, taken from 1. Where one
    named slip explains everything, or one of a joint and another, the answer loses no more than they cost;
    nor where its robot is the key's but for one twist: among prismatic joints it takes lengths with it, and
    one edit undoes it in some frames only. Where nothing is wrong but for too few digits, that costs what a
    wrong sign does.

    Args:
        decision: what was decided.
        repairs: what mends the answer, the likeliest first.
        work: the answer as it was meant, and the key.
        weights: what facts and slips are worth.
    """
    standard = standard_of(work.reference, work.policy, weights)
    nothing = standard.nothing
    if not nothing or not standard.facts.axes:
        return 0.0
    if lacks_precision(decision):
        return _share_left(weights.sign, nothing)
    slip = repairs[0].changes[0] if repairs and len(repairs[0].changes) == 1 else None
    if slip is not None and _is_in_one_row(slip, work, 0.0, standard):
        slip = None
    throughout = slip is not None and slip.row is None and not hides_an_entry(work, slip)
    singles = [repair.changes for repair in repairs if len(repair.changes) == 1]
    if slip is not None and all(_is_nothing_beside_a_row(work, change, standard) for change in singles):
        return 0.0
    off = nothing
    if throughout or not _has_no_more_than_zeros(work, standard):
        off = max(weights.sign, lost(decision, work, weights))
        if off > CELL:
            off -= shared_across_prismatic(work, standard)
        if slip is not None and not _is_of_length_or_turn(slip):
            off = min(off, max(_cost(slip, weights, nothing), _size_beside_sign(work, standard, slip)))
        elif slip is not None:
            off = min(off, max(CELL, wrong_of(work, standard) - shared_across_prismatic(work, standard)))
        elif work.excess:
            off = _cost_of_a_pair(work, repairs, weights, standard, off)
        if off > CELL and has_one_other_twist(work):
            off = CELL
    if not decision.same_robot:
        if slip is None:
            off = _with_lines(off, work, weights, nothing)
        off = _lost_beside_a_slip(work, weights, standard, off)
    return _share_left(off, nothing)


def _share_left(off: float, nothing: float) -> float:
    return round(min(max(1.0 - off / nothing, 0.0), HIGHEST_PARTIAL), DECIMALS)


def weight_to_earn(key: NumericTable, policy: Policy, weights: Weights) -> float:
    """Return the weight of what a table of zeros has wrong; without any, no wrong answer earns anything."""
    return standard_of(prepared(key), policy, weights).nothing


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


def _cost_of_a_pair(
    work: Work, repairs: Sequence[Repaired], weights: Weights, standard: Standard, most: float
) -> float:
    """What is lost, if less than so much, by edits that mend an answer with joints too many or too few."""
    nothing = standard.nothing
    costs = [sum(_cost(change, weights, nothing) for change in repair.changes) for repair in repairs]
    for cost, repair in sorted(zip(costs, repairs, strict=True), key=lambda pair: pair[0]):
        if cost >= most or _is_something(work, repair.changes, standard):
            return min(cost, most)
    return most


def _lost_beside_a_slip(work: Work, weights: Weights, standard: Standard, most: float) -> float:
    """What is lost, if less than so much, by a slip in a row or throughout the table and the facts beside it.

    Such a slip may make all facts wrong, as the wrong convention does, though few of them are mistakes.
    """
    if work.excess or most <= min(weights.row, weights.table, standard.nothing / 2.0) + weights.sign:
        return most
    undone = []
    for change in _slips(work):
        table, cost = change.table or work.table, _cost(change, weights, standard.nothing)
        rules = _lost_by_rules(table, work.policy, weights)
        as_many = work.has_the_joints(table) or table.joint_types == work.table.joint_types
        if cost + max(weights.sign, rules) < most and as_many:
            undone.append((cost, rules, change))
    if not undone:
        return most
    least = at_least_lost(work, [change for *_, change in undone], standard)
    bounds = [
        cost + max(weights.sign, rules + at_least)
        for (cost, rules, _), at_least in zip(undone, least, strict=True)
    ]
    found: list[tuple[float, int]] = []
    for k in sorted(range(len(undone)), key=bounds.__getitem__):
        if bounds[k] >= most or (found and bounds[k] > min(found)[0] + SAME):
            break
        cost, rules, change = undone[k]
        other = _without(change, work)
        wrong = wrong_of(other, standard)
        if wrong < standard.of_zeros - SAME and not _is_in_one_row(change, work, wrong, standard):
            beside = rules + wrong - shared_across_prismatic(other, standard)
            all_lost = _with_lines(cost + max(weights.sign, beside), other, weights, standard.nothing)
            found.append((all_lost, k))
    if not found:
        return most
    off, k = min(found)
    cost, rules, change = undone[k]
    with_a_cell = cost + rules + CELL
    one_twist = off > with_a_cell and has_one_other_twist(_without(change, work))
    return min(most, with_a_cell if one_twist else off)


def _is_in_one_row(change: Change, work: Work, wrong: float, standard: Standard) -> bool:
    """Whether an exchange of rows mends no more than what it changes in one of them: it is no exchange.

    Else a cell that no fact asks for would raise the score where it happens to hold what another one lacks.

    Args:
        change: the exchange, if it is one.
        work: the answer.
        wrong: the weight of the facts that are wrong after it.
        standard: what answers are measured by.
    """
    rows = {row for row, _ in change.places}
    if change.extent is not Extent.ROW or len(rows) < 2:
        return False
    other, most = change.of(work.table).rows, wrong + SAME
    halves = [
        change._replace(table=None, cells=tuple((row, cell, getattr(other[row], cell)) for cell in CELLS))
        for row in rows
    ]
    least = at_least_lost(work, halves, standard)
    return any(
        at_least <= most and wrong_of(_without(half, work), standard) <= most
        for half, at_least in zip(halves, least, strict=True)
    )


def _is_of_length_or_turn(change: Change) -> bool:
    """Whether a change is of one cell that does not turn an axis against the one before it."""
    return (
        change.code not in SIGNS
        and change.extent is Extent.CELL
        and all(cell != "alpha" for _, cell in change.places)
    )


def _size_beside_sign(work: Work, standard: Standard, slip: Change) -> float:
    """What another sign of a length costs where it changes the size of a fact, and not its sign alone.

    In what rows an offset along parallel axes stands, or a distance across prismatic joints, depends on the
    frames, and whether a sign mends it.
    """
    return min(CELL, wrong_of(work, standard)) if slip.code in ("a_sign", "d_sign") else 0.0


def _has_no_more_than_zeros(work: Work, standard: Standard) -> bool:
    """Whether a table of zeros has as many facts: that one length would mend it is no merit of it."""
    if not standard.of_zeros or not work.has_the_joints():
        return False
    return wrong_of(work, standard) >= standard.of_zeros - SAME


def _is_nothing_beside_a_row(work: Work, changes: Sequence[Change], standard: Standard) -> bool:
    """Whether an answer lacks a row and the others have no more than zeros: it would bring all facts."""
    return changes[0].code == "row_missing" and not _is_something(work, changes, standard)


def _is_something(work: Work, changes: Sequence[Change], standard: Standard) -> bool:
    """Whether an answer of which one joint is wrong has more than zeros, once that joint stands there.

    Where another slip is throughout the table, that may be undone, too.
    """
    table = with_joints_mended(work.table, changes, work.reference.table.joint_types)
    completed = replace(work, table=table)
    if not completed.has_the_joints():
        return False
    if not _has_no_more_than_zeros(completed, standard):
        return True
    codes = {change.code for change in changes if change.row is None}
    slips = (slip for slip in _slips(completed) if slip.code in codes) if codes else ()
    return any(not _has_no_more_than_zeros(_without(slip, completed), standard) for slip in slips)


def _slips(work: Work) -> Iterator[Change]:
    """What undoes each slip in a row or throughout the table that may have been made besides others."""
    for misconception in CATALOGUE:
        for change in misconception.changes(work) if misconception.beforehand else ():
            # a joint of another type is read as one of the key's wherever facts are counted; a row without a
            # variable exchanged with a joint's puts what is wrong at the end, where no fact asks for it
            fixed = {work.table.rows[row].joint is JointType.FIXED for row, _ in change.places}
            if change.code == "joint_type" or (change.extent is Extent.ROW and len(fixed) > 1):
                continue
            if not hides_an_entry(work, change):
                yield change


def _without(slip: Change, work: Work) -> Work:
    return replace(work, table=slip.of(work.table))


def lost(decision: Decision, work: Work, weights: Weights) -> float:
    """Return the weight of the facts that are wrong, and of the rules that are not kept.

    A rule that the right robot does not keep costs at most half of what a table of zeros loses: where the
    rule `axis` has the second length of two links decide about the tool, the first one is still right.
    """
    standard = standard_of(work.reference, work.policy, weights)
    wrong = wrong_of(work, standard)
    if decision.same_robot:
        broken = {mismatch.kind for mismatch in decision.mismatches}
        ends = bool(broken & {Kind.BASE, Kind.TOOL})
        return max(wrong, min(weights.rule, standard.nothing / 2.0) * (len(broken & RULES) + ends))
    return wrong + _lost_by_rules(work.table, work.policy, weights)


def _with_lines(off: float, work: Work, weights: Weights, nothing: float) -> float:
    """What is lost if so much is, and of the rest what a rule costs if lines at the ends are wrong, too.

    A table of zeros has them right, so like joints they can only be lost.
    """
    if off >= nothing or not work.ends_beside_joints():
        return off
    return off + (nothing - off) * min(weights.rule / nothing, 0.5)


def _lost_by_rules(table: NumericTable, policy: Policy, weights: Weights) -> float:
    """What the rules weigh that an answer with another robot is not seen to keep."""
    return weights.rule * (unconfirmed(policy) + (not convention_fits(table.convention, policy.convention)))
