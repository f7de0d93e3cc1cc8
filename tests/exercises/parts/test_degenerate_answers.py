"""Answers that say nothing: zeros in the place of numbers and functions, a motion that the arm never has."""

from typing import Any

import pytest

from exercises.grading import HelpLevel
from exercises.parts.inverse.joint_cells import JointAnswerCells
from exercises.parts.motion.jacobian_cells import JacobianCells
from exercises.parts.motion.motion_cells import MotionCells
from exercises.parts.motion.singularity_cells import SingularityCells
from kinematics.answers.joint_verdicts import JointClaim
from kinematics.answers.screw_answers import ScrewOrder
from tests.exercises.answering import codes, judged, part


@pytest.mark.parametrize(
    ("lost", "level", "told"),
    [
        ((0, 0, 0), HelpLevel.REPAIR, "lost_motion_zero"),
        ((0, 0, 0), HelpLevel.ROW, "lost_motion_zero"),
        ((0, 0, 1), HelpLevel.REPAIR, "lost_motion_never"),
        ((0, 0, 1), HelpLevel.ROW, "lost_motion_wrong"),
    ],
)
def test_why_a_vector_is_no_lost_motion(lost: Any, level: HelpLevel, told: str) -> None:
    cells = SingularityCells(conditions=(("sin(q2)",),), lost=lost)
    found = part(judged("twolink-singularities", help_level=level, singularities=cells), "singularities")
    assert (codes(found), found.score) == ([told], 0.75)


def test_a_combination_of_zeros_says_nothing() -> None:
    cells = JointAnswerCells(claim=JointClaim.FINITE, solutions=((30, 60), (0, 0)), combinations=((0, 0),))
    found = part(judged("twolink-inverse", inverse_kinematics=cells), "inverse_kinematics")
    assert "joints_combination_zero" in codes(found)
    assert "joints_combination_wrong" not in codes(found)


def test_right_joint_values_that_earn_nothing_are_told_why() -> None:
    """The claim of infinitely many and a wrong combination take off both of the right rows."""
    rows = ((30, 60), (90, -60))
    for combinations, taken_off in (((), False), (((1, 0),), True)):
        cells = JointAnswerCells(claim=JointClaim.INFINITE, solutions=rows, combinations=combinations)
        found = part(judged("twolink-inverse", inverse_kinematics=cells), "inverse_kinematics")
        assert ("joints_taken_off" in codes(found), found.score == 0.0) == (taken_off, taken_off)


def motion(exercise_id: str, **cells: Any) -> float:
    given = {name: value for name, value in cells.items() if value is not None}
    report = judged(exercise_id, equations_of_motion=MotionCells(**given))
    return part(report, "equations_of_motion").score


@pytest.mark.parametrize(
    ("exercise_id", "n"), [("scara-dynamics", 4), ("uw-dynamics", 3), ("twolink-dynamics", 2)]
)
def test_zeros_earn_nothing_in_equations_of_motion(exercise_id: str, n: int) -> None:
    row = (0,) * n
    asks_matrix = exercise_id == "twolink-dynamics"
    velocity = {"coriolis": (row,) * n} if asks_matrix else {"velocity": row}
    assert motion(exercise_id, mass=(row,) * n, gravity=row, **velocity) == 0.0


def test_gravity_of_the_wrong_sign_earns_nothing_where_one_joint_bears_it() -> None:
    third = "g*(m3 + m4)"
    assert motion("scara-dynamics", gravity=(0, 0, third, 0)) == pytest.approx(1 / 3)
    assert motion("scara-dynamics", gravity=(0, 0, f"-{third}", 0)) == 0.0


def test_joint_forces_of_zero_earn_nothing() -> None:
    """A vertical force does nothing about the vertical axis of joint 1."""
    for kind, exercise_id, n in (
        ("jacobian", "stanford-jacobian", 6),
        ("jacobian_form", "twolink-jacobian-form", 2),
    ):
        cells = JacobianCells(order=ScrewOrder.LINEAR_FIRST, jacobian=((0,) * n,) * 6, forces=(0,) * n)
        found = part(judged(exercise_id, **{kind: cells}), kind)
        assert (found.score, codes(found)) == (0.0, ["jacobian_wrong", "forces_wrong"])


@pytest.mark.parametrize(("length", "right"), [("(L2 + 0.004)", False), ("1.001*L2", False), ("L2", True)])
def test_names_in_a_jacobian_are_exact(length: str, right: bool) -> None:
    zeros = (("0", "0"),) * 3
    rows = (("-L1*s1 - L2*s12", f"-{length}*s12"), ("L1*c1 + L2*c12", "L2*c12"), *zeros, ("1", "1"))
    cells = JacobianCells(order=ScrewOrder.LINEAR_FIRST, jacobian=rows)
    found = part(judged("twolink-jacobian-form", jacobian_form=cells), "jacobian_form")
    assert ("jacobian_wrong" not in codes(found)) is right


def test_no_place_is_told_where_a_condition_that_always_holds_does_not() -> None:
    cells = SingularityCells(conditions=(("sin(q2) = cos(90 - q2)",),), lost=(1, 0, 0))
    found = part(judged("twolink-singularities", singularities=cells), "singularities")
    assert "singularity_everywhere" in codes(found)
    assert "singularity_missing_at" not in codes(found)


@pytest.mark.parametrize(("angle", "close"), [("0.7", True), ("20.5", False)])
def test_a_condition_that_is_almost_a_singularity_is_told_to_be_rounded(angle: str, close: bool) -> None:
    cells = SingularityCells(conditions=((f"q2 = {angle}, 180",),), lost=(1, 2, 3))
    report = judged("twolink-singularities", help_level=HelpLevel.REPAIR, singularities=cells)
    told = codes(part(report, "singularities"))
    assert "singularity_invented_at" in told
    assert ("singularity_rounded" in told) is close
