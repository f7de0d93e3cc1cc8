"""Whole verdicts on wrong answers: all that is told of each, in order, and every edit that would mend it."""

import pytest

from exercises.grading import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    HelpLevel,
    Policy,
    ToolRule,
    Verdict,
    ZeroRule,
    accept,
    grade,
    is_accepted,
)
from kinematics.cells import ReadTable
from tests.exercises.grading.test_grade import KEY, PUMA, PUMA_CRAIG, USUAL, VALUES, with_cells
from tests.exercises.grading.told import repairs
from tests.exercises.grading.written import Cell, read

Rows = list[tuple[Cell, Cell, Cell, Cell]]
Told = list[tuple[str, int | None]]

PLANAR: Rows = [(0, 0.31, 0, "q1"), (0, 0.4318, 0, "q2"), (0, 0.0203, 0, "q3")]
LIFT: Rows = [("pi/2", "a1", 0, "q1"), ("-pi/2", 0, "q2 + L2", 0), (0, "a3", 0, "q3 + pi/4")]
LIFT_VALUES = {"a1": 0.4, "L2": 0.3, "a3": 0.2}
FIXED = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)


def feedback(verdict: Verdict) -> Told:
    return [(entry.code, entry.row) for entry in verdict.feedback]


ANSWERS: dict[str, tuple[ReadTable, ReadTable, Policy, Told, list[Told], float]] = {
    "a sign, where everything is fixed": (
        read("standard", PLANAR),
        read("standard", with_cells(PLANAR, (2, 1, -0.4318))),
        FIXED,
        [("right_robot", None), ("zero_missed", None), ("length_wrong", 2)],
        [[("a_sign", 2)]],
        0.9,
    ),
    "one twist the wrong way: a mirrored arm": (
        read("modified", PUMA_CRAIG),
        read("modified", with_cells(PUMA_CRAIG, (4, 0, "pi/2"))),
        USUAL,
        [
            ("not_equivalent", None),
            ("mirrored", None),
            ("one_of_these", None),
            ("sign_wrong", 3),
            ("sign_wrong", 4),
        ],
        [
            [("alpha_sign", 4)],
            [("a_sign", 4)],
            [("d_sign", 3)],
            [("d_sign", 4)],
            [("twists_all_reversed", None)],
        ],
        0.94,
    ),
    "one angle in degrees": (
        read("modified", PUMA_CRAIG),
        read("modified", with_cells(PUMA_CRAIG, (4, 0, -90))),
        USUAL,
        [("not_equivalent", None), ("twist_wrong", 4)],
        [[("cell_in_degrees", 4)], [("alpha_value", 4)], [("angles_in_degrees", None)]],
        0.89,
    ),
    "all lengths in millimetres": (
        read("standard", PLANAR),
        read("standard", [(alpha, 1000 * a, d, theta) for alpha, a, d, theta in PLANAR]),  # type: ignore[operator]
        Policy(convention=ConventionRule.STANDARD),
        [("not_equivalent", None), ("lengths_throughout", None)],
        [[("length_unit", None)]],
        0.5,
    ),
    "the other convention, and a length": (
        read("standard", PLANAR),
        read("modified", with_cells(PLANAR, (2, 1, 0.9))),
        USUAL,
        [("not_equivalent", None), ("columns_throughout", None), ("length_wrong", 2)],
        [
            [("convention", None), ("a_value", 2)],
            [("a_value", 2), ("a_value", 3)],
            [("rows_swapped", 1), ("a_value", 3)],
        ],
        0.0,
    ),
}


@pytest.mark.parametrize(
    ("key", "answer", "policy", "told", "edits", "score"), ANSWERS.values(), ids=ANSWERS.keys()
)
def test_all_that_is_told(
    key: ReadTable, answer: ReadTable, policy: Policy, told: Told, edits: list[Told], score: float
) -> None:
    verdict = grade(key, answer, policy, VALUES if key.parameters else None)
    assert feedback(verdict) == told
    assert repairs(verdict) == edits
    assert verdict.score == score


