"""Singularities as sets: against textbook determinants, which are tested by differences of poses."""

import math
import random

import numpy as np
import pytest

from exercises.parts.motion.conditions import MOST_CONDITIONS, Condition, read_conditions
from kinematics.answers.lost_motions import lost_motion_is_right, lost_motions_at
from kinematics.answers.singular_arms import arm_of
from kinematics.answers.singularity_answers import is_sine_for_cosine, judge_singularities
from kinematics.answers.singularity_verdicts import ConditionStatus
from kinematics.answers.unit_multiples import never_vanishes
from kinematics.cells import AngleUnit
from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import evaluate
from kinematics.jacobian import JacobianFrame
from kinematics.symbolic import ProofStatus
from kinematics.symbolic.determinants import MotionRows
from kinematics.table import JointType
from tests.exercises.packaged import exercise
from tests.kinematics.answers.joint_values import robot
from tests.kinematics.answers.singular_sets import ARMS, TEXTBOOK, arm, read
from tests.kinematics.answers.test_jacobian_answers import differences

PUMA = ("puma560", MotionRows.TWIST)
SHOULDER, ELBOW, WRIST = "a2*c2 + a3*c23 = d4*s23", "a3*s3 + d4*c3", "q5 = k*pi"


def judged(name: str, rows: MotionRows, *texts: str):
    types = robot(name).joint_types
    found = [each for text in texts for each in read_conditions(text, types, AngleUnit.RAD, ())]
    conditions = [each for each in found if isinstance(each, Condition)]
    assert len(conditions) == len(found)
    rounded = {each.expression: each.rounded for each in conditions}
    return judge_singularities(arm(name, rows), [each.expression for each in conditions], rounded)


@pytest.mark.parametrize(("name", "rows"), ARMS)
def test_the_textbooks_factors_make_the_determinant_of_differences(name: str, rows: MotionRows) -> None:
    table, found = robot(name), arm(name, rows)
    rng = random.Random(4)
    ratios = []
    for _ in range(5):
        q = [rng.uniform(0.2, 1.4) for _ in table.joint_types]
        J = differences(table, q, JacobianFrame.BASE)
        J = J if rows is MotionRows.TWIST else J[:3]
        J = J[np.abs(J).max(axis=1) > 1e-7]
        factors = [evaluate(read(name, text)[0], found.values, q) for text in TEXTBOOK[name, rows]]
        if name == "stanford":
            factors.append(q[2])  # the slider's length enters twice
        ratios.append(np.linalg.det(J) / np.prod(factors))
    assert np.ptp(ratios) < 1e-5 * abs(ratios[0])


def test_factors_of_the_determinant_are_proved() -> None:
    assert judged(*PUMA, SHOULDER, ELBOW, WRIST).proof is ProofStatus.PROVED
    assert judged(*PUMA, f"({ELBOW})*sin(q5)", SHOULDER).proof is ProofStatus.PROVED
    rounded = judged(*PUMA, SHOULDER, "q3 = 92.6917°, -87.3083°", WRIST)
    assert (rounded.right, rounded.proof) == (True, ProofStatus.UNDECIDED)


def test_what_stands_above_and_below_is_cancelled() -> None:
    """At cos q3 = 0 the tangent has no value, and cos q3 · tan q3 is not zero there but ±1."""
    assert judged(*PUMA, SHOULDER, "cos(q3)*(a3*tan(q3) + d4)", WRIST).proof is ProofStatus.PROVED
    assert judged(*PUMA, SHOULDER, ELBOW, "cos(q5)^2*tan(q5)/cos(q5)").proof is ProofStatus.PROVED
    assert not judged(*PUMA, SHOULDER, "cos(q3)*(a3*tan(q3) - d4)", WRIST).right
    assert not judged(*PUMA, SHOULDER, ELBOW, "cos(q5)^2*tan(q5)").right


def test_a_quotient_is_not_zero_where_its_denominator_cancels_the_zero() -> None:
    assert judged(*PUMA, SHOULDER, ELBOW, "sin(2*q5)/cos(q5)").right
    assert judged(*PUMA, SHOULDER, ELBOW, "(1 - cos(q5)^2)/sin(q5)").proof is ProofStatus.PROVED
    (*_, never) = judged(*PUMA, SHOULDER, ELBOW, "(1 - cos(q5)^2)/sin(q5)^2").conditions
    assert never.status is ConditionStatus.NOWHERE
    (*_, cosine) = judged(*PUMA, SHOULDER, ELBOW, "sin(2*q5)/sin(q5)").conditions
    assert cosine.status is ConditionStatus.INVENTED


