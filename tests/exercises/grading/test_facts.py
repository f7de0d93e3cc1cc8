"""Which facts of a key an answer has: a measure that means something else there is none of them."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from exercises.grading import grade
from exercises.grading.across_prismatic import across_prismatic
from exercises.grading.axis_directions import fixed_ends, fixed_signs
from exercises.grading.facts import Facts
from kinematics.chain import Axis, chain_of_table
from kinematics.equivalence import BaseRule, Policy, ToolRule
from kinematics.equivalence.invariants import axes_of, invariants_of
from kinematics.equivalence.measures import Measure
from kinematics.equivalence.reference import prepared
from kinematics.se3 import ORIGIN, Vector, rotate, rotation_about, unit
from kinematics.table import NumericTable
from tests.exercises.grading.written import read
from tests.kinematics.equivalence.tables import HALF, P, R, standard

FREE = Policy(tool=ToolRule.FREE)
LIFTS = standard(
    (R, HALF, 0.1, 0.4, 0.2),
    (P, 0, 0.2, 0.1, 0),
    (P, HALF, 0.1, 0.2, 0.3),
    (R, 0.7, 0.1, 0.2, 0.1),
    (R, 0, 0.2, 0, 0),
)
PLANE = standard(
    (R, HALF, 0.1, 0.4, 0.2),
    (R, HALF, 0.1, 0.2, 0.3),
    (P, 0.5, 0, 0.1, 0.1),
    (P, 0.6, 0, 0.1, 0),
    (P, HALF, 0, 0.1, 0.4),
    (R, HALF, 0.2, 0.1, 0.3),
    (R, 0, 0.1, 0.1, 0),
)


def facts_of(key: NumericTable) -> Facts:
    invariants = invariants_of(prepared(key), FREE)
    axes = axes_of(chain_of_table(key), FREE)
    worth = np.ones(len(invariants.shapes))
    return Facts(axes, invariants, fixed_ends(len(axes), FREE), worth, sign=0.5)


def turned(axes: Sequence[Axis], i: int, about: Vector, angle: float) -> list[Axis]:
    """The axes, one of them turned."""
    turn = rotation_about(ORIGIN, unit(about), math.cos(angle), math.sin(angle))
    return [
        axis._replace(direction=rotate(turn, axis.direction)) if k == i else axis
        for k, axis in enumerate(axes)
    ]


def place_of(facts: Facts, measure: Measure) -> int:
    (place,) = (q for q, shape in enumerate(facts.invariants.shapes) if shape.measure is measure)
    return place


def test_a_turn_about_sliders_is_none_where_they_are_not_parallel() -> None:
    """Even if it has the same value: it is measured about the first of them."""
    facts = facts_of(LIFTS)
    turn = place_of(facts, Measure.TURN)
    assert facts.invariants.shapes[turn].axes == (1, 2, 4)
    assert facts.shared(facts.axes).all()
    assert not facts.shared(turned(facts.axes, 3, (1.0, 0.0, 0.0), 0.1))[turn]


def test_a_turn_about_sliders_is_one_whatever_comes_behind_its_second_axis() -> None:
    """There the next axis is parallel, and in the key it is not."""
    facts = facts_of(LIFTS)
    turn = place_of(facts, Measure.TURN)
    level = facts.axes[5]._replace(direction=facts.axes[4].direction)
    found = facts.shared([*facts.axes[:5], level, *facts.axes[6:]])
    assert found[turn]
    assert not found.all()


def test_an_offset_past_sliders_is_none_where_they_are_no_longer_parallel() -> None:
    """Even if it has the same value: of two sliders it is measured beside the second."""
    facts = facts_of(LIFTS)
    offset = place_of(facts, Measure.OFFSET)
    assert facts.invariants.shapes[offset].axes == (1, 4, 4, 5, 3, 4)
    assert not facts.shared(turned(facts.axes, 2, (1.0, 0.0, 0.0), 0.5))[offset]


def test_facts_across_sliders_are_those_that_no_neighbours_have() -> None:
    """The angle about them, the offset past them, and no angle or length beside them."""
    facts = facts_of(LIFTS)
    (across,) = across_prismatic(facts)
    shapes = [shape for shape, is_across in zip(facts.invariants.shapes, across, strict=True) if is_across]
    assert shapes == [(Measure.TURN, (1, 2, 4)), (Measure.OFFSET, (1, 4, 4, 5, 3, 4))]


def test_each_group_of_sliders_has_facts_of_its_own() -> None:
    key = standard(*((joint, HALF, 0.1, 0.2, 0.3) for joint in (R, P, R, P, R)))
    facts = facts_of(key)
    shapes = facts.invariants.shapes
    turns = [[shapes[q].axes for q in np.flatnonzero(across)] for across in across_prismatic(facts)]
    assert [[axes for axes in group if len(axes) == 3] for group in turns] == [[(1, 2, 3)], [(3, 4, 5)]]


def test_frames_that_are_fixed_fix_which_way_the_ends_point() -> None:
    for base in BaseRule:
        for tool in ToolRule:
            ends = fixed_ends(5, Policy(base=base, tool=tool))
            assert ends == (0,) * (base is BaseRule.FRAME) + (4,) * (tool is ToolRule.FRAME)


def test_a_sum_of_offsets_is_none_where_the_sliders_are_not_in_one_plane() -> None:
    """Even if it has the same value: it is measured across the plane of the first two."""
    facts = facts_of(PLANE)
    total = place_of(facts, Measure.SUM)
    assert facts.invariants.shapes[total].axes == (3, 4, 2, 2, 1, 2, 6, 6, 7, 6)
    assert facts.shared(facts.axes).all()
    assert not facts.shared(turned(facts.axes, 5, facts.axes[4].direction, 0.5))[total]


def test_a_row_of_zeros_may_be_a_joint_whose_variable_was_forgotten() -> None:
    """Of the type that the key has there: a slider behind a turning joint."""
    key = read("standard", [("pi/2", 0.3, 0.2, "q1"), (0, 0, "q2", 0), ("pi/2", 0.1, 0.2, "q3")])
    answer = read("standard", [("pi/2", 0.3, 0.2, "q1"), (0, 0, 0, 0), ("pi/2", 0.1, 0.2, "q2")])
    verdict = grade(key, answer, FREE)
    assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("joint_fixed", 2)]


def test_a_sign_is_fixed_where_no_axis_that_it_depends_on_may_be_turned() -> None:
    """An offset depends on the direction of the axes that it runs along, all else on that of both ends."""
    level = standard((R, HALF, 0.1, 0.4, 0), (R, 0, 0.3, 0.1, 0), (R, 0.7, 0.2, 0.2, 0), (R, 0, 0.2, 0, 0))
    shapes = invariants_of(prepared(level), FREE).shapes
    assert Measure.OFFSET in {shape.measure for shape in shapes}
    everything = tuple(range(level.n_joints + 2))
    for shape in shapes:
        along = shape.axes[1:2] if shape.measure is Measure.OFFSET else shape.axes[:2]
        assert fixed_signs((shape,), tuple(along)) == [0]
        for axis in along:
            assert fixed_signs((shape,), tuple(other for other in everything if other != axis)) == []
    assert fixed_signs(shapes, everything) == list(range(len(shapes)))


def test_a_joint_that_is_missing_and_one_of_another_type_each_take_a_share_of_what_is_right() -> None:
    """The one leaves four fifths of it, the other three fifths of that."""
    key = standard(
        (R, 1.1, 0.3, 0.2, 0),
        (R, 0.8, 0.1, 0.4, 0),
        (R, -0.9, 0.5, 0.3, 0),
        (P, 1.3, 0.2, 0.2, 0),
        (R, 0.4, 0.2, 0.1, 0),
    )
    facts, count = facts_of(key), 9.0
    assert len(facts.invariants.shapes) == count
    for joint in (None, 2, 3, 4, 5):
        axes = [facts.axes[0], *facts.axes[2:]]
        if joint is not None:
            axes[joint - 1] = axes[joint - 1]._replace(prismatic=not axes[joint - 1].prismatic)
        right = count - replace(facts, to_earn=count).wrong(axes)
        left = count - replace(facts, to_earn=count, joint=0.2, type=0.4).wrong(axes)
        assert left == pytest.approx(right * (0.8 if joint is None else 0.8 * 0.6))
