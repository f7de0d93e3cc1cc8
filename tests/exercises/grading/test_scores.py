"""Marks, counted by hand: what of the robot's facts an answer lacks, of those that a table of zeros lacks."""

import re
from dataclasses import asdict, replace
from pathlib import Path
from random import Random

import numpy as np
import pytest

from exercises.grading import ConventionRule, DirectionRule, HelpLevel, Policy, ToolRule, ZeroRule, grade
from exercises.grading.edits.changes import Change, Extent
from exercises.grading.facts import Weights
from exercises.grading.judging.digits import floors
from exercises.grading.score import _is_of_length_or_turn
from kinematics.equivalence.invariants import invariants_of
from kinematics.equivalence.reference import prepared
from kinematics.table import Convention, NumericTable
from tests.exercises.grading.campaign import drawn_by_hand
from tests.exercises.grading.test_grade import (
    KEY,
    MISTAKES,
    PUMA,
    PUMA_CRAIG,
    SCARA,
    USUAL,
    VALUES,
    Rows,
    numbers,
    with_cells,
)
from tests.exercises.grading.written import Cell, read, written
from tests.kinematics.equivalence import tables
from tests.kinematics.equivalence.tables import HALF, F, P, R
from tests.kinematics.equivalence.test_refinement import scaled
from tests.kinematics.robots import numeric

CHECKER = Path(__file__).resolve().parents[3] / "docs" / "checker.md"
OF_PUMA = 9
"""α of rows 1, 3, 4 and 5, a2, a3, d3, d4, and the offset along axis 5: along parallel axes there is none."""


def mark(lost: float, of: int) -> float:
    return round(1 - lost / of, 2)


CELLS: dict[str, tuple[list[tuple[int, int, Cell]], float]] = {
    "two cells": ([(2, 1, "a3"), (5, 0, 0)], 3),
    "three cells": ([(1, 0, 0), (2, 1, 0), (4, 2, 0)], 4),
    "four cells": ([(1, 0, 0), (2, 1, 0), (4, 2, 0), (5, 0, 0)], 6),
    "five cells": ([(1, 0, 0), (2, 1, 0), (3, 1, 0), (4, 2, 0), (5, 0, 0)], 7),
}


@pytest.mark.parametrize(("cells", "lost"), CELLS.values(), ids=CELLS.keys())
def test_cells_of_the_puma(cells: list[tuple[int, int, Cell]], lost: float) -> None:
    verdict = grade(KEY, read("standard", with_cells(PUMA, *cells)), USUAL, VALUES)
    assert verdict.score == mark(lost, OF_PUMA)


def test_named_slips_of_the_puma() -> None:
    """One cell costs a fact, its sign half of one, a row two, the whole table three.

    Of a row too many the facts count, which weigh less: one that is wrong, and a ninth of the others.
    """
    lost = {
        **dict.fromkeys(("alpha_sign", "twists_all_reversed"), 0.5),
        **dict.fromkeys(("alpha_value", "a_missing", "d_missing", "d_not_zero", "cell_parameter"), 1),
        **dict.fromkeys(("parameter_misnamed", "cell_in_degrees"), 1),
        **dict.fromkeys(("parameters_swapped", "a_d_swapped", "joint_type", "rows_swapped"), 2),
        "row_extra": 1 + 8 / OF_PUMA,
        "angles_in_degrees": 3,
    }
    found = {name: grade(KEY, read("standard", MISTAKES[name][0]), USUAL, VALUES).score for name in lost}
    assert found == {name: mark(count, OF_PUMA) for name, count in lost.items()}


def test_decimals_cost_what_names_do() -> None:
    typed = with_cells(numbers(PUMA, 2), (2, 1, 0.53), (3, 1, 0.12))
    assert grade(KEY, read("standard", typed), USUAL, VALUES).score == mark(2, OF_PUMA)
    more = with_cells(typed, (5, 0, 0.3), (1, 0, 1.2))
    assert grade(KEY, read("standard", more), USUAL, VALUES).score == mark(4, OF_PUMA)


SCARAS: dict[str, tuple[Rows, float]] = {
    "a length": (with_cells(SCARA, (2, 1, 0)), 1),
    "both lengths": (with_cells(SCARA, (2, 1, 0), (3, 1, 0)), 2),
    "lengths exchanged": (with_cells(SCARA, (2, 1, "a3"), (3, 1, "a2")), 1),
    "a twist": (with_cells(SCARA, (3, 0, "pi/2")), 1),
    "a twist and a length": (with_cells(SCARA, (3, 0, "pi/2"), (2, 1, 0)), 2),
    "no slider": ([(0, 0, 0, "q1"), (0, "a2", 0, "q2"), (0, "a3", 0, "q3"), (0, 0, 0, "q4")], 1),
}


