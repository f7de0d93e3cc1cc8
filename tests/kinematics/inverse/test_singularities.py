"""Poses at and near singularities: nothing lost, nothing invented, families told as what they are."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.catalogue import robots
from kinematics.forward import end_pose
from kinematics.inverse import IKStatus, UnreachableReason, inverse_kinematics, solver_of
from kinematics.inverse.goals import read_goal
from kinematics.inverse.methods.closed_form import closed_form_of
from kinematics.inverse.methods.general import GeneralArm
from kinematics.inverse.methods.wrist import WristArm
from kinematics.inverse.refinement import solutions_of
from kinematics.inverse.results import Isolation, Method
from kinematics.inverse.search import Bounds, search
from kinematics.inverse.self_motions import isolation as sorting
from kinematics.inverse.self_motions.components import belongs, components_of
from kinematics.inverse.self_motions.isolation import can_move
from kinematics.inverse.valleys import low_points
from kinematics.table import Convention
from tests.kinematics.inverse.__main__ import main
from tests.kinematics.inverse.arms import GENERAL, STANFORD, UR5, apart, random_joints, random_table
from tests.kinematics.inverse.campaign import has, posed, run, run_arms, singular_configuration
from tests.kinematics.inverse.models import MODELS
from tests.kinematics.robots import PLANAR4, PUMA560, RX90, numeric

WRIST_IN_LINE = np.radians([30, -40, 70, 20, 0, -80])
SMALL = ["puma", "ur5", "irb140", "kr5", "stanford", "three links", "five joints"]


@pytest.mark.parametrize("name", SMALL)
def test_a_small_campaign(name):
    tally = run(name, MODELS[name], poses=12, tried=1)
    assert tally.faults == []
    assert tally.poses == 12


@pytest.mark.parametrize("decimals", [6, 7, 9])
@pytest.mark.parametrize("factor", [1.0, 1000.0, 1.0 / 0.0254])
def test_a_wrist_in_line_behind_a_slide_turns_right_round_in_every_unit(factor, decimals):
    """A distance of 1e-6 counts as much as an angle of 1e-6, however many units the arm's size has."""
    rows = tuple(replace(row, a=factor * row.a, d=factor * row.d) for row in STANFORD.rows)
    table = replace(STANFORD, rows=rows)
    q = [-1.75183, 2.10798, -0.19994 * factor, -2.28115, math.pi, 1.47821]
    target = end_pose(table, q)
    target[:3, 3], target[:3, :3] = target[:3, 3].round(6), target[:3, :3].round(decimals)
    answer = inverse_kinematics(table, target, tolerance=1e-6)
    families = [solution.family for solution in answer.solutions if solution.family]
    assert len(answer.solutions) == 6
    assert [family.parameters[0].full_turn for family in families] == [True, True]


def test_a_campaign_refuses_a_model_that_there_is_not(capsys):
    with pytest.raises(SystemExit) as caught:
        main(["--poses", "1", "--tried", "0", "--only", "puma", "pumma"])
    assert caught.value.code == 2
    told = capsys.readouterr()
    assert not told.out
    assert "no model is called pumma; there are catalogue " in told.err


def test_a_search_finds_no_solution_that_random_arms_of_six_joints_lack():
    tally, _ = run_arms(30, seed=6)
    assert tally.complete == tally.poses == 30
    assert not tally.faults


