"""From two tables and a policy to a verdict."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from exercises.grading.certificate_report import certificate_report
from exercises.grading.comparison import Comparison, comparisons
from exercises.grading.findings import (
    all_right,
    feedback_of,
    link_findings,
    told_repairs,
    wrong_facts,
)
from exercises.grading.frames import explained
from exercises.grading.repairs import MOST_WORK, find_repairs
from exercises.grading.score import score_of
from exercises.grading.verdict import Basis, Feedback, HelpLevel, Verdict
from exercises.grading.work import Work
from kinematics.cells import ReadTable
from kinematics.equivalence import Decision, Policy, decide_draws, prove
from kinematics.equivalence.meter import Meter

REMEMBERED = 2048


def grade(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: Mapping[str, float] | None = None,
    help_level: HelpLevel = HelpLevel.REPAIR,
) -> Verdict:
    """Judge whether a submission describes the reference robot and keeps the policy.

    Args:
        reference: the key.
        submission: the answer; it may be in other units and in the other convention.
        policy: what is left free and what is fixed.
        parameters: values of the key's parameters [the key's units], so that an answer may be in numbers.
        help_level: how much a verdict on a wrong answer gives away.

    Raises:
        ParameterError: a value is not a finite number or belongs to no parameter, or the tables have no value
            for any values of their parameters.
    """
    given = tuple(sorted((parameters or {}).items(), key=lambda item: item[0]))
    return _grade(reference, submission, policy, given, help_level)


def accept(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: Mapping[str, float] | None = None,
) -> Verdict | None:
    """The verdict on a right answer, or None: what `grade` says, without the search that explains others.

    Args and raises as in `grade`.
    """
    given = tuple(sorted((parameters or {}).items(), key=lambda item: item[0]))
    decided = _decided(reference, submission, policy, given)
    return decided if isinstance(decided, Verdict) else None


@lru_cache(maxsize=REMEMBERED)
def _grade(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: tuple[tuple[str, float], ...],
    help_level: HelpLevel,
) -> Verdict:
    decided = _decided(reference, submission, policy, parameters)
    if isinstance(decided, Verdict):
        return decided
    decision, way = decided
    return _rejected(decision, way, reference, submission, policy, help_level)


@lru_cache(maxsize=REMEMBERED)
def _decided(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: tuple[tuple[str, float], ...],
) -> Verdict | tuple[Decision, Comparison]:
    """The verdict on a right answer; of a wrong one the decision that says most, and what was compared."""
    ways = comparisons(reference, submission, dict(parameters))
    decisions: list[Decision] = []
    for way in ways:
        decision = decide_draws(way.references, way.submissions, policy)
        if decision.accepted:
            return _accepted(decision, way, submission)
        decisions.append(decision)
    best = next((i for i, decision in enumerate(decisions) if decision.same_robot), 0)
    return decisions[best], ways[best]


def _accepted(decision: Decision, comparison: Comparison, submission: ReadTable) -> Verdict:
    certificate = decision.certificate
    assert certificate is not None
    exact = prove(comparison.reference, comparison.submission, certificate.draws, comparison.draws)
    key, answer = comparison.references[0], comparison.submissions[0]
    return Verdict(
        correct=True,
        score=1.0,
        basis=Basis.VERIFIED if exact is None else Basis.PROVED,
        certificate=certificate_report(certificate, exact, comparison, submission),
        links=all_right(answer),
        feedback=explained(key, answer, certificate, exact, submission.angle_unit),
        repairs=(),
        angle_unit=submission.angle_unit,
        length_unit=submission.length_unit,
    )


def _rejected(
    decision: Decision,
    comparison: Comparison,
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    help_level: HelpLevel,
) -> Verdict:
    key, answer = comparison.references[0], comparison.submissions[0]
    work = Work(
        key=reference,
        answer=submission,
        comparison=comparison,
        policy=policy,
        tables=comparison.submissions,
        meter=Meter(MOST_WORK),
    )
    repairs = find_repairs(work)
    wrong = wrong_facts(decision, repairs, answer)
    feedback = feedback_of(decision, repairs, wrong, key, answer, policy, help_level)
    return Verdict(
        correct=False,
        score=score_of(decision, repairs, answer, key),
        basis=Basis.REFUTED,
        certificate=None,
        links=link_findings(answer, wrong, decision, repairs, help_level),
        feedback=(*_about_names(reference, submission, comparison), *feedback),
        repairs=told_repairs(repairs, help_level),
        angle_unit=submission.angle_unit,
        length_unit=submission.length_unit,
    )


def _about_names(reference: ReadTable, submission: ReadTable, comparison: Comparison) -> tuple[Feedback, ...]:
    """Names that the exercise doesn't know, and numbers where it asks for names."""
    known = tuple(reference.parameters)
    told = [
        Feedback(code="parameter_unknown", params={"name": name, "known": ", ".join(known) or "–"})
        for name in submission.parameters
        if name not in reference.parameters
    ]
    if known and not submission.parameters and comparison.in_names:
        told.append(Feedback(code="names_asked", params={"known": ", ".join(known)}))
    return tuple(told)
