"""Answers as students type them: rounded, in names, wrong in several places, padded; see `campaign`."""

import math
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import islice, pairwise
from random import Random

import numpy as np

from exercises.grading import HelpLevel, Policy, ToolRule, grade, is_accepted
from exercises.grading.judging.comparison import comparisons
from exercises.grading.judging.judgement import judged
from exercises.selftest.variants import some_lengths, variant
from kinematics.catalogue import robots
from kinematics.cells import RawRow, RawTable, ReadTable, read_table
from kinematics.cells.substitution import substitute
from kinematics.chain import chain_of_table
from kinematics.equivalence import Certificate, rounding_tolerance
from kinematics.equivalence.decision import certify
from kinematics.equivalence.reference import prepared
from kinematics.expressions import ZERO, Expression, Number, Parameter, add, multiply, parameters_in, pi_times
from kinematics.table import CELLS, Convention, DHRow, DHTable, JointType, NumericTable, SymbolicTable, bind
from service.work.collection import new_objects_alone
from tests.exercises.grading.campaign import lost_explanations
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import (
    EXACT,
    TABLES_PER_BLOCK,
    Outcome,
    catalogue,
    confirm,
    random_rules,
    references,
)
from tests.kinematics.equivalence.generators import (
    cross,
    length_of,
    random_valid_table,
    robot_at,
    rounded,
)
from tests.kinematics.equivalence.mutations import mutations, with_rows
from tests.kinematics.equivalence.strict_generator import strict_table

STUDENTS = 2
MANY_STUDENTS = 20
SCORED = 20
"""One wrong name in so many is scored, too, for many students."""
WRITTEN_OTHERWISE = 0.8
"""Share of the answers in names that are no copy of the key."""
LONGEST = 10.0
MOST_SECONDS = 0.5
"""Of processor time, on the machine of the campaign."""
JUNK = 58
SIX_JOINTS = 6
EVALUATED_AGAIN = 20
"""One certificate in so many is evaluated again."""
WITH_A_SLIP = 4
"""One table in so many is handed in once more with a slip."""
PER_CENT = 0.01
"""What an exercise allows of an angle or a length."""
SECOND_ORDER = 1.5
"""What rounding does is bounded to first order; the rest has half as much again."""
NOTHING = 1e-7
NEARLY_PARALLEL = 0.1
"""Sine of an angle below which rounding moves the common normal too far to compare distances."""


@cache
def symbolic_robots() -> list[tuple[str, ReadTable, dict[str, float]]]:
    """The robots of the catalogue with their names, and the values of these."""
    return [(robot.id, robot.table, dict(robot.parameters)) for robot in robots()]


def slanted_robot(rng: Random) -> SymbolicTable:
    """A robot with twists of 30°, 45° and 60° among right ones, and lengths of three digits."""

    def length() -> Expression:
        return Number(Fraction(rng.choice((0, 0, rng.randint(50, 900))), 1000))

    rows = tuple(
        DHRow(
            joint=JointType.PRISMATIC if rng.random() < 0.15 else JointType.REVOLUTE,
            theta=ZERO,
            d=length(),
            a=length(),
            alpha=pi_times(Fraction(rng.choice((0, 6, -6, 3, -3, 4, 2, 8)), 12)),
        )
        for _ in range(rng.randint(2, 6))
    )
    return DHTable(convention=rng.choice(list(Convention)), rows=rows)


def as_typed(table: NumericTable, decimals: int) -> ReadTable:
    """The table with every entry rounded to some decimals, as text."""
    rows, joint = [], 0
    for row in table.rows:
        theta, d = f"{row.theta:.{decimals}f}", f"{row.d:.{decimals}f}"
        if row.joint is not JointType.FIXED:
            joint += 1
            variable = f"{'-' if row.sign < 0 else ''}q{joint}"
            theta = f"{variable} + ({theta})" if row.joint is JointType.REVOLUTE else theta
            d = f"{variable} + ({d})" if row.joint is JointType.PRISMATIC else d
        a, alpha = f"{row.a:.{decimals}f}", f"{row.alpha:.{decimals}f}"
        rows.append(RawRow(joint=row.joint, alpha=alpha, a=a, d=d, theta=theta))
    return read_table(RawTable(convention=table.convention, rows=tuple(rows)))