@pytest.mark.parametrize("level", HelpLevel)
@pytest.mark.parametrize(("key", "answer", "policy"), [answer[:3] for answer in ANSWERS.values()])
def test_the_row_of_a_sentence_is_the_row_that_is_marked(
    key: ReadTable, answer: ReadTable, policy: Policy, level: HelpLevel
) -> None:
    verdict = grade(key, answer, policy, VALUES if key.parameters else None, level)
    edits = [edit for repair in verdict.repairs for edit in repair.edits]
    for entry in (*verdict.feedback, *edits):
        assert entry.params.get("row") == entry.row


@pytest.mark.parametrize("place", range(7))
def test_a_row_of_zeros_changes_nothing_but_the_numbers_of_the_rows_behind_it(place: int) -> None:
    rows = with_cells(PUMA_CRAIG, (4, 0, -90))
    without = grade(KEY, read("modified", rows), USUAL, VALUES)
    found = grade(KEY, read("modified", [*rows[:place], (0, 0, 0, 0), *rows[place:]]), USUAL, VALUES)
    assert found.score == without.score

    def moved(told: Told) -> Told:
        return [(code, row and row + (row > place)) for code, row in told]

    assert feedback(found) == moved(feedback(without))
    assert repairs(found) == [moved(repair) for repair in repairs(without)]


def test_no_more_than_six_explanations() -> None:
    """A row too many and two rows exchanged have more; who reads them all is helped by none."""
    rows: Rows = [(0, 0.0203, 0, "q1"), (0, 0.31, 0, "q2"), (0, 0, 0, "q3"), (0, 0.4318, 0, "q4")]
    assert len(repairs(grade(read("standard", PLANAR), read("standard", rows), USUAL))) == 6


@pytest.mark.parametrize("ratio", [1000, 0.001, 100, 0.01, 10, 0.1])
def test_lengths_in_any_unit_are_told(ratio: float) -> None:
    rows = [(alpha, ratio * a, d, theta) for alpha, a, d, theta in PLANAR]  # type: ignore[operator]
    assert repairs(grade(read("standard", PLANAR), read("standard", rows), USUAL))[0] == [
        ("length_unit", None)
    ]


def test_a_short_length_is_no_length_in_another_unit() -> None:
    told = repairs(grade(KEY, read("standard", with_cells(PUMA, (4, 2, 0.001))), USUAL, VALUES))
    assert told[0] == [("d_value", 4)]


def test_a_single_twist_is_not_all_of_them() -> None:
    key = read("standard", with_cells(LIFT, (1, 0, 0)))
    answer = read("standard", with_cells(LIFT, (1, 0, 0), (2, 0, "pi/2")))
    assert repairs(grade(key, answer, FIXED, LIFT_VALUES)) == [[("alpha_sign", 2)]]


@pytest.mark.parametrize(
    ("unit", "zeros", "told"),
    [
        ("rad", ("q2 + L2 - 0.1", "q3 - pi/4"), [(2, "0.1"), (3, "pi/2")]),
        ("deg", ("q2 + L2 - 0.1", "q3 - 45"), [(2, "0.1"), (3, "90°")]),
    ],
)
def test_another_zero_is_told_in_the_unit_of_its_variable(
    unit: str, zeros: tuple[str, str], told: list[tuple[int, str]]
) -> None:
    """In the other convention, so that it is told of the variables, not of the frames."""
    slide, turn = zeros
    right = 90 if unit == "deg" else "pi/2"
    rows: Rows = [(0, 0, 0, "q1"), (right, "a1", slide, 0), (f"-{right}", 0, 0, turn), (0, "a3", 0, 0)]
    verdict = grade(read("standard", LIFT), read("modified", rows, unit), USUAL, LIFT_VALUES)
    assert verdict.correct
    assert [
        (entry.row, entry.params["joint"], entry.params["offset"])
        for entry in verdict.feedback
        if entry.code == "variable_offset"
    ] == [(row, row, text) for row, text in told]


