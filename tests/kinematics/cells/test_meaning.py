"""What cells mean: exact values, degrees and radians, kinds of parameters."""

import math
from fractions import Fraction

import pytest

from kinematics.cells import AngleUnit, ParameterKind, read_cell
from kinematics.errors import CellError
from kinematics.expressions import (
    PI,
    ZERO,
    Call,
    Function,
    JointVariable,
    Number,
    Parameter,
    add,
    call,
    evaluate,
    multiply,
    number,
    pi_times,
)
from tests.kinematics.cells.tables import faults_of, raw_row, read

DEG, RAD = AngleUnit.DEG, AngleUnit.RAD
ANGLE, LENGTH = ParameterKind.ANGLE, ParameterKind.LENGTH
BETA, L1, L2 = Parameter("beta"), Parameter("L1"), Parameter("L2")


def turns(numerator: int, denominator: int = 1):
    return pi_times(Fraction(numerator, denominator))


@pytest.mark.parametrize(
    ("cell", "meant"),
    [
        (0, ZERO),
        (-0.0, ZERO),
        (0.4318, number("0.4318")),
        ("0.4318", number("0.4318")),
        (" 1e-3 ", number("0.001")),
        (".5", number("0.5")),
        ("5.", number(5)),
        ("+3", number(3)),
        ("007", number(7)),
        (10**15, number(10**15)),
        ("0.1+0.2", number("0.3")),
        ("2^10", number(1024)),
        ("2**-1", number("0.5")),
        ("-2^2", number(-4)),
        ("2^3^1", number(8)),
        ("4^0.5", number(2)),
        ("9^(-1/2)", number(Fraction(1, 3))),
        ("(1+2)*3-4/2", number(7)),
        ("--1", number(1)),
        ("-+-1", number(1)),
        ("8/4/2", number(1)),
        ("sqrt(16)", number(4)),
        ("sqrt(2)^2", number(2)),
        ("1/sqrt(2)", multiply((number("0.5"), call(Function.SQRT, number(2))))),
        ("abs(-3)", number(3)),
        ("L1", L1),
        ("L1+L2", add((L1, L2))),
        ("L1-L1", ZERO),
        ("2L1", multiply((number(2), L1))),
        ("2(L1+L2)", multiply((number(2), add((L1, L2))))),
        ("L1 L2", multiply((L1, L2))),
        ("L1*sin(pi/6)", multiply((number("0.5"), L1))),
        ("L1*cos(pi)", multiply((number(-1), L1))),
        ("sin(pi/3)", multiply((number("0.5"), call(Function.SQRT, number(3))))),
        ("cos(-pi/4)", multiply((number("0.5"), call(Function.SQRT, number(2))))),
        ("tan(3*pi/4)", number(-1)),
        ("sin(pi/12)", Call(Function.SIN, (turns(1, 12),))),
        ("L1*cos(beta)", multiply((L1, call(Function.COS, BETA)))),
    ],
)
def test_lengths_are_exact(cell, meant):
    assert read_cell(cell, LENGTH) == meant
    if isinstance(cell, str):
        assert read_cell(cell, LENGTH, angle_unit=DEG) == meant


@pytest.mark.parametrize(
    ("cell", "meant"),
    [
        ("pi", PI),
        ("π/2", turns(1, 2)),
        ("-pi/2", turns(-1, 2)),
        ("pi*0.5", turns(1, 2)),
        ("3pi/4", turns(3, 4)),
        ("pi/2+pi/3", turns(5, 6)),
        (math.pi / 2, turns(1, 2)),
        (-math.pi / 2, turns(-1, 2)),
        (math.radians(75), turns(5, 12)),
        (2 * math.pi, turns(2)),
        ("1.5707963267948966", turns(1, 2)),
        ("1.570796326794897", turns(1, 2)),
        ("q1-1.5707963267948966", add((JointVariable(1), turns(-1, 2)))),
        (1.5708, number("1.5708")),
        (1.57, number("1.57")),
        (1, number(1)),
        ("90°", turns(1, 2)),
        ("-90°+q2", add((turns(-1, 2), JointVariable(2)))),
        ("45deg", turns(1, 4)),
        ("asin(1/2)", turns(1, 6)),
        ("acos(0)", turns(1, 2)),
        ("acos(-sqrt(3)/2)", turns(5, 6)),
        ("atan(1)", turns(1, 4)),
        ("atan(sqrt(3)/3)", turns(1, 6)),
        ("atan2(1, -1)", turns(3, 4)),
        ("atan2(0, -1)", PI),
        ("atan2(-2, 0)", turns(-1, 2)),
        ("atan2(L1, L2)", Call(Function.ATAN2, (L1, L2))),
        ("beta/2", multiply((number("0.5"), BETA))),
    ],
)
def test_angles_in_radians_are_exact(cell, meant):
    assert read_cell(cell, ANGLE) == meant


