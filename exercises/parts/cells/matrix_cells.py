"""Matrices as students write them: a 4×4 of cells, in the table's variables and in short forms.

Besides everything that a cell of a table may hold, `c1`, `s23`, `cθ1`, `C(q1)`, `Sθ_1` and the like are
understood: c and s stand for cosine and sine, and one-digit indices in a row for the sum of the variables.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import NamedTuple, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from exercises.parts.cells.exactness import roundings
from exercises.parts.protocol import Reading
from exercises.parts.samples import Samples
from kinematics.answers.left_open import EXACT, Rounded, left_open
from kinematics.cells import AngleUnit, Cell, Limits
from kinematics.cells.entries import cell_meaning
from kinematics.cells.meaning import CellMeaning, Position
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.tables import NoCell, as_cell
from kinematics.cells.variables import variable_index
from kinematics.errors import CellError, Fault, ParameterError, ParamValue
from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    add,
    call,
    evaluate,
    parameters_in,
)
from kinematics.expressions.arrays import matrices_at
from kinematics.expressions.values import holds_decimals
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.symbolic import Matrix
from kinematics.table import JointType

CellMatrix: TypeAlias = Sequence[Sequence[Cell]]
Where: TypeAlias = tuple[str | int, ...]

CELL_LIMITS = Limits(cell_characters=2000, cell_symbols=48)
"""A cell of ⁰T_6, multiplied out, is longer than a cell of a table."""

ALMOST = 1e-6
"""A share of a robot's size: what the comparison of an exact product with a chain leaves."""

_SHORT = re.compile(r"([cCsS])([0-9]+)")
_GREEK = re.compile(r"(?<![A-Za-z_])([cCsS])(?:θ|ϑ|\\theta|theta)_?\{?([0-9]+)\}?")
_CALLED = re.compile(r"(?<![A-Za-z_])([cCsS])(?= *\()")
_FUNCTIONS = {"c": Function.COS, "s": Function.SIN}


@dataclass(frozen=True)
class SymbolicMatrix:
    """A matrix of expressions.

    Attributes:
        entries: row by row; angles in [rad], lengths in the unit of the answer.
        idle: by row and column the names in a cell that make no difference.
        decimal: rows and columns of the cells that hold numbers which may have been rounded.
        rounded: of entries with names and decimals.
    """

    entries: tuple[tuple[Expression, ...], ...]
    idle: Mapping[tuple[int, int], frozenset[str]] = field(default_factory=dict, compare=False)
    decimal: frozenset[tuple[int, int]] = field(default=frozenset(), compare=False)
    rounded: Rounded = field(default_factory=dict, compare=False)

    def as_typed(self, samples: Samples, size: float) -> NDArray[np.float64]:
        """Return by how much entries may be off for their decimals, (k, 4, 4); infinite if not known."""
        limit = np.full((samples.joints.shape[1], 4, 4), np.inf)
        parameters = samples.parameters(self.names())
        for r, c in self.decimal:
            entry = self.entries[r][c]
            if entry in self.rounded:
                limit[:, r, c] = EXACT * size + left_open(entry, self.rounded, parameters, samples.joints)
        return limit

    def names(self) -> frozenset[str]:
        """Return the parameters in it."""
        return self._names

    @cached_property
    def _names(self) -> frozenset[str]:
        return frozenset().union(*(parameters_in(entry) for row in self.entries for entry in row))

    def typed_share(self, samples: Samples, size: float) -> float:
        """Return by which share of a size lengths may be off for all that is typed in decimals."""
        if not self.decimal:
            return ALMOST
        if any(self.entries[r][c] not in self.rounded for r, c in self.decimal):
            return 1.0
        typed = self.as_typed(samples, size)
        return max(ALMOST, float(typed.max(where=np.isfinite(typed), initial=0.0)) / size)

    def at(self, parameters: Mapping[str, float], joints: Sequence[float]) -> NDArray[np.float64]:
        """Return its values; an entry that has none there (a division by zero) is NaN."""
        return np.array([[_value(entry, parameters, joints) for entry in row] for row in self.entries])

    def at_points(self, samples: Samples) -> NDArray[np.float64]:
        """Return its values at all the points, (k, 4, 4); NaN or infinite where an entry has none."""
        return matrices_at(self.entries, samples.parameters(self.names()), samples.joints)


def read_matrix(
    cells: CellMatrix,
    joint_types: Sequence[JointType],
    angle_unit: AngleUnit,
    where: Where,
    limits: Limits = CELL_LIMITS,
) -> SymbolicMatrix:
    """Return the matrix that a 4×4 of cells means.

    Args:
        cells: row by row.
        joint_types: types of joint 1 … n, whose variables may stand in the cells.
        angle_unit: unit of plain numbers where an angle stands.
        where: place of the matrix in the answer, for faults.
        limits: how large a cell may be.

    Raises:
        CellError: it is not 4×4, or cells cannot be read; every fault, each with the place of its cell.
    """
    if len(cells) != 4 or any(len(row) != 4 for row in cells):
        raise CellError(Fault(code="matrix_not_4x4", where=where))
    found = _read_cells(cells, joint_types, angle_unit, where, limits)
    faults = [entry for row in found for entry in row if isinstance(entry, Fault)]
    if faults:
        raise CellError(faults)
    entries = cast(Sequence[Sequence[_Entry]], found)
    placed = [((r, k), entry) for r, row in enumerate(entries) for k, entry in enumerate(row)]
    return SymbolicMatrix(
        tuple(tuple(entry.meaning.expression for entry in row) for row in entries),
        {place: entry.idle for place, entry in placed if entry.idle},
        frozenset(place for place, entry in placed if entry.decimal),
    )


