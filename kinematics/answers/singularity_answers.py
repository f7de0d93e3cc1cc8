"""Singularities as an answer: do some conditions hold exactly where an arm loses a motion?

    S = { q : rank J(q) < the rank that J(q) has almost everywhere }      answered by  Z(g_1) ∪ … ∪ Z(g_m)

What counts is the set. Of an arm with one largest minor D (det J, if J is square) S = Z(D), the union of
the zeros of D's irreducible factors, its families. A condition g is compared with products P of powers of
families: if g = c · P with a c that never vanishes, its zeros are theirs, which is proved by the canonical
forms. Other conditions (arcs, rounded numbers) are verified: J loses rank at their zeros, found along lines
through the joint space, and they vanish at points of a family, found in the same way.

Source: J. J. Craig, Introduction to Robotics, sec. 5.8; Y. Nakamura, Advanced Robotics, ch. 4.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial

import numpy as np
from numpy.typing import NDArray

from kinematics.answers.left_open import TOGETHER, Rounded, moved_by
from kinematics.answers.singular_arms import LOST, ROUNDED, SingularArm, typical
from kinematics.answers.singularity_verdicts import (
    ConditionStatus,
    JudgedCondition,
    JudgedFamily,
    SingularityVerdict,
)
from kinematics.answers.unit_multiples import factors_of
from kinematics.errors import ParameterError
from kinematics.expressions import (
    Expression,
    JointVariable,
    add,
    joint_variables_in,
    multiply,
    pi_times,
    with_parts,
)
from kinematics.expressions.values import holds_decimals
from kinematics.se3 import Floats
from kinematics.symbolic import ProofStatus
from kinematics.symbolic.quotients import reduced
from kinematics.table import JointType

CLOSE = 0.05
"""Share of its usual value up to which the smallest singular value is that of roughly rounded conditions: one
or two degrees from a singular configuration."""


def judge_singularities(
    arm: SingularArm, conditions: Sequence[Expression], rounded: Rounded | None = None
) -> SingularityVerdict:
    """Judge conditions as a set.

    What is right for the arm's lengths and not proved is judged with other lengths as well, if the conditions
    hold no decimals: lengths may be equal by chance.

    Args:
        arm: which arm, and which motion.
        conditions: functions of the joint variables, each of which is said to vanish; products may be split.
        rounded: what those with decimals are with one of these moved by what its rounding leaves open.

    Raises:
        FormSizeError: the determinant of the arm is too large to be formed.
    """
    near = rounded or {}
    found = _judged(arm, conditions, near)
    exact = not any(near.get(condition) or holds_decimals(condition) for condition in conditions)
    if not exact or not found.right or found.proof is ProofStatus.PROVED:
        return found
    try:
        other = _judged(arm.other(), conditions, {})
    except ParameterError:  # the table has no value there
        return found
    if other.right or len(other.families) != len(found.families):
        return found
    return SingularityVerdict(
        conditions=tuple(JudgedCondition(status=entry.status) for entry in other.conditions),
        families=tuple(JudgedFamily(found=entry.found, example=None) for entry in other.families),
        proof=ProofStatus.REFUTED,
    )


@np.errstate(all="ignore")
def _judged(arm: SingularArm, conditions: Sequence[Expression], rounded: Rounded) -> SingularityVerdict:
    """Judge conditions at the arm's own lengths."""
    covered = [np.zeros(points.shape[1], dtype=bool) for points in arm.witnesses]
    proved: set[int] = set()
    judged: list[JudgedCondition] = []
    exact = True
    for condition in conditions:
        statuses, before, proved_before = [], [each.copy() for each in covered], set(proved)
        factors = _factors(arm, condition)
        near = _near([factor for factor, _ in factors], rounded.get(condition, ()))
        for factor, here in factors:
            if here is None:
                vanishing = _where(arm, factor, covered, near)
                found = frozenset(j for j, all_of_it in enumerate(vanishing) if all_of_it)
                here = found if found and arm.products.is_product(factor, found) else None
            if here is None:
                statuses.append(_verified(arm, factor, near.get(factor, ())))
                exact = False
                continue
            proved |= here
            for j in here:
                covered[j][:] = True
            status = ConditionStatus.SINGULAR if here else ConditionStatus.NOWHERE
            statuses.append(JudgedCondition(status=status))
        judged.append(_together(statuses))
        if judged[-1].status is ConditionStatus.EVERYWHERE:
            covered, proved = before, proved_before  # it says of no configuration that it is singular
    told = tuple(
        JudgedFamily(found=1.0 if j in proved else float(found.mean()), example=_example(points, found))
        for j, (found, points) in enumerate(zip(covered, arm.witnesses, strict=True))
    )
    verdict = SingularityVerdict(conditions=tuple(judged), families=told, proof=ProofStatus.REFUTED)
    if not verdict.right:
        return verdict
    whole = exact and arm.whole and len(proved) == len(arm.families)
    return replace(verdict, proof=ProofStatus.PROVED if whole else ProofStatus.UNDECIDED)


def _factors(arm: SingularArm, condition: Expression) -> list[tuple[Expression, frozenset[int] | None]]:
    """Return functions that vanish where a condition holds, and the families that these are proved to be.

    A quotient is one function where its denominator may cancel zeros: (1 − cos² q)/sin² q has none.
    """
    whole, bottom = reduced(condition)
    under = _divisors(arm, bottom)
    if under is not None and not any(under):
        found = [(factor, arm.products.zeros(factor)) for factor in factors_of(whole)]
        split = not bottom or all(families is not None for _, families in found)
        return found if split else [(whole, None)]
    powers = arm.products.powers(whole)
    if powers is None or under is None:
        return [(whole, None)]
    return [(whole, frozenset(j for j, count in enumerate(powers) if count > under[j]))]


