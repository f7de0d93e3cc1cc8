"""The cells of a DH table: what may stand in one, and what it means.

A table is handed in as text and numbers (`RawTable`), read into exact entries (`read_table`) and given
numbers (`bind_parameters`). No text ever reaches an interpreter of Python: the grammar is in `grammar`, its
meaning in `meaning`.
"""

from kinematics.cells.binding import bind_parameters, in_length_unit, parameter_values
from kinematics.cells.entries import read_cell
from kinematics.cells.limits import DEFAULT, Limits
from kinematics.cells.scanner import canonical_name
from kinematics.cells.suggestions import nearest_name
from kinematics.cells.table_reader import read_table
from kinematics.cells.tables import Cell, RawRow, RawTable, ReadTable
from kinematics.cells.units import AngleUnit, LengthUnit, ParameterKind

__all__ = [
    "DEFAULT",
    "AngleUnit",
    "Cell",
    "LengthUnit",
    "Limits",
    "ParameterKind",
    "RawRow",
    "RawTable",
    "ReadTable",
    "bind_parameters",
    "canonical_name",
    "in_length_unit",
    "nearest_name",
    "parameter_values",
    "read_cell",
    "read_table",
]
