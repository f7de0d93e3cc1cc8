"""Families are followed no further than a count of corrections; what is left over is told as what it is."""

import numpy as np
import pytest

from kinematics.forward import end_pose
from kinematics.inverse import ArmReach, newton, solver_of
from kinematics.inverse.goals import read_goal
from kinematics.inverse.results import Isolation, UnreachableReason
from kinematics.inverse.search import MOST_STARTS
from kinematics.inverse.self_motions import corrections, families, membership, paths, walks
from kinematics.inverse.self_motions.families import Follower, null_space
from kinematics.inverse.self_motions.membership import Component, Membership
from kinematics.inverse.self_motions.paths import path_through
from kinematics.inverse.self_motions.walks import leads
from kinematics.table import Convention
from tests.kinematics.inverse.models import MODELS
from tests.kinematics.robots import PUMA560, numeric

LONGEST_PATH = 2 * paths.MOST_STEPS

STRETCHED = np.radians([30, -90, 90, 20, 0, -80])


def counted(monkeypatch):
    """A list that grows by one with every correction."""
    calls = []
    correct = corrections.corrected_across

    def corrected(arm, targets, x, across):
        calls.append(len(x))
        return correct(arm, targets, x, across)

    for module in (corrections, paths, walks):
        monkeypatch.setattr(module, "corrected_across", corrected)
    return calls


@pytest.mark.parametrize(
    ("name", "reach", "target", "tolerance"),
    [
        ("catalogue cloos", ArmReach.AXIS, np.eye(4), 1e-2),
        ("catalogue cloos", ArmReach.POSE, np.eye(4), 1e-2),
        ("panda", ArmReach.POSE, end_pose(MODELS["panda"], np.zeros(7)), 1e-2),
    ],
)
def test_following_is_bounded_by_a_count(name, reach, target, tolerance, monkeypatch):
    calls = counted(monkeypatch)
    solver = solver_of(MODELS[name], reach=reach)
    answer = solver.solve(target, tolerance)
    assert answer.solutions
    assert not answer.complete
    assert len(calls) <= families.MOST_CORRECTIONS + LONGEST_PATH


def test_what_is_left_over_is_a_member_of_a_continuum(monkeypatch):
    monkeypatch.setattr(families, "MOST_CORRECTIONS", 1)
    calls = counted(monkeypatch)
    answer = solver_of(PUMA560).solve(end_pose(PUMA560, STRETCHED))
    assert not answer.complete
    assert len([s for s in answer.solutions if s.isolation is Isolation.ISOLATED]) <= 8
    assert any(s.family is not None and not s.family.parameters for s in answer.solutions)
    assert len(calls) <= LONGEST_PATH
    assert any(s.family is not None and s.family.parameters for s in answer.solutions)


FOLDED = numeric(
    Convention.MODIFIED,
    ("revolute", -np.pi / 2, 0.0, 0.0, np.pi / 2),
    ("revolute", -np.pi / 2, -0.3046620843964265, -0.3272667148067353, np.pi / 2),
    ("revolute", 0.0, 0.0, 0.2, 0.0),
)
IN_MILLIMETRES = numeric(
    Convention.STANDARD, ("revolute", 0.0, 400.0, 0.0, 0.0), ("revolute", 0.0, 400.0, 0.0, 0.0)
)


def rounded(table, joints, decimals_of_rotation, decimals_of_position):
    target = end_pose(table, joints).round(decimals_of_rotation)
    target[:3, 3] = target[:3, 3].round(decimals_of_position)
    return target


