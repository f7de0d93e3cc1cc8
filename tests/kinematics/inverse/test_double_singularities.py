"""Where an arm loses rank twice at once, or nearly: the configuration that made the pose is in the answer."""

import math
from itertools import product

import numpy as np
import pytest

from kinematics.forward import end_pose
from kinematics.inverse import ArmReach, IKStatus, inverse_kinematics, solver_of
from kinematics.inverse.goals import read_goal
from kinematics.inverse.residuals import are_solutions, errors_of
from kinematics.inverse.results import Isolation, Method
from kinematics.inverse.self_motions.crossings import tangents
from kinematics.inverse.self_motions.families import FamilyPath, Follower, nearest_on, null_space
from kinematics.inverse.self_motions.gaps import nearest_places, way_through_gaps
from kinematics.inverse.self_motions.paths import path_through
from kinematics.inverse.self_motions.walks import leads
from kinematics.table import Convention
from tests.conftest import EXPLORE
from tests.kinematics.inverse.campaign import has, posed
from tests.kinematics.inverse.models import MODELS
from tests.kinematics.robots import numeric

RIGHT = math.pi / 2
STRETCHED_DMRA = -math.atan2(130.0, 20.0)
"""The elbow at which the DMRA's wrist is as far away as may be."""


def asked(name, q, decimals=17, tolerance=None):
    table = MODELS[name]
    target = np.round(end_pose(table, q), decimals)
    solver = solver_of(table)
    return solver, read_goal(target, tolerance, where=()), solver.solve(target, tolerance)


def holds(solver, goal, answer, q):
    return has(solver, goal, np.asarray(q), answer)


@pytest.mark.parametrize("decimals", [17, 11, 9])
@pytest.mark.parametrize("slide", [-0.192402, 0.31])
@pytest.mark.parametrize("fourth", [RIGHT, 0.4, 2.9])
def test_a_wrist_in_line_below_a_shoulder_at_its_edge(fourth, slide, decimals):
    """A Stanford arm whose slider points down: q_1 and q_2 are a double root, and q_4, q_6 turn freely."""
    q = [-RIGHT, math.pi, slide, fourth, 0.0, 0.7]
    solver, goal, answer = asked("stanford", q, decimals)
    assert holds(solver, goal, answer, q)
    assert answer.status is IKStatus.SINGULAR
    assert {s.family.parameters[0].joint for s in answer.solutions if s.family} <= {4, 6}
    assert any(s.family and s.family.parameters[0].full_turn for s in answer.solutions)


@pytest.mark.parametrize(
    "q",
    [
        (1.58369684, -0.89018123, 1.61782943, -2.84851559, 2.83287576, -1.83423119),
        (1.77330868, -0.73299174, 1.61652164, 2.15263586, 0.63988234, -2.76288912),
    ],
)
def test_a_computed_pose_near_two_singularities_has_eight_solutions(q):
    """The PUMA's elbow nearly folded beside its shoulder: moved along a family the pose is off by 1e-10."""
    solver, goal, answer = asked("puma", q)
    assert holds(solver, goal, answer, q)
    assert len(answer.solutions) == 8
    assert answer.complete
    assert max(s.residual for s in answer.solutions) < 1e-12
    _, printed, rounded = asked("puma", q, decimals=9)
    assert printed.tolerance > goal.tolerance
    assert not rounded.complete


@pytest.mark.parametrize("decimals", [17, 9, 6])
@pytest.mark.parametrize("name", ["ur5", "ur10"])
@pytest.mark.parametrize("last", [0.0, RIGHT, 0.7])
def test_a_stretched_arm_whose_sixth_axis_is_parallel_to_three(name, last, decimals):
    """q_6 is free only as far as the elbow gives way: from the end of its reach, not from anywhere."""
    q = [0.0, -math.pi, 0.0, 0.0, 0.0, last]
    solver, goal, answer = asked(name, q, decimals)
    assert holds(solver, goal, answer, q)
    assert not answer.complete


