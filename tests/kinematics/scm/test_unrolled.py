"""A table for every chain: it moves as the chain does, whatever the chain's form."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kinematics.forward import forward_kinematics
from kinematics.scm import (
    forward_kinematics_scm,
    modified_dh_from_scm,
    table_of_chain,
    unrolled_dh_from_scm,
    verify,
)
from kinematics.table import bind

from .chains import STANFORD, chain_of, loose_chains


@given(chain=loose_chains(), random=st.randoms(use_true_random=False))
def test_the_table_moves_as_the_chain(chain, random):
    numbers = {name: random.uniform(-2, 2) for name in chain.parameters}
    q = [random.uniform(-4, 4) for _ in chain.chain.rows]
    expected = forward_kinematics_scm(chain.chain, q, numbers).transform
    for table in (table_of_chain(chain.chain), unrolled_dh_from_scm(chain.chain)):
        found = forward_kinematics(bind(table, numbers), q).transform
        np.testing.assert_allclose(found, expected, atol=1e-12)
        assert table.joint_types == tuple(row.joint for row in chain.chain.rows)


def test_a_chain_that_passes_the_check_gets_the_table_that_a_person_would_write():
    chain = chain_of(*STANFORD).chain
    assert not verify(chain)
    assert table_of_chain(chain) == modified_dh_from_scm(chain)