FOUND = {
    "over a bent surface": (
        "catalogue rx90", 5, (-3.141595, -0.5014946, 1.570794, 3.141593, 3.141602, -1.084791)),
    "over a surface, by places in between": (
        "catalogue rx90", 6, (-1.3350471, 2.6914588, 1.5707963, 3.1415927, 3.801234e-10, 3.1415927)),
    "a wrist 8e-9 rad from its line": (
        "stanford", 16, (-5.432378931980767e-09, 1.5707963243845098, -0.1360266415612421, 1.5707964081039483,
                         -8.402005439621999e-09, -1.57079638271508)),
    "a wrist 5e-9 rad from its line": (
        "stanford", 14, (1.570796321819806, 1.570796329868844, 0.2069969628355889, 1.57079632791816,
                         4.638574061559116e-09, 1.570796325994421)),
    "rounded by more than the rotation shows": ("catalogue twolink", 8, (0.907605556, -0.997073198)),
    "at the other end of a valley, beside a fold": (
        "catalogue scorbot", 13, (1.594712968157606, -0.7171083697268744, 3.141592020263957,
                                  -0.0008291021399516658, 1.9778775599964)),
    "half way along a valley": (
        "catalogue scorbot", 10, (-1.92643896055, 3.14159265545, -3.14159264945, -6.65846432209e-09,
                                  -0.268095334777)),
    "missed in distance alone where the squares are least": ("two links", 8, (-3.1415927525, 1.5707963417)),
    "within the width of crossing families": (
        "no offsets", 5, (0.0001108633, -1.570242, -1.570364, -1.570103, 3.141706, 3.14158)),
    "a family of a single point": (
        "catalogue gen3", 13, (1.57079632679522, -1.57079632679532, 3.14159265358964, 9.01546247525669e-14,
                               1.57079632679557, -3.14159265359008, -3.14159265359019)),
    "ways that leave a crossing of seven joints": (
        "catalogue gen3", 7, (-1.570532203, -3.141395701, -1.570610345, 3.142016411, 1.570159403,
                              9.270330828e-06, 1.570275242)),
    "a fold that is a single point at the end of the reach": (
        "catalogue gen3", 17, (-1.5707963267946325, 1.2037733537955275, 6.611293505001663e-13,
                               8.349630139637855e-14, 3.1415926535899583, -1.5707963267945928,
                               -5.938422318230567e-13)),
    "long families of seven joints": (
        "catalogue gen3", 8, (1.611244178, -3.141592654, 1.570796327, 2.605409363, 2.347476577, -2.381057249,
                              1.889702622)),
}  # fmt: skip


@pytest.mark.parametrize("case", FOUND)
def test_the_configuration_that_made_the_pose_is_found(case):
    name, decimals, q = FOUND[case]
    solver, pose, tolerance = posed(name, q, decimals)
    answer = solver.solve(pose, tolerance)
    goal = read_goal(pose, tolerance, where=())._replace(tolerance=answer.tolerance)
    assert has(solver, goal, np.array(q), answer)


@pytest.mark.parametrize(
    ("q", "decimals"),
    [
        ((1.57094991611, -0.00012180409, 1.57089434617, -1.57166849544, 3.14181582881, -3.14121651403), 7),
        (
            (
                1.5707936188608,
                2.7646494e-6,
                1.5707957199994,
                1.5707939151014,
                8.630652993e-6,
                3.1415947395355,
            ),
            12,
        ),
    ],
)
def test_of_families_with_the_wrist_turned_over_none_is_lost(q, decimals):
    """Shoulder and wrist are singular: the families end as near to each other as the tolerance is wide."""
    solver, q = solver_of(PUMA560), np.array(q)
    target = np.round(end_pose(PUMA560, q), decimals)
    answer = solver.solve(target, None)
    goal = read_goal(target, None, where=())._replace(tolerance=answer.tolerance)
    turned_over = q + np.array((0.0, 0.0, 0.0, np.pi, -2.0 * q[4], np.pi))
    for way in (q, turned_over):
        assert has(solver, goal, way, answer)


@pytest.mark.parametrize(
    ("q", "decimals"),
    [
        (
            (-5.499793881205594e-10, 1.570796327069842, 1.570796327186894,
             5.620864238913555e-10, 3.1415926535361645, 3.1415926539763785),
            11,
        ),
        (
            (-1.6539344970339172, 1.4486948187107451, 2.7510225284790746,
             -0.8858073557381132, -8.851513924675997e-11, -0.929895850508064),
            17,
        ),
    ],
)  # fmt: skip
def test_a_piece_at_the_edge_of_the_tolerance_is_one_answer(q, decimals):
    """Met from two families, at points 1e-6 apart, it was two isolated solutions, and there were twelve."""
    solver, q = solver_of(UR5), np.array(q)
    target = np.round(end_pose(UR5, q), decimals)
    answer = solver.solve(target, None)
    assert sum(solution.family is None for solution in answer.solutions) <= 8
    goal = read_goal(target, None, where=())._replace(tolerance=answer.tolerance)
    assert has(solver, goal, q, answer)


@pytest.mark.parametrize("decimals", [17, 12, 9, 8, 7, 6])
def test_a_wrist_in_line_is_six_solutions_and_a_family(decimals):
    target = np.round(end_pose(PUMA560, WRIST_IN_LINE), decimals)
    answer = inverse_kinematics(PUMA560, target)
    assert answer.status is IKStatus.SINGULAR
    assert not answer.complete
    families = [s for s in answer.solutions if s.isolation is Isolation.CONTINUUM]
    assert (len(families), len(answer.solutions) - len(families)) == (1, 6)
    family = families[0].family
    assert family.dimension == 1
    (parameter,) = family.parameters
    assert parameter.joint in (4, 6)
    assert parameter.full_turn
    total = sum(WRIST_IN_LINE[3:])
    for member in family.members:
        assert math.remainder(member[3] + member[5] - total, math.tau) == pytest.approx(0.0, abs=1e-4)
        assert np.abs(end_pose(PUMA560, member) - target).max() <= 3 * answer.tolerance
    if decimals >= 7:
        assert np.allclose(np.abs(family.direction), (0, 0, 0, 1, 0, 1), atol=1e-6)