@pytest.mark.parametrize("seed", range(5 if EXPLORE else 2))
def test_a_piece_of_a_family_that_no_exact_solution_is_on(seed):
    """A UR5's elbow folded and wrist in line, known to 1e-4: between two folds the pose is off by more."""
    rng = np.random.default_rng(seed)
    q = rng.uniform(-math.pi, math.pi, 6)
    q[2], q[4] = math.pi + 6e-4 * rng.normal(), 4e-4 * rng.normal()
    solver, goal, answer = asked("ur5", q, 4, 1e-4)
    assert holds(solver, goal, answer, q)
    assert sum(s.family is None for s in answer.solutions) <= 8


def test_pieces_of_a_family_are_on_one_way():
    """A PUMA's wrist 2e-8 rad from its line: two intervals of q_4, half a turn apart, and nothing between."""
    table = MODELS["puma"]
    q = np.array([0.3, -0.7, 1.2, 0.5, 2e-8, -1.4])
    solver = solver_of(table)
    follower = Follower(solver.arm, end_pose(table, q), 7e-10)
    (direction,) = null_space(follower.jacobian(q), follower.lost)
    path = path_through(follower, q, direction)
    assert not path.closed
    way = way_through_gaps(follower, q, path, 100.0)
    assert way.closed
    fourth = sorted(
        math.remainder(place[3] - q[3], math.tau) % math.tau for place in nearest_places(follower, way)
    )
    assert np.allclose(fourth, [0.0, math.pi], atol=1e-6) or np.allclose(
        fourth, [math.pi, math.tau], atol=1e-6
    )


@pytest.mark.parametrize("decimals", [6, 7, 9])
@pytest.mark.parametrize("seed", range(4))
def test_a_stretched_elbow_of_an_arm_measured_in_millimetres(seed, decimals):
    """Rounding turns the hand, and what that moves the wrist by is more than a tolerance for lengths."""
    q = np.random.default_rng(seed).uniform(-math.pi, math.pi, 6)
    q[2] = STRETCHED_DMRA
    solver, goal, answer = asked("catalogue dmra", q, decimals)
    own = solver.arm.frames(q[None])[-1]
    if are_solutions(errors_of(solver.arm, own, goal.pose), solver.arm, goal.tolerance)[0]:
        assert holds(solver, goal, answer, q)


@pytest.mark.parametrize("away", [1e-7, 1e-8, 1e-9, 1e-10])
def test_a_wrist_beside_the_first_axis_keeps_its_closed_form(away):
    """q_1 is the direction in which the wrist's centre lies, however near to the axis."""
    q = np.array([1.2, 0.6, 0.0, 0.8, -1.6, -1.7])
    # Upper arm and forearm are equally long: with this elbow the wrist is on axis 1.
    q[2] = 2.0 * (RIGHT - q[1]) + RIGHT
    q[1] += away
    solver, goal, answer = asked("no offsets", q)
    assert answer.method is Method.CLOSED_FORM
    assert holds(solver, goal, answer, q)


def test_families_leave_where_the_jacobian_stays_blind():
    """At a fold that q_4 passes it misses two directions; along one of them q_4 and q_6 turn freely."""
    table = MODELS["stanford"]
    q = np.array([-RIGHT, math.pi, -0.19, 0.0, 0.0, -RIGHT])
    follower = Follower(solver_of(table).arm, end_pose(table, q), 7e-10)
    x = q / follower.arm.units
    null = null_space(follower.jacobian(x), follower.lost)
    assert len(null) == 2
    free = tangents(follower, x, null, follower.lost)
    wrist = np.array((0, 0, 0, 1, 0, -1)) / math.sqrt(2.0)
    assert max(abs(float(direction @ wrist)) for direction in free) > 0.999


