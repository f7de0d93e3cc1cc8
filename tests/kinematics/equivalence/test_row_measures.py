"""Invariants read off the rows of tables are those that are measured between the axes."""

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest

from kinematics.equivalence import BaseRule, Policy, ToolRule, row_measures
from kinematics.equivalence.batches import Variation, axes_of_tables
from kinematics.equivalence.invariants import invariants_of
from kinematics.equivalence.measures import Measure, measured
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.row_measures import measured_of_tables
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable

FREE = Policy(tool=ToolRule.FREE)
RIGHT = (0.0, math.pi / 2, -math.pi / 2, math.pi)
# The distance of parallel axes is measured as a root of a difference of squares, which loses half the digits.
SAME = 1e-7


def arm(rng: Random) -> NumericTable:
    def row() -> DHRow[float]:
        alpha = rng.choice((*RIGHT, rng.uniform(-3.0, 3.0), rng.choice((1e-9, 1e-4))))
        return DHRow(
            joint=JointType.REVOLUTE,
            theta=rng.uniform(-3.0, 3.0),
            d=rng.choice((0.0, rng.uniform(-1.0, 1.0))),
            a=rng.choice((0.0, rng.uniform(-1.0, 1.0))),
            alpha=alpha,
            sign=1 if rng.random() < 0.95 else -1,
        )

    return DHTable(convention=rng.choice(list(Convention)), rows=tuple(row() for _ in range(6)))


def variations(table: NumericTable, rng: Random) -> list[Variation]:
    found: list[Variation] = [(0, ())]
    for row in range(len(table.rows)):
        found += [(0, ((row, "alpha", rng.choice((*RIGHT, 1.0, 1e-8))),)), (0, ((row, "a", -0.4),))]
        found += [(0, ((row, "d", rng.choice((0.0, 0.7))), (row, "theta", 1.0)))]
    return found


@pytest.mark.parametrize("number", range(60))
def test_what_is_read_is_what_is_measured(number: int) -> None:
    rng = Random(f"row measures {number}")
    key, answer = arm(rng), arm(rng)
    shapes = invariants_of(prepared(key), FREE).shapes
    for table in (key, answer):
        tried = variations(table, rng)
        read = measured_of_tables(shapes, [table], tried, FREE)
        np.testing.assert_allclose(
            read, measured(shapes, axes_of_tables([table], tried, FREE)), rtol=0.0, atol=SAME
        )


@pytest.mark.parametrize("base", BaseRule)
@pytest.mark.parametrize("tool", ToolRule)
@pytest.mark.parametrize("sliders", range(3))
def test_what_is_fixed_at_the_ends_and_sliders_are_measured_as_well(
    base: BaseRule, tool: ToolRule, sliders: int
) -> None:
    rng, policy = Random(f"ends {base} {tool} {sliders}"), Policy(base=base, tool=tool)
    for _ in range(4):
        key = arm(rng)
        rows = list(key.rows)
        for row in rng.sample(range(6), sliders):
            rows[row] = replace(rows[row], joint=JointType.PRISMATIC)
        key = DHTable(convention=key.convention, rows=tuple(rows))
        shapes = invariants_of(prepared(key), policy).shapes
        tried = variations(key, rng)
        read = measured_of_tables(shapes, [key], tried, policy)
        wanted = measured(shapes, axes_of_tables([key], tried, policy))
        np.testing.assert_allclose(read, wanted, rtol=0.0, atol=SAME)


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize("before", [0, 1, 2])
def test_no_axis_is_carried_through_space_where_a_row_leads_to_every_joint(
    convention: Convention, before: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Skew, right and parallel axes, some of them pointing the other way, behind rows of the base."""
    foot = DHRow(joint=JointType.FIXED, theta=0.3, d=0.2, a=0.1, alpha=0.4)
    alphas = (math.pi / 2, 0.0, math.pi, -0.7, 0.0, 1.0)
    rows = [
        DHRow(joint=JointType.REVOLUTE, theta=0.1, d=0.1 * k, a=0.5, alpha=alpha)
        for k, alpha in enumerate(alphas)
    ]
    table = DHTable(convention=convention, rows=(*[foot] * before, *rows))
    shapes = invariants_of(prepared(table), FREE).shapes
    wanted = measured(shapes, axes_of_tables([table], [(0, ())], FREE))
    monkeypatch.delattr(row_measures, "axes_of_tables")
    np.testing.assert_allclose(measured_of_tables(shapes, [table], [(0, ())], FREE), wanted, atol=SAME)


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize("twist", [0.0, math.pi, 0.4, -math.pi / 2])
@pytest.mark.parametrize("link", [0, 2, 3, 4])
def test_nor_where_an_answer_has_a_wrong_twist(
    link: int, twist: float, convention: Convention, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Axes that are parallel by mistake leave no foot behind a run; one that is not ends the run askew."""
    alphas = (math.pi / 2, 0.0, math.pi, -0.7, 0.0, 1.0)
    if convention is Convention.MODIFIED:
        alphas = (1.0, *alphas[:-1])
    rows = tuple(
        DHRow(joint=JointType.REVOLUTE, theta=0.5 + k, d=0.1 + 0.2 * k, a=0.5 - 0.3 * k, alpha=alpha)
        for k, alpha in enumerate(alphas)
    )
    table = DHTable(convention=convention, rows=rows)
    shapes = invariants_of(prepared(table), FREE).shapes
    tried: list[Variation] = [(0, ((link + (convention is Convention.MODIFIED), "alpha", twist),))]
    wanted = measured(shapes, axes_of_tables([table], tried, FREE))
    monkeypatch.delattr(row_measures, "axes_of_tables")
    np.testing.assert_allclose(measured_of_tables(shapes, [table], tried, FREE), wanted, atol=SAME)


def test_several_tables_are_read_side_by_side() -> None:
    rng = Random("several")
    key = arm(rng)
    other = DHTable(
        convention=next(one for one in Convention if one is not key.convention),
        rows=tuple(replace(row, a=row.a + 0.1) for row in key.rows),
    )
    shapes = invariants_of(prepared(key), FREE).shapes
    tried: list[Variation] = [(0, ()), (1, ()), (1, ((2, "d", 0.3),)), (0, ((2, "d", 0.3),))]
    read = measured_of_tables(shapes, [key, other], tried, FREE)
    np.testing.assert_allclose(
        read, measured(shapes, axes_of_tables([key, other], tried, FREE)), rtol=0.0, atol=SAME
    )


def test_the_rows_of_a_puma_are_its_facts() -> None:
    """Craig's table: all angles are right or zero, and a2, a3, d3, d4 are its lengths and offsets."""
    half = math.pi / 2
    entries = [(0, 0, 0), (-half, 0, 0), (0, 0.43, 0.15), (-half, 0.02, 0.36), (half, 0, 0), (-half, 0, 0)]
    table = DHTable(
        convention=Convention.MODIFIED,
        rows=tuple(
            DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha) for alpha, a, d in entries
        ),
    )
    shapes = invariants_of(prepared(table), FREE).shapes
    read = dict(zip(shapes, measured_of_tables(shapes, [table], [(0, ())], FREE)[:, 0].tolist(), strict=True))
    lengths = [abs(value) for shape, value in read.items() if shape.measure is not Measure.ANGLE and value]
    assert sorted(lengths) == [0.02, 0.15, 0.36, 0.43]
