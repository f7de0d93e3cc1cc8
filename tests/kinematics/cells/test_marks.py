"""What students type for a joint variable, a number or a name: understood, or told."""

import pytest

from kinematics.cells import AngleUnit, ParameterKind, nearest_name, rate_in_marks, read_cell
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.scanner import scan
from kinematics.errors import CellError, KinematicsError
from tests.kinematics.cells.tables import faults_of, raw_row, read

NAMES = ("L1", "L2", "a2", "a3", "D3", "RL4", "alpha1", "reach")


@pytest.mark.parametrize(
    "cell",
    [
        "θ₁*",
        "θ_1^*",
        "\\theta_1^*",
        "\\theta_{1}^{*}",
        "$\\theta_1^{*}$",
        "q1*",
        "q_1 *",
        "q1(t)",
        "\\theta_1(t)",
        "theta(1)",
        "q(1)",
        "θ(1)",
        "(q1*)",
        "theta1 ^ *",
        "q1(t)*",
        "θ^*_1",
        "\\theta^*_1",
        "\\theta^{*}_{1}",
        "θ*₁",
        "q*_1",
        "θ∗_1",
        "\\theta_1^\\ast",
        "q_1^{\\ast}",
        "q^{\\ast}_1",
        "q_1^\\star",
        "theta[1]",
        "q[1]",
        "θ[1]",
        "\\theta[1](t)",
    ],
)
def test_a_marked_joint_variable_is_the_variable(cell):
    assert read(raw_row(theta=cell)).table == read(raw_row(theta="q1")).table


@pytest.mark.parametrize(
    ("cell", "same"),
    [
        ("θ1* + 90", "q1 + 90"),
        ("θ1*-90", "q1-90"),
        ("-θ1* + 90", "-q1+90"),
        ("90 - q1(t)", "90-q1"),
        ("q1*-1", "-q1"),
    ],
)
def test_a_mark_stands_before_an_offset(cell, same):
    options = {"angle_unit": AngleUnit.DEG}
    assert read(raw_row(theta=cell), **options).table == read(raw_row(theta=same), **options).table


@pytest.mark.parametrize("cell", ["d1*", "d_1^*", "d1(t)", "d(1)", "q1*", "d^*_1", "d*₁", "d[1]"])
def test_a_slider_is_marked_in_the_same_ways(cell):
    assert read(raw_row(d=cell)).table == read(raw_row(d="d1")).table


@pytest.mark.parametrize(
    ("cell", "code"),
    [
        ("L1(t)", "function_unknown"),
        ("L(1)", "function_unknown"),
        ("q1(s)", "variable_called"),
        ("q(1.5)", "function_unknown"),
        ("L1*", "cell_incomplete"),
        ("q1**", "cell_incomplete"),
        ("q1*L1", "variable_in_product"),
        ("q1*2", "variable_scaled"),
        ("θ*", "variable_without_number"),
        ("\\theta^* + 90", "variable_without_number"),
        ("θ*1", "variable_without_number"),
        ("L*₁", "script_misplaced"),
        ("q[i]", "character_not_allowed"),
        ("[θ1]", "character_not_allowed"),
        ("q(t)", "variable_without_number"),
    ],
)
def test_what_only_looks_like_a_mark_is_refused_as_before(cell, code):
    assert faults_of(raw_row(theta=cell)) == [(code, ("rows", 0, "theta"))]


@pytest.mark.parametrize(
    "name", ["th1", "t1", "TH_1", "teta1", "vartheta1", "THETA1", "THETA_1", "var", "variable", "Var"]
)
def test_other_names_of_the_variable_are_told(name):
    assert faults_of(raw_row(theta=name)) == [("variable_misspelled", ("rows", 0, "theta"))]
    assert not faults_of(raw_row(theta="q1", d=name))


@pytest.mark.parametrize(("name", "suggestion"), [("th3", "q3"), ("var", "q"), ("variable", "q")])
def test_no_row_is_told_the_variable_of_another(name, suggestion):
    """The word alone stands in every row, and q1 in one."""
    with pytest.raises(KinematicsError) as caught:
        read(raw_row(theta=name))
    (fault,) = caught.value.faults
    assert fault.params["suggestion"] == suggestion


@pytest.mark.parametrize("cell", ["-", "–", "—", " − ", "--"])
def test_a_dash_alone_is_no_value(cell):
    assert faults_of(raw_row(a=cell)) == [("cell_dash", ("rows", 0, "a"))]


@pytest.mark.parametrize("cell", ["L1*sin30", "cos45", "sen 30"])
def test_a_number_behind_a_function_is_its_argument(cell):
    assert faults_of(raw_row(a=cell)) == [("function_without_parentheses", ("rows", 0, "a"))]


