"""Verdicts: right answers explained, wrong ones placed, as far as the help level goes."""

import math
from dataclasses import replace
from itertools import permutations

import pytest

from exercises.grading import (
    BaseRule,
    Basis,
    ConventionRule,
    DirectionRule,
    Finding,
    HelpLevel,
    LinkFinding,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
    grade,
)
from kinematics.cells import LengthUnit
from kinematics.errors import CellError, ParameterError, TableError
from tests.exercises.grading.told import codes
from tests.exercises.grading.written import Cell, read

Rows = list[tuple[Cell, Cell, Cell, Cell]]

PUMA: Rows = [
    ("pi/2", 0, 0, "q1"),
    (0, "a2", 0, "q2"),
    ("-pi/2", "a3", "d3", "q3"),
    ("pi/2", 0, "d4", "q4"),
    ("-pi/2", 0, 0, "q5"),
    (0, 0, 0, "q6"),
]
PUMA_CRAIG: Rows = [
    (0, 0, 0, "q1"),
    ("pi/2", 0, 0, "q2"),
    (0, "a2", "d3", "q3"),
    ("-pi/2", "a3", "d4", "q4"),
    ("pi/2", 0, 0, "q5"),
    ("-pi/2", 0, 0, "q6"),
]
SCARA: Rows = [(0, 0, 0, "q1"), (0, "a2", 0, "q2"), (0, "a3", "q3", 0), (0, 0, 0, "q4")]
VALUES = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.35}
KEY = read("standard", PUMA)
USUAL = Policy()


OTHER_VALUES = {"a2": 0.5, "a3": 0.03, "d3": 0.2, "d4": 0.4}


@pytest.mark.parametrize(
    ("rows", "shared"),
    [
        (PUMA_CRAIG, True),
        ([("pi/2", 0, 0.3, "q1"), *PUMA[1:]], True),  # the first frame may lie anywhere along its axis
        ([*PUMA[:3], ("pi/2", 0, "a2", "q4"), *PUMA[4:]], True),
        ([*PUMA[:3], ("pi/2", 0, "d4 + a2", "q4"), *PUMA[4:]], True),
        ([*PUMA[:3], ("pi/2", 0, 0.35, "q4"), *PUMA[4:]], False),  # a value for its name
        ([*PUMA[:3], ("pi/2", 0, "sqrt(d4^2 - a2^2)", "q4"), *PUMA[4:]], False),  # no value at some draws
    ],
)
def test_who_hands_in_the_same_names_is_judged_once_whatever_their_values(rows: Rows, shared: bool) -> None:
    answer = read("standard" if rows[0][0] else "modified", rows)
    one, other = (grade(KEY, answer, USUAL, values) for values in (VALUES, OTHER_VALUES))
    assert (one is other) == shared
    if shared:
        assert one == grade.__globals__["_grade"].__wrapped__(
            KEY, answer, USUAL, tuple(VALUES.items()), HelpLevel.REPAIR, grade.__globals__["USUAL"]
        )


def test_values_are_looked_at_whether_they_make_a_difference_or_not() -> None:
    for wrong in ({**VALUES, "b": 1.0}, {**VALUES, "a2": math.nan}):
        with pytest.raises(ParameterError):
            grade(KEY, read("standard", PUMA), USUAL, wrong)


def with_cells(rows: Rows, *changes: tuple[int, int, Cell]) -> Rows:
    """The rows with cells (row from 1, column, value) replaced."""
    changed = [list(row) for row in rows]
    for row, column, value in changes:
        changed[row - 1][column] = value
    return [tuple(row) for row in changed]  # type: ignore[misc]


def numbers(rows: Rows, decimals: int = 9) -> Rows:
    """The rows with values for names and decimals for angles."""
    known: dict[Cell, Cell] = {
        **VALUES,
        "pi/2": round(math.pi / 2, decimals),
        "-pi/2": round(-math.pi / 2, decimals),
    }
    return [tuple(known.get(cell, cell) for cell in row) for row in rows]  # type: ignore[misc]


# right answers


def test_the_key_itself() -> None:
    verdict = grade(KEY, KEY, USUAL, VALUES)
    assert verdict.correct
    assert verdict.score == 1.0
    assert verdict.basis is Basis.PROVED
    assert codes(verdict) == ["same_frames"]
    assert verdict.repairs == ()
    assert verdict.certificate is not None
    assert verdict.certificate.joint_signs == (1,) * 6
    assert verdict.certificate.exact is not None
    assert verdict.certificate.exact.joint_offsets == ("0",) * 6
    assert all(link.length is link.twist is link.offset is link.joint is Finding.OK for link in verdict.links)


def test_the_other_convention() -> None:
    verdict = grade(KEY, read("modified", PUMA_CRAIG), USUAL)
    assert verdict.correct
    assert verdict.basis is Basis.PROVED
    assert codes(verdict) == ["other_convention"]


def test_an_axis_reversed_and_an_x_axis_turned() -> None:
    # z_1 the other way: α_1 and α_2 change sign, θ_2 as well
    rows = with_cells(PUMA, (1, 0, "-pi/2"), (2, 0, "pi"), (2, 3, "-q2"))
    verdict = grade(KEY, read("standard", rows), USUAL)
    assert verdict.correct
    assert ("axis_reversed", 1, {"frame": 1, "joint": 2}) in [
        (entry.code, entry.row, dict(entry.params)) for entry in verdict.feedback
    ]


