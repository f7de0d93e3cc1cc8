"""The campaigns with small counts; `make campaign` runs them at length."""

from random import Random

import numpy as np
import pytest

from exercises.grading.axis_directions import least_cost
from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy, Tolerance, ToolRule
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.invariants import axes_of, invariants_of
from kinematics.equivalence.reference import prepared
from tests.kinematics.equivalence.campaign import (
    Outcome,
    references,
    rounded_tables,
    strict_tables,
    valid_tables,
    wrong_tables,
)
from tests.kinematics.equivalence.generators import random_valid_table


@pytest.mark.parametrize("block", range(6))
def test_valid_tables_are_accepted(block: int) -> None:
    outcome = valid_tables(block)
    assert outcome.failures == []
    assert outcome.accepted == outcome.tables
    assert outcome.residual <= 1e-9


@pytest.mark.parametrize("block", range(2))
def test_tables_that_keep_strict_rules_are_accepted(block: int) -> None:
    outcome = strict_tables(block)
    assert outcome.failures == []
    assert outcome.accepted == outcome.confirmed == outcome.tables
    assert outcome.residual <= 1e-9


@pytest.mark.parametrize("block", range(3))
def test_valid_tables_with_rounded_entries_are_accepted(block: int) -> None:
    outcome = rounded_tables(block)
    assert outcome.failures == []
    assert outcome.accepted == outcome.tables
    assert outcome.left_out <= 1


def test_wrong_tables_are_rejected_or_have_a_certificate_that_stands() -> None:
    total = Outcome()
    for block in range(4):
        total += wrong_tables(block)
    assert total.failures == []
    assert 0 < total.confirmed == total.accepted < total.tables
    assert len(total.kinds) > 15


def test_invariants_are_shared_by_all_valid_tables() -> None:
    """In size; and, with every axis turned as it suits best, in sign."""
    policy = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=1e-8, angle=1e-8))
    rng = Random("invariants")
    for _, reference in references():
        invariants = invariants_of(prepared(reference), policy)
        table = random_valid_table(reference, rng)
        axes = axis_batch([axes_of(chain_of_table(table), policy)])
        found = invariants.measured(axes)
        assert (invariants.strains(found) <= 1.0).all()
        costs = ~np.array(invariants.fits(found))
        assert least_cost(invariants.shapes, len(reference.joint_rows) + 2, costs.astype(float)) == 0.0
