"""A table and all that follows from it, as a student would hand it in."""

from __future__ import annotations

import numpy as np

from exercises.answers import RawAnswer, values_in_unit
from exercises.consistency import values_in_radians
from exercises.definition import PartKind, WorkspacePart
from exercises.grader import pose_joints
from exercises.grading.exact_text import angle_text, expression_text
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.matrix_cells import CellMatrix
from exercises.parts.schematic import schematic_of
from exercises.parts.workspace import workspace_of
from kinematics.cells import AngleUnit, Cell, RawRow, RawTable, ReadTable
from kinematics.expressions import ZERO
from kinematics.forward import forward_kinematics
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.symbolic import closed_form
from kinematics.table import JointType, SymbolicRow, bind

DECIMALS = 4


def typed(read: ReadTable) -> RawTable:
    """A table as it would be typed."""
    rows: list[RawRow] = []
    for i, row in enumerate(read.table.rows):
        number = read.table.joint_rows.index(i) + 1 if row.joint is not JointType.FIXED else 0
        rows.append(_typed_row(row, number, read.angle_unit))
    return RawTable(
        convention=read.table.convention,
        rows=tuple(rows),
        angle_unit=read.angle_unit,
        length_unit=read.length_unit,
    )


def answer_from(instance: Instance, read: ReadTable, kinds: set[PartKind]) -> RawAnswer:
    """A table with its link matrices, its ⁰T_N and its pose; structure and workspace are the robot's.

    Args:
        instance: the exercise with the student's values.
        read: the table, right or wrong.
        kinds: the parts that are handed in.
    """
    form = closed_form(read.table)
    printer = MatrixPrinter(
        n_joints=read.table.n_joints, parameters=tuple(read.parameters), notation=Notation.SHORT
    )
    purpose = Purpose(name="pose", meaning="The pose.")

    def text(matrix: object) -> CellMatrix:
        written: CellMatrix = printer.write(matrix, (Format.TEXT,), purpose)["text"]  # type: ignore[arg-type]
        return written

    context = _context(instance, read)
    return RawAnswer(
        table=typed(read),
        link_matrices=[text(link) for link in form.links] if PartKind.LINK_MATRICES in kinds else None,
        transform=text(form.transform) if PartKind.TRANSFORM in kinds else None,
        pose=_pose(instance, read) if PartKind.POSE in kinds else None,
        schematic=schematic_of(context.reference_numbers) if PartKind.SCHEMATIC in kinds else None,
        workspace=_workspace(instance, context) if PartKind.WORKSPACE in kinds else None,
    )


def _typed_row(row: SymbolicRow, number: int, unit: AngleUnit) -> RawRow:
    theta, d = angle_text(row.theta, unit), expression_text(row.d)
    if row.joint is JointType.REVOLUTE:
        theta = _with_variable(row.sign, number, theta, zero=row.theta == ZERO)
    if row.joint is JointType.PRISMATIC:
        d = _with_variable(row.sign, number, d, zero=row.d == ZERO)
    return RawRow(
        joint=row.joint, alpha=angle_text(row.alpha, unit), a=expression_text(row.a), d=d, theta=theta
    )


def _with_variable(sign: int, number: int, offset: str, *, zero: bool) -> str:
    variable = f"q{number}" if sign > 0 else f"-q{number}"
    if zero:
        return variable
    if offset.lstrip("-").replace(".", "").isalnum():
        return f"{variable} - {offset[1:]}" if offset.startswith("-") else f"{variable} + {offset}"
    return f"{variable} + ({offset})"


def _pose(instance: Instance, read: ReadTable) -> CellMatrix:
    values = values_in_radians(
        values_in_unit(instance, read.length_unit), instance.exercise.reference.parameters, read.angle_unit
    )
    joints = pose_joints(instance, read.length_unit)
    pose = forward_kinematics(bind(read.table, values), joints).transform
    rounded: CellMatrix = np.round(pose, DECIMALS).tolist()
    return rounded


def _workspace(instance: Instance, context: Context) -> dict[str, Cell]:
    part = instance.exercise.part(PartKind.WORKSPACE)
    assert isinstance(part, WorkspacePart)
    radii = workspace_of(context, part, instance.exercise.figure)
    ratio = context.unit_ratio
    return {"inner": radii.inner * ratio, "outer": radii.outer * ratio}


def _context(instance: Instance, read: ReadTable) -> Context:
    exercise = instance.exercise
    return Context(
        reference=exercise.reference,
        parameters=instance.parameters,
        policy=exercise.policy,
        help_level=exercise.help,
        own=None,
        own_correct=False,
        angle_unit=read.angle_unit,
        length_unit=read.length_unit,
    )
