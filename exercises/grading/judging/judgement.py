"""Whether an answer is right, in one way in which it may be meant."""

from collections.abc import Mapping
from dataclasses import replace

from exercises.grading.judging.comparison import Comparison
from exercises.grading.judging.digits import PER_CENT, beyond_digits, digits_and_angles
from exercises.grading.judging.end_lines import ends_beyond_digits
from exercises.grading.judging.typed import Place
from kinematics.chain import chain_of_table
from kinematics.equivalence import (
    BaseRule,
    Decision,
    Kind,
    Mismatch,
    Policy,
    ToolRule,
    ZeroRule,
    decide_draws,
)
from kinematics.equivalence.decision import EXACT, convention_fits, mechanism_only
from kinematics.equivalence.diagnosis import diagnose, mismatches_of
from kinematics.equivalence.invariants import Invariants
from kinematics.equivalence.reference import prepared, prepared_for
from kinematics.equivalence.results import Certificate
from kinematics.table import NumericTable

IMPRECISE = Decision(certificate=None, mismatches=(Mismatch(kind=Kind.PRECISION),), same_robot=False)
"""Every fact is right by itself, and only their small errors together are too much."""
REFUTED = Decision(certificate=None, mismatches=(), same_robot=False)
"""A length, an angle or a type is wrong, whatever frames were chosen; `diagnosed` finds what does not fit."""


def lacks_precision(decision: Decision) -> bool:
    """Return whether every fact is right by itself, and only their small errors together are too much."""
    return [mismatch.kind for mismatch in decision.mismatches] == [Kind.PRECISION]


def policy_of(comparison: Comparison, policy: Policy) -> Policy:
    """Return what an answer is held to as it was meant: names, where nothing was rounded, are exact."""
    if not comparison.exact:
        return policy
    lengths, angles = policy.tolerance.length, policy.tolerance.angle
    tolerance = replace(EXACT, length=min(EXACT.length, lengths), angle=min(EXACT.angle, angles))
    return replace(policy, tolerance=tolerance)


def share_of(comparison: Comparison) -> float:
    """Return by which part of itself a length may be off, whatever its digits; none where names say it."""
    return PER_CENT if comparison.by_value and not comparison.in_names else 0.0


def judged(comparison: Comparison, policy: Policy) -> Decision:
    """Return whether an answer is right: as it was typed, and, where entries were rounded, as it was meant.

    What is wrong is looked for in the answer as it was meant; so no 1.57 is taken for a mistake.
    """
    if _is_refuted(comparison, policy):
        return REFUTED
    strict = policy_of(comparison, policy)
    typed_exactly = comparison.typed_exactly
    if strict is not policy:
        meant = decide_draws(comparison.references, comparison.meant, strict)
        if typed_exactly or not meant.accepted:
            return meant
        return _or_imprecise(decide_draws(comparison.references, comparison.submissions, policy))
    typed = decide_draws(comparison.references, comparison.submissions, policy)
    if typed.certificate is not None:
        return _held_to_digits(comparison, typed, typed.certificate, policy)
    if typed_exactly:
        return typed
    meant = decide_draws(comparison.references, comparison.meant, policy)
    return IMPRECISE if meant.accepted else meant


def with_a_telling_draw_first(comparison: Comparison, policy: Policy) -> Comparison:
    """Return a comparison of a wrong answer, with a draw first at which a length or an angle is wrong.

    At another draw two names may have nearly the same value, or one that of a number. It is for answers that
    the first draw has not refuted.
    """
    telling = (draw for draw in range(1, len(comparison.draws)) if _is_refuted(comparison, policy, draw))
    return comparison.with_first(next(telling, 0))


