"""Two mistakes or more are told where they were made, as a single one is."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import product
from random import Random

import pytest

from exercises.grading import BaseRule, DirectionRule, HelpLevel, Policy, ToolRule, Verdict, ZeroRule, grade
from kinematics.conversion import convert
from kinematics.table import Convention, DHTable, NumericRow, NumericTable
from tests.exercises.grading.campaign import drawn_by_hand
from tests.exercises.grading.test_grade import Rows, with_cells
from tests.exercises.grading.told import codes, repairs
from tests.exercises.grading.written import read, written
from tests.kinematics.equivalence.campaign import catalogue
from tests.kinematics.equivalence.tables import HALF, PUMA, F, P, R, changed, standard

FRAMES = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
STRICT = Policy(
    base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
)
FREE = Policy(tool=ToolRule.FREE)
SIX = [(name, key) for name, key in catalogue() if key.n_joints == 6]
SCARA = standard((R, 0, 0.35, 0.4, 0), (R, math.pi, 0.25, 0, 0), (P, 0, 0, 0, 0), (R, 0, 0, 0.08, 0))
Slips = Mapping[tuple[int, str], float]


def told(key: NumericTable, slips: Slips, policy: Policy, level: HelpLevel = HelpLevel.REPAIR) -> Verdict:
    """The verdict on the key's own table, lengths with as many digits as they are typed with, and slips."""
    table = key
    for (row, cell), value in slips.items():
        table = changed(table, row, **{cell: value})
    return grade(written(key), written(table), policy, help_level=level)


def accused(verdict: Verdict) -> list[tuple[str, int | None]]:
    """What is said of rows, in order; and that there is a choice."""
    return [(one.code, one.row) for one in verdict.feedback if one.row or one.code == "one_of_these"]


@pytest.mark.parametrize("policy", [FREE, Policy(tool=ToolRule.AXIS)], ids=["free", "axis"])
@pytest.mark.parametrize(
    ("other", "code"),
    [((2, "a", 0.5), "length_wrong"), ((3, "a", 0.05), "length_wrong"), ((4, "d", 0.5), "offset_wrong"),
     ((1, "alpha", 0.0), "twist_wrong")],
)  # fmt: skip
def test_beside_another_mistake_a_typed_offset_is_accused_before_a_zero(
    policy: Policy, other: tuple[int, str, float], code: str
) -> None:
    row, cell, value = other
    verdict = told(PUMA, {(3, "d"): 0.22, (row, cell): value}, policy)
    assert set(accused(verdict)) == {("offset_wrong", 3), (code, row)}
    assert [one.row for one in told(PUMA, {(3, "d"): 0.22}, policy).feedback if one.row] == [3]


def test_beside_a_sure_mistake_only_the_other_one_is_a_choice() -> None:
    choice = accused(told(SCARA, {(4, "d"): 0.19}, STRICT))
    assert choice == [("one_of_these", None), ("offset_wrong", 1), ("offset_wrong", 4)]
    assert accused(told(SCARA, {(4, "d"): 0.19, (1, "a"): 0.4}, STRICT)) == [("length_wrong", 1), *choice]
    by_row = told(SCARA, {(4, "d"): 0.19, (1, "a"): 0.4}, STRICT, HelpLevel.ROW)
    assert accused(by_row) == [
        ("row_wrong", 1), ("one_of_these", None), ("row_wrong", 1), ("row_wrong", 4)
    ]  # fmt: skip


SKEW = standard(*((R, math.radians(twist), a, d, 0) for twist, a, d in (
    (60, 0.1, 0.4), (30, 0.4, 0.1), (-45, 0.05, 0.2), (60, 0.02, 0.35), (-60, 0.03, 0.1), (0, 0.01, 0.08)
)))  # fmt: skip