def test_x_turned_by_half_a_turn() -> None:
    rows = with_cells(PUMA, (2, 1, "-a2"), (2, 3, "q2 + pi"), (3, 3, "q3 - pi"))
    verdict = grade(KEY, read("standard", rows), USUAL)
    assert [(e.code, e.row, dict(e.params)) for e in verdict.feedback] == [
        ("x_turned", 2, {"frame": 2, "degrees": 180})
    ]


def test_an_origin_slid_along_a_parallel_axis() -> None:
    verdict = grade(KEY, read("standard", with_cells(PUMA, (2, 2, "d3"), (3, 2, 0))), USUAL)
    assert codes(verdict) == ["origin_slid"]


def test_a_slider_drawn_on_another_line() -> None:
    rows: Rows = [(0, 0, 0, "q1"), (0, "a2", 0, "q2"), (0, 0, "q3", 0), (0, "a3", 0, "q4")]
    verdict = grade(read("modified", SCARA), read("modified", rows), USUAL)
    assert verdict.correct
    assert "axis_moved" in codes(verdict)


def test_a_variable_with_another_zero_in_the_other_convention() -> None:
    rows = with_cells(PUMA_CRAIG, (2, 3, "q2 - 30"), (2, 0, 90), (4, 0, -90), (5, 0, 90), (6, 0, -90))
    verdict = grade(KEY, read("modified", rows, "deg"), USUAL)
    told = {e.code: dict(e.params) for e in verdict.feedback}
    assert told["variable_offset"] == {"joint": 2, "offset": "30°"}
    assert verdict.certificate is not None
    assert verdict.certificate.joint_offsets == pytest.approx((0, 30, 0, 0, 0, 0))
    assert verdict.angle_unit == "deg"


def test_a_variable_counted_the_other_way_in_the_other_convention() -> None:
    rows = with_cells(PUMA_CRAIG, (3, 3, "-q3"))
    verdict = grade(KEY, read("modified", rows), USUAL)
    assert ("variable_reversed", 3) in [(e.code, e.row) for e in verdict.feedback]


def test_an_axis_reversed_in_the_other_convention() -> None:
    """The variable counts as in the key: -q3 about the reversed axis."""
    rows = with_cells(PUMA_CRAIG, (3, 0, "pi"), (3, 2, "-d3"), (3, 3, "-q3"), (4, 0, "pi/2"))
    verdict = grade(KEY, read("modified", rows), USUAL)
    assert verdict.correct
    assert [(e.code, e.row) for e in verdict.feedback] == [("other_convention", None), ("axis_reversed", 3)]


def test_the_last_frame_elsewhere_in_the_other_convention() -> None:
    rows = with_cells(PUMA_CRAIG, (6, 2, "d4"))
    verdict = grade(KEY, read("modified", rows), USUAL)
    assert [(e.code, e.row) for e in verdict.feedback] == [("other_convention", None), ("origin_slid", 6)]


def test_numbers_for_names() -> None:
    typed = read("standard", numbers(PUMA, 2))
    verdict = grade(KEY, typed, USUAL, VALUES)
    assert verdict.correct
    assert verdict.basis is Basis.VERIFIED
    assert codes(verdict) == ["same_frames", "rounded"]
    known: dict[Cell, Cell] = {**VALUES}
    exact = [tuple(known.get(cell, cell) for cell in row) for row in PUMA]
    assert grade(KEY, read("standard", exact), USUAL, VALUES).basis is Basis.PROVED


def test_numbers_here_and_names_there() -> None:
    mixed = with_cells(PUMA, (2, 1, 0.4318), (4, 2, 0.35))
    assert grade(KEY, read("standard", mixed), USUAL, VALUES).correct
    assert not grade(KEY, read("standard", with_cells(PUMA, (2, 1, 0.45))), USUAL, VALUES).correct
    # a2 as a number in one cell, and by name where it does not belong
    assert not grade(
        KEY, read("standard", with_cells(PUMA, (2, 1, 0.4318), (3, 1, "a2"))), USUAL, VALUES
    ).correct


def test_a_name_used_for_another_of_equal_value_is_wrong() -> None:
    equal = {**VALUES, "d4": 0.4318}
    swapped = with_cells(PUMA, (2, 1, "d4"), (4, 2, "a2"))
    assert not grade(KEY, read("standard", swapped), USUAL, equal).correct
    assert not grade(KEY, read("standard", swapped), USUAL).correct


@pytest.mark.parametrize("angle_unit", ["rad", "deg"])
@pytest.mark.parametrize("length_unit", list(LengthUnit))
def test_answers_in_other_units(angle_unit: str, length_unit: LengthUnit) -> None:
    scale = float(1 / length_unit.metres_per_unit)
    turn = math.degrees if angle_unit == "deg" else float
    rows: Rows = [
        tuple(turn(c) if k == 0 else c * scale if isinstance(c, float) else c for k, c in enumerate(row))  # type: ignore[misc]
        for row in numbers(PUMA, 15)
    ]
    answer = read("standard", rows, angle_unit, length_unit.value)
    verdict = grade(KEY, answer, USUAL, VALUES)
    assert verdict.correct
    assert (verdict.angle_unit, verdict.length_unit) == (angle_unit, length_unit.value)
    raised = read("standard", with_cells(rows, (1, 2, 0.5 * scale)), angle_unit, length_unit.value)
    certificate = grade(KEY, raised, USUAL, VALUES).certificate
    assert certificate is not None
    assert certificate.base[2][3] == pytest.approx(0.5 * scale)


