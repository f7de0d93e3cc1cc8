"""Answers at the edges of what is told: each shows one step of the grading that others leave unseen."""

from dataclasses import replace

import pytest

from exercises.grading import BaseRule, Policy, ToolRule, grade
from exercises.grading.edits.last_row import _row_of
from exercises.grading.judging.comparison import LARGEST_ENTRY, _within_bounds
from kinematics.dh import link_transform
from kinematics.errors import ParameterError
from kinematics.se3 import compose, from_matrix, translation
from kinematics.table import Convention, DHRow, JointType
from tests.exercises.grading.written import read, written
from tests.kinematics.equivalence import tables
from tests.kinematics.equivalence.tables import HALF, P, R

FREE = Policy(tool=ToolRule.FREE)
LIFTS = tables.standard(
    (R, HALF, 0.1, 0.4, 0.2),
    (P, 0, 0.2, 0.1, 0),
    (P, HALF, 0.1, 0.2, 0.3),
    (R, 0.7, 0.1, 0.2, 0.1),
    (R, 0, 0.2, 0, 0),
)


@pytest.mark.parametrize("convention", Convention)
def test_what_a_large_robot_is_off_by_is_nothing(convention: Convention) -> None:
    """A motion that is that of a row but for 1e-8 of a robot a kilometre large; and a length as small."""
    row = DHRow(joint=JointType.FIXED, theta=0.7, d=400.0, a=1e-8, alpha=0.3)
    motion = from_matrix(link_transform(row, convention))
    for across in ((1e-8, 0.0, 0.0), (0.0, 1e-8, 0.0)):
        found = _row_of(compose(translation(across), motion), convention, 1000.0)
        assert found is not None
        assert (found.a, found.d) == (0.0, pytest.approx(400.0))
    assert _row_of(compose(translation((1e-3, 1e-3, 0.0)), motion), convention, 1000.0) is None


def test_of_two_rows_without_a_variable_one_of_zeros_may_be_the_joint() -> None:
    """The row with an offset may be it, too, and nobody can say which."""
    key = read("standard", [(0, 0.3, 0, "q1"), (0, 0, 0, "q2")])
    answer = read("standard", [(0, 0.3, 0, "q1"), (0, 0, 0.2, 0), (0, 0, 0, 0)])
    told = [(entry.code, entry.row) for entry in grade(key, answer, FREE).feedback]
    assert told[2:] == [("one_of_these", None), ("joint_type_wrong", 2), ("joint_type_wrong", 3)]


def test_lengths_that_move_a_frame_to_and_fro_cancel_exactly() -> None:
    key = read("standard", [(0, "L1", 0, "q1"), (0, "L2", 0, "q2"), (0, "L3", 0, "q3")])
    held = Policy(base=BaseRule.FRAME, tool=ToolRule.POINT)
    for back, right in ((-0.15, True), (-0.1501, False)):
        rows = read("standard", [(0, "L1", 0, "q1"), (0, "L2", 0.15, "q2"), (0, "L3", back, "q3")])
        assert grade(key, rows, held).correct is right


def test_a_fact_that_zeros_have_weighs_no_more_than_another() -> None:
    """Though the others weigh more together: seven, and the number and types of joints."""
    general = (R, 1.1, 0.3, 0.2, 0), (R, 0.8, 0, 0.4, 0), (R, -0.9, 0.5, 0.3, 0), (R, 1.3, 0.2, 0.2, 0)
    key = tables.standard(*general)
    wrong = tables.changed(tables.changed(key, 2, a=0.35), 1, alpha=0.6)
    assert grade(written(key), written(wrong), FREE).score == round(1 - 2 / 7, 2)


def test_a_fact_that_zeros_have_costs_nothing_where_another_type_hides_it() -> None:
    """The turn about the slider is none. Of three facts a length is wrong; the type takes half the rest."""
    key = tables.standard((R, HALF, 0.3, 0.2, 0), (P, HALF, 0, 0, 0), (R, 0, 0.4, 0.1, 0))
    wrong = tables.changed(key, 1, a=0.7)
    turning = replace(wrong, rows=(wrong.rows[0], replace(wrong.rows[1], joint=R), wrong.rows[2]))
    assert grade(written(key), written(turning), FREE).score == 0.33


@pytest.mark.parametrize(("row", "cell", "value"), [(4, "a", 0.7), (3, "theta", 1.0), (2, "a", 0.6)])
def test_what_is_wrong_across_sliders_costs_one_in_the_wrong_convention(
    row: int, cell: str, value: float
) -> None:
    wrong = tables.changed(LIFTS, row, **{cell: value})
    assert grade(written(LIFTS), written(wrong), FREE).score == 0.83
    verdict = grade(written(LIFTS), written(replace(wrong, convention=Convention.MODIFIED)), FREE)
    assert verdict.score == 0.33


@pytest.mark.parametrize("cell", ["alpha", "a", "d", "theta"])
def test_an_entry_may_be_as_large_as_is_said(cell: str) -> None:
    """A larger one has no value: powers of it would be infinite."""
    for entry in (LARGEST_ENTRY, -LARGEST_ENTRY):
        largest = tables.changed(LIFTS, 2, **{cell: entry})
        assert _within_bounds(largest) is largest
        with pytest.raises(ParameterError):
            _within_bounds(tables.changed(LIFTS, 2, **{cell: entry * 1.001}))


def test_a_value_that_no_name_asks_for_is_told_as_it_is_read() -> None:
    key = read("standard", [(0, "L1", 0, "q1"), (0, "L2", 0, "q2")])
    with pytest.raises(ParameterError) as raised:
        grade(key, key, FREE, {"L1": 0.5, "L_9": 0.4})
    (fault,) = raised.value.faults
    assert (fault.code, fault.params["other"]) == ("parameter_unused", "L9")
