"""Short ways to write tables for the tests of the cell grammar."""

from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable, ReadTable, read_table
from kinematics.errors import KinematicsError
from kinematics.table import Convention, JointType

REVOLUTE, PRISMATIC, FIXED = JointType.REVOLUTE, JointType.PRISMATIC, JointType.FIXED


def raw_row(theta=0, d=0, a=0, alpha=0, joint=None) -> RawRow:
    return RawRow(theta=theta, d=d, a=a, alpha=alpha, joint=joint)


def raw_table(
    *rows: RawRow, angle_unit=AngleUnit.RAD, length_unit=LengthUnit.M, convention=Convention.STANDARD
) -> RawTable:
    return RawTable(convention=convention, rows=rows, angle_unit=angle_unit, length_unit=length_unit)


def read(*rows: RawRow, **options) -> ReadTable:
    return read_table(raw_table(*rows, **options))


def faults_of(*rows: RawRow, **options) -> list[tuple[str, tuple[str | int, ...]]]:
    """Code and place of everything that is wrong with a table."""
    try:
        read(*rows, **options)
    except KinematicsError as error:
        return [(fault.code, fault.where) for fault in error.faults]
    return []
