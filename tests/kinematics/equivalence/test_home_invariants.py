"""Angles and distances of axes that are no neighbours: any right table has them where its joints are zero."""

import math
from dataclasses import replace
from random import Random

import pytest

from exercises.grading.axis_directions import fixed_signs, least_cost
from kinematics.equivalence import BaseRule, DirectionRule, Policy, ToolRule, ZeroRule, decide
from kinematics.equivalence.batches import axes_of_tables
from kinematics.equivalence.decision import EXACT
from kinematics.equivalence.home_invariants import home_invariants_of
from kinematics.equivalence.invariants import invariants_of
from kinematics.equivalence.measures import Measure
from kinematics.equivalence.reference import prepared
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable
from tests.kinematics.equivalence.campaign import catalogue, references
from tests.kinematics.equivalence.generators import random_valid_table

FREE = Policy(tool=ToolRule.FREE, tolerance=EXACT)
STRICT = replace(FREE, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)
ROBOTS = [robot for robot in references() if robot[1].n_joints > 2][:60]


def in_the_figure(key: NumericTable, table: NumericTable) -> NumericTable:
    """A right table, its variables counted and zero as the key's are."""
    certificate = decide(key, table, FREE).certificate
    assert certificate is not None
    rows = list(table.rows)
    signs, offsets = certificate.joint_signs, certificate.joint_offsets
    for index, sign, offset in zip(table.joint_rows, signs, offsets, strict=True):
        row = rows[index]
        cell = "theta" if row.joint is JointType.REVOLUTE else "d"
        moved = {cell: getattr(row, cell) + row.sign * offset}
        rows[index] = replace(row, sign=row.sign * sign, **moved)
    return DHTable(convention=table.convention, rows=tuple(rows))


@pytest.mark.parametrize("robot", ROBOTS, ids=[name for name, _ in ROBOTS])
def test_every_right_table_has_them(robot: tuple[str, NumericTable]) -> None:
    name, key = robot
    table = in_the_figure(key, random_valid_table(key, Random(name)))
    assert decide(key, table, STRICT).accepted
    reference = prepared(key)
    invariants = invariants_of(reference, STRICT).beside(home_invariants_of(reference, STRICT))
    found = invariants.measured(axes_of_tables([table], [(0, ())], STRICT))
    assert (invariants.strains(found) <= 1.0).all()
    joints = tuple(range(1, key.n_joints + 1))
    fits, _ = invariants.fits(found)
    assert fits[fixed_signs(invariants.shapes, joints)].all()
    costs = (~fits).astype(float)[None].repeat(2, axis=0)
    assert least_cost(invariants.shapes, key.n_joints + 2, costs, joints) == 0.0


def test_free_zeros_have_none_and_fixed_frames_count_as_axes() -> None:
    reference = prepared(dict(catalogue())["puma560"])
    assert not home_invariants_of(reference, FREE).shapes
    within = home_invariants_of(reference, STRICT).shapes
    frames = replace(STRICT, base=BaseRule.FRAME, tool=ToolRule.FRAME)
    assert set(within) < set(home_invariants_of(reference, frames).shapes)
    assert all(shape.axes[1] - shape.axes[0] > 1 for shape in within)


@pytest.mark.parametrize("base", list(BaseRule))
@pytest.mark.parametrize("tool", list(ToolRule))
def test_every_pair_of_axes_that_are_no_neighbours_has_an_angle(base: BaseRule, tool: ToolRule) -> None:
    """As far as four axes apart, with those that stand for the frames or points that a policy fixes."""
    reference = prepared(dict(catalogue())["puma560"])
    policy = replace(STRICT, base=base, tool=tool)
    first = 0 if base in (BaseRule.ORIGIN, BaseRule.FRAME) else 1
    last = 7 if tool in (ToolRule.POINT, ToolRule.FRAME) else 6
    found = {shape.axes[:2] for shape in home_invariants_of(reference, policy).shapes if shape.is_angle}
    assert found == {(i, j) for i in range(first, last) for j in range(i + 2, last + 1) if j - i <= 4}


def test_along_parallel_axes_a_slider_has_a_place_where_its_zero_is_fixed() -> None:
    """From the base's origin to the tool's: 0.5 up, turned over by 180°, then 0.1 down."""
    row = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=0.0, alpha=0.0)
    rows = (
        replace(row, d=0.5),
        replace(row, a=0.3, alpha=math.pi),
        replace(row, joint=JointType.PRISMATIC),
        replace(row, a=0.2, d=0.1),
    )
    reference = prepared(DHTable(convention=Convention.MODIFIED, rows=rows))
    frames = replace(STRICT, base=BaseRule.FRAME, tool=ToolRule.FRAME)
    found = home_invariants_of(reference, frames)
    (place,) = (i for i, shape in enumerate(found.shapes) if shape.measure is Measure.OFFSET)
    assert found.shapes[place].axes == (0, 0, 5, 5)
    assert found.values[place, 0] == pytest.approx(0.5 - 0.1)
    for one_end in (replace(frames, base=BaseRule.AXIS), replace(frames, tool=ToolRule.AXIS)):
        shapes = home_invariants_of(reference, one_end).shapes
        assert all(shape.measure is not Measure.OFFSET for shape in shapes)