@pytest.mark.parametrize("fourth", [0.3, -2.2])
@pytest.mark.parametrize("second", [-1.1, -2.0, 1.1, 1.9] if EXPLORE else [-2.0, 1.1])
def test_two_crossings_half_a_radian_apart_on_one_family(second, fourth):
    """A Stanford arm drawn in, its wrist in line: joints 2 and 5 turn together, or 4 and 6, each in two ways.

    Those of the second kind cross the first where the wrist is in line, near to where joint 2 stands upright.
    """
    q = [-1.1, second, 0.0, fourth, 0.0, 0.3]
    _, _, answer = asked("catalogue stanford", q)
    assert answer.status is IKStatus.SINGULAR
    at_rest = [np.ptp(np.array(s.family.members), axis=0)[1] < 1e-3 for s in answer.solutions]
    assert sorted(at_rest) == [False, False, True, True]
    assert any(abs(s.joints[1] - second) < 1e-3 for s in answer.solutions)


@pytest.mark.parametrize("seed", [0, 2])
def test_a_stretched_elbow_of_seven_joints_is_found_with_the_wrist_either_way(seed):
    """A Gen3 at the end of its reach: its offsets leave each family a point, all but level along q_3."""
    q = np.random.default_rng(seed).uniform(-3.0, 3.0, 7)
    q[2:5] = 0.0, 0.0, math.pi
    solver, goal, answer = asked("catalogue gen3", q)
    goal = goal._replace(tolerance=answer.tolerance)
    assert holds(solver, goal, answer, q)
    assert len({s.joints[5] > 0.0 for s in answer.solutions}) == 2


def test_a_target_at_the_edge_of_the_reach_leaves_nothing_isolated_to_seven_joints():
    """Its pose, with five decimals, is missed by 5e-6 at least: solutions lie along valleys."""
    q = (-1.870009, -1.52237, 1.570796, -3.141593, 1.570796, 2.932028, 4.302589e-10)
    solver, pose, tolerance = posed("catalogue ssrms", q, 5)
    answer = solver.solve(pose, tolerance)
    assert min(s.position_error for s in answer.solutions) > 1e-6
    assert {s.isolation for s in answer.solutions} == {Isolation.CONTINUUM}


def test_a_surface_that_a_family_crosses_is_one_family_of_two_dimensions():
    """An SSRMS with five parallel axes: two joints may be chosen, and no path wanders over the surface."""
    q = [0.0247, RIGHT, math.pi, 0.0, RIGHT, RIGHT, 0.4632]
    solver, goal, answer = asked("catalogue ssrms", q)
    assert answer.status is IKStatus.SINGULAR
    assert not answer.complete
    surfaces = [
        s.family for s in answer.solutions if s.family and s.family.dimension == 2 and s.family.parameters
    ]
    assert surfaces
    assert all(abs(p.greatest - p.least) <= 2.0 * math.pi + 1e-9 for s in surfaces for p in s.parameters)
    assert holds(solver, goal._replace(tolerance=answer.tolerance), answer, q)


@pytest.mark.parametrize("elbow", [1.0, -1.0])
@pytest.mark.parametrize("away", [4e-9, 3e-8])
@pytest.mark.parametrize("name", ["catalogue rx90", "no offsets"])
def test_a_forearm_folded_onto_an_equal_upper_arm_goes_both_ways(name, away, elbow):
    """A wrist this near the shoulder: rounding makes one root of two elbows, half a turn of q_2 apart."""
    q = np.array([0.3, -1.1, 0.0, 0.9, 1.3, 0.4])
    q[2] = -RIGHT if name == "no offsets" else RIGHT
    q[2] += elbow * away
    solver, goal, answer = asked(name, q)
    assert holds(solver, goal, answer, q)
    assert answer.complete or any(s.family for s in answer.solutions)


