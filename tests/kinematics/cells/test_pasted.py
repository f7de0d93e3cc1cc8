"""Cells as people paste them from a PDF, a word processor, a spreadsheet or LaTeX."""

import pytest

from kinematics.cells import AngleUnit, ParameterKind, canonical_name, read_cell

ANGLE, LENGTH = ParameterKind.ANGLE, ParameterKind.LENGTH


@pytest.mark.parametrize(
    ("pasted", "plain"),
    [
        ("\u2212pi/2", "-pi/2"),
        ("\u2013pi/2", "-pi/2"),
        ("\u2011pi/2", "-pi/2"),
        ("π\u20442", "pi/2"),
        ("π÷2", "pi/2"),
        ("2×π/3", "2*pi/3"),
        ("2·π/3", "2*pi/3"),
        ("2⋅π/3", "2*pi/3"),
        ("q1\u00a0+\u2009π/2", "q1+pi/2"),
        ("\tq1\n", "q1"),
        ("θ1", "q1"),
        ("θ_1", "q1"),
        ("θ₁", "q1"),
        ("theta1", "q1"),
        ("theta_1", "q1"),
        ("theta_{1}", "q1"),
        ("q_1", "q1"),
        ("q_{1}", "q1"),
        ("q₁", "q1"),
        ("Q1", "q1"),
        ("Θ1", "q1"),
        ("ϑ₁", "q1"),
        ("\U0001d703\u2081", "q1"),
        ("\U0001d45e1", "q1"),
        ("\\theta_1", "q1"),
        ("\\theta_{12}", "q12"),
        ("\\vartheta_1", "q1"),
        ("\\theta _1", "q1"),
        ("$\\theta_1$", "q1"),
        ("\\(\\theta_1 + 90\\)", "q1 + 90"),
        ("$\\( q1 \\)$", "q1"),
        ("$$-\\frac{\\pi}{2}$$", "-pi/2"),
        ("\\theta_1 + \\frac{\\pi}{2}", "q1+pi/2"),
        ("\\dfrac{3\\pi}{4}", "3*pi/4"),
        ("\\left(\\theta_1-\\pi\\right)", "q1-pi"),
        ("\\theta_1\\,+\\;\\pi", "q1+pi"),
        ("2\\cdot\\pi\\div 3", "2*pi/3"),
        ("90^\\circ", "pi/2"),
        ("90^{\\circ}", "pi/2"),
        ("90\\degree", "pi/2"),
        ("90º", "pi/2"),
        ("90⁰", "pi/2"),
        ("90^0", "pi/2"),
        ("90^{0}", "pi/2"),
        ("−90^o", "-pi/2"),
        ("90^{o}", "pi/2"),
        ("q1 + 90⁰", "q1 + pi/2"),
        ("2*45⁰", "pi/2"),
        ("1.5*10^0", "1.5"),
        ("2**0 + 1", "2"),
        ("1.5×10⁰", "1.5"),
        ("30¹⁰/30⁹", "30"),
        ("3²*0 + 1", "1"),
        ("RADIANS(90)", "pi/2"),
        ("{\\theta}_1", "q1"),
        ("{\\theta _1} - {\\theta _{2}}", "q1 - q2"),
        ("2*({q}_{1})", "2*q1"),
        ("90˚", "pi/2"),
        ("90◦", "pi/2"),
        ("−90 ∘", "-pi/2"),
        ("90 °", "pi/2"),
        ("−90°", "-pi/2"),
        ("PI()/2", "pi/2"),
        ("np.pi/2", "pi/2"),
        ("-math.pi / 2 + sp.pi", "pi/2"),
        ("np.deg2rad(90)", "pi/2"),
        ("math.radians(-45*2)", "-pi/2"),
        ("radians(90) + q1", "pi/2+q1"),
        ("\\frac12", "1/2"),
        ("\\frac\\pi2", "pi/2"),
        ("-\\frac \\pi 2", "-pi/2"),
        ("\\tfrac{\\pi}2", "pi/2"),
        ("\\dfrac3{4}\\pi", "3*pi/4"),
        ("\\frac{\\frac12}{\\frac34}", "2/3"),
        ("\\frac{\\frac{1}2\\pi}4", "pi/8"),
        ('"90°"', "pi/2"),
        (" 'q1' ", "q1"),
        ("“pi/2”", "pi/2"),
        ("„pi/2“", "pi/2"),
        ("'=PI()/2'", "pi/2"),
        ("Pi/2", "pi/2"),
        ("2π/3", "2*pi/3"),
        ("\\alpha_1", "alpha1"),
        ("α₁", "alpha1"),
        ("φ", "phi"),
        ("\\phi", "phi"),
        ("arctg(1)", "pi/4"),
        ("\\arctan(1)", "atan(1)"),
        ("arcsin(1)", "asin(1)"),
    ],
)
def test_pasted_angle(pasted, plain):
    assert read_cell(pasted, ANGLE) == read_cell(plain, ANGLE)


