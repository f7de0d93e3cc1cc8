"""The last row that was forgotten: with it a table is right, wherever its variables are zero."""

from dataclasses import replace

import pytest

from exercises.grading import BaseRule, Policy, ToolRule, ZeroRule, is_accepted
from exercises.grading.edits.last_row import last_row
from exercises.grading.edits.work import Work
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from kinematics.cells import ReadTable
from kinematics.table import DHTable
from tests.exercises.grading.test_repair_search import Rows, of
from tests.exercises.grading.written import Cell, written

FRAME = Policy(tool=ToolRule.FRAME)
TURNING: Rows = [("pi/2", 0.1, 0, "q1"), (0.7, 0.3, 0.2, "q2")]
SLIDING: Rows = [("pi/2", 0.1, 0, "q1"), (0.7, 0.3, "q2", 0.4)]


def work(key: ReadTable, answer: ReadTable, policy: Policy = FRAME) -> Work:
    return work_on(comparisons(key, answer, {})[0], (key, answer), policy)


@pytest.mark.parametrize("zero", ["", " + 0.5", " - pi/2", " + 3"])
@pytest.mark.parametrize(("rows", "cell"), [(TURNING, 3), (SLIDING, 2)], ids=["turning", "sliding"])
def test_it_is_the_same_wherever_the_last_variable_is_zero(rows: Rows, cell: int, zero: str) -> None:
    """In the other convention the twist and the length of the key's last row stand in a row of their own."""
    last: list[Cell] = ["pi/2", 0.1, *rows[1][2:]]
    last[cell] = f"q2{zero}"
    answer = of([(0, 0, 0, "q1"), tuple(last)], "modified")  # type: ignore[list-item]
    key = of(rows)
    row = last_row(work(key, answer))
    assert row is not None
    assert (row.alpha, row.a, row.d, row.theta) == pytest.approx((0.7, 0.3, 0.0, 0.0))
    table = work(key, answer).table
    whole = DHTable(convention=table.convention, rows=(*table.rows, row))
    assert is_accepted(key, written(whole), FRAME)
    assert not is_accepted(key, answer, FRAME)


@pytest.mark.parametrize("unit", [1e-4, 1e6])
def test_what_it_has_none_of_is_zero_in_every_unit(unit: float) -> None:
    rows: Rows = [("pi/2", 0.1 * unit, 0, "q1"), (0.7, 0.3 * unit, 0.2 * unit, "q2")]
    answer: Rows = [(0, 0, 0, "q1"), ("pi/2", 0.1 * unit, 0.2 * unit, "q2 + 0.5")]
    row = last_row(work(of(rows), of(answer, "modified")))
    assert row is not None
    assert (row.d, row.theta) == (0.0, 0.0)
    assert (row.alpha, row.a) == pytest.approx((0.7, 0.3 * unit))


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_where_the_figure_fixes_the_zeros_it_leads_from_the_frame_as_it_lies(convention: str) -> None:
    rows: Rows = [("pi/2", 0.1, 0, "q1"), (0.7, 0.3, 0.2, "q2 + 0.4"), (0.5, 0.2, 0.15, 0.3)]
    policy = replace(FRAME, base=BaseRule.FRAME, zero=ZeroRule.FIGURE)
    row = last_row(work(of(rows, convention), of(rows[:2], convention), policy))
    assert row is not None
    assert (row.alpha, row.a, row.d, row.theta) == pytest.approx((0.5, 0.2, 0.15, 0.3))


def test_a_table_that_lacks_nothing_or_is_another_robot_has_none() -> None:
    assert last_row(work(of(TURNING), of(TURNING), replace(FRAME, zero=ZeroRule.FIGURE))) is None
    other: Rows = [("pi/2", 0.15, 0, "q1"), TURNING[1]]
    assert last_row(work(of(TURNING), of(other))) is None
    # turned about z, x and z: no single row leads there
    far: Rows = [*TURNING, (0.5, 0, 0, 0.3), (0, 0, 0.2, 0.4)]
    assert last_row(work(of(far), of(TURNING), replace(FRAME, zero=ZeroRule.FIGURE))) is None
