"""A table as it would be typed."""

from exercises.grading.judging.exact_text import angle_text, expression_text
from kinematics.cells import AngleUnit, RawRow, RawTable, ReadTable
from kinematics.expressions import ZERO
from kinematics.table import JointType, SymbolicRow


def written_table(read: ReadTable) -> RawTable:
    """Return a table as it would be typed."""
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
