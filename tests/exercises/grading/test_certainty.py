"""Edits that are seen to make a table right without a search: a search finds the same."""

import math
from dataclasses import replace
from random import Random

import pytest

from exercises.grading.edits.certainty import surely_right
from exercises.grading.edits.work import Work
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from exercises.grading.judging.digits import measured_as_typed
from kinematics.equivalence import BaseRule, Policy, ToolRule, decide
from kinematics.equivalence.decision import EXACT
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable
from tests.exercises.grading.campaign import drawn_by_hand
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import random_rules, references
from tests.kinematics.equivalence.mutations import mutations

RULES = [
    Policy(base=base, tool=tool, tolerance=EXACT)
    for base in (BaseRule.FREE, BaseRule.ORIGIN, BaseRule.AXIS)
    for tool in (ToolRule.FREE, ToolRule.POINT, ToolRule.AXIS)
]


def work_of(key: NumericTable, answer: NumericTable, policy: Policy) -> Work:
    read = written(key), written(answer)
    return work_on(comparisons(*read, {})[0], read, policy)


def seen(key: NumericTable, answer: NumericTable, policy: Policy) -> bool:
    """Whether an answer is seen to be right as it stands."""
    work = work_of(key, answer, policy)
    if not work.has_the_joints():
        return False
    found = measured_as_typed(work.invariants, work.table, {}, policy)[:, 0]
    return surely_right(work, [((), found)]) == [True]


def with_other_ends(table: NumericTable, rng: Random) -> NumericTable:
    """A table with the first and the last row changed where that may be a choice of frames or a mistake."""
    rows = list(table.rows)
    for place in (0, -1):
        cell = rng.choice(("d", "a", "alpha", "theta"))
        if rng.random() < 0.7:
            rows[place] = replace(rows[place], **{cell: getattr(rows[place], cell) + rng.choice((0.1, -0.5))})
    return replace(table, rows=tuple(rows))


@pytest.mark.parametrize("number", range(25))
def test_what_is_seen_to_be_right_has_an_exact_certificate(number: int) -> None:
    rng = Random(f"certain {number}")
    _, key = rng.choice(references())
    table = drawn_by_hand(key, rng) or key
    made = mutations(table, rng)
    wrong = [one.table for one in rng.sample(made, min(12, len(made)))]
    for answer in (table, key, with_other_ends(key, rng), with_other_ends(table, rng), *wrong):
        for policy in (rng.choice(RULES), replace(random_rules(rng), tolerance=EXACT)):
            if seen(key, answer, policy):
                assert decide(key, answer, policy).accepted, policy


def test_right_tables_of_turning_joints_are_seen_to_be_right() -> None:
    rng, policy = Random(3), Policy(tool=ToolRule.FREE)
    keys = [key for _, key in references() if "prismatic" not in {joint.value for joint in key.joint_types}]
    tables = [(key, drawn_by_hand(key, rng)) for key in rng.sample(keys, 40)]
    found = [seen(key, table, policy) for key, table in tables if table is not None]
    assert sum(found) > 0.9 * len(found)


def test_a_sign_that_no_turned_axis_makes_up_for_is_seen() -> None:
    rng = Random(4)
    key = next(key for name, key in references() if "puma560" in name)
    table = drawn_by_hand(key, rng)
    assert table is not None
    assert seen(key, table, Policy(tool=ToolRule.FREE))
    mirrored = replace(table, rows=tuple(replace(row, alpha=-row.alpha, d=-row.d) for row in table.rows))
    assert not seen(key, mirrored, Policy(tool=ToolRule.FREE))


@pytest.mark.parametrize("degrees", [0.06, 0.1, 0.25, 0.28, 0.3, 1.0])
def test_an_offset_beside_axes_that_are_nearly_parallel_is_not_taken_for_right(degrees: float) -> None:
    links = [(0.4, 0.1, 90.0), (0.1, 0.3, degrees), (0.2, 0.25, 90.0), (0.1, 0.05, -60.0), (0.3, 0.0, 0.0)]
    key = turning(links)
    assert seen(key, key, Policy()) == (degrees >= 0.3)  # beside flatter axes, offsets are not measured
    for row in (1, 2):
        wrong = replace(key.rows[row], d=key.rows[row].d + 0.5)
        answer = replace(key, rows=(*key.rows[:row], wrong, *key.rows[row + 1 :]))
        assert not decide(key, answer, Policy()).accepted
        assert not seen(key, answer, Policy())


def test_a_joint_of_another_type_is_not_taken_for_right() -> None:
    policy = Policy(tool=ToolRule.FREE)
    key = turning([(0.4, 0.1, 90.0), (0.1, 0.3, 0.0), (0.0, 0.25, 0.0)])
    sliding = replace(key.rows[1], joint=JointType.PRISMATIC)
    assert seen(key, key, policy)
    assert not seen(key, replace(key, rows=(key.rows[0], sliding, key.rows[2])), policy)
    assert not seen(key, replace(key, rows=key.rows[:2]), policy)


def turning(links: list[tuple[float, float, float]]) -> NumericTable:
    """A robot of turning joints, of (d, a, α [°])."""
    rows = [
        DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=math.radians(alpha))
        for d, a, alpha in links
    ]
    return DHTable(convention=Convention.STANDARD, rows=tuple(rows))