def rounded_answers(block: int, tables: int = TABLES_PER_BLOCK) -> Outcome:
    """Valid answers rounded to three, four or five decimals, under any rules, are accepted.

    Left out are those whose rounding may do more than the tolerance, by the bound of `rounding_tolerance`.
    Some are handed in once more with one length or twist slightly wrong: whatever is accepted then has a
    certificate that stands, and angles and distances of neighbouring axes that its digits explain (`beyond`).
    """
    rng = Random(f"rounded answers {block}")
    outcome = Outcome()
    while outcome.tables < tables:
        name, read, values = rng.choice(symbolic_robots())
        key = read.table if rng.random() < 0.4 else slanted_robot(rng)
        policy, decimals = random_rules(rng), rng.choice((3, 4, 5))
        reference = bind(key, values)
        if rng.random() < 0.5:
            table = strict_table(reference, policy, rng)
        else:
            table = bind(variant(key, policy, some_lengths(key, 0.3), rng), values)
        if max(abs(x) for row in (*table.rows, *reference.rows) for x in (row.a, row.d)) > LONGEST:
            continue
        step = 10.0**-decimals
        bound = rounding_tolerance(reference, table, length_step=step, angle_step=step)
        if bound.length > policy.tolerance.length or bound.angle > policy.tolerance.angle:
            outcome.left_out += 1
            continue
        outcome.tables += 1
        outcome.kinds[f"{policy.tool.value}, {decimals} decimals"] += 1
        place = f"{name}, block {block}, table {outcome.tables}, {policy}, {decimals} decimals"
        known = written(reference)
        if (certificate := certificate_of(known, as_typed(table, decimals), policy)) is None:
            outcome.failures.append(f"rejected: {place}")
        else:
            outcome.accepted += 1
            if outcome.tables % EVALUATED_AGAIN == 0:
                confirm(outcome, reference, rounded(table, decimals), certificate, policy.tolerance, place)
        if outcome.tables % WITH_A_SLIP:
            continue
        wrong = slightly_wrong(table, step, rng)
        if (certificate := certificate_of(known, as_typed(wrong, decimals), policy)) is not None:
            outcome.kinds["accepted with a slip"] += 1
            wrong = rounded(wrong, decimals)
            if outcome.tables % EVALUATED_AGAIN == 0:
                confirm(outcome, reference, wrong, certificate, policy.tolerance, f"{place}, with a slip")
            outcome.failures += [f"{what} accepted: {place}" for what in beyond(reference, wrong, step / 2)]
    return outcome


def certificate_of(key: ReadTable, answer: ReadTable, policy: Policy) -> Certificate | None:
    """What an answer in numbers is accepted for, without the explanations that `accept` adds."""
    (way,) = comparisons(key, answer, None)
    return judged(way, policy).certificate


def slightly_wrong(table: NumericTable, step: float, rng: Random) -> NumericTable:
    """The table with one length or twist off by one to ten per cent, or by some units of its last place."""
    i = rng.randrange(len(table.rows))
    row = table.rows[i]
    cell = rng.choice(("a", "alpha") if row.joint is JointType.PRISMATIC else ("a", "d", "alpha"))
    here = getattr(row, cell)
    off = rng.choice((-1, 1)) * rng.choice((here * rng.uniform(0.01, 0.1), step * rng.uniform(1.0, 50.0)))
    return with_rows(table, [*table.rows[:i], replace(row, **{cell: here + off}), *table.rows[i + 1 :]])


def beyond(reference: NumericTable, table: NumericTable, half: float) -> list[str]:
    """Which angles and distances of neighbouring axes are off by more than a per cent and the digits.

    Args:
        reference: the key.
        table: an answer, rounded.
        half: half a unit of its last place.
    """
    wanted, here = neighbours(reference), neighbours(table)
    off = np.abs(here - wanted) - NOTHING
    if (off <= PER_CENT * wanted).all():
        return []
    room = np.zeros_like(here)
    for i, row in enumerate(table.rows):
        for cell in ("alpha", "a", "d", "theta"):
            either = [
                neighbours(with_rows(table, [*table.rows[:i], changed, *table.rows[i + 1 :]]))
                for changed in (replace(row, **{cell: getattr(row, cell) + s * half}) for s in (-1, 1))
            ]
            room += np.abs(np.array(either) - here).max(axis=0)
    far = off > np.maximum(PER_CENT * wanted, SECOND_ORDER * room)
    return [f"{here[k]:.6g} for {wanted[k]:.6g}" for k in np.flatnonzero(far)]