@pytest.mark.parametrize("tool", [ToolRule.FREE, ToolRule.AXIS, ToolRule.POINT, ToolRule.FRAME])
@pytest.mark.parametrize("base", [BaseRule.ORIGIN, BaseRule.FRAME])
@pytest.mark.parametrize("row", range(1, 6))
def test_the_supplement_of_a_twist_is_mended_in_its_cell(base: BaseRule, tool: ToolRule, row: int) -> None:
    supplement = math.pi - SKEW.rows[row - 1].alpha
    verdict = told(SKEW, {(row, "alpha"): supplement}, Policy(base=base, tool=tool))
    assert not verdict.correct
    assert {place for _, place in accused(verdict)} - {None} == {row}
    assert repairs(verdict)[0] == [("alpha_value", row)]
    assert {place for repair in repairs(verdict) for _, place in repair} == {row}


@pytest.mark.parametrize("policy", [FRAMES, STRICT], ids=["frames", "strict"])
@pytest.mark.parametrize("row", range(1, 6))
def test_a_sign_that_is_wrong_is_one_change_and_not_two(policy: Policy, row: int) -> None:
    verdict = told(SKEW, {(row, "alpha"): -SKEW.rows[row - 1].alpha}, policy)
    assert [("alpha_sign", row)] in repairs(verdict)
    assert [("alpha_value", row)] not in repairs(verdict)


@pytest.mark.parametrize("policy", [Policy(tool=ToolRule.POINT), FRAMES], ids=["point", "frames"])
@pytest.mark.parametrize(("cell", "code"), [("d", "offset_wrong"), ("a", "length_wrong")])
def test_of_three_mistakes_that_of_the_tool_is_told_in_its_cell(policy: Policy, cell: str, code: str) -> None:
    verdict = told(PUMA, {(2, "a"): 0.5, (3, "a"): 0.05, (6, cell): 0.1}, policy)
    assert accused(verdict) == [("length_wrong", 2), ("length_wrong", 3), (code, 6)]


WRONG = ((2, "alpha", HALF), (3, "a", 0.07), (4, "d", 0.2), (5, "alpha", 0.0))


@pytest.mark.parametrize(
    ("missing", "row", "cell", "value"),
    [(missing, *wrong) for missing in range(1, 7) for wrong in WRONG if wrong[0] != missing],
)
def test_a_row_forgotten_and_one_wrong_cell_are_both_mended(
    missing: int, row: int, cell: str, value: float
) -> None:
    """The row comes first where the cell is not seen to be wrong before the joints are the key's."""
    rows = [*changed(PUMA, row, **{cell: value}).rows]
    del rows[missing - 1]
    verdict = grade(written(PUMA), written(standard_table(rows)), FREE, help_level=HelpLevel.REPAIR)
    assert verdict.repairs
    assert any("row_missing" in {edit.code for edit in repair.edits} for repair in verdict.repairs)
    if not (
        missing == 6 and row == 5
    ):  # there the last row, which is zero but for its joint, is the one left
        assert all(len(repair.edits) == 2 for repair in verdict.repairs)


def standard_table(rows: Sequence[NumericRow]) -> NumericTable:
    return DHTable(convention=Convention.STANDARD, rows=tuple(rows))


def test_a_key_without_joints_is_judged_without_a_failure(caplog: pytest.LogCaptureFixture) -> None:
    key = standard((F, 0, 0, 0, 0))
    verdict = grade(written(key), written(standard((R, 0, 0, 0, 0))), STRICT)
    assert (verdict.correct, verdict.score) == (False, 0.0)
    assert not caplog.records


@pytest.mark.parametrize("name", ["rx90", "puma560", "irb140"])
def test_no_explanation_of_a_forgotten_row_and_an_angle_in_degrees_fails(name: str) -> None:
    """An explanation that fails is logged, and so fails the test."""
    key = dict(SIX)[name]
    table = drawn_by_hand(key, Random(name))
    assert table is not None
    for missing, row in product(range(1, len(table.rows) + 1), repeat=2):
        alpha = table.rows[row - 1].alpha
        if row != missing and alpha:
            rows = [*changed(table, row, alpha=math.degrees(alpha)).rows]
            del rows[missing - 1]
            wrong = DHTable(convention=table.convention, rows=tuple(rows))
            assert not grade(written(key), written(wrong), FREE, help_level=HelpLevel.REPAIR).correct


