"""Solutions that rounding takes from the equations of a general arm, and answers that lack one."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from kinematics.forward import end_pose
from kinematics.inverse import IKStatus, solver_of
from kinematics.inverse.goals import read_goal
from kinematics.inverse.methods.closed_form import InverseClosedForm
from kinematics.inverse.results import Method
from tests.kinematics.inverse.arms import GENERAL, UR5
from tests.kinematics.inverse.campaign import has, posed
from tests.kinematics.inverse.models import MODELS

RIGHT = np.pi / 2

FOLDED = {
    "two roots 0.02 rad apart with one q3": (
        "mico", 7, [3.1416421193908257, -3.141524348279931, -3.141632852242063, -1.5707945011587385,
                    3.1416247395747674, 1.5708117781427138]),
    "all decimals": (
        "mico", 17, [-6.505065861064094e-05, -3.1418428875667206, -3.1415565414128364, -3.1420335254353304,
                     -3.141242121768956, 3.1417016229137134]),
    "an arm folded but for 9e-4 rad": (
        "jaco", 17, [-0.00029417365740508366, -3.1411655300136365, 0.00033116174730159664,
                     -3.141092338284532, -3.141925868650957, 1.5709550414459914]),
    "12 decimals": (
        "jaco", 12, [3.1417397079169134, -3.141594066292777, 3.1415770182013114, -1.5707740689432548,
                     -3.1415641495408106, -1.0545430730709933]),
}  # fmt: skip
"""Arms all but folded into a plane: roots of their equations are nearer to each other than these have digits,
and come out as a complex pair."""


@pytest.mark.parametrize("case", FOLDED)
def test_of_two_roots_that_come_out_as_a_complex_pair_neither_is_lost(case):
    name, decimals, q = FOLDED[case]
    solver, pose, tolerance = posed(name, q, decimals)
    goal = read_goal(pose, tolerance, where=())
    answer, direct = solver.solve(pose, tolerance), solver.solve_directly(pose, tolerance)
    assert answer.complete
    assert has(solver, goal, np.array(q), answer)
    assert direct is None or len(direct.solutions) == len(answer.solutions)


OUT_OF_REACH = {
    "by less than the tolerance of 9 decimals": (
        "jaco", 9, [8.22e-10, 1.570796329976, 3.02961857118, 1.57079633585, -6.22e-10, -3.141592653415]),
    "of 8": (
        "jaco", 8, [-4.38668e-07, 1.570794710517, -0.428570110405, 1.570796226428, 5.87234e-07,
                    -3.141591119179]),
    "by less than one of 6": (
        "mico", 6, [1.57081241611727, 3.1415888355137658, -3.1416369834920364, -1.57077818445705,
                    -3.141565190009766, 3.141606109281737]),
    "of a fold that is hardly bent": (
        "jaco", 6, [-1.5707959751199714, 1.570796478729247, 1.0891561068471334, -2.9135835673424326,
                    3.1415925627859833, 1.5707964041830413]),
    "beside two solutions 0.2 rad away": (
        "mico", 10, [-1.7235214147649857e-13, -7.873138482834512e-13, 1.5707963267945404, -3.141592653590118,
                     1.5707963267952096, 1.4128581636965314e-13]),
}  # fmt: skip


@pytest.mark.parametrize("case", OUT_OF_REACH)
def test_a_fold_that_rounding_puts_out_of_reach_is_a_solution(case):
    name, decimals, q = OUT_OF_REACH[case]
    solver, pose, tolerance = posed(name, q, decimals)
    answer = solver.solve(pose, tolerance)
    assert has(solver, read_goal(pose, tolerance, where=()), np.array(q), answer)


@dataclass(frozen=True)
class _WithoutOne:
    """A closed form that loses a root: the one nearest to a configuration."""

    whole: InverseClosedForm
    lost: np.ndarray

    def candidates(self, target):
        found = self.whole.candidates(target)
        return found[np.abs(found - self.lost).max(axis=1) > 1e-3]


@pytest.mark.parametrize("table", [GENERAL, UR5, MODELS["mico"]], ids=["general", "ur5", "mico"])
def test_an_answer_that_lacks_a_solution_is_not_complete(table):
    q = np.array([0.3, -0.7, 1.2, 0.5, 0.9, -1.4])
    target, solver = end_pose(table, q), solver_of(table)
    whole = solver.solve(target)
    lossy = replace(solver, closed_form=_WithoutOne(solver.closed_form, q))
    answer = lossy.solve(target)
    assert whole.complete
    assert len(answer.solutions) == len(whole.solutions) - 1
    assert answer.method is Method.CLOSED_FORM
    assert not answer.complete
    assert lossy.solve_directly(target) is None


def test_out_of_limits_is_not_certain_where_a_solution_was_lost():
    """One solution is left to look for, and limits that none of those found is within."""
    q = np.array([0.3, -0.7, 1.2, 0.5, 0.9, -1.4])
    target = end_pose(GENERAL, q)
    nowhere = [(3.0, 3.001)] * 6
    solver = solver_of(GENERAL, limits=nowhere)
    lossy = replace(solver, closed_form=_WithoutOne(solver.closed_form, q))
    for one, certain in ((solver, True), (lossy, False)):
        answer = one.solve(target)
        assert answer.status is IKStatus.UNREACHABLE
        assert answer.complete is certain
