"""How exactly entries were typed, what rounded ones stand for, and at which values answers are compared."""

import math
from dataclasses import replace
from fractions import Fraction

import pytest

from exercises.grading import BaseRule, Policy, Tolerance, ToolRule, grade
from exercises.grading.judging.comparison import comparisons
from exercises.grading.judging.digits import fixing_frames, steps_of_wrong, tightened
from exercises.grading.judging.name_values import Values, drawn_value, typical_length
from exercises.grading.judging.named_numbers import with_names
from exercises.grading.judging.typed import half_steps, meant, meant_in_radians
from kinematics.cells import AngleUnit, ParameterKind
from kinematics.equivalence.reference import SAMPLES, prepared
from kinematics.expressions import Number, number, pi_times
from kinematics.table import DHTable, JointType, bind
from tests.exercises.grading.test_grade import KEY, PUMA, USUAL, VALUES, Rows, with_cells
from tests.exercises.grading.written import Cell, read

ONE: Rows = [(0.25, 0.5, 0, "q1"), (0, 0.3, 0.125, "q2")]


@pytest.mark.parametrize(
    ("typed", "unit", "step"),
    [
        (0.5, "rad", 0.05),
        (0.43, "rad", 0.005),
        (1.25, "rad", 0.005),
        (2.0, "rad", 0.5),
        ("1/3", "rad", 0.0),  # no decimal
        ("pi/7", "rad", 0.0),
        (31.5, "deg", math.radians(0.05)),
        (30, "deg", 0.0),  # a multiple of 15°
        (-15, "deg", 0.0),
        (31, "deg", math.radians(0.5)),
    ],
)
def test_a_decimal_is_right_within_half_a_unit_of_its_last_place(typed: Cell, unit: str, step: float) -> None:
    read_ = read("standard", [(typed, 1, 0, "q1"), (0, "1/3", 0, "q2")], unit)
    steps = half_steps(read_.table, read_.angle_unit)
    assert steps.get((0, "alpha"), 0.0) == pytest.approx(step)
    assert (1, "a") not in steps


def test_more_digits_than_a_double_tells_apart_are_exact() -> None:
    for decimals, exact in ((39, False), (40, False), (41, True)):
        table = read("standard", [(0, float(f"3e-{decimals}"), 0, "q1")]).table
        assert ((0, "a") not in half_steps(table, AngleUnit.RAD)) is exact


def test_a_zero_is_as_exact_as_the_most_exact_entry_of_its_kind() -> None:
    steps = half_steps(read("standard", ONE).table, AngleUnit.RAD)
    assert steps == pytest.approx(
        {(0, "alpha"): 0.005, (1, "alpha"): 0.005, (0, "a"): 0.05, (1, "a"): 0.05, (0, "d"): 0.0005}
        | {(1, "d"): 0.0005}
    )
    known = half_steps(read("standard", ONE).table, AngleUnit.RAD, {(0, "a"): 0.01, (1, "a"): 1.0})
    assert (known[0, "a"], known[1, "a"]) == (0.005, 0.05)


@pytest.mark.parametrize(
    ("typed", "known", "stands_for"),
    [
        (0.43, "0.4318", "0.4318"),
        (0.44, "0.4318", None),  # off by more than half a unit, less than a whole one
        (0.43, "0.435", "0.435"),  # by just half a unit
        (-0.43, "0.4318", "-0.4318"),
        (0.43, "0.4272", "0.4272"),
    ],
)
def test_a_rounded_length_stands_for_the_nearest_one_within_its_digits(
    typed: float, known: str, stands_for: str | None
) -> None:
    table = read("standard", [(0, typed, 0, "q1")]).table
    found = meant(table, AngleUnit.RAD, (), (Number(Fraction(known)),))
    expected = Number(Fraction(stands_for)) if stands_for else table.rows[0].a
    assert found.table.rows[0].a == expected
    assert ((0, "a") in found.steps) is (stands_for is None)
    assert found.typed_steps[0, "a"] == pytest.approx(0.005)


def test_of_two_lengths_the_nearer_one_is_meant() -> None:
    table = read("standard", [(0, 0.43, 0, "q1")]).table
    lengths = (Number(Fraction("0.427")), Number(Fraction("0.431")))
    assert meant(table, AngleUnit.RAD, (), lengths).table.rows[0].a == lengths[1]
    assert meant(table, AngleUnit.RAD, (), lengths, given={Fraction("0.43")}).table is table