def test_two_wrong_types_are_no_rows_exchanged() -> None:
    """Rows 3 and 5 exchanged would explain the table as well; but of all the rest nothing is wrong."""
    key = dict(catalogue())["stanford"]
    wrong = changed(changed(key, 3, joint=R), 5, joint=P)
    verdict = grade(written(key), written(wrong), Policy(tool=ToolRule.FREE))
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [
        ("joint_type", 3),
        ("joint_type", 5),
    ]
    assert verdict.score == 0.44


@pytest.mark.parametrize("convention", Convention)
def test_a_joint_that_took_its_offset_along_has_changed_rows(convention: Convention) -> None:
    """One slip has one mark in either convention, though in the modified one the types alone are off."""
    key = dict(catalogue())["stanford"]
    first, second, third, *rest = convert(key, convention).table.rows
    wrong = DHTable(convention=convention, rows=(first, third, second, *rest))
    verdict = grade(written(key), written(wrong), FREE)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("rows_swapped", 2)]
    assert verdict.score == 0.67


def test_columns_are_not_exchanged_in_the_row_of_a_wrong_twist_alone() -> None:
    """A d of 90 instead of α would mend a SCARA, for d is free; but nobody asks for it."""
    key = convert(dict(catalogue())["scara"], Convention.STANDARD).table
    verdict = told(key, {(2, "alpha"): HALF}, Policy(tool=ToolRule.AXIS))
    assert [[edit.code for edit in repair.edits] for repair in verdict.repairs] == [["alpha_value"]]
    arm = standard((R, HALF, 0.3, 0, 0), (R, 0, 0.2, 0, 0))
    exchanged = told(arm, {(1, "alpha"): 0.0, (1, "d"): HALF}, FREE)
    assert [edit.code for repair in exchanged.repairs for edit in repair.edits] == [
        "columns_exchanged", "alpha_value"
    ]  # fmt: skip


@pytest.mark.parametrize("name", ["puma560", "stanford", "scara", "twolink"])
def test_angles_counted_by_the_left_hand_throughout_are_one_slip(name: str) -> None:
    key = dict(catalogue())[name]
    rows = tuple(replace(row, sign=-row.sign) if row.joint is R else row for row in key.rows)
    wrong = DHTable(convention=key.convention, rows=rows)
    verdict = grade(written(key), written(wrong), STRICT)
    assert [edit.code for edit in verdict.repairs[0].edits] == ["turns_all_reversed"]
    assert accused(verdict) == []
    assert verdict.feedback[-1].code == "turns_throughout"


@pytest.mark.parametrize("name", ["scara", "stanford"])
def test_variables_that_all_count_the_other_way_accuse_no_right_cell(name: str) -> None:
    """A wrong twist and a row missing at the tool would mend a SCARA as well, and so it was told."""
    key = dict(catalogue())[name]
    rows = tuple(replace(row, sign=-row.sign) for row in key.rows)
    verdict = grade(written(key), written(DHTable(convention=key.convention, rows=rows)), STRICT)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [
        ("turns_all_reversed", None), ("variable_sign", 3)
    ]  # fmt: skip
    assert accused(verdict) == [("variable_direction_wrong", 3)]


def test_a_left_handed_table_of_an_arm_with_one_twist_is_wrong_in_its_signs() -> None:
    key = standard((R, HALF, 0, 0.4, 0), (R, 0, 0.5, 0, 0), (R, 0, 0.3, 0, 0))
    rows = tuple(replace(row, alpha=-row.alpha, sign=-row.sign) for row in key.rows)
    verdict = grade(written(key), written(DHTable(convention=key.convention, rows=rows)), STRICT)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [
        ("turns_all_reversed", None), ("alpha_sign", 1)
    ]  # fmt: skip
    assert accused(verdict) == [("twist_wrong", 1)]


