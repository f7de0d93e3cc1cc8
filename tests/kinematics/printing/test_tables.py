"""Tables as notebooks show them."""

import xml.etree.ElementTree as ET

import pytest

from kinematics.catalogue import robots
from kinematics.cells import RawRow, RawTable, bind_parameters, read_table
from kinematics.table import Convention


@pytest.mark.parametrize("robot", robots(), ids=lambda robot: robot.id)
def test_every_catalogue_table_is_sound_html(robot: object) -> None:
    read = robot.table  # type: ignore[attr-defined]
    for table in (read, read.table, bind_parameters(read, robot.parameters)):  # type: ignore[attr-defined]
        root = ET.fromstring(table._repr_html_())
        assert [len(row) for row in root.iter("tr")] == [5] * (len(read.table.rows) + 1)
        assert table._repr_latex_().count("&") == 4 * (len(read.table.rows) + 1)


def test_columns_stand_in_the_order_of_the_motions_and_variables_as_typed() -> None:
    rows = (RawRow(theta="θ1 + pi/2", d="L1", a=0, alpha="pi/2"), RawRow(theta=0, d="-d2", a=0, alpha=0))
    standard = read_table(RawTable(convention=Convention.STANDARD, rows=rows))
    assert standard._repr_latex_().splitlines()[2:5] == [
        r"i & \theta_{i} & d_{i} & a_{i} & \alpha_{i} \\ \hline",
        r"1 & \theta_{1}+\frac{\pi}{2} & L_{1} & 0 & \frac{\pi}{2} \\",
        r"2 & 0 & -d_{2} & 0 & 0",
    ]
    modified = read_table(RawTable(convention=Convention.MODIFIED, rows=rows))
    assert r"i & \alpha_{i-1} & a_{i-1} & d_{i} & \theta_{i}" in modified._repr_latex_()


def test_numbers_are_short_and_offsets_keep_their_sign() -> None:
    rows = (RawRow(theta="q1 - 0.123456789", d=0.1, a=0, alpha=0), RawRow(theta="2 - q2", d=0, a=1, alpha=0))
    numeric = bind_parameters(read_table(RawTable(convention=Convention.STANDARD, rows=rows)), {})
    assert r"1 & q_{1}-0.123457 & 0.1" in numeric._repr_latex_()
    assert r"2 & -q_{2}+2 & 0" in numeric._repr_latex_()


def test_a_table_without_rows_still_has_a_head() -> None:
    read = read_table(RawTable(convention=Convention.STANDARD, rows=(RawRow(theta=0, d=0, a=0, alpha=0),)))
    empty = type(read.table)(convention=Convention.STANDARD, rows=())
    assert "array" in empty._repr_latex_()
    assert "<tbody></tbody>" in empty._repr_html_()
