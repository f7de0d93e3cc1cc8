"""The decision: do two tables describe the same robot?

With F_r and F_s the forward kinematics of the reference and the submission, they do when there are joint
signs σ, joint offsets δ and constant rigid motions B and E with

    F_s(σ∘q + δ) = B · F_r(q) · E      for all q,                                    (1)

which is so exactly when motions g_0, …, g_n exist with g_{i-1} S_i^s = σ_i S_i^r and g_i ∈ exp(S_i^r ℝ)
g_{i-1}. docs/checker.md gives the argument; the modules beside this one are its steps.
"""

from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import replace
from functools import lru_cache

from kinematics.chain import Chain, chain_of_table
from kinematics.equivalence.bounds import surely_apart
from kinematics.equivalence.diagnosis import diagnose
from kinematics.equivalence.meter import Meter, WorkExhaustedError
from kinematics.equivalence.policy import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
)
from kinematics.equivalence.reference import SAMPLES, Reference, prepared
from kinematics.equivalence.results import Certificate, Decision, Kind, Mismatch
from kinematics.equivalence.search import Effort, Found, Search
from kinematics.equivalence.worst_case import ARITHMETIC, worst_case
from kinematics.se3 import to_matrix
from kinematics.table import Convention, DHTable, NumericTable

EXACT = Tolerance(length=1e-8, angle=1e-8)
"""Where two tables are the same but for the errors of the arithmetic, which are below 1e-9 of a robot."""

# Some ten certificates at the very limit of the tolerance are refined with this, each ten times; valid tables
# that need more are not known (see the campaigns). What a wrong one is told may cost as much again.
WORK_OF_ACCEPTANCE = 150_000
WORK_OF_EXPLANATION = 100_000


def decide(reference: NumericTable, submission: NumericTable, policy: Policy) -> Decision:
    """Decide whether a submission describes the reference robot and keeps the policy.

    Args:
        reference: the key, in the same length unit as the submission.
        policy: what is left free and what is fixed.
    """
    return decide_draws((reference,), (submission,), policy)


def decide_draws(
    references: Sequence[NumericTable], submissions: Sequence[NumericTable], policy: Policy
) -> Decision:
    """Decide for tables with parameters, given at several draws of the parameters.

    The draws must agree on the signs; structure and diagnosis follow the first one.
    """
    prepared_references = [prepared(table) for table in references]
    chains = [chain_of_table(table) for table in submissions]
    if convention_fits(submissions[0].convention, policy.convention):
        certificate = _certified(prepared_references, chains, policy, Meter(WORK_OF_ACCEPTANCE))
        if certificate is not None:
            measured = _measured(prepared_references, chains, certificate)
            return Decision(certificate=measured, mismatches=(), same_robot=True)
    return _explained(prepared_references, submissions[0], chains, policy)


def _certified(
    references: Sequence[Reference], submissions: Sequence[Chain], policy: Policy, meter: Meter
) -> Certificate | None:
    """The certificate of a submission, if it is found with the work that is granted."""
    try:
        return certify(references, submissions, policy, meter=meter)
    except WorkExhaustedError:
        return None


def _measured(
    references: Sequence[Reference], submissions: Sequence[Chain], certificate: Certificate
) -> Certificate:
    """The certificate with the largest residual that a climb finds, unless it is exact."""
    if certificate.residual <= ARITHMETIC:
        return certificate
    beside = map(Reference.beside, references, submissions)
    found = map(worst_case, beside, submissions, certificate.draws)
    return replace(certificate, residual=max(certificate.residual, *(max(worst.residual) for worst in found)))


def convention_fits(convention: Convention, rule: ConventionRule) -> bool:
    """Return whether a table's convention is one that the rule allows."""
    return rule is ConventionRule.ANY or rule.value == convention.value


def certify(
    references: Sequence[Reference],
    submissions: Sequence[Chain],
    policy: Policy,
    effort: Effort = Effort.REFINED,
    meter: Meter | None = None,
    *,
    measured: bool = True,
) -> Certificate | None:
    """Return the verified certificate of a submission, whatever its convention; None if there is none.

    Its residual is that at the samples where a bound shows that it stands at every configuration; or the
    bound, where nobody wants to know more than that.

    An exact one is looked for first: among axes that are nearly parallel there may be others nearby, which
    stand within the tolerance.
    """
    found = _found(references, submissions, policy, effort, meter, measured=measured)
    return None if found is None else _certificate(found)


def is_certified(
    references: Sequence[Reference],
    submissions: Sequence[Chain],
    policy: Policy,
    effort: Effort = Effort.REFINED,
    meter: Meter | None = None,
) -> bool:
    """Return whether `certify` finds a certificate, where nobody wants to see it; arguments as there."""
    return _found(references, submissions, policy, effort, meter, measured=False) is not None


