"""Families within joint limits: cut where a joint may not go on, and nowhere else."""

import math

import numpy as np
import pytest

from kinematics.forward import end_pose
from kinematics.inverse import inverse_kinematics
from kinematics.inverse.residuals import pose_errors
from tests.conftest import EXPLORE
from tests.kinematics.inverse.models import MODELS
from tests.kinematics.inverse.test_singularities import WRIST_IN_LINE
from tests.kinematics.robots import PUMA560

TURN = 2.0 * math.pi
ONE_AND_A_HALF = (-0.75 * TURN, 0.75 * TURN)
NARROW = [(-1.0, 1.5), (2.0, 4.0), (-0.01, 3.1)]


@pytest.mark.parametrize("name", ["panda", *(["catalogue ssrms", "catalogue gen3"] if EXPLORE else [])])
def test_limits_of_more_than_a_turn_cut_nothing(name):
    table = MODELS[name]
    target = end_pose(table, np.random.default_rng(8).uniform(-1.5, 1.5, 7))
    freely = inverse_kinematics(table, target).solutions
    within = inverse_kinematics(table, target, limits=[ONE_AND_A_HALF] * 7).solutions
    assert len(within) == len(freely)
    full = [s.family.parameters[0].full_turn for s in freely]
    assert sorted(s.family.parameters[0].full_turn for s in within) == sorted(full)
    keep(table, target, within, [ONE_AND_A_HALF] * 7, exact=1e-8)


@pytest.mark.parametrize(
    ("name", "narrow"),
    [
        *(("panda", narrow) for narrow in NARROW),
        *(("catalogue ssrms", narrow) for narrow in (NARROW if EXPLORE else NARROW[1:2])),
    ],
)
def test_members_at_a_limit_are_as_exact_as_others(name, narrow):
    table = MODELS[name]
    target = end_pose(table, np.random.default_rng(9).uniform(-1.5, 1.5, 7))
    limits = [ONE_AND_A_HALF, ONE_AND_A_HALF, narrow, *[ONE_AND_A_HALF] * 4]
    answer = inverse_kinematics(table, target, limits=limits)
    keep(table, target, answer.solutions, limits, exact=10.0 * answer.tolerance)
    ends = [
        member
        for s in answer.solutions
        if not s.family.parameters[0].full_turn
        for member in (s.family.members[0], s.family.members[-1])
    ]
    assert ends
    for end in ends:  # at a limit, or where a turn back from one leads
        off = [abs(math.remainder(v - b, TURN)) for v, pair in zip(end, limits, strict=True) for b in pair]
        assert min(off) <= 1e-9


@pytest.mark.parametrize("wide", [ONE_AND_A_HALF, (-TURN, TURN), (0.5, 0.5 + TURN)])
def test_a_wrist_in_line_is_cut_by_the_joint_that_is_limited_alone(wide):
    target = end_pose(PUMA560, WRIST_IN_LINE)
    whole = inverse_kinematics(PUMA560, target, limits=[None, None, None, wide, None, wide])
    (family,) = (s.family for s in whole.solutions if s.family)
    assert family.parameters[0].full_turn
    cut = inverse_kinematics(PUMA560, target, limits=[None, None, None, (-1.0, 1.5), None, wide])
    (part,) = (s.family for s in cut.solutions if s.family)
    ends = (part.members[0][3], part.members[-1][3])
    assert sorted(ends) == pytest.approx([-1.0, 1.5], abs=1e-9)
    keep(PUMA560, target, cut.solutions, [None, None, None, (-1.0, 1.5), None, wide], exact=1e-10)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_member_just_beyond_a_limit_is_not_told_at_the_limit(side):
    """A part of a family has a member that reaches the target, also where another lies close to its end."""
    target = end_pose(PUMA560, WRIST_IN_LINE)
    (member,) = (s.joints[3] for s in inverse_kinematics(PUMA560, target).solutions if s.family)
    narrow = sorted((member + 0.03 * side, member + side))
    limits = [None, None, None, tuple(narrow), None, None]
    answer = inverse_kinematics(PUMA560, target, limits=limits)
    assert any(solution.family for solution in answer.solutions)
    keep(PUMA560, target, answer.solutions, limits, exact=1e-10)


def test_a_part_that_leads_farther_than_a_range_is_wide_is_cut_there():
    """Three links that hold a point: the first turns by more than its range while the last keeps its own."""
    table = MODELS["four links"]
    target = end_pose(table, [0.4, 0.5, 0.6, 0.7])
    limits = [(-0.5 * TURN, 0.5 * TURN), None, None, (-1.2, 1.2)]
    answer = inverse_kinematics(table, target, limits=limits)
    keep(table, target, answer.solutions, limits, exact=1e-8)
    for solution in answer.solutions:
        (parameter,) = solution.family.parameters
        low, high = limits[parameter.joint - 1] or (-math.inf, math.inf)
        assert parameter.full_turn or low - 1e-9 <= parameter.least <= parameter.greatest <= high + 1e-9


def keep(table, target, solutions, limits, exact):
    """All members, and the solutions, are within the limits and reach the target."""
    found = [member for s in solutions for member in (s.joints, *(s.family.members if s.family else ()))]
    assert found
    for joints in found:
        assert np.abs(end_pose(table, np.array(joints)) - target).max() <= exact
        for value, pair in zip(joints, limits, strict=True):
            assert pair is None or pair[0] - 1e-9 <= value <= pair[1] + 1e-9


@pytest.mark.parametrize("off", [0.0, 1e-12, 1e-9, 1e-7, 1e-6])
def test_a_direction_is_told_only_where_the_target_stays_reached_along_it(off):
    table, told = MODELS["irb140"], 0
    for seed in range(8):
        rng = np.random.default_rng(seed)
        joints = np.array([*rng.uniform(-1.0, 1.0, 4), off, rng.uniform(-1.0, 1.0)])
        target = end_pose(table, joints)
        answer = inverse_kinematics(table, target)
        for solution in answer.solutions:
            family = solution.family
            if family is None or family.direction is None:
                continue
            told += 1
            (chosen,) = family.parameters
            for value in np.linspace(chosen.least, chosen.greatest, 7):
                t = value - solution.joints[chosen.joint - 1]
                pose = end_pose(table, np.add(solution.joints, t * np.array(family.direction)))
                assert max(np.concatenate(pose_errors(pose[None], target))) <= 3.0 * answer.tolerance
    assert told or off > 1e-12