@pytest.mark.parametrize(
    ("table", "target", "most"),
    [
        (
            FOLDED,
            rounded(FOLDED, [3.141592652661614, 3.141592653913599, 1.5707963269782905], 8, 8),
            MOST_STARTS,
        ),
        (IN_MILLIMETRES, rounded(IN_MILLIMETRES, [0.01, 0.01], 10, 7), MOST_STARTS // 4),
    ],
)
def test_a_pose_just_out_of_reach_is_not_weighed_again_and_again(table, target, most, monkeypatch):
    calls = []
    polish = newton.polish

    def polished(arm, targets, joints):
        calls.append(len(joints))
        return polish(arm, targets, joints)

    monkeypatch.setattr(newton, "polish", polished)
    answer = solver_of(table).solve(target)
    assert answer.reason is UnreachableReason.OUT_OF_REACH
    assert answer.nearest.position_error > answer.tolerance
    assert len(calls) < most


def test_of_no_pairs_none_is_led():
    solver = solver_of(MODELS["catalogue rx90"])
    goal = read_goal(end_pose(solver.table, np.zeros(6)), None, where=())
    nothing = np.empty((0, 6))
    assert not len(leads(Follower(solver.arm, goal.pose, goal.tolerance), nothing, nothing, 1e-6))


def followed():
    """A Panda's follower at a pose, a solution, and the path of its family."""
    q = np.array([0.3, -0.7, 0.5, -1.1, 0.2, 0.9, 0.4])
    arm = solver_of(MODELS["panda"]).arm
    follower = Follower(arm, end_pose(MODELS["panda"], q), 1e-9)
    (direction,) = null_space(follower.jacobian(q / arm.units), 1e-6)
    return follower, q, path_through(follower, q / arm.units, direction)


def test_many_solutions_are_looked_for_on_a_path_together(monkeypatch):
    follower, q, path = followed()
    one = Component(q, (path,), 1)
    rng = np.random.default_rng(3)
    beside = path.points[1:-1] + 0.01 * rng.normal(size=path.points[1:-1].shape)
    between = 0.5 * (path.points[1:] + path.points[:-1])[4:]
    asked = np.concatenate((beside, between))
    members = Membership(follower.arm, follower, follower.tolerance)
    calls = counted(monkeypatch)
    left = members.outside(asked, [one])
    assert len(calls) <= 3
    assert [members.within(one, joints) for joints in asked] == [
        joints.tolist() not in left.tolist() for joints in asked
    ]
    assert any(members.within(one, joints) for joints in between)


def evaluations(monkeypatch):
    """How many errors and Jacobians corrections evaluate, call by call."""
    calls = []
    evaluate = corrections.errors_and_jacobians

    def evaluated(arm, x, target):
        calls.append(len(x))
        return evaluate(arm, x, target)

    monkeypatch.setattr(corrections, "errors_and_jacobians", evaluated)
    return calls


def test_corrections_of_a_bent_path_start_where_it_bends(monkeypatch):
    calls = evaluations(monkeypatch)
    steps = counted(monkeypatch)
    _, _, path = followed()
    assert len(path.points) > 50
    assert len(calls) <= 3.6 * len(steps)


def test_what_misses_a_rounded_target_is_not_corrected_on(monkeypatch):
    """The slide of a Stanford arm all but drawn in, its pose known to 1e-4: what is missed by stays."""
    calls = evaluations(monkeypatch)
    corrected = counted(monkeypatch)
    table = MODELS["catalogue stanford"]
    q = [-0.76087301, 0.43248765, -0.014916628, 0.135530992, 2.471018047, 2.20923204]
    solver_of(table).solve(end_pose(table, q).round(4), 1e-4)
    assert len(corrected) > 200
    assert len(calls) <= 4.5 * len(corrected)


def test_of_walks_from_a_solution_one_is_asked_for_jumps(monkeypatch):
    """An RX-90 folded: all solutions are on one surface, which many ways lead to."""
    table = MODELS["catalogue rx90"]
    calls = counted(monkeypatch)
    q = [0.0, -np.pi / 2, np.pi / 2, -0.429484488, -1.074380541, np.pi / 2]
    (only,) = solver_of(table).solve(end_pose(table, q)).solutions
    assert only.family.dimension == 2
    assert sum(calls) <= 9000


def test_branches_of_a_path_are_looked_for_on_a_surface_together(monkeypatch):
    """An RX-90 folded but for 1e-8 rad, its wrist as near to its line: surfaces with many branches."""
    asked = []
    walk = membership.lead_to_one

    def walked(follower, starts, places, lost):
        asked.append(len(starts))
        return walk(follower, starts, places, lost)

    monkeypatch.setattr(membership, "lead_to_one", walked)
    table = MODELS["catalogue rx90"]
    q = [-1.570796301, -4.4e-08, 1.570796317, -3.091523851, 4.5e-08, 2.160522926]
    assert solver_of(table).solve(end_pose(table, q)).solutions
    assert len(asked) <= 25
    assert max(asked) > 1


def test_what_has_arrived_is_not_polished_on(monkeypatch):
    calls = []
    errors = newton.errors_of

    def counted_errors(arm, poses, target):
        calls.append(len(poses))
        return errors(arm, poses, target)

    monkeypatch.setattr(newton, "errors_of", counted_errors)
    q = np.array([0.3, -0.7, 1.2, 0.5, 0.9, -1.4])
    arm, target = solver_of(PUMA560).arm, end_pose(PUMA560, q)
    starts = np.array([q + 1e-6, q + 0.1, -q])
    alone = [newton.polish(arm, target, start[None])[0] for start in starts]
    rows = sum(calls)
    calls.clear()
    together = newton.polish(arm, target, starts)
    assert sum(calls) == rows
    assert together == pytest.approx(np.array(alone), abs=1e-14)
