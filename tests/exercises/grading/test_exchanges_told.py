"""Wrong cells are told as such, not as an exchange, a shift or a missing row that makes up for them."""

import pytest

from exercises.grading import BaseRule, Policy, ToolRule, Verdict, grade
from exercises.grading.edits.row_edits import is_foreign
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from kinematics.table import bind
from tests.exercises.grading.test_typed_before_zeros import PUMA
from tests.exercises.grading.told import repairs
from tests.exercises.grading.written import Cell, read

Rows = list[tuple[Cell, Cell, Cell, Cell]]
POINT, FREE = Policy(tool=ToolRule.POINT), Policy(tool=ToolRule.FREE)
WRIST: Rows = [(90, 0, 0, "q1"), (-90, 0, 0, "q2 + 180"), (90, 0, 0, "q3 + 90")]
STANFORD: Rows = [
    (0, 0, "L0", "q1"),
    (-90, 0, "L1", "q2"),
    (90, 0, "q3", 0),
    (0, 0, 0, "q4"),
    (-90, 0, 0, "q5"),
    (90, 0, "L2", "q6"),
]
KUKA: Rows = [
    (180, 0, "-L0", "q1"),
    (90, "L1", 0, "q2"),
    (0, "L2", 0, "q3 - 90"),
    (90, 0, "-L3", "q4"),
    (-90, 0, 0, "q5"),
    (90, 0, "-L4", "q6"),
    (180, 0, 0, 180),
]
ENDED: Rows = [(0, 0, 0, "q1"), (90, "L1", 0, "q2"), (0, "L2", 0, "q3"), (0, "L3", 0, 0)]
COLUMNS = ("alpha", "a", "d", "theta")


def _told(key: Rows, policy: Policy, *wrong: tuple[int, str, Cell]) -> Verdict:
    rows = [list(row) for row in key]
    for row, cell, value in wrong:
        rows[row - 1][COLUMNS.index(cell)] = value
    answer = [(row[0], row[1], row[2], row[3]) for row in rows]
    return grade(read("modified", key, "deg"), read("modified", answer, "deg"), policy)


@pytest.mark.parametrize(
    ("key", "wrong"),
    [
        (STANFORD, [(4, "alpha", 90), (4, "a", "L0")]),
        (WRIST, [(2, "alpha", -66), (2, "d", 0.384)]),
        (WRIST, [(2, "alpha", -66), (2, "a", 0.2143)]),
    ],
)
def test_nothing_is_moved_where_it_hides_what_no_row_of_the_key_has(
    key: Rows, wrong: list[tuple[int, str, Cell]]
) -> None:
    """Before the first joint every twist and length would do: rows were exchanged, or columns a row late."""
    verdict = _told(key, FREE, *wrong)
    assert {entry.row for entry in verdict.feedback if entry.row} == {wrong[0][0]}
    assert all(edit.row == wrong[0][0] for edit in verdict.repairs[0].edits)


@pytest.mark.parametrize("first", [0, 180])
def test_rows_that_are_exchanged_are_told(first: Cell) -> None:
    """Row 2 may be the first: its twist is one of the key's, and 180° lets z₀ point the other way."""
    rows = [STANFORD[1], (first, *STANFORD[0][1:]), *STANFORD[2:]]
    answer = [(*row[:3], f"q{k}" if k != 3 else row[3]) for k, row in enumerate(rows, 1)]
    verdict = grade(read("modified", STANFORD, "deg"), read("modified", answer, "deg"), FREE)
    assert "rows_out_of_order" in [entry.code for entry in verdict.feedback]


def test_the_last_two_rows_are_exchanged_whose_last_axis_points_the_other_way() -> None:
    key = [("-pi/2", 0, 0, "q1"), (0, "L1", 0, "q2"), ("pi/2", 0, 0, "q3"), (0, 0, "L2", "q4")]
    rows = [*key[:2], ("pi", 0, "L2", "q3"), ("pi/2", 0, 0, "q4")]
    verdict = grade(read("standard", key), read("standard", rows), FREE)
    assert "rows_out_of_order" in [entry.code for entry in verdict.feedback]


def test_a_cell_is_told_before_an_exchange_within_its_row() -> None:
    """That a length stands in the wrong column, and that a last row is missing, takes more than two cells."""
    verdict = _told(STANFORD, POINT, (6, "a", "L0"), (6, "d", 0))
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [
        ("a_not_zero", 6),
        ("d_missing", 6),
    ]
    assert {entry.code for entry in verdict.feedback} == {"not_equivalent", "length_wrong", "offset_wrong"}


@pytest.mark.parametrize("tool", [0, "L0"])
def test_no_last_row_is_missing_that_is_there(tool: Cell) -> None:
    """The table ends with a row without a variable, of which a length is wrong."""
    verdict = _told(KUKA, POINT, (6, "d", tool), (7, "a", "L0"))
    assert "row_missing" not in [entry.code for entry in verdict.feedback]
    assert 7 in {entry.row for entry in verdict.feedback}


def test_two_lengths_of_the_last_joint_are_told_and_no_row_behind_it() -> None:
    """A last row would have to take back the length that should not be there."""
    key: Rows = [(-90, "a1", "d1", "q1"), (0, "a2", 0, "q2"), (0, 0, "d3", "q3")]
    answer: Rows = [*key[:2], (0, "a1", 0, "q3")]
    verdict = grade(read("standard", key, "deg"), read("standard", answer, "deg"), POINT)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [
        ("a_not_zero", 3),
        ("d_missing", 3),
    ]
    assert "row_missing" not in [entry.code for entry in verdict.feedback]