@pytest.mark.parametrize(("rows", "lost"), SCARAS.values(), ids=SCARAS.keys())
def test_of_a_scara_there_are_two_lengths_to_earn(rows: Rows, lost: float) -> None:
    verdict = grade(read("modified", SCARA), read("modified", rows), USUAL, {"a2": 0.4, "a3": 0.3})
    assert verdict.score == mark(lost, 2)


STRICT = Policy(zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)


def test_rules_that_are_not_kept_are_facts_as_well() -> None:
    """Zeros and directions as in the figure are two more; nobody is seen to keep them on another robot."""
    for cells, lost in [
        ([(2, 3, "q2 + pi/2")], 1),
        ([(2, 3, "-q2 + pi/2")], 2),
        ([(2, 1, 0)], 1),
        ([(2, 1, 0), (4, 3, "q4 + pi/2")], 3),
        ([(6, 1, 0.1)], 1),
        ([(6, 1, 0.1), (2, 3, "q2 + pi/2")], 2),
    ]:
        answer = read("standard", with_cells(PUMA, *cells))  # type: ignore[arg-type]
        assert grade(KEY, answer, STRICT, VALUES).score == mark(lost, OF_PUMA + 2)
    asked = Policy(convention=ConventionRule.STANDARD)
    assert grade(KEY, read("modified", PUMA_CRAIG), asked, VALUES).score == mark(1, OF_PUMA)
    one_more = read("modified", with_cells(PUMA_CRAIG, (3, 1, 0)))
    assert grade(KEY, one_more, asked, VALUES).score == mark(2, OF_PUMA)


STANFORD: Rows = [
    ("-pi/2", 0, 0, "q1"), ("pi/2", 0, "d2", "q2"), (0, 0, "q3", 0),
    ("-pi/2", 0, 0, "q4"), ("pi/2", 0, 0, "q5"), (0, 0, 0, "q6"),
]  # fmt: skip


@pytest.mark.parametrize("cell", [(2, 2, 0), (2, 0, 0), (3, 0, "pi/2")])
def test_an_offset_and_twists_beside_a_slider(cell: tuple[int, int, Cell]) -> None:
    """Zeros lack α of rows 1, 2, 4 and 5, d2, and the offset along axis 5."""
    answer = read("standard", with_cells(STANFORD, cell))
    assert grade(read("standard", STANFORD), answer, USUAL, {"d2": 0.15}).score == mark(1, 6)


def test_what_the_arithmetic_may_do_to_lengths_grows_with_the_robot() -> None:
    key, larger = prepared(tables.PUMA), prepared(scaled(tables.PUMA, 1024.0))
    invariants = invariants_of(key, Policy(tool=ToolRule.FREE))
    ratio = floors(invariants, larger) / floors(invariants, key)
    assert ratio.tolist() == np.where(invariants.angular[:, 0], 1.0, 1024.0).tolist()


@pytest.mark.parametrize(("unit", "typed"), [("m", 350.0), ("mm", 0.35), ("cm", 0.35)])
def test_one_length_in_another_unit_is_one_slip(unit: str, typed: float) -> None:
    """Too long by a thousand, or too short."""
    scale = {"m": 1.0, "cm": 100.0, "mm": 1000.0}[unit]
    rows = [
        tuple(cell * scale if isinstance(cell, float) and k in (1, 2) else cell for k, cell in enumerate(row))
        for row in numbers(PUMA)
    ]
    answer = read("standard", with_cells(rows, (4, 2, typed)), length_unit=unit)  # type: ignore[arg-type]
    verdict = grade(KEY, answer, USUAL, VALUES)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("cell_length_unit", 4)]
    assert verdict.score == mark(1, OF_PUMA)


SMALL: dict[str, Rows] = {
    "one link": [(0, 0, 0, "q1"), (0, "L1", 0, 0)],
    "two links": [(0, 0, 0, "q1"), (0, "L1", 0, "q2")],
}


