"""Families of two dimensions and more: where an arm has joints to spare, each is told once, none is lost."""

import numpy as np
import pytest

from kinematics.forward import end_pose
from kinematics.inverse import ArmReach, IKStatus, inverse_kinematics, solver_of
from kinematics.table import Convention
from tests.kinematics.inverse.models import MODELS
from tests.kinematics.robots import numeric

ANY_WRIST = [
    [0.3, -0.7, 1.2, 0.5, 0.9, -1.4],
    [0.8, 0.4, -0.6, 1.0, -0.5, 0.2],
    [-2.0, 0.3, 0.9, 0.1, 1.2, 2.2],
]


@pytest.mark.parametrize("joints", ANY_WRIST)
def test_a_wrists_centre_has_a_family_for_each_posture_of_the_arm_before_it(joints):
    """Joints 4 to 6 of a PUMA do not move it; joints 1 to 3 are those of the solutions for any pose there."""
    table = MODELS["catalogue puma560"]
    target = end_pose(table, joints)
    postures = {tuple(np.round(s.joints[:3], 6)) for s in solver_of(table).solve(target).solutions}
    families = solver_of(table, reach=ArmReach.POSITION).solve(target).solutions
    assert all(s.family is not None and s.family.dimension == 3 for s in families)
    assert len(families) == len(postures)
    assert {tuple(np.round(s.joints[:3], 6)) for s in families} == postures


@pytest.mark.parametrize(
    ("name", "seed", "draw", "families"),
    [
        ("catalogue ur5", 1, 0, 4),
        ("catalogue ur5", 1, 1, 4),
        ("catalogue ur5", 1, 2, 2),
        ("catalogue irb140", 1, 0, 1),
        ("stanford", 1, 1, 2),
        ("stanford", 1, 2, 1),
    ],
)
def test_positions_of_a_tool_have_as_many_families_as_a_sample_of_configurations(name, seed, draw, families):
    """So many parts a sample of 120 configurations has, joined where corrected steps of 0.12 rad lead on."""
    table = MODELS[name]
    solver = solver_of(table, reach=ArmReach.POSITION)
    rng = np.random.default_rng(seed)
    spans = np.where(solver.arm.revolute, 1.0, 0.3 * solver.arm.size)
    drawn = rng.uniform(-1.5, 1.5, (draw + 1, solver.arm.n_joints)) * spans
    target = end_pose(table, drawn[draw])
    answer = solver.solve(target)
    assert len(answer.solutions) == families
    for solution in answer.solutions:
        reached = end_pose(table, solution.joints)
        assert np.linalg.norm(reached[:3, 3] - target[:3, 3]) < 1e-8


@pytest.mark.parametrize(
    ("off", "elbows"),
    [
        pytest.param(0.0, 1, id="folded: the shoulder turns right round"),
        pytest.param(-6.7e-6, 2, id="all but folded: it turns by an interval, and by another half a turn on"),
    ],
)
@pytest.mark.parametrize("third", [-8.2e-5, 0.9, 2.0])
def test_equal_links_folded_below_two_joints_on_one_axis_are_a_surface(off, elbows, third):
    """Four joints in a plane, the last two on one axis, which the fold brings onto the first as well."""
    rows = [("revolute", 0.0, a, d, 0.0) for a, d in ((0.3, 0.0), (0.3, 0.2), (0.0, 0.0), (0.3, 0.0))]
    table = numeric(Convention.STANDARD, *rows)
    target = end_pose(table, [np.pi + 1.8e-5, np.pi + off, np.pi + third, 1.6]).round(6)
    answer = inverse_kinematics(table, target, tolerance=1e-6)
    assert answer.status is IKStatus.SINGULAR
    assert len(answer.solutions) == elbows
    for solution in answer.solutions:
        assert solution.family.dimension == 2
        one, other = solution.family.parameters
        assert one.joint != other.joint
        assert one.full_turn or off
        assert other.full_turn


@pytest.mark.parametrize("decimals", [17, 8, 7, 6, 5, 4])
def test_a_surface_of_a_rounded_axis_is_one_however_distance_and_angle_are_missed(decimals):
    """Four axes through a point, two of them the same, and a tool along the last: its distance is fixed."""
    rows = [("revolute", alpha, 0.0, 0.0, 0.0) for alpha in (0.5236, np.pi / 2, -np.pi / 2, np.pi / 2)]
    table = numeric(Convention.STANDARD, *rows, ("fixed", 0.0, 0.0, 0.1, -0.8713885))
    target = end_pose(table, [-2.212444276, 5.433656607, -3.467322574, 1.893937880]).round(decimals)
    tolerance = 10.0**-decimals if decimals <= 6 else None
    answer = inverse_kinematics(table, target, reach=ArmReach.AXIS, tolerance=tolerance)
    assert answer.status is IKStatus.SOLVED
    assert len(answer.solutions) <= 4
    assert all(solution.family.dimension == 2 for solution in answer.solutions)
