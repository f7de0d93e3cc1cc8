"""From a DH table as handed in to exact entries."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from types import MappingProxyType

from kinematics.cells.exact import snapped
from kinematics.cells.grammar import parse
from kinematics.cells.joints import VARIABLE_CELLS, RowJoint, Syntax, row_joints
from kinematics.cells.limits import DEFAULT, Limits
from kinematics.cells.meaning import Meaning, Position, VariableOf, interpret
from kinematics.cells.refusals import Refusal, fault
from kinematics.cells.syntax import Node
from kinematics.cells.tables import Cell, NoCell, RawRow, RawTable, ReadTable, as_cell
from kinematics.cells.units import AngleUnit, ParameterKind
from kinematics.cells.variables import Use, refuse_numberless, uses, variable_index
from kinematics.errors import CellError, Fault, ParamValue, TableError
from kinematics.expressions import ZERO, Expression, JointVariable, Number, pi_times
from kinematics.table import CELLS, DHRow, DHTable, JointType, SymbolicRow

POSITIONS = {"alpha": Position.ANGLE, "a": Position.LENGTH, "d": Position.LENGTH, "theta": Position.ANGLE}

_PLAIN_NUMBER = re.compile(r"\s*([+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,2})?)\s*", re.ASCII)


def read_table(raw: RawTable, limits: Limits = DEFAULT) -> ReadTable:
    """The exact table that a table as handed in means.

    Args:
        raw: the table, cells as numbers or text.
        limits: how large it may be.

    Raises:
        CellError: cells cannot be read, each fault at ("rows", i, cell); table faults are among them.
        TableError: every cell can be read, but the rows do not form a DH table.
    """
    return _read_by_default(raw) if limits is DEFAULT else _read(raw, limits)


def read_cell(
    cell: Cell,
    kind: ParameterKind,
    *,
    angle_unit: AngleUnit = AngleUnit.RAD,
    limits: Limits = DEFAULT,
    variable: Callable[[str], int | None] = variable_index,
) -> Expression:
    """The exact expression that one cell means.

    Args:
        cell: a number or text.
        kind: whether a length or an angle stands in it.
        angle_unit: unit of plain numbers where an angle stands.
        limits: how large it may be.
        variable: the number of the joint variable that a canonical name is, or None.

    Returns:
        The expression; an angle in [rad], a length in the unit of the cell. How joint variables enter is not
        checked: that is a question of the row.

    Raises:
        CellError: the cell cannot be read.
    """

    def variable_of(name: str) -> Expression | None:
        index = variable(name)
        return None if index is None else JointVariable(index)

    try:
        return cell_meaning(cell, Position(kind.value), angle_unit, limits, variable_of).expression
    except Refusal as refusal:
        raise CellError(refusal.at()) from None


def cell_meaning(
    cell: Cell | NoCell, position: Position, angle_unit: AngleUnit, limits: Limits, variable_of: VariableOf
) -> Meaning:
    """What a cell means, and the kinds of its parameters.

    Raises:
        Refusal: the cell cannot be read.
    """
    node = cell_syntax(cell, limits)
    if isinstance(node, Fraction):
        return _number_meaning(node, position, angle_unit)
    return interpret(node, position, angle_unit, limits, variable_of)


def cell_syntax(cell: Cell | NoCell, limits: Limits) -> Node | Fraction:
    """The syntax tree of a cell, or the value of one that is a plain number.

    Raises:
        Refusal: the cell cannot be read.
    """
    value = as_cell(cell) if not isinstance(cell, NoCell) else cell
    if isinstance(value, NoCell):
        raise Refusal("cell_not_a_value", kind=value.kind)
    if isinstance(value, str):
        short = len(value) <= min(limits.digits, limits.cell_characters)
        plain = _PLAIN_NUMBER.fullmatch(value) if short else None
        return _sized(Fraction(plain.group(1)), limits) if plain else parse(value, limits)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise Refusal("cell_not_finite")
        return _sized(Fraction(repr(value)), limits)
    return _sized(Fraction(value), limits)


def text_length(cells: Iterable[object], limits: Limits) -> int:
    """The characters of all cells that are text; those that are too long by themselves are not counted."""
    lengths = (len(cell) for cell in cells if isinstance(cell, str))
    return sum(length for length in lengths if length <= limits.cell_characters)


def _sized(value: Fraction, limits: Limits) -> Fraction:
    if not limits.admits(value):
        raise Refusal("number_out_of_range", column=1, smallest=limits.smallest, largest=limits.largest)
    return value


def _number_meaning(value: Fraction, position: Position, angle_unit: AngleUnit) -> Meaning:
    expression: Expression = Number(value)
    if position is Position.ANGLE:
        expression = pi_times(value / 180) if angle_unit is AngleUnit.DEG else snapped(value)
    return Meaning(expression=expression, kinds={})


@lru_cache(maxsize=4096)
def _read_by_default(raw: RawTable) -> ReadTable:
    return _read_anew(raw, DEFAULT)


@lru_cache(maxsize=4096)
def _read(raw: RawTable, limits: Limits) -> ReadTable:
    return _read_anew(raw, limits)


def _read_anew(raw: RawTable, limits: Limits) -> ReadTable:
    _refuse_size(raw, limits)
    reader = _TableReader(raw=raw, limits=limits, faults={}, kinds={})
    rows = reader.rows()
    if reader.faults:
        ordered = sorted(reader.faults.values(), key=_reading_order)
        table_codes = all(found.code.startswith(("variable_", "table_")) for found in ordered)
        raise (TableError if table_codes else CellError)(ordered)
    if len(reader.kinds) > limits.table_parameters:
        raise TableError(fault("table_too_many_parameters", "rows", limit=limits.table_parameters))
    return ReadTable(
        table=DHTable(convention=raw.convention, rows=rows),
        angle_unit=raw.angle_unit,
        length_unit=raw.length_unit,
        parameters=MappingProxyType(reader.kinds),
    )


def _refuse_size(raw: RawTable, limits: Limits) -> None:
    if not raw.rows:
        raise TableError(fault("table_empty", "rows"))
    if len(raw.rows) > limits.rows:
        raise TableError(fault("table_too_many_rows", "rows", rows=len(raw.rows), limit=limits.rows))
    length = text_length((getattr(row, cell) for row in raw.rows for cell in CELLS), limits)
    if length > limits.table_characters:
        raise TableError(fault("table_too_long", "rows", length=length, limit=limits.table_characters))


def _reading_order(found: Fault) -> tuple[int, int]:
    match found.where:
        case ("rows", int(row), str(cell)):
            return row, CELLS.index(cell)
    return -1, 0


@dataclass(slots=True)
class _TableReader:
    """Reads the cells of one table, keeping every fault with the place of its cell."""

    raw: RawTable
    limits: Limits
    faults: dict[tuple[int, str], Fault]
    kinds: dict[str, ParameterKind]

    def rows(self) -> tuple[SymbolicRow, ...]:
        syntax = [self._syntax(i, row) for i, row in enumerate(self.raw.rows)]
        joints, misnumbered = row_joints([row.joint for row in self.raw.rows], syntax)
        readable = not self.faults
        rows = tuple(
            self._row(i, row, joint, cells)
            for i, (row, joint, cells) in enumerate(zip(self.raw.rows, joints, syntax, strict=True))
        )
        if readable:  # an unreadable cell may be the very one that names the joint
            for found in misnumbered:
                self.faults.setdefault((int(found.where[1]), str(found.where[2])), found)
        return rows

    def _syntax(self, i: int, row: RawRow) -> Syntax:
        trees: dict[str, Node] = {}
        for cell in CELLS:
            try:
                node = cell_syntax(getattr(row, cell), self.limits)
                if not isinstance(node, Fraction):
                    refuse_numberless(node)
                    trees[cell] = node
            except Refusal as refusal:
                self.faults[i, cell] = refusal.at("rows", i, cell)
        return trees

    def _row(self, i: int, row: RawRow, joint: RowJoint, cells: Syntax) -> SymbolicRow:
        sign = 1
        entries: dict[str, Expression] = {}
        for cell in CELLS:
            entries[cell] = ZERO
            if (i, cell) in self.faults:
                continue
            try:
                sign *= self._sign(joint, cell, cells)
                entries[cell] = self._entry(row, joint, cell)
            except Refusal as refusal:
                self.faults[i, cell] = refusal.at("rows", i, cell)
        return DHRow(joint=joint.joint, sign=sign, **entries)

    def _sign(self, joint: RowJoint, cell: str, cells: Syntax) -> int:
        if cell not in cells:
            return 1
        found = list(uses(cells[cell], lambda name: joint.variable(name, cell) is not None))
        if not found:
            return 1
        first = found[0].name
        place: dict[str, ParamValue] = {"column": first.column, "name": first.name}
        if cell in {"alpha", "a"}:
            raise Refusal("variable_in_constant_cell", cell=cell, **place)
        if joint.joint is JointType.FIXED:
            raise Refusal("variable_in_fixed_row", **place)
        expected = VARIABLE_CELLS[joint.joint]
        if cell != expected:
            if not joint.stated and joint.variable(first.name, cell) == joint.number:
                raise Refusal("variable_twice", **place)
            raise Refusal(
                "variable_in_wrong_cell", cell=cell, joint=joint.joint.value, expected=expected, **place
            )
        return _sign_of(found, joint, cell)

    def _entry(self, row: RawRow, joint: RowJoint, cell: str) -> Expression:
        def offset_of(name: str) -> Expression | None:
            return None if joint.variable(name, cell) is None else ZERO

        meaning = cell_meaning(
            getattr(row, cell), POSITIONS[cell], self.raw.angle_unit, self.limits, offset_of
        )
        for name, kind in meaning.kinds.items():
            known = self.kinds.setdefault(name, kind)
            if known is not kind:
                raise Refusal("parameter_two_kinds", column=1, name=name, kind=kind, other=known)
        return meaning.expression


def _sign_of(found: list[Use], joint: RowJoint, cell: str) -> int:
    for use in found:
        if use.fault:
            place: dict[str, ParamValue] = {"column": use.name.column, "name": use.name.name}
            factor = {"factor": str(abs(use.weight))} if use.fault == "variable_scaled" else {}
            raise Refusal(use.fault, **place, **factor)
    numbers = [joint.variable(use.name.name, cell) for use in found]
    for use, number in list(zip(found, numbers, strict=True))[1:]:
        if numbers.count(number) > 1:
            raise Refusal("variable_twice", column=use.name.column, name=use.name.name)
    return 1 if found[0].weight > 0 else -1