@pytest.mark.parametrize(
    ("typed", "twelfths"), [(1.57, 6), (-0.79, -3), (0.26, 1), (1.6, None), (1.56, None), (0.524, 2)]
)
def test_a_rounded_angle_stands_for_a_multiple_of_fifteen_degrees(typed: float, twelfths: int | None) -> None:
    """With two decimals or more, and within them."""
    table = read("standard", [(typed, 1, 0, "q1")]).table
    found = meant(table, AngleUnit.RAD, ()).table.rows[0].alpha
    assert found == (table.rows[0].alpha if twelfths is None else pi_times(Fraction(twelfths, 12)))


def test_radians_where_degrees_are_declared_need_two_decimals_for_a_right_angle() -> None:
    assert meant_in_radians(math.radians(1.57)) == pytest.approx(math.pi / 2, abs=1e-15)
    assert meant_in_radians(math.radians(1.566)) == pytest.approx(math.pi / 2, abs=1e-15)
    assert meant_in_radians(math.radians(1.56)) == pytest.approx(1.56)


@pytest.mark.parametrize(
    ("typed", "names"),
    [
        (0.4318, {"a2"}),
        (0.43, {"a2"}),
        (-0.4318, {"-a2"}),
        (0.424, set()),  # not to its last digit
        (0.4, set()),  # to its last digit, but seven per cent off
        (0.5, set()),
    ],
)
def test_a_number_stands_for_the_name_whose_value_it_is(typed: float, names: set[str]) -> None:
    kinds = dict.fromkeys(VALUES, ParameterKind.LENGTH)
    values = Values(kinds=kinds, given={name: Fraction(repr(VALUES[name])) for name in VALUES}, scale=1.0)
    found = with_names(read("standard", with_cells(PUMA, (2, 1, typed))), values)
    assert {str(one.table.rows[1].a) for one in found} == {str(_named(name)) for name in names}


@pytest.mark.parametrize(
    ("typed", "value", "is_meant"),
    [
        (0.4, 0.4076, True),
        (0.4, 0.4088, False),  # more than two per cent, whatever the digits
        ("1/3", 0.333, False),  # no decimal: exact
        ("1/3", 1 / 3, True),
        (0.1, 0.1 * (1 + 0.9e-9), True),  # the same but for the arithmetic's errors
    ],
)
def test_a_number_is_a_name_within_its_digits_and_two_per_cent(
    typed: Cell, value: float, is_meant: bool
) -> None:
    values = Values(kinds={"L": ParameterKind.LENGTH}, given={"L": value}, scale=1.0)
    found = with_names(read("standard", [(0, typed, 0, "q1")]), values)
    assert [one.table.rows[0].a for one in found] == [_named("L")] * is_meant


def test_an_exact_number_is_a_name_to_a_billionth() -> None:
    for off, is_meant in ((0.9e-9, True), (1.1e-9, False)):
        given = {"L": (1 + off) / 3}
        values = Values(kinds={"L": ParameterKind.LENGTH}, given=given, scale=1.0)
        assert bool(list(with_names(read("standard", [(0, "1/3", 0, "q1")]), values))) == is_meant


def test_a_length_stands_for_no_name_of_an_angle() -> None:
    kinds = {"L": ParameterKind.LENGTH, "beta": ParameterKind.ANGLE}
    values = Values(kinds=kinds, given={"L": 0.3, "beta": 0.4}, scale=1.0)
    assert list(with_names(read("standard", [("beta", 0.4, 0, "q1")]), values)) == []


def _named(name: str) -> object:
    return read("standard", [(0, name, 0, "q1")]).table.rows[0].a


def test_names_with_one_value_are_both_meant_and_names_with_nearly_one_neither() -> None:
    kinds = {"a": ParameterKind.LENGTH, "b": ParameterKind.LENGTH}
    answer = read("standard", [(0, 0.4, 0, "q1")])
    for other, count in (("0.4", 2), ("0.401", 1), ("0.45", 1)):
        values = Values(kinds=kinds, given={"a": Fraction("0.4"), "b": Fraction(other)}, scale=1.0)
        assert len(list(with_names(answer, values))) == count
    near = Values(kinds=kinds, given={"a": Fraction("0.401"), "b": Fraction("0.399")}, scale=1.0)
    assert list(with_names(read("standard", [(0, 0.4, 0.2, "q1")]), near)) == []