@pytest.mark.parametrize("shoulder", [2.7, 0.3, -1.1])
@pytest.mark.parametrize("away", [3e-9, 3e-8, 1e-6])
@pytest.mark.parametrize("decimals", [17, 10])
def test_equal_links_all_but_folded_are_found_beside_the_shoulder_turned_round(shoulder, away, decimals):
    """A SCORBOT pointing straight up, its closed form a quadruple root: on the way from elbow to elbow.

    The shoulder turned round reaches the pose too, so nothing else is looked for.
    """
    q = [-1.9, shoulder, -math.pi + away, math.pi - shoulder - away, -0.3]
    solver, goal, answer = asked("catalogue scorbot", q, decimals)
    assert holds(solver, goal, answer, q)
    assert answer.complete == all(s.family is None for s in answer.solutions)


@pytest.mark.parametrize("seed", range(6))
def test_solutions_with_one_value_of_a_joint_are_told_apart(seed):
    """A Jaco in a plane: its solutions are mirror images, and two of them have one eigenvalue."""
    rng = np.random.default_rng(seed)
    q = np.array([0.0, RIGHT, math.pi, math.pi, 0.0, -RIGHT]) + 1e-6 * rng.normal(size=6) * (seed > 0)
    solver, goal, answer = asked("jaco", q, 17 if seed % 2 else 8)
    assert answer.method is Method.CLOSED_FORM
    assert answer.complete
    assert holds(solver, goal, answer, q)


def test_a_pose_that_makes_the_equations_dependent_keeps_its_own_configuration():
    """A Jaco folded into a plane, for which no eigenproblem is regular: those of poses beside it are."""
    q = [RIGHT, -math.pi, -math.pi, -RIGHT, -math.pi, 0.0]
    solver, goal, answer = asked("jaco", q)
    assert answer.method is Method.SEARCH
    assert not answer.complete
    assert holds(solver, goal, answer, q)


def test_a_walk_does_not_step_over_what_parts_two_solutions():
    """A PUMA's forearm folded onto its upper arm but for 5e-5 rad: two elbows, their q_2 a tenth apart.

    Each is a short interval within the tolerance; half way between them the pose is off by more.
    """
    q = np.random.default_rng(1).uniform(-math.pi, math.pi, (161, 6))[160]
    solver, goal, answer = asked("puma, craig", q)
    found = np.array([s.joints for s in answer.solutions])
    assert len(found) == 8
    assert holds(solver, goal, answer, q)
    assert np.abs(found - q).max(axis=1).min() < 1e-6
    other = min((s for s in found if abs(s[1] - q[1]) > 0.05), key=lambda s: np.abs(s - q).max())
    follower = Follower(solver.arm, goal.pose, goal.tolerance)
    assert np.abs(other - q).max() < 0.2
    assert not leads(follower, q[None], other[None], follower.lost)[0]


@pytest.mark.parametrize("decimals", [9, 17] if EXPLORE else [9])
@pytest.mark.parametrize(
    ("shoulder", "side"), product([0.0, math.pi], [1, -1]) if EXPLORE else [(0.0, 1), (math.pi, -1)]
)
def test_the_last_step_of_a_walk_does_not_lead_to_the_wrist_turned_over(shoulder, side, decimals):
    """A Stanford arm upright, its wrist in line: families on either side of q_4 = 0 end 1e-3 apart."""
    q = [math.pi, shoulder + 2.6e-8, -0.1699, -side * RIGHT, math.pi + side * 5e-8, 0.4]
    solver, goal, answer = asked("stanford", q, decimals)
    assert has(solver, goal, np.asarray(q), answer)
    twin = [*q[:3], q[3] + math.pi, -q[4], q[5] + math.pi]
    assert has(solver, goal, np.asarray(twin), answer)


def test_roots_that_the_tolerance_joins_are_one_where_the_arm_is_singular_twice():
    """A UR10 stretched but for 4e-4 rad, its wrist as near in line: the rounded pose is out of reach by 1e-8.

    From each root the search ends elsewhere on the bottom of one valley, which bends across both directions
    that the Jacobian hardly sees.
    """
    q = [-1.571301403942, 0.000442482748, -0.000445098513, 1.571168119182, 3.142038360705, -1.570915108085]
    solver, goal, answer = asked("catalogue ur10", q, 7)
    assert has(solver, goal, np.asarray(q), answer)
    assert answer.complete
    found = np.array([s.joints for s in answer.solutions])
    assert len(found) == 7
    assert (np.abs(found[:, 1]) < 0.1).sum() == 1


