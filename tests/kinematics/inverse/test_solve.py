"""One target: every solution is one, all are there, and what is not reachable says so."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.catalogue import robots
from kinematics.cells import bind_parameters
from kinematics.errors import JointValueError, PoseError, TableError
from kinematics.forward import end_pose, end_poses, forward_kinematics
from kinematics.inverse import IKStatus, UnreachableReason, inverse_kinematics, solve_many, solver_of
from kinematics.inverse.arm import ArmReach, arm_of
from kinematics.inverse.goals import read_goal
from kinematics.inverse.newton import polish
from kinematics.inverse.residuals import pose_errors
from kinematics.inverse.results import Isolation, Method
from kinematics.inverse.search import Bounds, search
from kinematics.jacobian import jacobian
from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.conftest import EXPLORE
from tests.kinematics.inverse.arms import (
    GENERAL,
    RIGHT,
    STANFORD,
    THREE_LINKS,
    TWO_LINKS,
    UR5,
    apart,
    random_joints,
    random_table,
    turning,
)
from tests.kinematics.inverse.models import MODELS
from tests.kinematics.robots import PLANAR4, PUMA560, PUMA560_CRAIG, RX90, SCARA_RRPR, numeric
from tests.kinematics.strategies import tables

POSES, ARMS = (12, 40) if EXPLORE else (3, 10)

CATALOGUE = {robot.id: bind_parameters(robot.table, robot.parameters) for robot in robots()}


def reached(table, solution, **ends):
    return forward_kinematics(table, solution.joints, **ends).transform


def assert_solutions(table, target, answer, tolerance=1e-9, **ends):
    """Each is a solution by forward kinematics, its residual is true, and none is there twice."""
    assert answer.solutions
    for i, solution in enumerate(answer.solutions):
        off = reached(table, solution, **ends) - target
        chord = np.linalg.norm(off[:3, :3]) / math.sqrt(8.0)
        assert np.linalg.norm(off[:3, 3]) == pytest.approx(solution.position_error, abs=1e-12)
        assert 2 * math.asin(min(chord, 1.0)) == pytest.approx(solution.orientation_error, abs=1e-12)
        assert solution.residual == math.hypot(solution.position_error, solution.orientation_error)
        assert solution.residual <= tolerance
        for other in answer.solutions[:i]:
            assert apart(table, solution.joints, other.joints) > 1e-6


def test_the_arm_is_the_table():
    rng = np.random.default_rng(0)
    for n in range(1, 9):
        table = random_table(rng, n)
        table = DHTable(
            convention=table.convention,
            rows=(
                *table.rows[:1],
                DHRow(joint=JointType.FIXED, theta=0.4, d=0.1, a=0.2, alpha=-0.9),
                *table.rows[1:],
            ),
        )
        base = end_pose(random_table(rng, 3, sliding=0.0), [0.1, 0.2, 0.3])
        tool = end_pose(random_table(rng, 3, sliding=0.0), [0.3, 0.1, 0.2])
        arm = arm_of(table, base, tool)
        q = rng.normal(size=(5, n))
        frames = arm.frames(q)
        want = np.array([end_pose(table, one, base=base, tool=tool) for one in q])
        assert np.allclose(frames[-1], want, atol=1e-12)
        scale = np.array([arm.size] * 3 + [1.0] * 3)[:, None]
        signs = np.array([table.rows[i].sign for i in table.joint_rows])
        assert np.allclose(
            arm.jacobians(frames) * scale, jacobian(table, q, base=base, tool=tool), atol=1e-12
        ), signs


@pytest.mark.parametrize("table", [PUMA560, PUMA560_CRAIG], ids=["standard", "modified"])
def test_puma_has_eight(table):
    rng = np.random.default_rng(1)
    solver = solver_of(table)
    for _ in range(POSES):
        q = random_joints(rng, table)
        target = end_pose(table, q)
        answer = solver.solve(target)
        assert answer.status is IKStatus.SOLVED
        assert answer.complete
        assert len(answer.solutions) == 8
        assert_solutions(table, target, answer)
        assert min(apart(table, q, s.joints) for s in answer.solutions) < 1e-6


@pytest.mark.parametrize("name", CATALOGUE)
def test_catalogue(name):
    table = CATALOGUE[name]
    rng = np.random.default_rng(2)
    solver = solver_of(table)
    for _ in range(POSES if table.n_joints <= 6 else max(POSES // 3, 1)):
        q = random_joints(rng, table, slide=0.5 * solver.arm.size)
        target = end_pose(table, q)
        answer = solver.solve(target)
        assert answer.status is not IKStatus.UNREACHABLE
        assert_solutions(table, target, answer, tolerance=1e-8)
        if table.n_joints <= 6 and answer.status is IKStatus.SOLVED:
            assert answer.complete
            assert min(apart(table, q, s.joints) for s in answer.solutions) < 1e-6
        assert answer.complete == (table.n_joints <= 6 and answer.status is IKStatus.SOLVED)


def test_random_arms_of_four_to_eight_joints():
    rng = np.random.default_rng(3)
    for i in range(ARMS):
        table = random_table(
            rng, int(rng.integers(4, 9)), sliding=(0.0, 0.15, 0.3)[i % 3], aligned=bool(i % 2)
        )
        solver = solver_of(table)
        for _ in range(max(POSES // 3, 1)):
            target = end_pose(table, random_joints(rng, table))
            answer = solver.solve(target)
            assert answer.status is not IKStatus.UNREACHABLE
            assert_solutions(table, target, answer, tolerance=1e-8)


@pytest.mark.parametrize("n", [1, 2, 3, 9, 10, 11, 12])
def test_from_one_joint_to_twelve(n):
    rng = np.random.default_rng(n)
    table = random_table(rng, n, sliding=0.2)
    target = end_pose(table, random_joints(rng, table))
    assert_solutions(table, target, inverse_kinematics(table, target), tolerance=1e-8)


@pytest.mark.parametrize("convention", list(Convention))
@pytest.mark.parametrize("offset", [1e-3, 1e-5, 1.001e-6, 1e-8])
def test_slides_much_longer_than_all_offsets(offset, convention):
    """Two slides along one line, and an offset that is nothing beside their way."""
    turns, slides = JointType.REVOLUTE, JointType.PRISMATIC
    rows = [(turns, 0.0, math.pi / 2), (slides, 0.0, 0.0), (slides, offset, 0.0)]
    table = DHTable(
        convention=convention,
        rows=tuple(DHRow(joint=joint, theta=0.0, d=0.0, a=a, alpha=alpha) for joint, a, alpha in rows),
    )
    rng = np.random.default_rng(2)
    for _ in range(5):
        target = end_pose(table, rng.uniform(-1, 1, 3))
        answer = inverse_kinematics(table, target)
        assert answer.status is not IKStatus.UNREACHABLE
        assert_solutions(table, target, answer, tolerance=1e-8)


@given(tables(min_rows=1, max_rows=7), st.data())
def test_any_table_and_any_joints(table, data):
    """Tables full of tiny, huge and parallel things: what is returned for a pose in reach reaches it."""
    if not 1 <= table.n_joints <= 6:
        return
    q = [data.draw(st.floats(-3, 3)) for _ in range(table.n_joints)]
    target = forward_kinematics(table, q).transform
    answer = inverse_kinematics(table, target)
    if (
        answer.status is IKStatus.UNREACHABLE
    ):  # axes a millionth off parallel: the last digits may not be found
        assert answer.nearest.position_error < 1e-5
        assert answer.nearest.orientation_error < 1e-5
    for solution in answer.solutions:
        assert np.abs(reached(table, solution) - target).max() <= 2e-8


COMPLETE = {
    "ur5": UR5,
    "stanford": STANFORD,
    "scara": SCARA_RRPR,
    "three links": THREE_LINKS,
    "rx90": RX90,
    "craig": PUMA560_CRAIG,
}


@pytest.mark.parametrize("name", COMPLETE)
@pytest.mark.parametrize("special", [False, True], ids=["anywhere", "right angles"])
def test_complete_means_that_a_search_finds_no_more(name, special):
    table = COMPLETE[name]
    rng = np.random.default_rng(4)
    solver = solver_of(table)
    for _ in range(4):
        q = random_joints(rng, table, slide=0.5)
        if special:
            q = np.where(
                [j is JointType.REVOLUTE for j in table.joint_types], np.round(q / 1.5707) * math.pi / 2, 0.3
            )
        target = end_pose(table, q)
        answer = solver.solve(target)
        assert answer.method is Method.CLOSED_FORM
        if answer.status is not IKStatus.SOLVED:
            continue
        known = np.array([solution.joints for solution in answer.solutions])
        for found in search(solver.arm, target, solver.box, Bounds.IGNORED).solutions:
            assert apart(table, found, known).min() < 1e-3


def test_short_arms_of_every_kind_are_complete():
    """One to three joints of any types, and one to three before a wrist."""
    rng = np.random.default_rng(5)
    wrist = tuple(
        DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=0.0, alpha=alpha) for alpha in (1.4, -1.2, 0.0)
    )
    for i in range(24):
        head = random_table(rng, 1 + i % 3, sliding=0.5, aligned=bool(i % 2))
        table = DHTable(convention=Convention.STANDARD, rows=head.rows + (wrist if i % 4 < 2 else ()))
        q = random_joints(rng, table)
        target = end_pose(table, q)
        solver = solver_of(table)
        answer = solver.solve(target)
        if answer.status is IKStatus.SINGULAR or solver.arm.redundancy:
            assert not answer.complete
            continue
        assert answer.complete
        known = np.array([solution.joints for solution in answer.solutions])
        assert apart(table, q, known).min() < 1e-5
        for found in search(solver.arm, target, solver.box, Bounds.IGNORED).solutions:
            assert apart(table, found, known).min() < 1e-3


@pytest.mark.parametrize(
    "twists",
    [
        ((-1, 0, 0), (2, 0, 0), (1, 0, 0), (0, 0, 0.2), (1, 0, 0), (0, 0, 0)),
        ((-1, 0, 0), (0, 0, 0), (-1, 0.3, 0.2), (0, 0, 0), (1, 0, 0), (0, 0.3, 0)),
        ((1, 0, 0), (0, 0, 0), (1, 0.3, 0), (2, 0, 0.2), (1, 0, 0.2), (0, 0, 0)),
        ((0, 0, 0), (0, 0, 0), (0, 0.3, 0.2), (0, 0.3, 0)),
        ((2, 0.3, 0.2), (0, 0, 0), (0, 0, 0.2), (-1, 0, 0.2)),
    ],
)
def test_axes_on_one_line_do_no_harm(twists):
    """Arms with two joints on one axis have a joint to spare: a family for every pose, nothing singular."""
    rows = [("revolute", alpha * math.pi / 2, a, d, 0.0) for alpha, a, d in twists]
    table = numeric(Convention.STANDARD, *rows)
    target = end_pose(table, np.linspace(0.3, 0.9, len(rows)))
    answer = inverse_kinematics(table, target)
    assert answer.status is IKStatus.SOLVED
    assert not answer.complete
    assert all(solution.family for solution in answer.solutions)
    assert_solutions(table, target, answer, tolerance=1e-8)


@pytest.mark.parametrize("table", [PUMA560, PUMA560_CRAIG, RX90, UR5, STANFORD])
def test_a_wrist_in_line_is_singular(table):
    q = np.array([0.3, 0.5, 0.4, 0.2, 0.0, 0.7])
    answer = inverse_kinematics(table, end_pose(table, q))
    assert answer.status is IKStatus.SINGULAR
    assert not answer.complete
    assert any(solution.isolation is Isolation.CONTINUUM for solution in answer.solutions)
    assert_solutions(table, end_pose(table, q), answer)


def test_beside_the_singularity_there_are_two():
    q = np.array([0.3, 0.5, 0.4, 0.2, 1e-4, 0.7])
    answer = inverse_kinematics(PUMA560, end_pose(PUMA560, q))
    assert answer.status is IKStatus.SOLVED
    assert answer.complete
    assert len(answer.solutions) == 8


def test_a_stretched_elbow_is_one_solution_and_not_singular():
    target = end_pose(THREE_LINKS, [0.4, 0.0, 0.3])
    answer = inverse_kinematics(THREE_LINKS, target)
    assert answer.status is IKStatus.SOLVED
    assert answer.complete
    assert len(answer.solutions) == 1
    assert np.allclose(answer.solutions[0].joints, (0.4, 0.0, 0.3), atol=1e-4)
    assert_solutions(THREE_LINKS, target, answer)


def test_joints_to_spare_are_no_singularity():
    table = CATALOGUE["ssrms"]
    answer = inverse_kinematics(table, end_pose(table, np.full(7, 0.5)))
    assert answer.status is IKStatus.SOLVED
    assert not answer.complete
    assert answer.method is Method.SEARCH


def test_a_joint_to_spare_in_the_plane_is_a_continuum():
    answer = inverse_kinematics(PLANAR4, end_pose(PLANAR4, [0.1, 0.5, 0.4, 0.2]))
    assert answer.status is IKStatus.SOLVED
    assert {solution.isolation for solution in answer.solutions} == {Isolation.CONTINUUM}


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize("reached", [True, False])
def test_one_joint_whose_tool_is_on_its_axis(convention, reached):
    table = numeric(convention, ("revolute", 0.0, 0.0, 0.4, 0.0))
    target = end_pose(table, [0.7])
    target[2, 3] += 0.0 if reached else 0.1
    answer = inverse_kinematics(table, target, reach=ArmReach.POSITION)
    assert bool(answer.solutions) == reached
    assert not answer.complete
    if reached:
        assert answer.solutions[0].family.parameters[0].full_turn
    else:
        assert answer.nearest.position_error == pytest.approx(0.1)


def test_out_of_reach_gives_the_nearest_pose():
    target = np.eye(4)
    target[:3, 3] = 2.0, 0.3, 0.4
    for table in (PUMA560, PUMA560_CRAIG):
        answer = inverse_kinematics(table, target)
        assert answer.status is IKStatus.UNREACHABLE
        assert answer.reason is UnreachableReason.OUT_OF_REACH
        assert answer.complete
        assert answer.solutions == ()
        nearest = answer.nearest
        assert np.allclose(end_pose(table, nearest.joints), nearest.transform, atol=1e-12)
        # The wrist centre is the tool's origin: as far towards the target as the arm reaches, hand as wanted.
        reach = math.hypot(0.4318 + math.hypot(0.4318, 0.0203), 0.15005)
        assert nearest.position_error == pytest.approx(np.linalg.norm(target[:3, 3]) - reach, abs=1e-3)
        assert nearest.orientation_error < 1e-3


def test_slightly_off_is_not_solved_but_said():
    target = end_pose(TWO_LINKS, [0.3, 0.8])
    target[2, 3] += 1e-6
    answer = inverse_kinematics(TWO_LINKS, target)
    assert answer.status is IKStatus.UNREACHABLE
    assert answer.nearest.position_error == pytest.approx(1e-6, rel=1e-6)
    assert np.allclose(answer.nearest.joints, (0.3, 0.8), atol=1e-5)


def test_limits_choose_among_solutions():
    q = np.array([0.3, 0.2, 0.4, 0.2, 0.1, 0.3])
    target = end_pose(PUMA560, q)
    answer = inverse_kinematics(PUMA560, target, limits=[(-0.5, 0.5)] * 6)
    assert answer.status is IKStatus.SOLVED
    assert answer.complete
    assert answer.outside_limits == 7
    assert np.allclose(answer.solutions[0].joints, q, atol=1e-9)


def test_limits_wrap_turns():
    target = end_pose(PUMA560, [0.3, 0.2, 0.4, 0.2, 0.1, 0.3])
    wound = [(2 * math.pi, 4 * math.pi)] + [None] * 5
    answer = inverse_kinematics(PUMA560, target, limits=wound)
    assert len(answer.solutions) == 8
    assert all(2 * math.pi <= solution.joints[0] <= 4 * math.pi for solution in answer.solutions)
    wide = inverse_kinematics(PUMA560, target, limits=[(-3 * math.pi, 3 * math.pi)] * 6)
    free = inverse_kinematics(PUMA560, target)
    assert [s.joints for s in wide.solutions] == [s.joints for s in free.solutions]
    assert all(-math.pi < value <= math.pi for s in free.solutions for value in s.joints)


@pytest.mark.parametrize("shoulder", [0.0, math.pi, -math.pi / 2, 0.3])
def test_half_a_turn_is_counted_upwards_at_a_folded_elbow(shoulder):
    """Without limits angles are in (-π, π]."""
    table = numeric(Convention.STANDARD, *(("revolute", 0.0, a, 0.0, 0.0) for a in (0.5, 0.3)))
    for reach in (ArmReach.POSE, ArmReach.POSITION):
        answer = inverse_kinematics(table, end_pose(table, [shoulder, math.pi]), reach=reach)
        (solution,) = answer.solutions
        assert all(-math.pi < value <= math.pi for value in solution.joints)


def test_half_a_turn_is_counted_upwards_where_a_wrist_flips():
    """q4 and q6 are 0 but for rounding in one solution, and ±π in the other."""
    rng = np.random.default_rng(4)
    q = np.pi / 2 * rng.integers(-1, 3, (300, 6))
    q[:, (2, 4)] = rng.uniform(0.4, 1.0, (300, 2))
    targets = end_poses(PUMA560, q)
    solver = solver_of(PUMA560)
    one_by_one = np.array([s.joints for target in targets for s in solver.solve(target).solutions])
    for joints in (one_by_one, solve_many(solver, targets).joints):
        assert ((joints > -math.pi) & (joints <= math.pi)).all()


def test_one_sided_limits():
    target = end_pose(STANFORD, [0.3, 0.7, 0.4, 0.2, 0.6, 0.3])
    both = inverse_kinematics(STANFORD, target)
    out = inverse_kinematics(STANFORD, target, limits=[None, None, (0.0, None), None, None, None])
    assert len(both.solutions) == 8
    assert len(out.solutions) == 4
    assert all(solution.joints[2] >= 0 for solution in out.solutions)


def test_outside_the_limits_says_so():
    target = end_pose(PUMA560, [0.3, 0.2, 0.4, 0.2, 0.1, 2.3])
    answer = inverse_kinematics(PUMA560, target, limits=[(-0.5, 0.5)] * 6)
    assert answer.status is IKStatus.UNREACHABLE
    assert answer.reason is UnreachableReason.JOINT_LIMITS
    assert answer.outside_limits == 8
    assert all(-0.5 <= value <= 0.5 for value in answer.nearest.joints)


def test_limits_on_a_spare_joint_are_kept():
    table = CATALOGUE["ssrms"]
    limits = [(-1.0, 1.2)] * 7
    rng = np.random.default_rng(6)
    for _ in range(5):
        target = end_pose(table, rng.uniform(-0.9, 1.1, 7))
        answer = inverse_kinematics(table, target, limits=limits)
        assert answer.status is IKStatus.SOLVED
        assert_solutions(table, target, answer, tolerance=1e-8)
        assert all(-1.0 <= value <= 1.2 for s in answer.solutions for value in s.joints)


def test_a_limit_exactly_at_the_solution():
    target = end_pose(PUMA560, [0.3, 0.2, 0.4, 0.2, 0.1, 0.3])
    answer = inverse_kinematics(PUMA560, target, limits=[(0.3, 0.3), *[None] * 5])
    assert answer.solutions
    assert all(solution.joints[0] == 0.3 for solution in answer.solutions)


def test_base_tool_and_fixed_rows():
    rng = np.random.default_rng(7)
    base = end_pose(UR5, rng.normal(size=6))
    tool = end_pose(PUMA560, rng.normal(size=6))
    table = DHTable(
        convention=PUMA560.convention,
        rows=(
            DHRow(joint=JointType.FIXED, theta=0.3, d=0.7, a=0.1, alpha=0.2),
            *PUMA560.rows,
            DHRow(joint=JointType.FIXED, theta=0.1, d=0.2, a=0.0, alpha=0.4),
        ),
    )
    target = end_pose(table, rng.normal(size=6), base=base, tool=tool)
    answer = inverse_kinematics(table, target, base=base, tool=tool)
    assert len(answer.solutions) == 8
    assert_solutions(table, target, answer, base=base, tool=tool)


def test_a_general_arm_has_all_its_solutions():
    rng = np.random.default_rng(8)
    q = random_joints(rng, GENERAL)
    answer = inverse_kinematics(GENERAL, end_pose(GENERAL, q))
    assert answer.method is Method.CLOSED_FORM
    assert answer.complete
    assert min(apart(GENERAL, q, s.joints) for s in answer.solutions) < 1e-5


def test_a_general_arm_with_a_slide_is_searched():
    rows = (*GENERAL.rows[:3], replace(GENERAL.rows[3], joint=JointType.PRISMATIC), *GENERAL.rows[4:])
    table = replace(GENERAL, rows=rows)
    q = random_joints(np.random.default_rng(8), table)
    answer = inverse_kinematics(table, end_pose(table, q))
    assert answer.method is Method.SEARCH
    assert not answer.complete
    assert min(apart(table, q, s.joints) for s in answer.solutions) < 1e-5


def test_the_same_every_time():
    target = end_pose(GENERAL, np.linspace(-1, 1, 6))
    assert inverse_kinematics(GENERAL, target) == inverse_kinematics(GENERAL, target)


def test_millimetres_or_metres():
    mm = DHTable(
        convention=PUMA560.convention,
        rows=tuple(
            DHRow(joint=r.joint, theta=r.theta, d=1000 * r.d, a=1000 * r.a, alpha=r.alpha)
            for r in PUMA560.rows
        ),
    )
    q = np.array([0.3, -0.8, 0.4, 1.2, 0.9, -0.3])
    in_m = inverse_kinematics(PUMA560, end_pose(PUMA560, q))
    in_mm = inverse_kinematics(mm, end_pose(mm, q))
    assert np.allclose([s.joints for s in in_m.solutions], [s.joints for s in in_mm.solutions], atol=1e-9)
    assert all(solution.residual < 1e-9 for solution in in_mm.solutions)


@pytest.mark.parametrize("lengths", [(0.4, 0.3), (0.5, 0.3), (2.0, 1.0), (0.7, 0.45)])
@pytest.mark.parametrize("elbow", [0.0, math.pi])
@pytest.mark.parametrize("shoulder", [0.0, 0.3, math.radians(123.0), -2.9])
def test_a_stretched_or_folded_elbow_is_so_to_rounding(lengths, elbow, shoulder):
    table = numeric(Convention.STANDARD, *(("revolute", 0.0, a, 0.0, 0.0) for a in lengths))
    answer = inverse_kinematics(table, end_pose(table, [shoulder, elbow]), reach=ArmReach.POSITION)
    (solution,) = answer.solutions
    assert abs(math.remainder(solution.joints[0] - shoulder, math.tau)) < 1e-13
    assert abs(math.remainder(solution.joints[1] - elbow, math.tau)) < 1e-13
    assert solution.residual < 1e-15 * sum(lengths)


@pytest.mark.parametrize("far", [0.71, 2.0, 40.0])
def test_the_nearest_configuration_of_an_arm_that_stretches_is_zero_and_no_denormal(far):
    table = numeric(Convention.STANDARD, *(("revolute", 0.0, a, 0.0, 0.0) for a in (0.4, 0.3)))
    target = np.eye(4)
    target[0, 3] = far
    nearest = inverse_kinematics(table, target, reach=ArmReach.POSITION).nearest
    assert nearest.joints == (0.0, 0.0)


@pytest.mark.parametrize("off", [1e-6, 3e-7])
def test_an_elbow_that_is_stretched_but_for_more_than_rounding_is_left_as_it_is(off):
    stretched = -math.atan2(0.4318, 0.0203)
    answer = inverse_kinematics(PUMA560, end_pose(PUMA560, [0.3, -0.4, stretched + off, 0.2, 0.9, 0.1]))
    apart = [abs(solution.joints[2] - stretched) for solution in answer.solutions]
    assert min(apart) == pytest.approx(off, rel=0.05)


@pytest.mark.parametrize("seed", range(4))
def test_solutions_are_sorted_by_their_distance_from_a_start_in_every_unit(seed):
    rng = np.random.default_rng(seed)
    q, start = rng.uniform(-2.0, 2.0, (2, STANFORD.n_joints)) * np.where(turning(STANFORD), 1.0, 0.2)
    orders, first = [], []
    for factor in (1.0, 1000.0, 1.0 / 0.0254):
        rows = tuple(replace(row, a=factor * row.a, d=factor * row.d) for row in STANFORD.rows)
        table, units = replace(STANFORD, rows=rows), np.where(turning(STANFORD), 1.0, factor)
        solver = solver_of(table)
        answer = solver.solve(end_pose(table, q * units))
        found = solver.nearest_first(answer, (start * units).tolist())
        apart = (np.array([s.joints for s in found.solutions]) - start * units) / solver.arm.units
        apart = np.where(turning(STANFORD), (apart + np.pi) % (2.0 * np.pi) - np.pi, apart)
        assert (np.diff(np.linalg.norm(apart, axis=1)) >= -1e-9).all()
        orders.append(np.array([s.joints for s in found.solutions]) / units)
        first.append(np.array(answer.solutions[0].joints) / units)
    assert len(orders[0]) > 3
    for i in (1, 2):
        np.testing.assert_allclose(orders[i], orders[0], atol=1e-7)
        np.testing.assert_allclose(first[i], first[0], atol=1e-7)


@pytest.mark.parametrize("name", ["scorbot", "scara", "stanford", "panda"])
def test_poses_in_millimetres_with_one_decimal_are_those_in_metres_with_four(name):
    in_m = CATALOGUE[name]
    rows = tuple(replace(row, a=1000.0 * row.a, d=1000.0 * row.d) for row in in_m.rows)
    in_mm, slides = replace(in_m, rows=rows), ~turning(in_m)
    q = np.where(slides, 0.2, [0.3, -0.8, 0.4, 1.2, 0.9, -0.3, 0.6][: in_m.n_joints])
    limits = [(-1000.0, 1000.0) if slide else (-3.0, 3.0) for slide in slides]
    pose = np.round(end_pose(in_m, q), 4)
    pose[:3, :3] = end_pose(in_m, q)[:3, :3].round(7)
    of_mm = pose.copy()
    of_mm[:3, 3] = np.round(1000.0 * pose[:3, 3], 1)
    size = solver_of(in_m).arm.size
    answer = inverse_kinematics(in_mm, of_mm, tolerance=0.1, limits=limits)
    assert answer.solutions
    assert answer.tolerance == 0.1
    for solution in answer.solutions:
        off = reached(in_mm, solution) - of_mm
        assert np.linalg.norm(off[:3, 3]) == pytest.approx(solution.position_error, abs=1e-9)
        assert solution.position_error <= 0.1
        assert solution.orientation_error <= 1.01 * max(1e-4 / size, 3e-7)
    unit = np.where(slides, 1000.0, 1.0)
    families = [s.family.members for s in answer.solutions if s.family]
    chords = [np.linspace(*ends, 9) for members in families for ends in pairwise(np.array(members))]
    near = np.vstack([[s.joints for s in answer.solutions], *chords]) / unit
    assert np.abs(near - q).max(axis=1).min() < 0.1
    assert answer.complete is (name != "panda")


def test_an_unreachable_pose_in_millimetres_has_its_nearest_in_millimetres():
    rows = tuple(replace(row, a=1000.0 * row.a, d=1000.0 * row.d) for row in TWO_LINKS.rows)
    target = np.eye(4)
    target[0, 3] = 1000.0
    answer = inverse_kinematics(replace(TWO_LINKS, rows=rows), target, tolerance=1.0)
    assert answer.nearest.position_error == pytest.approx(200.0)
    assert answer.nearest.size == pytest.approx(800.0)
    assert answer.nearest.transform[0, 3] == pytest.approx(800.0)
    assert answer.tolerance == 1.0


@pytest.mark.parametrize("name", ["jaco", "five joints", "catalogue scorbot"])
def test_solutions_in_millimetres_are_within_the_tolerance_that_is_told(name):
    rows = tuple(replace(row, a=1000.0 * row.a, d=1000.0 * row.d) for row in MODELS[name].rows)
    table = replace(MODELS[name], rows=rows)
    rng = np.random.default_rng(1)
    for target in end_poses(table, rng.uniform(-math.pi, math.pi, (25, table.n_joints))):
        answer = inverse_kinematics(table, target)
        assert max(solution.position_error for solution in answer.solutions) <= answer.tolerance


def test_steps_that_lead_away_from_a_solution_beside_a_fold_lead_back_to_it():
    table = numeric(
        Convention.STANDARD,
        ("revolute", RIGHT, 0.0, 275.5, 0.0),
        ("revolute", math.pi, 410.0, 0.0, 0.0),
        ("revolute", RIGHT, 0.0, -9.799999999999999, 0.0),
        ("revolute", math.pi / 3, 0.0, -250.2, 0.0),
        ("revolute", math.pi / 3, 0.0, -85.79, 0.0),
        ("revolute", math.pi, 0.0, -211.60000000000002, 0.0),
    )
    q = (1.111232440849618, 1.1712002351388333, -3.2770356644753784)
    q = (*q, 0.9318022290539488, 2.8980164348158173, -1.6994266982217334)
    target = end_pose(table, q)
    candidate = np.add(q, (7.0529e-8, -2.5635e-9, 1.93708e-8, -1.275462e-7, 7.65845e-8, 1.101061e-7))
    found = polish(arm_of(table), target, candidate[None])
    position, _ = pose_errors(end_poses(table, found), target)
    assert position[0] < 1e-11


def test_a_tolerance_is_at_most_a_hundredth_of_the_size():
    with pytest.raises(PoseError) as caught:
        inverse_kinematics(TWO_LINKS, np.eye(4), tolerance=0.02)
    assert caught.value.faults[0].params == {"limit": 0.01}


def test_a_target_with_rounded_digits_is_made_a_rotation():
    target = np.round(end_pose(PUMA560, [0.3, -0.8, 0.4, 1.2, 0.9, -0.3]), 7)
    answer = inverse_kinematics(PUMA560, target)
    assert len(answer.solutions) == 8
    assert all(solution.residual < 1e-9 for solution in answer.solutions)
    assert np.abs(reached(PUMA560, answer.solutions[0]) - target).max() < 1e-6


# Their lengths of 0.2 or so weigh a distance much more than an angle; of the others the first two joints turn
# about one axis, so that they are searched.
SHORT = numeric(
    Convention.STANDARD,
    ("revolute", math.pi / 3, 0.1, 0.0, 0.0),
    ("revolute", -math.pi / 4, 0.0, 0.05, 0.0),
    ("revolute", math.pi / 6, 0.05, 0.0, 0.0),
)
TURNING, SLIDING = (
    numeric(
        Convention.MODIFIED,
        ("revolute", math.pi / 6, 0.0, 0.0, 0.0),
        ("revolute", math.pi, 0.0, 0.0, 0.4),
        last,
    )
    for last in (
        ("revolute", -math.pi / 4, 0.15, 0.0, 0.0),
        ("prismatic", math.pi / 3, 0.0, 0.15, RIGHT),
    )
)


@pytest.mark.parametrize(("table", "poses"), [(SHORT, 120), (TURNING, 8), (SLIDING, 8)])
def test_short_arms_reach_rounded_poses_within_distance_and_angle(table, poses):
    rng = np.random.default_rng(3)
    for _ in range(poses):
        q, decimals = random_joints(rng, table, slide=0.3), int(rng.integers(4, 10))
        target = np.round(end_pose(table, q), decimals)
        tolerance = 10.0**-decimals if decimals <= 6 else None
        goal = read_goal(target, tolerance, where=())
        distance, angle = pose_errors(end_pose(table, q)[None], goal.pose)
        answer = inverse_kinematics(table, target, tolerance=tolerance)
        assert answer.solutions or max(distance[0], angle[0]) > goal.tolerance
        if table is not SHORT:  # q1 and q2 turn against each other
            assert len(answer.solutions) <= 2
            assert all(s.family.parameters[0].full_turn for s in answer.solutions)


@pytest.mark.parametrize(
    ("limits", "code", "where"),
    [
        ([None] * 5, "limits_wrong_length", ("limits",)),
        ([(1.0, -1.0), *[None] * 5], "limits_reversed", ("limits", 0)),
        ([None, (math.nan, 1.0), *[None] * 4], "limits_reversed", ("limits", 1)),
        ([(math.inf, None), *[None] * 5], "limits_reversed", ("limits", 0)),
    ],
)
def test_malformed_limits(limits, code, where):
    with pytest.raises(JointValueError) as refusal:
        inverse_kinematics(PUMA560, np.eye(4), limits=limits)
    assert refusal.value.code == code
    assert refusal.value.faults[0].where == where


def test_other_refusals():
    with pytest.raises(PoseError) as refusal:
        inverse_kinematics(PUMA560, np.ones((4, 4)))
    assert refusal.value.faults[0].where[0] == "target"
    for name in ("base", "tool"):
        with pytest.raises(PoseError) as refusal:
            inverse_kinematics(PUMA560, np.eye(4), **{name: np.diag([1, 1, -1, 1])})
        assert refusal.value.faults[0].where[0] == name
    fixed = DHTable(
        convention=Convention.STANDARD,
        rows=(DHRow(joint=JointType.FIXED, theta=0.0, d=0.0, a=0.0, alpha=0.0),),
    )
    for table in (fixed, DHTable(convention=Convention.STANDARD, rows=PUMA560.rows * 3)):
        with pytest.raises(TableError) as wrong:
            inverse_kinematics(table, np.eye(4))
        assert wrong.value.code == "inverse_joint_count"


@pytest.mark.parametrize("size", [1e160, 1.7e308])
def test_lengths_that_overflow_on_the_way_are_refused_at_their_place(size):
    far = np.eye(4)
    far[:2, 3] = size
    for ends, place in (({}, "target"), ({"base": far}, "base"), ({"tool": far}, "tool")):
        with pytest.raises(PoseError) as refusal:
            inverse_kinematics(PUMA560, np.eye(4) if ends else far, **ends)
        assert refusal.value.code == "result_not_finite"
        assert refusal.value.faults[0].where == (place,)
    long = replace(PUMA560, rows=(*PUMA560.rows[:5], replace(PUMA560.rows[5], a=size, d=-size)))
    with pytest.raises(TableError) as wrong:
        inverse_kinematics(long, np.eye(4))
    assert [fault.where for fault in wrong.value.faults] == [("rows", 5, "a"), ("rows", 5, "d")]


def test_the_nearest_configuration_is_exact():
    """Two links out of reach point at the target; a joint that would leave its limits stays on one."""
    table = TWO_LINKS
    far = np.eye(4)
    far[:2, 3] = 3.0, 4.0
    angle = math.atan2(4.0, 3.0)
    free = solver_of(table, reach=ArmReach.POSITION).solve(far)
    np.testing.assert_allclose(free.nearest.joints, [angle, 0.0], atol=1e-14)
    limits = [(0.0, 0.5), (-1.0, 1.0)]
    held = solver_of(table, reach=ArmReach.POSITION, limits=limits).solve(far)
    a1, a2 = (row.a for row in table.rows)
    elbow = a1 * np.array([math.cos(0.5), math.sin(0.5)])
    second = math.atan2(*(far[:2, 3] - elbow)[::-1]) - 0.5
    assert a2 > 0.0
    np.testing.assert_allclose(held.nearest.joints, [0.5, second], atol=1e-14)
