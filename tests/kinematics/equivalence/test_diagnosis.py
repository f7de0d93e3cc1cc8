"""What is wrong with a table: as few facts as explain it, each of its own kind, with its own amount."""

import math
from dataclasses import replace
from random import Random

import pytest

from kinematics.chain import chain_of_table
from kinematics.conversion import convert, fixed_row
from kinematics.equivalence import Kind, Policy, ToolRule
from kinematics.equivalence.diagnosis import diagnose
from kinematics.equivalence.invariants import invariants_of
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.results import Mismatch
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable
from tests.kinematics.equivalence.campaign import catalogue
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.tables import HALF, PUMA, P, R, changed, standard

FREE = Policy(tool=ToolRule.FREE)
SLIDERS = standard(
    (R, HALF, 0, 0.2, 0), (R, 0.7, 0.4, 0.3, 0), (P, 0.6, 0.1, 0, 0), (P, 0.8, 0, 0, 0.3), (R, 0, 0, 0.2, 0)
)


def told(key: NumericTable, table: NumericTable, row: int, cell: str, by: float) -> tuple[Mismatch, ...]:
    """What is said when a cell of a right table (its row counted from 1) is off."""
    wrong = changed(table, row, **{cell: getattr(table.rows[row - 1], cell) + by})
    return diagnose(prepared(key), wrong, chain_of_table(wrong), FREE)


@pytest.mark.parametrize(("robot", "row"), [("cloos", 5), ("panda", 3), ("puma560", 5), ("ssrms", 2)])
def test_one_wrong_twist_is_one_wrong_fact(robot: str, row: int) -> None:
    """Which way axes point shows only at the axes behind them: several ways are followed side by side."""
    key = dict(catalogue())[robot]
    table = random_valid_table(key, Random(robot), dummies=0.0, textbook_ends=True)
    (mismatch,) = told(key, table, row, "alpha", 0.7)
    assert (mismatch.kind, mismatch.row) == (Kind.TWIST, row - 1)


@pytest.mark.parametrize("row", [1, 2, 3])
def test_one_wrong_twist_of_skew_axes_is_told_with_its_amount(row: int) -> None:
    (mismatch,) = told(SKEW, SKEW, row, "alpha", 0.2)
    assert (mismatch.kind, mismatch.joint, mismatch.row) == (Kind.TWIST, row + 1, row - 1)
    assert mismatch.angle == pytest.approx(0.2, rel=2e-3)


@pytest.mark.parametrize(
    ("row", "cell", "by", "kind"),
    [
        (2, "alpha", 0.2, Kind.TWIST),
        (3, "alpha", 0.2, Kind.TWIST),
        (4, "theta", 0.4, Kind.OFFSET),
    ],
)
def test_angles_of_sliders_are_told_with_their_amounts(row: int, cell: str, by: float, kind: Kind) -> None:
    (mismatch,) = told(SLIDERS, SLIDERS, row, cell, by)
    assert (mismatch.kind, mismatch.row) == (kind, row - 1)
    assert mismatch.angle == pytest.approx(by)


SKEW = standard(
    (R, 1.1, 0.4, 0.2, 0), (R, -0.7, 0.3, 0.25, 0), (R, 0.9, 0.35, 0.15, 0), (R, 0.5, 0.2, 0.1, 0)
)


@pytest.mark.parametrize(
    ("row", "cell", "kind"),
    [
        (1, "a", Kind.LENGTH),
        (2, "a", Kind.LENGTH),
        (3, "a", Kind.LENGTH),
        (2, "d", Kind.OFFSET),
        (3, "d", Kind.OFFSET),
    ],
)
def test_one_wrong_length_of_skew_axes_is_no_wrong_twist(row: int, cell: str, kind: Kind) -> None:
    """Nor is it another offset behind it, whichever way the arm is placed."""
    (mismatch,) = told(SKEW, SKEW, row, cell, 0.2)
    assert (mismatch.kind, mismatch.row) == (kind, row - 1)
    assert mismatch.length == pytest.approx(0.2, rel=1e-3)
    foot = DHRow(joint=JointType.FIXED, theta=0.7, d=0.2, a=0.1, alpha=0.9)
    placed = DHTable(convention=SKEW.convention, rows=(foot, *SKEW.rows))
    (again,) = told(placed, placed, row + 1, cell, 0.2)
    assert (again.kind, again.row) == (kind, row)
    assert again.length == pytest.approx(0.2, rel=1e-3)