def read_entries(
    cells: CellMatrix,
    joint_types: Sequence[JointType],
    angle_unit: AngleUnit,
    where: Where,
    limits: Limits = CELL_LIMITS,
) -> list[list[CellMeaning | Fault]]:
    """Return what each cell of a 4×4 means, or what is wrong with it, with its place.

    Args as in `read_matrix`.
    """
    found = _read_cells(cells, joint_types, angle_unit, where, limits)
    return [[entry if isinstance(entry, Fault) else entry.meaning for entry in row] for row in found]


def _read_cells(
    cells: CellMatrix, joint_types: Sequence[JointType], angle_unit: AngleUnit, where: Where, limits: Limits
) -> list[list[_Entry | Fault]]:
    length, ratio = (
        _manner(position, angle_unit, limits, tuple(joint_types))
        for position in (Position.LENGTH, Position.RATIO)
    )

    def entry(cell: Cell, r: int, k: int) -> _Entry | Fault:
        try:
            return _read(as_cell(cell), length if k == 3 and r < 3 else ratio)
        except CellRefusal as refusal:
            return refusal.at(*where, r, k)
        except _NameError as error:
            return error.fault.within(*where, r, k)

    return [[entry(cell, r, k) for k, cell in enumerate(row)] for r, row in enumerate(cells)]


def read_known_matrix(
    cells: CellMatrix, reading: Reading, part: str, *where: str | int
) -> SymbolicMatrix | None:
    """Return the matrix that a 4×4 of cells means in the joint variables of a student's answer.

    Its faults are kept in the reading, at `where` inside the part.
    """
    read = reading.keep(part, lambda: read_matrix(cells, reading.joint_types, reading.angle_unit, where))
    known = None if read is None else _in_known_names(read, reading, part, *where)
    if known is None or not known.decimal:
        return known

    def read_again(texts: Sequence[str]) -> tuple[Expression, ...] | None:
        return read_row(texts, replace(reading, faults=[]), part)

    pairs = [(cells[r][c], known.entries[r][c]) for r, c in sorted(known.decimal)]
    rounded = roundings(pairs, (), read_again)
    return replace(known, rounded=rounded) if rounded else known


def read_functions(
    cells: Sequence[Cell],
    joint_types: Sequence[JointType],
    angle_unit: AngleUnit,
    where: Where,
    position: Position = Position.LENGTH,
) -> list[CellMeaning | Fault]:
    """Return what each cell of a row means, or what is wrong with it; numbers are not angles.

    Args as in `read_matrix`.
    """
    manner = _manner(position, angle_unit, CELL_LIMITS, tuple(joint_types))

    def entry(cell: Cell, k: int) -> CellMeaning | Fault:
        try:
            return _read(as_cell(cell), manner).meaning
        except CellRefusal as refusal:
            return refusal.at(*where, k)
        except _NameError as error:
            return error.fault.within(*where, k)

    return [entry(cell, k) for k, cell in enumerate(cells)]


def read_row(
    cells: Sequence[Cell], reading: Reading, part: str, *where: str | int, names: Collection[str] = ()
) -> tuple[Expression, ...] | None:
    """Return what a row of cells means in the joint variables of a student's answer.

    Args:
        cells: the row.
        reading: where faults go.
        part: the kind of part.
        where: place of the row inside the part.
        names: names that may stand in it besides the exercise's own.
    """
    read = read_functions(cells, reading.joint_types, reading.angle_unit, (part, *where))
    found = [entry for entry in read if not isinstance(entry, Fault)]
    reading.faults.extend(entry for entry in read if isinstance(entry, Fault))
    if len(found) < len(cells):
        return None
    own = [
        reading.own_names(entry.expression, (part, *where, k), names, entry.idle)
        for k, entry in enumerate(found)
    ]
    row = tuple(entry for entry in own if entry is not None)
    return row if len(row) == len(own) else None


def read_numbers(cells: CellMatrix, reading: Reading, part: str, *where: str) -> NDArray[np.float64] | None:
    """Return (4, 4) the values of cells that hold numbers and dimensions but no joint variables.

    Lengths are in the student's unit; faults are kept in the reading, at `where` inside the part.
    """
    matrix = reading.keep(part, lambda: read_matrix(cells, (), reading.angle_unit, where))
    if matrix is None:
        return None
    known = _in_known_names(matrix, reading, part, *where)
    if known is None:
        return None
    numbers = known.at(reading.values, ())
    for r, c in np.argwhere(~np.isfinite(numbers)).tolist():
        reading.fault("value_not_real", part, *where, r, c)
    return numbers


