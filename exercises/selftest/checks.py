"""All checks of one exercise, over many seeds."""

import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from itertools import combinations
from random import Random

import numpy as np

from exercises.answers import RawAnswer
from exercises.definition import Exercise
from exercises.drawings import figure_drawing, true_scene
from exercises.draws import is_alike
from exercises.errors import DefinitionError
from exercises.grading import HelpLevel, Verdict
from exercises.grading.score import weight_to_earn
from exercises.instance import Instance, generate
from exercises.needs import rules_that_need, unneeded_dimensions
from exercises.parts.cells.short_forms import is_short_form
from exercises.parts.protocol import TABLE
from exercises.parts.registry import part_type
from exercises.parts.report import Credit
from exercises.selftest.answers import (
    answer_from,
    context_of,
    is_refused,
    judged_answer,
    other_frames,
    taken_by_slides,
)
from exercises.selftest.findings import Findings
from exercises.selftest.mistakes import MISTAKES
from exercises.selftest.robustness import check_robustness
from exercises.selftest.structure import structure_of, values_of_other_structure
from exercises.selftest.variants import key_as_asked
from exercises.written_table import written_table
from kinematics.cells import ParameterKind, RawRow, RawTable, ReadTable, in_length_unit, parameters_in_radians
from kinematics.chain import chain_of_table, size_of
from kinematics.forward import forward_kinematics
from kinematics.printing.numbers import fraction_as_decimal
from kinematics.se3 import Transform
from kinematics.table import JointType, NumericTable, bind

CONFIGURATIONS = 5
"""Joint values, drawn anew for each seed, at which a certificate is evaluated: one would show a wrong one."""
LOST = frozenset(
    {"columns_late", "columns_early", "twists_late", "twists_early", "row_missing", "joint_fixed"}
)
"""Mistakes that may lose what the table said; then no edit can tell it again."""


def check(exercise: Exercise, seeds: int, mistakes: int | None = None) -> Findings:
    """Test an exercise by itself.

    Args:
        seeds: how many students' values, and how many ways to write the table.
        mistakes: how many of the listed mistakes are made for each seed; None: all of them.
    """
    return check_values((None, *range(seeds)), exercise, mistakes)


def check_values(
    seeds: Iterable[int | str | None], exercise: Exercise, mistakes: int | None = None
) -> Findings:
    """Test an exercise by itself with the values of some seeds, None being the usual values.

    See `check`.
    """
    findings = Findings(exercise.id)
    with_table = exercise.part(TABLE) is not None
    seeds = tuple(seeds)
    for seed in seeds:
        rng = Random(f"{exercise.id} {seed}")  # noqa: S311 - tests want repeatable numbers
        with _crashes(findings, seed):
            instance = generate(exercise, seed)
            _check_drawn(findings, instance)
            if with_table:
                _check_right(findings, instance, rng)
                _check_mistakes(findings, instance, rng, mistakes)
                check_robustness(findings, instance, rng, mistakes)
            _check_parts(findings, instance, rng)
    with _crashes(findings, None):
        for name, value in values_of_other_structure(exercise):
            findings.fail("drawn_structure", name=name, value=fraction_as_decimal(value) or value)
        for part in exercise.parts:
            for code in part_type(part.kind).warnings(part, exercise):
                findings.warn(code, kind=part.kind)
        if any(part.kind != TABLE for part in exercise.parts):
            for name in filter(is_short_form, (*exercise.reference.parameters, *exercise.aliases)):
                findings.warn("taken_by_short_form", name=name)
        if with_table:
            _check_invalid(findings, exercise)
            _check_samples(findings, exercise)
            _check_earnings(findings, exercise)
            for name in unneeded_dimensions(exercise):
                rules = "; ".join(rules_that_need(exercise, name)) or "none"
                findings.warn("unneeded", name=name, rules=rules)
            for name in sorted(taken_by_slides(exercise)):
                findings.warn("taken_by_slide", name=name, joint=name.removeprefix("d"))
            for name, other in _alike(exercise, seeds):
                findings.warn("alike", name=name, other=other)
    return findings


