"""The cases that one should think of before writing a checker."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.equivalence import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    Kind,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
    decide,
    mirrored,
)
from kinematics.forward import forward_kinematics
from kinematics.table import Convention, DHTable, NumericTable
from tests.kinematics.equivalence.campaign import catalogue
from tests.kinematics.equivalence.tables import (
    A2,
    A3,
    D3,
    D4,
    HALF,
    PUMA,
    PUMA_CRAIG,
    RX90,
    SCARA,
    F,
    P,
    R,
    changed,
    modified,
    standard,
)

FREE = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=1e-9, angle=1e-9))
USUAL = Policy()


def accepted(reference: NumericTable, submission: NumericTable, policy: Policy = FREE) -> bool:
    """Whether the submission is accepted; if so, its certificate is evaluated from the tables themselves."""
    decision = decide(reference, submission, policy)
    certificate = decision.certificate
    if certificate is None:
        assert decision.mismatches
        return False
    rng = np.random.default_rng(7)
    for _ in range(5):
        q = rng.uniform(-2.0, 2.0, reference.n_joints)
        left = forward_kinematics(
            submission, np.array(certificate.joint_signs) * q + certificate.joint_offsets
        )
        right = certificate.base @ forward_kinematics(reference, q).transform @ certificate.tool
        slack = 10 * max(policy.tolerance.length, policy.tolerance.angle)
        assert np.allclose(left.transform, right, atol=max(slack, 1e-8))
    return True


def kinds(reference: NumericTable, submission: NumericTable, policy: Policy = USUAL) -> set[Kind]:
    return {mismatch.kind for mismatch in decide(reference, submission, policy).mismatches}


def test_a_puma_in_craigs_form_against_a_reference_in_standard_form() -> None:
    assert accepted(PUMA, PUMA_CRAIG)
    assert accepted(PUMA_CRAIG, PUMA)


def test_a_spherical_wrist_with_z5_reversed() -> None:
    # z_4 the other way: α_4 and α_5 change sign, θ_5 too
    wrist = changed(changed(PUMA, 4, alpha=-HALF), 5, alpha=HALF)
    decision = decide(PUMA, wrist, FREE)
    assert decision.certificate is not None
    assert accepted(PUMA, wrist)
    # turning q_4 by half a turn does the same as counting q_5 backwards: only both rules together exclude it
    assert decide(PUMA, wrist, replace(FREE, direction=DirectionRule.FIGURE)).accepted
    assert decide(PUMA, wrist, replace(FREE, zero=ZeroRule.FIGURE)).accepted
    strict = replace(FREE, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)
    assert kinds(PUMA, wrist, strict) == {Kind.DIRECTION}


@pytest.mark.parametrize("where", [0.0, 0.25, 0.1])
@pytest.mark.parametrize("upside_down", [False, True])
def test_a_scara_with_its_slider_drawn_on_either_axis_up_or_down(where: float, upside_down: bool) -> None:
    flip = math.pi if upside_down else 0.0
    table = modified(
        (R, 0, 0, 0, 0), (R, 0, 0.3, 0, 0), (P, flip, where, 0, 0), (R, -flip, 0.25 - where, 0, 0)
    )
    assert accepted(SCARA, table)


def test_a_scara_with_its_slider_after_joint_4_is_another_order_of_joints() -> None:
    after = modified((R, 0, 0, 0, 0), (R, 0, 0.3, 0, 0), (R, 0, 0.25, 0, 0), (P, 0, 0, 0, 0))
    assert kinds(SCARA, after) == {Kind.JOINT_TYPE}
    reference = modified((R, 0, 0, 0, 0), (R, 0, 0.3, 0, 0), (R, 0, 0.25, 0, 0), (P, math.pi, 0, 0, 0))
    assert accepted(reference, after)


def test_the_elbow_offset_on_joint_2_instead_of_3() -> None:
    moved = changed(changed(PUMA, 3, d=0.0), 2, d=D3)
    split = changed(changed(PUMA, 3, d=D3 - 0.1), 2, d=0.1)
    assert accepted(PUMA, moved)
    assert accepted(PUMA, split)


def test_the_elbow_offset_with_its_sign_wrong_is_right_if_a_flip_makes_up_for_it() -> None:
    assert not accepted(PUMA, changed(PUMA, 3, d=-D3), USUAL)
    # without a_3 the arm can be turned over: reversing d_3 is drawing x_0 the other way round
    flat = changed(PUMA, 3, a=0.0)
    straight = changed(flat, 4, alpha=HALF, d=0.0)
    assert accepted(straight, changed(straight, 3, d=-D3))


def test_degrees_where_radians_are_declared() -> None:
    degrees = DHTable(
        convention=PUMA.convention, rows=tuple(replace(r, alpha=math.degrees(r.alpha)) for r in PUMA.rows)
    )
    assert Kind.TWIST in kinds(PUMA, degrees)


def test_two_coincident_axes() -> None:
    reference = standard((R, 0, 0, 0.3, 0), (R, 0, 0, 0.2, 0), (R, HALF, 0.4, 0, 0))
    assert accepted(
        reference, standard((R, 0, 0, 0.1, 1.0), (R, math.pi, 0, -0.4, 0.3), (R, HALF, 0.4, 0, 0))
    )
    assert not accepted(
        reference, standard((R, 0, 0.1, 0.3, 0), (R, 0, 0, 0.2, 0), (R, HALF, 0.4, 0, 0)), USUAL
    )


def test_a_mirrored_robot_is_another_one() -> None:
    twisted = standard((R, 0.5, 0.3, 0.2, 0), (R, -0.7, 0.2, 0.1, 0), (R, 0.4, 0.3, 0.15, 0))
    for robot in (PUMA, twisted):
        image = mirrored(robot)
        assert not accepted(robot, image)
        assert Kind.HANDEDNESS in kinds(robot, image)
    # same |a|, |α| and |d| everywhere, other handedness
    assert Kind.HANDEDNESS in kinds(PUMA, changed(PUMA, 3, alpha=HALF))
    # a planar arm is its own mirror image
    assert accepted(SCARA, mirrored(SCARA))


def test_nearly_parallel_axes_as_a_calibrated_arm_has_them() -> None:
    """Calibration files of such arms hold rows like these: 3 mrad off parallel, offsets that cancel."""
    tilt = 0.0031
    arm = standard(
        (R, HALF, 0, 0.0892, 0),
        (R, tilt, -0.425, 137.23, 0.003),
        (R, -tilt / 2, -0.392, -137.1, -0.004),
        (R, HALF, 0, -0.02, 0),
        (R, -HALF, 0, 0.0946, 0),
        (R, 0, 0, 0.0823, 0),
    )
    assert accepted(arm, arm)
    turned = changed(changed(changed(arm, 2, theta=1.0), 3, theta=-0.5), 1, theta=0.2)
    assert accepted(arm, turned)
    assert not accepted(arm, changed(arm, 2, d=136.23))
    assert not accepted(arm, changed(arm, 3, alpha=tilt / 2))


def test_a_nominal_table_of_a_calibrated_arm_is_within_the_usual_tolerance() -> None:
    nominal = standard((R, HALF, 0, 0.09, 0), (R, 0, -0.425, 0, 0), (R, 0, -0.392, 0.11, 0))
    calibrated = standard(
        (R, HALF + 2e-4, 1e-5, 0.0901, 0), (R, 3e-4, -0.4251, 0.02, 0), (R, 1e-4, -0.3921, 0.0899, 0)
    )
    assert accepted(calibrated, nominal, Policy(tool=ToolRule.FREE))
    assert accepted(nominal, calibrated, Policy(tool=ToolRule.FREE))


def test_the_order_of_the_joints_swapped() -> None:
    rows = list(PUMA.rows)
    rows[1], rows[2] = rows[2], rows[1]
    assert not accepted(PUMA, DHTable(convention=PUMA.convention, rows=tuple(rows)), USUAL)
    rows = list(SCARA.rows)
    rows[2], rows[3] = rows[3], rows[2]
    assert Kind.JOINT_TYPE in kinds(SCARA, DHTable(convention=SCARA.convention, rows=tuple(rows)))


def test_a_prismatic_joint_marked_revolute() -> None:
    decision = decide(SCARA, changed(SCARA, 3, joint=R), USUAL)
    assert [(m.kind, m.joint, m.row) for m in decision.mismatches] == [(Kind.JOINT_TYPE, 3, 2)]


def test_too_few_and_too_many_joints() -> None:
    short = DHTable(convention=PUMA.convention, rows=PUMA.rows[:5])
    assert kinds(PUMA, short) == {Kind.JOINT_COUNT}
    assert kinds(short, PUMA) == {Kind.JOINT_COUNT}
    assert kinds(PUMA, DHTable(convention=PUMA.convention, rows=())) == {Kind.JOINT_COUNT}


def test_a_table_equal_but_for_the_tool() -> None:
    longer = changed(PUMA, 6, d=0.1)
    aside = changed(PUMA, 6, a=0.1)
    assert accepted(PUMA, longer)
    assert accepted(PUMA, aside)
    assert decide(PUMA, longer, USUAL).accepted  # z_6 still lies on the last axis
    for table in (longer, aside):
        decision = decide(PUMA, table, Policy(tool=ToolRule.POINT))
        assert decision.same_robot
        assert [m.kind for m in decision.mismatches] == [Kind.TOOL]
    assert [m.kind for m in decide(PUMA, aside, USUAL).mismatches] == [Kind.TOOL]


def test_all_lengths_zero() -> None:
    zero = standard((R, HALF, 0, 0, 0), (R, -HALF, 0, 0, 0), (R, 0, 0, 0, 0))
    assert accepted(zero, standard((R, -HALF, 0, 0, 0), (R, HALF, 0, 0, 0), (R, 0, 0, 0, 0)))
    assert accepted(zero, modified((R, 0, 0, 0, 0), (R, HALF, 0, 0, 0), (R, -HALF, 0, 0, 0)))
    assert accepted(zero, changed(zero, 1, d=0.4))  # the height of frame 0 is nobody's business
    assert not accepted(zero, changed(zero, 1, a=0.4), USUAL)
    assert not accepted(zero, changed(zero, 1, a=1e-4), USUAL)  # relative to its own size nothing is small


def test_only_prismatic_joints() -> None:
    portal = standard((P, HALF, 0, 0, 0), (P, HALF, 0, 0, HALF), (P, 0, 0, 0, 0))
    shifted = standard((P, -HALF, 0.7, 0.1, 0), (P, HALF, -0.3, 0.2, -HALF), (P, 0, 0.4, 2.0, 0))
    assert accepted(portal, shifted)
    assert not accepted(portal, changed(portal, 2, theta=0.3), USUAL)
    assert Kind.OFFSET in kinds(portal, changed(portal, 2, theta=0.3))


def test_first_and_last_joints_prismatic() -> None:
    robot = standard((P, HALF, 0.2, 0, 0.4), (R, -HALF, 0.3, 0.1, 0), (P, 0, 0, 0, 0))
    other = standard((P, HALF, -0.4, 1.0, 0.4), (R, -HALF, 0.3, 0.1, 0), (P, 0, 0.9, 0.2, 1.0))
    assert accepted(robot, other)
    assert accepted(robot, other, replace(USUAL, tool=ToolRule.AXIS))
    assert accepted(robot, robot, replace(USUAL, base=BaseRule.AXIS))


@pytest.mark.parametrize("place", range(7))
def test_dummy_rows_anywhere(place: int) -> None:
    blank = standard((F, 0, 0, 0, 0)).rows[0]
    rows = (*PUMA.rows[:place], blank, *PUMA.rows[place:])
    assert accepted(PUMA, DHTable(convention=PUMA.convention, rows=rows))


def test_one_joint_is_any_joint() -> None:
    assert accepted(standard((R, 0.3, 0.4, 0.5, 0.6)), modified((R, 1.0, 2.0, 3.0, 4.0)))
    assert accepted(standard((P, 0.3, 0.4, 0.5, 0.6)), modified((P, 1.0, 2.0, 3.0, 4.0)))
    assert not accepted(standard((P, 0, 0, 0, 0)), standard((R, 0, 0, 0, 0)), USUAL)


def test_twelve_joints() -> None:
    long = DHTable(convention=PUMA.convention, rows=PUMA.rows * 2)
    assert accepted(long, long)
    assert not accepted(long, changed(long, 11, alpha=0.0), USUAL)


def right_angles_rounded(angle: float) -> float:
    """1.57 for a right angle, and four decimals of any other."""
    return math.copysign(1.57, angle) if abs(abs(angle) - math.pi / 2) < 1e-9 else round(angle, 4)


def test_typing_157_for_a_right_angle_is_right() -> None:
    typed = DHTable(
        convention=PUMA.convention,
        rows=tuple(replace(r, alpha=math.copysign(1.57, r.alpha) if r.alpha else 0.0) for r in PUMA.rows),
    )
    assert accepted(PUMA, typed, USUAL)
    for _, robot in catalogue():
        typed = DHTable(
            convention=robot.convention,
            rows=tuple(
                replace(r, alpha=right_angles_rounded(r.alpha), theta=right_angles_rounded(r.theta))
                for r in robot.rows
            ),
        )
        assert decide(robot, typed, Policy(tool=ToolRule.AXIS)).accepted


def test_one_percent_of_the_reach_is_wrong() -> None:
    for row, cell in ((2, "a"), (3, "d"), (4, "d")):
        value = getattr(PUMA.rows[row - 1], cell)
        assert not accepted(PUMA, changed(PUMA, row, **{cell: value + 0.0105}), USUAL)


def test_the_convention_may_be_prescribed() -> None:
    policy = replace(USUAL, convention=ConventionRule.STANDARD)
    assert decide(PUMA, PUMA, policy).accepted
    decision = decide(PUMA, PUMA_CRAIG, policy)
    assert decision.same_robot
    assert [m.kind for m in decision.mismatches] == [Kind.CONVENTION]
    both = decide(PUMA, changed(PUMA_CRAIG, 2, alpha=0.0), policy)
    assert not both.same_robot
    assert {m.kind for m in both.mismatches} > {Kind.CONVENTION}


def test_every_robot_accepts_itself_under_every_policy() -> None:
    exact = Tolerance(length=1e-9, angle=1e-9)
    for _, robot in catalogue():
        for base in BaseRule:
            for tool in ToolRule:
                for zero in ZeroRule:
                    for direction in DirectionRule:
                        policy = Policy(base=base, tool=tool, zero=zero, direction=direction, tolerance=exact)
                        assert decide(robot, robot, policy).accepted


def test_rx90_has_its_mirror_image_in_its_elbow() -> None:
    """d_3 = 0: the elbow may be drawn with z_2 and z_3 either way, and α_4 with it."""
    other = modified(
        (R, 0, 0, 0, 0),
        (R, -HALF, 0, 0, 0),
        (R, 0, 0.45, 0, 0),
        (R, HALF, 0, 0.45, 0),
        (R, -HALF, 0, 0, 0),
        (R, HALF, 0, 0, 0),
    )
    assert accepted(RX90, other)
    assert decide(RX90, other, USUAL).accepted


def test_constants_are_those_of_the_design() -> None:
    assert (A2, A3, D3, D4) == (0.4318, 0.0203, 0.15005, 0.4318)
    assert PUMA.convention is Convention.STANDARD
