"""Answers that say nothing: a vector of zeros, a combination of zeros, a motion that the arm never has."""

from __future__ import annotations

from typing import Any

import pytest

from exercises.grading import HelpLevel
from exercises.parts.joint_solutions import JointAnswerCells
from exercises.parts.singularities import SingularityCells
from kinematics.answers.joint_verdicts import JointClaim
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
