"""Runs of joints with parallel axes: what lies between them is dissolved where a rule allows it."""

from fractions import Fraction

import pytest

from kinematics.dh import MotionKind
from kinematics.expressions import Expression, Parameter, add, multiply, number, pi_times
from kinematics.symbolic.angles import angle_of
from kinematics.symbolic.motions import Motion
from kinematics.symbolic.nested import Arena
from kinematics.symbolic.runs import Runs

BETA = Parameter("beta")
TWIST, TURN = MotionKind.TURN_X, MotionKind.TURN_Z


def quarter(times: int) -> Expression:
    return pi_times(Fraction(times, 2))


@pytest.mark.parametrize("first", [1, -1])
@pytest.mark.parametrize("second", [1, -1])
def test_between_right_angles_a_constant_turn_is_a_twist(first: int, second: int) -> None:
    """Rot_x(±π/2) Rot_z(β) Rot_x(∓π/2) = Rot_z(π/2) Rot_x(∓β) Rot_z(-π/2), and likewise with equal signs."""
    around = [Motion(TURN, joint=1), Motion(TWIST, quarter(first)), Motion(TURN, BETA)]
    around += [Motion(TWIST, quarter(second)), Motion(TURN, joint=2)]
    before, behind = Runs.of(Arena(), around).finished()
    q1, q2 = (angle_of(part) for part in (before.angle.expression(), behind.angle.expression()))
    turned = multiply((number(-first), BETA))
    assert before.twist == angle_of(add((turned, quarter(2))) if first == second else turned)
    assert (q1.half_turns, q1.weight_of(1)) == (Fraction(1, 2), 1)
    assert (q2.half_turns, q2.weight_of(2)) == (Fraction(first * second, 2), 1)


@pytest.mark.parametrize("first", [1, -1])
@pytest.mark.parametrize("twist", [BETA, pi_times(Fraction(1, 3))], ids=str)
def test_between_other_twists_a_constant_turn_stays(first: int, twist: Expression) -> None:
    for pair in ((quarter(first), twist), (twist, quarter(first))):
        around = [Motion(TURN, joint=1), Motion(TWIST, pair[0]), Motion(TURN, BETA), Motion(TWIST, pair[1])]
        assert len(Runs.of(Arena(), [*around, Motion(TURN, joint=2)]).finished()) == 3