def test_neighbours_in_line_are_exchanged() -> None:
    """The last two joints of a SCARA make the same motions in either order."""
    key = dict(catalogue())["scara"]
    wrong = changed(changed(key, 3, joint=R), 4, joint=P)
    verdict = grade(written(key), written(wrong), Policy(tool=ToolRule.FREE))
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("rows_swapped", 3)]


@pytest.mark.parametrize(("missing", "row", "cell"), [(3, 5, "alpha"), (5, 2, "a"), (2, 4, "d")])
def test_a_wrong_cell_is_told_beside_a_missing_row_in_the_wrong_convention(
    missing: int, row: int, cell: str
) -> None:
    wrong = changed(PUMA, row, **{cell: 0.37})
    rows = tuple(given for i, given in enumerate(wrong.rows, 1) if i != missing)
    answer = DHTable(convention=Convention.MODIFIED, rows=rows)
    verdict = grade(written(PUMA), written(answer), FREE)
    edits = [(edit.code, edit.row) for edit in verdict.repairs[0].edits]
    assert edits[0] == ("convention", None)
    assert {code for code, _ in edits[1:]} == {"row_missing", f"{cell}_value"}
    place = row - (row > missing)
    assert {at for code, at in edits if code != "row_missing"} == {None, place}
    assert verdict.score == round(1 - (3 + 2 + 1) / 9, 2)


def test_three_slips_in_names_are_told_as_well() -> None:
    key: Rows = [
        ("pi/2", 0, 0, "q1"),
        (0, "a2", 0, "q2"),
        ("-pi/2", "a3", "d3", "q3"),
        ("pi/2", 0, "d4", "q4"),
    ]
    key += [("-pi/2", 0, 0, "q5"), (0, 0, 0, "q6")]
    rows = with_cells([*key[:4], key[5]], (2, 1, "a3"), (5, 3, "q5"))
    verdict = grade(read("standard", key), read("modified", rows), FREE)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [
        ("convention", None),
        ("cell_parameter", 2),
        ("row_missing", 5),
    ]


def with_twists(key: NumericTable, twists: Sequence[float]) -> NumericTable:
    """A table with other twists, from the first row on."""
    table = key
    for row, alpha in enumerate(twists, 1):
        table = changed(table, row, alpha=alpha)
    return table


def test_twists_that_alone_stand_in_the_next_row_are_told_as_that() -> None:
    """The lengths are right: that of row 3 was called wrong."""
    twists = [row.alpha for row in PUMA.rows]
    verdict = grade(written(PUMA), written(with_twists(PUMA, [0.0, *twists[:-1]])), FREE)
    assert [edit.code for edit in verdict.repairs[0].edits] == ["twists_late"]
    assert codes(verdict) == ["not_equivalent", "twists_out_of_place"]
    assert verdict.score == round(1 - 3 / 9, 2)
    once_more = grade(written(PUMA), written(changed(with_twists(PUMA, [0.0, *twists[:-1]]), 2, a=0.7)), FREE)
    assert once_more.score == round(1 - 4 / 9, 2)


def test_of_twists_in_the_row_before_the_first_is_lost() -> None:
    twists = [row.alpha for row in PUMA.rows]
    verdict = grade(written(PUMA), written(with_twists(PUMA, [*twists[1:], 0.0])), FREE)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [
        ("twists_early", None),
        ("alpha_value", 1),
    ]


def test_which_of_two_rows_is_missing_is_left_open_beside_a_wrong_cell() -> None:
    """Row 5 of the wrist was told to be missing, where row 6 was."""
    wrong = changed(PUMA, 2, a=0.7)
    verdict = grade(written(PUMA), written(DHTable(convention=PUMA.convention, rows=wrong.rows[:5])), FREE)
    assert accused(verdict) == [
        ("length_wrong", 2),
        ("one_of_these", None),
        ("row_missing", 5),
        ("row_missing", 6),
    ]