@pytest.mark.parametrize("policy", [replace(STRICT, tool=tool) for tool in (ToolRule.POINT, ToolRule.FRAME)])
@pytest.mark.parametrize("rows", SMALL.values(), ids=SMALL.keys())
def test_zeros_of_a_small_arm_earn_nothing_under_strict_rules(rows: Rows, policy: Policy) -> None:
    """One length would mend them; the zeros and directions that they keep were had for nothing."""
    key = read("modified", rows)
    zeros: Rows = [(0, 0, 0, row[3]) for row in rows]
    for height in (0, 0.3):
        answer = read("modified", with_cells(zeros, (1, 2, height)))
        assert grade(key, answer, policy, {"L1": 0.5}).score == 0.0
    turned = read("modified", with_cells(rows, (1, 3, "-q1")))
    assert grade(key, turned, policy, {"L1": 0.5}).score > 0.3


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize("twist", [0.6, -1.3])
def test_one_other_twist_costs_one_fact_in_whatever_frames(convention: Convention, twist: float) -> None:
    """A slider between parallel axes: where it leans, their distance means something else.

    In frames of the answer's own no single edit need undo that.
    """
    ones = ("revolute", np.pi / 2, 0.0, 0.4, 0.0), ("revolute", 0.0, 0.5, 0.3, 0.0)
    slider = ("prismatic", 0.0, 0.3, 0.0, 0.4), ("revolute", 0.9, 0.2, 0.0, 0.0)
    key, policy = numeric(convention, *ones, *slider, *ones), Policy(tool=ToolRule.FREE)
    leaning = _with_twist(key, 2 if convention is Convention.MODIFIED else 1, twist)
    drawn = [table for seed in range(6) if (table := drawn_by_hand(leaning, Random(seed)))]
    scores = {grade(written(key), written(table), policy).score for table in drawn}
    worse = {grade(written(key), written(_with_twist(table, 4, 0.4)), policy).score for table in drawn}
    assert len(scores) == 1
    assert max(worse) < min(scores)


@pytest.mark.parametrize("second", [0.903, 0.92])
def test_a_second_wrong_twist_costs_under_every_rule_what_it_costs_without(second: float) -> None:
    """0.903 for 0.9 is within the tolerance of a pose, but more than its digits explain."""

    def arm(one: float, two: float) -> Rows:
        return [(one, "L1", 0, "q1"), (two, "L2", 0, "q2"), (0, "L1", 0, "q3")]

    key, answer, values = arm(0.3217, 0.9), arm(1.57, second), {"L1": 0.4, "L2": 0.3}
    scores = {
        tool: grade(read("standard", key), read("standard", answer), Policy(tool=tool), values).score
        for tool in (ToolRule.FREE, ToolRule.AXIS)
    }
    assert set(scores.values()) == {0.6}


def _with_twist(table: NumericTable, row: int, more: float) -> NumericTable:
    rows = list(table.rows)
    rows[row] = replace(rows[row], alpha=rows[row].alpha + more)
    return replace(table, rows=tuple(rows))


@pytest.mark.parametrize(
    ("weights", "of"), [(Weights(length=3.0), 13), (Weights(offset=3.0), 15)], ids=["length", "offset"]
)
def test_lengths_and_offsets_have_weights_of_their_own(weights: Weights, of: int) -> None:
    """Of the PUMA two of the nine facts are lengths, three are offsets."""
    for cells, weight in (
        (((2, 1, 0), (3, 1, 0)), weights.length),
        (((3, 2, 0), (4, 2, 0)), weights.offset),
    ):
        answer = read("standard", with_cells(PUMA, *cells))
        verdict = grade(KEY, answer, USUAL, VALUES, HelpLevel.REPAIR, weights)
        assert verdict.score == mark(2 * weight, of)


def test_two_facts_across_one_slider_cost_the_same_in_all_frames() -> None:
    """In some drawings one length of a row explains both, in others two cells do."""
    key = tables.modified(
        (P, np.pi / 2, 0.0, 0.0, 0.6),
        (R, 0.0, 0.8, 0.0, 0.0),
        (P, np.pi, 0.0, 0.0, 0.0),
        (R, np.pi / 2, -0.9, 0.0, 0.0),
        (P, -np.pi / 2, 0.0, -0.7, np.pi),
        (R, 0.0, -0.5, 0.0, 0.0),
        (R, -2.24, 0.75, 0.0, 0.0),
    )
    wrong = tables.changed(tables.changed(key, 4, d=2.7), 6, a=-1.7)
    drawn = [table for seed in range(30) if (table := drawn_by_hand(wrong, Random(seed)))]
    found = {grade(written(key), written(table), Policy(tool=ToolRule.FREE)).score for table in drawn}
    assert found == {mark(1, 7)}