@pytest.mark.parametrize("decimals", [3, 4, 5])
def test_roughly_written_poses_are_read_with_a_tolerance(decimals):
    target = np.round(end_pose(PUMA560, WRIST_IN_LINE), decimals)
    answer = inverse_kinematics(PUMA560, target, tolerance=10.0**-decimals)
    assert answer.status is IKStatus.SINGULAR
    assert sum(s.isolation is Isolation.CONTINUUM for s in answer.solutions) == 1
    assert len(answer.solutions) == 7


@pytest.mark.parametrize("q5", [4e-9, 8e-9, 3e-8, 1e-7, 1e-6, 1e-4])
@pytest.mark.parametrize("table", [UR5, PUMA560, RX90, STANFORD], ids=["ur5", "puma", "rx90", "stanford"])
def test_beside_a_wrist_in_line_no_solution_is_lost(table, q5):
    q = np.array([0.3, -0.7, 1.2, 0.5, q5, -1.4])
    answer = inverse_kinematics(table, end_pose(table, q))
    assert min(apart(table, q, s.joints) for s in answer.solutions if s.joints) < 0.05
    assert len(answer.solutions) <= 8
    if q5 >= 1e-6:
        assert answer.complete
        assert len(answer.solutions) == 8


def test_the_wrist_beside_the_first_axis():
    """The wrist's centre 1e-8 from axis 1: a family of turns about it at most, never dozens of solutions."""
    table = MODELS["no offsets"]
    for away in (0.0, 1e-12, 1e-10, 1e-8, 1e-6):
        q = np.array([0.4, 0.6, -0.1 + away, 0.7, 0.8, 0.9])
        reach = end_pose(table, q)
        isolated = [s for s in inverse_kinematics(table, reach).solutions if s.family is None]
        assert len(isolated) <= 8


def test_regular_poses_of_arms_with_joints_to_spare_are_not_singular():
    answer = inverse_kinematics(PLANAR4, end_pose(PLANAR4, [0.1, 0.5, 0.4, 0.2]))
    assert answer.status is IKStatus.SOLVED
    assert {s.isolation for s in answer.solutions} == {Isolation.CONTINUUM}
    panda = MODELS["panda"]
    answer = inverse_kinematics(panda, end_pose(panda, [0.1, 0.5, 0.4, -1.2, 0.3, 1.1, 0.2]))
    assert answer.status is IKStatus.SOLVED
    assert {s.isolation for s in answer.solutions} == {Isolation.CONTINUUM}
    assert len(answer.solutions) <= 16
    target = end_pose(panda, answer.solutions[0].joints)
    for solution in answer.solutions:
        for member in solution.family.members:
            assert np.abs(end_pose(panda, member) - target).max() <= 1e-7


@pytest.mark.parametrize(
    "q",
    [
        [1.570488049002024, 0.4995038516676532, 2.0191479000604273, -3.1343171091219526],
        [2.1828629671761544, 1.5698812766283976, -1.570639875268931, 1.1707265942145926],
    ],
)
def test_rounding_that_leaves_an_arms_plane_loses_no_solution(q):
    """Three parallel axes after an upright one: a target half of 1e-4 off their plane is meant (AL5D)."""
    table = numeric(
        Convention.MODIFIED,
        ("revolute", math.pi, 0.0, -0.06858, 0.0),
        ("revolute", math.pi / 2, 0.002, 0.0, 0.0),
        ("revolute", math.pi, 0.14679, 0.0, 0.0),
        ("revolute", math.pi, 0.17751, 0.0, 0.0),
    )
    answer = inverse_kinematics(table, end_pose(table, q).round(4), tolerance=1e-4)
    assert answer.status is IKStatus.SOLVED
    assert min(apart(table, np.array(q), solution.joints) for solution in answer.solutions) < 0.02


def _links(n):
    return numeric(Convention.STANDARD, *(("revolute", 0.0, 0.3 - 0.03 * i, 0.0, 0.0) for i in range(n)))


