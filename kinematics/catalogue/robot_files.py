"""A catalogue file to a robot: every fault at once, each with the file and the path of the key."""

import tomllib
from functools import partial
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from kinematics.catalogue.robots import (
    LinkWeights,
    NamedConfiguration,
    ReferencePose,
    Robot,
    RobotSource,
    ScmDescription,
)
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
from kinematics.dynamics import EARTH, bind_links, check_links
from kinematics.dynamics.reading import RawBody, read_bodies
from kinematics.errors import DescriptionError, Fault
from kinematics.expressions import Expression
from kinematics.keys import KeyFaults, KeyReader, ValueKind, are_numbers, is_number
from kinematics.scm import RawChain, read_chain
from kinematics.se3 import check_transform
from kinematics.table import CELLS, Convention, JointType

Limits = tuple[tuple[float, float], ...]

_PLACEMENT = "xyzabc"


class RobotKeys(KeyReader):
    """A table of keys of a robot's file."""

    codes: ClassVar[KeyFaults] = KeyFaults(
        missing="catalogue_key_missing",
        unknown="catalogue_key_unknown",
        mistyped="catalogue_value_type",
        unlisted="catalogue_value_type",
    )


def read_robot(robot_id: str, text: str) -> Robot:
    """Return the robot that a catalogue file describes.

    `robot_id` is the file's name without its ending.

    Raises:
        DescriptionError: every fault, each at (file name, key, …).
    """
    file = f"{robot_id}.toml"
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise DescriptionError(Fault.at("catalogue_not_toml", file, reason=str(error))) from None
    faults: list[Fault] = []
    robot = _robot(robot_id, RobotKeys(document, (file,), faults))
    if robot is None or faults:
        raise DescriptionError(faults)
    return robot


def _robot(robot_id: str, keys: RobotKeys) -> Robot | None:
    name, source = keys.text("name"), _source(keys)
    raw = _raw_table(keys.table("table", needed=True))
    table = keys.guarded(lambda: read_table(raw), "table")
    parameters = _parameters(keys, table)
    n = table.table.n_joints if table else sum(row.joint is not JointType.FIXED for row in raw.rows)
    limits, limits_source = _limits(keys, n) if keys.given("limits") else (None, None)
    configurations = _configurations(keys.table("configurations", needed=True), raw, n, limits)
    chain = _chain(keys.table("chain"), raw) if keys.given("chain") else None
    reference = _reference(keys.table("reference", needed=True), n)
    weights = _weights(keys.table("weights"), table) if keys.given("weights") else None
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
        weights=weights,
    )


def _source(keys: RobotKeys) -> RobotSource:
    source = keys.table("source", needed=True)
    read = RobotSource(
        document=source.text("document"), place=source.text("place"), figures=source.text("figures")
    )
    source.finish()
    return read


def _raw_table(keys: RobotKeys) -> RawTable:
    convention = keys.choice("convention", Convention)
    angle_unit, length_unit = keys.choice("angle_unit", AngleUnit), keys.choice("length_unit", LengthUnit)
    rows = []
    for row in keys.entries("rows", needed=True):
        rows.append(RawRow(joint=row.choice("joint", JointType), **{cell: row.cell(cell) for cell in CELLS}))
        row.finish()
    keys.finish()
    return RawTable(convention=convention, rows=tuple(rows), angle_unit=angle_unit, length_unit=length_unit)


def _parameters(keys: RobotKeys, table: ReadTable | None) -> dict[str, float]:
    """The values by canonical name; a table without parameters needs no such key."""
    inner = keys.table("parameters")
    values = {name: inner.cell(name) for name in inner.values}
    if table is not None:
        keys.guarded(lambda: bind_parameters(table, values))
    return {name: float(value) for name, value in values.items() if is_number(value)}


