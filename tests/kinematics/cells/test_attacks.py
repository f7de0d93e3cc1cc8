"""What is thrown at a cell, and what each gets: a refusal with its code and column, or a harmless meaning.

None of it may take long: a cell longer than the limit is refused before it is looked at, and nothing recurses
or computes with large numbers.
"""

import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from kinematics.cells import Limits, ParameterKind, RawRow, read_cell
from kinematics.errors import CellError, KinematicsError
from tests.kinematics.cells.tables import faults_of, raw_row, read

REFUSED = [
    # code that some other reader would run
    ("__import__('os').system('id')", "character_not_allowed", 12),
    ("__class__", "name_malformed", 1),
    ("q1.__class__", "number_malformed", 3),
    ("L1.real", "number_malformed", 3),
    ("().__class__.__bases__[0]", "character_not_allowed", 23),
    ("lambda: 0", "character_not_allowed", 7),
    ("lambda x: x", "character_not_allowed", 9),
    ("[x for x in (1,2)]", "character_not_allowed", 1),
    ("{1: 2}", "character_not_allowed", 3),
    ("a if b else c;", "character_not_allowed", 14),
    ("x = 1", "character_not_allowed", 3),
    ("x := 1", "character_not_allowed", 4),
    ("eval(1)", "function_unknown", 1),
    ("open(x)", "function_unknown", 1),
    ("Function(x)", "function_unknown", 1),
    ("'a' + 'b'", "character_not_allowed", 1),
    ('"text', "character_not_allowed", 1),
    ('""', "character_not_allowed", 1),
    ("f'{1}'", "character_not_allowed", 2),
    ("`id` `ls`", "character_not_allowed", 1),
    ("os.system(1)", "number_malformed", 3),
    ("a.np.pi", "number_malformed", 2),
    ("10^401", "exponent_out_of_range", 4),
    ("10^-400", "number_out_of_range", 1),
    ("$(id)", "dollar_misplaced", 1),
    ("${IFS}", "dollar_misplaced", 1),
    ("a|b", "character_not_allowed", 2),
    ("a & b", "character_not_allowed", 3),
    ("a < b", "character_not_allowed", 3),
    ("a % b", "character_not_allowed", 3),
    ("a // b", "value_missing", 4),
    ("5!", "character_not_allowed", 2),
    ("<script>", "character_not_allowed", 1),
    ("@x", "character_not_allowed", 1),
    ("#", "character_not_allowed", 1),
    ("\\input{x}", "command_unknown", 1),
    ("\\write18{x}", "command_unknown", 1),
    ("\\", "command_unknown", 1),
    # numbers that cost memory or time elsewhere
    ("9**9**9**9", "exponent_out_of_range", 7),
    ("9^9^9^9", "exponent_out_of_range", 5),
    ("2^99999", "exponent_out_of_range", 3),
    ("2^(1/99999)", "exponent_out_of_range", 3),
    ("10^16", "number_out_of_range", 1),
    ("((10^9)^9)^9", "number_out_of_range", 2),
    ("1e999999", "number_out_of_range", 1),
    ("1e-999999", "number_out_of_range", 1),
    ("2e99999999999999999999999999999", "number_out_of_range", 1),
    ("1e16", "number_out_of_range", 1),
    ("1e-330", "number_out_of_range", 1),
    ("1e15*10+L1", "number_out_of_range", 1),
    ("1" * 33, "number_too_long", 1),
    ("0." + "3" * 40, "number_too_long", 1),
    ("q1" + "²" * 40, "number_too_long", 3),
    ("1/0", "division_by_zero", 2),
    ("0^-1", "division_by_zero", 1),
    ("1/(2-2)", "division_by_zero", 2),
    ("L1/(L1-L1)", "division_by_zero", 3),
    ("tan(pi/2)", "division_by_zero", 1),
    ("sqrt(-1)", "value_not_real", None),
    ("asin(2)", "value_not_real", None),
    ("acos(1.0000000000001)", "value_not_real", None),
    ("(-8)^(1/3)", "value_not_real", None),
    # size
    ("1" * 1_000_000, "cell_too_long", None),
    ("(" * 100_000 + "1" + ")" * 100_000, "cell_too_long", None),
    ("x" * 201, "cell_too_long", None),
    ("x" * 200, "name_too_long", 1),
    ("(" * 99 + "1" + ")" * 99, "cell_too_deep", 1),
    ("-" * 150 + "1", "cell_too_deep", 1),
    ("2^" * 90 + "1", "cell_too_deep", 1),
    ("sqrt(" * 33 + "1" + ")" * 33, "cell_too_deep", 1),
    ("+".join("abcdefghklmnoprst"), "cell_too_many_symbols", 1),
    # characters that are not what they look like
    ("１+1", "character_full_width", 1),
    ("L１", "character_full_width", 2),
    ("ｑ1", "character_full_width", 1),
    ("（1）", "character_full_width", 1),
    ("1\u200b0", "character_invisible", 2),
    ("q1\u200d", "character_invisible", 3),
    ("\ufeffq1", "character_invisible", 1),
    ("q1\u202e+1", "character_invisible", 3),
    ("\u200fq1", "character_invisible", 1),
    ("\u2066q1\u2069", "character_invisible", 1),
    ("q1\u0000", "character_invisible", 3),
    ("q\x071", "character_invisible", 2),
    ("\x1b[31m", "character_invisible", 1),
    ("q1\x7f", "character_invisible", 3),
    ("q1\u0301", "character_invisible", 3),
    ("1\u2028+1", "character_invisible", 2),
    ("\ud800", "character_invisible", 1),
    ("а1+1", "character_lookalike", 1),  # Cyrillic а
    ("L1+с2", "character_lookalike", 4),  # Cyrillic с
    ("ж", "character_not_allowed", 1),
    ("١", "character_not_allowed", 1),  # Arabic-Indic digit
    ("θ́1", "character_invisible", 2),
    ("ά1", "character_not_allowed", 1),  # an accented Greek letter is no name
    ("∑", "character_not_allowed", 1),
    ("∞", "character_not_allowed", 1),
    ("‰", "character_not_allowed", 1),
    ("😀", "character_not_allowed", 1),
    # numbers of other languages
    ("1_000", "number_malformed", 1),
    ("0x10", "number_malformed", 1),
    ("0b101", "number_malformed", 1),
    ("0o17", "number_malformed", 1),
    ("1.2.3", "number_malformed", 1),
    (".", "number_malformed", 1),
    ("1..2", "number_malformed", 1),
    ("0,5", "decimal_comma", 2),
    ("L1*0,5", "decimal_comma", 5),
    ("1,000.5", "number_malformed", 1),
    ("1 000", "number_after_value", 3),
    ("1j", None, None),
    ("nan", "name_is_not_a_number", 1),
    ("NaN", "name_is_not_a_number", 1),
    ("inf", "name_is_not_a_number", 1),
    ("-Infinity", "name_is_not_a_number", 2),
    ("None", None, None),
    # structure
    ("", "cell_empty", None),
    ("   ", "cell_empty", None),
    ("$ $", "cell_empty", None),
    ("()", "value_missing", 2),
    ("(1+)", "value_missing", 4),
    ("1+", "cell_incomplete", 3),
    ("-", "cell_dash", None),
    ("sqrt(", "cell_incomplete", 6),
    ("*2", "value_missing", 1),
    ("2*/3", "value_missing", 3),
    ("(1", "parenthesis_not_closed", 1),
    ("2*(1+(3)", "parenthesis_not_closed", 3),
    ("1)", "parenthesis_not_opened", 2),
    ("[1]", "character_not_allowed", 1),
    ("1, 2", "decimal_comma", 2),
    (",5", "decimal_comma", 1),
    ("-,5", "decimal_comma", 2),
    ("L1*(,25)", "decimal_comma", 5),
    ("0·5", "number_malformed", 1),
    ("L1 + 0⋅25", "number_malformed", 6),
    ("59°30'", "minutes_in_cell", 1),
    ("q1 - 12º 30′ 36″", "minutes_in_cell", 6),
    ("1°'", "character_not_allowed", 3),
    ("≈59.9", "about_in_cell", 1),
    ("~ L1/2", "about_in_cell", 1),
    ("~", "character_not_allowed", 1),
    ("2 ≈ 3", "character_not_allowed", 3),
    ("a, b", "comma_misplaced", 2),
    ("L1 2", "number_after_value", 4),
    ("(1)2", "number_after_value", 4),
    ("L1L2", "names_run_together", 1),
    ("L1x", "names_run_together", 1),
    ("pi2", "names_run_together", 1),
    ("π2", "names_run_together", 1),
    ("L₁2", "names_run_together", 1),
    ("L_", "name_malformed", 2),
    ("_x", "name_malformed", 1),
    ("a__b", "name_malformed", 2),
    ("₁", "script_misplaced", 1),
    ("⁻", "script_misplaced", 1),
    ("°", "symbol_misplaced", 1),
    ("2D-3", "exponent_ambiguous", 1),
    ("L1 + 1.5d-10", "exponent_ambiguous", 6),
    ("1/2L1", "division_ambiguous", 2),
    ("1/-2L1", "division_ambiguous", 2),
    ("foo(1)", "function_unknown", 1),
    ("2+L1(3)", "function_unknown", 3),
    ("ATAN2(1,2)", "function_unknown", 1),
    ("exp(1)", "function_unknown", 1),
    ("sin", "function_without_parentheses", 1),
    ("sin 30", "function_without_parentheses", 1),
    ("\\sin 2\\theta", "function_without_parentheses", 1),
    ("sin L1 L2", "function_without_parentheses", 1),
    ("sin L1/2", "function_without_parentheses", 1),
    ("sin L1^2", "function_without_parentheses", 1),
    ("sin^-1(L1)", "function_without_parentheses", 1),
    ("sin⁻¹(L1)", "function_without_parentheses", 1),
    ("2½", "number_after_value", 2),
    ("L1½", "number_after_value", 3),
    ("sin()", "value_missing", 5),
    ("sin(1,2)", "function_arity", 1),
    ("atan2(1)", "function_arity", 1),
    ("atan2(1,2,3)", "function_arity", 1),
    ("L1^L2", "exponent_not_constant", 4),
    ("L1^pi", "exponent_not_constant", 4),
    ("10mm", "unit_in_cell", 3),
    ("0.5 m", "unit_in_cell", 5),
    ("1.57rad", "unit_in_cell", 5),
    ("90°", "degree_in_length", 1),
]


