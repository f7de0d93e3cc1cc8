"""QRAND: random configurations within limits."""

import math

import numpy as np
import pytest

from kinematics.errors import JointValueError
from kinematics.scm import default_limits, random_configurations

from .chains import STANFORD, STANFORD_LENGTHS, chain_of


def test_default_limits_are_full_turns_and_the_sum_of_lengths():
    limits = default_limits(chain_of(*STANFORD).chain, STANFORD_LENGTHS)
    total = pytest.approx(0.412 + 0.154 + 0.263)
    assert limits == ((-math.pi, math.pi),) * 2 + ((0.0, total),) + ((-math.pi, math.pi),) * 3


def test_a_slider_without_any_length_goes_up_to_one():
    assert default_limits(chain_of(("d1", 0, 0, 0, 0, 0)).chain, {}) == ((0.0, 1.0),)


def test_values_lie_within_the_limits_and_follow_the_seed():
    limits = ((-1.0, 1.0), (0.5, 0.5), (-3.0, -2.0))
    drawn = random_configurations(limits, count=200, seed=7)
    low, high = np.array(limits).T
    assert drawn.shape == (200, 3)
    assert ((low <= drawn) & (drawn <= high)).all()
    np.testing.assert_array_equal(drawn, random_configurations(limits, count=200, seed=7))
    assert not np.array_equal(drawn, random_configurations(limits, count=200, seed=8))
    assert np.ptp(drawn[:, 0]) > 1.5


@pytest.mark.parametrize("pair", [(1.0, 0.0), (math.nan, 1.0), (0.0, math.inf)])
def test_limits_that_are_none(pair):
    with pytest.raises(JointValueError) as caught:
        random_configurations(((0.0, 1.0), pair))
    assert [(fault.code, fault.where) for fault in caught.value.faults] == [
        ("scm_limits_reversed", ("limits", 1))
    ]


def test_a_range_wider_than_the_largest_double():
    widest = 1.7e308
    drawn = random_configurations(((-widest, widest), (0.0, 1.0)), count=200, seed=1)
    assert np.isfinite(drawn).all()
    assert (drawn[:, 0] < 0).any()
    assert (drawn[:, 0] > 0).any()
    np.testing.assert_array_equal(drawn[:, 1], random_configurations(((0, 1), (0, 1)), 200, seed=1)[:, 1])
    chain = chain_of(("d1", 0, 0, 0, 0, 0), ("L1", 0, 0, "a2", 0, 0), ("L2", 0, 0, "a3", 0, 0)).chain
    assert default_limits(chain, {"L1": widest, "L2": widest})[0][1] > widest