def test_the_key_has_itself_for_a_certificate() -> None:
    """No zero of it has a sign."""
    certificate = grade(KEY, KEY, USUAL).certificate
    assert certificate is not None
    same = tuple(tuple(float(i == k) for k in range(4)) for i in range(4))
    assert repr((certificate.base, certificate.tool)) == repr((same, same))


def test_who_accepts_asks_no_more_than_whether_it_is_right() -> None:
    right, wrong = read("modified", PUMA_CRAIG), read("standard", with_cells(PUMA, (4, 2, 0)))
    assert accept(KEY, right, USUAL) == accept(KEY, right, USUAL, {}) == grade(KEY, right, USUAL)
    assert accept(KEY, wrong, USUAL, VALUES) is None
    assert is_accepted(KEY, right, USUAL)
    assert not is_accepted(KEY, wrong, USUAL, VALUES)


@pytest.mark.parametrize("change", [(2, 1, "a2 + 1"), (4, 2, "d4 + 1"), (5, 0, 0)])
def test_every_kind_of_fact_is_worth_the_same(change: tuple[int, int, Cell]) -> None:
    """Where a policy says nothing of their weights: a twist counts as a length and as an offset."""
    one = grade(KEY, read("standard", with_cells(PUMA, (2, 1, "a2 + 1"))), USUAL, VALUES)
    verdict = grade(KEY, read("standard", with_cells(PUMA, change)), USUAL, VALUES)
    assert verdict.score == one.score


def test_without_names_of_its_own_a_key_knows_none() -> None:
    answer = read("standard", with_cells(PLANAR, (2, 1, "L2")))
    told = grade(read("standard", PLANAR), answer, USUAL).feedback[0]
    assert (told.code, told.params) == ("parameter_unknown", {"name": "L2", "known": "–"})


@pytest.mark.parametrize(("millimetres", "told"), [(0.5, []), (5.0, [2])])
def test_another_zero_of_a_slider_is_told_where_it_is_more_than_a_thousandth_of_the_robot(
    millimetres: float, told: list[int]
) -> None:
    key: Rows = [("pi/2", 0.4, 0, "q1"), ("-pi/2", 0, "q2", 0), (0, 0.2, 0, "q3")]
    slide = f"q2 - {millimetres}"
    rows: Rows = [(0, 0, 0, "q1"), ("pi/2", 400, slide, 0), ("-pi/2", 0, 0, "q3"), (0, 200, 0, 0)]
    verdict = grade(read("standard", key), read("modified", rows, length_unit="mm"), USUAL)
    assert verdict.correct
    assert [entry.row for entry in verdict.feedback if entry.code == "variable_offset"] == told


@pytest.mark.parametrize("turned", [[("pi/3", 0, 0, 0)], [(0, 0, 0, "pi/2"), ("pi/3", 0, 0, "-pi/2")]])
def test_a_last_frame_that_leans_is_elsewhere(turned: Rows) -> None:
    """Over its x axis, or over its y axis."""
    verdict = grade(KEY, read("modified", [*PUMA_CRAIG, *turned]), Policy(tool=ToolRule.FREE))
    last = len(PUMA_CRAIG) + len(turned)
    assert feedback(verdict) == [("other_convention", None), ("frame_elsewhere", last)]


METRES: Rows = [
    (90, 0, 0, "q1"),
    (0, 0.4318, 0, "q2"),
    (-90, 0.0203, 0.15005, "q3"),
    (90, 0, 0.4318, "q4"),
    (-90, 0, 0, "q5"),
    (0, 0, 0, "q6"),
]
"""A PUMA in degrees and metres."""
MILLIMETRES: Rows = [(alpha, 1000 * float(a), 1000 * float(d), theta) for alpha, a, d, theta in METRES]