def test_a_slider_that_is_turned_turns_what_comes_behind_it() -> None:
    first, second = told(SLIDERS, SLIDERS, 3, "theta", 0.3)
    assert (first.kind, first.row, second.kind, second.row) == (Kind.OFFSET, 2, Kind.OFFSET, 3)
    assert first.angle == pytest.approx(0.3)
    assert 0.2 < second.angle < 0.3


def test_a_slider_that_is_tilted_and_turned_is_told_both() -> None:
    tilted = changed(SLIDERS, 3, alpha=SLIDERS.rows[2].alpha + 0.2)
    twist, offset = told(SLIDERS, tilted, 4, "theta", 0.4)
    assert (twist.kind, twist.row, offset.kind, offset.row) == (Kind.TWIST, 2, Kind.OFFSET, 3)
    assert (twist.angle, offset.angle) == pytest.approx((0.2, 0.4))


def test_an_axis_that_is_tilted_and_turned_is_told_both() -> None:
    tilted = changed(SLIDERS, 4, alpha=SLIDERS.rows[3].alpha + 0.2)
    twist, offset = told(SLIDERS, tilted, 4, "theta", 0.4)
    assert (twist.kind, twist.row, offset.kind, offset.row) == (Kind.TWIST, 3, Kind.OFFSET, 3)
    assert (twist.angle, offset.angle) == pytest.approx((0.2, 0.4))


def test_a_missed_tool_is_told_of_the_last_joint() -> None:
    wrong = changed(SLIDERS, 5, d=0.5)
    found = diagnose(prepared(SLIDERS), wrong, chain_of_table(wrong), Policy(tool=ToolRule.POINT))
    assert [(mismatch.kind, mismatch.joint, mismatch.row) for mismatch in found] == [
        (Kind.TOOL, 5, 4),
        (Kind.OFFSET, 5, 4),
    ]
    assert [mismatch.length for mismatch in found] == pytest.approx([0.3, 0.3])


def test_a_missed_tool_is_one_wrong_fact_as_a_twist_is() -> None:
    """An axis that is turned over has the wrong twist, or its tool at the wrong end: that leaves less."""
    key = standard((R, 1.1, 0.4, 0.2, 0.3), (R, -0.7, 0.3, 0.25, 0.1), (R, 0, 0.35, 0.15, -0.2))
    over = changed(key, 2, alpha=math.pi - 0.7)
    found = diagnose(prepared(key), over, chain_of_table(over), Policy(tool=ToolRule.POINT))
    assert [(one.kind, one.joint) for one in found] == [(Kind.TOOL, 3), (Kind.OFFSET, 3)]
    assert [one.length for one in found] == pytest.approx([2 * 0.15, 2 * 0.15])


def test_a_missed_tool_of_a_slider_says_all() -> None:
    """Beside a prismatic axis, which lies nowhere, the last link has no length."""
    wrong = changed(SLIDERS, 2, a=0.5)
    key = DHTable(convention=SLIDERS.convention, rows=SLIDERS.rows[:3])
    wrong = changed(DHTable(convention=key.convention, rows=wrong.rows[:3]), 3, a=0.4)
    found = diagnose(prepared(key), wrong, chain_of_table(wrong), Policy(tool=ToolRule.POINT))
    assert [(one.kind, one.joint) for one in found] == [(Kind.TOOL, 3)]


