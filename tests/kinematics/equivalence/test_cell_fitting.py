"""Cells with which a table would be the robot, and how frame N moves with a cell."""

from dataclasses import replace
from random import Random

import numpy as np
import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy, Tolerance, ToolRule, decide
from kinematics.equivalence.cell_fitting import fitted_cells, motion_with_cell
from kinematics.equivalence.meter import PER_ROUND, Meter
from kinematics.equivalence.reference import prepared
from kinematics.se3 import turns_between
from kinematics.table import CELLS, Convention, DHTable, NumericTable
from tests.kinematics.equivalence.campaign import references
from tests.kinematics.equivalence.generators import random_robot, random_valid_table
from tests.kinematics.equivalence.tables import R, standard

STEP = 1e-4
FREE = Policy(tool=ToolRule.FREE)
TOLERANCE = Tolerance(length=1e-3, angle=1e-3)


def _moved(table: NumericTable, row: int, cell: str, step: float) -> NumericTable:
    rows = list(table.rows)
    rows[row] = replace(rows[row], **{cell: getattr(rows[row], cell) + step})  # type: ignore[arg-type]
    return DHTable(convention=table.convention, rows=tuple(rows))


def _answer(seed: int) -> tuple[NumericTable, NumericTable, tuple[int, ...]]:
    """A key, a right answer to it, and which of its variables are reversed."""
    rng = Random(f"fitting {seed}")
    key = random_robot(rng, joints=rng.randint(3, 5))
    table = random_valid_table(key, rng, dummies=0.2)
    certificate = decide(key, table, FREE).certificate
    assert certificate is not None
    return key, table, certificate.joint_signs


@pytest.mark.parametrize("seed", range(12))
def test_wrong_cells_are_found_together(seed: int) -> None:
    """A length and a twist of other rows, each off by so much as a student may be off."""
    key, right, signs = _answer(seed)
    rng = Random(f"wrong {seed}")
    first, second = rng.sample(range(len(right.rows)), 2)
    size = prepared(key).size
    table = _moved(_moved(right, first, rng.choice(("a", "d")), 0.2 * size), second, "alpha", 0.2)
    places = [(row, cell) for row in (first, second) for cell in CELLS]
    found = fitted_cells(prepared(key), table, places, signs, TOLERANCE, Meter(10**9))
    assert found is not None
    assert decide(key, found, replace(FREE, tolerance=TOLERANCE)).accepted
    kept = [(row, cell) for row in range(len(table.rows)) for cell in CELLS if (row, cell) not in places]
    assert all(getattr(found.rows[row], cell) == getattr(table.rows[row], cell) for row, cell in kept)
    assert all(
        abs(row.alpha) <= np.pi and abs(row.theta) <= np.pi for row in (found.rows[first], found.rows[second])
    )


@pytest.mark.parametrize("cell", ["a", "alpha"])
def test_what_is_off_by_less_than_half_the_tolerance_is_left_as_it_is(cell: str) -> None:
    """What lies between the only two axes is off by so much in the mean of all configurations."""
    key = standard((R, 0.7, 0.5, 0.2, 0.1), (R, -0.9, 0.4, 0.3, 0.2))
    unit = TOLERANCE.angle if cell == "alpha" else TOLERANCE.length * prepared(key).size
    meter = Meter(10**9)
    almost, off = (_moved(key, 0, cell, share * unit) for share in (0.45, 0.55))
    assert fitted_cells(prepared(key), almost, [(0, cell)], (1, 1), TOLERANCE, meter) is almost
    assert meter.left == 10**9 - PER_ROUND
    mended = fitted_cells(prepared(key), off, [(0, cell)], (1, 1), TOLERANCE, meter)
    assert mended is not None
    assert getattr(mended.rows[0], cell) == pytest.approx(getattr(key.rows[0], cell), abs=0.1 * unit)


@pytest.mark.parametrize("seed", range(4))
def test_cells_that_cannot_mend_it_are_given_up(seed: int) -> None:
    """A twist is off, and an offset may change; or variables are reversed that are not."""
    key, right, signs = _answer(seed)
    table = _moved(right, 1, "alpha", 0.3)
    meter = Meter(10**9)
    assert fitted_cells(prepared(key), table, [(0, "d")], signs, TOLERANCE, meter) is None
    other = tuple(-sign if i == 1 else sign for i, sign in enumerate(signs))
    assert fitted_cells(prepared(key), right, [(0, "d")], other, TOLERANCE, meter) is None
    assert meter.left > 10**9 - 2 * 10 * PER_ROUND


@pytest.mark.parametrize("convention", list(Convention))
def test_the_motion_with_a_cell_is_the_limit_of_differences(convention: Convention) -> None:
    """Fixed rows, reversed variables and sliders among them, at configurations all round."""
    rng, draw = Random(f"cells {convention}"), np.random.default_rng(1)
    tables = [random_valid_table(reference, rng) for _, reference in references()[:60]]
    alike = [table for table in tables if table.convention is convention]
    assert len(alike) > 20
    for table in alike:
        chain = chain_of_table(table)
        joints = draw.uniform(-3.0, 3.0, (5, chain.n_joints))
        frames = chain.frames(joints)
        for row in range(len(table.rows)):
            for cell in CELLS:
                before, after = (
                    chain_of_table(_moved(table, row, cell, step)).poses(joints) for step in (-STEP, STEP)
                )
                shift = after[:, :3, 3] - before[:, :3, 3]
                quotient = np.concatenate([turns_between(before, after), shift], axis=1) / (2.0 * STEP)
                found = motion_with_cell(table, (row, cell), frames)
                assert found == pytest.approx(quotient, abs=1e-7 * max(1.0, chain.extent))
