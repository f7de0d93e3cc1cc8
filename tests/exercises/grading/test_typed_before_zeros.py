"""A length that was typed is likelier wrong than a zero, however the table is written."""

import pytest

from exercises.grading import BaseRule, HelpLevel, Policy, ToolRule, Verdict, ZeroRule, grade
from kinematics.cells import ReadTable
from tests.exercises.grading.written import Cell, read

Rows = list[tuple[Cell, Cell, Cell, Cell]]
VALUES = {"a2": 0.4, "a3": 0.3}
KEY: Rows = [(0, 0, 0, "q1"), (0, "a2", 0, "q2"), (0, "a3", "q3", 0), (0, 0, 0, "q4")]
STANDARD: Rows = [(0, "a2", 0, "q1"), (0, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]
TURNED: Rows = [(0, "a2", 0, "q1"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]
SPREAD: Rows = [(0, "a2", 0, "q1"), (0, 0, 0, "q2"), (0, "a3", 0, 0), (0, 0, "q3", 0), (0, 0, 0, "q4")]
ARM = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4331}
AXIS = Policy(tool=ToolRule.AXIS)


def _scara(convention: str, rows: Rows) -> ReadTable:
    return read(convention, rows, "deg")


def _told(key: ReadTable, answer: ReadTable, level: HelpLevel = HelpLevel.KIND) -> Verdict:
    return grade(key, answer, AXIS, VALUES, level)


def _named(verdict: Verdict) -> list[tuple[str, int]]:
    return [(entry.code, entry.row) for entry in verdict.feedback if entry.row]


def _with(rows: Rows, row: int, a: Cell) -> Rows:
    alpha, _, d, theta = rows[row - 1]
    return [*rows[: row - 1], (alpha, a, d, theta), *rows[row:]]


@pytest.mark.parametrize("wrong", ["a2", 0.35, "2 a3"])
@pytest.mark.parametrize(
    ("convention", "rows", "row"),
    [("standard", STANDARD, 2), ("standard", TURNED, 2), ("standard", SPREAD, 3), ("modified", KEY, 3)],
)
def test_one_wrong_length_is_told_where_it_was_typed(
    convention: str, rows: Rows, row: int, wrong: Cell
) -> None:
    """The axis of a slider lies anywhere, so a length in the row of zeros behind it would mend them too."""
    key = _scara("modified", KEY)
    assert _told(key, _scara(convention, rows)).correct
    answer = _scara(convention, _with(rows, row, wrong))
    assert _named(_told(key, answer)) == [("length_wrong", row)]
    assert _named(_told(key, answer, HelpLevel.ROW)) == [("row_wrong", row)]


@pytest.mark.parametrize("wrong", ["a2", 0.35])
def test_beside_an_origin_of_ones_own_the_length_that_becomes_one_of_the_keys_is_told(wrong: Cell) -> None:
    """Frame 2 slid by 0.1 along its axis and back: no table of the key's, but its lengths."""
    slid: Rows = [(0, "a2", 0, "q1"), (0, "a3", 0.1, "q2"), (0, 0, "q3", 0), (0, 0, -0.1, "q4")]
    key = _scara("modified", KEY)
    assert _told(key, _scara("standard", slid)).correct
    answer = _scara("standard", _with(slid, 2, wrong))
    assert _named(_told(key, answer)) == [("length_wrong", 2)]


@pytest.mark.parametrize("d", [0, "a2", 0.1])
def test_a_length_too_many_behind_the_last_axis_is_told(d: Cell) -> None:
    """No fact shows it: of where the last frame lies, only that its z stays on the axis is asked."""
    rows: Rows = [*STANDARD[:3], (0, "a2", d, "q4")]
    verdict = _told(_scara("modified", KEY), _scara("standard", rows), HelpLevel.REPAIR)
    first = verdict.repairs[0].edits
    assert [(edit.code, edit.row, edit.cell) for edit in first] == [("a_not_zero", 4, "a")]


def test_a_forgotten_last_row_is_told_first_in_the_other_convention() -> None:
    """The sign of d₄ before it leads to the frame of the tool as well; written is the key's own form."""
    rows: Rows = [
        (180, 0, -0.85, "q1"),
        (90, 0.4, 0, "q2"),
        (0, 1.0, 0, "q3 - 90"),
        (90, 0, -1.0, "q4"),
        (-90, 0, 0, "q5"),
        (90, 0, -0.2, "q6"),
        (180, 0, 0, 180),
    ]
    standard: Rows = [
        (180, 0, 0, 0),
        (90, 0.4, -0.85, "q1"),
        (0, 1.0, 0, "q2"),
        (90, 0, 0, "q3 - 90"),
        (-90, 0, -1.0, "q4"),
        (90, 0, 0, "q5"),
        (180, 0, -0.2, "q6"),
    ]
    policy = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
    key = read("standard", standard, "deg")
    assert grade(key, read("modified", rows, "deg"), policy).correct
    verdict = grade(key, read("modified", rows[:-1], "deg"), policy)
    assert [edit.code for edit in verdict.repairs[0].edits] == ["fixed_row_missing"]


@pytest.mark.parametrize("zero", list(ZeroRule))
@pytest.mark.parametrize("theta", [90, 180, -90])
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_forgotten_last_row_that_turns_about_z(convention: str, theta: int, zero: ZeroRule) -> None:
    """A hand mounted round the last axis: the row turns, and leads to the prescribed frame."""
    rows: Rows = [(0, 0, 0.5, "q1"), (-90, 0, 0, "q2"), (0, 0.4, 0.1, "q3"), (0, 0.05, 0.2, theta)]
    policy = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=zero)
    key, answer = read(convention, rows, "deg"), read(convention, rows[:-1], "deg")
    verdict = grade(key, answer, policy)
    assert [[edit.code for edit in repair.edits] for repair in verdict.repairs] == [["fixed_row_missing"]]