@pytest.mark.parametrize("text", ["sqrt(sin(q5) - 2)", "sqrt(-1 - cos(q2)^2) + q5*0"])
def test_a_condition_that_has_a_value_nowhere_says_nothing(text: str) -> None:
    (found,) = judged(*PUMA, text).conditions
    assert found.status is ConditionStatus.NOWHERE


def test_which_length_is_longer_may_be_used() -> None:
    """Of the student's arm the first link is the longer one; folded, the tip is L1 − L2 from its axis."""
    reach = "sqrt(L1^2 + L2^2 + 2*L1*L2*cos(q2))"
    table = exercise("twolink-singularities").reference.table
    own = arm_of(table, MotionRows.TRANSLATION, (("L1", 1.1), ("L2", 0.4)))

    def right(*texts: str) -> bool:
        types = table.joint_types
        ones = [read_conditions(text, types, AngleUnit.DEG, ())[0] for text in texts]
        return judge_singularities(own, [one.expression for one in ones if not isinstance(one, Fault)]).right

    assert right(f"{reach} = L1 - L2", f"{reach} = L1 + L2")
    assert not right(f"{reach} = L2 - L1", f"{reach} = L1 + L2")


def test_each_missing_family_is_shown_where_none_of_the_conditions_holds() -> None:
    found = judged(*PUMA, SHOULDER, WRIST)
    assert [family.found for family in found.families].count(1.0) == 3
    (missing,) = [family for family in found.families if family.found < 1.0]
    assert missing.example is not None
    joints = list(missing.example)
    values = arm(*PUMA).values
    assert abs(evaluate(read("puma560", ELBOW)[0], values, joints)) < 1e-9
    assert np.linalg.svd(differences(robot("puma560"), joints, JacobianFrame.BASE))[1][-1] < 1e-6
    assert found.share == pytest.approx(0.75)


def test_the_other_branch_of_a_family_is_missed() -> None:
    found = judged(*PUMA, SHOULDER, "q3 = atan2(-d4, a3)", WRIST)
    assert not found.right
    assert 0.0 < min(family.found for family in found.families) < 1.0


def test_an_invented_condition_is_shown_where_the_arm_can_move() -> None:
    found = judged(*PUMA, SHOULDER, ELBOW, WRIST, "cos(q5)")
    assert [entry.status for entry in found.conditions] == [ConditionStatus.SINGULAR] * 3 + [
        ConditionStatus.INVENTED
    ]
    joints = found.conditions[-1].example
    assert joints is not None
    assert np.linalg.svd(differences(robot("puma560"), list(joints), JacobianFrame.BASE))[1][-1] > 1e-4
    assert is_sine_for_cosine(arm(*PUMA), read("puma560", "cos(q5)")[0])
    assert not is_sine_for_cosine(arm(*PUMA), read("puma560", "sin(q1) - 1/3")[0])


def test_conditions_that_hold_always_or_never_are_called_so() -> None:
    found = judged("twolink", MotionRows.TRANSLATION, "sin(q2)", "s1^2 + c1^2 = 1", "sin(q1) = 2", "1/0.5")
    status = [entry.status for entry in found.conditions]
    assert status[1:] == [ConditionStatus.EVERYWHERE, ConditionStatus.NOWHERE, ConditionStatus.NOWHERE]
    assert not found.right
    assert judged("twolink", MotionRows.TRANSLATION, "sin(q2)", "sin(q1) = 2").right
    assert judged("twolink", MotionRows.TRANSLATION).share == 0.0


def test_lengths_that_are_equal_by_chance_are_not_one() -> None:
    listed = arm("rx90", MotionRows.TWIST)
    equal = arm_of(listed.table, listed.rows, tuple((name, 0.45) for name in sorted(listed.values)))
    named = [function for text in ("cos(q3)", "sin(q5)") for function in read("rx90", text)]
    right = read("rx90", "D3*cos(q2) - RL4*sin(q2 + q3)")
    swapped = read("rx90", "RL4*cos(q2) - D3*sin(q2 + q3)")
    assert judge_singularities(equal, [*named, *right]).right
    assert not judge_singularities(equal, [*named, *swapped]).right


def test_an_arm_that_is_never_singular_has_no_families() -> None:
    assert arm("onelink", MotionRows.TWIST).families == ()
    assert arm("twolink", MotionRows.TWIST).families == ()


def test_an_arm_of_five_joints_is_singular_where_two_equations_hold_too() -> None:
    assert not arm("scorbot", MotionRows.TWIST).whole
    found = judged("scorbot", MotionRows.TWIST, "sin(q3)")
    assert (found.right, found.proof) == (True, ProofStatus.UNDECIDED)


def test_determinants_beyond_the_limit_are_refused() -> None:
    with pytest.raises(FormSizeError):
        _ = arm("iiwa14", MotionRows.TWIST).families