def test_values_are_told_in_the_units_of_the_answer() -> None:
    key = read("standard", [("pi/2", 0, 0, "q1"), ("beta", "L1", 0, "q2")])
    in_degrees = read("standard", [(90, 0, 0, "q1"), ("beta", "L1", 0, "q2")], "deg")
    one, other = (grade(key, answer, USUAL).certificate for answer in (key, in_degrees))
    assert one is not None
    assert other is not None
    assert other.parameters == pytest.approx(
        {"L1": one.parameters["L1"], "beta": math.degrees(one.parameters["beta"])}
    )


def test_a_key_in_millimetres_and_degrees() -> None:
    key = read("standard", [(90, 0, 0, "q1"), (0, "L1", 0, "q2"), ("beta", 200, 0, "q3")], "deg", "mm")
    answer = read("standard", [("pi/2", 0, 0, "q1"), (0, 0.3, 0, "q2"), ("pi/6", 0.2, 0, "q3")])
    policy = Policy(tool=ToolRule.FRAME)
    assert grade(key, answer, policy, {"L1": 300, "beta": 30}).correct
    assert not grade(key, answer, policy, {"L1": 310, "beta": 30}).correct
    assert not grade(key, answer, policy, {"L1": 300, "beta": 0.5}).correct


# wrong answers

MISTAKES: dict[str, tuple[Rows, str, int | None]] = {
    "alpha_sign": (with_cells(PUMA, (3, 0, "pi/2")), "alpha_sign", 3),
    "alpha_value": (with_cells(PUMA, (4, 0, 0)), "alpha_value", 4),
    "a_missing": (with_cells(PUMA, (2, 1, 0)), "a_missing", 2),
    "a_not_zero": (with_cells(PUMA, (4, 1, "a3")), "a_not_zero", 4),
    "d_not_zero": (with_cells(PUMA, (5, 2, "d3")), "d_not_zero", 5),
    "d_missing": (with_cells(PUMA, (4, 2, 0)), "d_missing", 4),
    "cell_parameter": (with_cells(PUMA, (2, 1, "d4")), "cell_parameter", 2),
    "parameter_misnamed": (with_cells(PUMA, (2, 1, "L2")), "parameter_misnamed", None),
    "parameters_swapped": (with_cells(PUMA, (2, 1, "d4"), (4, 2, "a2")), "parameters_swapped", None),
    "a_d_swapped": (with_cells(PUMA, (3, 1, "d3"), (3, 2, "a3")), "a_d_swapped", 3),
    "joint_type": (with_cells(PUMA, (4, 2, "q4"), (4, 3, 0)), "joint_type", 4),
    "row_extra": (
        [*PUMA[:2], (0, "a3", 0, "q3"), *[(*r[:3], f"q{k}") for k, r in enumerate(PUMA[2:], 4)]],
        "row_extra",
        3,
    ),
    "rows_swapped": ([PUMA[0], (*PUMA[2][:3], "q2"), (*PUMA[1][:3], "q3"), *PUMA[3:]], "rows_swapped", 2),
    "twists_swapped": (with_cells(PUMA, (2, 0, "-pi/2"), (3, 0, 0)), "twists_swapped", 2),
    "angles_in_degrees": (
        [(90 if r[0] == "pi/2" else -90 if r[0] == "-pi/2" else 0, *r[1:]) for r in PUMA],
        "angles_in_degrees",
        None,
    ),
    "cell_in_degrees": (with_cells(PUMA, (3, 0, -90)), "cell_in_degrees", 3),
    "twists_all_reversed": (
        [("-pi/2" if r[0] == "pi/2" else "pi/2" if r[0] == "-pi/2" else 0, *r[1:]) for r in PUMA],
        "twists_all_reversed",
        None,
    ),
}  # type: ignore[assignment]


@pytest.mark.parametrize(("rows", "code", "row"), MISTAKES.values(), ids=MISTAKES.keys())
def test_a_mistake_is_named_and_placed(rows: Rows, code: str, row: int | None) -> None:
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
    assert not verdict.correct
    assert verdict.basis is Basis.REFUTED
    assert verdict.certificate is None
    assert 0.5 < verdict.score < 1.0
    single = [repair.edits[0] for repair in verdict.repairs if len(repair.edits) == 1]
    assert (code, row) in [(edit.code, edit.row) for edit in single]
    for edit in single:
        assert not {str(v) for v in edit.params.values()} & {"0.4318", "0.0203", "0.15005", "0.35"}


def test_of_two_exchanged_cells_both_are_wrong() -> None:
    """One slip, two cells: that only one of them was wrong was told, too."""
    verdict = grade(KEY, read("standard", MISTAKES["a_d_swapped"][0]), USUAL, VALUES)
    assert codes(verdict) == ["not_equivalent", "length_wrong", "offset_wrong"]


@pytest.mark.parametrize("degrees", [-90, 180])
def test_degrees_in_a_table_in_radians_are_told_before_another_angle(degrees: int) -> None:
    key = read("standard", with_cells(PUMA, (3, 0, "-pi/2" if degrees < 0 else "pi")))
    verdict = grade(key, read("standard", with_cells(PUMA, (3, 0, degrees))), USUAL, VALUES)
    assert verdict.repairs[0].edits[0].code == "cell_in_degrees"


