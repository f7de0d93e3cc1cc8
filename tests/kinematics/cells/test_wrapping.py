"""Cells as formula editors, computer algebra and pages write them: they mean what they show."""

import pytest

from kinematics.cells import AngleUnit, ParameterKind, read_cell
from kinematics.errors import CellError
from tests.kinematics.cells.tables import faults_of, raw_row

ANGLE, LENGTH = ParameterKind.ANGLE, ParameterKind.LENGTH


@pytest.mark.parametrize(
    ("pasted", "plain"),
    [
        # MathType puts a base, and the whole of base and index, into braces
        ("{{\\theta }_{1}}", "q1"),
        ("\\[{{\\theta }_{1}}\\]", "q1"),
        ("{{\\theta }_{1}}^{*}", "q1"),
        ("{{\\theta }_{1}}+\\frac{\\pi }{2}", "q1 + pi/2"),
        ("{{\\theta }_{1}}-{{90}^{\\circ }}", "q1 - 90°"),
        ("{{90}^{{}^\\circ }}", "90°"),
        ("90{}^\\circ", "90°"),
        ("2{\\pi}/{3}", "2*pi/3"),
        ("\\[-\\frac{\\pi }{2}\\]", "-pi/2"),
        ("90\\textdegree", "90°"),
        # Mathematica
        ("\\[Pi]/2", "pi/2"),
        ("Subscript[θ,1]", "q1"),
        ("Subscript[\\[Theta], 1] + \\[Pi]/2", "q1 + pi/2"),
        ("-\\[Theta]1", "-q1"),
        ("\\[CapitalTheta]1", "q1"),
        ("\\[CurlyTheta]1", "q1"),
        ("90\\[Degree]", "90°"),
        # siunitx
        ("\\ang{90}", "90°"),
        ("q1 - \\ang{22.5}", "q1 - 22.5°"),
        ("-\\ang{ 90 }", "-90°"),
        # pages
        ("90&deg;", "90°"),
        ("&minus;&pi;/2", "-pi/2"),
        ("&theta;<sub>1</sub> + 90&#176;", "q1 + 90°"),
        ("&theta;&#8321;&nbsp;&#x2212; &pi;/2", "q1 - pi/2"),
        # other keyboards, other fonts, other spreadsheets
        ("п/2", "pi/2"),
        ("-П/2", "-pi/2"),
        ("2п/3", "2*pi/3"),
        ("пі/2", "pi/2"),
        ("пи/2", "pi/2"),
        ("ϖ/2", "pi/2"),
        ("∏/2", "pi/2"),
        ("=RADIANES(90)", "pi/2"),
        # letters that look like θ, and an index that a PDF no longer lowers
        ("Ѳ1", "q1"),
        ("ө₁", "q1"),
        ("{\\theta }₁ - 90°", "q1 - 90°"),
        ("θ 1", "q1"),
        ("q 1 + 90°", "q1 + 90°"),
        ("theta 12", "q12"),
        ("=RADIANOS(-90)", "-pi/2"),
    ],
)
def test_angle(pasted, plain):
    assert read_cell(pasted, ANGLE) == read_cell(plain, ANGLE)


@pytest.mark.parametrize(
    ("pasted", "plain"),
    [
        ("{{L}_{1}}", "L1"),
        ("L 1 + a 2", "L1 + a2"),
        ("2 d 3", "2*d3"),
        ("{{L}_{1}}+{{L}_{2}}", "L1 + L2"),
        ("2{{L}_{1}}", "2*L1"),
        ("\\sqrt{2}{{L}_{1}}", "sqrt(2)*L1"),
        ("\\frac{{{L}_{1}}}{2}{{L}_{2}}", "L1/2*L2"),
        ("\\frac{1}{{{L}_{1}}}", "1/L1"),
        ("1/{2{{L}_{1}}}", "1/(2*L1)"),
        ("-{L_1-L_2}", "-(L1 - L2)"),
        ("{L}x", "L*x"),
        ("{L}1", "L1"),
        ("{L}₁", "L1"),
        ("{L_1}x", "L1*x"),
        ("{L_1}_2", "L_1_2"),
        ("{\\it L}_1", "L1"),
        ("{\\rm L}_{1}", "L1"),
        ("\\displaystyle L_1", "L1"),
        ("a\\_2 + 1", "a2 + 1"),
        ("L ₁", "L1"),
        ("Subscript[a,2]", "a2"),
        ("Subscript[L, max]/2", "L_max/2"),
        ("a<sub>2</sub>", "a2"),
        ("2&times;L1", "2*L1"),
        ("&frac12;L1&sup2;", "L1^2/2"),
        ("2Subscript[a,2]", "2*a2"),
        ("RAIZ(2)*L1", "sqrt(2)*L1"),
        ("=RACINE(2)", "sqrt(2)"),
        ("L1*SENO(pi/6)", "L1/2"),
        ("L^{2}^{1}", "L^2"),
        # an index in braces, or a lowered one, ends where it ends
        ("c₁c₂ − s₁s₂", "c1*c2 - s1*s2"),
        ("c_{1}c_{2}-s_{1}s_{2}", "c1*c2 - s1*s2"),
        ("c_1c_2 - s_1s_2", "c1*c2 - s1*s2"),
        ("L1*c_{1}c_2+s_12c3", "L1*c1*c2 + s12*c3"),
        ("L_{max}x", "L_max*x"),
        ("cosθ₁cosθ₂ - sinq1sinq2", "cos(θ1)*cos(θ2) - sin(q1)*sin(q2)"),
        ("L1 cosq_{12}", "L1*cos(q12)"),
        ("Cos[q1 + Subscript[q, 2]]", "cos(q1 + q2)"),
        ("Sqrt[L1^2 + Cos[θ[1]]^2]", "sqrt(L1^2 + cos(q1)^2)"),
    ],
)
def test_length(pasted, plain):
    assert read_cell(pasted, LENGTH) == read_cell(plain, LENGTH)


