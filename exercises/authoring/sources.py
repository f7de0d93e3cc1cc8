"""What an exercise is started from, in one form: a DH table whose lengths have names and values."""

import json
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn

from exercises.authoring.axes_drawing import in_named_lengths, read_drawing
from exercises.authoring.named_tables import ExerciseSource, from_numeric_table, with_names
from exercises.definition_files import ENCODING
from exercises.errors import DefinitionError
from exercises.reading import Reader
from exercises.sample_reading import read_raw_table
from exercises.statements import LONGEST_TITLE, text_faults
from kinematics import catalogue
from kinematics.cells import AngleUnit, Cell, LengthUnit, ReadTable, read_table
from kinematics.errors import Fault, KinematicsError
from kinematics.keys import ValueKind
from kinematics.scm import modified_dh_from_scm
from kinematics.scm.chain_reading import ENTRIES, RawChain, read_chain
from kinematics.table import Convention
from kinematics.urdf import table_from_urdf


def read_source(document: Mapping[str, Any]) -> ExerciseSource:
    """Return what an exercise is to be about, from a document with one of the keys of `FORMS`.

    Raises:
        DefinitionError: every fault with its key.
    """
    faults: list[Fault] = []
    reader = Reader(document, ("source",), faults)
    given = [form for form in FORMS if reader.given(form)]
    reader.finish()
    if len(given) != 1:
        reader.fault("source_form", known=", ".join(FORMS))
    if faults:
        raise DefinitionError(faults)
    form = given[0]
    if form == "robot":
        name = reader.text(form)
        return from_robot(name) if not faults else _refuse(faults)
    if form == "urdf":
        text = reader.text(form)
        return from_urdf(text, "source") if not faults else _refuse(faults)
    inner = reader.table(form)
    if faults:
        raise DefinitionError(faults)
    return {"table": from_table, "axes": from_axes, "scm": from_scm}[form](inner)


FORMS = ("robot", "table", "axes", "scm", "urdf")  # From what an exercise is started.


def _refuse(faults: Sequence[Fault]) -> NoReturn:
    raise DefinitionError(faults)


def keys_of(path: Path) -> Reader:
    """Return what reads the keys of a file in JSON (a table as the API takes it) or TOML.

    Raises:
        DefinitionError: the file cannot be read.
    """
    try:
        text = path.read_text(encoding=ENCODING)
        document = json.loads(text) if path.suffix == ".json" else tomllib.loads(text)
    except (OSError, ValueError, RecursionError) as error:
        raise DefinitionError(_unreadable(path, getattr(error, "strerror", None) or str(error))) from error
    if not isinstance(document, dict):
        raise DefinitionError(_unreadable(path, "it holds no table of keys"))
    return Reader(document, (path.name,), [])


def from_table(reader: Reader) -> ExerciseSource:
    """Return a DH table, with the values of its parameters under `parameters`.

    Lengths that are plain numbers get the names of their columns, a2 or d4, so that the figure can show them.

    Raises:
        DefinitionError: every fault with its key.
    """
    parameters = reader.table("parameters").named_numbers()
    raw = read_raw_table(reader)
    reader.finish()
    read = reader.guarded(lambda: read_table(raw)) if raw is not None else None
    if read is not None:
        missing = [name for name in read.parameters if name not in parameters]
        for name in missing:
            reader.fault("parameter_missing", "parameters", name, name=name)
    if reader.faults or read is None:
        raise DefinitionError(reader.faults)
    return with_names(read, {name: parameters[name] for name in read.parameters})


def from_robot(robot_id: str) -> ExerciseSource:
    """Return a robot of the catalogue.

    Raises:
        DefinitionError: the catalogue holds no such robot.
    """
    if robot_id not in catalogue.robot_ids():
        known = ", ".join(catalogue.robot_ids())
        raise DefinitionError(Fault.at("exercise_robot_unknown", "robot", robot=robot_id[:100], known=known))
    found = catalogue.robot(robot_id)
    return ExerciseSource(table=found.raw, values=dict(found.parameters), robot=robot_id)


def from_axes(reader: Reader) -> ExerciseSource:
    """Return joint axes as they are drawn.

    `axes` with `joint`, `point` and `direction` each, `lengths` with values.

    Raises:
        DefinitionError: every fault with its key.
    """
    unit = reader.choice("length_unit", LengthUnit, LengthUnit.M)
    drawing = read_drawing(reader)
    reader.finish()
    table = None if reader.faults else reader.guarded(drawing.table, "axes")
    if table is None:
        raise DefinitionError(reader.faults)
    source = from_numeric_table(table, unit, in_named_lengths(drawing), drawing.lengths)
    return replace(source, axes=drawing.axes())


def from_scm(reader: Reader) -> ExerciseSource:
    """Return an SCM chain.

    `joints` with x, y, z, a, b, c each, `final` and `tool`, values under `parameters`.

    Raises:
        DefinitionError: every fault with its key.
    """
    parameters = reader.table("parameters").named_numbers()
    raw = RawChain(
        joints=tuple(_six(entry) for entry in reader.entries("joints")),
        final=_six(reader.table("final")),
        tool=_six(reader.table("tool")),
        angle_unit=reader.choice("angle_unit", AngleUnit, AngleUnit.DEG),
        length_unit=reader.choice("length_unit", LengthUnit, LengthUnit.M),
    )
    reader.finish()
    chain = None if reader.faults else reader.guarded(lambda: read_chain(raw))
    table = None if chain is None else reader.guarded(lambda: modified_dh_from_scm(chain.chain))
    if chain is not None:
        for name in chain.parameters:
            if name not in parameters:
                reader.fault("parameter_missing", "parameters", name, name=name)
    if chain is None or table is None or reader.faults:
        raise DefinitionError(reader.faults)
    read = ReadTable(
        table=table, angle_unit=chain.angle_unit, length_unit=chain.length_unit, parameters=chain.parameters
    )
    return with_names(read, {name: parameters[name] for name in chain.parameters})


def from_urdf_file(path: Path) -> ExerciseSource:
    """Return the one serial chain of a URDF file.

    Raises:
        DefinitionError: the file cannot be read, or its chain is none that a DH table can hold.
    """
    try:
        return from_urdf(path.read_text(encoding=ENCODING), path.name)
    except (OSError, UnicodeDecodeError) as error:
        raise DefinitionError(_unreadable(path, str(error))) from error


def from_urdf(text: str, where: str) -> ExerciseSource:
    """Return the one serial chain of a URDF description.

    Raises:
        DefinitionError: it is none, or its chain is none that a DH table can hold.
    """
    try:
        robot = table_from_urdf(text, Convention.MODIFIED)
    except KinematicsError as error:
        raise DefinitionError(fault.within(where) for fault in error.faults) from error
    name = robot.name.strip()
    is_title = name and not any(text_faults(name, LONGEST_TITLE))
    return replace(from_numeric_table(robot.table, LengthUnit.M), name=name if is_title else None)


def _six(reader: Reader) -> dict[str, Cell]:
    """The entries of a placement that are given."""
    found: dict[str, Cell] = {}
    for name in ENTRIES:
        if reader.given(name):
            value = reader.values[name]
            if isinstance(value, bool) or not isinstance(value, int | float | str):
                reader.mistyped(ValueKind.CELL, name)
            else:
                found[name] = value
    reader.finish()
    return found


def _unreadable(path: Path, reason: str) -> Fault:
    return Fault.at("source_unreadable", path.name, reason=reason)
