"""Tables as handed in by a program."""

import pytest

from kinematics.cells import AngleUnit, LengthUnit, read_table
from kinematics.table import Convention, JointType
from tests.kinematics.cells.tables import raw_row, raw_table


def test_what_is_given_by_its_value_is_what_it_names():
    """A table of "standard" was read once for all equal ones, and grading them failed from then on."""
    rows = (raw_row(theta="q1", a="by_value"), raw_row(d="q2", joint="prismatic"))
    read = read_table(raw_table(*rows, convention="standard", angle_unit="deg", length_unit="mm"))
    again = read_table(
        raw_table(
            raw_row(theta="q1", a="by_value"),
            raw_row(d="q2", joint=JointType.PRISMATIC),
            convention=Convention.STANDARD,
            angle_unit=AngleUnit.DEG,
            length_unit=LengthUnit.MM,
        )
    )
    assert again is read
    assert read.table.convention is Convention.STANDARD
    assert read.angle_unit is AngleUnit.DEG
    assert read.length_unit is LengthUnit.MM
    assert [row.joint for row in read.table.rows] == [JointType.REVOLUTE, JointType.PRISMATIC]
    assert all(isinstance(row.joint, JointType) for row in read.table.rows)


@pytest.mark.parametrize("what", ["convention", "angle_unit", "length_unit"])
def test_a_value_that_names_nothing_is_refused(what):
    with pytest.raises(ValueError, match="craig"):
        raw_table(raw_row(theta="q1"), **{what: "craig"})