def test_a_missing_row() -> None:
    short = [PUMA[0], *[(*row[:3], f"q{k}") for k, row in enumerate(PUMA[2:], 2)]]
    verdict = grade(KEY, read("standard", short), USUAL, VALUES)
    (missing,) = [
        r.edits[0] for r in verdict.repairs if (r.edits[0].code, r.edits[0].row) == ("row_missing", 2)
    ]
    assert (missing.params["place"], missing.params["after"]) == (2, 1)
    assert "joint_count_wrong" in codes(verdict)
    assert verdict.links[-1].row == 2
    assert verdict.links[-1].joint is Finding.MISSING


def test_the_other_convention_declared() -> None:
    verdict = grade(KEY, read("modified", PUMA), USUAL, VALUES)
    assert not verdict.correct
    assert "convention" in [r.edits[0].code for r in verdict.repairs]
    assert "columns_throughout" in codes(verdict)


def test_columns_a_row_late_where_the_convention_is_prescribed() -> None:
    late = [(b[0], b[1], r[2], r[3]) for r, b in zip(PUMA, [(0, 0), *PUMA], strict=False)]
    verdict = grade(KEY, read("standard", late), replace(USUAL, convention=ConventionRule.STANDARD), VALUES)
    assert [r.edits[0].code for r in verdict.repairs][:1] == ["columns_late"]


def test_millimetres_where_metres_are_declared() -> None:
    rows = [
        tuple(c * 1000 if isinstance(c, float) and k in (1, 2) else c for k, c in enumerate(r))
        for r in numbers(PUMA)
    ]
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)  # type: ignore[arg-type]
    assert [r.edits[0].code for r in verdict.repairs][:1] == ["length_unit"]
    one = with_cells(numbers(PUMA), (4, 2, 350.0))
    verdict = grade(KEY, read("standard", one), USUAL, VALUES)
    assert [(r.edits[0].code, r.edits[0].row) for r in verdict.repairs][:1] == [("cell_length_unit", 4)]


def test_two_mistakes() -> None:
    rows = with_cells(PUMA, (2, 1, "a3"), (5, 0, 0))
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
    places = [tuple((e.code, e.row) for e in r.edits) for r in verdict.repairs]
    assert (("cell_parameter", 2), ("alpha_value", 5)) in places
    assert verdict.score < grade(KEY, read("standard", with_cells(PUMA, (5, 0, 0))), USUAL, VALUES).score


@pytest.mark.parametrize("missing", range(4))
def test_a_forgotten_row_leaves_what_the_others_say(missing: int) -> None:
    """A SCARA has two facts to earn, its lengths; of three right rows in four half is left."""
    key = read("modified", SCARA)
    kept = [row for i, row in enumerate(SCARA) if i != missing]
    rows: Rows = [
        (0, a, f"q{i}", 0) if d else (0, a, 0, f"q{i}") for i, (_, a, d, _) in enumerate(kept, start=1)
    ]
    verdict = grade(key, read("modified", rows), USUAL, {"a2": 0.4, "a3": 0.3})
    assert verdict.repairs[0].edits[0].code == "row_missing"
    assert verdict.score == 0.5
    zeros: Rows = [(0, 0, d, theta) for _, _, d, theta in rows]
    assert grade(key, read("modified", zeros), USUAL, {"a2": 0.4, "a3": 0.3}).score == 0.0


def test_two_exchanged_names_are_one_slip_in_a_small_arm_too() -> None:
    """A SCARA's only facts are its two lengths; both are there, and one thing is wrong with them."""
    key, values = read("modified", SCARA), {"a2": 0.4, "a3": 0.3}
    swapped = with_cells(SCARA, (2, 1, "a3"), (3, 1, "a2"))
    verdict = grade(key, read("modified", swapped), USUAL, values)
    assert ([edit.code for edit in verdict.repairs[0].edits], verdict.score) == (["parameters_swapped"], 0.5)
    other = with_cells(SCARA, (2, 1, "2*a3"), (3, 1, "2*a2"))
    assert grade(key, read("modified", other), USUAL, values).score == 0.0


def test_three_mistakes_still_earn_something() -> None:
    rows = with_cells(PUMA, (1, 0, 0), (2, 1, 0), (4, 2, 0), (5, 0, 0))
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
    assert verdict.repairs == ()
    assert 0.2 < verdict.score < 0.9
    assert {"twist_wrong", "length_wrong"} & set(codes(verdict))


def test_rounded_entries_are_not_taken_for_other_frames() -> None:
    values = {**VALUES, "d4": 0.4318}
    rows = with_cells(PUMA, (2, 1, 0.43), (3, 1, 0.02), (3, 2, 0.15), (4, 2, 0.43))
    verdict = grade(KEY, read("standard", rows), USUAL, values)
    assert codes(verdict) == ["same_frames", "rounded"]
    assert verdict.certificate is not None
    assert verdict.certificate.joint_offsets[0] == 0.0


def test_a_table_of_zeros_earns_nothing() -> None:
    zeros: Rows = [(0, 0, 0, f"q{i}") for i in range(1, 7)]
    verdict = grade(KEY, read("standard", zeros), USUAL)
    assert (verdict.repairs, verdict.score) == ((), 0.0)


