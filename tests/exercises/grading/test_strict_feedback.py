"""What strict rules are told by: the variable of the row, and no length or angle that is right."""

from __future__ import annotations

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
