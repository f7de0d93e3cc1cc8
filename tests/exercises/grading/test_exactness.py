"""Names are exact, and numbers are as exact as they were typed."""

import math
from dataclasses import replace
from fractions import Fraction

import pytest

from exercises.grading import BaseRule, Policy, ToolRule, accept, grade
from exercises.grading.judging.certificate_report import in_unit
from exercises.grading.judging.comparison import comparisons
from exercises.grading.judging.digits import SECOND_ORDER, digits_and_angles, measured_as_typed
from exercises.grading.judging.typed import COARSEST_ANGLE, half_steps, meant
from exercises.instance import generate
from exercises.written_table import written_table
from kinematics.catalogue import robots
from kinematics.cells import AngleUnit, ReadTable, read_table
from kinematics.equivalence.invariants import invariants_of
from kinematics.equivalence.reference import prepared
from kinematics.expressions import ZERO, Number, Parameter, add, pi_times
from kinematics.table import DHRow, JointType
from tests.exercises.grading.test_grade import KEY, PUMA, USUAL, VALUES, Rows, codes, numbers, with_cells
from tests.exercises.grading.written import Cell, read
from tests.exercises.packaged import exercise
from tests.kinematics.equivalence import tables
from tests.kinematics.equivalence.tables import scaled

SEEDS = range(20)
WRONG_NAMES: list[tuple[int, int, Cell]] = [
    (2, 1, "1.01*a2"),
    (2, 1, "a2 + 0.004"),
    (2, 1, "a2*1.0001"),
    (2, 1, "d4"),
    (3, 1, "-a3"),
    (3, 2, "d3 + a3 - a3*1.001"),
    (4, 2, "(a2 + d4)/2"),
]


@pytest.mark.parametrize("change", WRONG_NAMES, ids=[str(change[2]) for change in WRONG_NAMES])
@pytest.mark.parametrize("angles", ["exact", "rounded"])
def test_a_wrong_name_is_wrong_whatever_was_drawn(change: tuple[int, int, Cell], angles: str) -> None:
    """The rounding of a right angle is no reason to let a length pass, and no drawn value is."""
    twist: dict[Cell, Cell] = {"pi/2": 1.57, "-pi/2": -1.57} if angles == "rounded" else {}
    right: Rows = [(twist.get(row[0], row[0]), *row[1:]) for row in PUMA]
    wrong = read("standard", with_cells(right, change))
    verdicts = []
    for seed in SEEDS:
        # d4 = a2, and a3 = a2 / 2, are drawn as well
        values = {**VALUES, "a2": 0.4 + 0.01 * seed, "d4": 0.4 if seed % 2 else 0.5, "a3": 0.2}
        assert grade(KEY, read("standard", right), USUAL, values).correct
        verdicts.append(grade(KEY, wrong, USUAL, values))
    assert not any(verdict.correct for verdict in verdicts)
    assert len({(verdict.score, tuple(codes(verdict))) for verdict in verdicts}) == 1


@pytest.mark.parametrize("cell", ["L2 + 0.008", "1.01*L2", "L2 - 0.01*L1"])
def test_a_wrong_name_is_wrong_beside_a_frame_that_is_moved_to_and_fro(cell: str) -> None:
    """Decimals that cancel stand for no name and no length of the key: they are no reason either."""
    key = read("standard", [(0, "L1", 0, "q1"), (0, "L2", 0, "q2")])
    values = {"L1": 0.5, "L2": 0.4}
    for last, right in (("L2", True), (cell, False)):
        rows: Rows = [(0, 0, 0.15, "q1"), (0, "L1", -0.15, 0), (0, last, 0, "q2")]
        assert grade(key, read("standard", rows), Policy(), values).correct is right
    rows = [(0, 0, 0.15, "q1"), (0, "L1", -0.14, 0), (0, "L2", 0, "q2")]
    moved = grade(key, read("standard", rows), Policy(tool=ToolRule.FRAME, base=BaseRule.FRAME), values)
    assert not moved.correct


