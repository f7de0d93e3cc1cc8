"""A cell of a matrix: everything that a cell of a table may hold, and short forms.

`c1`, `s23`, `cθ₁`, `C(q1)`, `S_{θ1}` and the like are understood: c and s stand for cosine and sine, and
one-digit indices in a row for the sum of the variables. `c1 (L1 + L2)` is a product.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from kinematics.cells import AngleUnit, Cell, Limits
from kinematics.cells.entries import cell_meaning
from kinematics.cells.meaning import CellMeaning, Position
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.tables import NoCell, as_cell
from kinematics.cells.variables import variable_index
from kinematics.errors import Fault
from kinematics.expressions import Expression, Function, JointVariable, add, call
from kinematics.expressions.values import holds_decimals
from kinematics.table import JointType

_SHORT = re.compile(r"([cCsS])([0-9]+)")
_THETA = r"(?:θ|ϑ|\\theta|theta|q) ?_?(?:([0-9]+|[₀-₉]+)|\{([0-9]+)\})"
_GREEK = re.compile(rf"(?<![A-Za-z_\\])([cCsS])(?:{_THETA}|_?\{{ ?{_THETA} ?\}})")
"""A short form that names the variable: cθ1, cθ₁, c_{\\theta_1}, cq1."""
_BEFORE_BRACKET = re.compile(
    r"(?<![A-Za-z_])([cCsS])(?= *\()|(?<![A-Za-z0-9_])([cCsS]_?(?:[0-9]+|\{[0-9]+\}))( ?)(?= *\()"
)
"""A short form before a bracket: of a function with its argument, or a factor."""
_FUNCTIONS = {"c": Function.COS, "s": Function.SIN}
CELL_LIMITS = Limits(cell_characters=2000, cell_symbols=48)
"""A cell of ⁰T_6, multiplied out, is longer than a cell of a table."""


@dataclass(frozen=True, eq=False, slots=True)
class CellManner:
    """How a cell is read; one object for each manner, so that a cell is looked up by text and identity.

    Attributes:
        position: what stands in the cell.
        unit: of plain numbers where an angle stands.
        joint_types: of joint 1 … n, whose variables may stand in it.
    """

    position: Position
    unit: AngleUnit
    joint_types: tuple[JointType, ...]


cell_manner = lru_cache(maxsize=512)(CellManner)  # Return the one object for a manner.


class MatrixEntry(NamedTuple):
    """What a cell means, its names that make no difference, and whether it holds rounded numbers."""

    meaning: CellMeaning
    idle: frozenset[str]
    decimal: bool


def is_short_form(name: str) -> bool:
    """Return whether a name means a cosine or a sine, as c1 and s23 do, whatever else has this name."""
    return _SHORT.fullmatch(name) is not None


def read_entry(cell: Cell | NoCell, manner: CellManner, *where: str | int) -> MatrixEntry | Fault:
    """Return what a cell means, or what is wrong with it, at its place."""
    try:
        return _read(as_cell(cell), manner)
    except CellRefusal as refusal:
        return refusal.at(*where)


@lru_cache(maxsize=8192, typed=True)
def _read(cell: Cell | NoCell, manner: CellManner) -> MatrixEntry:
    meaning = _meaning(cell, manner)
    return MatrixEntry(meaning, meaning.idle, holds_decimals(meaning.expression))


def _meaning(cell: Cell | NoCell, manner: CellManner) -> CellMeaning:
    """The meaning of one cell; the columns of a refusal are those of the cell as typed."""
    position, unit = manner.position, manner.unit
    variable = _variables(manner.joint_types)
    if not isinstance(cell, str):
        return cell_meaning(cell, position, unit, CELL_LIMITS, variable)
    text = _GREEK.sub(lambda m: "".join(filter(None, m.groups())).rjust(len(m[0])), cell)
    inserted: list[tuple[int, int]] = []

    def written_out(m: re.Match[str]) -> str:
        if m[1]:
            inserted.append((m.start(), 2))
            return _FUNCTIONS[m[1].lower()].value
        inserted.extend([] if m[3] else [(m.end(), 1)])
        return f"{m[2]}*"

    text = _BEFORE_BRACKET.sub(written_out, text)
    try:
        return cell_meaning(text, position, unit, CELL_LIMITS, variable)
    except CellRefusal as refusal:
        column = refusal.params.get("column")
        if isinstance(column, int):
            before = 0
            for place, added in inserted:
                before += added if place + before + added < column else 0
            refusal.params["column"] = max(1, column - before)
        raise


def _variables(joint_types: Sequence[JointType]) -> Callable[[str], Expression | None]:
    n = len(joint_types)

    def meaning(name: str) -> Expression | None:
        index = variable_index(name)
        if index is not None:
            return JointVariable(_known(index, name, n))
        if name[:1] == "d" and name[1:].isdecimal() and _is(joint_types, int(name[1:]), JointType.PRISMATIC):
            return JointVariable(int(name[1:]))
        short = _SHORT.fullmatch(name)
        if short is None:
            return None
        if not n:
            raise CellRefusal("joint_variable_in_number", name=name, joints=n)
        digits = short[2]
        joints = [int(digits)] if n > 9 or len(digits) == 1 else [int(digit) for digit in digits]
        if not all(_is(joint_types, joint, JointType.REVOLUTE) for joint in joints):
            raise CellRefusal("short_form_unknown", name=name, joints=n)
        return call(_FUNCTIONS[short[1].lower()], add(JointVariable(joint) for joint in joints))

    return meaning


def _is(joint_types: Sequence[JointType], joint: int, joint_type: JointType) -> bool:
    return 1 <= joint <= len(joint_types) and joint_types[joint - 1] is joint_type


def _known(index: int, name: str, n: int) -> int:
    if not n:
        raise CellRefusal("joint_variable_in_number", name=name, joints=n)
    if not 1 <= index <= n:
        digits = str(index)
        several = len(digits) > 1 and all(1 <= int(digit) <= n for digit in digits)
        meant = " + ".join(f"q{digit}" for digit in digits) if several else ""
        raise CellRefusal("joint_variable_unknown", name=name, joints=n, sum=meant, summed=int(several))
    return index