@pytest.mark.parametrize(
    ("cell", "code"),
    [
        ("L{1}", "number_after_value"),
        ("L₁2", "names_run_together"),
        ("L_{1}2", "names_run_together"),
        ("{L_1}2", "number_after_value"),
        ("{{L}_{1}}2", "number_after_value"),
        ("xSubscript[a,2]", "character_not_allowed"),
        ("0&middot;5", "number_malformed"),
        ("10\\,\\rm mm", "unit_in_cell"),
        ("L1L2", "names_run_together"),
        ("cosq1²", "function_without_parentheses"),
        ("ArcTan[1, 2]", "character_not_allowed"),
        ("Cos[q1", "character_not_allowed"),
        ("{}", "value_missing"),
        ("{L1", "parenthesis_not_closed"),
        ("{L1)", "value_missing"),
        ("\\[Foo]", "character_not_allowed"),
        ("Subscript[a]", "character_not_allowed"),
        ("&lt;", "character_not_allowed"),
        ("&nothing;", "character_not_allowed"),
        ("&#0;", "character_not_allowed"),
        ("п1", "character_not_allowed"),
        ("кут", "character_not_allowed"),
        ("\\frac{{L}_1}", "cell_incomplete"),
        ("d3 (m)", "unit_in_cell"),
        ("0.15 [mm]", "unit_in_cell"),
        ("2*L1 (cm.)", "unit_in_cell"),
        ("3 x 4", "number_after_value"),
        ("1 e 3", "number_after_value"),
        ("L 1 2", "number_after_value"),
        # half of L, or half of L1; an exponent as Fortran prints it; an index with a zero before it
        ("L 1/2", "number_after_value"),
        ("1.5D 03", "number_after_value"),
        ("L 01", "number_after_value"),
        ("n/a", "cell_dash"),
        (" N/A ", "cell_dash"),
        ("n.a.", "cell_dash"),
    ],
)
def test_what_means_nothing_is_refused(cell, code):
    assert faults_of(raw_row(a=cell)) == [(code, ("rows", 0, "a"))]


def test_where_a_joint_variable_may_be_multiplied_a_product_is_proposed():
    """A slide times a sum, in an entry of a matrix: it was told to write an offset."""
    with pytest.raises(CellError) as caught:
        read_cell("q3(L1 + L2)", LENGTH)
    (fault,) = caught.value.faults
    assert (fault.code, fault.params["name"]) == ("function_unknown", "q3")


@pytest.mark.parametrize("cell", ["θ1(+90°)", "θ1 (0)", "\\theta_1 (var)", "Q1(2)"])
def test_no_product_is_proposed_where_something_in_parentheses_follows_a_joint_variable(cell):
    assert faults_of(raw_row(theta=cell)) == [("variable_called", ("rows", 0, "theta"))]


def test_lengths_n_and_a_may_still_be_divided():
    assert read_cell("L1*n/a", LENGTH) == read_cell("L1*n*(1/a)", LENGTH)


def test_columns_are_those_of_the_text_as_typed():
    for text, column in [("90&deg; + ?", 11), ("{{\\theta }_{1}} + ?", 19), ("\\[Pi]/2 + ?", 11)]:
        with pytest.raises(CellError) as caught:
            read_cell(text, ANGLE, angle_unit=AngleUnit.RAD)
        assert caught.value.faults[0].params["column"] == column
