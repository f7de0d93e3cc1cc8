"""What strict rules are told by: the variable of the row, and no length or angle that is right."""

import pytest

from exercises.grading import BaseRule, DirectionRule, HelpLevel, Policy, ToolRule, ZeroRule, grade
from tests.exercises.grading.test_grade import Rows
from tests.exercises.grading.written import read

NOTHING_FREE = Policy(
    base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
)
ARM: Rows = [("pi/2", 0, "L1", "q1"), (0, "L2", 0, "q2"), (0, "L3", 0, "q3")]


@pytest.mark.parametrize(
    ("cell", "code"), [("q2 + pi/2", "variable_zero_wrong"), ("-q2", "variable_direction_wrong")]
)
@pytest.mark.parametrize("level", [HelpLevel.ROW, HelpLevel.KIND, HelpLevel.REPAIR])
def test_a_variable_is_told_as_such(cell: str, code: str, level: HelpLevel) -> None:
    rows = [ARM[0], (*ARM[1][:3], cell), ARM[2]]
    verdict = grade(read("standard", ARM), read("standard", rows), NOTHING_FREE, None, level)
    told = [entry.code for entry in verdict.feedback if entry.row == 2]
    assert told == (["row_wrong"] if level is HelpLevel.ROW else [code])
    assert [link.offset.value for link in verdict.links if link.row != 2] == ["ok", "ok"]
    if level is not HelpLevel.ROW:
        assert (verdict.links[1].offset.value, verdict.links[1].joint.value) == ("ok", "wrong")


def test_the_zero_of_a_slider_is_no_angle() -> None:
    def table(d: str) -> Rows:
        return [("pi/2", 0, "q1", 0), ("pi/2", 0, d, 0), (0, 0, "q3", 0)]

    verdict = grade(read("standard", table("q2")), read("standard", table("q2 + 0.3")), NOTHING_FREE)
    assert [entry.code for entry in verdict.feedback if entry.row] == ["variable_zero_wrong"]
    assert [edit.code for repair in verdict.repairs for edit in repair.edits] == ["d_offset"]


SCARA: Rows = [(0, 0, "L0", "q1"), ("pi", "L1", 0, "q2"), (0, 0, "q3", 0), (0, "L2", "L3", "q4")]


@pytest.mark.parametrize("row", [1, 4])
def test_a_length_along_a_slider_is_told_in_its_row(row: int) -> None:
    """Along parallel axes it may be missing in any row; the zero of the slider is one of them."""
    rows = list(SCARA)
    rows[row - 1] = (*SCARA[row - 1][:2], 0, SCARA[row - 1][3])
    verdict = grade(read("modified", SCARA), read("modified", rows), NOTHING_FREE)
    told = [(entry.code, entry.row) for entry in verdict.feedback if entry.row]
    assert {("offset_wrong", row), ("variable_zero_wrong", 3)} <= set(told)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("d_missing", row)]


@pytest.mark.parametrize(("column", "code"), [(1, "a_missing"), (2, "d_missing")], ids=["a", "d"])
def test_a_row_of_zeros_is_filled_rather_than_another_added(column: int, code: str) -> None:
    """Rows of zeros change nothing, and cost nothing; the one that was left unfinished is named."""
    key: Rows = [(0, 0, "L1", "q1"), ("pi/2", 0, 0, "q2"), (0, 0, 0, 0)]
    key[2] = (*key[2][:column], "L2", *key[2][column + 1 :])
    unfinished = read("modified", [*key[:2], (0, 0, 0, 0)])
    verdict = grade(read("modified", key), unfinished, NOTHING_FREE)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [(code, 3)]
    assert (column == 1) is ({entry.row for entry in verdict.feedback if entry.row} == {3})
    left_out = grade(read("modified", key), read("modified", key[:2]), NOTHING_FREE)
    assert [(edit.code, edit.row) for edit in left_out.repairs[0].edits] == [("fixed_row_missing", 3)]
    assert left_out.score == verdict.score
