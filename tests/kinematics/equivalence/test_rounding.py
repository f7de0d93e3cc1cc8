"""The tolerance that matches a number of decimals."""

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest

from kinematics.equivalence import Policy, ToolRule, decide, rounding_tolerance
from kinematics.equivalence.reference import prepared
from kinematics.table import DHTable, JointType, NumericTable
from tests.kinematics.equivalence.campaign import size_beside
from tests.kinematics.equivalence.evaluation import poses_of
from tests.kinematics.equivalence.generators import random_robot, random_valid_table, rounded
from tests.kinematics.equivalence.tables import HALF, PUMA, P, R, standard


def with_exact_variables(table: NumericTable, exact: NumericTable) -> NumericTable:
    """The table, with what joint offsets make up for as it was before rounding."""
    rows = tuple(
        replace(row, theta=was.theta)
        if row.joint is JointType.REVOLUTE
        else replace(row, d=was.d)
        if row.joint is JointType.PRISMATIC
        else row
        for row, was in zip(table.rows, exact.rows, strict=True)
    )
    return DHTable(convention=table.convention, rows=rows)


@pytest.mark.parametrize("seed", range(40))
def test_rounding_moves_the_end_by_no_more(seed: int) -> None:
    rng = Random(f"rounding {seed}")
    key = random_robot(rng, joints=rng.randint(1, 9))
    exact = random_valid_table(key, rng)
    table = rounded(exact, 3)
    tolerance = rounding_tolerance(key, exact, length_step=1e-3, angle_step=1e-3)
    size = size_beside(key, exact)
    reach = [math.pi if joint is JointType.REVOLUTE else size for joint in key.joint_types]
    joints = np.random.default_rng(seed).uniform(-1.0, 1.0, (300, key.n_joints)) * reach
    apart = poses_of(with_exact_variables(table, exact), joints) - poses_of(exact, joints)
    assert np.linalg.norm(apart[:, :3, 3], axis=1).max() <= 1.01 * tolerance.length * size
    assert np.linalg.norm(apart[:, :3, :3], axis=(1, 2)).max() / math.sqrt(2.0) <= 1.01 * tolerance.angle


def test_one_link_by_hand() -> None:
    """α, a and d of one revolute row; the lever of α is nothing, for the end lies on its line."""
    link = standard((R, HALF, 2.0, 0.0, 0.3))
    tolerance = rounding_tolerance(link, link, length_step=0.01, angle_step=0.1)
    assert prepared(link).size == 2.0
    assert tolerance.angle == pytest.approx(0.05)
    assert tolerance.length == pytest.approx((0.005 + 0.005) / 2.0)


def test_the_lever_of_a_slider_reaches_as_far_as_what_is_behind_it_can_stretch() -> None:
    """Links of 3 and 4 at right angles at the zeros: θ and α before them move the end at 7 at most.

    Each twist turns about a line through the axis behind it: 4 of the first, nothing of the last.
    """
    arm = standard((P, 0.0, 3.0, 0.0, 0.0), (R, 0.0, 4.0, 0.0, HALF))
    tolerance = rounding_tolerance(arm, arm, length_step=0.0, angle_step=0.1)
    size = prepared(arm).size
    assert tolerance.angle == pytest.approx(0.05 * 3)
    assert tolerance.length == pytest.approx(0.05 * (7.0 + 4.0 + 0.0) / size)


def test_a_puma_to_three_decimals() -> None:
    """The figures of docs/checker.md."""
    tolerance = rounding_tolerance(PUMA, PUMA, length_step=1e-3, angle_step=1e-3)
    assert tolerance.length == pytest.approx(0.0069, abs=5e-5)
    assert tolerance.angle == pytest.approx(0.003)


def test_finer_steps_leave_less() -> None:
    coarse = rounding_tolerance(PUMA, PUMA, length_step=1e-2, angle_step=1e-2)
    fine = rounding_tolerance(PUMA, PUMA, length_step=1e-3, angle_step=1e-3)
    assert fine.length == pytest.approx(0.1 * coarse.length)
    assert fine.angle == pytest.approx(0.1 * coarse.angle)


@pytest.mark.parametrize("seed", range(20))
def test_two_decimals_are_accepted_at_what_they_can_do(seed: int) -> None:
    table = rounded(random_valid_table(PUMA, Random(f"two {seed}"), dummies=0.0), 2)
    tolerance = rounding_tolerance(PUMA, table, length_step=1e-2, angle_step=1e-2)
    assert decide(PUMA, table, Policy(tool=ToolRule.FREE, tolerance=tolerance)).accepted