def _found(
    references: Sequence[Reference],
    submissions: Sequence[Chain],
    policy: Policy,
    effort: Effort,
    meter: Meter | None,
    *,
    measured: bool,
) -> Found | None:
    types = [axis.prismatic for axis in references[0].chain.axes]
    if types != [axis.prismatic for axis in submissions[0].axes]:
        return None
    references = [r.beside(chain) for r, chain in zip(references, submissions, strict=True)]
    wanted = policy.tolerance

    def first(asked: Policy, trying: Effort) -> Found | None:
        """Return the first certificate that stands, whatever axes count as parallel."""
        levels = references[0].levels(asked.base, asked.zero, asked.tolerance)
        tried = (
            Search(references, submissions, asked, near, trying, meter, measured).run() for near in levels
        )
        return next((found for found in tried if found is not None), None)

    coarser = min(wanted.length, wanted.angle) > EXACT.angle
    if coarser and not surely_apart(references[0], submissions[0], EXACT):
        # among axes that are nearly parallel, alignments lever up the errors of the arithmetic
        is_refined = effort is Effort.REFINED
        levered = is_refined and references[0].further_levels(policy.base, policy.zero, wanted)
        trying = effort if levered else Effort.PLAIN
        exact = replace(policy, tolerance=EXACT)
        with nullcontext() if meter is None else meter.at_most(meter.left // 2):
            found = first(exact, trying)
            if found is not None:
                return found
    elif surely_apart(references[0], submissions[0], wanted):
        return None
    return first(policy, effort)


def _certificate(found: Found) -> Certificate:
    first = found.candidates[0]
    return Certificate(
        joint_signs=first.signs,
        joint_offsets=first.offsets,
        base=to_matrix(first.base),
        tool=to_matrix(first.tool),
        residual=max(max(residual) for residual in found.residuals),
        samples=SAMPLES * len(found.residuals),
        draws=found.candidates,
    )


_RULES: tuple[tuple[Kind, str, BaseRule | ToolRule | ZeroRule | DirectionRule], ...] = (
    (Kind.BASE, "base", BaseRule.FREE),
    (Kind.TOOL, "tool", ToolRule.FREE),
    (Kind.ZERO, "zero", ZeroRule.FREE),
    (Kind.DIRECTION, "direction", DirectionRule.FREE),
)


@lru_cache(maxsize=256)
def mechanism_only(policy: Policy) -> Policy:
    """Return the policy that asks for nothing but the same mechanism, at the same tolerance."""
    return Policy(tool=ToolRule.FREE, tolerance=policy.tolerance)


def _explained(
    references: Sequence[Reference], table: NumericTable, chains: Sequence[Chain], policy: Policy
) -> Decision:
    wrong_convention = not convention_fits(table.convention, policy.convention)
    named = (Mismatch(kind=Kind.CONVENTION),) if wrong_convention else ()
    tried = not wrong_convention and policy == replace(mechanism_only(policy), convention=policy.convention)
    meter = Meter(WORK_OF_EXPLANATION)
    if not tried and _certified(references, chains, mechanism_only(policy), meter) is not None:
        return Decision(
            certificate=None,
            mismatches=(*named, *_broken_rules(references, chains, policy, meter)),
            same_robot=True,
        )
    expected, got = len(references[0].chain.axes), len(chains[0].axes)
    if expected != got:
        return Decision(
            certificate=None, mismatches=(*named, Mismatch(kind=Kind.JOINT_COUNT)), same_robot=False
        )
    found = diagnose(references[0].beside(chains[0]), table, chains[0], policy)
    mirror = [prepared(mirrored(r.table)) for r in references]
    if _certified(mirror, chains, mechanism_only(policy), meter) is not None:
        found = (Mismatch(kind=Kind.HANDEDNESS), *found)
    return Decision(certificate=None, mismatches=(*named, *found), same_robot=False)


def _broken_rules(
    references: Sequence[Reference], chains: Sequence[Chain], policy: Policy, meter: Meter
) -> tuple[Mismatch, ...]:
    """The rules that a submission of the right robot does not keep, each judged with the others left free."""
    free = mechanism_only(policy)
    asked = [(kind, name) for kind, name, rule in _RULES if getattr(policy, name) is not rule]
    broken = [
        kind
        for kind, name in asked
        if _certified(references, chains, replace(free, **{name: getattr(policy, name)}), meter) is None
    ]
    if not broken and _certified(references, chains, policy, meter) is None:
        broken = _not_together(references, chains, policy, asked, meter)
    return tuple(Mismatch(kind=kind) for kind in broken)


def _not_together(
    references: Sequence[Reference],
    chains: Sequence[Chain],
    policy: Policy,
    asked: list[tuple[Kind, str]],
    meter: Meter,
) -> list[Kind]:
    """Of rules that can be kept singly but not together, the last one without which the others can."""
    free = mechanism_only(policy)
    for kind, name in reversed(asked):
        without = replace(policy, **{name: getattr(free, name)})
        if _certified(references, chains, without, meter) is not None:
            return [kind]
    return [kind for kind, _ in asked]


def mirrored(table: NumericTable) -> NumericTable:
    """Mirror a robot in the plane z_0 = 0: d, α and every prismatic variable change sign."""
    rows = tuple(
        replace(
            row, d=-row.d, alpha=-row.alpha, sign=-row.sign if row.joint.value == "prismatic" else row.sign
        )
        for row in table.rows
    )
    return DHTable(convention=table.convention, rows=rows)
