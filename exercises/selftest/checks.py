"""All checks of one exercise, over many seeds."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from random import Random

import numpy as np

from exercises.answers import RawAnswer, parse
from exercises.definition import Exercise
from exercises.drawings import figure_svg, true_scene, values
from exercises.errors import AnswerError, DefinitionError
from exercises.grader import Report, grade
from exercises.grading import HelpLevel, Verdict
from exercises.instance import Instance, generate
from exercises.parts.protocol import TABLE, values_in_unit
from exercises.parts.registry import part_type
from exercises.parts.report import Credit
from exercises.parts.schematic import schematic_of
from exercises.selftest.answers import answer_from, context_of
from exercises.selftest.mistakes import MISTAKES
from exercises.selftest.typed import typed
from exercises.selftest.variants import some_lengths, variant
from kinematics.cells import AngleUnit, ParameterKind, RawRow, RawTable, ReadTable, in_length_unit
from kinematics.chain import chain_of_table, size_of
from kinematics.forward import forward_kinematics
from kinematics.se3 import Transform
from kinematics.table import JointType, NumericTable, bind

CONFIGURATIONS = 5
LOST = frozenset({"columns_late", "columns_early", "row_missing", "joint_fixed"})
"""Mistakes that may lose what the table said; then no edit can tell it again."""


@dataclass(slots=True)
class Findings:
    """What was checked, and what failed.

    Attributes:
        exercise: its id.
        passed: how many checks of each kind passed.
        failures: the others, in words.
    """

    exercise: str
    passed: Counter[str] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)

    def expect(self, kind: str, holds: bool, failure: Callable[[], str]) -> None:
        """Count a check, or keep what failed."""
        if holds:
            self.passed[kind] += 1
        else:
            self.failures.append(f"{kind}: {failure()}")


def check(exercise: Exercise, seeds: int, mistakes: int | None = None) -> Findings:
    """Test an exercise by itself.

    Args:
        exercise: the exercise.
        seeds: how many students' values, and how many ways to write the table.
        mistakes: how many of the listed mistakes are made for each seed; None: all of them.
    """
    findings = Findings(exercise.id)
    for seed in (None, *range(seeds)):
        instance = generate(exercise, seed)
        rng = Random(f"{exercise.id} {seed}")  # noqa: S311 - tests want repeatable numbers
        _check_values(findings, instance)
        _check_right(findings, instance, rng)
        _check_mistakes(findings, instance, rng, mistakes)
        _check_parts(findings, instance, rng)
    _check_invalid(findings, exercise)
    _check_samples(findings, exercise)
    return findings


def _check_values(findings: Findings, instance: Instance) -> None:
    """A student's own values leave the structure as it is, and the figure can be drawn."""
    exercise = instance.exercise
    usual, own = (
        schematic_of(bind(exercise.reference.table, values(which)))
        for which in (generate(exercise), instance)
    )
    findings.expect("structure", usual == own, lambda: f"seed {instance.seed} changes the robot's structure")
    try:
        true_scene(instance)
        figure_svg(instance, title=exercise.id, description="", language="en")
    except DefinitionError as error:
        findings.failures.append(f"figure: seed {instance.seed}: {error}")
    else:
        findings.passed["figure"] += 1


def _check_right(findings: Findings, instance: Instance, rng: Random) -> None:
    """The key itself, and the key as others would have written it."""
    for read in (instance.exercise.reference, _other(instance, rng)):
        verdict = _judged(instance, RawAnswer(table=typed(read))).verdict
        assert verdict is not None
        findings.expect("right", verdict.correct, lambda read=read: f"{typed(read)} is rejected")  # type: ignore[misc]
        if verdict.correct:
            holds = certificate_holds(instance, read, verdict, rng)
            findings.expect(
                "certificate",
                holds,
                lambda read=read: f"the certificate of {typed(read)} does not hold",  # type: ignore[misc]
            )


def _check_mistakes(findings: Findings, instance: Instance, rng: Random, most: int | None) -> None:
    """Every listed mistake is rejected and explained, or shown by its certificate to be none."""
    listed = instance.exercise.misconceptions
    for code in listed if most is None else rng.sample(listed, min(most, len(listed))):
        ways = list(MISTAKES[code](_other(instance, rng)))
        if not ways:
            continue
        wrong = rng.choice(ways)
        raw = typed(wrong)
        if _is_refused(instance.exercise, raw):
            findings.passed["refused"] += 1  # a slide of joint 1 beside a length d1, say
            continue
        verdict = _judged(instance, RawAnswer(table=raw)).verdict
        assert verdict is not None
        if verdict.correct:
            holds = certificate_holds(instance, wrong, verdict, rng)
            findings.expect("harmless", holds, lambda wrong=wrong: f"{typed(wrong)} is accepted")  # type: ignore[misc]
            continue
        explained = any(len(repair.edits) == 1 for repair in verdict.repairs)
        findings.expect(
            code,
            verdict.score < 1.0 and (explained or code in LOST),
            lambda wrong=wrong, code=code: f"{code} in {typed(wrong)} is not explained",  # type: ignore[misc]
        )


def _check_parts(findings: Findings, instance: Instance, rng: Random) -> None:
    """All parts of a right table earn full marks; what follows from a wrong one earns its own."""
    exercise = instance.exercise
    read = _other(instance, rng)
    right = _judged(instance, answer_from(instance, read))
    for report in right.parts:
        findings.expect(
            report.kind,
            report.correct,
            lambda report=report: f"seed {instance.seed}: {report}",  # type: ignore[misc]
        )
    _check_wrong_parts(findings, instance, read, rng)
    wrong = next(iter(MISTAKES["a_d_swapped"](exercise.reference)), None)
    if wrong is None:
        return
    following = _judged(instance, answer_from(instance, wrong))
    if following.verdict is None or following.verdict.correct:
        return
    for report in following.parts:
        if part_type(report.kind).follows_table:
            findings.expect(
                "follow_through",
                report.score == 1.0 and report.credit is Credit.OWN_TABLE and not report.correct,
                lambda report=report: f"seed {instance.seed}: {report}",  # type: ignore[misc]
            )


