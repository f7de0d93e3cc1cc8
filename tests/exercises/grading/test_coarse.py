"""Too few digits are no wrong length, unless they are not those of the right one."""

from typing import Any

import pytest

from exercises.grading import BaseRule, DirectionRule, HelpLevel, Policy, ToolRule, ZeroRule, grade
from kinematics.cells import ReadTable
from tests.exercises.grading.told import codes
from tests.exercises.grading.written import Cell, read

Lengths = tuple[Cell, Cell, Cell, Cell]
VALUES = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
NAMES: Lengths = ("a2", "a3", "d3", "d4")
FREE = Policy(tool=ToolRule.FREE)
STRICT = Policy(
    base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
)


def _puma(lengths: Lengths, twist: Cell = -90, third: Cell = "q3") -> ReadTable:
    a2, a3, d3, d4 = lengths
    rows: list[tuple[Cell, Cell, Cell, Cell]] = [
        (90, 0, 0, "q1"),
        (0, a2, 0, "q2"),
        (twist, a3, d3, third),
        (90, 0, d4, "q4"),
        (-90, 0, 0, "q5"),
        (0, 0, 0, "q6"),
    ]
    return read("standard", rows, "deg")


def _craig(lengths: Lengths) -> ReadTable:
    a2, a3, d3, d4 = lengths
    rows: list[tuple[Cell, Cell, Cell, Cell]] = [
        (0, 0, 0, "q1"),
        (-90, 0, 0, "q2"),
        (0, a2, d3, "q3"),
        (-90, a3, d4, "q4"),
        (90, 0, 0, "q5"),
        (-90, 0, 0, "q6"),
    ]
    return read("modified", rows, "deg")


@pytest.mark.parametrize(
    "lengths",
    [
        (0.4, 0.0203, 0.15005, 0.4318),
        (0.4318, 0.0203, 0.2, 0.4318),
        (0.4, 0.02, 0.2, 0.4),
        ("a2", "a3", "d3", 0.4),
    ],
)
@pytest.mark.parametrize("policy", [FREE, STRICT])
def test_a_length_of_too_few_digits_is_said_to_be_that(lengths: Lengths, policy: Policy) -> None:
    verdict = grade(_puma(NAMES), _puma(lengths), policy, VALUES)
    assert not verdict.correct
    assert codes(verdict) == ["not_accepted", "entries_imprecise"]
    assert verdict.repairs == ()


@pytest.mark.parametrize("make", [_puma, _craig])
@pytest.mark.parametrize("policy", [FREE, STRICT])
def test_too_few_digits_cost_less_than_a_wrong_length(make: Any, policy: Policy) -> None:
    """Under strict rules 0.4 for 0.4318 had fewer marks than 0.3."""
    key = make(NAMES)
    wrong = grade(key, make((0.3, 0.0203, 0.15005, 0.4318)), policy, VALUES).score
    scores = [
        grade(key, make(lengths), policy, VALUES).score
        for lengths in ((0.4, 0.0203, 0.15005, 0.4318), (0.4, 0.02, 0.2, 0.4))
    ]
    assert scores[0] == scores[1] > wrong


def test_in_other_frames_too() -> None:
    verdict = grade(_puma(NAMES), _craig((0.4, 0.02, 0.2, 0.4)), FREE, VALUES)
    assert codes(verdict) == ["not_accepted", "entries_imprecise"]


@pytest.mark.parametrize(
    ("answer", "policy"),
    [
        (_puma((0.5, 0.02, 0.15, 0.43)), FREE),
        (_puma((0.4, 0, 0.2, 0.4)), FREE),
        (_puma((1, 0, 0, 0)), FREE),
        (_puma((0.4, 0.02, -0.2, 0.4)), FREE),
        (_puma((0.4, 0.02, 0.2, 0.4), twist=90), FREE),
        (_puma((0.4, 0.02, 0.2, 0.4), third="q3 + 90"), STRICT),
        (_puma((0.4, 0.02, 0.2, 0.4), third="-q3"), STRICT),
        (_puma(("a2", "a3", "d3", 0.5)), FREE),
        (_puma(("a2", "a3", "d3", 1)), FREE),
    ],
)
def test_what_the_digits_do_not_explain_is_wrong(answer: ReadTable, policy: Policy) -> None:
    assert "entries_imprecise" not in codes(grade(_puma(NAMES), answer, policy, VALUES))