@pytest.mark.parametrize(
    ("pasted", "plain"),
    [
        ("L₁", "L1"),
        ("L_1", "L1"),
        ("L_{1}", "L1"),
        ("L_{ 1 }", "L1"),
        ("L_{max}", "L_max"),
        ("L[1]", "L1"),
        ("2*a[2] + L[12]", "2*a2 + L12"),
        ("{L}_{1}/2", "L1/2"),
        ("{L}_1\\sin(30^0)", "L1/2"),
        ("lₙ", "l_n"),
        ("\U0001d43f\u2081", "L1"),
        ("L1²", "L1^2"),
        ("L1⁻¹", "L1^-1"),
        ("L1¹⁰", "L1^10"),
        ("L_1^{2}", "L1^2"),
        ("L_1^{-1}", "L1^-1"),
        ("\\sqrt{2}L_1", "sqrt(2)*L1"),
        ("√2/2", "sqrt(2)/2"),
        ("√(L1²+L2²)", "sqrt(L1^2+L2^2)"),
        ("√L1", "sqrt(L1)"),
        ("\\sqrt{L_1^2+L_2^2}", "sqrt(L1^2+L2^2)"),
        ("\\frac{L_1}{2}", "L1/2"),
        ("1/\\frac{L_1}{2}", "2/L1"),
        ("L_1\\sin(\\beta)", "L1*sin(beta)"),
        ("L_1\\cos{\\beta}", "L1*cos(beta)"),
        ("L1 cos(β)", "L1*cos(beta)"),
        ("L1 sen(β)", "L1*sin(beta)"),
        ("L1*tg(β)", "L1*tan(beta)"),
        ("SQRT(2)", "sqrt(2)"),
        ("2 L1", "2*L1"),
        ("2L1+3L2", "2*L1+3*L2"),
        ("(L1)(L2)", "L1*L2"),
        ("2(L1)", "2*L1"),
        ("μ", "mu"),
        ("µ", "mu"),
    ],
)
def test_pasted_length(pasted, plain):
    assert read_cell(pasted, LENGTH) == read_cell(plain, LENGTH)


@pytest.mark.parametrize(
    ("given", "name"),
    [
        ("L1", "L1"),
        ("L_1", "L1"),
        ("L₁", "L1"),
        ("L_{1}", "L1"),
        (" L1 ", "L1"),
        ("α", "alpha"),
        ("D3", "D3"),
        ("RL4", "RL4"),
        ("L_max", "L_max"),
        ("a_1_2", "a1_2"),
        ("L01", "L01"),
        ("", None),
        ("1", None),
        ("L1+L2", None),
        ("pi", None),
        ("sin", None),
        ("L1 L2", None),
        ("x" * 33, None),
        ("__class__", None),
        ("nan", None),
    ],
)
def test_one_spelling_of_a_name(given, name):
    assert canonical_name(given) == name


def test_columns_are_those_of_the_text_as_typed():
    from kinematics.errors import CellError

    for text, column in [("θ₁ + −²", 7), ("\\frac{\\pi}{2} + ?", 17), ("$\\theta_1 +$", 12)]:
        with pytest.raises(CellError) as caught:
            read_cell(text, ANGLE, angle_unit=AngleUnit.RAD)
        assert caught.value.faults[0].params["column"] == column
