"""SCM2DH: the table moves as the chain does, symbols and all."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.errors import DescriptionError
from kinematics.expressions import pi_fraction
from kinematics.forward import forward_kinematics
from kinematics.scm import RawChain, modified_dh_from_scm, read_chain
from kinematics.table import Convention, JointType, bind, table_parameters

from .chains import ENTRIES, STANFORD, chain_of, product, strict_chains


@given(strict_chains(), st.randoms(use_true_random=False))
def test_table_equals_product_of_elementary_motions(chain, random):
    rows, final, tool = chain
    read = read_chain(RawChain(joints=tuple(rows), final=final, tool=tool))
    table = modified_dh_from_scm(read.chain)
    numbers = {name: random.uniform(-2, 2) for name in read.parameters}
    q = [random.uniform(-7, 7) for _ in rows]
    expected = np.eye(4)
    for i, (cells, value) in enumerate(zip(rows, q, strict=True), start=1):
        expected = expected @ product(cells, numbers, f"q{i}", value)
    for end in (final, tool):
        expected = expected @ product({e: _canonical(end[e]) for e in ENTRIES}, numbers)
    found = forward_kinematics(bind(table, numbers), q).transform
    np.testing.assert_allclose(found, expected, atol=1e-12)


def _canonical(cell):
    return cell.replace("_", "") if isinstance(cell, str) else cell


@given(strict_chains())
def test_every_joint_keeps_its_type_and_no_length_is_lost(chain):
    rows, final, tool = chain
    read = read_chain(RawChain(joints=tuple(rows), final=final, tool=tool))
    table = modified_dh_from_scm(read.chain)
    assert table.convention is Convention.MODIFIED
    assert table.joint_types == tuple(row.joint for row in read.chain.rows)
    assert set(table_parameters(table)) == set(read.parameters)


def test_stanford_is_the_textbook_table():
    table = modified_dh_from_scm(chain_of(*STANFORD).chain)
    alphas = [pi_fraction(row.alpha) for row in table.rows]
    half = Fraction(1, 2)
    assert alphas == [0, -half, half, 0, -half, half]
    assert all(pi_fraction(row.theta) == 0 for row in table.rows)
    assert [row.joint for row in table.rows].count(JointType.PRISMATIC) == 1
    assert len(table.rows) == 6


def test_chain_that_fails_the_check_is_refused_with_its_reasons():
    chain = chain_of((0, 0, 0, "q1+pi/2", 0, 0), ("q2", 0, "L1", 0, 0, 0)).chain
    with pytest.raises(DescriptionError) as refusal:
        modified_dh_from_scm(chain)
    assert [fault.code for fault in refusal.value.faults] == [
        "scm_revolute_offset",
        "scm_prismatic_second_length",
    ]
