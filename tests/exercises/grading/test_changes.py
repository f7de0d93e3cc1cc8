"""Edits one after another, in the numbers of the answer's own rows; rows of zeros, counted as they stand."""

from fractions import Fraction

import pytest

from exercises.grading import Edit, Feedback, Finding, LinkFinding, Repair
from exercises.grading.edits.changes import Change, Extent, after
from exercises.grading.edits.repairs import _likelihood
from exercises.grading.explanation import Explanation
from exercises.grading.idle_rows import renumbered
from exercises.grading.judging.exact_text import angle_text
from kinematics.cells import AngleUnit
from kinematics.expressions import Expression, Parameter, add, multiply, number, pi_times
from kinematics.table import Convention, DHRow, DHTable, JointType

PLACES = ("other", "place", "after")


@pytest.mark.parametrize(
    ("code", "row", "of_second", "in_answer"),
    [
        ("row_missing", 1, [0, 2, 3], [0, 1, 2]),
        ("fixed_row_missing", 1, [0, 2, 3], [0, 1, 2]),
        ("row_extra", 1, [0, 1, 2], [0, 2, 3]),
        ("rows_swapped", 1, [0, 1, 2, 3], [0, 2, 1, 3]),
        ("a_value", 1, [0, 1, 2], [0, 1, 2]),
    ],
)
def test_a_second_edit_is_told_in_the_rows_of_the_answer(
    code: str, row: int, of_second: list[int], in_answer: list[int]
) -> None:
    swapped = ((row, "a"), (row + 1, "a")) if code == "rows_swapped" else ((row, "a"),)
    first = Change(code, Extent.ROW, row, touched=swapped)
    for theirs, ours in zip(of_second, in_answer, strict=True):
        params = (*((name, theirs + 1) for name in PLACES), ("name", "a2"), ("degrees", theirs + 1))
        second = Change("a_d_swapped", Extent.ROW, theirs, touched=((theirs, "d"),), params=params)
        told = after(first, second)
        assert (told.row, told.places) == (ours, ((ours, "d"),))
        assert dict(told.params) == dict.fromkeys(PLACES, ours + 1) | {"name": "a2", "degrees": theirs + 1}


def test_what_comes_before_every_row_stays_there() -> None:
    second = Change("row_missing", Extent.ROW, 3, params=(("after", 0),))
    assert after(Change("row_extra", Extent.ROW, 0, touched=((0, "a"),)), second).params == (("after", 0),)


def test_what_is_told_of_an_edit_counts_rows_from_one() -> None:
    edit = Change("rows_swapped", Extent.ROW, 1, params=(("other", 4),)).edit
    assert (edit.row, edit.params) == (2, {"row": 2, "other": 4})
    throughout = Change("convention", Extent.TABLE).edit
    assert (throughout.row, throughout.params) == (None, {})


def test_edits_are_nearly_the_same_if_they_put_the_same_values_in_the_same_cells() -> None:
    one = Change("a_value", Extent.CELL, 1, "a", ((1, "a", 0.4),))
    assert one.is_nearly(one._replace(code="a_sign", cells=((1, "a", 0.4 + 1e-12),)))
    assert not one.is_nearly(one._replace(cells=((1, "a", 0.4001),)))
    assert not one.is_nearly(one._replace(cells=((1, "d", 0.4),)))
    assert not one.is_nearly(one._replace(cells=((1, "a", 0.4), (2, "a", 0.4))))
    assert not one.is_nearly(one._replace(row=2))


def test_a_length_is_filled_in_where_none_was_typed() -> None:
    row = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.2, a=0.0, alpha=0.0)
    table = DHTable(convention=Convention.STANDARD, rows=(row,))
    assert Change("a_missing", Extent.CELL, 0, "a").fills_a_zero(table)
    assert not Change("d_value", Extent.CELL, 0, "d").fills_a_zero(table)
    assert not Change("alpha_value", Extent.CELL, 0, "alpha").fills_a_zero(table)
    assert not Change("a_missing", Extent.CELL, 1, "a").fills_a_zero(table)
    assert not Change("a_d_swapped", Extent.ROW, 0, "a").fills_a_zero(table)


def test_rows_of_zeros_count_where_rows_are_numbered() -> None:
    """Of four rows the first and the third were left out; a row behind them all is the fifth."""
    params = {"row": 1, "other": 2, "place": 3, "after": 1, "degrees": 1, "name": "a2"}
    shown = {"row": 2, "other": 4, "place": 5, "after": 2, "degrees": 1, "name": "a2"}
    told = Explanation(
        score=0.5,
        links=(LinkFinding(row=2, length=Finding.OK, twist=Finding.OK, offset=Finding.OK, joint=Finding.OK),),
        feedback=(Feedback(code="one", row=1, params=params), Feedback(code="all", params={"after": 0})),
        repairs=(Repair(edits=(Edit(code="a_value", row=3, params=params),)),),
    )
    found = renumbered(told, (1, 3), 4)
    assert [link.row for link in found.links] == [4]
    assert [(entry.row, entry.params) for entry in found.feedback] == [(2, shown), (None, {"after": 0})]
    assert [(edit.row, edit.params) for edit in found.repairs[0].edits] == [(5, shown)]
    assert renumbered(told, (0, 1), 2) is told


@pytest.mark.parametrize(
    ("angle", "radians", "degrees"),
    [
        (pi_times(Fraction(1, 3)), "pi/3", "60"),
        (number(2), "2", "360/pi"),
        (add((pi_times(Fraction(-1, 2)), Parameter("beta"))), "-pi/2 + beta", "beta - 90"),
        (multiply((number(2), Parameter("beta"))), "2*beta", "2*beta"),
    ],
)
def test_angles_as_a_cell_takes_them(angle: Expression, radians: str, degrees: str) -> None:
    assert (angle_text(angle, AngleUnit.RAD), angle_text(angle, AngleUnit.DEG)) == (radians, degrees)


def test_of_edits_a_convention_is_likelier_than_a_row_and_less_likely_than_a_cell() -> None:
    row = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.2, a=0.1, alpha=0.0)
    table = DHTable(convention=Convention.STANDARD, rows=(row,))
    changes = [
        Change("columns_late", Extent.TABLE),
        Change("convention", Extent.TABLE),
        Change("row_extra", Extent.ROW, 0),
        Change("a_value", Extent.CELL, 0, "a", ((0, "a", 0.4),)),
    ]
    likeliest = sorted(changes, key=lambda change: _likelihood(change, table))
    assert [change.code for change in likeliest] == ["a_value", "convention", "row_extra", "columns_late"]