@pytest.mark.parametrize("first", [0.5, 2.642])
def test_lengths_that_cancel_leave_a_rounded_twist_what_it_is(first: Cell) -> None:
    """Beside them it was held to all digits of the key's: what is mirrored was told as two wrong twists."""
    key = read("standard", [(0.5, "L1", 0, "q1"), (0.9, "L2", 0, "q2"), (0, "L1", 0, "q3")])
    verdicts = []
    for there in (0, 0.15):
        rows: Rows = [
            (0, 0, there, "q1"),
            (first, "L1", -there, 0),
            (2.242, "L2", 0, "q2"),
            (0, "L1", 0, "q3"),
        ]
        verdicts.append(grade(key, read("standard", rows), USUAL, {"L1": 0.4, "L2": 0.3}))
    assert verdicts[0].score == verdicts[1].score
    assert codes(verdicts[0]) == codes(verdicts[1])


def test_two_names_exchanged_throughout_are_wrong_for_every_student() -> None:
    ssrms = exercise("ssrms")
    raw = written_table(ssrms.reference)
    exchanged = str.maketrans({"3": "4", "4": "3"})
    rows = tuple(
        replace(row, d=row.d.translate(exchanged) if "d" in str(row.d) else row.d) for row in raw.rows
    )
    assert rows != raw.rows
    answer = read_table(replace(raw, rows=rows))
    verdicts = [
        grade(ssrms.reference, answer, ssrms.policy, generate(ssrms, seed).parameters) for seed in SEEDS
    ]
    assert {verdict.correct for verdict in verdicts} == {False}
    assert len({verdict.score for verdict in verdicts}) == 1


def test_a_difference_of_names_is_not_the_name_that_has_its_value() -> None:
    key = read("standard", [("pi/2", "L1", 0, "q1"), ("pi/2", "L2", "L2", "q2"), (0, 0, 0, "q3")])
    values = {"L1": 0.4, "L2": 0.2}
    for cell in ("L1 - L2", "L1/2", 0.2):
        rows: Rows = [("pi/2", "L1", 0, "q1"), ("pi/2", cell, "L2", "q2"), (0, 0, 0, "q3")]
        assert grade(key, read("standard", rows), USUAL, values).correct is (cell == 0.2)


def test_a_name_and_its_value_may_both_stand_in_an_answer() -> None:
    key = read("standard", [("pi/2", "L1", 0, "q1"), ("pi/2", "L1", "L2", "q2"), (0, 0, 0, "q3")])
    for first, second in (("L1", 0.4), (0.4, "L1"), (0.4, 0.4)):
        rows: Rows = [("pi/2", first, 0, "q1"), ("pi/2", second, "L2", "q2"), (0, 0, 0, "q3")]
        assert grade(key, read("standard", rows), USUAL, {"L1": 0.4, "L2": 0.2}).correct
        assert not grade(key, read("standard", rows), USUAL, {"L1": 0.46, "L2": 0.2}).correct


def test_a_name_left_out_is_wrong_although_its_value_is_zero() -> None:
    key = read("standard", [("pi/2", "L1", 0, "q1"), ("pi/2", "L2", "L3", "q2"), (0, 0, 0, "q3")])
    without: Rows = [("pi/2", "L1", 0, "q1"), ("pi/2", "L2", 0, "q2"), (0, 0, 0, "q3")]
    assert not grade(key, read("standard", without), USUAL, {"L1": 0.3, "L2": 0.2, "L3": 0.0}).correct


