"""A DH table whose lengths have names and values, from one in numbers."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from exercises.written_table import written_table
from kinematics.angles import nearest_twelfth
from kinematics.cells import AngleUnit, LengthUnit, ParameterKind, RawTable, ReadTable
from kinematics.expressions import (
    Expression,
    Number,
    Parameter,
    multiply,
    parameters_in,
    pi_times,
    rational_value,
)
from kinematics.frames.axes import JointAxis
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable, SymbolicRow

TINY = 1e-9  # Lengths below it [m] are rounding of zero.


@dataclass(frozen=True, kw_only=True, slots=True)
class ExerciseSource:
    """What an exercise is about.

    Attributes:
        table: the key as it is typed; its lengths have names.
        values: the value of each name [the table's length unit].
        robot: id of the catalogue robot, if it is one; then table and values follow from it.
        axes: the joint axes in space, where they were drawn.
        name: what its file calls the robot.
    """

    table: RawTable
    values: Mapping[str, float]
    robot: str | None = None
    axes: tuple[JointAxis, ...] = ()
    name: str | None = None


def from_numeric_table(
    table: NumericTable,
    unit: LengthUnit,
    named: Mapping[tuple[int, str], Expression] | None = None,
    lengths: Mapping[str, float] | None = None,
) -> ExerciseSource:
    """Return a table of numbers, in [rad] and a length unit; angles that are nearly nice become so.

    Args:
        table: the numbers.
        unit: of its lengths.
        named: what is written in names instead, by row and cell.
        lengths: values of these names.
    """
    written = named or {}
    rows = tuple(
        DHRow(
            joint=row.joint,
            theta=nice_angle(row.theta),
            d=written.get((i, "d")) or nice_length(row.d),
            a=written.get((i, "a")) or nice_length(row.a),
            alpha=nice_angle(row.alpha),
            sign=row.sign,
        )
        for i, row in enumerate(table.rows)
    )
    symbolic = DHTable(convention=table.convention, rows=rows)
    used = {name for entry in written.values() for name in parameters_in(entry)}
    values = {name: value for name, value in (lengths or {}).items() if name in used}
    kinds = dict.fromkeys(values, ParameterKind.LENGTH)
    read = ReadTable(table=symbolic, angle_unit=AngleUnit.DEG, length_unit=unit, parameters=kinds)
    return with_names(read, values)


def nice_angle(angle: float) -> Expression:
    """Return a multiple of π/12 if the angle is one but for rounding, else degrees to four decimals [rad]."""
    k = nearest_twelfth(angle, 1e-6)
    return pi_times(Fraction(repr(round(math.degrees(angle), 4))) / 180 if k is None else Fraction(k, 12))


def nice_length(length: float) -> Expression:
    """Return the length to six decimals."""
    return Number(Fraction(repr(round(length, 6))) if abs(length) > TINY else Fraction(0))


def with_names(read: ReadTable, parameters: Mapping[str, float]) -> ExerciseSource:
    """Return a table with a name for every length that is a plain number.

    Args:
        parameters: the values of the names that stand in it already.
    """
    values = dict(parameters)
    standard = read.table.convention is Convention.STANDARD
    rows: list[SymbolicRow] = []
    for i, row in enumerate(read.table.rows, 1):
        a = _name(row.a, f"a{i if standard else i - 1}", values)
        d = row.d if row.joint is JointType.PRISMATIC else _name(row.d, f"d{i}", values)
        rows.append(DHRow(joint=row.joint, theta=row.theta, d=d, a=a, alpha=row.alpha, sign=row.sign))
    table = DHTable(convention=read.table.convention, rows=tuple(rows))
    angles = any(kind is ParameterKind.ANGLE for kind in read.parameters.values())
    named = ReadTable(
        table=table,
        angle_unit=read.angle_unit if angles else AngleUnit.DEG,
        length_unit=read.length_unit,
        parameters={**read.parameters, **dict.fromkeys(values, ParameterKind.LENGTH)},
    )
    return ExerciseSource(table=written_table(named), values=values)


def _name(cell: Expression, name: str, values: dict[str, float]) -> Expression:
    value = rational_value(cell)
    if not value:
        return cell
    while name in values:
        name = f"L{len(values)}" if not name.startswith("L") else f"{name}0"
    values[name] = abs(float(value))
    return Parameter(name) if value > 0 else multiply((Number(Fraction(-1)), Parameter(name)))