@pytest.mark.parametrize(("text", "code", "column"), REFUSED, ids=lambda value: repr(value)[:40])
def test_refused_with_code_and_column(text, code, column):
    if code is None:
        assert read_cell(text, ParameterKind.LENGTH)  # names and products like any other
        return
    with pytest.raises(CellError) as caught:
        read_cell(text, ParameterKind.LENGTH)
    (fault,) = caught.value.faults
    assert fault.code == code
    assert fault.params.get("column") == column
    assert len(str(fault)) < 400  # what was sent is not sent back
    assert (code, ("rows", 1, "d")) in faults_of(raw_row(theta="q1"), raw_row(theta="q2", d=text))


@pytest.mark.parametrize(
    ("cell", "kind"),
    [
        (True, "true/false"),
        (False, "true/false"),
        (None, "null"),
        ([1], "list"),
        ({"a": 1}, "dict"),
        (1j, "complex"),
        (b"1", "bytes"),
        (object(), "object"),
    ],
    ids=lambda value: type(value).__name__,
)
def test_a_cell_of_another_type_is_refused(cell, kind):
    with pytest.raises(CellError) as caught:
        read(raw_row(a=cell))
    (fault,) = caught.value.faults
    assert (fault.code, fault.params["kind"]) == ("cell_not_a_value", kind)