def _limits(keys: RobotKeys, n: int) -> tuple[Limits, str]:
    inner = keys.table("limits", needed=True)
    pairs = inner.rows("joints", n, 2)
    source = inner.text("source")
    inner.finish()
    joints: list[tuple[float, float]] = []
    for i, pair in enumerate(pairs):
        if not are_numbers(pair, 2):
            inner.mistyped(ValueKind.NUMBERS, "joints", i, count=2)
        elif pair[0] >= pair[1]:
            inner.fault("catalogue_limits_reversed", "joints", i, joint=i + 1)
        else:
            joints.append((float(pair[0]), float(pair[1])))
    return tuple(joints) if len(joints) == len(pairs) else (), source


def _configurations(
    keys: RobotKeys, raw: RawTable, n: int, limits: Limits | None
) -> dict[str, NamedConfiguration]:
    found = {}
    for name in keys.values:
        inner = keys.table(name)
        joints = inner.numbers("joints", n)
        for i, ((low, high), q) in enumerate(zip(limits or (), joints, strict=False)):
            if not low <= q <= high:
                inner.fault("catalogue_outside_limits", "joints", i, joint=i + 1)
        meaning = inner.text("meaning")
        position = _position(inner, raw)
        inner.finish()
        found[name] = NamedConfiguration(joints=joints, meaning=meaning, position=position)
    return found


def _position(keys: RobotKeys, raw: RawTable) -> tuple[Expression, Expression, Expression] | None:
    cells = keys.cell("position")
    if not isinstance(cells, list) or len(cells) != 3:
        keys.mistyped(ValueKind.CELLS, "position", count=3)
        return None
    x, y, z = (
        keys.guarded(partial(read_cell, cell, ParameterKind.LENGTH, angle_unit=raw.angle_unit), "position", i)
        for i, cell in enumerate(cells)
    )
    return None if x is None or y is None or z is None else (x, y, z)


def _chain(keys: RobotKeys, raw: RawTable) -> ScmDescription | None:
    rows = keys.rows("joints", None, 6)
    final = keys.cell("final")
    if not isinstance(final, list) or len(final) != 6:
        keys.mistyped(ValueKind.CELLS, "final", count=6)
        final = [0] * 6
    names = keys.table("parameters")
    renamed = {name: names.text(name) for name in names.values}
    keys.finish()
    chain = RawChain(
        joints=tuple(dict(zip(_PLACEMENT, row, strict=True)) for row in rows),
        final=dict(zip(_PLACEMENT, final, strict=True)),
        tool={},
        angle_unit=raw.angle_unit,
        length_unit=raw.length_unit,
    )
    read = keys.guarded(lambda: read_chain(chain))
    if read is None:
        return None
    parameters = {name: renamed.get(name, name) for name in read.parameters}
    return ScmDescription(raw=chain, read=read, parameters=parameters)


def _weights(keys: RobotKeys, table: ReadTable | None) -> LinkWeights:
    """The links' mass, centre and moments; products of inertia are zero where only moments are printed."""
    links = []
    for link in keys.entries("links", needed=True):
        xx, yy, zz = link.numbers("moments", 3) or (0.0,) * 3
        xy, yz, xz = link.numbers("products", 3) if link.given("products") else (0.0,) * 3
        links.append(
            RawBody(
                mass=link.number("mass"),
                centre=link.numbers("centre", 3),
                inertia=((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)),
            )
        )
        link.finish()
    source = keys.text("source")
    keys.finish()
    if table is not None:
        read = table
        keys.guarded(lambda: check_links(bind_links(read_bodies(read, links, EARTH).links, {})))
    return LinkWeights(links=tuple(links), source=source)


def _reference(keys: RobotKeys, n: int) -> ReferencePose | None:
    derivation, joints = keys.text("derivation"), keys.numbers("joints", n)
    rows = keys.rows("transform", 4, 4)
    keys.finish()
    if not rows:
        return None
    transform = keys.guarded(lambda: check_transform(_matrix(rows)), "transform")
    if transform is None:
        return None
    return ReferencePose(derivation=derivation, joints=joints, transform=transform)


def _matrix(rows: list[list[Any]]) -> NDArray[Any]:
    numeric = all(are_numbers(row, 4) for row in rows)
    return np.array(rows, dtype=np.float64 if numeric else object)
