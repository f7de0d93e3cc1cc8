"""SCM chains: SCM2DH of the toolbox, and the way back."""

from dataclasses import replace

from kinematics.cells import ParameterKind, ReadTable, parameter_values
from kinematics.conversion import convert, fixed_row
from kinematics.expressions import ZERO
from kinematics.scm import (
    ChainRow,
    DescribedScm,
    Entry,
    Placement,
    modified_dh_from_scm,
    read_chain,
    scm_from_numbers,
    scm_from_table,
    unrolled_dh_from_scm,
    verify,
    with_tool,
)
from kinematics.symbolic import Matrix
from kinematics.table import Convention, SymbolicTable
from service.schemas.kinematics.conversion import ConvertRequest, ScmAnswer
from service.schemas.kinematics.scm import ScmChainModel, Verification
from service.schemas.tables import units_of
from service.settings import Settings
from service.wire.fault_pointers import traced
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.conversion.described import RobotDescription
from service.wire.kinematics.conversion.dh_tables import ends_in_expressions, matrix_of_cells
from service.wire.kinematics.conversion.named_poses import with_names, x_screw
from service.wire.kinematics.prepared_chains import in_chain
from service.wire.kinematics.prepared_robots import robot_of
from service.wire.kinematics.written_tables import TableWriter, WireCell, with_variable


def described_chain(request: ConvertRequest, settings: Settings) -> RobotDescription:
    """Return the robot of an SCM chain, as the modified DH table that is exactly the chain for every q.

    Raises:
        DescriptionError: the chain cannot be read, or does not pass the document's input check.
        ParameterError: the parameters that were given do not fit.
    """
    assert request.scm is not None
    with in_chain("scm", request.scm):
        chain = read_chain(request.scm.raw(), settings.cell_limits)
        strict = request.verify is not Verification.OFF
        table = modified_dh_from_scm(chain.chain) if strict else unrolled_dh_from_scm(chain.chain)
    read = ReadTable(
        table=table, angle_unit=chain.angle_unit, length_unit=chain.length_unit, parameters=chain.parameters
    )
    read, named = with_names(read, request, settings.cell_limits)
    if request.parameters is not None:
        parameter_values(read.parameters, read.angle_unit, request.parameters)
    return RobotDescription(read=read, parameters=request.parameters, named=named)


def scm_answer(robot: RobotDescription, request: ConvertRequest) -> ScmAnswer:
    """Return the robot as an SCM chain: entry by entry, or in numbers where it has fixed rows.

    Raises:
        TableError: the table has no joints.
        ParameterError: a parameter has no value, and one is needed.
    """
    writer = TableWriter(units=robot.read, spellings=robot.spellings)
    with traced(request):
        before, behind = ends_in_expressions(robot)
        moved = _moved(robot.read.table, behind)
        chain = None if moved is None else with_tool(moved.chain, robot.tool)
        if moved is not None and chain is not None:
            base = matrix_of_cells(moved.base, robot, before=robot.base if before is None else before)
        else:
            table = robot_of(robot.read, robot.parameters or {}).table
            first, chain = scm_from_numbers(table, robot.base, robot.tool)
            base = plain_lists(first)
    units = units_of(robot.read)
    written = ScmChainModel.model_validate(
        {
            "joints": [_row(row, i, writer) for i, row in enumerate(chain.rows, 1)],
            "final": _placement(chain.final, writer),
            "tool": _placement(chain.tool, writer),
            **units,
        }
    )
    check = Verification.OFF if verify(chain) else Verification.STRICT
    return ScmAnswer.model_validate(
        {"scm": written, "base": base, "verify": check, **robot.names_and_limits, **units}
    )


def _moved(table: SymbolicTable, tool: Matrix | None) -> DescribedScm | None:
    """The chain entry by entry, with a tool in expressions as a last row; None where values are needed."""
    if tool is None:
        return scm_from_table(table)
    screw = x_screw(tool)
    if screw is None:
        return None
    converted = convert(table, Convention.STANDARD, tool=screw)
    rows = converted.table.rows if converted.tool is None else (*converted.table.rows, fixed_row(screw))
    moved = scm_from_table(replace(converted.table, rows=rows))
    return None if moved is None else replace(moved, base=converted.base)


def _placement(placement: Placement, writer: TableWriter) -> dict[str, WireCell]:
    """The entries that are not zero."""
    return {
        entry.value: writer.cell(
            placement.entry(entry), ParameterKind.ANGLE if entry.is_turn else ParameterKind.LENGTH
        )
        for entry in Entry
        if placement.entry(entry) != ZERO
    }


def _row(row: ChainRow, joint: int, writer: TableWriter) -> dict[str, WireCell]:
    cells = _placement(row.constant, writer)
    held = row.variable.value
    cells[held] = with_variable(row.sign, joint, cells.get(held, 0))
    return cells