@pytest.mark.parametrize("wrong", [(2, "d", "L1"), (2, "alpha", 0), (3, "a", "L1")])
def test_beside_another_mistake_a_last_row_of_zeros_lacks_its_length(wrong: tuple[int, str, Cell]) -> None:
    """A row was said to be missing behind it."""
    verdict = _told(ENDED, POINT, wrong, (4, "a", 0))
    assert ("a_missing", 4) in [(edit.code, edit.row) for edit in verdict.repairs[0].edits]
    assert "row_missing" not in [entry.code for entry in verdict.feedback]


@pytest.mark.parametrize("rows", [1, 2, 3])
def test_of_last_rows_of_zeros_the_first_lacks_the_length(rows: int) -> None:
    """It might stand in any of them: they were all accused."""
    answer: Rows = [*ENDED[:3], *[(0, 0, 0, 0)] * rows]
    verdict = grade(read("modified", ENDED, "deg"), read("modified", answer, "deg"), POINT)
    assert [[(edit.code, edit.row) for edit in repair.edits] for repair in verdict.repairs] == [
        [("a_missing", 4)]
    ]


@pytest.mark.parametrize("row", [3, 5])
def test_an_offset_beside_a_twist_that_hides_it_is_told_in_its_own_row(row: int) -> None:
    """Along axes that are parallel by mistake there is no offset: those of two rows were called wrong."""
    key: Rows = [
        (-90, "a1", "d1", "q1"),
        (0, "a2", 0, "q2"),
        (-90, "a3", 0, "q3"),
        (90, 0, "d4", "q4"),
        (-90, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ]
    answer = [*key]
    answer[row - 1] = (0, key[row - 1][1], "a1", f"q{row}")
    verdict = grade(read("standard", key, "deg"), read("standard", answer, "deg"), POINT)
    edits = [{(edit.code, edit.row) for edit in repair.edits} for repair in verdict.repairs]
    assert {("alpha_value", row), ("d_not_zero", row)} in edits
    assert row + 1 not in {entry.row for entry in verdict.feedback}


def test_beside_a_wrong_length_all_signs_that_mirror_the_arm_are_told() -> None:
    """Exchanges within row 1 left no room for them: row 3, which is right, was accused alone."""
    answer: Rows = [(90, "a2", 0, "q1"), *PUMA[1:3], (90, 0, "-d4", "q4"), *PUMA[4:]]
    verdict = grade(read("standard", PUMA, "deg"), read("standard", answer, "deg"), Policy())
    told = [(entry.code, entry.row) for entry in verdict.feedback]
    assert told[1:] == [("length_wrong", 1), ("one_of_these", None), ("sign_wrong", 3), ("sign_wrong", 4)]


@pytest.mark.parametrize(
    ("alpha", "a", "foreign"),
    [(0, 0, False), (90, 0.3, False), (-90, -0.7, False), (57.29577951308232, 0, True), (0, 1, True)],
)
def test_nothing_is_in_every_key_even_where_each_of_its_rows_has_a_twist_and_a_length(
    alpha: Cell, a: Cell, foreign: bool
) -> None:
    key = read("standard", [(90, 0.3, 0, "q1"), (-90, 0.7, 0, "q2")], "deg")
    work = work_on(comparisons(key, key, {})[0], (key, key), FREE)
    row = bind(read("standard", [(alpha, a, 0, "q1")], "deg").table, {}).rows[0]
    assert is_foreign(work, row) is foreign


def test_a_last_row_of_zeros_is_told_only_where_what_it_lacks_mends_the_answer_as_soon() -> None:
    """With a twist and two lengths it takes three cells; a single length may as well be wrong before it."""
    key: Rows = [(0, 0, 0.35, "q1"), (90, 0.02, 0.01, "q2"), (0, 0.22, 0, "q3"), (90, 0.3, 0.2, 0)]
    frames = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
    assert repairs(_told(key, frames, (4, "alpha", 0), (4, "a", 0), (4, "d", 0))) == [
        [("fixed_row_missing", 5)]
    ]
    links, longer = (read("standard", [(0, 0.5, 0, "q1"), (0, a, 0, "q2"), (0, 0, 0, 0)]) for a in (0.3, 0.7))
    assert repairs(grade(links, longer, Policy(tool=ToolRule.FRAME))) == [
        [("a_value", 2)],
        [("a_missing", 3)],
        [("fixed_row_missing", 4)],
    ]


TILTED_WRIST: Rows = [(60, 0, 0, "q1"), (-60, 0, 0, "q2"), (0, 0, "t", "q3")]
TWO_LINKS: Rows = [(45, "L2", "L1", "q1"), (0, 0, "L3", "q2")]


@pytest.mark.parametrize(
    ("key", "answer"),
    [
        (TILTED_WRIST, [(60, "t", 0, "q1"), TILTED_WRIST[1], (0, 0, 0, "q3")]),
        (TWO_LINKS, [(45, "L1", "L1", "q1"), (0, 0, "L2", "q2")]),
    ],
    ids=["columns", "names"],
)
def test_two_cells_are_told_before_an_exchange_throughout_and_a_row_behind_it(
    key: Rows, answer: Rows
) -> None:
    """The exchange moves the marked point, and a row to it makes up for that."""
    verdict = grade(read("standard", key, "deg"), read("standard", answer, "deg"), POINT)
    assert {entry.row for entry in verdict.feedback if entry.row} == {1, len(key)}
    assert "row_missing" not in [entry.code for entry in verdict.feedback]
