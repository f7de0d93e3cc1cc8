"""The cells of a DH table: what may stand in one, and what it means.

A table is handed in as text and numbers (`RawTable`), read into exact entries (`read_table`) and given
numbers (`bind_parameters`). No text ever reaches an interpreter of Python.

tables           a table as it is handed in, and as it is read
table_reader     from the one to the other
rows, joints     a row, and which joint it holds
entries          one cell
From the text of a cell to an expression:
  wrapping, characters, unit_words  what comes with pasted text
  scanner, scanned_names  tokens
  variable_marks, bare_arguments  joint variables and functions as they are printed
  grammar, syntax  the tree of a cell
  meaning        the exact expression in radians
variables        which names are joint variables
exact, substitution  exact values of sines and angles, also in the place of parameters
units, scaling   units of a table, and a cell in another one
limits           how large cells and tables may be
refusals         why one is refused
suggestions      what somebody may have meant
binding          from a read table to numbers
"""

from kinematics.cells.binding import bind_parameters, in_length_unit, parameter_values, parameters_in_radians
from kinematics.cells.entries import read_cell
from kinematics.cells.limits import DEFAULT, Limits
from kinematics.cells.scanner import canonical_name
from kinematics.cells.suggestions import nearest_name, rate_in_marks
from kinematics.cells.table_reader import read_table
from kinematics.cells.tables import Cell, RawRow, RawTable, ReadTable
from kinematics.cells.units import AngleUnit, LengthUnit, ParameterKind