def test_a_turn_about_sliders_is_none_where_they_are_no_longer_parallel() -> None:
    """A third wrong twist made the angle about the first of them right again."""
    key = tables.standard(
        (P, np.pi / 2, 0, -0.2, 2.6659),
        (P, 0, 0, 0, 0),
        (P, np.pi, 0, 0.15, np.pi),
        (P, np.pi / 2, 0, 0.55, np.pi / 2),
        (P, 0, 0, -0.9, np.pi / 2),
    )
    wrong = tables.changed(tables.changed(key, 4, alpha=1.7718), 2, alpha=-0.6678)
    worse = tables.changed(wrong, 3, alpha=2.5141)
    before, after = (
        grade(written(key), written(table), Policy(tool=ToolRule.FREE)).score for table in (wrong, worse)
    )
    assert after < before


@pytest.mark.parametrize("row", [1, 2, 3])
@pytest.mark.parametrize("rule", [ToolRule.FREE, ToolRule.AXIS])
def test_a_forgotten_variable_leaves_half_of_a_short_arm(row: int, rule: ToolRule) -> None:
    """What a joint and its neighbours are may be all the facts; one more that is wrong leaves no more."""
    policy = Policy(tool=rule)
    rows: Rows = [("pi/2", 0.1, 0, "q1"), (0, 0.4, 0.2, "q2"), ("pi/6", 0, "q3", 0.3), (0, 0.05, 0.2, 0)]
    forgotten = with_cells(rows, (row, 2 if row == 3 else 3, 0.3))
    verdict = grade(read("standard", rows), read("standard", forgotten), policy)
    assert verdict.repairs[0].edits[0].code == "joint_fixed"
    assert verdict.score == 0.5
    more = with_cells(forgotten, (1, 0, 0.4))
    assert grade(read("standard", rows), read("standard", more), policy).score <= 0.5


KINDS = {
    "puma": (tables.PUMA, 9),
    "stanford": (
        tables.standard(
            (R, -HALF, 0, 0, 0),
            (R, HALF, 0, 0.15, 0),
            (P, 0, 0, 0, 0),
            (R, -HALF, 0, 0, 0),
            (R, HALF, 0, 0, 0),
            (R, 0, 0, 0, 0),
        ),
        6,
    ),
    "scara": (tables.SCARA, 2),
    "two links": (tables.standard((R, 0, 0.5, 0, 0), (R, 0, 0.3, 0, 0)), 1),
    "polar": (tables.standard((R, -HALF, 0, 0.4, 0), (R, HALF, 0, 0.2, 0), (P, 0, 0, 0, 0)), 2),
    "cartesian": (tables.standard((P, -HALF, 0, 0, 0), (P, HALF, 0, 0, HALF), (P, 0, 0, 0, 0)), 3),
}
OTHER = {R: P, P: R}


def test_axes_made_parallel_are_not_nearly_so_beside_a_slider() -> None:
    """Nearly parallel, they might have any distance: the slider would carry them far enough."""
    key = read("standard", [(-30, 0.3, "q1", 0), (60, 0, 0.8, "q2"), (-90, -0.1, 0.2, "q3")], "deg")
    own = read("standard", [(-30, 0.3, "q1", 0), (0, 0.4, 0.4, "q2"), (-90, -0.1, 0.2, "q3")], "deg")
    redrawn = [(180, 0.7, "q1", 180), (-150, 0.4, 0.33, "q2 - 90"), (0, -0.4, -0.73, "q3")]
    scores = {
        grade(key, answer, Policy(tool=ToolRule.FREE)).score
        for answer in (own, read("modified", redrawn, "deg"))
    }
    assert scores == {0.25}


@pytest.mark.parametrize(("key", "of"), KINDS.values(), ids=KINDS.keys())
def test_another_type_of_joint_costs_twice_a_twist_and_at_most_half(key: NumericTable, of: int) -> None:
    for row, given in enumerate(key.rows, start=1):
        other = tables.changed(key, row, joint=OTHER[given.joint])
        assert grade(written(key), written(other), USUAL).score == mark(min(2, of / 2), of)


@pytest.mark.parametrize(("key", "of"), KINDS.values(), ids=KINDS.keys())
def test_every_joint_more_of_another_type_leaves_less(key: NumericTable, of: int) -> None:
    """Zeros and lengths left out beside them, too; of zeros nothing can be left."""
    for start, most in ((key, 1.0), (_without_lengths(key), 1.0), (_zeros(key), 0.0)):
        table, scores = start, [most]
        for row, given in enumerate(key.rows, start=1):
            table = tables.changed(table, row, joint=OTHER[given.joint])
            scores.append(grade(written(key), written(table), USUAL).score)
        assert scores == sorted(scores, reverse=True)


