"""From one cell to the exact expression that it means."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable
from fractions import Fraction

from kinematics.cells.exact import snapped
from kinematics.cells.grammar import parse
from kinematics.cells.limits import DEFAULT, Limits
from kinematics.cells.meaning import CellMeaning, Position, VariableOf, interpret
from kinematics.cells.refusals import CellRefusal, size_refusal
from kinematics.cells.syntax import Node
from kinematics.cells.tables import Cell, NoCell, as_cell
from kinematics.cells.units import AngleUnit, ParameterKind
from kinematics.cells.variables import variable_index
from kinematics.errors import CellError
from kinematics.expressions import Expression, JointVariable, Number, pi_times

_PLAIN_NUMBER = re.compile(r"\s*([+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,2})?)\s*", re.ASCII)


def read_cell(
    cell: Cell,
    kind: ParameterKind,
    *,
    angle_unit: AngleUnit = AngleUnit.RAD,
    limits: Limits = DEFAULT,
    variable: Callable[[str], int | None] = variable_index,
) -> Expression:
    """Return the exact expression that one cell means.

    Args:
        cell: a number or text.
        kind: whether a length or an angle stands in it.
        angle_unit: unit of plain numbers where an angle stands.
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
    except CellRefusal as refusal:
        raise CellError(refusal.at()) from None


def cell_meaning(
    cell: Cell | NoCell, position: Position, angle_unit: AngleUnit, limits: Limits, variable_of: VariableOf
) -> CellMeaning:
    """Return what a cell means, and the kinds of its parameters.

    Raises:
        CellRefusal: the cell cannot be read.
    """
    return entry_of(cell_syntax(cell, limits), position, angle_unit, limits, variable_of)


def entry_of(
    node: Node | Fraction, position: Position, angle_unit: AngleUnit, limits: Limits, variable_of: VariableOf
) -> CellMeaning:
    """Return what a cell means whose syntax tree, or plain number, is known.

    Raises:
        CellRefusal: the cell has no meaning here, or no finite value.
    """
    if not isinstance(node, Fraction):
        return interpret(node, position, angle_unit, limits, variable_of)
    expression: Expression = Number(node)
    if position is Position.ANGLE:
        expression = pi_times(node / 180) if angle_unit is AngleUnit.DEG else snapped(node)
    return CellMeaning(expression=expression, kinds={})


def plain_number(cell: Cell, position: Position, angle_unit: AngleUnit, limits: Limits) -> float | None:
    """Return the value of a cell that is a number and nothing else, an angle in [rad]; None of any other.

    Raises:
        CellRefusal: the cell cannot be read.
    """
    node = cell_syntax(cell, limits)
    if not isinstance(node, Fraction):
        return None
    value = node.numerator / node.denominator
    return math.radians(value) if position is Position.ANGLE and angle_unit is AngleUnit.DEG else value


def cell_syntax(cell: Cell | NoCell, limits: Limits) -> Node | Fraction:
    """Return the syntax tree of a cell, or the value of one that is a plain number.

    Raises:
        CellRefusal: the cell cannot be read.
    """
    value = as_cell(cell) if not isinstance(cell, NoCell) else cell
    if isinstance(value, NoCell):
        raise CellRefusal("cell_not_a_value", kind=value.kind)
    if isinstance(value, str):
        short = len(value) <= min(limits.digits, limits.cell_characters)
        plain = _PLAIN_NUMBER.fullmatch(value) if short else None
        return _sized(Fraction(plain.group(1)), limits) if plain else parse(value, limits)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise CellRefusal("cell_not_finite")
        return _sized(Fraction(repr(value)), limits)
    return _sized(Fraction(value), limits)


def text_length(cells: Iterable[object], limits: Limits) -> int:
    """Return the characters of all cells that are text.

    Those that are too long by themselves are not counted.
    """
    lengths = (len(cell) for cell in cells if isinstance(cell, str))
    return sum(length for length in lengths if length <= limits.cell_characters)


def _sized(value: Fraction, limits: Limits) -> Fraction:
    if not limits.admits(value):
        raise size_refusal(value, 1, limits)
    return value
