"""Screws and a home pose: right in any frame, sense and zero; slips are told."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from kinematics.answers.screw_answers import (
    ScrewAnswer,
    ScrewFrame,
    ScrewMistake,
    adjoint,
    judge_screws,
)
from kinematics.equivalence import BaseRule, DirectionRule, Policy, Tolerance, ToolRule, ZeroRule
from kinematics.screws import product_of_exponentials
from kinematics.se3 import inverse_transform
from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.kinematics.answers.joint_values import robot
from tests.kinematics.answers.screw_rows import POLICY, motion

SCARA = robot("scara")
PUMA = robot("puma560")
FIXED = Policy(tool=ToolRule.POINT)
ROUNDED = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=0.005, angle=0.005))


def key(table=PUMA) -> ScrewAnswer:
    found = product_of_exponentials(table)
    rows = np.array([[*screw.linear, *screw.angular] for screw in found.screws])
    return ScrewAnswer(screws=rows, home=found.home)


def slips(answer: ScrewAnswer, table=PUMA, policy=POLICY):
    found = judge_screws(table, answer, policy)
    assert not found.right
    return found.mistakes


def test_either_sense_and_any_length_of_a_slider_are_right() -> None:
    right = key(SCARA)
    for i in range(4):
        turned = right.screws.copy()
        turned[i] *= -1
        assert judge_screws(SCARA, replace(right, screws=turned), POLICY).right
    longer = right.screws.copy()
    longer[2] *= 0.001
    assert judge_screws(SCARA, replace(right, screws=longer), POLICY).right


def test_axes_that_meet_in_one_point_are_right_in_any_frame() -> None:
    """Such a robot has no length, and what the arithmetic leaves of zero is none either."""
    rows = tuple(
        DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=0.0, alpha=alpha) for alpha in (-1.2, 0.7)
    )
    for n in (1, 2):
        wrist = DHTable(convention=Convention.STANDARD, rows=rows[:n])
        right = key(wrist)
        for angle in np.linspace(0.1, 3.0, 12):
            c, s = math.cos(angle), math.sin(angle)
            turn = np.array(
                [[c, -s, 0, 0.7], [c * s, c * c, -s, -0.4], [s * s, s * c, c, angle], [0, 0, 0, 1]]
            )
            moved = ScrewAnswer(screws=right.screws @ adjoint(turn).T, home=turn @ right.home)
            assert judge_screws(wrist, moved, POLICY).right
            apart = moved.home.copy()
            apart[:3, 3] += 0.1 * moved.home[:3, 0]
            assert judge_screws(wrist, replace(moved, home=apart), FIXED).right is False


def test_the_robot_that_breaks_a_rule_is_still_the_robot() -> None:
    """The rule is named without which the answer would be right, if there is only one."""
    strict = Policy(
        base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
    )
    right = key(SCARA)

    def broken(policy: Policy = strict, **changes: np.ndarray) -> tuple[str, ...] | None:
        found = judge_screws(SCARA, replace(right, **changes), policy)
        assert not found.right
        return found.broken

    reversed_slide = right.screws * np.array([[1], [1], [-1], [1]])
    assert broken(screws=reversed_slide) == ("direction",)
    turned = right.home @ np.diag([1.0, -1.0, -1.0, 1.0])
    assert broken(home=turned) == ("tool",)
    assert broken(POLICY, screws=right.screws * np.array([1, 2, 1, 1, 1, 1])) is None  # another length
    lower = right.home.copy()
    lower[2, 3] -= 0.2  # the base, the tool or the zero of the slide
    assert broken(home=lower) == ()
    moved = right.home.copy()
    moved[0, 3] += 0.1
    assert broken(FIXED, home=moved) == ("tool",)


def test_slips_are_told() -> None:
    right = key()
    minus = right.screws * np.array([-1, -1, -1, 1, 1, 1])
    assert slips(replace(right, screws=minus)) == ((ScrewMistake.MOMENT_SIGN, None),)
    one = right.screws.copy()
    one[2] = minus[2]
    assert slips(replace(right, screws=one)) == ((ScrewMistake.MOMENT_SIGN, 3),)
    halves = np.hstack([right.screws[:, 3:], right.screws[:, :3]])
    assert slips(replace(right, screws=halves)) == ((ScrewMistake.HALVES, None),)
    double = right.screws.copy()
    double[1] *= 2
    assert slips(replace(right, screws=double)) == ((ScrewMistake.NOT_UNIT, 2),)
    pitched = right.screws.copy()
    pitched[0] = [0, 0, 0.3, 0, 0, 1]
    assert slips(replace(right, screws=pitched)) == ((ScrewMistake.PITCH, 1),)
    sliding = right.screws.copy()
    sliding[0] = [0, 0, 1, 0, 0, 0]
    assert slips(replace(right, screws=sliding)) == ((ScrewMistake.JOINT_TYPE, 1),)
    skew = right.home.copy()
    skew[:3, :3] *= 2
    assert slips(replace(right, home=skew)) == ((ScrewMistake.NOT_RIGID, None),)


def test_body_for_space_and_another_home_are_told() -> None:
    right = key(SCARA)
    assert slips(replace(right, frame=ScrewFrame.BODY), SCARA, FIXED) == ((ScrewMistake.OTHER_FRAME, None),)
    away = right.home.copy()
    away[0, 3] += 0.1
    assert slips(replace(right, home=away), SCARA, FIXED) == ((ScrewMistake.HOME, None),)
    assert slips(replace(right, home=inverse_transform(right.home)), SCARA, FIXED)


def alike(answer: ScrewAnswer) -> dict[tuple[int, int], bool]:
    pairs = judge_screws(SCARA, answer, FIXED).pairs
    return {(pair.first, pair.second): pair.alike for pair in pairs}


def test_a_row_that_is_no_screw_of_its_joint_spoils_its_own_relations_alone() -> None:
    right = key(SCARA)
    turning = right.screws.copy()
    turning[2] = [0, 0, 0, 0, 0, 1]
    assert slips(replace(right, screws=turning), SCARA, FIXED) == ((ScrewMistake.JOINT_TYPE, 3),)
    own = {(1, 2): True, (2, 3): False, (3, 4): False, (2, 4): True}
    assert alike(replace(right, screws=turning)) == own
    nothing = right.screws.copy()
    nothing[2] = 0
    assert alike(replace(right, screws=nothing)) == own
    double = right.screws.copy()
    double[0] *= 2
    halves = np.hstack([right.screws[:, 3:], right.screws[:, :3]])
    mirrored = right.home @ np.diag([1.0, 1.0, -1.0, 1.0])
    for answer in (
        replace(right, screws=double),
        replace(right, screws=halves),
        replace(right, home=mirrored),
    ):
        assert all(alike(answer).values())


def test_a_length_across_a_slider_is_a_relation() -> None:
    """Joints 2 and 4 of a SCARA turn about parallel axes, and the slider between goes along both."""
    right = key(SCARA)
    shorter = right.screws.copy()
    shorter[3] = shorter[1]
    assert not slips(replace(right, screws=shorter), SCARA, FIXED)
    assert alike(replace(right, screws=shorter)) == {(1, 2): True, (2, 3): True, (3, 4): True, (2, 4): False}


def test_a_sign_or_an_inverted_home_pose_look_alike_between_parallel_axes() -> None:
    right = key(SCARA)
    minus = right.screws * [-1, -1, -1, 1, 1, 1]
    minus[2] = right.screws[2]
    assert slips(replace(right, screws=minus), SCARA, FIXED) == ((ScrewMistake.SIGN_OR_HOME, None),)
    inverted = replace(right, home=inverse_transform(right.home))
    assert slips(inverted, SCARA, FIXED) == ((ScrewMistake.SIGN_OR_HOME, None),)


@pytest.mark.parametrize("value", [0.0, 1e-300, 1e6])
def test_degenerate_screws_are_judged(value) -> None:
    rows = np.full((6, 6), value)
    assert not judge_screws(PUMA, ScrewAnswer(screws=rows, home=np.eye(4)), POLICY).right
    assert not judge_screws(PUMA, replace(key(), home=np.full((4, 4), value)), POLICY).right


def test_screws_rounded_to_three_digits_have_no_pitch() -> None:
    """An axis that passes near the origin has a small v, and v·ω is what rounding leaves of zero."""
    scorbot = robot("scorbot")
    exact = key(scorbot)
    rng = random.Random(5)
    for _ in range(60):
        frame = motion(rng, 0.02)
        moved = replace(exact, screws=exact.screws @ adjoint(frame).T, home=frame @ exact.home)
        rounded = ScrewAnswer(screws=np.round(moved.screws, 3), home=np.round(moved.home, 3))
        judged = judge_screws(scorbot, rounded, ROUNDED)
        assert not any(mistake is ScrewMistake.PITCH for mistake, _ in judged.mistakes)


def test_a_pitch_is_told_however_far_the_frame_lies() -> None:
    right = key()
    frame = np.eye(4)
    frame[0, 3] = 50.0
    moved = replace(right, screws=right.screws @ adjoint(frame).T, home=frame @ right.home)
    assert judge_screws(PUMA, moved, POLICY).right
    pitched = moved.screws.copy()
    pitched[1, :3] += 0.1 * pitched[1, 3:]
    assert slips(replace(moved, screws=pitched)) == ((ScrewMistake.PITCH, 2),)


@pytest.mark.parametrize("table", [PUMA, SCARA])
@pytest.mark.parametrize("unit", [1000.0, 100.0, 0.001])
def test_lengths_in_another_unit_are_told(table: DHTable, unit: float) -> None:
    right = key(table)
    screws, home = right.screws.copy(), right.home.copy()
    screws[screws[:, 3:].any(axis=1), :3] *= unit
    told = ((ScrewMistake.LENGTH_UNIT, None),)
    assert slips(replace(right, screws=screws), table, FIXED) == told
    home[:3, 3] *= unit
    assert slips(replace(right, screws=screws, home=home), table, FIXED) == told


def test_rows_in_another_order_are_told() -> None:
    right = key()
    for i, changed in ((1, [1, 0, 2, 3, 4, 5]), (4, [0, 1, 2, 4, 3, 5])):
        assert slips(replace(right, screws=right.screws[changed])) == ((ScrewMistake.EXCHANGED, i),)
    assert slips(replace(right, screws=right.screws[::-1])) == ((ScrewMistake.REVERSED, None),)