def test_a_mirror_image_is_said_to_be_one() -> None:
    assert "mirrored" in codes(
        grade(KEY, read("standard", MISTAKES["twists_all_reversed"][0]), USUAL, VALUES)
    )


def test_of_several_signs_none_is_accused_alone() -> None:
    verdict = grade(KEY, read("standard", with_cells(PUMA, (3, 2, "-d3"))), USUAL, VALUES)
    told = {entry.row: entry.params["cells"] for entry in verdict.feedback if entry.code == "sign_wrong"}
    assert told[3] == "α, a, d"
    assert set(told) == {edit.row for repair in verdict.repairs for edit in repair.edits if edit.row}
    assert verdict.links[2] == LinkFinding(
        row=3, length=Finding.WRONG, twist=Finding.WRONG, offset=Finding.WRONG, joint=Finding.OK
    )


def test_the_length_that_was_typed_is_accused_before_a_zero() -> None:
    """Along parallel axes an offset may stand in any row; it is wrong where it was typed."""
    key = read("standard", with_cells(PUMA, (3, 2, "d3")))
    for level in (HelpLevel.ROW, HelpLevel.REPAIR):
        answer = read("standard", with_cells(PUMA, (3, 2, "d4")))
        verdict = grade(key, answer, USUAL, VALUES, level)
        accused = {entry.row for entry in verdict.feedback if entry.row}
        assert accused == {3}


def test_a_wrong_sign_accuses_every_row_that_may_hold_it() -> None:
    verdict = grade(KEY, read("standard", with_cells(PUMA, (4, 2, "-d4"))), USUAL, VALUES, HelpLevel.ROW)
    accused = {entry.row for entry in verdict.feedback if entry.code == "row_wrong"}
    assert 4 in accused


@pytest.mark.parametrize("unit", ["rad", "deg"])
@pytest.mark.parametrize("in_names", [True, False])
def test_columns_in_any_other_order(unit: str, in_names: bool) -> None:
    """Names as well as numbers: a2 under α is a length that stands where an angle should."""
    right = {"rad": "pi/2", "deg": 90}[unit]
    turn = {"rad": "-pi/2", "deg": -90}[unit]
    a2, a3, d3, d4 = ("a2", "a3", "d3", "d4") if in_names else (0.4318, 0.0203, 0.15005, 0.35)
    rows = [
        (right, 0, 0, "q1"),
        (0, a2, 0, "q2"),
        (turn, a3, d3, "q3"),
        (right, 0, d4, "q4"),
        (turn, 0, 0, "q5"),
        (0, 0, 0, "q6"),
    ]
    for order in permutations(range(3)):
        moved: Rows = [(*(row[k] for k in order), row[3]) for row in rows]
        verdict = grade(KEY, read("standard", moved, unit), USUAL, VALUES)
        if order == (0, 1, 2):
            assert verdict.correct
            continue
        assert "columns_in_disorder" in codes(verdict)
        (edit,) = verdict.repairs[0].edits
        names = ("alpha", "a", "d")
        if edit.code == "columns_reordered":
            assert dict(edit.params) == {names[i]: "αad"[k] for i, k in enumerate(order)}
        else:
            (kept,) = [i for i, k in enumerate(order) if i == k]
            assert {edit.params["one"], edit.params["other"]} == {*"αad"} - {"αad"[kept]}


def test_columns_of_which_two_are_empty_are_exchanged_not_reordered() -> None:
    """Two links with their lengths under d: that α and a changed places as well cannot be seen."""
    key = read("standard", [(0, 1.0, 0, "q1"), (0, 0.5, 0, "q2")])
    answer = read("standard", [(0, 0, 1.0, "q1"), (0, 0, 0.5, "q2")])
    verdict = grade(key, answer, Policy(tool=ToolRule.POINT))
    told = {edit.code for repair in verdict.repairs for edit in repair.edits}
    assert "columns_exchanged" in told
    assert "columns_reordered" not in told


def test_two_columns_exchanged_throughout() -> None:
    lengths: Rows = [(row[0], row[2], row[1], row[3]) for row in PUMA]
    verdict = grade(KEY, read("standard", lengths), USUAL, VALUES)
    assert [(edit.code, edit.params["one"], edit.params["other"]) for edit in verdict.repairs[0].edits] == [
        ("columns_exchanged", "a", "d")
    ]
    assert "columns_in_disorder" in codes(verdict)
    degrees: Rows = [
        (90, 0, 0, "q1"),
        (0, 0.4, 0, "q2"),
        (-90, 0.02, 0.15, "q3"),
        (90, 0, 0.4, "q4"),
        (0, 0, 0, "q5"),
    ]
    exchanged: Rows = [(row[1], row[0], *row[2:]) for row in degrees]
    verdict = grade(read("standard", degrees, "deg"), read("standard", exchanged, "deg"), USUAL)
    assert verdict.repairs[0].edits[0].params["other"] == "α"
    assert verdict.score > 0.0


def test_a_last_row_that_the_marked_point_needs() -> None:
    rows: Rows = [(0, 0, 0, "q1"), (0, 0.4, 0, "q2"), (0, 0.3, 0, 0)]
    verdict = grade(read("modified", rows), read("modified", rows[:2]), Policy(tool=ToolRule.POINT))
    assert [edit.code for edit in verdict.repairs[0].edits] == ["fixed_row_missing"]
    assert verdict.links[-1].row == 3
    assert verdict.links[-1].length is Finding.MISSING


