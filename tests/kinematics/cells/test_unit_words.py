"""Units behind a value: told, in the languages of the pages, with the cell as it is without them."""

import pytest

from kinematics.cells import ParameterKind, read_cell
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.scanner import scan
from kinematics.errors import CellError
from tests.kinematics.cells.tables import faults_of, raw_row


@pytest.mark.parametrize(
    "cell",
    [
        "90 grados",
        "90 degrees",
        "90 degrés",
        "90 graus",
        "90 grade",
        "90 градусів",
        "1.5 rad",
        "12mm",
        "0.3 metros",
        "3 mètres",
        "12 мм",
        "2.5e-1 m",
        "90\u00a0Grados",
        "q1 + 90 grados",
        "q1 rad",
        "θ₁ grados",
        "π rad",
        "pi radianes",
        "90 de grade",
        "1.5 Rad",
        "12 MM",
        "0.4 метра",
        "90 градусов",
        "1.5 радиана",
        "0.4 метров",
        "40 миллиметров",
    ],
)
def test_units_in_seven_languages_are_told(cell):
    assert faults_of(raw_row(theta=cell)) == [("unit_in_cell", ("rows", 0, "theta"))]


@pytest.mark.parametrize("unit", ["градусів", "градусов", "міліметрів"])
def test_a_unit_in_cyrillic_letters_is_told_while_it_is_typed(unit):
    for end in range(1, len(unit) + 1):
        assert faults_of(raw_row(theta=f"90 {unit[:end]}")) == [("unit_in_cell", ("rows", 0, "theta"))]


@pytest.mark.parametrize("word", ["р", "ра", "с"])
def test_letters_that_look_like_latin_ones_are_no_half_typed_unit(word):
    assert faults_of(raw_row(theta=f"2 {word}")) == [("character_lookalike", ("rows", 0, "theta"))]


@pytest.mark.parametrize("cell", ["90 deg", "90 Deg", "90DEG", "π/2"])
def test_the_degree_sign_may_be_a_word(cell):
    assert read_cell(cell, ParameterKind.ANGLE) == read_cell("90°", ParameterKind.ANGLE)


@pytest.mark.parametrize(
    ("cell", "rest"),
    [
        ("90 grados", "90"),
        ("pi/2 rad", "pi/2"),
        ("90 град.", "90"),
        ("12 мм. + 3 mm.", "12 + 3"),
        ("90 deg.", "90"),
        ("q1 - 90Deg.", "q1 - 90"),
        ("45 deg. + 45°", "45 + 45°"),
        ("0.3 m + 0.2 m", "0.3 + 0.2"),
        ("q1 + 90 grados", "q1 + 90"),
        ("90 de grade", "90"),
        ("π rad / 2", "π / 2"),
        ("2π rad", "2π"),
        ("п рад", "п"),
        ("q1 + 2пі рад", "q1 + 2пі"),
        ("0,4 m", "0.4"),
        ("q1 + 1,57 rad", "q1 + 1.57"),
        ("1,000.5 mm", "1,000.5"),
    ],
)
def test_a_unit_is_told_with_the_cell_without_it(cell, rest):
    with pytest.raises(CellRefusal, match="unit_in_cell") as refused:
        scan(cell)
    assert refused.value.params["suggestion"] == rest


@pytest.mark.parametrize("cell", ["2 m1", "L12 m", "L_1 m", "2 M", "2 cm(1)"])
def test_names_that_are_no_units_are_left_alone(cell):
    assert ("unit_in_cell", ("rows", 0, "a")) not in faults_of(raw_row(a=cell))


def test_the_column_of_a_unit_is_where_it_begins():
    with pytest.raises(Exception, match="unit_in_cell") as refused:
        scan("q1 + 90 grados")
    assert refused.value.params["column"] == 9


@pytest.mark.parametrize(("cell", "rest"), [("q1 (rad)", "q1"), ("90 [deg] + q1", "90 + q1")])
def test_a_unit_in_brackets_is_told_as_one(cell, rest):
    with pytest.raises(CellError) as caught:
        read_cell(cell, ParameterKind.ANGLE)
    (fault,) = caught.value.faults
    assert (fault.code, fault.params["suggestion"]) == ("unit_in_cell", rest)