PUMA_KEY: Rows = [
    (90, 0, 0, "q1"), (0, 0.4318, 0, "q2"), (-90, 0.0203, 0.15, "q3"),
    (90, 0, 0.4318, "q4"), (-90, 0, 0, "q5"), (0, 0, 0, "q6"),
]  # fmt: skip


@pytest.mark.parametrize("slid", [1.9247, 0.0745, -0.2814])
def test_of_an_offset_that_is_missing_along_parallel_axes_no_other_row_is_accused_alone(slid: float) -> None:
    """Frame 2 lies elsewhere on its axis, and that was left out in its own row."""
    rows: Rows = [
        (-90, 0, 0, "q1"), (0, -0.4318, slid, "q2"), (-90, 0.0203, -0.15 - slid, "q3"),
        (90, 0, -0.4318, "q4"), (-90, 0, 0, "q5"), (0, 0, 0, "q6"),
    ]  # fmt: skip
    key, policy = read("standard", PUMA_KEY, "deg"), Policy(tool=ToolRule.FREE)
    assert grade(key, read("standard", rows, "deg"), policy).correct
    left_out: Rows = [rows[0], (0, -0.4318, 0, "q2"), *rows[2:]]
    verdict = grade(key, read("standard", left_out, "deg"), policy, None, HelpLevel.ROW)
    assert {row for _, row in _named(verdict)} == {2, 3}


PUMA: Rows = [
    (90, 0, 0, "q1"),
    (0, "a2", 0, "q2"),
    (-90, "a3", "d3", "q3"),
    (90, 0, "d4", "q4"),
    (-90, 0, 0, "q5"),
    (0, 0, 0, "q6"),
]


@pytest.mark.parametrize("row", range(1, 7))
@pytest.mark.parametrize("padding", [0, 2])
def test_a_forgotten_variable_is_told_in_its_row(row: int, padding: int) -> None:
    """There is a row for every joint, so none is missing: in a row of zeros, too, like the PUMA's last."""
    key = read("standard", PUMA, "deg")
    alpha, a, d, _ = PUMA[row - 1]
    rows = [*PUMA[: row - 1], (alpha, a, d, 0), *PUMA[row:], *[(0, 0, 0, 0)] * padding]
    verdict = grade(key, read("standard", rows, "deg"), AXIS, ARM)
    assert _named(verdict)[0] == ("joint_type_wrong", row)
    assert ("row_missing", row) not in _named(verdict)


def test_a_row_left_out_beside_a_row_of_zeros_is_missing() -> None:
    key = read("standard", PUMA, "deg")
    verdict = grade(key, read("standard", [(0, 0, 0, 0), *PUMA[:5]], "deg"), AXIS, ARM)
    assert _named(verdict) == [("row_missing", 7)]


@pytest.mark.parametrize("zero", list(ZeroRule))
@pytest.mark.parametrize("convention", ["standard", "modified"])
@pytest.mark.parametrize(
    "last",
    [
        (90, 0, 0.25, 0),
        (-90, 0.15, 0.25, 180),
        (30, 0.1, -0.2, 40),
        (0, 0, 0.3, 90),
        (30, 0, 0, 40),
        (50, 0, 0.3, 0),
    ],
)
def test_a_forgotten_last_row_with_an_offset(
    convention: str, last: tuple[float, ...], zero: ZeroRule
) -> None:
    """No invariant shows the offset: what leads from the last frame to the prescribed one does."""
    rows: Rows = [(-90, 0, 0.5, "q1"), (90, 0.4, 0.1, "q2"), (60, 0.1, 0.2, "q3"), last]
    policy = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=zero)
    key, answer = read(convention, rows, "deg"), read(convention, rows[:-1], "deg")
    assert ["fixed_row_missing"] in [
        [edit.code for edit in repair.edits] for repair in grade(key, answer, policy).repairs
    ]


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_forgotten_last_row_behind_a_slider(convention: str) -> None:
    rows: Rows = [(-90, 0, 0.5, "q1"), (90, 0.1, "q2", 30), (60, 0.1, 0.2, 45)]
    policy = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
    verdict = grade(read(convention, rows, "deg"), read(convention, rows[:-1], "deg"), policy)
    assert ["fixed_row_missing"] in [[edit.code for edit in repair.edits] for repair in verdict.repairs]


@pytest.mark.parametrize("first", [(45, "-a1", 0, "q1"), (-45, "a1", 0, "q1")])
def test_beside_a_wrong_sign_too_a_typed_length_is_told_and_not_a_zero(
    first: tuple[Cell, Cell, Cell, Cell],
) -> None:
    """The slider could stand elsewhere, with a length in the row before it, where nothing was typed."""
    key: Rows = [
        (45, "a1", 0, "q1"),
        (90, 0, "d2", "q2"),
        (0, 0, "q3", 0),
        (-45, 0, 0, "q4"),
        (60, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ]
    answer = [first, key[1], (0, "d6", "q3", 0), *key[3:]]
    policy = Policy(tool=ToolRule.POINT)
    verdict = grade(read("standard", key, "deg"), read("standard", answer, "deg"), policy)
    assert {row for _, row in _named(verdict)} == {1, 3}
