"""Numeric tables written out as a person would hand them in."""

import math
from collections.abc import Callable

from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable, ReadTable, read_table
from kinematics.table import Convention, JointType, NumericTable

Cell = int | float | str


def read(
    convention: str,
    rows: list[tuple[Cell, Cell, Cell, Cell]],
    angle_unit: str = "rad",
    length_unit: str = "m",
) -> ReadTable:
    """A table from its cells, in the order alpha, a, d, theta."""
    return read_table(
        RawTable(
            convention=Convention(convention),
            rows=tuple(RawRow(alpha=alpha, a=a, d=d, theta=theta) for alpha, a, d, theta in rows),
            angle_unit=AngleUnit(angle_unit),
            length_unit=LengthUnit(length_unit),
        )
    )


def written(
    table: NumericTable, angle_unit: AngleUnit = AngleUnit.RAD, length_unit: LengthUnit = LengthUnit.M
) -> ReadTable:
    """A numeric table (lengths in metres) with its entries as typed numbers of the given units."""
    angle: Callable[[float], float] = math.degrees if angle_unit is AngleUnit.DEG else float
    scale = float(1 / length_unit.metres_per_unit)
    rows = []
    joint = 0
    for row in table.rows:
        theta: Cell = angle(row.theta)
        d: Cell = row.d * scale
        if row.joint is not JointType.FIXED:
            joint += 1
            variable = f"{'-' if row.sign < 0 else ''}q{joint}"
            if row.joint is JointType.REVOLUTE:
                theta = f"{variable}{theta:+.17g}"
            else:
                d = f"{variable}{d:+.17g}"
        rows.append(RawRow(joint=row.joint, alpha=angle(row.alpha), a=row.a * scale, d=d, theta=theta))
    raw = RawTable(
        convention=table.convention, rows=tuple(rows), angle_unit=angle_unit, length_unit=length_unit
    )
    return read_table(raw)