@pytest.mark.parametrize(
    ("rows", "unit", "first", "others"),
    [
        (with_cells(with_cells(METRES, (2, 1, 0.5)), (4, 2, 0.2)), "rad", "angles", {2, 4}),
        (with_cells(with_cells(METRES, (3, 0, 45)), (4, 2, 0.2)), "rad", "angles", {3, 4}),
        (with_cells(with_cells(MILLIMETRES, (2, 0, 45)), (4, 2, 200)), "deg", "lengths", {2, 4}),
        (
            with_cells(with_cells(with_cells(METRES, (2, 1, 0.5)), (3, 2, 0.3)), (4, 2, 0.2)),
            "rad",
            "angles",
            {2, 3, 4},
        ),
    ],
    ids=["degrees", "degrees and a twist", "millimetres", "degrees and three lengths"],
)
def test_a_unit_throughout_is_told_first_whatever_is_wrong_beside_it(
    rows: Rows, unit: str, first: str, others: set[int]
) -> None:
    """Nine facts were called wrong, and the unit was not."""
    key, answer = read("standard", METRES, "deg"), read("standard", rows, unit)
    told = feedback(grade(key, answer, USUAL, help_level=HelpLevel.KIND))
    assert told[0] == ("not_equivalent", None)
    assert (f"{first}_throughout", None) in told
    assert {row for _, row in told if row is not None} == others
    by_row = feedback(grade(key, answer, USUAL, help_level=HelpLevel.ROW))
    assert ("whole_table", None) in by_row
    assert {code for code, _ in by_row} <= {"not_equivalent", "whole_table", "row_wrong"}
    for repair in repairs(grade(key, answer, USUAL)):
        assert repair[0][1] is None
        assert {row for _, row in repair[1:]} == others


@pytest.mark.parametrize("wrong_length", [0.117, 0.134, 0.41])
@pytest.mark.parametrize(("unit", "by"), [("m", 1000), ("mm", 0.001), ("m", 100), ("m", 10)])
def test_one_length_shows_a_unit_throughout_if_no_length_is_wrong_by_so_much(
    wrong_length: float, unit: str, by: float
) -> None:
    """Metres for millimetres; that another unit makes one length right may be by chance."""
    is_told, one = by in (1000, 0.001), 1000 if unit == "mm" else 1
    right: Rows = [
        (90, 0.3 * one, 0, "q1"),
        (0, 0.5 * one, 0.12 * one, "q2"),
        (90, 0.2 * one, 0.3 * one, "q3"),
        (-90, 0, 0.25 * one, "q4"),
        (60, 0.15 * one, 0, "q5"),
    ]
    wrong: Rows = [
        (60, wrong_length * one * by, 0, "q1"),
        (0, 0.5 * one * by, 0, "q2"),
        (70, 0.11 * one * by, 0.17 * one * by, "q3"),
        (-90, 0, 0.33 * one * by, "q4"),
        (60, 0, 0, "q5"),
    ]
    key, answer = (read("standard", rows, "deg", unit) for rows in (right, wrong))
    told = feedback(grade(key, answer, Policy(tool=ToolRule.FREE)))
    assert (("lengths_throughout", None) in told) is is_told
    assert (("length_wrong", 2) in told) is not is_told


def test_lengths_that_another_unit_makes_the_key_s_tell_nothing_where_facts_do() -> None:
    """Three of them are lengths of the key, but one of them alone stands where the key has it."""
    right: Rows = [(90, 0.3, 0, "q1"), (0, 0.5, 0.12, "q2"), (90, 0.2, 0.3, "q3"), (60, 0.15, 0.25, "q4")]
    wrong: Rows = [(60, 30, 0, "q1"), (0, 20, 2, "q2"), (70, 50, 17, "q3"), (60, 0, 33, "q4")]
    key, answer = read("standard", right, "deg"), read("standard", wrong, "deg")
    told = feedback(grade(key, answer, Policy(tool=ToolRule.FREE)))
    assert ("lengths_throughout", None) not in told
