"""Closed forms as SymPy objects: there and back, with nothing lost and nothing evaluated by surprise."""

import random
import subprocess
import sys
from fractions import Fraction

import pytest
import sympy

from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    Parameter,
    add,
    call,
    multiply,
    number,
    pi_times,
    power,
)
from kinematics.symbolic import ProofStatus, compare, count_operations, from_sympy, to_sympy
from kinematics.symbolic.closed_form import Workings
from kinematics.symbolic.interchange import SympyNodes
from kinematics.table import Convention
from tests.conftest import EXPLORE
from tests.kinematics.symbolic.tables import puma, random_table

X = sympy.Symbol("x")
TABLES = 1000 if EXPLORE else 50
PROVED = TABLES // 20
"""Tables of which the evaluated form is proved equal, entry by entry."""


def test_tables_there_and_back() -> None:
    rng = random.Random(20)
    for number_of_table in range(TABLES):
        table = random_table(rng, rng.randrange(1, 6), fixed=rng.randrange(3))
        transform = Workings(table).transform
        nested, evaluated = to_sympy(transform, evaluate=False), to_sympy(transform)
        for i, row in enumerate(transform[:3]):
            for j, entry in enumerate(row):
                assert from_sympy(nested[i, j]) == entry
                back = from_sympy(evaluated[i, j])
                assert to_sympy(back) == evaluated[i, j]
                if number_of_table < PROVED:
                    assert compare(back, entry) is ProofStatus.PROVED


def test_the_puma_keeps_its_form() -> None:
    transform = Workings(puma(Convention.STANDARD)).transform
    written = to_sympy(transform)
    operations = sum(int(sympy.count_ops(entry)) for entry in written[:3, :])
    assert operations == count_operations([entry for row in transform for entry in row]) <= 270
    q2, q3 = sympy.symbols("q2 q3")
    a2, a3, d4 = sympy.symbols("a2 a3 d4")
    height = a2 * sympy.sin(q2) + a3 * sympy.sin(q2 + q3) - d4 * sympy.cos(q2 + q3)
    assert written[2, 3].subs(d4, -d4) == height  # d4 has the other sign in that table


@pytest.mark.parametrize(
    "expression",
    [
        *map(number, ("2", "-2", "0.5", "-0.5")),
        *(power(Parameter("x"), Fraction(*exponent)) for exponent in ((-1, 1), (2, 1), (-2, 1))),
        add((number("-0.5"), Parameter("x"))),
        add((multiply((number(-1), Parameter("x"))), multiply((number(-3), JointVariable(1))))),
        multiply((number("-0.5"), Parameter("x"), JointVariable(1))),
        call(Function.ATAN2, number("-0.5"), Parameter("x")),
    ],
    ids=str,
)
def test_operations_are_counted_as_sympy_counts_them(expression: Expression) -> None:
    assert count_operations([expression]) == sympy.count_ops(to_sympy(expression))


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (number("0.4318"), sympy.Rational(2159, 5000)),
        (power(Parameter("x"), Fraction(-3, 2)), sympy.Symbol("x") ** sympy.Rational(-3, 2)),
        (call(Function.SQRT, Parameter("x")), sympy.sqrt(sympy.Symbol("x"))),
        (call(Function.ABS, Parameter("x")), sympy.Abs(sympy.Symbol("x"))),
        (call(Function.ATAN2, Parameter("y"), Parameter("x")), sympy.atan2(*sympy.symbols("y x"))),
        (
            call(Function.COS, add((JointVariable(12), pi_times(Fraction(1, 4))))),
            sympy.cos(sympy.Symbol("q12") + sympy.pi / 4),
        ),
        (multiply((number(-2), Parameter("lambda"))), -2 * sympy.Symbol("lambda")),
    ],
)
def test_each_node_has_its_counterpart(expression: object, expected: sympy.Expr) -> None:
    assert to_sympy(expression) == expected
    assert from_sympy(expected) == expression


def test_a_matrix_of_one_row_or_none_keeps_its_shape() -> None:
    assert to_sympy(()).shape == (0, 0)
    assert to_sympy(((number(1), number(2)),)).shape == (1, 2)


def test_constants_under_a_sine_stay_as_written() -> None:
    angle = call(Function.SIN, pi_times(Fraction(1, 5)))
    assert to_sympy(angle).func is sympy.sin
    assert from_sympy(to_sympy(angle)) == angle


def test_a_float_means_the_decimal_that_it_prints() -> None:
    assert from_sympy(sympy.Float(0.1)) == number("0.1")


@pytest.mark.parametrize(
    "foreign", [sympy.exp(sympy.Symbol("x")), sympy.oo, sympy.I, sympy.Symbol("x") ** sympy.Symbol("y")]
)
def test_what_has_no_counterpart_is_refused(foreign: sympy.Expr) -> None:
    with pytest.raises(ValueError, match="no counterpart"):
        from_sympy(foreign)


def test_a_parameter_cannot_pass_for_a_joint_variable() -> None:
    with pytest.raises(ValueError, match="joint variable"):
        to_sympy(Parameter("q1"))


def test_sympy_is_imported_by_those_alone_who_want_it() -> None:
    program = """
import sys
import service.app
from kinematics.catalogue import robots
from kinematics.printing import Format, MatrixPrinter, Purpose
from kinematics.symbolic import Workings, prove_identity
from kinematics.table import table_parameters
table = robots()[0].table.table
printer = MatrixPrinter(n_joints=table.n_joints, parameters=table_parameters(table))
readable = (Format.LATEX, Format.MATHML, Format.TEXT, Format.JSON)
printer.write(Workings(table).transform, readable, Purpose(name="f", meaning="."))
assert "sympy" not in sys.modules
printer.write(Workings(table).transform, (Format.C,), Purpose(name="f", meaning="."))
assert "sympy" in sys.modules
"""
    subprocess.run([sys.executable, "-c", program], check=True)


def test_nodes_are_put_into_the_order_of_sympy_unless_they_are_to_stay_as_they_are() -> None:
    x, y = sympy.symbols("x y")
    expression = add((Parameter("y"), Parameter("x")))
    assert SympyNodes().convert(expression).args == (x + y).args == (x, y)
    assert SympyNodes(evaluate=False).convert(expression).args == (y, x)
