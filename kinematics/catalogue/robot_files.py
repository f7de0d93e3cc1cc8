"""A catalogue file to a robot: every fault at once, each with the file and the path of the key."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from functools import partial
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from kinematics.catalogue.keys import FileKeys, fault, is_number, is_numbers
from kinematics.catalogue.robots import NamedConfiguration, ReferencePose, Robot, RobotSource, ScmDescription
from kinematics.cells import (
    AngleUnit,
    LengthUnit,
    ParameterKind,
    RawRow,
    RawTable,
    ReadTable,
    bind_parameters,
    read_cell,
    read_table,
)
from kinematics.errors import DescriptionError, Fault, KinematicsError
from kinematics.expressions import Expression
from kinematics.scm import RawChain, read_chain
from kinematics.se3 import check_transform
from kinematics.table import CELLS, Convention, JointType

Read = TypeVar("Read")
Limits = tuple[tuple[float, float], ...]

_PLACEMENT = "xyzabc"


def read_robot(robot_id: str, text: str) -> Robot:
    """The robot that a catalogue file describes.

    Args:
        robot_id: the file's name without its ending.
        text: the file's content.

    Raises:
        DescriptionError: every fault, each at (file name, key, …).
    """
    file = f"{robot_id}.toml"
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise DescriptionError(fault("catalogue_not_toml", file, reason=str(error))) from None
    faults: list[Fault] = []
    robot = _robot(robot_id, FileKeys(document, (file,), faults))
    if robot is None or faults:
        raise DescriptionError(faults)
    return robot


def _robot(robot_id: str, keys: FileKeys) -> Robot | None:
    name, source = keys.text("name"), _source(keys)
    raw = _raw_table(keys.table("table"))
    table = _tried(keys, ("table",), lambda: read_table(raw))
    parameters = _parameters(keys, table)
    n = table.table.n_joints if table else _stated_joints(raw)
    limits, limits_source = _limits(keys, n) if keys.holds("limits") else (None, None)
    configurations = _configurations(keys.table("configurations"), raw, n, limits)
    chain = _chain(keys.table("chain"), raw) if keys.holds("chain") else None
    reference = _reference(keys.table("reference"), n)
    keys.finish()
    if table is None or reference is None:
        return None
    return Robot(
        id=robot_id,
        name=name,
        source=source,
        raw=raw,
        table=table,
        parameters=parameters,
        configurations=configurations,
        limits=limits,
        limits_source=limits_source,
        chain=chain,
        reference=reference,
    )


def _source(keys: FileKeys) -> RobotSource:
    source = keys.table("source")
    read = RobotSource(
        document=source.text("document"), place=source.text("place"), figures=source.text("figures")
    )
    source.finish()
    return read


def _raw_table(keys: FileKeys) -> RawTable:
    convention = keys.choice("convention", Convention)
    angle_unit, length_unit = keys.choice("angle_unit", AngleUnit), keys.choice("length_unit", LengthUnit)
    rows = []
    for row in keys.tables("rows"):
        cells = {cell: row.cell(cell) for cell in CELLS}
        rows.append(RawRow(joint=row.choice("joint", JointType), **cells))
        row.finish()
    keys.finish()
    return RawTable(convention=convention, rows=tuple(rows), angle_unit=angle_unit, length_unit=length_unit)


def _stated_joints(raw: RawTable) -> int:
    return sum(row.joint is not JointType.FIXED for row in raw.rows)


def _parameters(keys: FileKeys, table: ReadTable | None) -> dict[str, float]:
    """The values by canonical name; a table without parameters needs no such key."""
    inner = keys.table("parameters") if keys.holds("parameters") else FileKeys({}, (), [])
    values = {name: inner.cell(name) for name in inner.values}
    if table is not None:
        _tried(keys, (), lambda: bind_parameters(table, values))
    return {name: float(value) for name, value in values.items() if is_number(value)}


def _limits(keys: FileKeys, n: int) -> tuple[Limits, str]:
    inner = keys.table("limits")
    pairs = inner.lists("joints", n, 2)
    source = inner.text("source")
    inner.finish()
    joints: list[tuple[float, float]] = []
    for i, pair in enumerate(pairs):
        if not is_numbers(pair, 2):
            expected = "a list of 2 finite numbers"
            keys.faults.append(
                fault("catalogue_value_type", *inner.where, "joints", i, key=str(i), expected=expected)
            )
        elif pair[0] >= pair[1]:
            keys.faults.append(fault("catalogue_limits_reversed", *inner.where, "joints", i, joint=i + 1))
        else:
            joints.append((float(pair[0]), float(pair[1])))
    return tuple(joints) if len(joints) == len(pairs) else (), source


def _configurations(
    keys: FileKeys, raw: RawTable, n: int, limits: Limits | None
) -> dict[str, NamedConfiguration]:
    found = {}
    for name in keys.values:
        inner = keys.table(name)
        joints = inner.numbers("joints", n)
        for i, ((low, high), q) in enumerate(zip(limits or (), joints, strict=False)):
            if not low <= q <= high:
                keys.faults.append(fault("catalogue_outside_limits", *inner.where, "joints", i, joint=i + 1))
        meaning = inner.text("meaning")
        position = _position(inner, raw)
        inner.finish()
        found[name] = NamedConfiguration(joints=joints, meaning=meaning, position=position)
    return found


def _position(keys: FileKeys, raw: RawTable) -> tuple[Expression, Expression, Expression] | None:
    cells = keys.cell("position")
    if not isinstance(cells, list) or len(cells) != 3:
        keys.faults.append(
            fault(
                "catalogue_value_type", *keys.where, "position", key="position", expected="a list of 3 cells"
            )
        )
        return None
    x, y, z = (
        _tried(
            keys, ("position", i), partial(read_cell, cell, ParameterKind.LENGTH, angle_unit=raw.angle_unit)
        )
        for i, cell in enumerate(cells)
    )
    return None if x is None or y is None or z is None else (x, y, z)


def _chain(keys: FileKeys, raw: RawTable) -> ScmDescription | None:
    rows = keys.lists("joints", None, 6)
    final = keys.cell("final")
    if not isinstance(final, list) or len(final) != 6:
        keys.faults.append(
            fault("catalogue_value_type", *keys.where, "final", key="final", expected="a list of 6 entries")
        )
        final = [0] * 6
    names = keys.table("parameters") if keys.holds("parameters") else FileKeys({}, (), [])
    renamed = {name: names.text(name) for name in names.values}
    keys.finish()
    chain = RawChain(
        joints=tuple(dict(zip(_PLACEMENT, row, strict=True)) for row in rows),
        final=dict(zip(_PLACEMENT, final, strict=True)),
        tool={},
        angle_unit=raw.angle_unit,
        length_unit=raw.length_unit,
    )
    read = _tried(keys, (), lambda: read_chain(chain))
    if read is None:
        return None
    parameters = {name: renamed.get(name, name) for name in read.parameters}
    return ScmDescription(raw=chain, read=read, parameters=parameters)


def _reference(keys: FileKeys, n: int) -> ReferencePose | None:
    derivation, joints = keys.text("derivation"), keys.numbers("joints", n)
    rows = keys.lists("transform", 4, 4)
    keys.finish()
    if not rows:
        return None
    transform = _tried(keys, ("transform",), lambda: check_transform(_matrix(rows)))
    if transform is None:
        return None
    return ReferencePose(derivation=derivation, joints=joints, transform=transform)


def _matrix(rows: list[list[Any]]) -> NDArray[Any]:
    numeric = all(is_numbers(row, 4) for row in rows)
    return np.array(rows, dtype=np.float64 if numeric else object)


def _tried(keys: FileKeys, where: tuple[str | int, ...], read: Callable[[], Read]) -> Read | None:
    """What is read, or None with the faults placed in the file."""
    try:
        return read()
    except KinematicsError as error:
        keys.faults += [found.within(*keys.where, *where) for found in error.faults]
        return None
