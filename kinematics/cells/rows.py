"""One row of a DH table: its cells read, its joint variable found.

Rows that were read before are cached: in a course most rows of most tables have been handed in by
somebody else.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

from kinematics.caching import cached_by_size
from kinematics.cells.entries import cell_syntax, entry_of
from kinematics.cells.joints import RowJoint
from kinematics.cells.limits import Limits
from kinematics.cells.meaning import Position
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.syntax import Node
from kinematics.cells.tables import RawRow
from kinematics.cells.units import AngleUnit, ParameterKind
from kinematics.cells.variable_marks import is_joint_variable
from kinematics.cells.variables import Use, refuse_misspelled, refuse_numberless, uses
from kinematics.errors import Fault, ParamValue
from kinematics.expressions import ZERO, Expression, evaluate, parameters_in
from kinematics.table import CELLS, VARIABLE_CELLS, DHRow, JointType, SymbolicRow

POSITIONS = {"alpha": Position.ANGLE, "a": Position.LENGTH, "d": Position.LENGTH, "theta": Position.ANGLE}
CACHED_ROWS = 4096  # Rows in the cache, as read: those of some 600 tables of six or seven joints.
_ONE_NUMBER = re.compile(r"[\s()+=−–-]*((?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)[\s()°]*")
_LARGEST_EXPONENT = 100
USUAL_ROW = 80  # Length of the cells of a row [character] up to which so many are cached.


@dataclass(frozen=True, kw_only=True, slots=True)
class RowSyntax:
    """The cells of a row before anything is known of its joint; each cell is in one of the three.

    Attributes:
        trees: the syntax trees of cells that are more than a number.
        numbers: the values of plain numbers.
        faults: why the others cannot be read; their place is the cell.
    """

    trees: Mapping[str, Node]
    numbers: Mapping[str, Fraction]
    faults: Mapping[str, Fault]


@dataclass(frozen=True, kw_only=True, slots=True)
class RowMeaning:
    """A row, understood.

    Attributes:
        row: its exact entries; 0 where a cell cannot be read.
        kinds: cell, name and kind of every parameter, in the order in which they stand.
        faults: why cells cannot be read; their place is the cell.
        last_places: units of the last place [rad or length] of cells that are one number with zeros at its
            end.
    """

    row: SymbolicRow
    kinds: tuple[tuple[str, str, ParameterKind], ...]
    faults: Mapping[str, Fault]
    last_places: Mapping[str, float]


def _length(row: RawRow) -> int:
    """The characters of a row's cells; a number counts as none."""
    return sum([len(cell) for cell in (row.alpha, row.a, row.d, row.theta) if isinstance(cell, str)])


@cached_by_size(lambda row, limits: _length(row), longest=USUAL_ROW, most=CACHED_ROWS, few=64)
def row_syntax(row: RawRow, limits: Limits) -> RowSyntax:
    """Return the cells of a row, before anything is known of its joint."""
    trees: dict[str, Node] = {}
    numbers: dict[str, Fraction] = {}
    faults: dict[str, Fault] = {}
    for cell in CELLS:
        try:
            node = cell_syntax(getattr(row, cell), limits)
            if isinstance(node, Fraction):
                numbers[cell] = node
            else:
                refuse_numberless(node)
                if cell == "theta":
                    refuse_misspelled(node)
                trees[cell] = node
        except CellRefusal as refusal:
            faults[cell] = _without_a_product(refusal).at()
    return RowSyntax(trees=trees, numbers=numbers, faults=faults)


def _without_a_product(refusal: CellRefusal) -> CellRefusal:
    """What is said where an offset may be meant and no product: θ1 (+90°)."""
    name = str(refusal.params.get("name"))
    if refusal.code == "function_unknown" and is_joint_variable(name):
        return CellRefusal("variable_called", column=refusal.column, name=name)
    return refusal


