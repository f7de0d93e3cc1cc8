"""Laws: what is read evaluates as written, prints to text that reads the same, and no text does harm."""

import math
from fractions import Fraction

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from kinematics.cells import AngleUnit, ParameterKind, RawRow, RawTable, read_cell, read_table
from kinematics.errors import CellError, ParameterError
from kinematics.expressions import (
    Call,
    Expression,
    JointVariable,
    Number,
    Parameter,
    Pi,
    Power,
    Product,
    Sum,
    evaluate,
)
from kinematics.table import Convention
from tests.conftest import EXPLORE

NAMES = {"L1": 0.7, "a2": 1.9, "beta": 0.4}
PYTHON = {
    **NAMES,
    "pi": math.pi,
    **{name: getattr(math, name) for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2")},
    "abs": abs,
}

atoms = st.one_of(
    st.integers(0, 20).map(str),
    st.decimals(0, 20, places=3).map(str),
    st.sampled_from([*NAMES, "pi"]),
)


def grown(inner):
    pair = st.tuples(inner, inner)
    return st.one_of(
        pair.flatmap(lambda ab: st.sampled_from("+-*/").map(lambda op: f"({ab[0]}){op}({ab[1]})")),
        pair.map(lambda ab: f"{ab[0]}+{ab[1]}"),
        pair.map(lambda ab: f"{ab[0]}-{ab[1]}"),
        pair.map(lambda ab: f"{ab[0]}*{ab[1]}"),
        inner.map(lambda a: f"-({a})"),
        inner.map(lambda a: f"({a})**2"),
        inner.map(lambda a: f"({a})**-1"),
        st.tuples(st.sampled_from(["sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "abs"]), inner).map(
            lambda fa: f"{fa[0]}({fa[1]})"
        ),
        pair.map(lambda ab: f"atan2({ab[0]},{ab[1]})"),
    )


# Trusted strings, made here: they alone are given to Python's own evaluator, as the oracle.
expressions = st.recursive(atoms, grown, max_leaves=8).filter(lambda text: len(text) <= 200)


def python_value(text: str) -> float | None:
    try:
        value = eval(text, {"__builtins__": {}}, dict(PYTHON))
    except (ValueError, ZeroDivisionError, OverflowError):
        return None
    return value if isinstance(value, int | float) and math.isfinite(value) else None


REFUSALS_OF_SOUND_TEXT = {
    "division_by_zero", "value_not_real", "number_out_of_range", "parameter_two_kinds", "cell_too_deep",
    "angle_product", "angle_in_denominator", "angle_power",
}  # fmt: skip


def value_or_refusal(text: str, kind=ParameterKind.LENGTH, unit=AngleUnit.RAD) -> float | str | None:
    """The value of a cell, the code of its refusal, or None where it has no value for these parameters."""
    try:
        expression = read_cell(text, kind, angle_unit=unit)
    except CellError as error:
        return error.code
    try:
        return evaluate(expression, NAMES, [0.0] * 10000)
    except ParameterError:
        return None


@settings(max_examples=1000 if EXPLORE else 150)
@given(text=expressions)
@example(text="(-((0)/(sin(pi))))**2")  # for Python sin(pi) is no zero
def test_a_cell_means_what_python_means_by_it(text):
    expected = python_value(text)
    found = value_or_refusal(text)
    if isinstance(found, str):
        assert found in REFUSALS_OF_SOUND_TEXT
        undefined = found in {"division_by_zero", "value_not_real"}
        finite = expected is not None and 1e-9 < abs(expected) < 1e9  # else 1/0, or 1/(1/0), up to rounding
        assert not undefined or not finite or _near_singular(text)
    elif found is None:
        assert expected is None or _near_singular(text)
    elif expected is not None and not _near_singular(text):
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-9)


def _near_singular(text: str) -> bool:
    """Whether rounding alone decides about Python's value."""
    values = []
    for shift in (-1e-9, 1e-9):
        PYTHON.update({name: value + shift for name, value in NAMES.items()}, pi=math.pi * (1 + shift))
        values.append(python_value(text))
    PYTHON.update(NAMES, pi=math.pi)
    a, b = values
    return a is None or b is None or abs(a - b) > 1e-6 * max(1.0, abs(a))


def printed(node: Expression) -> str:
    """An expression as a cell; nothing clever, so that it can be trusted."""
    match node:
        case Number(value):
            return f"({value})" if value.denominator == 1 else f"({value.numerator}/{value.denominator})"
        case Pi():
            return "pi"
        case Parameter(name):
            return name
        case JointVariable(index):
            return f"q{index}"
        case Sum(terms):
            return "(" + "+".join(printed(term) for term in terms) + ")"
        case Product(factors):
            return "*".join(printed(factor) for factor in factors)
        case Power(base, exponent):
            return f"({printed(base)})^({exponent})"
        case Call(function, arguments):
            return f"{function}({','.join(printed(argument) for argument in arguments)})"
    raise AssertionError(node)


@settings(max_examples=1000 if EXPLORE else 100)
@given(text=expressions, kind=st.sampled_from(list(ParameterKind)))
def test_what_is_printed_reads_the_same(text, kind):
    value = value_or_refusal(text, kind)
    if not isinstance(value, float):
        return
    again = printed(read_cell(text, kind))
    found = value_or_refusal(again, kind) if len(again) <= 200 else value
    if found not in {
        "number_out_of_range",
        "number_too_long",
    }:  # numerator and denominator of a fraction are larger than it is
        assert found == pytest.approx(value, rel=1e-9, abs=1e-12)


@settings(max_examples=2000 if EXPLORE else 300)
@given(text=st.text(max_size=60), unit=st.sampled_from(list(AngleUnit)))
def test_no_text_does_harm(text, unit):
    value_or_refusal(text, ParameterKind.ANGLE, unit)  # a refusal or a value; any other exception fails


LIKELY = st.text(alphabet="q1θ2+-*/^()πpi.,°√²₁_ L{}\\fracsn09e$", max_size=40)


@settings(max_examples=4000 if EXPLORE else 500)
@given(text=LIKELY, unit=st.sampled_from(list(AngleUnit)), kind=st.sampled_from(list(ParameterKind)))
def test_no_likely_text_does_harm(text, unit, kind):
    value_or_refusal(text, kind, unit)  # a refusal or a value; any other exception fails


@given(value=st.fractions(-1000, 1000, max_denominator=1000))
def test_degrees_are_exact(value):
    expression = read_cell(
        f"{value.numerator}/{value.denominator}", ParameterKind.ANGLE, angle_unit=AngleUnit.DEG
    )
    expected = value / 180
    found = Fraction(0) if expression == Number(Fraction(0)) else _turns(expression)
    assert found == expected


def _turns(expression: Expression) -> Fraction:
    from kinematics.expressions import pi_fraction

    turns = pi_fraction(expression)
    assert turns is not None
    return turns


@pytest.mark.parametrize("written", ["5e-324", "4.9E-324", "-4.94065645841246544e-324", "1e-320"])
def test_the_smallest_doubles_are_read_as_programs_write_them(written):
    value = float(written)
    assert evaluate(read_cell(written, ParameterKind.LENGTH)) == value
    for cell in (written, value):
        assert evaluate(read_cell(cell, ParameterKind.ANGLE)) == value
        in_degrees = evaluate(read_cell(cell, ParameterKind.ANGLE, angle_unit=AngleUnit.DEG))
        assert in_degrees == pytest.approx(math.radians(value), abs=5e-324)
    row = RawRow(theta=f"q1 + {written}".replace("+ -", "- "), d=0, a=0, alpha=0)
    offset = read_table(
        RawTable(convention=Convention.STANDARD, angle_unit=AngleUnit.DEG, rows=(row,))
    ).table.rows[0]
    assert evaluate(offset.theta) == pytest.approx(math.radians(value), abs=5e-324)


@given(value=st.floats(allow_nan=False, allow_infinity=False).filter(lambda x: abs(x) <= 1e15))
@example(value=-1.3e-33)
@example(value=5e-324)
@example(value=2.2250738585072011e-308)
def test_json_numbers_are_kept_to_the_last_digit(value):
    assert evaluate(read_cell(value, ParameterKind.LENGTH)) == value
    assert evaluate(read_cell(repr(value), ParameterKind.LENGTH)) == value
    assert evaluate(read_cell(value, ParameterKind.ANGLE)) == pytest.approx(value, rel=1e-15)
