"""DH tables and poses as the wire writes them: cells that the grammar reads back to the very same entries."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, TypeAlias

from kinematics.cells import DEFAULT, AngleUnit, ParameterKind
from kinematics.cells.exact import snapped
from kinematics.expressions import Expression, pi_fraction, rational_value
from kinematics.printing.notation import Names
from kinematics.printing.numbers import decimal_text
from kinematics.printing.text import TextWriter
from kinematics.table import VARIABLE_CELLS, NumericRow, NumericTable, SymbolicRow, SymbolicTable
from service.schemas.tables import Measured, Table, units_of

WireCell: TypeAlias = int | float | str
WireTable: TypeAlias = dict[str, Any]
Spellings: TypeAlias = Mapping[tuple[ParameterKind, Expression], WireCell]

_HALF_TURN = 180
_ROUNDING = 1e-15  # What a few roundings leave of an angle between −π and π [rad].
_TOO_LONG = re.compile(rf"(?<![\w.])[\d.]{{{DEFAULT.digits + 2},}}(?:e-\d+)?")
"""A decimal in an expression that has more digits than a cell can hold, such as a sum of two doubles."""
CELL_KINDS = {
    "alpha": ParameterKind.ANGLE,
    "a": ParameterKind.LENGTH,
    "d": ParameterKind.LENGTH,
    "theta": ParameterKind.ANGLE,
}


@dataclass(frozen=True, kw_only=True, slots=True)
class TableWriter:
    """Writes tables in given units.

    Attributes:
        units: of angles and lengths that are written as numbers.
        spellings: how a person wrote a constant, to be kept where the same constant is written again.
        variable_cells: how a person wrote the cells with the joint variables, by joint number.
    """

    units: Measured
    spellings: Spellings = field(default_factory=dict)
    variable_cells: Mapping[int, WireCell] = field(default_factory=dict)

    def table(self, table: SymbolicTable | NumericTable) -> WireTable:
        """Return a table of exact entries, or of numbers."""
        numbers = {row: joint for joint, row in enumerate(table.joint_rows, 1)}
        given: Sequence[SymbolicRow | NumericRow] = table.rows
        rows = [self.row(row, numbers.get(i, 0)) for i, row in enumerate(given)]
        return {"convention": table.convention.value, **units_of(self.units), "rows": rows}

    def row(self, row: SymbolicRow | NumericRow, joint: int = 0) -> dict[str, WireCell]:
        """Return a row; `joint` is the number of its variable, if it has one."""
        cells: dict[str, WireCell] = {"joint": row.joint.value}
        for name, kind in CELL_KINDS.items():
            cells[name] = self.cell(getattr(row, name), kind)
        held = VARIABLE_CELLS.get(row.joint)
        if held is not None:
            cells[held] = self.variable_cells.get(joint, with_variable(row.sign, joint, cells[held]))
        return cells

    def cell(self, entry: Expression | float, kind: ParameterKind) -> WireCell:
        """Return an entry: a number where a number says it exactly, else an expression."""
        if isinstance(entry, int | float):
            return angle_in(self.units.angle_unit, entry) if kind is ParameterKind.ANGLE else _readable(entry)
        known = self.spellings.get((kind, entry))
        if known is not None:
            return known
        value = rational_value(entry)
        if kind is ParameterKind.ANGLE and self.units.angle_unit is AngleUnit.DEG:
            turns = pi_fraction(entry)
            if turns is not None:
                return _number(turns * _HALF_TURN)
            if value is not None:
                return readable_degrees(float(value))
        if value is not None:
            return _number(value)
        return cell_text(entry)


def table_in_units_of(asked: Measured, table: SymbolicTable) -> Table:
    """Return a table of exact entries as it goes out, in the units of what was asked about."""
    return Table.model_validate(TableWriter(units=asked).table(table), strict=False)


def angle_in(unit: AngleUnit, value: float) -> float:
    """Return an angle [rad] in a unit.

    What is a multiple of π/12, but for rounding, becomes a whole number of degrees.
    """
    if unit is AngleUnit.RAD:
        return _readable(value)
    turns = pi_fraction(snapped(Fraction(repr(value))))
    return float(turns * _HALF_TURN) if turns is not None else _readable(readable_degrees(value))


def readable_degrees(angle: float) -> float:
    """Return an angle [rad] in degrees: to eleven decimals where that is the angle but for rounding."""
    short = round(math.degrees(angle), 11)
    return (
        short if abs(math.radians(short) - angle) <= _ROUNDING * max(1.0, abs(angle)) else math.degrees(angle)
    )


def _readable(value: float) -> float:
    """The value as a cell can hold it: what is smaller than the smallest number of a cell is rounding."""
    return value if abs(value) >= DEFAULT.smallest else 0.0


def _number(value: Fraction) -> WireCell:
    """The value as a JSON number where that is exact, else as text; rounded where no cell can hold it."""
    if value.denominator == 1 and abs(value.numerator) < 2**53:
        return value.numerator
    number = float(value)
    if math.isfinite(number) and Fraction(repr(number)) == value:
        return number
    text = decimal_text(value)
    if text is None:
        return str(value) if max(abs(value.numerator), value.denominator) <= DEFAULT.largest else number
    return text if sum(character.isdigit() for character in text) <= DEFAULT.digits else number


def cell_text(entry: Expression) -> str:
    """Return an expression as a cell can hold it."""
    return _TOO_LONG.sub(lambda found: repr(float(found[0])), TextWriter(Names()).text(entry))


def with_variable(sign: int, joint: int, offset: WireCell) -> str:
    """Return a cell with a joint variable, which counts in the sense of its sign, and a constant."""
    variable = f"{'-' if sign < 0 else ''}q{joint}"
    if offset == 0:
        return variable
    text = str(offset)
    if isinstance(offset, str) and any(sign in text.lstrip("-") for sign in "+-"):
        return f"{variable} + ({text})"
    return f"{variable} - {text[1:]}" if text.startswith("-") else f"{variable} + {text}"
