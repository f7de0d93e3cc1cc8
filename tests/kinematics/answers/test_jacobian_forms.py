"""Jacobians and joint forces as functions, against derivatives of products of DH matrices."""

import random
from fractions import Fraction

import numpy as np
import pytest

from kinematics.answers.jacobian_answers import judge_jacobian
from kinematics.answers.jacobian_forms import force_form, jacobian_form, judge_force_form, judge_jacobian_form
from kinematics.answers.jacobian_verdicts import JacobianMistake
from kinematics.cells.substitution import substitute
from kinematics.chain import chain_of_table
from kinematics.errors import JointValueError
from kinematics.expressions import ZERO, Parameter, add, call, evaluate, multiply, negate, power
from kinematics.expressions.trees import Function, JointVariable, number
from kinematics.jacobian import JacobianFrame
from kinematics.rates import analytic_jacobian
from kinematics.rotations.sequences import SEQUENCES, EulerSequence
from kinematics.symbolic import ProofStatus
from kinematics.table import bind
from tests.kinematics.answers.jacobian_forms import cases, entries, robot

BASE, END = JacobianFrame.BASE, JacobianFrame.END


def test_right_ones_are_accepted_however_written_and_wrong_ones_refused() -> None:
    for found, rows, frame, right in cases(60, 7):
        verdict = judge_jacobian_form(found, rows, frame, 1e-6)
        assert verdict.right is right
        if right and found.table.n_joints < 5:  # the product rule makes more of six than a proof may expand
            assert verdict.proof is ProofStatus.PROVED


def test_rounded_numbers_are_right_within_the_tolerance_but_not_proved() -> None:
    arm = robot("twolink")
    values = {name: number(f"{value:.3f}") for name, value in arm.values.items()}
    form = [list(row) for row in jacobian_form(arm.table, BASE)]
    form[0][1] = _lever(values["L2"], "1.001")
    found = judge_jacobian_form(arm, form, BASE, 0.005)
    assert found.right
    assert found.proof is ProofStatus.REFUTED
    form[0][1] = _lever(values["L2"], "1.2")
    assert np.argwhere(~judge_jacobian_form(arm, form, BASE, 0.005).entries).tolist() == [[0, 1]]


def _lever(length, factor):
    q12 = add((JointVariable(1), JointVariable(2)))
    return multiply((number(-1), length, number(factor), call(Function.SIN, q12)))


def test_a_length_of_the_same_value_is_not_the_same_length() -> None:
    arm = robot("scara")
    equal = type(arm)(table=arm.table, values=dict.fromkeys(arm.values, 0.4), lengths=arm.lengths)
    form = [list(row) for row in entries("scara", BASE)]
    assert judge_jacobian_form(equal, form, BASE, 0.005).right
    form[0][0] = substitute(form[0][0], {"a2": Parameter("a3"), "a3": Parameter("a2")})
    assert not judge_jacobian_form(equal, form, BASE, 0.005).right


@pytest.mark.parametrize("sequence", SEQUENCES[::7], ids=lambda found: f"{found.axes}-{found.turning}")
def test_the_analytic_form_is_the_analytic_jacobian_in_numbers(sequence: EulerSequence) -> None:
    arm = robot("stanford")
    form = jacobian_form(arm.table, BASE, sequence)
    rng = random.Random(3)
    chain = chain_of_table(bind(arm.table, arm.values))
    for _ in range(3):
        q = [rng.uniform(-2, 2) for _ in range(6)]
        numbers = np.array([[evaluate(entry, arm.values, q) for entry in row] for row in form])
        expected = analytic_jacobian(chain, q, sequence)
        assert expected is not None
        assert judge_jacobian(chain, q, numbers, BASE, 1e-7, sequence).right
        numbers[4] *= -1  # the other triple of the same orientation
        assert judge_jacobian(chain, q, numbers, BASE, 1e-7, sequence).right
        numbers[3] *= -1
        assert not judge_jacobian(chain, q, numbers, BASE, 1e-7, sequence).right
    other = [list(row) for row in form]
    other[4] = [negate(entry) for entry in other[4]]
    assert judge_jacobian_form(arm, other, BASE, 1e-6, sequence).right
    other[5] = [negate(entry) for entry in other[5]]
    assert not judge_jacobian_form(arm, other, BASE, 1e-6, sequence).right


def test_angles_that_are_always_locked_are_refused_by_name() -> None:
    with pytest.raises(JointValueError) as refusal:
        judge_jacobian_form(robot("scara"), entries("scara", BASE), BASE, 0.005, EulerSequence(axes="ZYZ"))
    assert [fault.code for fault in refusal.value.faults] == ["angles_locked"]
    assert analytic_jacobian(robot("scara").chain, [0.1] * 4, EulerSequence(axes="ZYZ")) is None


def test_slips_are_named() -> None:
    arm = robot("stanford")
    base, end = entries("stanford", BASE), jacobian_form(arm.table, END)
    rates = jacobian_form(arm.table, BASE, EulerSequence(axes="ZYZ"))

    def told(rows, frame=BASE, angles=None):
        return judge_jacobian_form(arm, rows, frame, 1e-3, angles).mistakes

    assert told(base, END) == ((JacobianMistake.OTHER_FRAME, None),)
    assert told((*base[3:], *base[:3])) == ((JacobianMistake.ROWS_EXCHANGED, None),)
    assert told(base, BASE, EulerSequence(axes="ZYZ")) == ((JacobianMistake.GEOMETRIC, None),)
    assert not told(rates, BASE, EulerSequence(axes="ZYZ"))
    one = [[*row[:3], end[r][3], *row[4:]] for r, row in enumerate(base)]
    assert told(one) == ((JacobianMistake.OTHER_FRAME, 4),)
    sign = [[negate(row[0]) if r < 3 else row[0], *row[1:]] for r, row in enumerate(base)]
    assert told(sign) == ((JacobianMistake.POINT_SWAPPED, 1),)
    slider = [[*row[:2], base[r - 3][2] if r > 2 else ZERO, *row[3:]] for r, row in enumerate(base)]
    assert told(slider) == ((JacobianMistake.PRISMATIC, 3),)


