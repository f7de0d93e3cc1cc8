"""`parse`: what a student handed in, read or refused. What is refused is not graded and costs no attempt."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from exercises.definition import PartKind
from exercises.errors import AnswerError
from exercises.instance import Instance
from exercises.parts.matrix_cells import CellMatrix, SymbolicMatrix, read_matrix
from exercises.parts.pose import policy_fixes_pose
from exercises.parts.schematic import Schematic, schematic_faults
from exercises.parts.workspace import WorkspaceAnswer
from kinematics.cells import (
    DEFAULT,
    AngleUnit,
    Cell,
    LengthUnit,
    Limits,
    ParameterKind,
    RawTable,
    ReadTable,
    read_cell,
    read_table,
)
from kinematics.errors import CellError, Fault, KinematicsError
from kinematics.expressions import evaluate, parameters_in
from kinematics.table import JointType

Read = TypeVar("Read")


@dataclass(frozen=True, kw_only=True, slots=True)
class RawAnswer:
    """An answer as handed in; None where nothing was handed in.

    Attributes:
        table: the DH table.
        link_matrices: per row of the table a 4×4 of cells, or None.
        transform: ⁰T_N, 4×4 of cells.
        pose: ⁰T_N at the given joint values, 4×4 of cells.
        schematic: joint types and relations of neighbouring axes.
        workspace: inner and outer radius.
    """

    table: RawTable | None = None
    link_matrices: Sequence[CellMatrix | None] | None = None
    transform: CellMatrix | None = None
    pose: CellMatrix | None = None
    schematic: Schematic | None = None
    workspace: Mapping[str, Cell] | None = None

    def parts(self) -> tuple[PartKind, ...]:
        """What was handed in."""
        return tuple(kind for kind in PartKind if getattr(self, kind.value) is not None)


@dataclass(frozen=True, kw_only=True, eq=False)
class Answer:
    """An answer as read; None where nothing was handed in.

    Attributes:
        table: the DH table.
        link_matrices: per row of the table a matrix, or None.
        transform: ⁰T_N.
        pose: (4, 4) ⁰T_N in numbers.
        schematic: joint types and relations.
        workspace: the radii.
        angle_unit: unit of its angles: the table's, or else the exercise's.
        length_unit: unit of its lengths: the table's, or else the exercise's.
    """

    table: ReadTable | None
    link_matrices: tuple[SymbolicMatrix | None, ...] | None
    transform: SymbolicMatrix | None
    pose: NDArray[np.float64] | None
    schematic: Schematic | None
    workspace: WorkspaceAnswer | None
    angle_unit: AngleUnit
    length_unit: LengthUnit

    def parts(self) -> tuple[PartKind, ...]:
        """What was handed in."""
        return tuple(kind for kind in PartKind if getattr(self, kind.value) is not None)


def parse(instance: Instance, raw: RawAnswer, limits: Limits = DEFAULT) -> Answer:
    """Read an answer.

    Args:
        instance: the exercise with the student's values.
        raw: what was handed in.
        limits: how large a table may be.

    Raises:
        AnswerError: it cannot be graded; every fault, each with its place in the answer.
    """
    faults = list(_shape_faults(instance, raw))
    reader = _Reader(faults)
    raw_table = raw.table
    table = reader.keep("table", lambda: read_table(raw_table, limits)) if raw_table is not None else None
    source = table or instance.exercise.reference
    types, angle, length = source.table.joint_types, source.angle_unit, source.length_unit
    values = values_in_unit(instance, length)
    answer = Answer(
        table=table,
        link_matrices=_link_matrices(raw, table, types, angle, reader),
        transform=_matrix(raw.transform, types, angle, "transform", reader),
        pose=_pose(raw.pose, values, angle, reader),
        schematic=raw.schematic,
        workspace=_workspace(raw.workspace, values, angle, reader),
        angle_unit=angle,
        length_unit=length,
    )
    if faults:
        raise AnswerError(faults)
    return answer


def values_in_unit(instance: Instance, unit: LengthUnit) -> dict[str, float]:
    """Value of every dimension in a length unit (an angle in the exercise's unit)."""
    exercise = instance.exercise
    ratio = float(exercise.length_unit.metres_per_unit / unit.metres_per_unit)
    kinds = exercise.reference.parameters
    return {
        name: value * (ratio if kinds[name] is ParameterKind.LENGTH else 1.0)
        for name, value in instance.parameters.items()
    }


class _Reader:
    """Reads pieces of an answer; keeps the faults of all of them."""

    def __init__(self, faults: list[Fault]) -> None:
        self.faults = faults

    def keep(self, part: str, read: Callable[[], Read]) -> Read | None:
        """What a reading function returns, or None; its faults are seen from the whole answer."""
        try:
            return read()
        except KinematicsError as error:
            self.faults.extend(fault.within(part) for fault in error.faults)
            return None


def _shape_faults(instance: Instance, raw: RawAnswer) -> list[Fault]:
    """What is wrong before a single cell is read."""
    asked = [part.kind for part in instance.exercise.parts]
    known = tuple(kind.value for kind in asked)
    given = raw.parts()
    if not given:
        f"nothing was handed in; the exercise asks for {', '.join(known)}"
        return [Fault(code="answer_empty", params={"known": known})]
    faults = [
        Fault(
            code="part_not_asked",
            where=(kind.value,),
            params={"part": kind.value, "known": known},
        )
        for kind in given
        if kind not in asked
    ]
    if raw.link_matrices is not None:
        faults += _count_faults(instance, raw)
    if raw.schematic is not None:
        faults += [fault.within("schematic") for fault in schematic_faults(raw.schematic)]
    if (
        raw.pose is not None
        and raw.table is None
        and raw.transform is None
        and not policy_fixes_pose(instance.exercise.policy)
    ):
        faults.append(
            Fault(
                code="pose_needs_table",
                where=("pose",),
            )
        )
    return faults


def _count_faults(instance: Instance, raw: RawAnswer) -> list[Fault]:
    assert raw.link_matrices is not None
    given = len(raw.link_matrices)
    rows = len(raw.table.rows) if raw.table is not None else None
    if rows is not None and given != rows:
        return [
            Fault(
                code="link_matrices_count",
                where=("link_matrices",),
                params={"expected": rows, "given": given},
            )
        ]
    if rows is None and (not given or any(matrix is None for matrix in raw.link_matrices)):
        return [
            Fault(
                code="link_matrices_need_table",
                where=("link_matrices",),
            )
        ]
    return []


def _link_matrices(
    raw: RawAnswer, table: ReadTable | None, types: Sequence[JointType], unit: AngleUnit, reader: _Reader
) -> tuple[SymbolicMatrix | None, ...] | None:
    if raw.link_matrices is None or (raw.table is not None and table is None):
        return None
    return tuple(
        None if cells is None else _matrix(cells, types, unit, "link_matrices", reader, i)
        for i, cells in enumerate(raw.link_matrices)
    )


def _matrix(
    cells: CellMatrix | None,
    types: Sequence[JointType],
    unit: AngleUnit,
    part: str,
    reader: _Reader,
    *where: int,
) -> SymbolicMatrix | None:
    if cells is None:
        return None
    return reader.keep(part, lambda: read_matrix(cells, types, unit, where))


def _pose(
    cells: CellMatrix | None, values: Mapping[str, float], unit: AngleUnit, reader: _Reader
) -> NDArray[np.float64] | None:
    matrix = _matrix(cells, (), unit, "pose", reader)
    if matrix is None:
        return None
    faults = _name_faults(matrix, tuple(values))
    reader.faults.extend(fault.within("pose") for fault in faults)
    if faults:
        return None
    numbers = matrix.at(values, ())
    reader.faults.extend(
        Fault(code="value_not_real", where=("pose", r, c))
        for r, c in np.argwhere(~np.isfinite(numbers)).tolist()
    )
    return numbers


def _name_faults(matrix: SymbolicMatrix, known: tuple[str, ...]) -> list[Fault]:
    return [
        Fault(
            code="name_without_value",
            where=(r, c),
            params={"name": name, "known": known},
        )
        for r, row in enumerate(matrix.entries)
        for c, entry in enumerate(row)
        for name in sorted(parameters_in(entry) - set(known))
    ]


def _workspace(
    cells: Mapping[str, Cell] | None, values: Mapping[str, float], unit: AngleUnit, reader: _Reader
) -> WorkspaceAnswer | None:
    if cells is None:
        return None
    radii: dict[str, float] = {}
    for name in ("inner", "outer"):
        value = reader.keep("workspace", partial(_radius, cells[name], name, values, unit))
        if value is not None:
            radii[name] = value
    return WorkspaceAnswer(**radii) if len(radii) == 2 else None


def _radius(cell: Cell, name: str, values: Mapping[str, float], unit: AngleUnit) -> float:
    try:
        expression = read_cell(cell, ParameterKind.LENGTH, angle_unit=unit, variable=lambda _: None)
        value = evaluate(expression, values)
    except KinematicsError as error:
        raise type(error)(
            Fault(code=fault.code, where=(name,), params=fault.params) for fault in error.faults
        ) from None
    if value < 0:
        raise CellError(Fault(code="radius_negative", where=(name,)))
    return value