@pytest.mark.parametrize("number", [np.float64(0.5), np.float32(0.5), np.int64(3), np.uint8(3)], ids=repr)
def test_numbers_of_numpy_are_numbers(number):
    assert read(raw_row(a=number)).table == read(raw_row(a=number.item())).table


@pytest.mark.parametrize("cell", [np.bool_(True), np.array([1.0]), Fraction(1, 3)], ids=repr)
def test_other_things_of_numpy_are_not(cell):
    assert faults_of(raw_row(a=cell)) == [("cell_not_a_value", ("rows", 0, "a"))]


@pytest.mark.parametrize("number", [float("nan"), float("inf"), -float("inf")])
def test_numbers_that_are_none_are_refused(number):
    assert faults_of(raw_row(a=number)) == [("cell_not_finite", ("rows", 0, "a"))]


@pytest.mark.parametrize("number", [1e16, -1e300, 10**400])
def test_numbers_out_of_range_are_refused(number):
    assert faults_of(raw_row(a=number)) == [("number_out_of_range", ("rows", 0, "a"))]


def test_true_is_not_one_even_after_one_was_read():
    assert read(raw_row(theta="q1", a=1))
    assert faults_of(raw_row(theta="q1", a=True)) == [("cell_not_a_value", ("rows", 0, "a"))]