@pytest.mark.parametrize(
    ("row", "column", "value", "right"),
    [
        (3, 1, 0.0203, True),
        (3, 1, 0.02, True),  # rounded to its two decimals
        (3, 1, 0.0202, True),  # within one per cent
        (3, 1, 0.0148, False),  # 5.5 mm of 20: less than the tolerance of the whole arm
        (3, 1, 0.021, False),
        (3, 1, 0, False),
        (3, 2, 0.15, True),
        (3, 2, 0.1514, True),
        (3, 2, 0.154, False),
        (2, 1, 0.43, True),
        (2, 1, 0.44, False),
    ],
)
def test_a_small_length_of_a_large_arm_is_held_to_its_digits(
    row: int, column: int, value: float, *, right: bool
) -> None:
    verdict = grade(KEY, read("standard", with_cells(numbers(PUMA, 4), (row, column, value))), USUAL, VALUES)
    assert verdict.correct is right
    assert ("rounded" in codes(verdict)) is right


def test_a_zero_is_as_exact_as_the_entries_beside_it() -> None:
    """0.0004 rounds to 0 beside entries of three decimals; beside one of five it does not."""
    key = read("standard", [("pi/2", 0.4, 0.0004, "q1"), ("pi/2", 0.3, 0.0004, "q2"), (0, 0, 0.2, "q3")])
    three: Rows = [("pi/2", 0.4, 0, "q1"), ("pi/2", 0.3, 0, "q2"), (0, 0, 0.2, "q3")]
    assert grade(key, read("standard", with_cells(three, (1, 1, "0.401"))), USUAL).correct
    assert not grade(key, read("standard", with_cells(three, (1, 1, "0.40001"))), USUAL).correct


def test_half_a_unit_of_the_last_place() -> None:
    table = read(
        "standard", [(1.57, 0.25, "1/3", "q1 + 0.3"), ("pi/2", "2*L", "4.5", "q2"), (0.5, 0, "q3", 0.25)]
    ).table
    found = half_steps(table, AngleUnit.RAD)
    assert {place: pytest.approx(step) for place, step in found.items()} == {
        (0, "alpha"): 0.005,
        (0, "a"): 0.005,
        (1, "d"): 0.05,
        (2, "alpha"): 0.05,
        (2, "theta"): 0.005,
        (2, "a"): 0.005,
    }
    degrees = read("standard", [(44.5, 0, 0, "q1"), (90, 0, 0, "q2"), ("45/7", 0, 0, "q3")], "deg").table
    assert half_steps(degrees, AngleUnit.DEG) == {(0, "alpha"): pytest.approx(math.radians(0.05))}


def test_what_a_rounded_angle_stands_for() -> None:
    key = pi_times(Fraction(35, 180))
    table = read(
        "standard", [(1.57, 0, 0, "q1"), (0.61, 0, 0, "q2"), (0.7, 0, 0, "q3"), (2, 0, 0, "q4")]
    ).table
    found = meant(table, AngleUnit.RAD, (key,))
    assert [row.alpha for row in found.table.rows][:2] == [pi_times(Fraction(1, 2)), key]
    assert found.table.rows[2:] == table.rows[2:]
    assert set(found.steps) == {(2, "alpha"), (3, "alpha")}
    assert found.steps[3, "alpha"] > COARSEST_ANGLE
    exact = read("standard", [("pi/2", "L", 0, "q1")]).table
    assert meant(exact, AngleUnit.RAD, ()).table is exact
    assert meant(exact, AngleUnit.RAD, ()).exact


def test_an_angle_too_coarse_for_the_tolerance_is_said_to_be_that() -> None:
    strict = replace(USUAL, tolerance=replace(USUAL.tolerance, angle=1e-4, length=1e-4))
    coarse: Rows = [(1.57 if row[0] == "pi/2" else row[0], *row[1:]) for row in PUMA]
    verdict = grade(KEY, read("standard", coarse), strict, VALUES)
    assert codes(verdict) == ["not_accepted", "entries_imprecise"]
    assert verdict.repairs == ()


