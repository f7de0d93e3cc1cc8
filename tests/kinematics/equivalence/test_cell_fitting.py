"""How frame N moves with a cell of the table."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import numpy as np
import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence.cell_fitting import motion_with_cell
from kinematics.se3 import turns_between
from kinematics.table import CELLS, Convention, DHTable, NumericTable
from tests.kinematics.equivalence.campaign import references
from tests.kinematics.equivalence.generators import random_valid_table

STEP = 1e-4


def _moved(table: NumericTable, row: int, cell: str, step: float) -> NumericTable:
    rows = list(table.rows)
    rows[row] = replace(rows[row], **{cell: getattr(rows[row], cell) + step})  # type: ignore[arg-type]
    return DHTable(convention=table.convention, rows=tuple(rows))


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