def test_the_right_robot_with_the_wrong_tool() -> None:
    verdict = grade(
        KEY, read("standard", with_cells(PUMA, (6, 2, "d3"))), Policy(tool=ToolRule.POINT), VALUES
    )
    assert codes(verdict)[:2] == ["right_robot", "tool_point_missed"]
    assert [(r.edits[0].code, r.edits[0].row) for r in verdict.repairs][:1] == [("d_not_zero", 6)]


def test_the_right_robot_with_other_zeros_and_directions() -> None:
    strict = Policy(zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)
    verdict = grade(KEY, read("standard", with_cells(PUMA, (2, 3, "q2 + pi/2"))), strict, VALUES)
    assert codes(verdict)[:2] == ["right_robot", "zero_missed"]
    assert ("theta_offset", 2) in [(r.edits[0].code, r.edits[0].row) for r in verdict.repairs]
    verdict = grade(KEY, read("standard", with_cells(PUMA, (2, 3, "-q2"))), strict, VALUES)
    assert codes(verdict)[:2] == ["right_robot", "direction_missed"]
    assert ("variable_sign", 2) in [(r.edits[0].code, r.edits[0].row) for r in verdict.repairs]
    verdict = grade(KEY, read("standard", with_cells(PUMA, (2, 3, "q2 + pi/5"))), strict, VALUES)
    assert [(r.edits[0].code, r.edits[0].row) for r in verdict.repairs] == [("theta_offset", 2)]
    verdict = grade(KEY, read("standard", with_cells(PUMA, (1, 3, "-q1"), (4, 3, "-q4"))), strict, VALUES)
    told = [[(edit.code, edit.row) for edit in repair.edits] for repair in verdict.repairs]
    assert [("variable_sign", 1), ("variable_sign", 4)] in told


def test_the_wrong_convention() -> None:
    verdict = grade(KEY, read("modified", PUMA_CRAIG), Policy(convention=ConventionRule.STANDARD), VALUES)
    assert codes(verdict)[:2] == ["right_robot", "convention_not_asked"]
    assert verdict.feedback[1].params == {"asked": "standard", "given": "modified"}
    assert 0.5 < verdict.score < 1.0


def test_names_that_the_robot_does_not_have() -> None:
    verdict = grade(KEY, read("standard", with_cells(PUMA, (2, 1, "L2"))), USUAL, VALUES)
    assert verdict.feedback[0].code == "parameter_unknown"
    assert verdict.feedback[0].params == {"name": "L2", "known": "a2, a3, d3, d4"}


def test_numbers_where_the_robot_has_only_names() -> None:
    verdict = grade(KEY, read("standard", numbers(PUMA)), USUAL)
    assert not verdict.correct
    assert codes(verdict)[0] == "names_asked"


def test_a_key_in_numbers_and_an_answer_in_names() -> None:
    key = read("standard", numbers(PUMA))
    assert not grade(key, KEY, USUAL).correct
    assert codes(grade(key, KEY, USUAL))[0] == "parameter_unknown"
    assert grade(key, KEY, USUAL, VALUES).correct


# help levels


def test_help_levels_tell_more_and_more() -> None:
    answer = read("standard", with_cells(PUMA, (3, 0, 0)))
    by_level = {level: grade(KEY, answer, USUAL, VALUES, level) for level in HelpLevel}
    assert len({verdict.score for verdict in by_level.values()}) == 1
    assert codes(by_level[HelpLevel.VERDICT]) == ["not_equivalent"]
    assert by_level[HelpLevel.VERDICT].links == ()
    row = by_level[HelpLevel.ROW]
    assert [(e.code, e.row) for e in row.feedback] == [("not_equivalent", None), ("row_wrong", 3)]
    assert row.links[2].twist is row.links[2].length is Finding.HIDDEN
    assert row.links[1].twist is Finding.OK
    kind = by_level[HelpLevel.KIND]
    assert [(e.code, e.row) for e in kind.feedback] == [("not_equivalent", None), ("twist_wrong", 3)]
    assert kind.links[2].twist is Finding.WRONG
    assert kind.links[2].length is Finding.OK
    assert kind.repairs == ()
    assert by_level[HelpLevel.REPAIR].repairs != ()


def test_a_broken_rule_is_not_named_where_only_the_verdict_is_told() -> None:
    answer = read("standard", with_cells(PUMA, (6, 2, "d3")))
    verdict = grade(KEY, answer, Policy(tool=ToolRule.POINT), VALUES, HelpLevel.VERDICT)
    assert codes(verdict) == ["not_accepted"]


@pytest.mark.parametrize("level", list(HelpLevel))
def test_no_level_gives_the_key_away(level: HelpLevel) -> None:
    for rows, _, _ in MISTAKES.values():
        verdict = grade(KEY, read("standard", rows), USUAL, VALUES, level)
        said = [*verdict.feedback, *(edit for repair in verdict.repairs for edit in repair.edits)]
        for entry in said:
            if entry.code in {"parameter_unknown", "parameters_swapped", "parameter_misnamed"}:
                continue  # the names stand in the figure
            assert not {str(value) for value in entry.params.values()} & set(VALUES)


# what cannot be graded


def test_malformed_tables_never_reach_the_grader() -> None:
    with pytest.raises(TableError):
        read("standard", [])
    with pytest.raises(CellError):
        read("standard", [("pi/2", "2*", 0, "q1")])


