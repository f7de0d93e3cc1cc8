"""Joint values that reach a pose: right ones however they are written, families, none, and usual slips."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.answers.joint_answers import in_other_frames, judge_joints
from kinematics.answers.joint_questions import joint_question
from kinematics.answers.joint_verdicts import Branch, JointAnswer, JointClaim, JointMistake
from kinematics.inverse import ArmReach, solver_of
from tests.kinematics.answers.joint_values import product, robot

PUMA = robot("puma560")
Q = (0.3, -0.5, 0.4, 0.6, 0.7, -0.2)


def asked(q=Q, table=PUMA, **options):
    solver = solver_of(table, reach=options.get("reach", ArmReach.POSE))
    return joint_question(solver, product(table, q), **options)


def finite(*rows):
    return JointAnswer(claim=JointClaim.FINITE, rows=tuple(tuple(row) for row in rows))


@pytest.mark.parametrize(
    ("joint", "value", "mistake"),
    [
        (1, Q[0] + math.pi, JointMistake.QUADRANT),
        (4, -Q[3], JointMistake.SIGN),
        (6, math.pi / 2 - Q[5], JointMistake.SWAPPED),
    ],
)
def test_a_slip_in_one_joint_is_told(joint, value, mistake) -> None:
    row = [*Q[: joint - 1], value, *Q[joint:]]
    found = judge_joints(asked(every=False), finite(row))
    assert not found.right
    assert (found.rows[0].joint, found.rows[0].mistake) == (joint, mistake)


def test_degrees_and_half_of_a_pose_are_told() -> None:
    degrees = judge_joints(asked(every=False), finite([math.degrees(q) for q in Q]))
    assert degrees.rows[0].mistake is JointMistake.DEGREES
    turned = judge_joints(asked(every=False), finite([*Q[:5], Q[5] + 0.5]))
    assert turned.rows[0].mistake is JointMistake.POSITION_ONLY
    found = judge_joints(asked(every=False), finite([q + 0.4 for q in Q]))
    assert found.rows[0].mistake is None


def test_a_solution_in_whole_degrees_is_close_and_no_branch_is_missing() -> None:
    question = asked()
    rows = [
        [math.radians(round(math.degrees(q))) for q in found.joints] for found in question.found.solutions
    ]
    found = judge_joints(question, finite(*rows))
    assert {row.mistake for row in found.rows if not row.right} == {JointMistake.ROUNDED}
    assert found.missing == ()


@pytest.mark.parametrize("value", [1.7e308, -1e160, 1e20])
def test_no_joint_value_is_too_large_to_be_judged_beside_a_family(value) -> None:
    question = asked((*Q[:4], 0.0, Q[5]))
    for row in ((*Q[:3], value, 0.0, -value), (value,) * 6, (value, -value) * 3):
        found = judge_joints(question, finite(row))
        assert found.rows[0].mistake is not JointMistake.ROUNDED


@pytest.mark.parametrize("signs", [(1, -1, 1, 1, -1, 1), (-1,) * 6])
def test_slips_are_those_of_the_answerers_own_variables(signs) -> None:
    question = asked(every=False)
    offsets = (0.5, -1.2, math.pi / 2, 0.3, -0.7, 1.1)
    own = [s * q + d for s, q, d in zip(signs, Q, offsets, strict=True)]

    def told(row):
        (found,) = judge_joints(question, in_other_frames(finite(row), signs, offsets)).rows
        return found.mistake, found.joint

    for i in range(6):
        before, after = own[:i], own[i + 1 :]
        assert told([*before, -own[i], *after]) == (JointMistake.SIGN, i + 1)
        assert told([*before, own[i] + math.pi, *after]) == (JointMistake.QUADRANT, i + 1)
        assert told([*before, math.pi / 2 - own[i], *after]) == (JointMistake.SWAPPED, i + 1)
        of_the_key = signs[i] * -Q[i] + offsets[i]
        assert told([*before, of_the_key, *after])[0] is not JointMistake.SIGN
    assert told([math.degrees(q) for q in own])[0] is JointMistake.DEGREES


def test_missing_branches_are_named() -> None:
    question = asked()
    rows = [found.joints for found in question.found.solutions]
    assert len(rows) == 8
    for k in range(8):
        found = judge_joints(question, finite(*rows[:k], *rows[k + 1 :]))
        assert found.missing == (Branch.WRIST,)
        assert found.share == pytest.approx(7 / 8)
    without = [row for row in rows if abs(math.remainder(row[0] - Q[0], math.tau)) < 1e-6]
    found = judge_joints(question, finite(*without))
    assert set(found.missing) == {Branch.SHOULDER}
    one_elbow = [row for row in without if abs(math.remainder(row[1] - Q[1], math.tau)) < 1e-6]
    assert Branch.ELBOW in judge_joints(question, finite(*one_elbow)).missing


def test_a_stretched_wrist_is_answered_with_its_condition() -> None:
    question = asked((*Q[:4], 0.0, Q[5]))
    assert question.expected is JointClaim.INFINITE
    rows = tuple(found.joints for found in question.found.solutions)
    condition = (0.0, 0.0, 0.0, 2.0, 0.0, 2.0)
    answer = JointAnswer(claim=JointClaim.INFINITE, rows=rows, combinations=(condition,))
    assert judge_joints(question, answer).right
    elsewhere = tuple(
        (*row[:3], row[3] + 1, row[4], row[5] - 1) if abs(row[4]) < 1e-9 else row for row in rows
    )
    assert judge_joints(question, replace(answer, rows=elsewhere)).right
    other = judge_joints(question, replace(answer, combinations=((0, 0, 0, 1, 0, -1),)))
    assert not other.right
    assert other.combinations == (False,)
    assert judge_joints(question, replace(answer, combinations=())).combination_missing
    assert not judge_joints(question, replace(answer, claim=JointClaim.FINITE)).right
    assert not judge_joints(question, replace(answer, rows=rows[1:])).right or len(rows) == 1


def test_a_pose_that_cannot_be_reached() -> None:
    target = product(PUMA, Q)
    target[:3, 3] *= 9
    question = joint_question(solver_of(PUMA), target)
    assert question.expected is JointClaim.OUT_OF_REACH
    assert judge_joints(question, JointAnswer(claim=JointClaim.OUT_OF_REACH)).right
    assert judge_joints(question, JointAnswer(claim=JointClaim.JOINT_LIMITS)).share == 0.5
    assert judge_joints(question, finite(Q)).share == 0


def test_limits_are_counted_modulo_full_turns() -> None:
    narrow = [(q - 0.1, q + 0.1) for q in Q]
    question = joint_question(solver_of(PUMA, limits=narrow), product(PUMA, Q))
    assert judge_joints(question, finite([q + math.tau for q in Q])).right
    flipped = [*Q[:3], Q[3] + math.pi, -Q[4], Q[5] + math.pi]
    found = judge_joints(question, finite(flipped))
    assert found.rows[0].mistake is JointMistake.LIMITS
    away = [(q + 1, q + 1.1) for q in Q]
    question = joint_question(solver_of(PUMA, limits=away), product(PUMA, Q))
    assert judge_joints(question, JointAnswer(claim=JointClaim.JOINT_LIMITS)).right


def test_a_stretched_arm_has_one_solution() -> None:
    table = robot("twolink")
    reach = ArmReach.POSITION
    question = joint_question(solver_of(table, reach=reach), product(table, (0.4, 0.0)), reach=reach)
    assert judge_joints(question, finite((0.4, 0.0))).right
    assert judge_joints(question, finite((0.4 - math.tau, math.tau))).right


def test_a_joint_turned_over_alone_is_half_a_branch() -> None:
    """To say that its sign is wrong would lead back to the row that is there."""
    table = robot("twolink")
    question = asked((0.4, 0.9), table, reach=ArmReach.POSITION)
    up, down = (found.joints for found in question.found.solutions)
    found = judge_joints(question, finite(up, (up[0], -up[1])))
    assert (found.rows[1].mistake, found.rows[1].joint, found.rows[1].other) == (
        JointMistake.HALF_BRANCH,
        2,
        0,
    )
    assert found.missing == (Branch.ELBOW,)
    alone = judge_joints(question, finite((up[0], -up[1])))
    assert (alone.rows[0].mistake, alone.rows[0].joint) == (JointMistake.SIGN, 2)
    mended = judge_joints(question, finite(up, (down[0] + math.pi, down[1])))
    assert (mended.rows[1].mistake, mended.missing) == (JointMistake.QUADRANT, ())


def test_a_slider_that_goes_the_other_way_is_told() -> None:
    found = judge_joints(
        asked((0.3, 0.8, 0.2, -0.4), robot("scara"), every=False), finite((0.3, 0.8, -0.2, -0.4))
    )
    assert (found.rows[0].joint, found.rows[0].mistake) == (3, JointMistake.SIGN)


def test_each_solution_has_its_share_and_a_wrong_row_in_its_place_costs_no_more() -> None:
    question = asked((0.4, 0.9), robot("twolink"), reach=ArmReach.POSITION)
    up, down = (found.joints for found in question.found.solutions)
    bad, worse = (0.1, 0.2), (0.2, 0.1)

    def share(*rows, claim=JointClaim.FINITE):
        return judge_joints(question, replace(finite(*rows), claim=claim)).share

    assert share(up) == share(up, bad) == share(up, down, bad) == 0.5
    assert share(bad) == share(up, bad, worse) == share(up, down, bad, worse) == 0.0
    assert share(up, down, claim=JointClaim.INFINITE) == 0.5
    assert share(up, down, claim=JointClaim.OUT_OF_REACH) == 0.0
    assert share(up, down) == 1.0


def test_a_member_of_a_family_is_half_of_it_and_its_condition_the_other() -> None:
    question = asked((*Q[:4], 0.0, Q[5]))
    rows = tuple(found.joints for found in question.found.solutions)
    n, families = len(rows), sum(found.family is not None for found in question.found.solutions)
    answer = JointAnswer(claim=JointClaim.INFINITE, rows=rows)
    assert judge_joints(question, answer).share == pytest.approx((n - families / 2) / n)
    nothing = judge_joints(question, replace(answer, combinations=((0.0,) * 6,)))
    assert (nothing.combinations, nothing.complete) == ((False,), True)
    wrong = replace(answer, combinations=((0.0, 0.0, 0.0, 1.0, 0.0, -1.0),))
    assert judge_joints(question, wrong).share == pytest.approx(min(n - families / 2, n - 1) / n)


def test_of_a_family_without_a_condition_it_is_half_that_there_are_infinitely_many() -> None:
    """Two equal links, folded: the claim that there is one solution had nearly all of the marks."""
    links = robot("twolink")
    table = replace(links, rows=(links.rows[0], replace(links.rows[1], a=links.rows[0].a)))
    reach = ArmReach.POSITION
    question = joint_question(solver_of(table, reach=reach), product(table, (0.4, math.pi)), reach=reach)
    one = judge_joints(question, finite((0.4, math.pi)))
    assert (one.right, one.share, one.combination_missing) == (False, 0.5, False)
    assert judge_joints(question, replace(finite((0.4, math.pi)), claim=JointClaim.INFINITE)).right


def test_no_solution_is_told_to_be_missing_where_none_is_said_to_exist() -> None:
    question = asked()
    none = judge_joints(question, JointAnswer(claim=JointClaim.OUT_OF_REACH))
    assert (none.missing, none.combination_missing, none.share) == ((), False, 0.0)


@pytest.mark.parametrize("value", [1e308, -1e300, 1e-300])
def test_no_joint_value_is_too_large_to_be_judged(value) -> None:
    question = asked()
    assert not judge_joints(question, finite([value] * 6)).right
    answer = JointAnswer(claim=JointClaim.INFINITE, rows=(Q,), combinations=((value,) * 6,))
    assert not judge_joints(question, answer).right
    assert np.isfinite(judge_joints(question, answer).share)


def test_where_only_the_position_counts_nothing_is_said_of_the_orientation() -> None:
    found = judge_joints(asked(reach=ArmReach.POSITION, every=False), finite([1.1, 0.9, -0.3, 0.2, 0.1, 0.0]))
    assert not found.right
    assert (found.rows[0].joint, found.rows[0].mistake) == (None, None)


def test_one_solution_is_right_beside_true_statements_only() -> None:
    question = asked(every=False)
    answer = finite(Q)
    assert judge_joints(question, answer).right
    for false in (
        replace(answer, claim=JointClaim.INFINITE),
        replace(answer, combinations=((0, 0, 0, 1, 0, 1),)),
    ):
        found = judge_joints(question, false)
        assert (found.right, found.share) == (False, 0.5)
    stretched = asked((*Q[:4], 0.0, Q[5]), every=False)
    answer = finite((*Q[:4], 0.0, Q[5]))
    assert judge_joints(stretched, answer).right
    infinite = replace(answer, claim=JointClaim.INFINITE, combinations=((0, 0, 0, 1, 0, 1),))
    assert judge_joints(stretched, infinite).right


@pytest.mark.parametrize("combination", [(1, 0, 0, 0, 0, 0), (1, 0, 0, 1, 0, 1)])
def test_a_combination_that_is_fixed_without_saying_what_belongs_to_the_family_is_loose(combination) -> None:
    question = asked((*Q[:4], 0.0, Q[5]))
    rows = tuple(found.joints for found in question.found.solutions)
    answer = JointAnswer(claim=JointClaim.INFINITE, rows=rows, combinations=(combination,))
    found = judge_joints(question, answer)
    assert (found.combinations, found.loose, found.right) == ((False,), (True,), False)
    beside = judge_joints(question, replace(answer, combinations=((0, 0, 0, 1, 0, 1), combination)))
    assert (beside.combinations, beside.loose, beside.right) == ((True, True), (False, False), True)
    false = judge_joints(question, replace(answer, combinations=((0, 0, 0, 1, 0, -1), combination)))
    assert (false.combinations, false.loose, false.right) == ((False, False), (False, True), False)


def test_a_true_condition_stands_whatever_the_rows_are() -> None:
    question = asked((*Q[:4], 0.0, Q[5]))
    answer = replace(
        finite([0.1] * 6), claim=JointClaim.INFINITE, combinations=((0, 0, 0, 1, 0, 1), (0, 0, 0, 1, 0, -1))
    )
    found = judge_joints(question, answer)
    assert (found.combinations, found.loose, found.share) == ((True, False), (False, False), 0.0)


def test_rows_beyond_the_limits_are_told_where_all_solutions_are() -> None:
    away = [(q + 1, q + 1.1) for q in Q]
    question = joint_question(solver_of(PUMA, limits=away), product(PUMA, Q))
    found = judge_joints(question, finite(Q, (0.0,) * 6))
    assert (found.right, found.share, found.expected) == (False, 0.0, JointClaim.JOINT_LIMITS)
    assert [row.mistake for row in found.rows] == [JointMistake.LIMITS, None]
    assert not any(row.right for row in found.rows)
    beside = joint_question(solver_of(PUMA, limits=[(q + 1e-3, q + 1.1) for q in Q]), product(PUMA, Q))
    assert judge_joints(beside, finite(Q)).rows[0].mistake is JointMistake.LIMITS
