"""What an exercise is started from, in one form: a DH table whose lengths have names and values."""

from __future__ import annotations

import json
import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from exercises.errors import DefinitionError
from exercises.reading import Reader
from exercises.sample_reading import read_raw_table
from exercises.selftest.typed import typed
from kinematics import catalogue
from kinematics.cells import AngleUnit, LengthUnit, RawTable, ReadTable, read_table
from kinematics.errors import Fault, KinematicsError
from kinematics.expressions import Expression, Number, Parameter, multiply, pi_times, rational_value
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import JointAxis
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable, SymbolicRow
from kinematics.urdf import table_from_urdf

TINY = 1e-9
STEPS_OF_PI = 12


@dataclass(frozen=True, kw_only=True, slots=True)
class ExerciseSource:
    """What an exercise is about.

    Attributes:
        table: the key as it is typed; its lengths have names.
        values: the value of each name [the table's length unit].
        robot: id of the catalogue robot, if it is one; then table and values follow from it.
    """

    table: RawTable
    values: Mapping[str, float]
    robot: str | None = None


def from_table_file(path: Path) -> ExerciseSource:
    """A table in JSON (as the API takes it) or TOML, with the values of its parameters under `parameters`.

    Lengths that are plain numbers get the names of their columns, a2 or d4, so that the figure can show them.

    Raises:
        DefinitionError: the file cannot be read; every fault with its key.
    """
    document = _document(path)
    faults: list[Fault] = []
    reader = Reader(document, (path.name,), faults)
    parameters = {name: reader.table("parameters").number(name) for name in reader.table("parameters").values}
    raw = read_raw_table(reader)
    reader.finish()
    read = reader.guarded(lambda: read_table(raw)) if raw is not None else None
    if read is not None:
        missing = [name for name in read.parameters if name not in parameters]
        for name in missing:
            reader.fault("parameter_missing", "parameters", name, name=name)
    if faults or read is None:
        raise DefinitionError(faults)
    return _named(read, parameters)


def from_robot(robot_id: str) -> ExerciseSource:
    """A robot of the catalogue.

    Raises:
        DefinitionError: the catalogue holds no such robot.
    """
    if robot_id not in catalogue.robot_ids():
        ", ".join(catalogue.robot_ids())
        raise DefinitionError(
            Fault(
                code="exercise_robot_unknown",
                where=("robot",),
                params={"robot": robot_id},
            )
        )
    found = catalogue.robot(robot_id)
    return ExerciseSource(table=found.raw, values=found.parameters, robot=robot_id)


def from_axes_file(path: Path) -> ExerciseSource:
    """Joint axes in JSON or TOML: `axes` with `joint`, `point` and `direction` each.

    Raises:
        DefinitionError: the file cannot be read; every fault with its key.
    """
    document = _document(path)
    faults: list[Fault] = []
    reader = Reader(document, (path.name,), faults)
    unit = reader.choice("length_unit", LengthUnit, LengthUnit.M)
    axes = [
        JointAxis(
            joint=entry.choice("joint", JointType),
            point=_three(entry, "point"),
            direction=_three(entry, "direction"),
        )
        for entry in reader.entries("axes")
    ]
    reader.finish()
    if not axes:
        reader.fault("exercise_key_missing", "axes", key="axes")
    assigned = None if faults else reader.guarded(lambda: assign_frames(axes, Convention.MODIFIED), "axes")
    if assigned is None:
        raise DefinitionError(faults)
    return from_numeric_table(assigned.table, unit)


def from_urdf_file(path: Path) -> ExerciseSource:
    """The one serial chain of a URDF description.

    Raises:
        DefinitionError: the file cannot be read, or its chain is none that a DH table can hold.
    """
    try:
        robot = table_from_urdf(path.read_text(encoding="utf-8"), Convention.MODIFIED)
    except KinematicsError as error:
        raise DefinitionError(fault.within(path.name) for fault in error.faults) from error
    except (OSError, UnicodeDecodeError) as error:
        raise DefinitionError(_unreadable(path, str(error))) from error
    return from_numeric_table(robot.table, LengthUnit.M)


def from_numeric_table(table: NumericTable, unit: LengthUnit) -> ExerciseSource:
    """A table of numbers, in [rad] and a length unit; angles that are nearly nice become so."""
    rows = tuple(
        DHRow(
            joint=row.joint,
            theta=nice_angle(row.theta),
            d=nice_length(row.d),
            a=nice_length(row.a),
            alpha=nice_angle(row.alpha),
            sign=row.sign,
        )
        for row in table.rows
    )
    symbolic = DHTable(convention=table.convention, rows=rows)
    read = ReadTable(table=symbolic, angle_unit=AngleUnit.DEG, length_unit=unit, parameters={})
    return _named(read, {})


def nice_angle(angle: float) -> Expression:
    """A multiple of π/12 if the angle is one but for rounding, else degrees to four decimals [rad]."""
    steps = angle / math.pi * STEPS_OF_PI
    if abs(steps - round(steps)) < 1e-6:
        return pi_times(Fraction(round(steps), STEPS_OF_PI))
    return pi_times(Fraction(repr(round(math.degrees(angle), 4))) / 180)


def nice_length(length: float) -> Expression:
    """The length to six decimals."""
    return Number(Fraction(repr(round(length, 6))) if abs(length) > TINY else Fraction(0))


def _named(read: ReadTable, parameters: Mapping[str, float]) -> ExerciseSource:
    """The table with a name for every length that is a plain number."""
    values = dict(parameters)
    standard = read.table.convention is Convention.STANDARD
    rows: list[SymbolicRow] = []
    for i, row in enumerate(read.table.rows, 1):
        a = _name(row.a, f"a{i if standard else i - 1}", values)
        d = row.d if row.joint is JointType.PRISMATIC else _name(row.d, f"d{i}", values)
        rows.append(DHRow(joint=row.joint, theta=row.theta, d=d, a=a, alpha=row.alpha, sign=row.sign))
    table = DHTable(convention=read.table.convention, rows=tuple(rows))
    named = ReadTable(
        table=table, angle_unit=AngleUnit.DEG, length_unit=read.length_unit, parameters=read.parameters
    )
    return ExerciseSource(table=typed(named), values=values)


def _name(cell: Expression, name: str, values: dict[str, float]) -> Expression:
    value = rational_value(cell)
    if not value:
        return cell
    while name in values:
        name = f"L{len(values)}" if not name.startswith("L") else f"{name}0"
    values[name] = abs(float(value))
    return Parameter(name) if value > 0 else multiply((Number(Fraction(-1)), Parameter(name)))


def _three(reader: Reader, key: str) -> tuple[float, float, float]:
    entries = reader.exacts(key)
    if len(entries) != 3:
        reader.fault("exercise_value_type", key, key=key)
        return 0.0, 0.0, 1.0
    x, y, z = (float(entry) for entry in entries)
    return x, y, z


def _document(path: Path) -> dict[str, Any]:
    try:
        text = path.read_text(encoding="utf-8")
        document = json.loads(text) if path.suffix == ".json" else tomllib.loads(text)
    except (OSError, ValueError) as error:
        raise DefinitionError(_unreadable(path, str(error))) from error
    if not isinstance(document, dict):
        raise DefinitionError(_unreadable(path, "it holds no table of keys"))
    return document


def _unreadable(path: Path, reason: str) -> Fault:
    return Fault(code="source_unreadable", where=(path.name,), params={"reason": reason})