@pytest.mark.parametrize("n", [4, 5, 6])
@pytest.mark.parametrize("beside", [0.0, 1e-7, 1e-3])
def test_stretched_links_cannot_be_moved_however_many_they_are(n, beside):
    """Their solutions lie on a sphere of the size of what they are bent by: they are one."""
    q = beside * np.random.default_rng(n).normal(size=n)
    answer = inverse_kinematics(_links(n), end_pose(_links(n), q))
    assert answer.status is IKStatus.SOLVED
    (only,) = answer.solutions
    assert only.isolation is Isolation.ISOLATED
    assert np.abs(np.array(only.joints) - q).max() <= max(10.0 * beside, 1e-4)


@pytest.mark.parametrize("n", [4, 5, 6])
def test_folded_links_are_on_a_family_of_as_many_dimensions_as_others(n):
    answer = inverse_kinematics(_links(n), end_pose(_links(n), [0.3, 0.0, np.pi, *[0.0] * (n - 3)]))
    assert answer.status is IKStatus.SOLVED
    assert {solution.family.dimension for solution in answer.solutions} == {n - 3}


def test_families_end_at_the_limits():
    target = end_pose(PUMA560, WRIST_IN_LINE)
    limits = [None, None, None, (-1.0, 1.5), None, (-2.0, 2.0)]
    answer = inverse_kinematics(PUMA560, target, limits=limits)
    families = [s for s in answer.solutions if s.family]
    assert families
    for solution in families:
        for member in solution.family.members:
            assert -1.0 <= member[3] <= 1.5
            assert -2.0 <= member[5] <= 2.0
            assert np.abs(end_pose(PUMA560, member) - target).max() <= 1e-8
    # q_4 + q_6 = -60°: q_4 from -1 (q_6 = -0.05) to 0.95 (q_6 = -2).
    (parameter,) = families[0].family.parameters
    ends = sorted(member[3] for member in families[0].family.members)
    assert not parameter.full_turn
    assert ends[0] == pytest.approx(-1.0, abs=1e-6)
    assert ends[-1] == pytest.approx(2.0 + sum(WRIST_IN_LINE[3:]), abs=1e-6)


def test_outside_the_limits_of_an_arm_with_a_spare_joint_says_so():
    panda = MODELS["panda"]
    target = end_pose(panda, [0.1, 0.5, 0.4, -1.2, 0.3, 1.1, 0.2])
    limits = [(2.9, 2.95), (1.7, 1.75), (2.8, 2.85), (-0.1, -0.07), (2.8, 2.85), (3.7, 3.75), (2.8, 2.85)]
    answer = inverse_kinematics(panda, target, limits=limits)
    assert answer.status is IKStatus.UNREACHABLE
    assert answer.reason is UnreachableReason.JOINT_LIMITS
    assert answer.outside_limits > 0


def test_general_arms_have_what_a_search_finds():
    rng = np.random.default_rng(9)
    for i in range(12):
        table = GENERAL if i == 0 else random_table(rng, 6, sliding=0.0, aligned=bool(i % 3 == 1))
        solver = solver_of(table)
        if solver.arm.redundancy:
            continue
        target = end_pose(table, random_joints(rng, table))
        answer = solver.solve(target)
        if not answer.complete:
            continue
        known = np.array([s.joints for s in answer.solutions])
        for found in search(solver.arm, target, solver.box, Bounds.IGNORED).solutions:
            assert apart(table, found, known).min() < 1e-3


FOLDS = [("jaco", 1, 35), ("general", 1, 57), ("five joints", 2, 31)]


@pytest.mark.parametrize(("arm", "seed", "draw"), FOLDS)
def test_rounding_that_puts_a_fold_out_of_reach_loses_no_solution(arm, seed, draw):
    # A configuration where the Jacobian loses rank; decimals of its pose are cut off, so that the target is
    # out of reach by less than the tolerance.
    table = GENERAL if arm == "general" else MODELS[arm]
    solver = solver_of(table)
    rng = np.random.default_rng(seed)
    for _ in range(draw + 1):
        q = singular_configuration(rng, solver)
        decimals = int(rng.integers(4, 7))
    target, tolerance = np.round(end_pose(table, q), decimals), 10.0**-decimals
    answer = solver.solve(target, tolerance)
    assert has(solver, read_goal(target, tolerance, where=()), q, answer)


@pytest.mark.parametrize("bend", [3e-5, -1e-4, 4.5e-4])
def test_the_other_bend_of_an_elbow_all_but_folded_is_found_from_one(bend):
    # It is nearer than a stride along the valley, and rounding may leave one root of the two.
    table = numeric(
        Convention.STANDARD,
        ("revolute", math.pi / 2, 0, 0.053, 0),
        ("revolute", 0, 0.170384, 0, 0),
        ("revolute", 0, -0.136307, 0, 0),
        ("revolute", 0, 0.126, 0, 0),
    )
    arm = solver_of(table).arm
    q = np.array([-2.1, 2.3, bend, -1.6])
    target = end_pose(table, q)
    found = solutions_of(arm, low_points(arm, target, q[None], 1e-12), target, 1e-12)
    assert np.abs(found[:, 2] + bend).min() < 1e-6


