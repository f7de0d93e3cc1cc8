"""From two tables and a policy to a verdict."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from exercises.grading.edits.in_common import in_common
from exercises.grading.edits.repaired import Repaired
from exercises.grading.explanation import Diagnosis, Refused, as_typed, clearest, diagnosis, explanation
from exercises.grading.facts import Weights
from exercises.grading.findings import all_right
from exercises.grading.idle_rows import renumbered, without_idle_rows
from exercises.grading.judging.certificate_report import certificate_report
from exercises.grading.judging.comparison import Comparison, compared_by_names, comparisons
from exercises.grading.judging.frames import explained
from exercises.grading.judging.judgement import REFUTED, judged, with_a_telling_draw_first
from exercises.grading.verdict import Basis, Feedback, HelpLevel, Verdict
from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.cells import ReadTable
from kinematics.equivalence import Decision, Policy, prove
from kinematics.table import JointType

CACHED_VERDICTS = 512  # Verdicts in the cache: a class hands in the same few answers again and again.
CACHED_DIAGNOSES = 64
"""Diagnoses in the cache: an answer is told by one level of help and written down by another."""
USUAL = Weights()
ROW_TO_THE_POINT = "fixed_row_missing"


def grade(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: Mapping[str, float] | None = None,
    help_level: HelpLevel = HelpLevel.REPAIR,
    weights: Weights = USUAL,
) -> Verdict:
    """Judge whether a submission describes the reference robot and keeps the policy.

    Args:
        reference: the key.
        submission: the answer; it may be in other units and in the other convention.
        policy: what is left free and what is fixed.
        parameters: values of the key's parameters [the key's units], so that an answer may be in numbers.
        help_level: how much a verdict on a wrong answer gives away.
        weights: what facts and slips are worth in a wrong answer.

    Raises:
        ParameterError: a value is not a finite number or belongs to no parameter, or the tables have no value
            for any values of their parameters.
    """
    given = _values_that_matter(reference, submission, parameters or {})
    return _grade(reference, submission, policy, given, help_level, weights)


def accept(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: Mapping[str, float] | None = None,
) -> Verdict | None:
    """Return the verdict on a right answer, as `grade` does; None for a wrong one, unexplained.

    Args and raises as in `grade`.
    """
    given = _values_that_matter(reference, submission, parameters or {})
    decided = _decided(reference, submission, policy, given)
    return decided if isinstance(decided, Verdict) else None


def is_accepted(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: Mapping[str, float] | None = None,
) -> bool:
    """Return whether `accept` has a verdict, without the proof in symbols that stands in one.

    Args and raises as in `grade`.
    """
    ways = comparisons(reference, submission, dict(parameters or {}))
    return any(judged(way, policy).accepted for way in ways)


def _values_that_matter(
    reference: ReadTable, submission: ReadTable, parameters: Mapping[str, float]
) -> tuple[tuple[str, float], ...]:
    """The values that a verdict depends on: with an answer in names, whatever a student was given, none."""
    if not parameters or compared_by_names(reference, submission, parameters):
        return ()
    return tuple(sorted(parameters.items(), key=lambda item: item[0]))


def _most_rows(*tables: ReadTable) -> int:
    return max(len(read.table.rows) for read in tables)


@cached_by_size(
    lambda reference, submission, policy, parameters, help_level, weights: _most_rows(reference, submission),
    longest=USUAL_ROWS,
    most=CACHED_VERDICTS,
    few=64,
)
def _grade(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: tuple[tuple[str, float], ...],
    help_level: HelpLevel,
    weights: Weights,
) -> Verdict:
    decided = _diagnosed(reference, submission, policy, parameters, weights)
    if isinstance(decided, Verdict):
        return decided
    found, way, kept = decided
    told = renumbered(explanation(found, policy, help_level), kept, len(submission.table.rows))
    shared = None if any(entry.code == "one_of_these" for entry in told.feedback) else in_common(told.repairs)
    return Verdict(
        correct=False,
        score=told.score,
        basis=Basis.REFUTED,
        certificate=None,
        links=told.links,
        feedback=(
            *_about_names(reference, submission, way),
            *told.feedback,
            *((shared,) if shared else ()),
        ),
        repairs=told.repairs,
        angle_unit=submission.angle_unit,
        length_unit=submission.length_unit,
    )


@lru_cache(maxsize=CACHED_DIAGNOSES)
def _diagnosed(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: tuple[tuple[str, float], ...],
    weights: Weights,
) -> Verdict | tuple[Diagnosis, Comparison, tuple[int, ...]]:
    """The verdict on a right answer; of a wrong one what is wrong, what was compared, what rows count."""
    decided = _decided(reference, submission, policy, parameters)
    if isinstance(decided, Verdict):
        return decided
    shortened, kept = without_idle_rows(submission)
    if len(kept) < len(submission.table.rows):
        forgotten = _row_without_its_variable(reference, submission, policy, dict(parameters), kept)
        shortened, kept = without_idle_rows(submission, but=forgotten)
    if shortened is not submission:
        again = _decided(reference, shortened, policy, parameters)
        decided = decided._replace(repairs=None) if isinstance(again, Verdict) else again
    found = diagnosis(decided, (reference, shortened), policy, weights)
    forgotten = _row_left_zero(found.repairs, kept, len(submission.table.rows))
    if forgotten:
        filled, with_it = without_idle_rows(submission, but=forgotten)
        again = _decided(reference, filled, policy, parameters)
        if not isinstance(again, Verdict):
            other = diagnosis(again, (reference, filled), policy, weights)
            if other.repairs and _are_as_likely(other.repairs, found.repairs):
                return replace(other, score=found.score), again.comparison, with_it
    return found, decided.comparison, kept


def _row_left_zero(repairs: Sequence[Repaired], kept: Sequence[int], rows: int) -> tuple[int, ...]:
    """The row of zeros, from 0, that stands where a repair puts a fixed row in.

    Args:
        repairs: of the table without its rows of zeros.
        kept: the number of each of its rows in the whole table.
        rows: how many rows that has.
    """
    changes = [change for repair in repairs for change in repair.changes]
    missing = next((change for change in changes if change.code == ROW_TO_THE_POINT), None)
    if missing is None:
        return ()
    place = missing.places[0][0]
    start = kept[place - 1] + 1 if place else 0
    return tuple(range(start, kept[place] if place < len(kept) else rows))[:1]


def _are_as_likely(repairs: Sequence[Repaired], others: Sequence[Repaired]) -> bool:
    """Whether repairs of a table with a row of zeros are as likely as those without: none is missing then."""
    if any(change.code == ROW_TO_THE_POINT for change in others[0].changes):
        return True
    return len(repairs[0].changes) <= len(others[0].changes)


def _row_without_its_variable(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: Mapping[str, float],
    kept: Sequence[int],
) -> tuple[int, ...]:
    """The row of zeros, from 0, with which a table is right once the variable of a joint stands in it."""
    wanted, rows = reference.table.joint_types, submission.table.rows
    if submission.table.n_joints != len(wanted) - 1:
        return ()
    # Of rows of zeros that follow each other the first speaks for all.
    for i in (i for i in range(len(rows)) if i not in kept and (i == 0 or i - 1 in kept)):
        joint = wanted[sum(row.joint is not JointType.FIXED for row in rows[:i])]
        moving = (*rows[:i], replace(rows[i], joint=joint), *rows[i + 1 :])
        table = replace(submission, table=replace(submission.table, rows=moving))
        if is_accepted(reference, table, policy, parameters):
            return (i,)
    return ()


@cached_by_size(
    lambda reference, submission, policy, parameters: _most_rows(reference, submission),
    longest=USUAL_ROWS,
    most=CACHED_VERDICTS,
    few=64,
)
def _decided(
    reference: ReadTable,
    submission: ReadTable,
    policy: Policy,
    parameters: tuple[tuple[str, float], ...],
) -> Verdict | Refused:
    """The verdict on a right answer; of a wrong one the decision that says most."""
    ways: list[Comparison] = []
    decisions: list[Decision] = []
    for way in comparisons(reference, submission, dict(parameters)):
        decision = judged(way, policy)
        if decision.accepted:
            return _accepted(decision, way, submission)
        telling = way if decision is REFUTED else with_a_telling_draw_first(way, policy)
        told = decision if telling is way else judged(telling, policy)
        decisions.append(as_typed(told, telling, (reference, submission), policy))
        ways.append(telling)
    return clearest(decisions, ways, (reference, submission), policy)


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