def _check_wrong_parts(findings: Findings, instance: Instance, read: ReadTable, rng: Random) -> None:
    """Each part's own wrong answers beside a right table are rejected and told as what they are."""
    context = context_of(instance, read)
    right = answer_from(instance, read)
    for part in instance.exercise.parts:
        if part.kind == TABLE:
            continue  # its misconceptions have a check of their own
        for code, raw in part_type(part.kind).wrong(part, context, rng):
            judged = _judged(instance, RawAnswer(**{**right.parts, part.kind: raw}))
            report = next(found for found in judged.parts if found.kind == part.kind)
            told = {entry.code for entry in report.feedback}
            findings.expect(
                f"wrong_{part.kind}",
                not report.correct and report.score < 1.0 and (told_at_most(instance) or code in told),
                lambda code=code, report=report: f"seed {instance.seed}: {code} is told as {report}",  # type: ignore[misc]
            )


def told_at_most(instance: Instance) -> bool:
    """Return whether the exercise's help level keeps some explanations back."""
    return instance.exercise.help is not HelpLevel.REPAIR


def _check_invalid(findings: Findings, exercise: Exercise) -> None:
    """What is malformed is refused, not graded."""
    for name, raw in malformed(typed(exercise.reference)):
        findings.expect("invalid", _is_refused(exercise, raw), lambda name=name: f"{name} is graded")  # type: ignore[misc]


def malformed(right: RawTable) -> Iterator[tuple[str, RawTable]]:
    """Tables that nobody can grade."""
    first = right.rows[0]

    def starting_with(row: RawRow) -> RawTable:
        return replace(right, rows=(row, *right.rows[1:]))

    yield "a table without rows", replace(right, rows=())
    yield "an open parenthesis", starting_with(replace(first, a="(1"))
    yield "an empty cell", starting_with(replace(first, d=""))
    yield "a scaled variable", starting_with(replace(first, joint=JointType.REVOLUTE, theta="2*q1", d=0))
    yield "a variable as a length", starting_with(replace(first, a="q1"))
    yield "an infinite number", starting_with(replace(first, a="1/0"))


def _check_samples(findings: Findings, exercise: Exercise) -> None:
    """The definition's own samples are judged as it says."""
    instance = generate(exercise)
    for sample in exercise.samples:
        if sample.correct is None:
            findings.expect(
                "sample",
                _is_refused(exercise, sample.table),
                lambda sample=sample: f"{sample.name} is graded",  # type: ignore[misc]
            )
            continue
        verdict = _judged(instance, RawAnswer(table=sample.table)).verdict
        assert verdict is not None
        told = {entry.code for entry in verdict.feedback}
        findings.expect(
            "sample",
            verdict.correct is sample.correct and set(sample.feedback) <= told,
            lambda sample=sample, told=told: f"{sample.name}: told {sorted(told)}",  # type: ignore[misc]
        )


def certificate_holds(instance: Instance, read: ReadTable, verdict: Verdict, rng: Random) -> bool:
    """Whether F_s(σ∘q + δ) = B · F_r(q) · E, evaluated here and now."""
    certificate = verdict.certificate
    assert certificate is not None
    exercise = instance.exercise
    reference = in_length_unit(exercise.reference, read.length_unit)
    degrees = read.angle_unit is AngleUnit.DEG
    kinds = {**read.parameters, **reference.parameters}
    given = {
        name: math.radians(value) if degrees and kinds[name] is ParameterKind.ANGLE else value
        for name, value in {**values_in_unit(instance, read.length_unit), **certificate.parameters}.items()
    }
    ours, theirs = bind(reference.table, given), bind(read.table, given)
    size = size_of(chain_of_table(ours)) or 1.0
    offsets = [
        math.radians(value) if degrees and joint_type is JointType.REVOLUTE else value
        for value, joint_type in zip(certificate.joint_offsets, ours.joint_types, strict=True)
    ]
    tolerance = exercise.policy.tolerance
    for _ in range(CONFIGURATIONS):
        q = [rng.uniform(-1, 1) * (math.pi if t is JointType.REVOLUTE else size) for t in ours.joint_types]
        turned = [s * v + o for s, v, o in zip(certificate.joint_signs, q, offsets, strict=True)]
        off = _pose(theirs, turned) - np.array(certificate.base) @ _pose(ours, q) @ np.array(certificate.tool)
        if np.abs(off[:3, :3]).max() > tolerance.angle or np.abs(off[:3, 3]).max() > tolerance.length * size:
            return False
    return True


def _pose(table: NumericTable, joints: list[float]) -> Transform:
    return forward_kinematics(table, joints).transform


def _other(instance: Instance, rng: Random) -> ReadTable:
    """The key in other frames."""
    exercise = instance.exercise
    usual = size_of(chain_of_table(bind(exercise.reference.table, values(instance)))) / 4
    lengths = some_lengths(exercise.reference.table, usual)
    table = variant(exercise.reference.table, exercise.policy, lengths, rng)
    return replace(exercise.reference, table=table)


def _judged(instance: Instance, raw: RawAnswer) -> Report:
    return grade(instance, parse(instance, raw))


def _is_refused(exercise: Exercise, raw: RawTable) -> bool:
    try:
        parse(generate(exercise), RawAnswer(table=raw))
    except AnswerError:
        return True
    return False
