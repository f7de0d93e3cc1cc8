"""Under the rule `axis` the key's line at an end tells which cell is wrong, where it is no joint's axis."""

from dataclasses import replace

import pytest

from exercises.grading import BaseRule, HelpLevel, Policy, ToolRule, Verdict, ZeroRule, grade
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from tests.exercises.grading.test_grade import PUMA, VALUES, with_cells
from tests.exercises.grading.told import codes, repairs
from tests.exercises.grading.written import Cell, read, written
from tests.kinematics.equivalence.campaign import catalogue

Rows = list[tuple[Cell, Cell, Cell, Cell]]
AXIS = Policy(tool=ToolRule.AXIS)
PLANAR: Rows = [(0, 0.5, 0, "q1"), (0, 0.3, 0, "q2")]
ELBOW: Rows = [(90, 0, 0.4, "q1"), (0, 0.5, 0.12, "q2"), (90, 0.3, -0.05, "q3")]
NAMED: Rows = [(90, 0, "h", "q1"), (0, "L1", "e", "q2"), (90, "L2", "f", "q3")]
COLUMNS = ("alpha", "a", "d", "theta")


def _told(key: Rows, *wrong: tuple[int, str, Cell], policy: Policy = AXIS, modified: bool = False) -> Verdict:
    rows = [list(row) for row in key]
    for row, cell, value in wrong:
        rows[row - 1][COLUMNS.index(cell)] = value
    answer = [(row[0], row[1], row[2], row[3]) for row in rows]
    convention = "modified" if modified else "standard"
    tables = read(convention, key, "deg"), read(convention, answer, "deg")
    return grade(*tables, policy, help_level=HelpLevel.REPAIR)


@pytest.mark.parametrize(
    ("key", "wrong", "code"),
    [
        (PLANAR, (2, "a", 0.25), "a_value"),
        (ELBOW, (3, "a", 0.25), "a_value"),
        (ELBOW, (3, "a", 0), "a_missing"),
        (ELBOW, (3, "d", 0), "d_missing"),
        (NAMED, (3, "a", "L1"), "cell_parameter"),
        (NAMED, (3, "d", 0), "d_missing"),
    ],
)
def test_the_length_before_the_line_of_the_tool_is_told(
    key: Rows, wrong: tuple[int, str, Cell], code: str
) -> None:
    verdict = _told(key, wrong)
    assert not verdict.correct
    assert repairs(verdict)[0] == [(code, wrong[0])]


def test_of_offsets_along_parallel_axes_before_the_line_none_is_told_alone() -> None:
    verdict = _told(ELBOW, (3, "d", 0))
    assert "one_of_these" in codes(verdict)
    assert {entry.row for entry in verdict.feedback if entry.row} == {2, 3}


def test_beside_another_mistake_the_length_before_the_line_is_told() -> None:
    """Not that z of the last frame should stand on the last joint's axis."""
    verdict = _told(PLANAR, (1, "a", 0.45), (2, "a", 0.25))
    assert repairs(verdict) == [[("a_value", 1), ("a_value", 2)]]


def test_the_twist_behind_the_line_of_the_base_is_no_more_likely_than_the_offset() -> None:
    """Axes 1 and 2 are parallel: one d or the other takes the robot off the key's line of the base."""
    key: Rows = [(90, 0.12, 0.6, "q1"), (0, 0.4, 0.52, "q2"), (90, 0.2, 0.3, "q3")]
    verdict = _told(key, (2, "d", 0.4), policy=Policy(base=BaseRule.AXIS, tool=ToolRule.FREE), modified=True)
    assert {("d_value", 1), ("d_value", 2)} <= {edit for repair in repairs(verdict) for edit in repair}
    assert {entry.row for entry in verdict.feedback if entry.row} == {1, 2}


@pytest.mark.parametrize("off", [0.4485, 0.7])
def test_digits_that_would_explain_the_line_leave_the_length_before_it_to_be_told(off: float) -> None:
    """With -0.5, typed to one decimal, the line might be anywhere there; the poses say that it is not."""
    key: Rows = [(90, 0, 0.56, "q1"), (-90, 0.4273, 0, "q2"), (-90, -0.5, "q3", 30)]
    verdict = _told(key, (2, "a", off))
    assert ("a_value", 2) in {edit for repair in repairs(verdict) for edit in repair}
    assert 2 in {entry.row for entry in verdict.feedback}


def test_a_slider_whose_zero_takes_the_line_of_the_tool_along_is_told() -> None:
    """Joint 3 slides along the axis of joint 4, from which the key's last z stands off at right angles."""
    key: Rows = [(-90, 0.4, 0.2, "q1"), (90, 0.3, 0.1, "q2"), (0, 0, "q3", 0), (90, 0, 0, "q4")]
    verdict = _told(key, (3, "d", "q3+0.15"), policy=Policy(tool=ToolRule.AXIS, zero=ZeroRule.FIGURE))
    assert ("d_offset", 3) in {edit for repair in repairs(verdict) for edit in repair}
    assert 3 in {entry.row for entry in verdict.feedback}


@pytest.mark.parametrize("zero", ZeroRule)
def test_a_line_that_is_kept_is_looked_for_where_the_zeros_are_fixed_as_well(zero: ZeroRule) -> None:
    """To the letter alone, and elsewhere not at all: there it is on the line whatever the variables are."""
    policy, key = replace(AXIS, zero=zero), read("standard", ELBOW, "deg")
    wrong: Rows = [*ELBOW[:2], (90, 0.25, -0.05, "q3")]
    for rows, is_off in ((ELBOW, False), (wrong, True)):
        answer = read("standard", rows, "deg")
        work = work_on(comparisons(key, answer, {})[0], (key, answer), policy)
        to_the_letter = is_off or zero is ZeroRule.FIGURE
        assert (work.for_lines() is not None) is is_off
        assert (work.for_lines(to_the_letter=True) is not None) is to_the_letter


def test_a_sign_that_mirrors_the_arm_is_told_in_each_row_beside_a_line_that_is_missed() -> None:
    """No edit of another row brings z_6 back onto the axis of joint 6: none of these is tried at length."""
    rows = with_cells(PUMA, (4, 2, "-d4"), (6, 1, 0.1))
    verdict = grade(read("standard", PUMA), read("standard", rows), AXIS, VALUES)
    told = {edit for repair in repairs(verdict) for edit in repair}
    assert {("d_sign", 4), ("d_sign", 3), ("a_sign", 3), ("alpha_sign", 3)} <= told
    assert all(("a_not_zero", 6) in repair for repair in repairs(verdict))
    assert {entry.row for entry in verdict.feedback if entry.row} == {3, 4, 6}
    assert "one_of_these" in codes(verdict)


@pytest.mark.parametrize("name", ["puma560", "ur5", "irb140", "lrmate200id"])
def test_two_wrong_cells_of_the_last_row_are_told_beside_the_line_that_they_miss(name: str) -> None:
    """The robot is right, and many pairs of edits leave it so: those that touch the last row come first."""
    key = dict(catalogue())[name]
    last = replace(key.rows[-1], alpha=key.rows[-1].alpha + 0.7, a=0.1)
    verdict = grade(written(key), written(replace(key, rows=(*key.rows[:-1], last))), AXIS)
    assert codes(verdict)[:2] == ["right_robot", "tool_axis_missed"]
    assert repairs(verdict) == [[("alpha_value", 6), ("a_not_zero", 6)]]