@pytest.mark.parametrize("size", [1e-3, 1e3])
@pytest.mark.parametrize("tool", [ToolRule.FREE, ToolRule.FRAME])
@pytest.mark.parametrize(("row", "cell"), [(2, "a"), (3, "d"), (4, "alpha"), (6, "d")])
def test_what_is_wrong_does_not_depend_on_the_unit_of_length(
    size: float, tool: ToolRule, row: int, cell: str
) -> None:
    """Nor on errors within the tolerance beside it."""
    almost = changed(PUMA, 6, a=2e-4, alpha=1e-4)
    wrong = changed(almost, row, **{cell: getattr(PUMA.rows[row - 1], cell) + 0.1})
    policy = Policy(tool=tool)
    expected = diagnose(prepared(PUMA), wrong, chain_of_table(wrong), policy)
    key, table = scaled(PUMA, size), scaled(wrong, size)
    found = diagnose(prepared(key), table, chain_of_table(table), policy)
    assert [(one.kind, one.row) for one in found] == [(one.kind, one.row) for one in expected]
    assert [one.length for one in found] == pytest.approx([size * one.length for one in expected])
    assert [one.angle for one in found] == pytest.approx([one.angle for one in expected])


def scaled(table: NumericTable, size: float) -> NumericTable:
    rows = tuple(replace(row, a=size * row.a, d=size * row.d) for row in table.rows)
    return DHTable(convention=table.convention, rows=rows)


@pytest.mark.parametrize("rule", [ToolRule.POINT, ToolRule.AXIS, ToolRule.FRAME])
@pytest.mark.parametrize(
    ("cell", "value", "kind"), [("a", 0.1, Kind.LENGTH), ("d", 0.4, Kind.OFFSET), ("alpha", 0.3, Kind.TWIST)]
)
@pytest.mark.parametrize("convention", [Convention.STANDARD, Convention.MODIFIED])
def test_beside_other_faults_a_missed_tool_is_told_by_the_facts_of_the_last_link(
    rule: ToolRule, cell: str, value: float, kind: Kind, convention: Convention
) -> None:
    """Where the tool lies beside the last axis is seen from there, whatever is wrong before it."""
    wrong = changed(changed(changed(PUMA, 2, a=0.6), 3, a=0.1), 6, **{cell: value})
    made = convert(wrong, convention)
    rows = made.table.rows if made.tool is None else (*made.table.rows, fixed_row(made.tool))
    table = replace(made.table, rows=rows)
    found = diagnose(prepared(PUMA), table, chain_of_table(table), Policy(tool=rule))
    last = {(one.kind, one.row) for one in found if one.row == len(table.rows) - 1}
    before = {(one.kind, one.joint) for one in found if one.joint in (3, 4)}
    assert before == {(Kind.LENGTH, 3), (Kind.LENGTH, 4)}
    if (cell, rule) in (("alpha", ToolRule.POINT), ("d", ToolRule.AXIS)):
        assert not last
    elif cell == "d" and convention is Convention.MODIFIED:
        assert {(one.kind, one.joint) for one in found} - before == {(Kind.TOOL, 6), (Kind.OFFSET, 6)}
    else:
        assert last == {(Kind.TOOL, len(table.rows) - 1), (kind, len(table.rows) - 1)}


CROSSED = standard(
    (R, HALF, 0.4, 0.2, 0),
    (R, HALF, 0.3, 0.25, 0),
    (R, HALF, 0.35, 0.15, 0),
    (R, HALF, 0.2, 0.1, 0),
    (R, 0, 0, 0, 0),
)


@pytest.mark.parametrize("row", [2, 3, 4])
@pytest.mark.parametrize(("cell", "kind"), [("d", Kind.OFFSET), ("a", Kind.LENGTH)])
def test_lengths_between_crossed_axes_are_told_with_their_amounts(row: int, cell: str, kind: Kind) -> None:
    (mismatch,) = told(CROSSED, CROSSED, row, cell, 0.08)
    assert (mismatch.kind, mismatch.row) == (kind, row - 1)
    assert mismatch.length == pytest.approx(0.08)


def test_an_invariant_spans_the_axes_that_it_concerns() -> None:
    invariants = invariants_of(prepared(SLIDERS), FREE)
    first, last = invariants.spans
    assert first[:, 0].tolist() == [min(shape.axes) for shape in invariants.shapes]
    assert last[:, 0].tolist() == [max(shape.axes) for shape in invariants.shapes]