def test_every_fault_of_a_table_is_reported_at_once():
    found = faults_of(
        raw_row(theta="q1 +", a="0,5"), raw_row(theta="2*q2"), RawRow(alpha=None, a=[], d="q3", theta=0)
    )
    assert found == [
        ("decimal_comma", ("rows", 0, "a")),
        ("cell_incomplete", ("rows", 0, "theta")),
        ("variable_scaled", ("rows", 1, "theta")),
        ("cell_not_a_value", ("rows", 2, "alpha")),
        ("cell_not_a_value", ("rows", 2, "a")),
    ]


@pytest.mark.parametrize(
    ("limits", "text", "code", "limit"),
    [
        (Limits(cell_characters=5), "123456", "cell_too_long", 5),
        (Limits(cell_depth=2), "(((1)))", "cell_too_deep", 2),
        (Limits(cell_symbols=1), "a+b", "cell_too_many_symbols", 1),
        (Limits(exponent=2), "2^3", "exponent_out_of_range", 2),
        (Limits(digits=3), "1.234", "number_too_long", 3),
        (Limits(largest=100), "101", "number_out_of_range", 100),
    ],
)
def test_every_limit_is_a_setting_and_is_named(limits, text, code, limit):
    with pytest.raises(CellError) as caught:
        read_cell(text, ParameterKind.LENGTH, limits=limits)
    (fault,) = caught.value.faults
    assert fault.code == code
    assert limit in fault.params.values()
    assert str(limit) in str(fault)


@pytest.mark.parametrize(
    ("smallest", "refused", "admitted"),
    [
        (0.5, "0.49999999", "0.5"),
        (0.001, "0.00099999", "0.001"),  # the double of 0.001 is a little larger
        (5e-324, "1e-324", "4.9E-324"),
        (2.0, "1", "2"),
    ],
)
def test_a_number_is_read_from_the_smallest_on(smallest: float, refused: str, admitted: str) -> None:
    """It was read from half the size on."""
    limits = Limits(smallest=smallest)
    assert read_cell(admitted, ParameterKind.LENGTH, limits=limits)
    with pytest.raises(CellError) as caught:
        read_cell(refused, ParameterKind.LENGTH, limits=limits)
    assert caught.value.code == "number_out_of_range"
    assert caught.value.faults[0].params["size"] == "small"


def test_a_longer_limit_lifts_the_bound_without_recursion():
    generous = Limits(cell_characters=10**6, cell_depth=32)
    with pytest.raises(CellError) as caught:
        read_cell("(" * 50_000 + "1" + ")" * 50_000, ParameterKind.LENGTH, limits=generous)
    assert caught.value.code == "cell_too_deep"


def test_rows_are_bounded():
    assert faults_of() == [("table_empty", ("rows",))]
    assert faults_of(*[raw_row()] * 65) == [("table_too_many_rows", ("rows",))]
    assert read(*[raw_row()] * 64)


def test_text_of_a_table_is_bounded():
    """So that reading takes some tens of milliseconds at worst, whatever the cells hold."""
    long = "+".join(["sin(pi/7)"] * 19)
    assert faults_of(*[raw_row(a=long)] * 44) == [("table_too_long", ("rows",))]
    assert read(*[raw_row(a=long)] * 43)


def test_exact_numbers_do_not_grow_without_bound():
    assert faults_of(raw_row(a="*".join(["(1.0000001^16)^16"] * 3))) == [
        ("number_too_long", ("rows", 0, "a"))
    ]


def test_parameters_of_a_table_are_bounded():
    rows = [raw_row(a=f"a{i}", d=f"e{i}") for i in range(1, 34)]
    assert faults_of(*rows) == [("table_too_many_parameters", ("rows",))]


def test_every_code_is_met_by_some_test_here_or_beside():
    """Codes that no input reaches would be dead letters: each is named in a test of this folder."""
    root = Path(__file__).parents[3]
    sentences = (root / "service/locales/en/cells.ftl").read_text(encoding="utf-8")
    codes = set(re.findall(r"^error-(\w+) =", sentences, re.MULTILINE))
    texts = "".join(path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("test_*.py"))
    assert len(codes) > 60
    assert [code for code in sorted(codes) if f'"{code}"' not in texts] == []


def test_the_root_error_catches_all():
    with pytest.raises(KinematicsError):
        read_cell("1+", ParameterKind.ANGLE)