@pytest.mark.parametrize(("typed", "length"), [(1, 0.8), (1, 1.4), (0.1, 0.08)])
def test_a_lone_one_is_no_rounded_length(typed: Cell, length: Cell) -> None:
    """Half of it would be room for everything: its row is told, and what may stand there."""
    key, answer = (read("standard", [(0, a, 0, "q1"), (0, 0.537, 0, "q2")]) for a in (length, typed))
    verdict = grade(key, answer, FREE)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("a_value", 1)]
    assert "entries_imprecise" not in codes(verdict)


@pytest.mark.parametrize("also_wrong", [0.15005, 0.4])
def test_half_a_unit_that_is_half_the_number_excuses_nothing(also_wrong: float) -> None:
    """0.1 for 0.07 cost less than 0.11, and less beside another wrong length than that alone."""
    key, values = _puma(NAMES), {**VALUES, "a3": 0.07}

    def score(a3: float, d3: float) -> float:
        return grade(key, _puma((0.4318, a3, d3, 0.4318)), FREE, values).score

    assert score(0.1, also_wrong) == score(0.11, also_wrong) < score(0.07, also_wrong)


@pytest.mark.parametrize("help_level", [HelpLevel.ROW, HelpLevel.KIND, HelpLevel.REPAIR])
@pytest.mark.parametrize(("a3", "twist", "rows"), [(0, -90, {3}), (0.3, -90, {3}), (0.02, 60, {3, 4})])
def test_too_few_digits_are_told_first_and_only_the_rest_is_accused(
    a3: float, twist: float, rows: set[int], help_level: HelpLevel
) -> None:
    """All four lengths were called wrong where one of them, or a twist, was wrong besides."""
    verdict = grade(_puma(NAMES), _puma((0.4, a3, 0.2, 0.4), twist), FREE, VALUES, help_level=help_level)
    assert codes(verdict)[:2] == ["not_equivalent", "lengths_rounded"]
    told = {entry.row for entry in verdict.feedback if entry.row is not None}
    assert 3 in told <= rows
    assert verdict.repairs == ()


def test_too_few_digits_cost_beside_a_wrong_length_what_a_wrong_sign_does() -> None:
    exact, rounded = (
        grade(_puma(NAMES), _puma(lengths), FREE, VALUES).score
        for lengths in ((0.4318, 0, 0.15005, 0.4318), (0.4, 0, 0.2, 0.4))
    )
    assert exact - rounded == pytest.approx(0.5 / 9, abs=0.01)
    assert "lengths_rounded" not in codes(
        grade(_puma(NAMES), _puma((0.4, 0, 0.2, 0.4)), FREE, VALUES, help_level=HelpLevel.VERDICT)
    )


def test_what_is_off_by_half_a_unit_is_rounded_up_or_down() -> None:
    """0.4 for 0.45, 0.2 for 0.15 and 0.3 for 0.35; the length that was left out is told alone."""
    values = {"a2": 0.45, "a3": 0.0203, "d3": 0.15, "d4": 0.35}
    verdict = grade(_puma(NAMES), _puma((0.4, 0, 0.2, 0.3)), FREE, values)
    assert codes(verdict) == ["not_equivalent", "lengths_rounded", "length_wrong"]


ENDS = [
    Policy(tool=ToolRule.POINT),
    Policy(base=BaseRule.ORIGIN, tool=ToolRule.POINT),
    Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME),
    Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE),
]


def _long_puma(*lengths: Cell) -> ReadTable:
    """PUMA on its pedestal, with a tool."""
    d1, a2, a3, d3, d4, d6 = lengths
    rows: list[tuple[Cell, Cell, Cell, Cell]] = [
        (90, 0, d1, "q1"),
        (0, a2, 0, "q2"),
        (-90, a3, d3, "q3"),
        (90, 0, d4, "q4"),
        (-90, 0, 0, "q5"),
        (0, 0, d6, "q6"),
    ]
    return read("standard", rows, "deg")


LONG = _long_puma(0.672, 0.4318, 0.0203, 0.15005, 0.4318, 0.193)
TOO_FEW_DIGITS = codes(grade(_puma(NAMES), _puma((0.4, 0.02, 0.2, 0.4)), FREE, VALUES))


