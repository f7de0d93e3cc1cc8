"""DH tables: read from the wire or the catalogue, written in either convention."""

from collections.abc import Mapping
from dataclasses import replace
from functools import reduce
from typing import TypeAlias

import numpy as np

from kinematics.cells import ParameterKind, RawTable, ReadTable, bind_parameters, read_table
from kinematics.conversion import XScrew, convert, fixed_row
from kinematics.dh import link_transform
from kinematics.expressions import Expression, add, evaluate, multiply, number, parameters_in
from kinematics.fixed_rows import fixed_rows
from kinematics.se3 import Transform
from kinematics.table import VARIABLE_CELLS, Convention, DHTable
from service.http.problems import located
from service.schemas.kinematics.conversion import ConvertRequest, TableAnswer
from service.schemas.tables import AnsweredRow, AnsweredTable, units_of
from service.settings import Settings
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.conversion.described import RobotDescription
from service.wire.kinematics.conversion.named_poses import with_names, x_screw, x_screw_entries
from service.wire.kinematics.prepared_robots import listed_robot, robot_of
from service.wire.kinematics.written_tables import (
    CELL_KINDS,
    Spellings,
    TableWriter,
    WireCell,
    cell_text,
)

Matrix = list[list[WireCell]]
Entries: TypeAlias = tuple[tuple[Expression, ...], ...]


def described_table(request: ConvertRequest, settings: Settings) -> RobotDescription:
    """Return the robot of a table, or of the catalogue.

    Raises:
        KinematicsError: the table cannot be read, or the parameters that were given do not fit.
    """
    name: str | None = None
    limits = None
    if request.table is None:
        listed = listed_robot(str(request.robot))
        name, limits = listed.id, listed.limits
        raw, read = listed.raw, listed.table
        parameters: Mapping[str, float] | None = {**listed.parameters, **(request.parameters or {})}
    else:
        raw = request.table.raw()
        with located("table"):
            read = read_table(raw, settings.cell_limits)
        parameters = request.parameters
    read, named = with_names(read, request, settings.cell_limits)
    if parameters is not None:
        robot_of(read, parameters)
    return RobotDescription(
        read=read,
        parameters=parameters,
        named=named,
        spellings=_spellings(raw, read),
        variable_cells=_variable_cells(raw, read),
        name=name,
        limits=limits,
    )


def table_answer(robot: RobotDescription, request: ConvertRequest) -> TableAnswer:
    """Return the robot's table in a convention, its entries moved and never computed.

    Raises:
        ParameterError: a parameter of base or tool has no finite value.
    """
    convention = Convention(request.to.value)
    before, behind = ends_in_expressions(robot)
    base_screw, tool_screw = x_screw(before), x_screw(behind)
    converted = convert(robot.read.table, convention, base=base_screw, tool=tool_screw)
    writer = TableWriter(units=robot.read, spellings=robot.spellings, variable_cells=robot.variable_cells)
    table = writer.table(converted.table)
    before, behind = None if base_screw else before, None if tool_screw else behind
    base = matrix_of_cells(converted.base, robot, before=robot.base if before is None else before)
    tool = matrix_of_cells(converted.tool, robot, behind=robot.tool if behind is None else behind)
    base_row = None if before else _row(converted.base, writer, robot.base)
    tool_row = None if behind else _row(converted.tool, writer, robot.tool)
    return TableAnswer(
        **units_of(robot.read),
        table=AnsweredTable.model_validate(table),
        base=base,
        tool=tool,
        base_row=base_row,
        tool_row=tool_row,
        base_rows=_rows(base, base_row, convention, writer),
        tool_rows=_rows(tool, tool_row, convention, writer),
        **robot.names_and_limits,
    )


def ends_in_expressions(robot: RobotDescription) -> tuple[Entries | None, Entries | None]:
    """Return base and tool in expressions, None where all of it is known in numbers."""
    if robot.parameters is not None:
        return None, None
    return robot.named.get("base"), robot.named.get("tool")


def matrix_of_cells(
    screw: XScrew[Expression] | None,
    robot: RobotDescription,
    *,
    before: Transform | Entries | None = None,
    behind: Transform | Entries | None = None,
) -> Matrix:
    """Return before · screw · behind: numbers where all is known, else expressions."""
    named = screw is not None and parameters_in(screw.a) | parameters_in(screw.alpha)
    if isinstance(before, tuple) or isinstance(behind, tuple) or (robot.parameters is None and named):
        factors = [_entries(before), None if screw is None else x_screw_entries(screw), _entries(behind)]
        product = reduce(_product, (factor for factor in factors if factor is not None))
        return [[_entry(entry) for entry in row] for row in product]
    motion = np.eye(4) if screw is None else _motion(screw, robot)
    if before is not None:
        motion = before @ motion
    if behind is not None:
        motion = motion @ behind
    return plain_lists(motion)


def _motion(screw: XScrew[Expression], robot: RobotDescription) -> Transform:
    """The motion with the robot's parameters, bound as a row of its table is; without them it needs none."""
    table = DHTable(convention=robot.read.table.convention, rows=(fixed_row(screw),))
    needed = {} if robot.parameters is None else robot.read.parameters
    bound = bind_parameters(replace(robot.read, table=table, parameters=needed), robot.parameters or {})
    return link_transform(bound.rows[0], bound.convention)


def _entries(motion: Transform | Entries | None) -> Entries | None:
    if motion is None or isinstance(motion, tuple):
        return motion
    return tuple(tuple(number(repr(entry)) for entry in row) for row in plain_lists(motion))


def _product(one: Entries, other: Entries) -> Entries:
    columns = tuple(zip(*other, strict=True))
    return tuple(
        tuple(add(multiply(pair) for pair in zip(row, column, strict=True)) for column in columns)
        for row in one
    )


def _entry(entry: Expression) -> WireCell:
    return cell_text(entry) if parameters_in(entry) else evaluate(entry) + 0.0


def _row(screw: XScrew[Expression] | None, writer: TableWriter, other: Transform) -> AnsweredRow | None:
    """The motion as a fixed row, unless something else stands beside it."""
    if screw is None or not np.array_equal(other, np.eye(4)):
        return None
    return AnsweredRow.model_validate(writer.row(fixed_row(screw)))


def _rows(
    pose: Matrix, single: AnsweredRow | None, convention: Convention, writer: TableWriter
) -> list[AnsweredRow] | None:
    """The pose as fixed rows; None if it depends on a parameter without a value and is not a single row."""
    if single is not None:
        return [single]
    if any(isinstance(entry, str) for row in pose for entry in row):
        return None
    rows = fixed_rows(np.array(pose, dtype=float), convention)
    return [AnsweredRow.model_validate(writer.row(row)) for row in rows]


def _spellings(raw: RawTable, read: ReadTable) -> Spellings:
    """How the constant entries were written."""
    found: dict[tuple[ParameterKind, Expression], WireCell] = {}
    for row, entries in zip(raw.rows, read.table.rows, strict=True):
        for name, kind in CELL_KINDS.items():
            if VARIABLE_CELLS.get(entries.joint) != name:
                found.setdefault((kind, getattr(entries, name)), getattr(row, name))
    return found


def _variable_cells(raw: RawTable, read: ReadTable) -> dict[int, WireCell]:
    """How the cells with the joint variables were written, by the number of the joint."""
    return {
        joint: getattr(raw.rows[i], VARIABLE_CELLS[read.table.rows[i].joint])
        for joint, i in enumerate(read.table.joint_rows, 1)
    }
