"""Infix text: the cell grammar reads it back as the same function."""

import random
from fractions import Fraction

import pytest

from kinematics.cells import AngleUnit, ParameterKind, read_cell
from kinematics.cells.grammar import parse
from kinematics.cells.limits import Limits
from kinematics.cells.meaning import Position, interpret
from kinematics.cells.variables import variable_index
from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    Parameter,
    Pi,
    Product,
    Sum,
    add,
    call,
    multiply,
    negate,
    number,
    pi_times,
    power,
)
from kinematics.printing.latex import LatexWriter
from kinematics.printing.notation import Names, Notation
from kinematics.printing.numbers import decimal_text
from kinematics.printing.text import TextWriter
from kinematics.symbolic import closed_form, same_function
from tests.kinematics.symbolic.rewriting import random_expression
from tests.kinematics.symbolic.tables import random_table

L1, L2 = Parameter("L1"), Parameter("L2")
q1, q2, q3 = map(JointVariable, (1, 2, 3))
AMPLE = Limits(cell_characters=10**6, cell_depth=500, cell_symbols=64, digits=60)


def full(expression: Expression) -> str:
    return TextWriter(Names()).text(expression)


def short(expression: Expression, **names: object) -> str:
    return TextWriter(Names(notation=Notation.SHORT, **names)).text(expression)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("value", "written"),
    [
        ("1/2", None),
        ("3/4", None),
        ("1/8", None),
        ("1/3", None),
        ("7", None),
        ("0.4318", "0.4318"),
        ("0.1", "0.1"),
        ("-0.05", "-0.05"),
        ("2.5", None),  # 5/2
        ("12.04", "12.04"),
        ("0.0625", "0.0625"),
        ("1e-7", "0.0000001"),
        ("1e-9", "0.000000001"),
        ("1e-10", "1e-10"),
        ("-8.940316365525654e-18", "-8.940316365525654e-18"),
        ("2.5e-300", "2.5e-300"),
        ("123456.789", "123456.789"),
        ("0.7071067811865476", "0.7071067811865476"),
    ],
)
def test_a_decimal_is_written_as_typed(value: str, written: str | None) -> None:
    assert decimal_text(Fraction(value)) == written
    if written is not None:
        assert Fraction(written) == Fraction(value)


@pytest.mark.parametrize(
    ("expression", "written"),
    [
        (pi_times(Fraction(1, 2)), "pi/2"),
        (pi_times(Fraction(-37, 180)), "-37*pi/180"),
        (multiply((number("1/2"), call(Function.SQRT, number(2)))), "sqrt(2)/2"),
        (multiply((number("-3/4"), L1)), "-3*L1/4"),
        (multiply((number("0.4318"), L1)), "0.4318*L1"),
        (add((L1, negate(L2))), "L1 - L2"),
        (add((negate(L1), L2)), "-L1 + L2"),
        (multiply((L1, add((L1, negate(L2))))), "L1*(L1 - L2)"),
        (negate(multiply((L1, add((L1, L2))))), "-L1*(L1 + L2)"),
        (power(add((L1, L2)), 2), "(L1 + L2)^2"),
        (power(L1, -1), "1/L1"),
        (power(add((L1, L2)), -2), "1/(L1 + L2)^2"),
        (multiply((number("2/3"), L1, power(L2, -1))), "2*L1/(3*L2)"),
        (power(L1, Fraction(1, 3)), "L1^(1/3)"),
        (power(L1, Fraction(1, 2)), "sqrt(L1)"),
        (call(Function.ATAN2, L1, negate(L2)), "atan2(L1, -L2)"),
        (power(call(Function.COS, q1), 2), "cos(q1)^2"),
        (number(-2), "-2"),
        (power(number("-2"), Fraction(1, 3)), "(-2)^(1/3)"),
    ],
)
def test_spelling(expression: Expression, written: str) -> None:
    assert full(expression) == written


def times(value: str, *factors: Expression) -> Expression:
    return multiply((number(value), *factors))


ROOT = call(Function.SQRT, number(3))
EIGHTH = multiply((times("0.4", L1), add((times("1/8", L2), number("5/2")))))