@pytest.mark.parametrize("policy", ENDS)
@pytest.mark.parametrize(
    "lengths",
    [
        (0.672, 0.4318, 0.0203, 0.15005, 0.4318, 0.2),
        (0.67, 0.43, 0.02, 0.15, 0.43, 0.2),
        (0.7, 0.43, 0.02, 0.15, 0.43, 0.2),
    ],
)
def test_a_rule_that_only_the_digits_break_accuses_no_cell(lengths: Any, policy: Policy) -> None:
    """0.2 for a tool of 0.193 was told as a wrong offset, and cost more than 0.4 for 0.4318 beside it."""
    verdict = grade(LONG, _long_puma(*lengths), policy)
    assert codes(verdict) == TOO_FEW_DIGITS
    assert verdict.repairs == ()
    assert verdict.score == grade(LONG, _long_puma(0.7, 0.4, 0.02, 0.2, 0.4, 0.2), policy).score


@pytest.mark.parametrize("policy", ENDS)
@pytest.mark.parametrize("tool", [0, 0.19001, 0.21, 0.22, 0.25, 0.3, 1, -0.193])
def test_a_rule_that_the_digits_do_not_explain_is_broken(tool: Cell, policy: Policy) -> None:
    verdict = grade(LONG, _long_puma(0.67, 0.43, 0.02, 0.15, 0.43, tool), policy)
    assert verdict.correct or "entries_imprecise" not in codes(verdict)


def test_in_other_frames_a_repair_shows_that_the_digits_are_too_few() -> None:
    """Along parallel axes an offset may stand in either row: no entry is one of the key's."""
    key = read("standard", [(0, 0.4, 0.123, "q1"), (0, 0.35, 0, "q2"), (0, 0, 0.2, "q3")])
    policy = Policy(base=BaseRule.FRAME, tool=ToolRule.POINT)
    answer = read("standard", [(0, 0.4, 0, "q1"), (0, 0.35, 0, "q2"), (0, 0, 0.3, "q3")])
    assert codes(grade(key, answer, policy)) == TOO_FEW_DIGITS


def test_a_length_of_the_key_is_not_rounded() -> None:
    """Moved within its one decimal, the second length would make up for the first, which is wrong."""
    key = read("standard", [(90, 0, 0.56, "q1"), (-90, 0.4273, 0, "q2"), (-90, -0.5, "q3", 30)], "deg")
    answer = read("standard", [(90, 0, 0.56, "q1"), (-90, 0.7, 0, "q2"), (-90, -0.5, "q3", 30)], "deg")
    assert "length_wrong" in codes(grade(key, answer, Policy(tool=ToolRule.AXIS)))


@pytest.mark.parametrize("policy", [Policy(), FREE, Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)])
def test_angles_with_too_few_digits_explain_where_they_take_what_is_behind_them(policy: Policy) -> None:
    """The lengths are exact: they were compared as if no angle turned them, and both twists called wrong."""
    key = read("standard", [(0.943, 0.496, 0.387, "q1"), (1.332, 0.708, 0.584, "q2")])
    answer = read("standard", [(0.9, 0.496, 0.387, "q1"), (1.3, 0.708, 0.584, "q2")])
    assert codes(grade(key, answer, policy)) == TOO_FEW_DIGITS


@pytest.mark.parametrize("degrees", [29, 45, 83, 150])
@pytest.mark.parametrize("policy", [Policy(), Policy(tool=ToolRule.POINT)])
def test_degrees_typed_for_radians_are_no_radians_with_too_few_digits(degrees: int, policy: Policy) -> None:
    """45 rad is 1.02 rad and seven turns: within half a radian of it there is a quarter of π."""
    rows: list[tuple[Cell, Cell, Cell, Cell]] = [(degrees, "L2", "L1", "q1"), (0, 0, "L3", "q2")]
    verdict = grade(read("standard", rows, "deg"), read("standard", rows, "rad"), policy)
    assert ("twist_wrong", 1) in [(entry.code, entry.row) for entry in verdict.feedback]
    assert "cell_in_degrees" in [repair.edits[0].code for repair in verdict.repairs]
