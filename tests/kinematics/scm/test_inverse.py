"""Inverse kinematics of chains: the poses of printed robots are reached again, the nearest solution first."""

import numpy as np
import pytest

from kinematics import catalogue
from kinematics.inverse import IKStatus, solver_of
from kinematics.scm import forward_kinematics_scm, table_of_chain
from kinematics.table import bind

SIX_JOINTS = ["cloos", "kr100p", "kr125", "kr2150k", "puma560", "puma600", "stanford"]


def solved(chain, target, lengths, start=None):
    solver = solver_of(bind(table_of_chain(chain), lengths))
    return solver.nearest_first(solver.solve(target), start)


@pytest.mark.parametrize("robot_id", [*SIX_JOINTS, "onelink", "twolink", "uw", "scara-scm", "scorbot"])
def test_every_printed_robot_reaches_its_own_pose(robot_id):
    robot = catalogue.robot(robot_id)
    chain = robot.chain.read.chain
    lengths = {name: robot.parameters[known] for name, known in robot.chain.parameters.items()}
    q = [0.4, -0.7, 0.5, 0.6, 0.8, -1.1][: chain.n_joints]
    target = forward_kinematics_scm(chain, q, lengths).transform
    found = solved(chain, target, lengths, start=q)
    assert found.status is IKStatus.SOLVED
    np.testing.assert_allclose(found.solutions[0].joints, q, atol=1e-7)
    for solution in found.solutions:
        reached = forward_kinematics_scm(chain, solution.joints, lengths).transform
        np.testing.assert_allclose(reached, target, atol=1e-8)


def test_all_eight_solutions_of_the_puma():
    robot = catalogue.robot("puma560")
    lengths = {name: robot.parameters[known] for name, known in robot.chain.parameters.items()}
    chain = robot.chain.read.chain
    target = forward_kinematics_scm(chain, [0.4, 0.7, -0.5, 0.6, 0.8, -1.1], lengths).transform
    found = solved(chain, target, lengths)
    assert found.complete
    assert len(found.solutions) == 8


def test_out_of_reach_is_a_result():
    robot = catalogue.robot("twolink")
    target = np.eye(4)
    target[0, 3] = 5.0
    found = solved(robot.chain.read.chain, target, {"L1": 1.0, "L2": 1.0})
    assert found.status is IKStatus.UNREACHABLE