def test_of_several_wrong_types_the_other_facts_leave_something() -> None:
    """Each takes a third of what is right beside it."""
    key = KINDS["stanford"][0]
    wrong = tables.changed(key, 3, joint=R)
    for row, cells in ((2, {"alpha": 0.0}), (2, {"d": 0.0}), (4, {"alpha": 0.0})):
        score = grade(written(key), written(tables.changed(wrong, row, **cells)), USUAL).score
        assert 0.4 < score < 0.67


@pytest.mark.parametrize(("key", "of"), KINDS.values(), ids=KINDS.keys())
def test_a_row_left_out_leaves_what_the_others_say(key: NumericTable, of: int) -> None:
    """It costs two facts, and no more than half; where the others say no more than zeros, nothing is left."""
    for row in range(len(key.rows)):
        rest = replace(key, rows=(*key.rows[:row], *key.rows[row + 1 :]))
        says_nothing = len(rest.rows) == 1 and row == 0
        expected = 0.0 if says_nothing else mark(min(2, of / 2), of)
        assert grade(written(key), written(rest), USUAL).score == expected
        assert grade(written(key), written(_zeros(rest)), USUAL).score == 0.0


def _without_lengths(table: NumericTable) -> NumericTable:
    return replace(table, rows=tuple(replace(row, a=0.0, d=0.0) for row in table.rows))


def _zeros(table: NumericTable) -> NumericTable:
    rows = (replace(row, theta=0.0, d=0.0, a=0.0, alpha=0.0) for row in table.rows)
    return replace(table, rows=tuple(rows))


@pytest.mark.parametrize("typed", [1, 0.4, 2])
def test_a_zero_is_no_length_that_was_typed_coarsely(typed: Cell) -> None:
    """Beside a length typed to the metre, or to a decimetre, those left out counted as right."""
    zeros = [(2, 1, 0), (3, 1, 0), (3, 2, 0), (4, 2, 0)]
    key = read("standard", numbers(PUMA))
    nothing, one = (
        grade(key, read("standard", with_cells(numbers(PUMA), *cells)), USUAL).score  # type: ignore[arg-type]
        for cells in (zeros, [*zeros, (2, 1, typed)])
    )
    assert nothing == one == mark(4, OF_PUMA)


PLANE = tables.standard(
    (R, 1.0123, 0.3111, 0.2123, 0),
    (R, 0.8456, 0.4123, 0.2511, 0),
    (P, HALF, 0, 0.1234, 0.3),
    (P, 0.7123, 0.2345, 0.3, 0.5),
    (R, -0.9, 0.3456, 0.3511, 0),
    (R, 0, 0.1, 0.2, 0),
)


@pytest.mark.parametrize(("row", "cells"), [(2, {"d": 0.5123}), (5, {"d": 0.6123}), (3, {"a": 0.3123})])
def test_the_sum_of_offsets_beside_a_plane_of_sliders_is_a_fact(row: int, cells: dict[str, float]) -> None:
    """Nothing else is wrong, and it was told that the entries are too few digits long, for 0.94."""
    policy = Policy(tool=ToolRule.FREE)
    wrong = tables.changed(PLANE, row, **cells)
    assert grade(written(PLANE), written(wrong), policy).score == mark(1, 10)
    for seed in range(4):
        right, answer = (drawn_by_hand(table, Random(seed)) for table in (PLANE, wrong))
        assert right
        assert grade(written(PLANE), written(right), policy).correct
        assert answer
        verdict = grade(written(PLANE), written(answer), policy)
        assert verdict.score == mark(1, 10)
        assert {edit.code for repair in verdict.repairs for edit in repair.edits} & {"a_value", "d_value"}


BESIDE_A_CELL: dict[str, tuple[NumericTable, float]] = {
    "row missing": (replace(tables.PUMA, rows=(*tables.PUMA.rows[:2], *tables.PUMA.rows[3:])), 2),
    "last row missing": (replace(tables.PUMA, rows=tables.PUMA.rows[:5]), 2),
    "row extra": (replace(tables.PUMA, rows=(*tables.PUMA.rows, replace(tables.PUMA.rows[0], a=0.2))), 1),
    "other type": (tables.changed(tables.PUMA, 3, joint=P), 2),
    "forgotten variable": (tables.changed(tables.PUMA, 3, joint=F, theta=0.3), 2),
}