def test_a_prismatic_joint_and_its_tool_point_are_held_to_their_digits() -> None:
    key = read("standard", [(0, 0, 0.5, "q1"), ("pi/2", 0.04, 0, "q2"), (0, 0, "q3", 0)])
    policy = Policy(tool=ToolRule.POINT)
    assert key.table.joint_types[-1] is JointType.PRISMATIC
    good = read("standard", [(0, 0, 0.5, "q1"), ("pi/2", 0.04, 0, "q2"), (0, 0, "q3", 0)])
    bad = read("standard", [(0, 0, 0.5, "q1"), ("pi/2", 0.0385, 0, "q2"), (0, 0, "q3", 0)])
    assert grade(key, good, policy).correct
    assert not grade(key, bad, policy).correct


@pytest.mark.parametrize(("typed", "right"), [("0.21", True), ("0.2100", False), ("0.206", True)])
def test_zeros_at_the_end_are_digits_too(typed: str, *, right: bool) -> None:
    """A hand of 0.206 m, a share of the arm below the tolerance off: 0.21 says so much, 0.2100 does not."""
    key = read(
        "standard", [("pi/2", 0.4, 0, "q1"), (0, 1, 0, "q2"), ("pi/2", 0.01, 0, "q3"), (0, 0, 0.206, "q4")]
    )
    rows: Rows = [("pi/2", 0.4, 0, "q1"), (0, 1, 0, "q2"), ("pi/2", 0.01, 0, "q3"), (0, 0, typed, "q4")]
    policy = Policy(tool=ToolRule.POINT)
    assert grade(key, read("standard", rows), policy).correct is right
    padded: Rows = [(0, 0, 0, 0), *rows]
    assert grade(key, read("standard", padded), policy).correct is right


def test_the_digits_of_a_cell_with_zeros_at_its_end() -> None:
    table = read("standard", [("0.60", "0.2500", "-(0.500)", "q1"), ("0.7", "2*0.50", "q2", "0.10")])
    found = half_steps(table.table, AngleUnit.RAD, table.last_places)
    assert {place: pytest.approx(step) for place, step in found.items()} == {
        (0, "alpha"): 0.005,
        (0, "a"): 0.00005,
        (0, "d"): 0.0005,
        (1, "alpha"): 0.05,
        (1, "a"): 0.5,
        (1, "theta"): 0.005,
    }
    assert half_steps(table.table, AngleUnit.RAD)[0, "d"] == pytest.approx(0.05)


def test_a_wrong_length_is_no_wrong_sign() -> None:
    """0.152 for 0.15005: -0.152 would be as wrong, and half a fact is not given back for it."""
    key = read("standard", [(0, "L1", 0, "q1"), (0, "L2", 0, "q2")])
    verdicts = [
        grade(
            key,
            read("standard", [(0, typed, 0, "q1"), (0, 0.4, 0, "q2")]),
            Policy(tool=ToolRule.POINT),
            {"L1": 0.15005, "L2": 0.4},
        )
        for typed in (0.152, -0.152, 0.153)
    ]
    edits = [[edit.code for repair in verdict.repairs for edit in repair.edits] for verdict in verdicts]
    assert edits == [["a_value"]] * 3
    assert len({verdict.score for verdict in verdicts}) == 1


@pytest.mark.parametrize("name", ["L0", "L2", "L1 - L2"])
def test_numbers_are_told_apart_where_two_names_have_one_value(name: str) -> None:
    """The height of the base may be anything; what is in numbers is right, whatever was drawn alike."""
    rows: Rows = [("pi/2", 0, "L0", "q1"), (0, "L1", 0, "q2"), (0, "L2", 0, "q3")]
    key = read("standard", rows)
    for drawn in (
        {"L0": 0.4, "L1": 0.3, "L2": 0.2},
        {"L0": 0.4, "L1": 0.3, "L2": 0.3},
        {"L0": 0.3, "L1": 0.3, "L2": 0.3},
    ):
        typed = [("pi/2", 0, name, "q1"), (0, drawn["L1"], 0, "q2"), (0, drawn["L2"], 0, "q3")]
        assert grade(key, read("standard", typed), Policy(tool=ToolRule.POINT), drawn).correct
        wrong = [("pi/2", 0, 0, "q1"), (0, "L2", 0, "q2"), (0, drawn["L2"], 0, "q3")]
        assert not grade(key, read("standard", wrong), Policy(tool=ToolRule.POINT), drawn).correct


