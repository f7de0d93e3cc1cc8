"""Equations of motion as an answer: any form, any C with the right C q̇; slips are told."""

from dataclasses import replace

import pytest

from kinematics.answers.dynamics_answers import judge_dynamics
from kinematics.answers.dynamics_verdicts import DynamicsMistake, EquationsAnswer
from kinematics.symbolic import ProofStatus
from tests.kinematics.answers.dynamics_rows import campaign, question, read

TWO = question(2)
H = "m2*L1*r2*s2"
MASS = [
    ["m1*r1^2 + m2*(L1^2 + r2^2 + 2*L1*r2*c2) + I1 + I2", "m2*r2*(r2 + L1*c2) + I2"],
    ["m2*r2*(r2 + L1*c2) + I2", "I2 + m2*r2^2"],
]
BARE = [[cell.replace("I1 + I2", "0").replace("I2", "0") for cell in row] for row in MASS]
GRAVITY = ["(m1*r1 + m2*L1)*g*c1 + m2*r2*g*c12", "m2*r2*g*c12"]


def judged(**parts):
    given = {
        name: read(rows) if isinstance(rows[0], list) else read([rows])[0] for name, rows in parts.items()
    }
    return judge_dynamics(TWO, EquationsAnswer(**given))


def test_answers_written_differently_are_accepted_and_wrong_ones_refused() -> None:
    right, wrong, misjudged, _ = campaign(60)
    assert misjudged == []
    assert min(right, wrong) > 15


def test_the_equations_of_books_are_proved() -> None:
    coriolis = [[f"-{H}*dq2", f"-{H}*(dq1 + dq2)"], [f"{H}*dq1", "0"]]
    found = judged(mass=MASS, coriolis=coriolis, gravity=GRAVITY)
    assert found.right
    assert found.skew
    assert found.proof is ProofStatus.PROVED
    assert found.mistakes == ()


def test_another_matrix_with_the_same_product_is_right_but_not_skew() -> None:
    found = judged(coriolis=[[f"-2*{H}*dq2", f"-{H}*dq2"], [f"{H}*dq1", "0"]])
    assert found.right
    assert found.skew is False
    assert found.mass is None
    assert judged(velocity=[f"-{H}*(2*dq1*dq2 + dq2^2)", f"{H}*dq1^2"]).skew is None


@pytest.mark.parametrize(
    ("parts", "mistake"),
    [
        ({"gravity": [f"-({cell})" for cell in GRAVITY]}, DynamicsMistake.GRAVITY_SIGN),
        ({"mass": BARE}, DynamicsMistake.POINT_MASSES),
        ({"mass": [MASS[0], ["m2*r2*(r2 + L1*s2) + I2", MASS[1][1]]]}, DynamicsMistake.ASYMMETRIC),
        ({"velocity": [f"-{H}*(dq1*dq2 + dq2^2)", f"{H}*dq1^2"]}, DynamicsMistake.COUPLING_ONCE),
        ({"velocity": [f"{H}*(2*dq1*dq2 + dq2^2)", f"-{H}*dq1^2"]}, DynamicsMistake.VELOCITY_SIGN),
        ({"velocity": [f"-{H}*(2*dq1*dq2 + dq2^2)", f"-{H}*dq1*dq2"]}, DynamicsMistake.MASS_RATE),
    ],
)  # fmt: skip
def test_slips_are_told(parts, mistake: DynamicsMistake) -> None:
    found = judged(**parts)
    assert not found.right
    assert found.proof is ProofStatus.REFUTED
    assert found.mistakes == (mistake,)


def test_numbers_in_the_place_of_names_are_right_at_the_values_and_wrong_names_are_not() -> None:
    found = judged(gravity=["(3*0.2 + 2*0.5)*9.81*c1 + 2.943*c12", "2.94*c12"])
    assert found.right
    assert found.proof is ProofStatus.UNDECIDED
    assert not judged(gravity=["(m1*r1 + m2*L1)*g*c1 + m2*r2*g*c12", "m1*r2*g*c12*2/3"]).right
    assert judged(gravity=["15.696*c1 + 2.943*c12", "2.943*c1"]).gravity == (True, False)


@pytest.mark.parametrize("factor", ["0", "2", "-1", "0.5"])
def test_a_term_that_is_small_beside_the_others_is_no_rounding(factor: str) -> None:
    """The tool of a SCARA hardly matters for M, and M_14 is its moment of inertia alone."""
    light = replace(TWO, values={**TWO.values, "I2": 1e-5})
    for i, j in ((0, 0), (0, 1), (1, 1)):
        spoilt = [list(row) for row in MASS]
        spoilt[i][j] = spoilt[i][j].replace("I2", f"{factor}*I2")
        answer = EquationsAnswer(mass=read(spoilt))
        found = judge_dynamics(light, answer)
        assert found.mass is not None
        assert not found.mass[i][j]
    assert judge_dynamics(light, EquationsAnswer(mass=read(MASS))).right


def test_entries_that_have_no_value_are_wrong() -> None:
    assert not judged(gravity=["1/(s1^2 + c1^2 - 1)", "m2*r2*g*c12"]).right