@pytest.mark.parametrize(("wrong", "lost"), BESIDE_A_CELL.values(), ids=BESIDE_A_CELL.keys())
def test_a_wrong_joint_and_a_wrong_cell_cost_what_both_cost(wrong: NumericTable, lost: float) -> None:
    """Two facts and one; what lies about the joint would else be lost as well, and a third leaves less."""
    key, one_more = written(tables.PUMA), tables.changed(wrong, 2, a=0.6)
    assert grade(key, written(wrong), USUAL).score == mark(lost, OF_PUMA)
    both = grade(key, written(one_more), USUAL).score
    assert mark(3, OF_PUMA) <= both < mark(lost, OF_PUMA)
    third = tables.changed(one_more, 1, alpha=0.3)
    assert grade(key, written(third), USUAL).score < both


@pytest.mark.parametrize(("key", "of"), KINDS.values(), ids=KINDS.keys())
def test_of_a_short_arm_a_row_and_all_else_left_out_leave_nothing(key: NumericTable, of: int) -> None:
    """Two edits would mend some of these, and one of them would bring what the other rows lack."""
    zeros = _zeros(key)
    for row in range(len(key.rows)):
        rest = (*zeros.rows[:row], *zeros.rows[row + 1 :])
        assert grade(written(key), written(replace(zeros, rows=rest)), USUAL).score == 0.0
        fixed = tables.changed(zeros, row + 1, joint=F)
        assert grade(written(key), written(fixed), USUAL).score == 0.0


@pytest.mark.parametrize("rows", [(0, 5), (1, 4)])
def test_rows_that_are_missing_apart_cost_what_two_together_do(rows: tuple[int, int]) -> None:
    """Rows 5 and 6, or one of them and row 1 or 2: the links of rows 3 and 4 are right."""

    def score(*missing: int) -> float:
        kept = [row for i, row in enumerate(PUMA_CRAIG) if i not in missing]
        answer: Rows = [(*row[:3], f"q{i}") for i, row in enumerate(kept, start=1)]
        return grade(KEY, read("modified", answer), USUAL, VALUES).score

    assert score(*rows) == score(4, 5) == 0.28


@pytest.mark.parametrize("wrong", [("0.6", 0.2), ("-0.3", -0.26), ("0.6", 1)])
def test_another_wrong_cell_of_a_short_arm_hides_none(wrong: tuple[Cell, Cell]) -> None:
    """A row further up they would stand before the first joint, and the length of the last row is right."""
    key: Rows = [(0, 0, 0, "q1"), (0, 1, 0, "q2"), (0, 1, 0, 0)]
    answer: Rows = with_cells(key, (2, 0, wrong[0]), (2, 1, wrong[1]))
    policy = Policy(tool=ToolRule.FREE)
    assert grade(read("modified", key), read("modified", answer), policy).score == 0.0


def test_the_weights_are_those_that_the_documentation_lists() -> None:
    lines = CHECKER.read_text(encoding="utf-8").splitlines()
    listed = {}
    for line in lines:
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) == 5 and re.fullmatch(r"\d+(\.\d+)?", cells[2]):
            listed |= dict.fromkeys(re.findall(r"`(\w+)`", cells[1]), float(cells[2]))
    assert listed == asdict(Weights())


def test_a_repair_of_one_cell_is_of_a_length_or_a_turn_unless_it_tilts_an_axis() -> None:
    cell = Change("a_value", Extent.CELL, 0, "a")
    found = [
        cell,
        cell._replace(cell="theta"),
        cell._replace(cell="alpha"),
        cell._replace(code="a_sign"),
        cell._replace(extent=Extent.ROW),
    ]
    assert [_is_of_length_or_turn(change) for change in found] == [True, True, False, False, False]


def test_a_rule_that_the_right_robot_breaks_costs_at_most_half_of_what_zeros_lose() -> None:
    """Under the rule `axis` the second length of two links only says where the tool is."""
    key, answer = (read("standard", [(0, 0.5, 0, "q1"), (0, a, 0, "q2")]) for a in (0.3, 0.25))
    for rule in (0.5, 1.0, 100.0):
        weights = Weights(sign=0.1, rule=rule)
        assert grade(key, answer, Policy(tool=ToolRule.AXIS), weights=weights).score == 0.5