@pytest.mark.parametrize("drawn", [0.15, 0.3, 0.6])
def test_a_number_beside_a_name_is_as_exact_whatever_the_name_was_drawn_to_be(drawn: float) -> None:
    """0.3 beside a3 was exact for who had drawn a3 = 0.3, and one decimal for everybody else."""
    key = read("modified", [(0, 0, 0, "q1"), (0, "a2", 0, "q2"), (0, "a3", "q3", 0), (0, 0, 0, "q4")])
    answer = read(
        "standard",
        [
            ("pi", 0, 0, 0),
            (0, "a2", 0, "q1"),
            ("pi", "a3 + 0.332", "a2", "q2"),
            ("pi", -0.3, "q3", 0),
            (0, 0, 0.3, "q4"),
        ],
    )
    verdict = grade(key, answer, Policy(), {"a2": 0.4, "a3": drawn})
    assert codes(verdict) == ["not_accepted", "entries_imprecise"]
    assert verdict.score == 0.75


@pytest.mark.parametrize("typed", [-0.45, "-d4"])
def test_a_length_that_the_exercise_gives_is_exact(typed: Cell) -> None:
    """0.5 is d3 to its last digit, though it has one decimal: it is no 0.55 that was rounded."""
    ssrms = exercise("ssrms")
    values = {"d1": 1.35, "d2": 0.8, "a4": 7.2, "d3": 0.5, "a5": 6.8, "d4": 0.45}
    rows = [
        ("-pi/2", 0, 1.35, "q1"),
        ("pi/2", 0, 0.8, "q2 + pi/2"),
        (0, -7.2, typed, "q3"),
        (0, -6.8, -0.45, "q4"),
        ("-pi/2", 0, -0.5, "q5"),
        ("pi/2", 0, -0.8, "q6 - pi/2"),
        (0, 0, 1.35, "q7"),
    ]
    wrong = read("standard", rows)
    right = read("standard", with_cells(rows, (3, 2, -0.5)))
    assert grade(ssrms.reference, right, ssrms.policy, values).correct
    assert not grade(ssrms.reference, wrong, ssrms.policy, values).correct


PLANAR: Rows = [(0, 1, 0, "q1"), (0, 0.1, 0, "q2")]
AXES = Policy(base=BaseRule.AXIS, tool=ToolRule.AXIS)


@pytest.mark.parametrize("policy", [Policy(), AXES], ids=["usual", "axes"])
@pytest.mark.parametrize(
    ("cell", "right"),
    [(0.1, True), (0.1004, True), (0.101, True), (0, True), (0.105, False), (0.004, False), (0.2, False)],
)
def test_the_last_axis_is_the_joint_s_or_the_key_s_as_the_digits_say(
    policy: Policy, cell: float, right: bool
) -> None:
    """5 mm are less than the tolerance of an arm of 1.1 m, and far from what 0.105 may stand for."""
    key, answer = (read("standard", with_cells(PLANAR, (2, 1, value))) for value in (0.1, cell))
    verdict = grade(key, answer, policy)
    assert verdict.correct is right
    if not right:
        assert {"tool_axis_missed", "length_wrong"} <= set(codes(verdict))
        assert {edit.row for repair in verdict.repairs for edit in repair.edits} == {2}
        assert verdict.score == 0.5  # one of its two lengths is right


@pytest.mark.parametrize(("offset", "right"), [(0.1, True), (0.101, True), (0, True), (0.105, False)])
def test_the_first_axis_is_the_joint_s_or_the_key_s_as_the_digits_say(offset: float, right: bool) -> None:
    before = [(0, 0.1, 0, 0), (0, 1, 0, "q1"), (0, 0, 0, "q2")]
    key = read("standard", before)
    answer = read("standard", [(0, offset, 0, 0), *before[1:]])
    verdict = grade(key, answer, AXES)
    assert verdict.correct is right
    assert ("base_axis_missed" in codes(verdict)) is not right