def _divisors(arm: SingularArm, bottom: Sequence[Expression]) -> tuple[int, ...] | None:
    """Return how often each family divides a denominator; None if one may, and it is not proved how often."""
    none = (0,) * len(arm.families)
    if not bottom:
        return none
    product = multiply(bottom)
    powers = arm.products.powers(product)
    if powers is None:
        touched = [np.zeros(points.shape[1], dtype=bool) for points in arm.witnesses]
        _where(arm, product, touched, {})
        return None if any(points.any() for points in touched) else none
    return powers


def _near(factors: Sequence[Expression], rounded: Sequence[Expression]) -> Rounded:
    """Return what the factors of a condition are with its decimals moved; each moves one of them."""
    found: dict[Expression, tuple[Expression, ...]] = {}
    before = Counter(factors)
    for moved in rounded:
        whole = reduced(moved)[0]
        after = Counter([whole] if len(factors) == 1 else factors_of(whole))
        left, new = [*(before - after)], [*(after - before)]
        if len(left) == len(new) == 1:
            found[left[0]] = (*found.get(left[0], ()), new[0])
    return found


def _where(
    arm: SingularArm, factor: Expression, covered: Sequence[NDArray[np.bool_]], near: Rounded
) -> list[bool]:
    """Note where in the families a function vanishes; return in which it does everywhere."""
    scale = typical(arm.values_of(factor, arm.lines[0]))
    limit = ROUNDED if holds_decimals(factor) else LOST
    found = []
    for seen, points in zip(covered, arm.witnesses, strict=True):
        values = np.abs(arm.values_of(factor, points))
        zero = values <= limit * scale
        if factor in near:
            zero |= values <= moved_by(factor, near[factor], arm.values, points)
        seen |= zero
        found.append(bool(zero.all()))
    return found


def _verified(arm: SingularArm, factor: Expression, near: Sequence[Expression]) -> JudgedCondition:
    """Return what the zeros of a function show, and of what it is with its decimals moved."""
    sample = arm.values_of(factor, arm.grid)
    finite = sample[np.isfinite(sample)]
    if len(finite) and np.abs(finite).max() <= 1e-12:
        return JudgedCondition(status=ConditionStatus.EVERYWHERE)
    zeros = arm.zeros(factor)
    if not zeros.shape[1]:
        return JudgedCondition(status=ConditionStatus.NOWHERE)
    lost = arm.lost(zeros)
    limit = ROUNDED if holds_decimals(factor) else LOST
    if (lost <= limit).all() or (lost <= _lost_by_rounding(arm, factor, near, zeros)).all():
        return JudgedCondition(status=ConditionStatus.SINGULAR)
    return JudgedCondition(
        status=ConditionStatus.INVENTED,
        example=tuple(zeros[:, int(np.argmax(lost))].tolist()),
        is_close=holds_decimals(factor) and bool((lost <= CLOSE).all()),
    )


def _lost_by_rounding(
    arm: SingularArm, factor: Expression, near: Sequence[Expression], zeros: Floats
) -> Floats:
    """Return by how much the smallest singular value may differ at zeros whose decimals were rounded, (k,).

    Near a singular configuration it grows with the distance, so that moving a zero by what rounding leaves
    open, away from there, adds what rounding may have left.
    """
    here = arm.lost(zeros)
    step = 1e-6 * arm.units[:, None]
    rates = np.array(
        [
            (arm.values_of(factor, zeros + one) - arm.values_of(factor, zeros - one)) / 2e-6
            for one in np.eye(len(step))[:, :, None] * step
        ]
    )
    along = rates / (rates**2).sum(axis=0) * arm.units[:, None]
    off = np.zeros(zeros.shape[1])
    for moved in near:
        way = along * arm.values_of(moved, zeros)
        if not np.isfinite(way).all():
            continue
        off += np.maximum(arm.lost(zeros + way), arm.lost(zeros - way)) - here
    return TOGETHER * off


def is_sine_for_cosine(arm: SingularArm, condition: Expression) -> bool:
    """Return whether a condition is one of singularities, but for a quarter turn of one of its angles."""
    quarter = pi_times(Fraction(1, 2))
    for factor in factors_of(condition):
        for joint in sorted(joint_variables_in(factor)):
            if arm.table.joint_types[joint - 1] is JointType.PRISMATIC:
                continue
            variable = JointVariable(joint)
            turned = _turned(factor, variable, add((variable, quarter)))
            if arm.products.zeros(turned):
                return True
            zeros = arm.zeros(turned)
            if zeros.shape[1] and (arm.lost(zeros) <= LOST).all():
                return True
    return False


def _turned(expression: Expression, joint: JointVariable, by: Expression) -> Expression:
    """Return an expression with a joint variable replaced."""
    return by if expression == joint else with_parts(expression, partial(_turned, joint=joint, by=by))


def _together(statuses: Sequence[JudgedCondition]) -> JudgedCondition:
    """Return what is said of a condition whose factors are judged."""
    for status in (ConditionStatus.EVERYWHERE, ConditionStatus.INVENTED, ConditionStatus.SINGULAR):
        for found in statuses:
            if found.status is status:
                return found
    return JudgedCondition(status=ConditionStatus.NOWHERE)


def _example(points: Floats, found: NDArray[np.bool_]) -> tuple[float, ...]:
    k = int(np.argmin(found)) if len(found) else 0
    return tuple(points[:, k].tolist())