@pytest.mark.parametrize(
    ("parameters", "code"),
    [
        ({"a2": math.nan}, "parameter_not_finite"),
        ({"a2": True}, "parameter_not_finite"),
        ({"zz": 1.0}, "parameter_unused"),
        ({"a2": 1.0, "a_2": 2.0}, "parameter_given_twice"),
        ({"a 2!": 1.0}, "parameter_name_invalid"),
    ],
)
def test_values_that_are_none(parameters: dict[str, float], code: str) -> None:
    with pytest.raises(ParameterError) as caught:
        grade(KEY, KEY, USUAL, parameters)
    assert code in [fault.code for fault in caught.value.faults]


@pytest.mark.parametrize(("length", "shown"), [(39, 39), (40, 40), (41, 40)])
def test_a_name_that_means_nothing_is_shown_as_far_as_forty_characters(length: int, shown: int) -> None:
    with pytest.raises(ParameterError) as caught:
        grade(KEY, KEY, USUAL, {"z" * length: 1.0})
    assert caught.value.faults[0].params["name"] == "z" * shown


def test_tables_without_any_value() -> None:
    impossible = read("standard", [("asin(2 + L1^2/L1^2)", "L1", 0, "q1")])
    with pytest.raises(ParameterError) as caught:
        grade(impossible, impossible, USUAL)
    assert caught.value.code in {"tables_without_value", "value_undefined", "parameter_missing"}


def test_roots_that_exist_only_near_the_given_values() -> None:
    key = read("standard", [(0, "sqrt(L1^2 - L2^2)", 0, "q1"), (0, "L2", 0, "q2")])
    assert grade(key, key, USUAL, {"L1": 1.0, "L2": 0.95}).correct
    assert not grade(
        key, read("standard", [(0, "L1", 0, "q1"), (0, "L2", 0, "q2")]), USUAL, {"L1": 1.0, "L2": 0.95}
    ).correct


# degenerate keys


def test_a_robot_without_lengths() -> None:
    wrist = read("standard", [("pi/2", 0, 0, "q1"), ("-pi/2", 0, 0, "q2"), (0, 0, 0, "q3")])
    euler = read("modified", [(0, 0, 0, "q1"), ("-pi/2", 0, 0, "q2"), ("pi/2", 0, 0, "q3")])
    assert grade(wrist, euler, USUAL).basis is Basis.PROVED
    verdict = grade(
        wrist, read("standard", [("pi/2", 0.2, 0, "q1"), ("-pi/2", 0, 0, "q2"), (0, 0, 0, "q3")]), USUAL
    )
    assert not verdict.correct
    assert ("a_not_zero", 1) in [(r.edits[0].code, r.edits[0].row) for r in verdict.repairs]


def test_what_a_program_leaves_of_zero_is_no_length_of_a_robot_without_lengths() -> None:
    wrist = read("standard", [("pi/2", 0, 0, "q1"), ("-pi/2", 0, 0, "q2"), (0, 0, 0, "q3")])
    left = read("standard", [("pi/2", 1e-17, 0, "q1"), ("-pi/2", 6e-17, -1.3e-33, "q2"), (0, 0, 0, "q3")])
    for tool in ToolRule:
        policy = replace(USUAL, tool=tool)
        assert grade(wrist, left, policy).correct
        assert grade(left, wrist, policy).correct


def test_dimensions_that_happen_to_be_zero_or_equal() -> None:
    """Structure is that of the symbols, not of the values that a student is given."""
    key = read("standard", [("pi/2", "L1", 0, "q1"), ("pi/2", "L2", "L3", "q2"), (0, 0, 0, "q3")])
    values = {"L1": 0.3, "L2": 0.3, "L3": 0.0}
    assert grade(key, key, USUAL, values).correct
    assert not grade(
        key,
        read("standard", [("pi/2", "L2", 0, "q1"), ("pi/2", "L1", "L3", "q2"), (0, 0, 0, "q3")]),
        USUAL,
        values,
    ).correct
    assert grade(
        key,
        read("standard", [("pi/2", 0.3, 0, "q1"), ("pi/2", 0.3, 0, "q2"), (0, 0, 0, "q3")]),
        USUAL,
        values,
    ).correct


def test_one_joint_and_one_fixed_row() -> None:
    key = read("standard", [(0, 0, 0.2, "q1")])
    assert grade(key, read("modified", [(0, 0, 0, "q1")]), USUAL).correct
    assert not grade(key, read("standard", [(0, 0, "q1", 0)]), USUAL).correct
    assert not grade(key, read("standard", [(0, 0.1, 0.2, 0)]), USUAL).correct


def test_a_tight_tolerance_holds_typed_angles_to_their_decimals() -> None:
    tight = replace(USUAL, tolerance=Tolerance(length=1e-6, angle=1e-6))
    assert not grade(KEY, read("standard", numbers(PUMA, 2)), tight, VALUES).correct
    assert grade(KEY, read("standard", numbers(PUMA, 9)), tight, VALUES).correct


def test_equal_requests_get_the_same_verdict() -> None:
    answer = read("standard", with_cells(PUMA, (3, 0, 0)))
    assert grade(KEY, answer, USUAL, VALUES) is grade(KEY, answer, USUAL, dict(reversed(VALUES.items())))