@pytest.mark.parametrize(("twist", "right"), [(0.5, True), (0.504, True), (0, True), (0.51, False)])
def test_a_slider_s_end_is_parallel_to_it_or_to_the_key_s(twist: float, right: bool) -> None:
    def table(alpha: float) -> Rows:
        return [("pi/2", 0, 0, "q1"), (alpha, 0, "q2", 0)]

    verdict = grade(read("standard", table(0.5)), read("standard", table(twist)), Policy())
    assert verdict.correct is right


def test_a_wrong_name_costs_the_same_where_a_drawn_value_is_nearly_that_of_another() -> None:
    """The answer is also read with d3 as the number it is; at its first draw d5 nearly has that value."""
    (panda,) = (robot for robot in robots() if robot.id == "panda")
    key = panda.table
    third = replace(key.table.rows[2], d=add((Parameter("d5"), Number(Fraction(-3, 10)))))
    lifted = DHRow(joint=JointType.FIXED, theta=ZERO, d=Number(Fraction(3, 10)), a=ZERO, alpha=ZERO)
    rows = (*key.table.rows[:2], third, lifted, *key.table.rows[3:])
    names = {name: kind for name, kind in key.parameters.items() if name != "d3"}
    answer = replace(key, table=replace(key.table, rows=rows), parameters=names)
    given = dict(panda.parameters)
    verdicts = [
        grade(key, answer, Policy(), {**given, "d3": d3, "d5": d5})
        for d3, d5 in ((0.632, 0.768), (0.316, 0.384))
    ]
    assert len({(verdict.score, tuple(codes(verdict))) for verdict in verdicts}) == 1
    assert [entry.row for entry in verdicts[0].feedback if entry.code == "offset_wrong"] == [3, 4]


@pytest.mark.parametrize(("alpha", "a"), [(0.003, 0), (0.0003, 0), (0, 0.002), (0, 0.0)])
def test_the_line_of_z_0_is_held_to_the_digits_under_the_rule_axis(alpha: float, a: float) -> None:
    """However little it moves poses; without the rule it may lie anywhere."""
    rows: Rows = [("pi/2", 0.4, 0.1, "q2"), (0.7, 0.3, 0.2, "q3")]
    key = read("modified", [(0, 0, 0.3, "q1"), *rows])
    answer = read("modified", [(alpha, a, 0.3, "q1"), *rows])
    assert grade(key, answer, Policy(base=BaseRule.FREE, tool=ToolRule.FREE)).correct
    verdict = grade(key, answer, Policy(base=BaseRule.AXIS, tool=ToolRule.FREE))
    assert verdict.correct is (alpha == a == 0)
    assert ("base_axis_missed" in codes(verdict)) is not verdict.correct


@pytest.mark.parametrize(("typed", "right"), [(0.05, False), (0.06, True), (0.056, True), (0.055, False)])
def test_a_length_is_what_its_last_digit_allows_and_no_more(typed: float, *, right: bool) -> None:
    """Of 0.056 in an arm of 3 m: 0.05 is half a unit and a fifth of that off."""

    def arm(length: float) -> ReadTable:
        first: Rows = [(90, 1, 0, "q1"), (0, 1.5, 0, "q2"), (90, length, 0, "q3")]
        return read("standard", [*first, (0, 0, 0.8, "q4"), (0, 0.4, 0, "q5")], "deg")

    assert grade(arm(0.056), arm(typed), Policy(tool=ToolRule.FREE)).correct is right


def test_rounded_twists_that_add_up_are_no_wrong_name() -> None:
    """Two of 0.2244 for π/7: they need not cancel to the last digit, as lengths beside names must."""
    key = read("standard", [("pi/7", "L1", 0, "q1"), (0, "L2", 0, "q2")])
    rows: Rows = [(0.2244, "L1", 0, "q1"), (0.2244, 0, 0, 0), (0, "L2", 0, "q2")]
    assert grade(key, read("standard", rows), Policy(), {"L1": 0.5, "L2": 0.4}).correct