@pytest.mark.parametrize(
    ("expression", "written"),
    [
        (add((times("0.4", L1), times("1/2", L2))), "0.4*L1 + 0.5*L2"),
        (add((times("1/2", L1), times("1/4", L2))), "L1/2 + L2/4"),
        (add((times("0.425", L1), times("-3/8", L2), number("5/2"))), "0.425*L1 - 0.375*L2 + 2.5"),
        (add((times("0.4", L1), times("1/2", ROOT, L2), times("1/3", L2))), "0.4*L1 + sqrt(3)*L2/2 + L2/3"),
        (
            add((times("0.4", L1), call(Function.COS, add((q1, pi_times(Fraction(1, 4))))))),
            "0.4*L1 + cos(q1 + pi/4)",
        ),
        (EIGHTH, "0.4*L1*(0.125*L2 + 2.5)"),
        (add((EIGHTH, times("1/2", power(L2, -1)))), "0.4*L1*(0.125*L2 + 2.5) + 1/(2*L2)"),
    ],
)
def test_fractions_beside_decimals_are_decimals(expression: Expression, written: str) -> None:
    assert full(expression) == written
    latex = LatexWriter(Names()).text(expression)
    assert (r"\frac{1}{2}" in latex) is (written == "L1/2 + L2/4")


def test_an_entry_without_decimals_keeps_its_fractions_beside_one_that_has_some() -> None:
    half, whole = times("1/2", L1), add((times("1/2", L1), times("0.4", L2)))
    writer = TextWriter(Names())
    assert [writer.text(half), writer.text(whole), writer.text(half)] == ["L1/2", "0.5*L1 + 0.4*L2", "L1/2"]


def test_short_names_stand_where_nothing_else_can_be_meant() -> None:
    c23 = call(Function.COS, add((q2, q3)))
    assert short(c23) == "c23"
    assert short(call(Function.SIN, q1)) == "s1"
    assert short(call(Function.COS, add((q2, negate(q3))))) == "cos(q2 - q3)"
    assert short(call(Function.COS, add((q1, pi_times(Fraction(1, 4)))))) == "cos(q1 + pi/4)"
    assert short(c23, parameters={"c23"}) == "cos(q2 + q3)"
    assert short(c23, separated=True) == "c2_3"
    assert short(call(Function.COS, JointVariable(12))) == "c12"
    assert short(call(Function.TAN, q1)) == "tan(q1)"
    assert full(c23) == "cos(q2 + q3)"


def variable_of(name: str) -> JointVariable | None:
    index = variable_index(name)
    return None if index is None else JointVariable(index)


@pytest.mark.parametrize("seed", range(60))
def test_the_cell_grammar_reads_it_back_as_the_same_function(seed: int) -> None:
    expression = random_expression(random.Random(seed), 2)
    node = parse(full(expression), AMPLE)
    again = interpret(node, Position.LENGTH, AngleUnit.RAD, AMPLE, variable_of).expression
    assert same_function(again, expression)


@pytest.mark.parametrize("seed", range(20))
def test_entries_of_closed_forms_are_cells(seed: int) -> None:
    rng = random.Random(seed)
    transform = closed_form(random_table(rng, 3, fixed=1)).transform
    writer = TextWriter(Names())
    for line in transform:
        for entry in line:
            parse(writer.text(entry), AMPLE)


@pytest.mark.parametrize(
    "written", ["cos_1", "sin_{2}", "tan₃", "atan_2", "arctan_2", "sqrt_2", "L_1", "θ_{max}"]
)
def test_a_name_is_printed_so_that_it_is_read_as_that_name(written: str) -> None:
    length = read_cell(written, ParameterKind.LENGTH)
    assert isinstance(length, Parameter)
    assert read_cell(full(length), ParameterKind.LENGTH) == length


def test_trees_that_no_constructor_made_are_written_as_they_are() -> None:
    """Two numbers in a product, a sum within a sum: the constructors fold them, but nothing else must."""
    assert full(Product((L1, number(2), number("1/3")))) == "2*L1/3"
    assert full(Sum((L1, Sum((negate(L2), L1))))) == "L1 + (-L2 + L1)"


def test_a_shared_node_is_written_once_and_reads_the_same_everywhere() -> None:
    shared = add((L1, multiply((L2, Pi()))))
    writer = TextWriter(Names())
    assert writer.text(multiply((shared, shared))) == "(L1 + L2*pi)*(L1 + L2*pi)"