def test_names_are_compared_at_three_draws_and_numbers_at_none() -> None:
    """Each of them at 64 configurations."""
    named = grade(KEY, KEY, USUAL).certificate
    of_numbers = read("standard", [(0, 0.4, 0, "q1"), (0, 0.3, 0, "q2")])
    numbers = grade(of_numbers, of_numbers, USUAL).certificate
    assert named is not None
    assert numbers is not None
    assert (SAMPLES, named.samples, numbers.samples) == (64, 192, 64)


def test_draws_owe_nothing_to_given_values_at_first_and_come_nearer_later() -> None:
    kinds = {"h": ParameterKind.LENGTH, "beta": ParameterKind.ANGLE}
    values = Values(kinds=kinds, given={"h": 100.0}, scale=2.0)
    assert all(0.8 <= drawn_value("h", attempt, values) <= 3.2 for attempt in range(20))
    apart = [abs(drawn_value("h", attempt, values) / 100.0 - 1.0) for attempt in range(20, 60)]
    assert max(apart[:4]) <= 0.6
    assert max(apart[4:8]) <= 0.3
    assert max(apart[36:]) <= 0.06
    assert max(apart[:4]) > 0.3
    assert all(0.28 <= drawn_value("beta", attempt, values) <= 1.12 for attempt in range(30))


def test_a_typical_length_is_the_mean_of_the_numbers() -> None:
    assert typical_length(read("standard", [(0, 0.4, -0.2, "q1"), (0, 0, "h", "q2")]).table) == pytest.approx(
        0.3
    )
    assert typical_length(KEY.table) == 1.0


def test_the_values_of_names_in_an_exercise_are_in_the_keys_unit() -> None:
    answer = read("standard", [(0, 400, 0, "q1"), (0, 300, 0, "q2")], length_unit="mm")
    key = read("standard", [(0, "a", 0, "q1"), (0, "b", 0, "q2")])
    (way,) = comparisons(key, answer, {"a": 0.4, "b": 0.3})
    assert [row.a for row in way.references[0].rows] == [400.0, 300.0]
    assert way.by_value
    assert not way.in_names


TWISTED: Rows = [
    ("pi/2", 0.1, 0.2, "q1"),
    (0.7, 0.4, 0.3, "q2"),
    (0.6, 0.1, "q3", 0.4),
    (0.9, 0.2, 0.1, "q4"),
]


@pytest.mark.parametrize(
    ("rule", "row", "cell", "typed", "right"),
    [
        ("base", 1, 2, 0.9, True),  # along the axis
        ("tool", 4, 2, 0.9, False),
        ("tool", 4, 1, 0.2, True),
        ("tool", 4, 1, 0.21, False),
        ("tool", 4, 0, 0.91, False),
        ("tool", 4, 0, 0.9, True),
    ],
)
def test_a_line_at_an_end_is_held_to_the_digits(
    rule: str, row: int, cell: int, typed: float, right: bool
) -> None:
    """By a per cent of itself, though poses may be off by more of the robot."""
    policy = Policy(base=BaseRule.AXIS, tool=ToolRule.FREE) if rule == "base" else Policy(tool=ToolRule.AXIS)
    answer = read("standard", with_cells(TWISTED, (row, cell, typed)))
    assert grade(read("standard", TWISTED), answer, policy).correct is right


@pytest.mark.parametrize(("typed", "right"), [(0, True), (0.003, False)])
def test_a_tool_on_the_last_axis_stays_on_it(typed: float, right: bool) -> None:
    """Behind a slider, too, though 3 mm are within the tolerance of poses."""
    rows: Rows = [*TWISTED[:3], (0, 0, 0.1, "q4")]
    answer = read("standard", with_cells(rows, (4, 1, typed)))
    assert grade(read("standard", rows), answer, Policy(tool=ToolRule.AXIS)).correct is right