def neighbours(table: NumericTable) -> np.ndarray:
    """Return angles between neighbouring axes, and distances of those that nothing slides along."""
    found: list[float] = []
    for one, two in pairwise(robot_at(table, (0.0,) * table.n_joints).joints):
        normal = cross(one.direction, two.direction)
        sine, apart = length_of(normal), two.point - one.point
        found.append(math.atan2(sine, abs(float(one.direction @ two.direction))))
        if JointType.PRISMATIC not in (one.type, two.type) and sine > NEARLY_PARALLEL:
            found.append(abs(float(apart @ normal)) / sine)
        else:
            found.append(0.0)
    return np.array(found)


def wrong_names(block: int, tables: int = TABLES_PER_BLOCK) -> Outcome:
    """One name made wrong in a valid table: one verdict for every student, and none accepts it.

    Each is judged for two students, and one in so many for twenty, who also get the same score. Answers that
    are right in spite of it (a height of the base) come on top: they are right at fresh values, too, by a
    certificate that stands there.
    """
    rng = Random(f"names {block}")
    outcome = Outcome()
    named = [robot for robot in symbolic_robots() if robot[1].parameters]
    while outcome.tables < tables:
        name, key, values = rng.choice(named)
        answer = _misnamed(key, rng)
        if answer is None:
            continue
        place = f"{name}, block {block}, table {outcome.tables + 1}"
        scored = outcome.tables % SCORED == 0
        students = [
            {n: v * rng.choice((0.5, 1.0, 1.0, 2.0)) for n, v in values.items()}
            for _ in range(MANY_STUDENTS if scored else STUDENTS)
        ]
        judged_as = {is_accepted(key, answer, Policy(), drawn) for drawn in students}
        fresh = {n: rng.uniform(0.3, 1.7) for n in key.parameters}
        there, reference = bind(answer.table, fresh), bind(key.table, fresh)
        certificate = certify((prepared(reference),), (chain_of_table(there),), Policy(tolerance=EXACT))
        if judged_as != {certificate is not None}:
            outcome.failures.append(f"accepted is {judged_as}: {place}")
        if certificate is not None:
            outcome.accepted += 1
            confirm(outcome, reference, there, certificate, EXACT, place)
            continue
        outcome.tables += 1
        if scored:
            verdicts = [grade(key, answer, Policy(), drawn) for drawn in students]
            found = Counter((verdict.correct, verdict.score) for verdict in verdicts)
            if len(found) > 1 or verdicts[0].correct:
                outcome.failures.append(f"verdicts differ: {place}: {found}")
    return outcome


def _misnamed(key: ReadTable, rng: Random) -> ReadTable | None:
    """The key as somebody else may write it, one name in a length replaced: by another, a multiple, a sum."""
    table = key.table
    if rng.random() < WRITTEN_OTHERWISE:
        table = variant(table, Policy(), some_lengths(table, 0.3), rng)
    places = [
        (i, cell, name)
        for i, row in enumerate(table.rows)
        for cell in ("a", "d")
        for name in sorted(parameters_in(getattr(row, cell)))
    ]
    if not places:
        return None
    i, cell, name = rng.choice(places)
    right = Parameter(name)
    others = [Parameter(other) for other in key.parameters if other != name]
    factor = Number(Fraction(rng.choice((101, 99, 110, 1001, -100)), 100 if rng.random() < 0.9 else 99))
    wrong = rng.choice(
        [*others, multiply((factor, right)), add((right, Number(Fraction(rng.randint(1, 9), 250))))]
    )
    row = table.rows[i]
    changed = replace(row, **{cell: substitute(getattr(row, cell), {name: wrong})})
    table = DHTable(convention=table.convention, rows=(*table.rows[:i], changed, *table.rows[i + 1 :]))
    used = {name for row in table.rows for entry in CELLS for name in parameters_in(getattr(row, entry))}
    kinds = {name: kind for name, kind in key.parameters.items() if name in used}
    return ReadTable(table=table, angle_unit=key.angle_unit, length_unit=key.length_unit, parameters=kinds)