@pytest.mark.parametrize("folded", [0.0, np.pi])
def test_lost_motions_have_no_power_with_any_velocity(folded: float) -> None:
    found = arm("twolink", MotionRows.TRANSLATION)
    joints = [0.4, folded]
    (motion,) = lost_motions_at(found, joints)
    along = (np.cos(0.4), np.sin(0.4), 0.0)
    assert abs(np.dot(motion, (-along[1], along[0], 0.0))) < 1e-9
    assert lost_motion_is_right(found, joints, along)
    assert lost_motion_is_right(found, joints, [-3 * value for value in along])
    assert lost_motion_is_right(found, joints, [1e300 * value for value in along])
    assert lost_motion_is_right(found, joints, (along[1], -along[0], 0.0)) is False
    assert lost_motion_is_right(found, joints, (0.0, 0.0, 1.0)) is None  # it never moves that way
    assert lost_motion_is_right(found, joints, (0.0, 0.0, 0.0)) is None
    assert lost_motions_at(found, [0.4, 1.0]) == []


def test_where_all_three_families_meet_three_motions_are_lost_or_fewer() -> None:
    found = arm("stanford", MotionRows.TWIST)
    joints = [0.3, 0.0, 0.4, 0.2, 0.0, 0.1]
    motions = lost_motions_at(found, joints)
    J = differences(robot("stanford"), joints, JacobianFrame.BASE)
    assert len(motions) == 6 - np.linalg.matrix_rank(J, tol=1e-6)
    for motion in motions:
        assert np.abs(np.array(motion) @ J).max() < 1e-6


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "condition_not_equation"),
        ("–", "condition_not_equation"),
        ("q3 < 0", "condition_not_equation"),
        ("q3 = 0 = q5", "condition_not_equation"),
        ("q3 = sin(q5)", "condition_angle_nonlinear"),
        ("q3*q5 = 0", "angle_product"),
        ("q3 = k*pi/3.3", "condition_period"),
        ("q3 = ", "condition_not_equation"),
        ("= pi", "condition_not_equation"),
        ("q3 = ±", "condition_not_equation"),
        ("sin(q3", "parenthesis_not_closed"),
        ("1/0", "division_by_zero"),
        ("q9", "joint_variable_unknown"),
        ("k" * 3000, "cell_too_long"),
        ("q3 = " + ", ".join(map(str, range(17))), "conditions_too_many"),
        ("q3 = " + ", ".join(f"±{i}" for i in range(1, 10)), "conditions_too_many"),
        (
            "q3 = k*pi" + " " * 1900 + "x",
            "angle_product",
        ),  # all threads waited minutes
    ],
)
def test_what_is_no_condition_is_refused(text: str, code: str) -> None:
    types = (JointType.REVOLUTE,) * 6
    (found,) = read_conditions(text, types, AngleUnit.DEG, ("conditions", 0))
    assert isinstance(found, Fault)
    assert (found.code, found.where[:2]) == (code, ("conditions", 0))


@pytest.mark.parametrize("told", ["", ", k ∈ ℤ", ",  ( k in Z )", " (k ∈ integers)", ", n∈ℤ and so on"])
def test_what_k_may_be_is_left_out(told: str) -> None:
    types = (JointType.REVOLUTE,) * 6
    found = read_conditions(f"q3 = k*pi{told}", types, AngleUnit.DEG, ("conditions", 0))
    assert found == read_conditions("q3 = k*pi", types, AngleUnit.DEG, ("conditions", 0))


