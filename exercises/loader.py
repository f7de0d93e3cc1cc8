"""From a folder to an exercise: exercise.toml and statement.<language>.md, every fault at once."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from types import MappingProxyType
from typing import Any

from exercises.consistency import FILE, inconsistencies
from exercises.definition import LANGUAGES, DrawnParameter, Exercise
from exercises.errors import DefinitionError, UnknownExerciseError
from exercises.figures.reading import read_figure
from exercises.grading import HelpLevel
from exercises.part_reading import read_draw, read_parts
from exercises.policy_reading import read_policy
from exercises.reading import Reader
from exercises.sample_reading import read_raw_table, read_samples
from exercises.selftest.mistakes import MISTAKES
from kinematics import catalogue
from kinematics.cells import AngleUnit, ReadTable, read_table
from kinematics.errors import Fault

ROOT = files("exercises") / "definitions"


_folders: list[Traversable] = [ROOT]


def use_folders(folders: Sequence[Path]) -> None:
    """Take exercises from further folders, too; one of them goes before a packaged one of its id.

    Raises:
        DefinitionError: a folder does not exist, or holds a malformed exercise; every fault.
    """
    missing = [
        Fault(code="folder_missing", params={"folder": str(folder)})
        for folder in folders
        if not folder.is_dir()
    ]
    if missing:
        raise DefinitionError(missing)
    _folders[:] = [*folders, ROOT]
    exercise_ids.cache_clear()
    exercise.cache_clear()
    faults: list[Fault] = []
    for exercise_id in exercise_ids():
        try:
            exercise(exercise_id)
        except DefinitionError as error:
            faults += error.faults
    if faults:
        raise DefinitionError(faults)


@cache
def exercise_ids() -> tuple[str, ...]:
    """Ids of all exercises, in alphabetical order."""
    found = (entry for folder in _folders for entry in folder.iterdir())
    return tuple(sorted({entry.name for entry in found if (entry / FILE).is_file()}))


@cache
def exercise(exercise_id: str) -> Exercise:
    """The exercise of that id.

    Raises:
        UnknownExerciseError: there is none.
        DefinitionError: its folder is malformed.
    """
    if exercise_id not in exercise_ids():
        known = ", ".join(exercise_ids())
        raise UnknownExerciseError(
            Fault(
                code="exercise_unknown",
                where=("exercise_id",),
                params={"id": exercise_id, "known": known},
            )
        )
    return load_exercise(next(f / exercise_id for f in _folders if (f / exercise_id / FILE).is_file()))


def load_exercise(folder: Traversable) -> Exercise:
    """The exercise in a folder.

    Args:
        folder: holds exercise.toml and one statement.<language>.md for each language; its name is the id.

    Raises:
        DefinitionError: every fault that was found, each at (file, key, …).
    """
    faults: list[Fault] = []
    document = _document(folder)
    statements = _statements(folder, faults)
    exercise = _exercise(folder.name, Reader(document, (FILE,), faults), statements)
    if exercise is not None and not faults:
        faults += inconsistencies(exercise)
    if faults or exercise is None:
        raise DefinitionError(fault.within(folder.name) for fault in faults)
    return exercise


def _document(folder: Traversable) -> Mapping[str, Any]:
    try:
        return tomllib.loads((folder / FILE).read_text(encoding="utf-8"))
    except FileNotFoundError:
        fault = Fault(code="exercise_file_missing", where=(folder.name, FILE))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        fault = Fault(
            code="exercise_file_not_toml",
            where=(folder.name, FILE),
            params={"reason": str(error)},
        )
    raise DefinitionError(fault)


def _statements(folder: Traversable, faults: list[Fault]) -> Mapping[str, str]:
    statements: dict[str, str] = {}
    for language in LANGUAGES:
        name = f"statement.{language}.md"
        file = folder / name
        text = file.read_text(encoding="utf-8").strip() if file.is_file() else ""
        if not text:
            faults.append(
                Fault(
                    code="statement_missing",
                    where=(name,),
                    params={"language": language},
                )
            )
        statements[language] = text
    return MappingProxyType(statements)


def _exercise(exercise_id: str, reader: Reader, statements: Mapping[str, str]) -> Exercise | None:
    robot = reader.text("robot", "") or None
    reference, values = _reference(reader, robot)
    version = reader.integer("version")
    titles = reader.table("title", needed=True)
    found_titles = {language: titles.text(language) for language in LANGUAGES}
    titles.finish()
    policy = read_policy(reader.table("policy"))
    help_table = reader.table("help")
    help_level = help_table.choice("most", HelpLevel, HelpLevel.REPAIR)
    help_table.finish()
    if reference is None:
        return None
    parameters = _parameters(reader, reference, values)
    types = reference.table.joint_types
    degrees = reference.angle_unit is AngleUnit.DEG
    limits = catalogue.robot(robot).limits if robot else None
    parts = read_parts(reader, types, degrees, limits)
    figure = read_figure(reader.table("figure"), types, degrees)
    tests = reader.table("tests")
    misconceptions = tests.texts("misconceptions", default=())
    for i, code in enumerate(misconceptions):
        if code not in MISTAKES:
            known = ", ".join(MISTAKES)
            tests.fault(
                "misconception_unknown",
                "misconceptions",
                i,
                name=code,
                known=known,
            )
    samples = read_samples(tests, reference)
    tests.finish()
    reader.finish()
    return Exercise(
        id=exercise_id,
        version=version,
        titles=MappingProxyType(found_titles),
        statements=statements,
        robot=robot,
        reference=reference,
        angle_unit=reference.angle_unit,
        length_unit=reference.length_unit,
        parameters=parameters,
        parts=parts,
        policy=policy,
        help=help_level,
        figure=figure,
        misconceptions=misconceptions,
        samples=samples,
    )


def _reference(reader: Reader, robot: str | None) -> tuple[ReadTable | None, Mapping[str, Fraction]]:
    """The key and the usual values of its parameters."""
    if robot is not None and reader.given("reference"):
        reader.fault("robot_and_reference", "reference")
    if robot is not None:
        if robot not in catalogue.robot_ids():
            ", ".join(catalogue.robot_ids())
            reader.fault(
                "exercise_robot_unknown",
                "robot",
                robot=robot,
            )
            return None, {}
        found = catalogue.robot(robot)
        return found.table, {name: Fraction(repr(value)) for name, value in found.parameters.items()}
    if not reader.given("reference"):
        reader.fault("exercise_key_missing", "robot")
        return None, {}
    inner = reader.table("reference")
    raw = read_raw_table(inner)
    inner.finish()
    return (inner.guarded(lambda: read_table(raw)) if raw is not None else None), {}


def _parameters(
    reader: Reader, reference: ReadTable, values: Mapping[str, Fraction]
) -> tuple[DrawnParameter, ...]:
    given: dict[str, DrawnParameter] = {}
    for name, inner in reader.tables("parameters"):
        spelled = inner.name(name)
        if spelled not in reference.parameters:
            ", ".join(reference.parameters) or "none"
            inner.fault("parameter_unused", name=name)
        default = values.get(spelled)
        value = inner.exact("value", *(() if default is None else (default,)))
        draw = read_draw(inner, "draw")
        given[spelled] = DrawnParameter(name=spelled, value=value, draw=draw)
        inner.finish()
    for name in reference.parameters:
        if name in given:
            continue
        if name in values:
            given[name] = DrawnParameter(name=name, value=values[name])
        else:
            reader.fault("parameter_missing", "parameters", name, name=name)
    return tuple(given[name] for name in reference.parameters if name in given)