def test_exact_offsets_are_told_in_the_units_of_their_joints() -> None:
    """Degrees of a revolute joint, lengths of a prismatic one."""
    key = read("standard", [(0, "L1", 0, "q1"), (0, 0, "q2", 0)], "deg")
    answer = read("standard", [(0, "L1", 0, "q1 + 90"), (0, 0, "q2 + L1", 0)], "deg")
    certificate = grade(
        key, answer, Policy(tool=ToolRule.FRAME, base=BaseRule.FRAME), {"L1": 0.5}
    ).certificate
    assert certificate is not None
    assert certificate.exact is not None
    assert certificate.exact.joint_offsets == ("-90", "-L1")


def test_beside_names_a_rounded_length_stands_for_the_number_of_the_key() -> None:
    key = read("standard", [(0, "L1", "1/3", "q1"), (0, "L2", 0, "q2")])
    values = {"L1": 0.5, "L2": 0.4}
    for typed in ("1/3", 0.333, 0.33333):
        answer = read("standard", [(0, "L1", typed, "q1"), (0, "L2", 0, "q2")])
        assert grade(key, answer, Policy(tool=ToolRule.POINT, base=BaseRule.ORIGIN), values).correct
    for wrong in ("1.001*L2", "L2 + 0.001"):
        answer = read("standard", [(0, "L1", 0.333, "q1"), (0, wrong, 0, "q2")])
        assert not grade(key, answer, Policy(), values).correct


def test_an_offset_is_in_the_unit_of_its_joint() -> None:
    turning, sliding = JointType.REVOLUTE, JointType.PRISMATIC
    assert in_unit(math.pi, turning, AngleUnit.DEG) == 180.0
    assert in_unit(math.pi, turning, AngleUnit.RAD) == math.pi
    assert in_unit(0.3, sliding, AngleUnit.DEG) == in_unit(0.3, sliding, AngleUnit.RAD) == 0.3


@pytest.mark.parametrize(("length", "angle"), [(0.123, 0.7), (123.4567, 0.71)])
def test_digits_that_the_arithmetic_does_not_keep_are_not_tried(length: float, angle: float) -> None:
    for more, tried in ((0.0, True), (math.pi * 1e-4, False)):
        rows: Rows = [(angle + more, length + more, 0, "q1"), (0, length + more, 0, "q2")]
        table = read("modified", rows)
        (way,) = comparisons(table, table, None)
        invariants = invariants_of(prepared(way.references[0]), Policy(tool=ToolRule.POINT))
        found = measured_as_typed(invariants, way.meant[0], way.steps, Policy())
        assert way.steps
        assert (found.shape[1] > 1) is tried


@pytest.mark.parametrize("unit", [1e-3, 1.0, 1e4])
def test_what_digits_may_move_is_a_share_of_the_robot_in_every_unit(unit: float) -> None:
    """Half a unit of an angle as it is, and of a length beside the robot's size."""
    table = scaled(tables.PUMA, unit)
    reference = prepared(table)
    steps = {(1, "a"): 0.005 * unit, (2, "alpha"): 0.01}
    moved = digits_and_angles(reference, table, steps, USUAL)
    assert moved == pytest.approx(SECOND_ORDER * (0.005 / prepared(tables.PUMA).size + 0.01))


def test_what_is_accepted_is_accepted_for_the_values_that_were_given() -> None:
    numeric = read("standard", numbers(PUMA, 4))
    assert accept(KEY, numeric, USUAL, VALUES) == grade(KEY, numeric, USUAL, VALUES)
    for others in (None, {**VALUES, "a2": 2 * VALUES["a2"]}):
        assert accept(KEY, numeric, USUAL, others) is None