def test_a_path_does_not_change_over_to_a_family_that_it_all_but_crosses():
    """A Sawyer's axes at right angles but for 1e-4 rad: four loops, two of them 2e-4 from each other.

    Lengths of D. Layeghi, Dynamic and kinematic modelling of the Sawyer arm (2017).
    """
    lengths = zip([0.081, *[0.0] * 6], [0.317, 0.1925, 0.4, 0.1685, 0.4, 0.1363, 0.13375], strict=True)
    rows = ((-RIGHT if i < 6 else 0.0, a, d) for i, (a, d) in enumerate(lengths))
    table = numeric(Convention.STANDARD, *(("revolute", alpha, a, d, 0.0) for alpha, a, d in rows))
    q = np.array([1.571197, -1.570568, -0.000296, -3.14242, 3.141711, 1.570806, -1.570767])
    solver, pose = solver_of(table), end_pose(table, q)
    follower = Follower(solver.arm, pose, 5e-9)
    (null,) = np.linalg.svd(follower.jacobian(q))[2][6:]
    loop = path_through(follower, q, null)
    assert loop.closed
    answer = solver.solve(pose)
    assert len(answer.solutions) == 4
    assert has(solver, read_goal(pose, 5e-9, where=()), q, answer)
    # The way round is the same from wherever on the loop it is followed.
    for start in loop.points[:: len(loop.points) // 8]:
        direction = np.linalg.svd(follower.jacobian(start))[2][6]
        again = path_through(follower, start, direction)
        assert again.closed
        turn = math.tau * round((again.points[-1, 2] - again.points[0, 2]) / math.tau)
        assert abs(turn) == math.tau


@pytest.mark.parametrize("elbow", [0.4, -1.2, 2.0])
@pytest.mark.parametrize(("off", "families"), [(0.0, 2), (1e-12, 2), (9e-9, 2), (4e-7, 1)])
def test_a_path_leads_straight_across_a_family_that_it_crosses(elbow, off, families):
    """Links 2 and 3 folded: they turn together, and apart where they lie along the first one.

    Folded but for 4e-7 rad the two families are one, which leads from the one to the other way of moving.
    """
    rows = [("revolute", 0.0, a, 0.0, 0.0) for a in (0.5, 0.3, 0.3)]
    table = numeric(Convention.STANDARD, *rows)
    target = end_pose(table, [0.7, elbow, off - math.pi]).round(8)
    answer = inverse_kinematics(table, target, reach=ArmReach.POSITION)
    assert len(answer.solutions) == families
    for solution in answer.solutions if families == 2 else ():
        (parameter,) = solution.family.parameters
        assert parameter.full_turn
        assert parameter.greatest - parameter.least == pytest.approx(math.tau)
    if families == 2:
        assert {s.family.parameters[0].joint for s in answer.solutions} == {2, 3}


def test_a_forearm_on_the_upper_arm_of_an_arm_without_offsets_leaves_two_joints_free():
    """Its wrist is at the shoulder within the tolerance: any q_1, a range of q_2, and q_4 to q_6 follow."""
    q = [0.001, -0.047, -RIGHT + 4e-4, RIGHT + 6e-3, -7.5e-3, 1.88]
    solver, goal, answer = asked("no offsets", q, 4, 1e-4)
    assert any(s.family is not None and s.family.dimension == 2 for s in answer.solutions)
    assert has(solver, goal._replace(tolerance=answer.tolerance), np.asarray(q), answer)


FOLDED = np.array(
    [0.6887477559205877, -1.6867644327906026, -np.pi / 2, -0.8787464989335025, 0.0, -3.127538926378512]
)
"""The PUMA 600, its equal links folded: the wrist, which is in line, has its centre on axis 2."""


@pytest.mark.parametrize(
    ("off", "decimals"),
    [(3e-9, 12), (1e-7, 12), (1e-6, 9), *([(3e-9, 17), (1e-7, 17), (1e-7, 15)] if EXPLORE else [])],
)
def test_beside_a_folded_arm_with_its_wrist_in_line_families_are_told_and_not_samples(off, decimals):
    table = MODELS["catalogue puma600"]
    q = FOLDED + off * np.array([0, 0, 1, 0, 1, 0])
    solver, target = solver_of(table), np.round(end_pose(table, q), decimals)
    answer = solver.solve(target)
    assert 0 < len(answer.solutions) <= 8
    assert all(s.family.parameters for s in answer.solutions if s.family)
    goal = read_goal(target, None, where=())._replace(tolerance=answer.tolerance)
    assert has(solver, goal, q, answer)


@pytest.mark.parametrize(
    ("wrist", "off"), product([0.334, 0.0], [6e-9, 1e-8]) if EXPLORE else [(0.334, 6e-9), (0.0, 1e-8)]
)
def test_ways_through_gaps_are_asked_for_one_member_of_each_piece(wrist, off):
    table = MODELS["catalogue puma600"]
    q = np.array([-2.263, 0.17, -np.pi / 2 + off, -0.05, wrist + off, -2.474])
    solver, target = solver_of(table), end_pose(table, q)
    answer = solver.solve(target)
    assert 0 < len(answer.solutions) <= 8
    assert all(s.family.parameters for s in answer.solutions if s.family)
    over = q * [1, 1, 1, 1, -1, 1] + [0, 0, 0, np.pi, 0, np.pi]
    goal = read_goal(target, None, where=())._replace(tolerance=answer.tolerance)
    assert has(solver, goal, q, answer)
    assert has(solver, goal, over, answer)


def test_both_elbows_of_a_folded_arm_are_found_where_decimals_have_made_them_one():
    """The arm is 6e-5 rad from folded, the pose known to 3e-8."""
    q = [-1.570232885, -3.141581743, -1.570742996, -1.570936542, 0.000364104865, -0.0007261797588]
    solver, goal, answer = asked("catalogue puma600", q, 8)
    assert holds(solver, goal._replace(tolerance=answer.tolerance), answer, q)
    assert len(answer.solutions) == 4


@pytest.mark.parametrize("decimals", [17, 12, 9])
def test_a_stretched_arm_of_seven_joints_has_one_family_of_three_dimensions(decimals):
    table = MODELS["catalogue iiwa14"]
    answer = inverse_kinematics(table, np.round(end_pose(table, np.zeros(7)), decimals))
    (only,) = answer.solutions
    assert only.family.dimension == 3
    assert {parameter.full_turn for parameter in only.family.parameters} == {True}


@pytest.mark.parametrize(
    ("name", "q", "decimals"),
    [
        (
            "no offsets",
            (-1.4154902022e-07, 1.7190145e-07, -1.5707965797, 3.1415925772, -1.5707961293, -3.141593571),
            9,
        ),
        ("catalogue puma600", (-2.263, 0.17, -np.pi / 2 + 6e-9, -0.05, 6e-9, -2.474), 17),
    ],
    ids=["no offsets", "puma600"],
)
def test_no_family_is_told_as_a_part_of_another_too(name, q, decimals):
    """A path that was followed from one side may end where others cross it, another leads across."""
    solver, goal, answer = asked(name, q, decimals)
    curves = [s.family.members for s in answer.solutions if s.family and s.family.dimension == 1]
    followed = [np.array(members) for members in curves if members]
    for one in followed:
        for other in (other for other in followed if other is not one):
            path = FamilyPath(other, closed=False, second=np.empty(0))
            off = [np.linalg.norm(nearest_on(solver.arm, path, member)[0]) for member in one]
            assert max(off) > max(1e-3, 20 * answer.tolerance)
    assert holds(solver, goal._replace(tolerance=answer.tolerance), answer, q)