def hostile_tables(block: int) -> Iterator[tuple[str, ReadTable, ReadTable, Policy]]:
    """Two or three mistakes, rows missing, strict rules, junk: a robot's name, key, answer and policy."""
    rng = Random(f"hostile {block}")
    known = references()
    while True:
        name, reference = rng.choice(known)
        table = reference
        for _ in range(rng.choice((2, 3))):
            made = mutations(table, rng)
            table = rng.choice(made).table if made else table
        if rng.random() < 0.3:
            table = DHTable(convention=table.convention, rows=(*table.rows, *_junk(len(table.rows), rng)))
        policy = random_rules(rng) if rng.random() < 0.5 else Policy()
        yield name, written(reference), written(table), policy


def hostile_answers(block: int, tables: int = TABLES_PER_BLOCK) -> Outcome:
    """No hostile table raises, and none is expensive; garbage is collected as in the service."""
    outcome = Outcome()
    with new_objects_alone():
        for name, key, answer, policy in islice(hostile_tables(block), tables):
            outcome.tables += 1
            _answer_a_hostile(outcome, key, answer, policy, f"{name}, block {block}, table {outcome.tables}")
    return outcome


def _answer_a_hostile(
    outcome: Outcome, key: ReadTable, answer: ReadTable, policy: Policy, place: str
) -> None:
    start = time.process_time()
    with lost_explanations() as lost:
        try:
            outcome.accepted += grade(key, answer, policy).correct
        except Exception as error:
            outcome.failures.append(f"raises {error!r}: {place}")
    seconds = time.process_time() - start
    outcome.failures += [f"explanation lost, {what}: {place}" for what in lost]
    outcome.residual = max(outcome.residual, seconds)
    outcome.kinds["up to 0.05 s" if seconds <= 0.05 else "up to 0.2 s" if seconds <= 0.2 else "more"] += 1
    if seconds > MOST_SECONDS:
        outcome.failures.append(f"takes {seconds:.2f} s: {place}")


def _junk(rows: int, rng: Random) -> list[DHRow[float]]:
    return [
        DHRow(
            joint=JointType.FIXED,
            theta=rng.choice((0.0, 0.3)),
            d=rng.uniform(0.0, 0.1),
            a=rng.uniform(0.0, 0.1),
            alpha=rng.choice((0.0, 0.2)),
        )
        for _ in range(max(JUNK - rows, 0))
    ]


def accused_rows(block: int, tables: int = TABLES_PER_BLOCK) -> Outcome:
    """One mistake in a six-joint robot, at the help level `row`: the rows that are accused hold it.

    Failures are mistakes for which no accused row holds it; a right row that is accused alone is one of them.
    Where another edit mends the table as well, its row is named beside the mistaken one, never instead of it.
    """
    rng = Random(f"accused {block}")
    known = [(name, table) for name, table in catalogue() if table.n_joints == SIX_JOINTS]
    outcome = Outcome()
    while outcome.tables < tables:
        name, reference = rng.choice(known)
        table = random_valid_table(reference, rng, dummies=0.0, signed_rows=False, textbook_ends=True)
        made = [mutation for mutation in mutations(table, rng) if mutation.rows]
        mutation = rng.choice(made)
        key, answer, policy = written(reference), written(mutation.table), Policy(tool=ToolRule.FREE)
        with lost_explanations() as lost:
            verdict = grade(key, answer, policy, None, HelpLevel.ROW)
        outcome.failures += [f"explanation lost, {what}: {name}, block {block}" for what in lost]
        if verdict.correct:
            outcome.accepted += 1
            continue
        outcome.tables += 1
        outcome.kinds[mutation.kind] += 1
        accused = {entry.row for entry in verdict.feedback if entry.row}
        accused |= {entry.params.get("other") for entry in verdict.feedback}
        rows = sorted(row for row in accused if isinstance(row, int))
        outcome.kinds[f"{len(rows)} rows named"] += 1
        if accused & set(mutation.rows):
            outcome.right_row += 1
        else:
            outcome.failures.append(
                f"{mutation.kind} in {mutation.rows} told as {rows}: {name}, block {block}"
            )
    return outcome