def _is_refuted(comparison: Comparison, policy: Policy, draw: int = 0) -> bool:
    """Whether a length or an angle of an answer is wrong, or a joint's type, whatever frames were chosen.

    Nothing is searched for then: no certificate stands, and none of the mirror image.
    """
    key, answer = comparison.references[draw], comparison.meant[draw]
    if key.n_joints != answer.n_joints or not convention_fits(answer.convention, policy.convention):
        return False
    if key.joint_types != answer.joint_types:
        # what else a diagnosis says is told beside any repair: which rules about the ends are not kept
        return policy.base is BaseRule.FREE and policy.tool is ToolRule.FREE
    return _beyond_digits(comparison, mechanism_only(policy), draw) is not None


def _beyond_digits(comparison: Comparison, policy: Policy, draw: int = 0) -> Invariants | None:
    """What the digits do not explain, neither of the answer as it was meant nor as it was typed.

    A constant in front of a prismatic joint may be near a multiple of 15° by chance.
    """
    far = _beyond(comparison, comparison.meant[draw], comparison.steps, policy, draw)
    if far is None or comparison.typed_exactly:
        return far
    typed = comparison.submissions[draw], comparison.typed_steps
    return None if _beyond(comparison, *typed, policy, draw) is None else far


def _beyond(
    comparison: Comparison, answer: NumericTable, steps: Mapping[Place, float], policy: Policy, draw: int
) -> Invariants | None:
    reference = prepared_for(comparison.references[draw], answer)
    return beyond_digits(reference, answer, steps, policy, share_of(comparison))


def diagnosed(comparison: Comparison, policy: Policy) -> Decision:
    """Return what does not fit in an answer of which a length or an angle is wrong."""
    policy, answer = policy_of(comparison, policy), comparison.meant[0]
    chain = chain_of_table(answer)
    reference = prepared(comparison.references[0]).beside(chain)
    found = diagnose(reference, answer, chain, policy)
    if all(mismatch.kind is Kind.PRECISION for mismatch in found):
        free = mechanism_only(policy)
        far = _beyond_digits(comparison, free)
        found = found if far is None else mismatches_of(far, reference, answer, chain, free)
    return replace(REFUTED, mismatches=found)


def _or_imprecise(decision: Decision) -> Decision:
    return decision if decision.accepted else IMPRECISE


def _held_to_digits(
    comparison: Comparison, decision: Decision, certificate: Certificate, policy: Policy
) -> Decision:
    """The decision, unless a length or an angle is off by more than its digits explain, at any draw."""
    if certificate.residual <= EXACT.length:
        return decision
    for draw, (key, answer) in enumerate(zip(comparison.references, comparison.meant, strict=True)):
        far = _beyond_digits(comparison, policy, draw)
        if far is not None:
            chain = chain_of_table(answer)
            found = mismatches_of(far, prepared_for(key, answer), answer, chain, policy)
            return replace(REFUTED, mismatches=found)
        ends = ends_beyond_digits(
            prepared_for(key, answer), answer, comparison.steps, policy, share_of(comparison)
        )
        if ends:
            return Decision(
                certificate=None, mismatches=tuple(Mismatch(kind=kind) for kind in ends), same_robot=True
            )
    # where zeros are fixed, the digits of the variables' own cells count, too, which are not known
    if prepared(comparison.references[0]).scaleless and policy.zero is ZeroRule.FREE:
        return _held_to_no_size(comparison, decision, certificate, policy)
    return decision


def _held_to_no_size(
    comparison: Comparison, decision: Decision, certificate: Certificate, policy: Policy
) -> Decision:
    """The decision, where the key has no length: positions are off by no more than digits and angles explain.

    What counts as the size is then that of the answer, which grows with the frames that were chosen.
    """
    share = 0.0
    for key, answer in zip(comparison.references, comparison.meant, strict=True):
        reference = prepared_for(key, answer)
        share = max(share, EXACT.length + digits_and_angles(reference, answer, comparison.steps, policy))
    if certificate.residual <= share or share >= policy.tolerance.length:
        return decision
    tolerance = replace(policy.tolerance, length=share)
    return decide_draws(comparison.references, comparison.meant, replace(policy, tolerance=tolerance))
