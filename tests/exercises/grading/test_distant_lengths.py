"""Lengths far longer than the robot: what they should be is found as exactly as of others."""

from dataclasses import replace

import pytest

from exercises.grading import Policy, ToolRule, Verdict, grade
from kinematics.table import DHTable, NumericTable
from tests.exercises.grading.told import repairs
from tests.exercises.grading.written import Cell, read, written
from tests.kinematics.equivalence.campaign import catalogue

KEY: NumericTable = dict(catalogue())["puma560"]


def graded(*cells: tuple[int, str, float]) -> Verdict:
    """What is said of the key's own table with some cells changed, its rows counted from 0."""
    rows = list(KEY.rows)
    for row, cell, value in cells:
        rows[row] = replace(rows[row], **{cell: value})
    return grade(
        written(KEY),
        written(DHTable(convention=KEY.convention, rows=tuple(rows))),
        Policy(tool=ToolRule.FREE),
    )


def test_a_length_in_millimetres_between_parallel_axes_is_told_once() -> None:
    """Offsets along the axes do not blur their distance."""
    row = next(i for i, row in enumerate(KEY.rows) if row.a > 0.4)
    d = KEY.rows[row].d
    verdict = graded(
        (row, "a", 1000.0 * KEY.rows[row].a), (row, "d", d + 1.7), (row + 1, "d", KEY.rows[row + 1].d - 1.7)
    )
    assert repairs(verdict) == [[("cell_length_unit", row + 1)]]


@pytest.mark.parametrize("size", [1.0, 141.0, 5000.0])
def test_a_length_that_should_be_zero_is_zero_however_long_it_is(size: float) -> None:
    long = next(i for i, row in enumerate(KEY.rows) if row.a > 0.4)
    verdict = graded((long, "a", 1000.0 * KEY.rows[long].a), (4, "a", size))
    assert [("cell_length_unit", long + 1), ("a_not_zero", 5)] in repairs(verdict)


@pytest.mark.parametrize("typed", [3217.0, 41234.0])
def test_a_distant_length_beside_a_fixed_one_at_an_angle_is_mended(typed: float) -> None:
    """The distance of the two axes is x² + 0.3 x + 0.09, squared: least at no zero of the length."""
    others: list[tuple[Cell, Cell, Cell, Cell]] = [
        (0, 0.3, 0, "pi/3"),
        ("pi/2", 0.2, 0.2, "q2"),
        (0, 0.2, 0.1, "q3"),
    ]
    key, answer = (read("standard", [(0, a, 0.1, "q1"), *others]) for a in (0.4, typed))
    verdict = grade(key, answer, Policy(tool=ToolRule.FREE))
    repairs = [[(edit.code, edit.row) for edit in repair.edits] for repair in verdict.repairs]
    assert repairs == [[("a_value", 1)]]
