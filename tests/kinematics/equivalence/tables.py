"""Tables of well-known robots, as numbers."""

import math
from dataclasses import replace

from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable

HALF = math.pi / 2
R, P, F = JointType.REVOLUTE, JointType.PRISMATIC, JointType.FIXED

Row = tuple[JointType, float, float, float, float]


def table(convention: Convention, *rows: Row) -> NumericTable:
    """A table from rows (joint, alpha, a, d, theta)."""
    return DHTable(
        convention=convention,
        rows=tuple(DHRow(joint=j, alpha=al, a=a, d=d, theta=th) for j, al, a, d, th in rows),
    )


def standard(*rows: Row) -> NumericTable:
    return table(Convention.STANDARD, *rows)


def modified(*rows: Row) -> NumericTable:
    return table(Convention.MODIFIED, *rows)


def scaled(table: NumericTable, factor: float) -> NumericTable:
    """A table in another unit of length."""
    rows = tuple(replace(row, a=row.a * factor, d=row.d * factor) for row in table.rows)
    return DHTable(convention=table.convention, rows=rows)


A2, A3, D3, D4 = 0.4318, 0.0203, 0.15005, 0.4318

# DESIGN section 8; P. Corke, Robotics, Vision and Control, 2nd ed., table 7.1
PUMA = standard(
    (R, HALF, 0, 0, 0),
    (R, 0, A2, 0, 0),
    (R, -HALF, A3, D3, 0),
    (R, HALF, 0, D4, 0),
    (R, -HALF, 0, 0, 0),
    (R, 0, 0, 0, 0),
)

# J. J. Craig, Introduction to Robotics, 3rd ed., figure 3.21, with the signs of the axes above
PUMA_CRAIG = modified(
    (R, 0, 0, 0, 0),
    (R, HALF, 0, 0, 0),
    (R, 0, A2, D3, 0),
    (R, -HALF, A3, D4, 0),
    (R, HALF, 0, 0, 0),
    (R, -HALF, 0, 0, 0),
)

# seed 002: SCARA, modified
SCARA = modified((R, 0, 0, 0, 0), (R, 0, 0.3, 0, 0), (P, 0, 0.25, 0, 0), (R, 0, 0, 0, 0))

# DESIGN section 8: RX-90, Khalil and Dombre
RX90 = modified(
    (R, 0, 0, 0, 0),
    (R, HALF, 0, 0, 0),
    (R, 0, 0.45, 0, 0),
    (R, -HALF, 0, 0.45, 0),
    (R, HALF, 0, 0, 0),
    (R, -HALF, 0, 0, 0),
)


def changed(original: NumericTable, row: int, **cells: object) -> NumericTable:
    """The table with cells of a row (counted from 1) replaced."""
    rows = list(original.rows)
    rows[row - 1] = replace(rows[row - 1], **cells)  # type: ignore[arg-type]
    return DHTable(convention=original.convention, rows=tuple(rows))
