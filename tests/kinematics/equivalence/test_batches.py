"""Many tables at once give what each gives by itself."""

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import BaseRule, Policy, ToolRule
from kinematics.equivalence.batches import CellChange, axes_of_tables
from kinematics.equivalence.invariants import axes_of, invariants_of
from kinematics.equivalence.measures import Measure
from kinematics.equivalence.reference import prepared
from kinematics.table import CELLS, Convention, DHRow, DHTable, JointType, NumericTable
from tests.kinematics.equivalence.campaign import references
from tests.kinematics.equivalence.generators import random_valid_table

POLICIES = [
    Policy(),
    Policy(tool=ToolRule.FREE),
    Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME),
    Policy(base=BaseRule.ORIGIN, tool=ToolRule.POINT),
]


def changed(table: NumericTable, changes: tuple[CellChange, ...]) -> NumericTable:
    rows = list(table.rows)
    for i, cell, value in changes:
        rows[i] = replace(rows[i], **{cell: value})
    return DHTable(convention=table.convention, rows=tuple(rows))


def some_changes(table: NumericTable, rng: Random) -> tuple[CellChange, ...]:
    return tuple(
        (
            rng.randrange(len(table.rows)),
            rng.choice(CELLS),
            rng.choice((math.pi / 2, 0.0, rng.uniform(-1, 1))),
        )
        for _ in range(rng.randrange(4))
    )


@pytest.mark.parametrize("policy", POLICIES)
def test_axes_of_many_tables_are_those_of_each(policy: Policy) -> None:
    """Both conventions, fixed rows and reversed variables side by side; as lines, for points may slide."""
    rng = Random("batches")
    for _, reference in references()[:60]:
        tables = [random_valid_table(reference, rng) for _ in range(4)]
        variations = [(i, some_changes(tables[i], rng)) for i in (0, 1, 2, 3, 1, 3)]
        batch = axes_of_tables(tables, variations, policy)
        for k, (i, changes) in enumerate(variations):
            alone = axes_of(chain_of_table(changed(tables[i], changes)), policy)
            for m, axis in enumerate(alone):
                direction, gap = batch.directions[m, :, k], batch.points[m, :, k] - axis.point
                assert direction == pytest.approx(axis.direction, abs=1e-12)
                assert np.cross(gap, direction) == pytest.approx(0.0, abs=1e-12)
            for end in (0, -1):  # offsets are counted from the very points
                assert batch.points[end, :, k] == pytest.approx(alone[end].point, abs=1e-12)


def test_what_is_measured_of_a_table_known_by_hand() -> None:
    """A = 0.3, α = 90°, d = −0.2 between normals, then a = 0.5; and the same with z_1 turned round."""
    right = math.pi / 2
    rows = [(right, 0.3, 0.0), (right, 0.0, -0.2), (0.0, 0.5, 0.0)]
    table = DHTable(
        convention=Convention.STANDARD,
        rows=tuple(DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha) for alpha, a, d in rows),
    )
    invariants = invariants_of(prepared(table), Policy(tool=ToolRule.FREE))
    expected = {
        (Measure.ANGLE, (1, 2)): right,
        (Measure.DISTANCE, (1, 2, 1, 2)): 0.3,
        (Measure.ANGLE, (2, 3)): right,
        (Measure.DISTANCE, (2, 3, 2, 3)): 0.0,
        (Measure.OFFSET, (1, 2, 2, 3)): -0.2,
    }
    found = {
        tuple(shape): value
        for shape, value in zip(invariants.shapes, invariants.values[:, 0].tolist(), strict=True)
    }
    assert found.keys() == expected.keys()
    assert {key: abs(value) for key, value in found.items()} == pytest.approx(
        {key: abs(value) for key, value in expected.items()}
    )
    assert found[Measure.OFFSET, (1, 2, 2, 3)] == pytest.approx(-0.2)
    assert found[Measure.DISTANCE, (1, 2, 1, 2)] == pytest.approx(0.3)
    turned = invariants.reversed(invariants.values)
    assert turned[list(found).index((Measure.DISTANCE, (1, 2, 1, 2)))] == pytest.approx(-0.3)
    assert turned[list(found).index((Measure.OFFSET, (1, 2, 2, 3)))] == pytest.approx(0.2)
    assert turned[list(found).index((Measure.ANGLE, (1, 2)))] == pytest.approx(math.pi - right)