@pytest.mark.parametrize(
    ("cell", "meant"),
    [
        (90, turns(1, 2)),
        (-90, turns(-1, 2)),
        ("-90", turns(-1, 2)),
        (22.5, turns(1, 8)),
        ("0.1", turns(1, 1800)),
        (0, ZERO),
        ("pi/2", turns(1, 2)),
        ("pi/2+90", PI),
        ("π - 30", turns(5, 6)),
        ("90+90°", PI),
        ("90°", turns(1, 2)),
        ("(30+15)°", turns(1, 4)),
        ("2*45", turns(1, 2)),
        ("180/4", turns(1, 4)),
        ("(1+1)*(pi/4)", turns(1, 2)),
        ("3*(pi/2-45)", turns(3, 4)),
        ("pi/180*90", turns(1, 2)),
        ("sqrt(2)*45", multiply((turns(1, 4), call(Function.SQRT, number(2))))),
        ("q1+90", add((JointVariable(1), turns(1, 2)))),
        ("-q1-pi/2", add((multiply((number(-1), JointVariable(1))), turns(-1, 2)))),
        ("beta", BETA),
        ("beta+10", add((BETA, turns(1, 18)))),
        ("2*beta", multiply((number(2), BETA))),
        ("atan2(1, 1)", turns(1, 4)),
        ("atan2(1, 1)+45", turns(1, 2)),
        ("asin(1/2)", turns(1, 6)),
        ("abs(-90)", turns(1, 2)),
        ("abs(-pi/2)", turns(1, 2)),
        ("30*sin(30)", turns(1, 12)),
    ],
)
def test_angles_in_degrees_are_exact(cell, meant):
    assert read_cell(cell, ANGLE, angle_unit=DEG) == meant


@pytest.mark.parametrize(
    ("cell", "value"),
    [
        ("L*sin(30)", 0.5),
        ("L*cos(pi/3)", 0.5),
        ("L*cos(60°)", 0.5),
        ("L*tan(atan2(1,2))", 0.5),
        ("L*sin(pi/2-60)", 0.5),
    ],
)
def test_trigonometric_arguments_of_a_table_in_degrees_are_in_degrees(cell, value):
    assert evaluate(read_cell(cell, LENGTH, angle_unit=DEG), {"L": 1.0}) == pytest.approx(value, abs=1e-15)


def test_trigonometric_arguments_of_a_table_in_radians_are_in_radians():
    assert evaluate(read_cell("sin(30)", LENGTH)) == pytest.approx(math.sin(30))
    assert evaluate(read_cell("sin(30°)", LENGTH)) == 0.5


@pytest.mark.parametrize(
    ("cell", "kind", "unit", "code"),
    [
        ("90°°", ANGLE, RAD, "symbol_misplaced"),
        ("pi°", ANGLE, DEG, "degree_of_angle"),
        ("beta°", ANGLE, RAD, "degree_of_angle"),
        ("L1*90°", LENGTH, RAD, "degree_in_length"),
        ("atan(1)", LENGTH, DEG, "angle_in_length"),
        ("pi*pi", ANGLE, DEG, "angle_product"),
        ("alpha*beta", ANGLE, RAD, "angle_product"),
        ("beta*90°", ANGLE, DEG, "angle_product"),
        ("1/pi", ANGLE, DEG, "angle_in_denominator"),
        ("90/beta", ANGLE, RAD, "angle_in_denominator"),
        ("beta^2", ANGLE, RAD, "angle_power"),
        ("pi^2", ANGLE, DEG, "angle_power"),
        ("L1+sin(L1)", LENGTH, RAD, "parameter_two_kinds"),
    ],
)
def test_angles_and_lengths_are_not_mixed(cell, kind, unit, code):
    with pytest.raises(CellError) as caught:
        read_cell(cell, kind, angle_unit=unit)
    assert caught.value.code == code


def test_pi_is_a_number_in_a_table_in_radians():
    assert evaluate(read_cell("pi^2/8", ANGLE)) == pytest.approx(math.pi**2 / 8)
    assert evaluate(read_cell("0.5*180/pi", ANGLE)) == pytest.approx(90 / math.pi)
    assert evaluate(read_cell("pi*0.1", LENGTH, angle_unit=DEG)) == pytest.approx(math.pi / 10)


def test_kinds_of_parameters_follow_from_where_they_stand():
    table = read(
        raw_row(theta="q1+beta", d="L1*cos(gamma)", a="a1", alpha="atan2(h, w)"),
        raw_row(theta="q2", d="sqrt(r^2-s^2)", alpha="delta"),
    )
    assert list(table.parameters.items()) == [
        ("h", LENGTH),
        ("w", LENGTH),
        ("a1", LENGTH),
        ("L1", LENGTH),
        ("gamma", ANGLE),
        ("beta", ANGLE),
        ("delta", ANGLE),
        ("r", LENGTH),
        ("s", LENGTH),
    ]


def test_a_parameter_is_not_both_an_angle_and_a_length():
    assert faults_of(raw_row(theta="q1", a="x"), raw_row(theta="q2", alpha="x")) == [
        ("parameter_two_kinds", ("rows", 1, "alpha"))
    ]


def test_large_multiples_do_not_snap():
    assert isinstance(read_cell(1e6 * math.pi, ANGLE), Number)