@pytest.mark.parametrize("sign", [1, -1])
def test_slips_of_an_analytic_jacobian_are_named_for_either_triple(sign: int) -> None:
    arm, zyz = robot("stanford"), EulerSequence(axes="ZYZ")
    rates = [list(row) for row in jacobian_form(arm.table, BASE, zyz)]
    if sign < 0:
        rates[4] = [negate(entry) for entry in rates[4]]

    def told(rows):
        return judge_jacobian_form(arm, rows, BASE, 1e-3, zyz).mistakes

    assert told((*rates[3:], *rates[:3])) == ((JacobianMistake.ROWS_EXCHANGED, None),)
    degree = number(Fraction(355, 113 * 180))
    per_degree = [[e if i == 2 else multiply((degree, e)) for i, e in enumerate(row)] for row in rates]
    assert told(per_degree) == ((JacobianMistake.PER_DEGREE, None),)
    millimetres = [[multiply((number(1000), e)) for e in row] for row in rates[:3]]
    assert told((*millimetres, *rates[3:])) == ((JacobianMistake.OTHER_UNIT, None),)


def test_forces_are_functions_of_the_load_too() -> None:
    arm = robot("scorbot")
    loaded = type(arm)(
        table=arm.table, values={**arm.values, "fx": 7.0, "mz": 4.0}, lengths=arm.lengths | {"mz"}
    )
    wrench = [Parameter("fx"), ZERO, number(3), ZERO, ZERO, Parameter("mz")]
    forces = force_form(arm.table, wrench, BASE)
    assert judge_force_form(loaded, forces, wrench, BASE, 1e-6) == ((True,) * 5, ProofStatus.PROVED, None)
    turned = [negate(force) for force in forces]
    right, _, mistake = judge_force_form(loaded, turned, wrench, BASE, 1e-6)
    assert right[0] is False
    assert mistake is JacobianMistake.SIGN


def test_entries_without_a_value_are_wrong_and_no_error() -> None:
    arm = robot("twolink")
    form = [list(row) for row in jacobian_form(arm.table, BASE)]
    form[0][0] = call(Function.SQRT, add((number(-4), call(Function.SIN, JointVariable(1)))))
    form[1][0] = call(Function.ASIN, add((number(4), JointVariable(1))))
    found = judge_jacobian_form(arm, form, BASE, 0.005)
    assert np.argwhere(~found.entries).tolist() == [[0, 0], [1, 0]]


def test_quotients_are_proved_by_multiplying_crosswise() -> None:
    arm, rates = robot("scorbot"), EulerSequence(axes="XYZ")
    form = [list(row) for row in jacobian_form(arm.table, BASE, rates)]
    sine, cosine = call(Function.SIN, JointVariable(1)), call(Function.COS, JointVariable(1))
    square = add((number(1), multiply((number(-1), sine, sine))))
    for r in (0, 1, 2, 3, 5):
        form[r] = [multiply((entry, cosine, cosine, power(square, -1))) for entry in form[r]]
    found = judge_jacobian_form(arm, form, BASE, 1e-6, rates)
    assert found.right
    assert found.proof is ProofStatus.PROVED
    form[3][0] = multiply((form[3][0] if form[3][0] != ZERO else cosine, cosine))
    assert np.argwhere(~judge_jacobian_form(arm, form, BASE, 1e-6, rates).entries).tolist() == [[3, 0]]


def test_long_entries_that_no_proof_multiplies_out_are_compared() -> None:
    arm = robot("twolink")
    form = [list(row) for row in jacobian_form(arm.table, BASE)]
    angles = [add((JointVariable(1), multiply((number(k), JointVariable(2))))) for k in range(3, 9)]
    long = add(call(Function.SIN, angle) for angle in angles)
    factor = power(add((number(9), long)), 24)
    form[0][0] = multiply((form[0][0], factor, power(factor, -1)))
    assert judge_jacobian_form(arm, form, BASE, 1e-6).right
    form[0][0] = multiply((form[0][0], number("1.01")))
    assert np.argwhere(~judge_jacobian_form(arm, form, BASE, 1e-6).entries).tolist() == [[0, 0]]


@pytest.mark.parametrize("sign", [1, -1])
def test_one_wrong_entry_beside_the_other_triple_is_one_wrong_entry(sign: int) -> None:
    """The row of the middle angle may have either sign, and what is wrong in it is told entry by entry."""
    arm, zyz = robot("stanford"), EulerSequence(axes="ZYZ")
    rates = [list(row) for row in jacobian_form(arm.table, BASE, zyz)]
    if sign < 0:
        rates[4] = [negate(entry) for entry in rates[4]]
    rates[4][1] = add((rates[4][1], number(Fraction(1, 2))))
    right = np.array(judge_jacobian_form(arm, rates, BASE, 1e-3, zyz).entries)
    assert np.argwhere(~right).tolist() == [[4, 1]]
    joints = [0.3, 0.8, 0.4, -0.6, 1.1, 0.2]
    given = analytic_jacobian(arm.chain, np.array(joints), zyz)
    given[4] *= sign
    given[4, 1] += 0.5
    verdict = judge_jacobian(arm.chain, joints, given, BASE, 1e-3, zyz)
    assert np.argwhere(~verdict.entries).tolist() == [[4, 1]]
