"""What students really type: rounded numbers, other rules, several mistakes at once. Nothing may crash."""

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from random import Random

from exercises.answers import RawAnswer
from exercises.definition import Exercise
from exercises.errors import AnswerError
from exercises.grading import BaseRule, DirectionRule, Policy, ToolRule, Verdict, ZeroRule
from exercises.instance import Instance, generate
from exercises.parts.protocol import TABLE
from exercises.selftest.answers import judged_answer, other_frames
from exercises.selftest.findings import Findings
from exercises.selftest.mistakes import MISTAKES
from exercises.selftest.variants import key_as_asked
from exercises.written_table import written_table
from kinematics.cells import AngleUnit, RawTable, ReadTable, parameters_in_radians
from kinematics.errors import KinematicsError
from kinematics.expressions import Expression, Number, evaluate, pi_fraction, pi_times
from kinematics.table import ANGLES, CELLS, DHRow, DHTable, SymbolicRow

DIGITS = 4  # Significant digits to which students round on paper.

PAIRS = 3  # Tables with two mistakes that are tried for each seed.


def check_robustness(findings: Findings, instance: Instance, rng: Random, mistakes: int | None) -> None:
    """Check rounded tables, every tool rule, pairs of mistakes and the strictest policy."""
    read = other_frames(instance, rng)
    _check_rounded(findings, instance, read)
    for rule in ToolRule:
        strict = _held_to(instance, replace(instance.exercise.policy, tool=rule))
        right = other_frames(strict, rng)
        verdict = _verdict(findings, strict, written_table(right))
        if verdict is not None:
            findings.expect("tool_rule", verdict.correct, rule=rule.value, table=written_table(right))
            _check_rounded(findings, strict, right)
    strictest = _held_to(instance, strictest_policy(instance.exercise.policy))
    for case in (instance, strictest):
        base = key_as_asked(case.exercise.reference, case.exercise.policy) if case is strictest else read
        for wrong in islice(pairs(case.exercise, base, rng), PAIRS if mistakes is None else 1):
            if _verdict(findings, case, written_table(wrong)) is not None:
                findings.passed["pair"] += 1


def strictest_policy(policy: Policy) -> Policy:
    """Return the policy that leaves nothing free but the convention."""
    return replace(
        policy, base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
    )


def pairs(exercise: Exercise, read: ReadTable, rng: Random) -> Iterator[ReadTable]:
    """Yield tables with a listed misconception and a row missing."""
    codes = list(exercise.misconceptions)
    rng.shuffle(codes)
    for code in codes:
        ways = list(MISTAKES[code](read))
        shorter = list(MISTAKES["row_missing"](rng.choice(ways))) if ways else []
        if shorter:
            yield rng.choice(shorter)


def rounded(instance: Instance, read: ReadTable) -> ReadTable | None:
    """Return the table in the student's own numbers, to four digits; None if a cell has no value.

    Right angles and their like stay exact: nobody rounds 90.
    """
    values = parameters_in_radians(instance.parameters, read.parameters, read.angle_unit)
    degrees = read.angle_unit is AngleUnit.DEG

    def number(entry: Expression, *, angle: bool) -> Expression:
        turns = pi_fraction(entry)
        if turns is not None and (turns * 12).denominator == 1:
            return entry
        value = evaluate(entry, values)
        if angle and degrees:
            return pi_times(Fraction(f"{math.degrees(value):.{DIGITS}g}") / 180)
        return Number(Fraction(f"{value:.{DIGITS}g}"))

    def rounded_row(row: SymbolicRow) -> SymbolicRow:
        cells = {cell: number(getattr(row, cell), angle=cell in ANGLES) for cell in CELLS}
        return DHRow(joint=row.joint, sign=row.sign, **cells)

    try:
        rows = tuple(map(rounded_row, read.table.rows))
    except KinematicsError:
        return None
    return replace(read, table=DHTable(convention=read.table.convention, rows=rows), parameters={})


def _check_rounded(findings: Findings, instance: Instance, read: ReadTable) -> None:
    numbers = rounded(instance, read)
    if numbers is None:
        return
    verdict = _verdict(findings, instance, written_table(numbers))
    if verdict is not None:
        rule = instance.exercise.policy.tool.value
        findings.expect("rounded", verdict.correct, digits=DIGITS, rule=rule, table=written_table(numbers))


def _held_to(instance: Instance, policy: Policy) -> Instance:
    return generate(replace(instance.exercise, policy=policy), instance.seed)


def _verdict(findings: Findings, instance: Instance, raw: RawTable) -> Verdict | None:
    """Return the verdict on a table; None if it is refused, or if grading it fails."""
    try:
        return judged_answer(instance, RawAnswer(**{TABLE: raw})).verdict
    except AnswerError:
        findings.passed["refused"] += 1
    except Exception as error:
        findings.fail("crash", seed=instance.seed, reason=f"{type(error).__name__}: {error} ({raw})")
    return None