@pytest.mark.parametrize("cell", ["4×10-1", "4*10−1", "q1 + 1.5·10-3", "4 * 10-1", "4&times;10&minus;1"])
def test_a_power_that_a_pdf_lost_is_told(cell):
    """4×10⁻¹ was read as 39."""
    with pytest.raises(CellRefusal, match="exponent_ambiguous") as refused:
        scan(cell)
    assert refused.value.params["number"] in {"4e-1", "1.5e-3"}


@pytest.mark.parametrize("cell", ["4*10 - 1", "10-3", "2*10-3*L1", "2*10-L1", "4*10^-1"])
def test_a_difference_from_tens_is_read(cell):
    scan(cell)


@pytest.mark.parametrize("cell", ["1,000.5", "1.000,5"])
def test_separators_of_thousands_are_told_as_such(cell):
    assert faults_of(raw_row(a=cell)) == [("number_malformed", ("rows", 0, "a"))]


@pytest.mark.parametrize(
    ("cell", "size"),
    [("1e-400", "small"), ("1e400", "large"), ("((0.1^9)^9)^9", "small")],
)
def test_a_number_out_of_range_is_too_small_or_too_large(cell, size):
    with pytest.raises(CellError) as error:
        read_cell(cell, ParameterKind.LENGTH)
    (fault,) = error.value.faults
    assert (fault.code, fault.params["size"]) == ("number_out_of_range", size)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("A2", "a2"),
        ("rl4", "RL4"),
        ("d3", "D3"),
        ("l_1", "L1"),
        ("Ll", "L1"),
        ("alhpa1", "alpha1"),
        ("α_1", "alpha1"),
        ("aplha1", "alpha1"),
        ("reac", "reach"),
        ("raech", "reach"),
        ("L3", None),
        ("a4", None),
        ("x", None),
        ("alpha2", None),
        ("", None),
        ("a2", "a2"),
    ],
)
def test_the_nearest_name(typed, meant):
    assert nearest_name(typed, NAMES) == meant


@pytest.mark.parametrize("typed", ["α2", "α_2", "alpha2", "\\alpha_2"])
def test_an_alpha_is_an_a_where_no_name_has_one(typed):
    assert nearest_name(typed, ("a2", "a3", "d1")) == "a2"
    assert nearest_name(typed, ("a2", "alpha1")) is None
    assert nearest_name(typed, ("a3", "d2")) is None


def test_two_names_as_near_are_no_suggestion():
    assert nearest_name("A2", ("a2", "a_2")) == "a2"
    assert nearest_name("reech", ("reach", "reuch")) is None


@pytest.mark.parametrize(
    ("cell", "decimal"),
    [("59°30'", "59.5°"), ("q1 - 12º 30′ 36″", "12.51°"), ("7°0.6'", "7.01°"), ("≈ 59.9", "59.9")],
)
def test_minutes_of_arc_and_about_are_told_in_decimals(cell, decimal):
    with pytest.raises(CellError) as refused:
        read_cell(cell, ParameterKind.ANGLE)
    (fault,) = refused.value.faults
    assert fault.params["suggestion"] == decimal


@pytest.mark.parametrize("typed", ["q1_dot", "qdot1", "q_dot1", "qp1", "dtheta1", "dth_1", "theta1_dot"])
def test_a_rate_by_another_name(typed):
    known = ("dq1", "dq2", "L1", "q1x")
    assert nearest_name(typed, known) == "dq1"
    assert nearest_name(typed, ("L1", "L2", "dq2")) is None


@pytest.mark.parametrize(
    "typed", ["dq1/dt", "dq_1 / dt", "dθ1", "dθ_1/dt", "dtheta1/dt", "q1'", "θ1’", "q_1′", "theta1'"]
)
def test_a_rate_in_marks_of_calculus(typed):
    assert rate_in_marks(f"2*m2*{typed} + L1", ("L1", "dq1", "dq2")) == (typed, "dq1")
    assert rate_in_marks(f"2*m2*{typed} + L1", ("L1", "dq2")) is None


@pytest.mark.parametrize("cell", ["dq1", "q1''", "q1", "dq1/dtx", "dq1*dq2", "add1/dt", "xq1'"])
def test_no_rate_in_marks(cell):
    assert rate_in_marks(cell, ("dq1", "dq2")) is None


def test_a_name_d_or_dt_is_no_mark():
    assert rate_in_marks("dθ1", ("d", "dq1")) is None
    assert rate_in_marks("dq1/dt", ("dt", "dq1")) is None