def test_as_many_conditions_as_rows_are_read_in_one_cell() -> None:
    types = (JointType.REVOLUTE,) * 6
    text = "q3 = " + ", ".join(f"±{i}" for i in range(1, MOST_CONDITIONS // 2 + 1))
    assert len(read_conditions(text, types, AngleUnit.DEG, ("conditions", 0))) == MOST_CONDITIONS


@pytest.mark.parametrize("word", ["or", "o", "ou", "sau", "або", "чи"])
def test_conditions_stand_beside_each_other_in_six_languages(word: str) -> None:
    types = (JointType.REVOLUTE,) * 6
    assert len(read_conditions(f"q3 = 0 {word} q5 = 0", types, AngleUnit.DEG, ("conditions", 0))) == 2


@pytest.mark.parametrize("name", ["u", "o", "ou"])
def test_a_name_is_no_word_between_conditions(name: str) -> None:
    types = (JointType.REVOLUTE,) * 3
    wanted = read_conditions(f"v*c23 + {name}*c2", types, AngleUnit.DEG, (), {name, "v"})
    assert len(wanted) == 1
    for text in (f"v c23 + {name} c2 = 0", f" {name} c2 + v c23", f"v c23 = - {name} c2"):
        (found,) = read_conditions(text, types, AngleUnit.DEG, (), {name, "v"})
        assert isinstance(found, Condition)
        assert evaluate(found.expression, {name: 0.6, "v": 0.4}, [0.3, 1.2, -0.7]) == pytest.approx(
            0.6 * math.cos(1.2) + 0.4 * math.cos(0.5)
        )
    assert len(read_conditions("q3 = 0 u q2 = 0", types, AngleUnit.DEG, (), {"v"})) == 2


def test_conditions_may_be_written_in_latex() -> None:
    types = (JointType.REVOLUTE,) * 6
    typed = read_conditions(r"q_3 = 0, \pm\pi \lor q_5 = \pm 90", types, AngleUnit.DEG, ())
    assert typed == read_conditions("q3 = 0, ±pi; q5 = ±90", types, AngleUnit.DEG, ())
    assert len(typed) == 5


def test_what_always_holds_finds_no_family() -> None:
    found = judged(*PUMA, "0")
    assert {entry.found for entry in found.families} == {0.0}
    assert found.share == 0.0
    alone, beside = judged(*PUMA, "sin(q5)"), judged(*PUMA, "sin(q5)", "0")
    assert [entry.found for entry in beside.families] == [entry.found for entry in alone.families]


def test_powers_and_products_with_what_never_vanishes_are_proved() -> None:
    shoulder = "(a2*c2 + a3*c23 - d4*s23)*sin(q5)*(sin(q1)^2 + cos(q1)^2)"
    found = judged(*PUMA, "(2 + cos(q1))*(a3*s3 + d4*c3)^2", "cos(q5)^2 = 1", shoulder)
    assert found.right
    assert found.proof is ProofStatus.PROVED


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("2 + cos(q1)", True),
        ("1 + cos(q1)", False),
        ("-3 + 2*sin(q1)*cos(q2)", True),
        ("1 + sin(q1)^2", True),
        ("1/2 - sin(q1)^3", False),
        ("L1 + 2", False),
        ("(2 + sin(q1))*(cos(q1) - 3)", True),
    ],
)
def test_what_never_vanishes_is_told_by_its_numbers(text: str, never: bool) -> None:
    (function,) = read("kr125", text)
    assert never_vanishes(function) is never


@pytest.mark.parametrize("digits", [1, 2, 3])
@pytest.mark.parametrize("unit", ["°", ""])
def test_a_condition_is_as_exact_as_its_decimals(unit: str, digits: int) -> None:
    """Of the elbow's two angles; nothing is told of one that contradicts what is told of another."""
    values = arm(*PUMA).values
    elbow = math.atan2(-values["d4"], values["a3"])
    angles = [math.degrees(q) if unit == "°" else q for q in (elbow, elbow + math.pi)]
    right = [f"{angle:.{digits}f}{unit}" for angle in angles]
    assert judged(*PUMA, SHOULDER, WRIST, f"q3 = {', '.join(right)}").right
    step = max(10.0**-digits, 0.12 if unit == "°" else 0.002)
    off = [f"{angle + step:.{digits}f}{unit}" for angle in angles]
    found = judged(*PUMA, SHOULDER, WRIST, f"q3 = {', '.join(off)}")
    assert [entry.status for entry in found.conditions[2:]] == [ConditionStatus.INVENTED] * 2
    assert [entry.is_close for entry in found.conditions[2:]] == [digits > 1 or unit == "°"] * 2
    assert sum(entry.found == 0.0 for entry in found.families) == 1


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("0.02*s3 + 0.43*c3", True),
        ("0.020*s3 + 0.432*c3 = 0", True),
        ("sin(q5)*(0.02*s3 + 0.43*c3)", True),
        ("tan(q3) = -21.3", True),
        ("tan(q3) = -21.2", False),
        ("0.03*s3 + 0.43*c3", False),
        ("0.020*s3 + 0.442*c3", False),
        ("sin(q5)*(0.03*s3 + 0.43*c3)", False),
    ],
)
def test_lengths_in_a_condition_are_as_exact_as_they_were_typed(text: str, right: bool) -> None:
    """a3 = 0.0203 and d4 = 0.4318."""
    assert judged(*PUMA, SHOULDER, WRIST, text).right is right


def test_a_condition_that_always_holds_finds_no_family_by_one_of_its_factors() -> None:
    found = judged("twolink", MotionRows.TRANSLATION, "sin(q2)*(sin(q1)^2 + cos(q1)^2 - 1)")
    assert [entry.status for entry in found.conditions] == [ConditionStatus.EVERYWHERE]
    assert [family.found for family in found.families] == [0.0, 0.0]
    assert found.share == 0.0