@cached_by_size(
    lambda row, joint, angle_unit, limits: _length(row), longest=USUAL_ROW, most=CACHED_ROWS, few=64
)
def row_meaning(row: RawRow, joint: RowJoint, angle_unit: AngleUnit, limits: Limits) -> RowMeaning:
    """Return the exact entries of a row whose joint is known."""
    syntax = row_syntax(row, limits)
    sign = 1
    entries: dict[str, Expression] = dict.fromkeys(CELLS, ZERO)
    kinds: list[tuple[str, str, ParameterKind]] = []
    faults = dict(syntax.faults)

    for cell in CELLS:
        if cell in faults:
            continue

        def offset_of(name: str, cell: str = cell) -> Expression | None:
            return None if joint.variable(name, cell) is None else ZERO

        node = syntax.numbers.get(cell) if cell in syntax.numbers else syntax.trees[cell]
        assert node is not None
        try:
            sign *= _sign(joint, cell, syntax.trees)
            meaning = entry_of(node, POSITIONS[cell], angle_unit, limits, offset_of)
        except CellRefusal as refusal:
            faults[cell] = refusal.at()
            continue
        entries[cell] = meaning.expression
        kinds.extend((cell, name, kind) for name, kind in meaning.kinds.items())
    meant: SymbolicRow = DHRow(joint=joint.joint, sign=sign, **entries)
    places = dict(_last_places(row, meant))
    return RowMeaning(row=meant, kinds=tuple(kinds), faults=faults, last_places=places)


def _last_places(typed: RawRow, row: SymbolicRow) -> Iterator[tuple[str, float]]:
    """Yield units of the last place [rad or length] of cells that are one number with zeros at its end."""
    for cell in CELLS:
        text = getattr(typed, cell)
        if not isinstance(text, str) or "0" not in text:
            continue
        entry = getattr(row, cell)
        if entry == ZERO or parameters_in(entry):
            continue
        match = _ONE_NUMBER.fullmatch(text)
        if match is None or not match[1].endswith("0"):
            continue
        number = Decimal(match[1])
        exponent = number.as_tuple().exponent
        if number and abs(number.adjusted()) < _LARGEST_EXPONENT and isinstance(exponent, int):
            yield cell, abs(evaluate(entry)) / float(number) * 10.0**exponent


def _sign(joint: RowJoint, cell: str, trees: Mapping[str, Node]) -> int:
    """The sign with which the joint variable stands in a cell; 1 where none does."""
    if cell not in trees:
        return 1
    found = list(uses(trees[cell], lambda name: joint.variable(name, cell) is not None))
    if not found:
        return 1
    first = found[0].name
    place: dict[str, ParamValue] = {"column": first.column, "name": first.name}
    if cell in {"alpha", "a"}:
        raise CellRefusal("variable_in_constant_cell", cell=cell, **place)
    if joint.joint is JointType.FIXED:
        raise CellRefusal("variable_in_fixed_row", **place)
    expected = VARIABLE_CELLS[joint.joint]
    if cell != expected:
        if not joint.stated and joint.variable(first.name, cell) == joint.number and _moves(joint, trees):
            raise CellRefusal("variable_twice", **place)
        raise CellRefusal(
            "variable_in_wrong_cell", cell=cell, joint=joint.joint.value, expected=expected, **place
        )
    return _sign_of(found, joint, cell)


def _moves(joint: RowJoint, trees: Mapping[str, Node]) -> bool:
    """Whether the variable of a row stands in its cell; another one may."""
    cell = VARIABLE_CELLS[joint.joint]
    return cell in trees and any(uses(trees[cell], lambda name: joint.variable(name, cell) == joint.number))


def _sign_of(found: list[Use], joint: RowJoint, cell: str) -> int:
    for use in found:
        if use.fault:
            place: dict[str, ParamValue] = {"column": use.name.column, "name": use.name.name}
            factor = {"factor": str(abs(use.weight))} if use.fault == "variable_scaled" else {}
            raise CellRefusal(use.fault, **place, **factor)
    numbers = [joint.variable(use.name.name, cell) for use in found]
    for use, number in list(zip(found, numbers, strict=True))[1:]:
        if numbers.count(number) > 1:
            raise CellRefusal("variable_twice", column=use.name.column, name=use.name.name)
    return 1 if found[0].weight > 0 else -1