def test_entries_that_are_right_one_by_one_but_too_imprecise() -> None:
    """No length and no angle is accused where all that is wrong is 1.57 under a strict tolerance."""
    strict = Policy(tolerance=Tolerance(length=0.001, angle=0.001))
    typed = with_cells(PUMA, (1, 0, 1.57), (3, 0, -1.57), (4, 0, 1.57), (5, 0, -1.57))
    assert grade(KEY, read("standard", typed), USUAL).correct
    verdict = grade(KEY, read("standard", typed), strict)
    assert not verdict.correct
    assert verdict.repairs == ()
    assert codes(verdict) == ["not_accepted", "entries_imprecise"]
    assert {finding for link in verdict.links for finding in (link.length, link.twist)} == {Finding.OK}
    assert verdict.score >= 0.8
    told = grade(KEY, read("standard", typed), strict, help_level=HelpLevel.VERDICT)
    assert codes(told) == ["not_accepted"]


def test_in_frames_of_ones_own_an_offset_is_wrong_in_any_row_of_parallel_axes() -> None:
    """D₂ + d₃ is what counts: each of the two rows is named, and neither alone."""
    split = with_cells(PUMA, (2, 2, 0.4), (3, 2, "d3 - 0.4"))
    assert grade(KEY, read("standard", split), USUAL, VALUES).correct
    for row, cell in ((2, 0.9), (3, "d3 + 0.7")):
        answer = read("standard", with_cells(split, (row, 2, cell)))
        verdict = grade(KEY, answer, USUAL, VALUES, HelpLevel.ROW)
        assert codes(verdict) == ["not_equivalent", "one_of_these", "row_wrong", "row_wrong"]
        assert {entry.row for entry in verdict.feedback if entry.row} == {2, 3}


def test_a_convention_is_declared_wrong_sooner_than_rows_are_exchanged() -> None:
    """A SCARA's table in the modified convention, declared as a standard one."""
    key = read("modified", [(0, 0, "L0", "q1"), (0, "L1", 0, "q2"), ("pi", "L2", "q3", 0), (0, 0, 0, "q4")])
    values = {"L0": 0.5, "L1": 0.4, "L2": 0.3}
    answer = read(
        "standard", [(0, 0, "L0", "q1"), (0, "L1", 0, "q2"), ("pi", "L2", "q3", 0), (0, 0, 0, "q4")]
    )
    verdict = grade(key, answer, USUAL, values)
    assert [edit.code for edit in verdict.repairs[0].edits] == ["convention"]
    assert "rows_out_of_order" not in codes(verdict)


@pytest.mark.parametrize("name", ["x", "a2"])
def test_one_wrong_name_among_numbers_accuses_no_number(name: str) -> None:
    """Whether the exercise knows the name or not, the numbers stand for what they are the values of."""
    answer = read("standard", with_cells(numbers(PUMA, 4), (4, 2, name)))
    verdict = grade(KEY, answer, USUAL, VALUES)
    assert [(e.code, e.row) for e in verdict.feedback if e.row] == [("offset_wrong", 4)]
    assert [edit.row for repair in verdict.repairs for edit in repair.edits] == [4]


def test_a_sign_that_is_free_is_not_accused() -> None:
    """Z₃ may point either way if d₄ follows: turned round, with d₄ wrong besides, d₄ alone is wrong."""
    turned = with_cells(PUMA, (3, 0, "pi/2"), (4, 0, "-pi/2"), (4, 2, "-d4"))
    assert grade(KEY, read("standard", turned), USUAL, VALUES).correct
    wrong = with_cells(turned, (4, 2, "-a2"))
    verdict = grade(KEY, read("standard", wrong), USUAL, VALUES)
    assert [(e.code, e.row) for e in verdict.feedback if e.row] == [("offset_wrong", 4)]


def test_a_last_row_that_the_frame_of_the_tool_needs() -> None:
    """The sign of d4 before it would lead to that frame too; the rows written are the key's own."""
    rows: Rows = [
        (180, 0, -0.85, "q1"),
        (90, 0.4, 0, "q2"),
        (0, 1.0, 0, "q3 - 90"),
        (90, 0, -1.0, "q4"),
        (-90, 0, 0, "q5"),
        (90, 0, -0.2, "q6"),
        (180, 0, 0, 180),
    ]
    policy = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
    key, answer = read("modified", rows, "deg"), read("modified", rows[:-1], "deg")
    verdict = grade(key, answer, policy)
    assert [edit.code for edit in verdict.repairs[0].edits] == ["fixed_row_missing"]
    told = grade(key, answer, policy, help_level=HelpLevel.ROW)
    assert [entry.row for entry in told.feedback if entry.row] == [7]


@pytest.mark.parametrize(
    ("column", "cell", "code"), [(2, 0.25, "offset_wrong"), (3, "pi/6", "angle_wrong")], ids=["d", "theta"]
)
def test_of_a_fixed_row_the_cell_that_is_wrong_is_told(column: int, cell: Cell, code: str) -> None:
    """No variable stands there: d and θ both are facts of the robot."""
    rows: Rows = [("pi/2", 0.4, 0, "q1"), ("pi/2", 0.3, 0.2, "pi/4"), (0, 0.1, 0, "q2")]
    answer = read("standard", with_cells(rows, (2, column, cell)))
    verdict = grade(read("standard", rows), answer, USUAL)
    assert [(entry.code, entry.row) for entry in verdict.feedback if entry.row] == [(code, 2)]
    assert [link.row for link in verdict.links if link.offset is Finding.WRONG] == [2]
