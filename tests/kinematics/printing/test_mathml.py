"""MathML: well formed, with the right signs, and content that says what is meant."""

import random
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from fractions import Fraction

import pytest

from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Pi,
    add,
    call,
    multiply,
    negate,
    number,
    pi_times,
    power,
)
from kinematics.printing.mathml import MathmlWriter
from kinematics.printing.notation import Names, Notation
from kinematics.symbolic import closed_form, same_function
from kinematics.table import Convention
from tests.kinematics.symbolic.rewriting import random_expression
from tests.kinematics.symbolic.tables import puma

NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"
TIMES, APPLY, MINUS = "\u2062", "\u2061", "\u2212"
q1, q2, q3 = map(JointVariable, (1, 2, 3))


def presentation(expression: Expression, notation: Notation = Notation.SHORT) -> str:
    return MathmlWriter(Names(notation=notation)).text(expression)


def matrix_of(entries: Sequence[Sequence[Expression]], notation: Notation) -> str:
    writer = MathmlWriter(Names(notation=notation))
    return writer.table(writer.ledger.matrix(entries))


def spoken(markup: str) -> str:
    """What stands in the markup, in order."""
    return "".join(ET.fromstring(markup).itertext())


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (multiply((Parameter("L1"), call(Function.COS, q1))), f"L1{TIMES}c1"),
        (negate(Parameter("L1")), f"{MINUS}L1"),
        (add((Parameter("L1"), negate(Parameter("L2")))), f"L1{MINUS}L2"),
        (call(Function.COS, add((q2, negate(q3)))), f"c2{MINUS}3"),
        (call(Function.TAN, Parameter("alpha1")), f"tan{APPLY}(α1)"),
        (pi_times(Fraction(-1, 2)), f"{MINUS}π2"),
        (multiply((number("1/2"), call(Function.SQRT, number(3)), call(Function.COS, q1))), f"32{TIMES}c1"),
        (number("0.4318"), "0.4318"),
    ],
)
def test_signs_and_invisible_operators(expression: Expression, expected: str) -> None:
    assert spoken(presentation(expression)) == expected


def test_a_squared_sine_is_written_as_people_do_and_two_numbers_have_a_dot_between_them() -> None:
    squared = power(call(Function.SIN, q1), 2)
    assert spoken(presentation(squared, Notation.FULL)) == f"sin2{APPLY}(q1)"
    assert spoken(presentation(squared)) == "s12"
    roots = multiply((power(number(2), Fraction(1, 3)), power(number(3), Fraction(1, 3))))
    assert spoken(presentation(roots)) == "213⋅313"


def test_an_index_is_a_subscript() -> None:
    assert presentation(q1) == "<msub><mi>q</mi><mn>1</mn></msub>"
    assert presentation(Parameter("L_x")) == "<msub><mi>L</mi><mi>x</mi></msub>"
    half = multiply((number("1/2"), Parameter("alpha")))
    assert presentation(half).endswith("<mfrac><mn>1</mn><mn>2</mn></mfrac><mo>\u2062</mo><mi>α</mi></mrow>")


@pytest.mark.parametrize("notation", list(Notation))
def test_a_matrix_is_one_math_element_with_presentation_and_content(notation: Notation) -> None:
    written = matrix_of(closed_form(puma(Convention.STANDARD)).transform, notation)
    root = ET.fromstring(written)
    assert root.tag == f"{NAMESPACE}math"
    assert root.get("display") == "block"
    assert len(root.findall(f".//{NAMESPACE}mtr")) == 4
    assert len(root.findall(f".//{NAMESPACE}mtd")) == 16
    annotation = root.find(f".//{NAMESPACE}annotation-xml")
    assert annotation is not None
    assert annotation.get("encoding") == "MathML-Content"
    assert len(annotation.findall(f".//{NAMESPACE}matrixrow")) == 4
    assert not any("-" in (text or "") for text in root.itertext())


@pytest.mark.parametrize("seed", range(60))
def test_content_means_the_expression(seed: int) -> None:
    """Read by a reader of its own, the content markup is the same function, in short notation too."""
    expression = random_expression(random.Random(seed), 2)
    root = ET.fromstring(matrix_of([[expression]], Notation.SHORT))
    row = root.find(f".//{NAMESPACE}matrixrow")
    assert row is not None
    assert same_function(meant(row[0]), expression)


def test_every_construct_has_content() -> None:
    x = Parameter("x")
    for expression in (
        power(x, 3),
        power(x, Fraction(-1, 2)),
        call(Function.ATAN2, x, number("-0.25")),
        call(Function.ABS, x),
        call(Function.ASIN, x),
        call(Function.SQRT, add((x, number("1/3")))),
        multiply((number(-2), x)),
        multiply((number("-1.3e-33"), x)),
    ):
        root = ET.fromstring(matrix_of([[expression]], Notation.FULL))
        row = root.find(f".//{NAMESPACE}matrixrow")
        assert row is not None
        assert same_function(meant(row[0]), expression)


@pytest.mark.parametrize("name", ["<script>", "a&b", 'x"y', "]]>"])
def test_no_name_can_break_out(name: str) -> None:
    written = matrix_of([[Parameter(name)]], Notation.FULL)
    assert name in "".join(ET.fromstring(written).itertext())
    assert "<script>" not in written


def meant(element: ET.Element) -> Expression:
    """Content markup as an expression."""
    tag = element.tag.removeprefix(NAMESPACE)
    if tag == "pi":
        return Pi()
    if tag == "ci":
        name = element.text or ""
        return JointVariable(int(name[1:])) if name[0] == "q" and name[1:].isdigit() else Parameter(name)
    if tag == "cn":
        if element.get("type") == "rational":
            return Number(Fraction(int(element.text or ""), int(element[0].tail or "")))
        if element.get("type") == "e-notation":
            return number(f"{element.text}e{element[0].tail}")
        return number(element.text or "")
    head, *operands = element
    values = [meant(operand) for operand in operands]
    match head.tag.removeprefix(NAMESPACE):
        case "plus":
            return add(values)
        case "minus":
            return negate(values[0])
        case "times":
            return multiply(values)
        case "power":
            assert isinstance(values[1], Number)
            return power(values[0], values[1].value)
        case "root":
            return call(Function.SQRT, values[0])
        case "csymbol":
            return call(Function(head.text or ""), *values)
        case name:
            return call(Function(name.replace("arc", "a")), *values)