def _check_earnings(findings: Findings, exercise: Exercise) -> None:
    """There is something to describe, and a wrong table may earn a part of the points."""
    key = bind(exercise.reference.table, generate(exercise).values)
    if not key.n_joints:
        findings.warn("no_joints")
    elif not weight_to_earn(key, exercise.policy, exercise.weights):
        findings.warn("nothing_earned")


def _alike(exercise: Exercise, seeds: Iterable[int | str | None]) -> list[tuple[str, str]]:
    """Dimensions, two by two, that some students may exchange in an answer in numbers, and nobody sees it.

    The usual values are those of students only where nothing is drawn.
    """
    drawn = any(parameter.draw for parameter in exercise.parameters)
    students = [generate(exercise, seed) for seed in seeds if seed is not None or not drawn]
    kinds = exercise.reference.parameters
    lengths = [name for name in generate(exercise).exact if kinds.get(name) is ParameterKind.LENGTH]
    return [
        (one, other)
        for one, other in combinations(lengths, 2)
        if any(is_alike(student.exact[one], (abs(student.exact[other]),)) for student in students)
    ]


@contextmanager
def _crashes(findings: Findings, seed: int | str | None) -> Iterator[None]:
    """What goes wrong inside is a failure of the exercise, whatever it is: a student would meet it too."""
    try:
        yield
    except Exception as error:
        findings.fail("crash", seed=seed, reason=f"{type(error).__name__}: {error}")


def _check_drawn(findings: Findings, instance: Instance) -> None:
    """A student's own values leave the structure as it is, and the figure can be drawn."""
    usual = structure_of(generate(instance.exercise))
    findings.expect("structure", structure_of(instance) == usual, seed=instance.seed)
    try:
        true_scene(instance)
        figure_drawing(instance)
    except DefinitionError as error:
        findings.fail("figure", seed=instance.seed, reason=error.code)
    else:
        findings.passed["figure"] += 1


def _check_right(findings: Findings, instance: Instance, rng: Random) -> None:
    """The key itself, and the key as others would have written it."""
    exercise = instance.exercise
    for read in (key_as_asked(exercise.reference, exercise.policy), other_frames(instance, rng)):
        verdict = judged_answer(instance, RawAnswer(table=written_table(read))).verdict
        assert verdict is not None
        findings.expect("right", verdict.correct, table=written_table(read))
        if verdict.correct:
            holds = certificate_holds(instance, read, verdict, rng)
            findings.expect("certificate", holds, table=written_table(read))


def _check_mistakes(findings: Findings, instance: Instance, rng: Random, most: int | None) -> None:
    """Every listed mistake is rejected and explained, or shown by its certificate to be none."""
    listed = instance.exercise.misconceptions
    for code in listed if most is None else rng.sample(listed, min(most, len(listed))):
        ways = list(MISTAKES[code](other_frames(instance, rng)))
        if not ways:
            continue
        wrong = rng.choice(ways)
        raw = written_table(wrong)
        if is_refused(instance.exercise, raw):
            findings.passed["refused"] += 1  # a slide of joint 1 beside a length d1, say
            continue
        verdict = judged_answer(instance, RawAnswer(table=raw)).verdict
        assert verdict is not None
        if verdict.correct:
            findings.expect("harmless", certificate_holds(instance, wrong, verdict, rng), table=raw)
            continue
        explained = any(len(repair.edits) == 1 for repair in verdict.repairs)
        known = explained or code in LOST or told_at_most(instance)
        findings.expect("mistake", verdict.score < 1.0 and known, mistake=code, table=raw)