@pytest.mark.parametrize(("missing", "first"), [(0, 1), (0, 3), (1, 2), (2, 3)])
def test_two_edits_that_may_be_made_in_either_order_are_told_once(missing: int, first: int) -> None:
    """A row left out and two rows exchanged, numbered as they stand in the answer."""
    rows = [row for number, row in enumerate(PUMA.rows) if number != missing]
    rows[first], rows[first + 1] = rows[first + 1], rows[first]
    answer = DHTable(convention=PUMA.convention, rows=tuple(rows))
    found = grade(written(PUMA), written(answer), FREE).repairs
    edits = [frozenset((edit.code, edit.row) for edit in repair.edits) for repair in found]
    assert frozenset({("row_missing", missing + 1), ("rows_swapped", first + 1)}) in edits
    assert len(edits) == len(set(edits))


@pytest.mark.parametrize(
    ("name", "row"),
    [("cloos", 3), ("dmra", 1), ("rx90", 3), ("stanford", 3), ("puma560", 1), ("uw", 2)],
)
def test_twists_that_stand_in_each_others_rows_are_told_as_that_alone(name: str, row: int) -> None:
    key = dict(catalogue())[name]
    one, other = key.rows[row - 1].alpha, key.rows[row].alpha
    verdict = told(key, {(row, "alpha"): other, (row + 1, "alpha"): one}, FREE)
    assert [(edit.code, edit.row, edit.params["other"]) for edit in verdict.repairs[0].edits] == [
        ("twists_swapped", row, row + 1)
    ]
    assert accused(verdict) == [("twist_wrong", row), ("twist_wrong", row + 1)]
    by_row = accused(told(key, {(row, "alpha"): other, (row + 1, "alpha"): one}, FREE, HelpLevel.ROW))
    assert by_row == [("row_wrong", row), ("row_wrong", row + 1)]


def test_twists_in_each_others_rows_are_one_idea_where_the_second_only_spoils_the_tool() -> None:
    """α5 of RX 90 alone mends all facts, α6 only the tool's line: two cells were said to be wrong."""
    key = convert(dict(catalogue())["rx90"], Convention.STANDARD).table
    answer = changed(changed(changed(key, 6, d=0.1), 5, alpha=0.0), 6, alpha=key.rows[4].alpha)
    policy = Policy(tool=ToolRule.AXIS)
    verdict = grade(written(key), written(answer), policy)
    (repair,) = verdict.repairs
    assert [(edit.code, edit.row, edit.params["other"]) for edit in repair.edits] == [
        ("twists_swapped", 5, 6)
    ]
    assert accused(verdict) == [("twist_wrong", 5), ("twist_wrong", 6)]
    elsewhere = changed(answer, 6, alpha=math.pi / 3)
    assert len(grade(written(key), written(elsewhere), policy).repairs[0].edits) == 2


@pytest.mark.parametrize(("name", "row"), [("dmra", 5), ("kr125", 1), ("ur5", 5)])
def test_a_twist_that_no_frame_asks_for_is_not_accused_of_being_elsewhere(name: str, row: int) -> None:
    key = dict(catalogue())[name]
    one, other = key.rows[row - 1].alpha, key.rows[row].alpha
    verdict = told(key, {(row, "alpha"): other, (row + 1, "alpha"): one}, FREE)
    assert [[edit.code for edit in repair.edits] for repair in verdict.repairs] == [["alpha_value"]]


@pytest.mark.parametrize("off", [math.pi, 0.4])
def test_two_zeros_at_the_ends_of_an_arm_are_told_where_both_frames_are_fixed(off: float) -> None:
    """Neither alone leaves less misplaced; where one end is free, the other is told alone."""
    slips = {(1, "theta"): off, (4, "theta"): 0.4}
    assert repairs(told(SCARA, slips, STRICT)) == [[("theta_offset", 1), ("theta_offset", 4)]]
    for free, row in (({"base": BaseRule.FREE}, 4), ({"tool": ToolRule.POINT}, 1)):
        assert repairs(told(SCARA, slips, replace(STRICT, **free))) == [[("theta_offset", row)]]
