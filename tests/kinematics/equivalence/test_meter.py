"""Work is counted: what costs more on a machine costs more of it, and what is used up is used up."""

import pytest

from kinematics.equivalence.meter import (
    MOST_ROWS_OF_A_ROBOT,
    OVERDRAFT,
    Meter,
    WorkExhaustedError,
    per_batch,
    per_certificate,
)


def test_every_row_beyond_those_of_a_robot_costs_each_table_more() -> None:
    def of_a_table(rows: int) -> float:
        return (per_batch(2000, rows, 12) - per_batch(1000, rows, 12)) / 1000

    assert of_a_table(MOST_ROWS_OF_A_ROBOT) - of_a_table(6) < 1.0
    assert of_a_table(MOST_ROWS_OF_A_ROBOT + 40) - of_a_table(MOST_ROWS_OF_A_ROBOT) > 20.0


def test_only_arms_of_many_joints_make_a_certificate_dearer() -> None:
    assert per_certificate(2) == per_certificate(7) < per_certificate(8) < per_certificate(9)


def test_what_is_used_up_ends_the_search() -> None:
    meter = Meter(10)
    meter.charge(OVERDRAFT)
    with pytest.raises(WorkExhaustedError):
        meter.charge(1)


def test_the_last_unit_may_be_spent() -> None:
    meter = Meter(2)
    meter.charge(1)
    meter.charge(1)
    assert meter.left == 0
    with pytest.raises(WorkExhaustedError):
        meter.charge(0)


def test_a_step_far_beyond_what_is_left_is_not_begun() -> None:
    meter = Meter(10)
    with pytest.raises(WorkExhaustedError):
        meter.charge(OVERDRAFT + 11)
    assert meter.left == 10
    meter.charge(OVERDRAFT + 10)


def test_it_is_known_whether_work_ran_out() -> None:
    """With more of it other things might have been found; in a step with a limit, too."""
    meter = Meter(1000)
    with meter.at_most(300):
        meter.charge(300)
    assert not meter.ran_out
    with meter.at_most(300):
        for _ in range(4):
            meter.charge(100)
    assert meter.ran_out


def test_a_step_with_a_limit_leaves_the_rest() -> None:
    meter = Meter(1000)
    with meter.at_most(300):
        meter.charge(100)
        meter.charge(100)
    assert meter.left == 800
    with meter.at_most(300):
        for _ in range(1000):
            meter.charge(100)
    assert meter.left == 500
