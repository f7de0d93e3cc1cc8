r"""Functions, fractions and rates as they are printed."""

import pytest

from kinematics.cells.scanner import scan


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("-L_1 \\sin\\theta_1 - L_2 \\sin(\\theta_1+\\theta_2)", "-L1 sin(theta1) - L2 sin(theta1+theta2)"),
        ("\\sin\\theta_1\\cos\\theta_2", "sin(theta1) cos(theta2)"),
        ("\\sin^2\\theta_1 + 1", "sin(theta1)^2 + 1"),
        ("\\sin^{2}{\\left(q_{2} \\right)}", "sin{(q2)}^{2}"),
        ("sin^2(cos^3(q1) + 1)*L1", "sin(cos(q1)^3 + 1)^2*L1"),
        ("½π", "(1/2)pi"),
        ("|L1 - L2| + 1", "abs(L1 - L2) + 1"),
        ("-¾", "-(3/4)"),
        ("\\dot{q}_1 \\dot\\theta_2", "dq1 dq2"),
        ("\\dot{\\theta}_{2}^2", "dq2^2"),
        ("q\u03071*θ\u0307₂ + q\u0307_{3}", "dq1*dq2 + dq3"),
    ],
)
def test_what_is_printed_is_read_as_what_it_means(typed: str, meant: str) -> None:
    assert [(token.type, str(token)) for token in scan(typed)] == [
        (token.type, str(token)) for token in scan(meant)
    ]
