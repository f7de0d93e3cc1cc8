"""Where the figure fixes the zeros, a slider's constant is told wherever the slider stands in the chain."""

import pytest

from exercises.grading import BaseRule, HelpLevel, Policy, ToolRule, ZeroRule, grade
from tests.exercises.grading.written import Cell, read

Rows = list[tuple[Cell, Cell, Cell, Cell]]
FIXED = Policy(base=BaseRule.FRAME, tool=ToolRule.POINT, zero=ZeroRule.FIGURE)
ON_AXIS = Policy(base=BaseRule.FRAME, tool=ToolRule.AXIS, zero=ZeroRule.FIGURE)
FREE_BASE = Policy(tool=ToolRule.POINT, zero=ZeroRule.FIGURE)
CARTESIAN: Rows = [(-90, 0, "q1+0.4", 0), (-90, 0, "q2+0.3", -90), (0, 0, "q3+0.2", 0)]
COLUMN: Rows = [(-90, 0, "q1+0.4", 0), (0, 0.5, 0.1, "q2"), (0, 0.3, 0, "q3")]
SPHERICAL: Rows = [(90, 0, 0.4, "q1"), (90, 0.3, 0, "q2"), (0, 0, "q3+0.2", 0)]


@pytest.mark.parametrize("wrong", ["{}", "{}+0.35"])
@pytest.mark.parametrize(
    ("key", "row", "policy"),
    [
        (CARTESIAN, 1, FIXED),
        (CARTESIAN, 2, FIXED),
        (CARTESIAN, 3, FIXED),
        (COLUMN, 1, FIXED),
        (COLUMN, 1, ON_AXIS),
        (SPHERICAL, 3, FIXED),
        (SPHERICAL, 3, FREE_BASE),
    ],
    ids=["first", "second", "third", "column", "column, tool on the axis", "last", "last, base free"],
)
def test_the_constant_of_a_slider_is_told(key: Rows, row: int, policy: Policy, wrong: str) -> None:
    alpha, a, _, theta = key[row - 1]
    answer = [*key[: row - 1], (alpha, a, wrong.format(f"q{row}"), theta), *key[row:]]
    verdict = grade(read("standard", key, "deg"), read("standard", answer, "deg"), policy)
    assert not verdict.correct
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("d_offset", row)]
    shown = grade(
        read("standard", key, "deg"), read("standard", answer, "deg"), policy, help_level=HelpLevel.ROW
    )
    assert row in {entry.row for entry in shown.feedback}