def _in_known_names(
    matrix: SymbolicMatrix, reading: Reading, part: str, *where: str | int
) -> SymbolicMatrix | None:
    """Return a matrix in the exercise's own names; None if it holds one that means nothing there."""
    if matrix.names() <= reading.instance.exercise.reference.parameters.keys() and not matrix.idle:
        return matrix  # with what is known of it: it is read once for all who write the same
    rows: list[tuple[Expression, ...]] = []
    for r, row in enumerate(matrix.entries):
        own = [
            reading.own_names(entry, (part, *where, r, c), idle=matrix.idle.get((r, c), ()))
            for c, entry in enumerate(row)
        ]
        rows.append(tuple(entry for entry in own if entry is not None))
    is_whole = all(len(own) == len(row) for own, row in zip(rows, matrix.entries, strict=True))
    return replace(matrix, entries=tuple(rows)) if is_whole else None


def write_matrix(matrix: Matrix, n_joints: int, parameters: Sequence[str]) -> CellMatrix:
    """Return a matrix in closed form as a student would type it, with c1 for cos(q1)."""
    printer = MatrixPrinter(n_joints=n_joints, parameters=tuple(parameters), notation=Notation.SHORT)
    purpose = Purpose(name="matrix", meaning="A matrix.")
    written: CellMatrix = printer.write(matrix, (Format.TEXT,), purpose)["text"]
    return written


@dataclass(frozen=True, eq=False, slots=True)
class _Manner:
    """How a cell is read; one object for each manner, so that a cell is looked up by text and identity."""

    position: Position
    unit: AngleUnit
    limits: Limits
    joint_types: tuple[JointType, ...]


@lru_cache(maxsize=512)
def _manner(
    position: Position, unit: AngleUnit, limits: Limits, joint_types: tuple[JointType, ...]
) -> _Manner:
    return _Manner(position, unit, limits, joint_types)


class _Entry(NamedTuple):
    """What a cell means, its names that make no difference, and whether it holds rounded numbers."""

    meaning: CellMeaning
    idle: frozenset[str]
    decimal: bool


@lru_cache(maxsize=8192, typed=True)
def _read(cell: Cell | NoCell, manner: _Manner) -> _Entry:
    """What is read in one cell."""
    meaning = _meaning(cell, manner)
    return _Entry(meaning, meaning.idle, holds_decimals(meaning.expression))


def _meaning(cell: Cell | NoCell, manner: _Manner) -> CellMeaning:
    """The meaning of one cell; the columns of a refusal are those of the cell as typed."""
    position, unit, limits = manner.position, manner.unit, manner.limits
    variable = _variables(manner.joint_types)
    if not isinstance(cell, str):
        return cell_meaning(cell, position, unit, limits, variable)
    text = _GREEK.sub(lambda m: f"{m[1]}{m[2]}".rjust(len(m[0])), cell)
    places = [m.start() for m in _CALLED.finditer(text)]
    text = _CALLED.sub(lambda m: _FUNCTIONS[m[1].lower()].value, text)
    try:
        return cell_meaning(text, position, unit, limits, variable)
    except CellRefusal as refusal:
        column = refusal.params.get("column")
        if isinstance(column, int):
            before = sum(1 for k, place in enumerate(places) if place + 2 * (k + 1) < column)
            refusal.params["column"] = max(1, column - 2 * before)
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
            raise _NameError("joint_variable_in_number", name, n)
        digits = short[2]
        joints = [int(digits)] if n > 9 or len(digits) == 1 else [int(digit) for digit in digits]
        if not all(_is(joint_types, joint, JointType.REVOLUTE) for joint in joints):
            raise _NameError(
                "short_form_unknown",
                name,
                n,
            )
        return call(_FUNCTIONS[short[1].lower()], add(JointVariable(joint) for joint in joints))

    return meaning


class _NameError(Exception):
    """A name in a cell means nothing there."""

    def __init__(self, code: str, name: str, joints: int, **params: ParamValue) -> None:
        super().__init__(code)
        self.fault = Fault(code=code, params={"name": name, "joints": joints, **params})


def _is(joint_types: Sequence[JointType], joint: int, joint_type: JointType) -> bool:
    return 1 <= joint <= len(joint_types) and joint_types[joint - 1] is joint_type


def _known(index: int, name: str, n: int) -> int:
    if not n:
        raise _NameError("joint_variable_in_number", name, n)
    if not 1 <= index <= n:
        digits = str(index)
        several = len(digits) > 1 and all(1 <= int(digit) <= n for digit in digits)
        meant = " + ".join(f"q{digit}" for digit in digits) if several else ""
        raise _NameError("joint_variable_unknown", name, n, sum=meant, summed=int(several))
    return index


def _value(entry: Expression, parameters: Mapping[str, float], joints: Sequence[float]) -> float:
    try:
        return evaluate(entry, parameters, joints)
    except ParameterError as error:
        if error.code == "parameter_missing":
            raise
        return float("nan")
