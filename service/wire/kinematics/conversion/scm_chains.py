"""SCM chains: SCM2DH of the toolbox, and the way back."""

from __future__ import annotations

from kinematics.cells import ParameterKind, ReadTable, parameter_values
from kinematics.expressions import ZERO
from kinematics.scm import (
    ChainRow,
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
from service.schemas.kinematics.conversion import ConvertRequest, ScmAnswer
from service.schemas.kinematics.scm import ScmChainModel, Verification
from service.settings import Settings
from service.wire.fault_pointers import traced
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.conversion.described import RobotDescription
from service.wire.kinematics.conversion.dh_tables import matrix_of_cells
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
    if request.parameters is not None:
        parameter_values(chain.parameters, chain.angle_unit, request.parameters)
    read = ReadTable(
        table=table,
        angle_unit=chain.angle_unit,
        length_unit=chain.length_unit,
        parameters=chain.parameters,
    )
    return RobotDescription(read=read, parameters=request.parameters)


def scm_answer(robot: RobotDescription, request: ConvertRequest) -> ScmAnswer:
    """Return the robot as an SCM chain: entry by entry, or in numbers where it has fixed rows.

    Raises:
        TableError: the table has no joints.
        ParameterError: a parameter has no value, and one is needed.
    """
    writer = TableWriter(
        angle_unit=robot.read.angle_unit, length_unit=robot.read.length_unit, spellings=robot.spellings
    )
    with traced(request):
        moved = scm_from_table(robot.read.table)
        chain = None if moved is None else with_tool(moved.chain, robot.tool)
        if moved is not None and chain is not None:
            base = matrix_of_cells(moved.base, robot, before=robot.base)
        else:
            table = robot_of(robot.read, robot.parameters or {}).table
            before, chain = scm_from_numbers(table, robot.base, robot.tool)
            base = plain_lists(before)
    units = {"angle_unit": robot.read.angle_unit.value, "length_unit": robot.read.length_unit.value}
    rows = [_row(row, i, writer) for i, row in enumerate(chain.rows, 1)]
    written = ScmChainModel.model_validate(
        {
            "joints": rows,
            "final": _placement(chain.final, writer),
            "tool": _placement(chain.tool, writer),
            **units,
        }
    )
    check = Verification.OFF if verify(chain) else Verification.STRICT
    return ScmAnswer.model_validate(
        {"scm": written, "base": base, "verify": check, **robot.names_and_limits, **units}
    )


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
    cells[held] = with_variable(f"{'-' if row.sign < 0 else ''}q{joint}", cells.get(held, 0))
    return cells