def _check_parts(findings: Findings, instance: Instance, rng: Random) -> None:
    """All parts of a right table earn all points; what follows from a wrong one earns its own."""
    exercise = instance.exercise
    read = other_frames(instance, rng)
    for report in judged_answer(instance, answer_from(instance, read)).parts:
        findings.expect("part", report.correct, part=report.kind, seed=instance.seed)
    _check_wrong_parts(findings, instance, read, rng)
    wrong = next(iter(MISTAKES["a_d_swapped"](key_as_asked(exercise.reference, exercise.policy))), None)
    if wrong is None:
        return
    following = judged_answer(instance, answer_from(instance, wrong))
    if following.verdict is None or following.verdict.correct:
        return
    for report in following.parts:
        if part_type(report.kind).follows_table:
            earns = report.score == 1.0 and report.credit is Credit.OWN_TABLE and not report.correct
            findings.expect("follow_through", earns, part=report.kind, seed=instance.seed)


def _check_wrong_parts(findings: Findings, instance: Instance, read: ReadTable, rng: Random) -> None:
    """Each part's own wrong answers beside a right table are rejected and told as what they are."""
    context = context_of(instance, read)
    right = answer_from(instance, read)
    for part in instance.exercise.parts:
        if part.kind == TABLE:
            continue  # its misconceptions have a check of their own
        for code, raw in part_type(part.kind).wrong(part, context, rng):
            judged = judged_answer(instance, RawAnswer(**{**right.parts, part.kind: raw}))
            report = next(found for found in judged.parts if found.kind == part.kind)
            told = {entry.code for entry in report.feedback}
            known = not report.correct and report.score < 1.0 and (told_at_most(instance) or code in told)
            findings.expect(
                "wrong_part",
                known,
                part=part.kind,
                seed=instance.seed,
                mistake=code,
                told=", ".join(sorted(told)),
            )


def told_at_most(instance: Instance) -> bool:
    """Return whether the exercise's help level keeps some explanations back."""
    return instance.exercise.help is not HelpLevel.REPAIR


def _check_invalid(findings: Findings, exercise: Exercise) -> None:
    """What is malformed is refused, not graded."""
    for name, raw in malformed(written_table(exercise.reference)):
        findings.expect("invalid", is_refused(exercise, raw), name=name)


def malformed(right: RawTable) -> Iterator[tuple[str, RawTable]]:
    """Yield the tables that nobody can grade."""
    first = right.rows[0]

    def starting_with(row: RawRow) -> RawTable:
        return replace(right, rows=(row, *right.rows[1:]))

    yield "no_rows", replace(right, rows=())
    yield "open_parenthesis", starting_with(replace(first, a="(1"))
    yield "empty_cell", starting_with(replace(first, d=""))
    yield "scaled_variable", starting_with(replace(first, joint=JointType.REVOLUTE, theta="2*q1", d=0))
    yield "variable_as_length", starting_with(replace(first, a="q1"))
    yield "infinite_number", starting_with(replace(first, a="1/0"))


def _check_samples(findings: Findings, exercise: Exercise) -> None:
    """The definition's own samples are judged as it says."""
    instance = generate(exercise)
    for sample in exercise.samples:
        if sample.correct is None:
            findings.expect("sample", is_refused(exercise, sample.table), name=sample.name, told="")
            continue
        verdict = judged_answer(instance, RawAnswer(table=sample.table)).verdict
        assert verdict is not None
        told = {entry.code for entry in verdict.feedback}
        fits = verdict.correct is sample.correct and set(sample.feedback) <= told
        findings.expect("sample", fits, name=sample.name, told=", ".join(sorted(told)))


def certificate_holds(instance: Instance, read: ReadTable, verdict: Verdict, rng: Random) -> bool:
    """Return whether F_s(σ∘q + δ) = B · F_r(q) · E, evaluated here and now."""
    certificate = verdict.certificate
    assert certificate is not None
    exercise = instance.exercise
    reference = in_length_unit(exercise.reference, read.length_unit)
    known = {**instance.values_in(read.length_unit), **certificate.parameters}
    given = parameters_in_radians(known, {**read.parameters, **reference.parameters}, read.angle_unit)
    ours, theirs = bind(reference.table, given), bind(read.table, given)
    size = size_of(chain_of_table(ours)) or 1.0
    offsets = [
        read.angle_unit.in_radians(value) if joint_type is JointType.REVOLUTE else value
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
