"""Entry by entry: the equations give the matrix, and each fits a line."""

import random

import numpy as np
import pytest

from kinematics.catalogue import robots
from kinematics.cells import ParameterKind, RawRow, RawTable, read_cell, read_table
from kinematics.expressions import Parameter, evaluate, number
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.symbolic import closed_form, jacobian
from kinematics.table import Convention, table_parameters
from tests.kinematics.symbolic.tables import puma, row, table

PRINTER = {"n_joints": 6, "parameters": ("a2", "a3", "d3", "d4"), "notation": Notation.SHORT}


def lines_of(matrix, result="T", **options):
    purpose = Purpose(name="f", meaning=".", result=result)
    return MatrixPrinter(**options).write(matrix, (Format.ENTRIES,), purpose)["entries"]


@pytest.mark.parametrize("robot", robots(), ids=lambda robot: robot.id)
@pytest.mark.parametrize("wanted", ["pose", "jacobian"])
def test_the_equations_give_the_matrix(robot, wanted):
    symbolic = robot.table.table
    names = table_parameters(symbolic)
    matrix = closed_form(symbolic).transform if wanted == "pose" else jacobian(symbolic)
    rng = random.Random(5)
    values = {name: rng.uniform(0.2, 1) for name in names}
    joints = [rng.uniform(-3, 3) for _ in range(symbolic.n_joints)]
    lines = lines_of(matrix, "J", n_joints=symbolic.n_joints, parameters=names)
    known, found = dict(values), []
    for line in lines:
        entry = read_cell(line["text"], ParameterKind.LENGTH)
        known[line["name"]] = evaluate(entry, known, joints)
        assert line["latex"].count("=") == 1
        if not line["name"].startswith("k"):
            found.append(known[line["name"]])
    rows = matrix[:3] if wanted == "pose" else matrix
    expected = [evaluate(entry, values, joints) for line in rows for entry in line]
    np.testing.assert_allclose(found, expected, atol=1e-12)


@pytest.mark.parametrize(
    ("own", "rotation", "position"),
    [
        (("r11", "L"), "R", "p"),
        (("px", "L"), "r", "P"),
        (("p_x", "r_23"), "R", "P"),
        (("l1", "l2"), "r", "p"),
    ],
)
def test_entries_are_not_called_what_the_robot_calls_its_own(own, rotation, position):
    links = table(Convention.STANDARD, *(row(a=Parameter(name)) for name in own))
    lines = lines_of(closed_form(links).transform, n_joints=2, parameters=own)
    names = [line["name"] for line in lines if not line["name"].startswith("k")]
    assert names[:4] == [f"{rotation}11", f"{rotation}12", f"{rotation}13", f"{position}x"]
    assert not set(own) & set(names)
    for line in lines:
        left, right = line["latex"].split("=")
        assert left not in right


def test_the_puma_fits_a_page():
    lines = lines_of(closed_form(puma(Convention.MODIFIED)).transform, **PRINTER)
    written = {line["name"]: line["text"] for line in lines}
    assert written["k1"] == "c4*c5*c6 - s4*s6"
    assert written["r11"] == "c1*k2 + s1*k3"
    assert lines[0]["latex"] == "k_{1}=c_{4}c_{5}c_{6}-s_{4}s_{6}"
    assert list(written)[-12:] == [
        "r11",
        "r12",
        "r13",
        "px",
        "r21",
        "r22",
        "r23",
        "py",
        "r31",
        "r32",
        "r33",
        "pz",
    ]
    assert max(map(len, written.values())) < 40


def test_intermediates_take_a_letter_that_no_parameter_has():
    symbolic = puma(Convention.MODIFIED)
    lines = lines_of(closed_form(symbolic).transform, **{**PRINTER, "parameters": ("k1", "w2")})
    assert lines[0]["name"] == "u1"


def test_entries_take_names_that_no_parameter_has():
    taken = ("r11", "px", "k1", "w1", "u1", "v1", "a1", "b1", "J12", "j12")
    form = closed_form(puma(Convention.MODIFIED)).transform
    names = [line["name"] for line in lines_of(form, **{**PRINTER, "parameters": taken})]
    assert names[0] == "d1"
    assert names[-4:] == ["R31", "R32", "R33", "Pz"]
    form = jacobian(puma(Convention.MODIFIED))
    names = [line["name"] for line in lines_of(form, "J", **{**PRINTER, "parameters": taken})]
    assert names[-1] == "JJ66"


def test_columns_of_two_digits_are_kept_apart():
    symbolic = table(Convention.STANDARD, *[row(a=number(1))] * 10)
    lines = lines_of(jacobian(symbolic), "J", n_joints=10, parameters=())
    assert {"J1_10", "J1_1"} <= {line["name"] for line in lines}
    assert any(line["latex"].startswith("J_{1,10}=") for line in lines)


def test_variables_keep_the_names_that_were_typed():
    rows = (
        RawRow(theta="θ1", d=0, a=0, alpha="-pi/2"),
        RawRow(theta="\\theta_2*", d="L2", a=0, alpha="pi/2"),
        RawRow(theta=0, d="d3", a=0, alpha=0),
        RawRow(theta="q4", d="d4", a=0, alpha=0),
    )
    read = read_table(RawTable(convention=Convention.STANDARD, rows=rows))
    assert read.variables == ("theta1", "theta2", "d3", "q4")
    printer = MatrixPrinter(n_joints=4, parameters=tuple(read.parameters), variables=read.variables)
    form = closed_form(read.table).transform
    formats = (Format.TEXT, Format.LATEX, Format.MATHML, Format.JSON, Format.SYMPY, Format.PYTHON)
    written = printer.write(form, formats, Purpose(name="T", meaning="."))
    assert written["text"][2][3] == "cos(theta2)*(d3 + d4)"
    assert r"\cos(\theta_{2})" in written["latex"]
    assert "<mi>θ</mi><mn>2</mn>" in written["mathml"]
    assert 'd3 = Symbol("d3")' in written["sympy"].replace("'", '"')
    assert "q[2]" in written["python"]


def test_a_name_that_a_parameter_has_or_that_numbers_rows_is_not_kept():
    rows = (RawRow(theta=0, d="d1", a=0, alpha=0), RawRow(theta="q2", d="d1", a=0, alpha=0))
    assert read_table(RawTable(convention=Convention.STANDARD, rows=rows)).variables == ("q1", "q2")
    fixed = RawRow(theta=0, d=1, a=0, alpha=0)
    numbered = (fixed, RawRow(theta="θ2", d=0, a=0, alpha=0))
    assert read_table(RawTable(convention=Convention.STANDARD, rows=numbered)).variables == ("q1",)


def test_twists_stand_in_their_order():
    rows = [RawRow(theta=f"q{i}", d=0, a=0, alpha=f"alpha{i}") for i in (1, 2)]
    read = read_table(RawTable(convention=Convention.STANDARD, rows=tuple(rows)))
    printer = MatrixPrinter(n_joints=2, parameters=tuple(read.parameters))
    text = printer.write(closed_form(read.table).transform, (Format.TEXT,), Purpose(name="T", meaning="."))
    assert "sin(alpha1)*sin(alpha2)" in text["text"][2][2]
