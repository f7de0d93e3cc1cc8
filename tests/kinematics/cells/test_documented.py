"""The examples of docs/cells.md."""

import re
from pathlib import Path

import pytest

from kinematics.cells import AngleUnit, Limits, ParameterKind, read_cell
from kinematics.errors import CellError
from tests.kinematics.cells.tables import raw_row, read

PAGE = (Path(__file__).parents[3] / "docs" / "cells.md").read_text(encoding="utf-8")


def rows_after(comment: str) -> list[tuple[str, str]]:
    table = PAGE[PAGE.index(f"<!-- {comment} -->") :].split("\n\n")[1]
    return re.findall(r"^\| `(.+)` \| `(.+)` \|$", table, re.MULTILINE)


SAME = rows_after("the same value, in a table in radians")
DEGREES = rows_after("in a table in degrees, and what it is in radians")
VARIABLES = rows_after("joint variables, in the first row of a table")
REFUSED = rows_after("refused")


def test_the_page_has_examples():
    assert len(SAME) > 15
    assert len(DEGREES) > 5
    assert len(VARIABLES) > 5
    assert len(REFUSED) > 10


@pytest.mark.parametrize(("written", "understood"), SAME)
def test_pasted(written, understood):
    kind = ParameterKind.LENGTH if "L" in understood or "sqrt" in understood else ParameterKind.ANGLE
    assert read_cell(written, kind) == read_cell(understood, kind)


@pytest.mark.parametrize(("degrees", "radians"), DEGREES)
def test_degrees(degrees, radians):
    found = read_cell(degrees, ParameterKind.ANGLE, angle_unit=AngleUnit.DEG)
    assert found == read_cell(radians, ParameterKind.ANGLE)


@pytest.mark.parametrize(("cell", "code"), REFUSED)
def test_refused(cell, code):
    with pytest.raises(CellError) as caught:
        read_cell(cell, ParameterKind.LENGTH)
    assert caught.value.code == code


def test_the_bounds_are_those_of_the_code():
    limits = Limits()
    for value in (
        f"{limits.cell_characters} characters and {limits.cell_depth} levels a cell",
        f"{limits.table_characters} characters and {limits.rows} rows a table",
        f"{limits.cell_symbols}\nnames a cell, {limits.table_parameters} parameters a table",
        f"exponents up to {limits.exponent}, numbers of up to {limits.digits} digits",
        f"between {limits.smallest!r} and 1e15",
    ):
        assert value in PAGE
    assert limits.largest == 1e15


@pytest.mark.parametrize(("written", "same"), VARIABLES)
def test_marked_variables_are_variables(written, same):
    assert read(raw_row(theta=written)).table == read(raw_row(theta=same)).table