def test_multiples_of_names_are_exact() -> None:
    assert number(2) != number(3)
    assert half_steps(read("standard", with_cells(PUMA, (2, 1, "a2/3 + d4"))).table, AngleUnit.RAD) == {}


@pytest.mark.parametrize("unit", [1e-3, 1e3])
@pytest.mark.parametrize("joint", [JointType.REVOLUTE, JointType.PRISMATIC])
def test_what_digits_explain_does_not_depend_on_the_unit_of_length(unit: float, joint: JointType) -> None:
    """Of a table with the joints of the key, and of one with others."""

    def slacks(unit: float) -> tuple[list[float], list[float]]:
        rows: Rows = [(0.5, 0.4 * unit, 0.3 * unit, "q1"), (0.7, 0.2 * unit, 0.1 * unit, "q2")]
        key = bind(read("standard", [*rows, (0, 0.3 * unit, 0, "q3")]).table, {})
        table = DHTable(
            convention=key.convention, rows=(key.rows[0], replace(key.rows[1], joint=joint), key.rows[2])
        )
        steps = {(0, "a"): 0.005 * unit, (1, "d"): 0.005 * unit, (1, "alpha"): 0.005}
        found = tightened(prepared(key), table, steps, Policy(tool=ToolRule.POINT), 0.01)
        angular = found.angular[:, 0]
        return found.slacks[angular, 0].tolist(), found.slacks[~angular, 0].tolist()

    (angles, lengths), (same, scaled) = slacks(1.0), slacks(unit)
    assert same == pytest.approx(angles)
    assert scaled == pytest.approx([unit * length for length in lengths])


def test_zeros_of_a_wrong_answer_are_known_to_within_the_tolerance() -> None:
    """[rad] of angles, and of lengths a share of the robot's 3 m; so are a lone 1, or 0.5, that may be half.

    Other entries are as exact as typed.
    """
    key = read("standard", [(0, 1, 0, "q1"), (0.5, 2, 0, "q2")]).table
    reference = prepared(bind(key, {}))
    assert reference.size == 3.0
    typed = dict.fromkeys(((0, "alpha"), (0, "a"), (0, "d"), (1, "a"), (1, "alpha")), 0.5)
    found = steps_of_wrong(typed, reference.table, reference, Tolerance(length=0.01, angle=0.005))
    assert found == pytest.approx(
        {(0, "alpha"): 0.005, (0, "a"): 0.03, (0, "d"): 0.03, (1, "a"): 0.5, (1, "alpha"): 0.005}
    )


def test_a_number_that_says_too_little_is_as_wrong_among_names_as_among_numbers() -> None:
    """0.1 is no 0.07 rounded."""
    values = {"a2": 0.4, "a3": 0.07, "d3": 0.15, "d4": 0.45}
    wrong = with_cells(PUMA, (3, 1, 0.1))
    found = {
        (verdict.score, *((entry.code, entry.row) for entry in verdict.feedback))
        for rows in (wrong, [tuple(values.get(str(cell), cell) for cell in row) for row in wrong])
        for verdict in [grade(KEY, read("standard", rows), USUAL, values)]  # type: ignore[arg-type]
    }
    assert found == {(0.89, ("not_equivalent", None), ("length_wrong", 3))}


def test_a_draw_is_moved_to_the_front_and_none_is_lost() -> None:
    (way, *_) = comparisons(KEY, KEY, {})
    assert len(way.drawn) > 2
    assert way.with_first(0) is way
    moved = way.with_first(2).drawn
    assert moved == (way.drawn[2], *way.drawn[:2], *way.drawn[3:])


@pytest.mark.parametrize("base", BaseRule)
@pytest.mark.parametrize("tool", ToolRule)
def test_what_is_measured_depends_on_the_frames_that_are_fixed_alone(base: BaseRule, tool: ToolRule) -> None:
    fixed = fixing_frames(Policy(base=base, tool=tool))
    assert (fixed.base is BaseRule.FRAME, fixed.tool is ToolRule.FRAME) == (
        base is BaseRule.FRAME,
        tool is ToolRule.FRAME,
    )
    assert fixed.base in (BaseRule.FRAME, BaseRule.FREE)
    assert fixed.tool in (ToolRule.FRAME, ToolRule.FREE)