@pytest.mark.parametrize("name", ["puma", "ur5", "stanford"])
def test_what_cannot_be_moved_is_sorted_as_when_it_is_followed(name, monkeypatch):
    solver = solver_of(MODELS[name])
    rng = np.random.default_rng(8)
    still = merged = 0
    for _ in range(24):
        away = rng.normal(size=6)
        q = singular_configuration(rng, solver) + 10.0 ** rng.uniform(-6, -3) * away * solver.arm.units
        target = end_pose(MODELS[name], q)
        joints = solutions_of(solver.arm, solver.closed_form.candidates(target), target, 7e-10)
        if can_move(solver.arm, target, joints, 7e-10).any():
            continue
        with monkeypatch.context() as patch:
            patch.setattr(sorting, "can_move", lambda *_: np.ones(1, dtype=bool))
            followed = components_of(solver.arm, target, joints, 7e-10)
        at_once = components_of(solver.arm, target, joints, 7e-10)
        assert sorted(tuple(one.joints) for one in at_once) == sorted(tuple(one.joints) for one in followed)
        assert not any(one.dimension for one in followed)
        still += 1
        merged += len(at_once) < len(joints)
    assert still > 2
    assert merged > 0 or name == "stanford"


def test_which_arm_has_which_closed_form():
    assert isinstance(solver_of(PUMA560).closed_form, WristArm)
    assert isinstance(solver_of(GENERAL).closed_form, GeneralArm)
    assert closed_form_of(solver_of(PLANAR4).arm) is None
    jaco = MODELS["jaco"]
    q = [0.3, -0.7, 1.2, 0.5, 0.9, -1.4]
    answer = inverse_kinematics(jaco, end_pose(jaco, q))
    assert answer.method is Method.CLOSED_FORM
    assert answer.complete
    assert min(apart(jaco, q, s.joints) for s in answer.solutions) < 1e-6


def test_every_arm_of_six_turning_joints_in_the_catalogue_is_closed():
    for robot in robots():
        solver = solver_of(MODELS[f"catalogue {robot.id}"])
        assert (solver.closed_form is None) == (solver.arm.redundancy > 0)


CROSSINGS = {
    # The wrist's centre on the shoulder's axis: turns of joint 2 against the wrist; where they bring the
    # wrist into line, joints 4 and 6 turn against each other as well.
    "catalogue puma600": (0.0, -2.928641, -math.pi / 2, 1.097606, 0.0, -math.pi / 2),
    # Shoulder and wrist lose rank together, and the closed form's double root is off by 3e-7.
    "stanford": (-math.pi / 2, 0.0, -0.041222884794, -math.pi / 2, math.pi, -math.pi / 2),
    # The wrist's centre where axes 1 and 2 meet: both turn freely.
    "no offsets": (0.0, math.pi / 2, -math.pi / 2, math.pi / 2, math.pi / 2, -math.pi / 2),
    "irb140": (0.0, math.pi, math.pi / 2, -math.pi / 2, -math.pi, -math.pi),
}


@pytest.mark.parametrize("name", CROSSINGS)
@pytest.mark.parametrize("decimals", [17, 11])
def test_where_families_cross_no_configuration_is_lost(name, decimals):
    table, q = MODELS[name], np.array(CROSSINGS[name])
    solver = solver_of(table)
    target = np.round(end_pose(table, q), decimals)
    answer = solver.solve(target)
    assert not answer.complete
    assert answer.status is IKStatus.SINGULAR
    members = np.array([s.joints for s in answer.solutions])
    tolerance = 3.0 * answer.tolerance
    parts = components_of(solver.arm, target, members, answer.tolerance)
    assert any(belongs(solver.arm, target, part, q, tolerance) for part in parts)


def test_the_families_of_a_puma_whose_wrist_is_in_its_shoulder():
    """Joint 2 turns fully against the wrist, twice; each way meets the wrist in line once."""
    table = MODELS["catalogue puma600"]
    answer = inverse_kinematics(table, end_pose(table, CROSSINGS["catalogue puma600"]))
    turning = [s.family.parameters[0] for s in answer.solutions]
    assert {(one.joint, one.full_turn) for one in turning} == {(2, True), (4, True)}
