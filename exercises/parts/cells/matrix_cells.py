"""Matrices as students write them: a 4×4 of cells, in the table's variables and in short forms."""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from typing import Any, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from exercises.parts.cells.exactness import roundings
from exercises.parts.cells.short_forms import MatrixEntry, cell_manner, read_entry
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.protocol import Reading
from kinematics.cells import AngleUnit, Cell
from kinematics.cells.meaning import CellMeaning, Position
from kinematics.errors import CellError, Fault
from kinematics.expressions import Expression
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.symbolic import Matrix
from kinematics.table import JointType

CellMatrix: TypeAlias = Sequence[Sequence[Cell]]
Where: TypeAlias = tuple[str | int, ...]


def read_matrix(
    cells: CellMatrix, joint_types: Sequence[JointType], angle_unit: AngleUnit, where: Where
) -> SymbolicMatrix:
    """Return the matrix that a 4×4 of cells means.

    Args:
        joint_types: types of joint 1 … n, whose variables may stand in the cells.
        angle_unit: unit of plain numbers where an angle stands.
        where: place of the matrix in the answer, for faults.

    Raises:
        CellError: it is not 4×4, or cells cannot be read; every fault, each with the place of its cell.
    """
    if len(cells) != 4 or any(len(row) != 4 for row in cells):
        raise CellError(Fault.at("matrix_not_4x4", *where))
    found = _read_cells(cells, joint_types, angle_unit, where)
    faults = [entry for row in found for entry in row if isinstance(entry, Fault)]
    if faults:
        raise CellError(faults)
    entries = cast(Sequence[Sequence[MatrixEntry]], found)
    placed = [((r, k), entry) for r, row in enumerate(entries) for k, entry in enumerate(row)]
    return SymbolicMatrix(
        tuple(tuple(entry.meaning.expression for entry in row) for row in entries),
        {place: entry.idle for place, entry in placed if entry.idle},
        frozenset(place for place, entry in placed if entry.decimal),
    )


def read_entries(
    cells: CellMatrix, joint_types: Sequence[JointType], angle_unit: AngleUnit, where: Where
) -> list[list[CellMeaning | Fault]]:
    """Return what each cell of a 4×4 means, or what is wrong with it, with its place.

    Args as in `read_matrix`.
    """
    found = _read_cells(cells, joint_types, angle_unit, where)
    return [[entry if isinstance(entry, Fault) else entry.meaning for entry in row] for row in found]


def _read_cells(
    cells: CellMatrix, joint_types: Sequence[JointType], angle_unit: AngleUnit, where: Where
) -> list[list[MatrixEntry | Fault]]:
    length, ratio = (
        cell_manner(position, angle_unit, tuple(joint_types))
        for position in (Position.LENGTH, Position.RATIO)
    )
    return [
        [read_entry(cell, length if k == 3 and r < 3 else ratio, *where, r, k) for k, cell in enumerate(row)]
        for r, row in enumerate(cells)
    ]


def read_known_matrix(cells: CellMatrix, reading: Reading, *where: str | int) -> SymbolicMatrix | None:
    """Return the matrix that a 4×4 of cells means in the joint variables of a student's answer.

    Its faults are kept in the reading, at `where`.
    """
    read = reading.keep(lambda: read_matrix(cells, reading.joint_types, reading.angle_unit, where))
    known = None if read is None else _in_known_names(read, reading, *where)
    if known is None or not known.decimal:
        return known
    rounded = roundings_in(((cells[r][c], known.entries[r][c]) for r, c in sorted(known.decimal)), reading)
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
    manner = cell_manner(position, angle_unit, tuple(joint_types))
    found = (read_entry(cell, manner, *where, k) for k, cell in enumerate(cells))
    return [entry if isinstance(entry, Fault) else entry.meaning for entry in found]


def read_row(
    cells: Sequence[Cell], reading: Reading, *where: str | int, names: Collection[str] = ()
) -> tuple[Expression, ...] | None:
    """Return what a row of cells means in the joint variables of a student's answer.

    Other names than the exercise's own may stand in it, if `names` holds them; faults go to the reading.
    """
    read = read_functions(cells, reading.joint_types, reading.angle_unit, where)
    found = [entry for entry in read if not isinstance(entry, Fault)]
    reading.faults.extend(entry for entry in read if isinstance(entry, Fault))
    if len(found) < len(cells):
        return None
    own = [
        reading.own_names(entry.expression, (*where, k), names, entry.idle) for k, entry in enumerate(found)
    ]
    row = tuple(entry for entry in own if entry is not None)
    return row if len(row) == len(own) else None


def roundings_in(
    cells: Iterable[tuple[Any, Expression]],
    reading: Reading,
    rates: Collection[str] = (),
    names: Collection[str] = (),
) -> dict[Expression, tuple[Expression, ...]]:
    """Return entries with their decimals moved, as `roundings`; they are read again as `read_row` reads."""
    again = replace(reading, faults=[])
    return roundings(cells, rates, lambda texts: read_row(texts, again, names=names))


def read_numbers(cells: CellMatrix, reading: Reading, *where: str) -> NDArray[np.float64] | None:
    """Return (4, 4) the values of cells that hold numbers and dimensions but no joint variables.

    Lengths are in the student's unit; faults are kept in the reading, at `where`.
    """
    matrix = reading.keep(lambda: read_matrix(cells, (), reading.angle_unit, where))
    if matrix is None:
        return None
    known = _in_known_names(matrix, reading, *where)
    if known is None:
        return None
    numbers = known.at(reading.values, ())
    for r, c in np.argwhere(~np.isfinite(numbers)).tolist():
        reading.fault("value_not_real", *where, r, c)
    return numbers


def _in_known_names(matrix: SymbolicMatrix, reading: Reading, *where: str | int) -> SymbolicMatrix | None:
    """Return a matrix in the exercise's own names; None if it holds one that means nothing there."""
    if matrix.names() <= reading.instance.exercise.reference.parameters.keys() and not matrix.idle:
        return matrix  # with what is known of it: it is read once for all who write the same
    rows: list[tuple[Expression, ...]] = []
    for r, row in enumerate(matrix.entries):
        own = [
            reading.own_names(entry, (*where, r, c), idle=matrix.idle.get((r, c), ()))
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
