"""From a folder to an exercise: exercise.toml and statement.<language>.md, every fault at once."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from types import MappingProxyType
from typing import Any

from exercises.access import read_access
from exercises.consistency import FILE, inconsistencies
from exercises.definition import LANGUAGES, DrawnParameter, Exercise, Part
from exercises.definition_files import (
    STATEMENT,
    files_of_folder,
    read_definition,
    read_statements,
    statement_file,
)
from exercises.draws import read_draw
from exercises.errors import DefinitionError, UnknownExerciseError
from exercises.figures.figure_keys import read_figure
from exercises.grading.misconceptions import repair_codes
from exercises.parts.protocol import RobotFacts
from exercises.parts.registry import part_type, part_types
from exercises.policy_reading import read_policy, read_weights
from exercises.reading import Reader
from exercises.sample_reading import read_raw_table, read_samples
from exercises.selftest.mistakes import MISTAKES
from exercises.statements import LONGEST_STATEMENT, LONGEST_TITLE, text_faults
from kinematics import catalogue
from kinematics.cells import AngleUnit, ReadTable, read_table
from kinematics.errors import Fault

ROOT = files("exercises") / "definitions"

_LANGUAGE = re.compile(r"[a-z]{2}")


Shelf = Callable[[str], Exercise | None]
"""Where exercises are that stand in no folder, by an id that nobody finds in a list."""


class Library:
    """The exercises of some folders and of the package; each is read once.

    One of your own goes before a packaged one of its id. What stands in no folder may be on the shelf.
    """

    def __init__(self, folders: Sequence[Path] = (), shelf: Shelf | None = None) -> None:
        self._shelf = shelf
        self._folders: tuple[Traversable, ...] = (*folders, ROOT)
        self._read: dict[str, Exercise] = {}
        self._files: dict[str, Mapping[str, bytes]] = {}
        missing = [folder for folder in folders if not folder.is_dir()]
        if missing:
            raise DefinitionError(Fault(code="folder_missing", params={"folder": str(f)}) for f in missing)
        found = (entry for folder in self._folders for entry in folder.iterdir())
        self.ids: tuple[str, ...] = tuple(sorted({e.name for e in found if (e / FILE).is_file()}))

    def exercise(self, exercise_id: str) -> Exercise:
        """Return the exercise of that id.

        Raises:
            UnknownExerciseError: there is none.
            DefinitionError: its folder is malformed.
        """
        if exercise_id not in self._read:
            if exercise_id not in self.ids:
                kept = self._shelf(exercise_id) if self._shelf is not None else None
                if kept is not None:
                    return kept
                raise UnknownExerciseError(
                    Fault(
                        code="exercise_unknown",
                        where=("exercise_id",),
                        params={"id": exercise_id, "known": ", ".join(self.ids)},
                    )
                )
            holding = self._holding(exercise_id)
            found = files_of_folder(holding / exercise_id)
            # packaged ones are checked by the tests: to do so again takes half of the time of reading all
            exercise = exercise_of_files(exercise_id, found, is_checked=holding is ROOT)
            self._files[exercise_id] = found
            self._read.setdefault(exercise_id, exercise)  # another thread may have read it meanwhile
        return self._read[exercise_id]

    def files(self, exercise_id: str) -> Mapping[str, bytes] | None:
        """Return the files that an exercise was read from; None where it stands in no folder.

        Raises:
            UnknownExerciseError: there is no such exercise.
            DefinitionError: its folder is malformed.
        """
        self.exercise(exercise_id)
        return self._files.get(exercise_id)

    def read_own(self) -> None:
        """Read every exercise of the folders now; the packaged ones are known to be well-formed.

        Raises:
            DefinitionError: some are malformed; every fault of every folder.
        """
        faults: list[Fault] = []
        for exercise_id in self.ids:
            try:
                if self._holding(exercise_id) is not ROOT:
                    self.exercise(exercise_id)
            except DefinitionError as error:
                faults += error.faults
        if faults:
            raise DefinitionError(faults)

    def _holding(self, exercise_id: str) -> Traversable:
        """Return the first folder that has the exercise."""
        return next(folder for folder in self._folders if (folder / exercise_id / FILE).is_file())


@cache
def packaged() -> Library:
    """Return the exercises that come with the package."""
    return Library()


def load_exercise(folder: Traversable) -> Exercise:
    """The exercise in a folder.

    Args:
        folder: holds exercise.toml and a statement.<language>.md in one language or more; its name is the id.

    Raises:
        DefinitionError: every fault that was found, each at (folder, file, key, …).
    """
    return exercise_of_files(folder.name, files_of_folder(folder))


def exercise_of_files(exercise_id: str, files: Mapping[str, bytes], *, is_checked: bool = False) -> Exercise:
    """The exercise that the files of a folder describe.

    Args:
        exercise_id: names it.
        files: by their names.
        is_checked: whether its pieces are known to fit together, so that only their form is looked at.

    Raises:
        DefinitionError: every fault that was found, each at (folder, file, key, …).
    """
    try:
        definition, statements = read_definition(files), read_statements(files)
        return read_exercise(exercise_id, definition, statements, is_checked=is_checked)
    except DefinitionError as error:
        raise DefinitionError(fault.within(exercise_id) for fault in error.faults) from error


def read_exercise(
    exercise_id: str,
    definition: Mapping[str, Any],
    statements: Mapping[str, str],
    *,
    is_checked: bool = False,
) -> Exercise:
    """The exercise that a definition and its statements describe.

    Args:
        exercise_id: names it.
        definition: the keys of exercise.toml.
        statements: in Markdown, by language.
        is_checked: whether its pieces are known to fit together.

    Raises:
        DefinitionError: every fault that was found, each at (file, key, …).
    """
    faults: list[Fault] = []
    written = _statements(statements, faults)
    exercise = _exercise(exercise_id, Reader(definition, (FILE,), faults), written)
    if exercise is not None and not faults and not is_checked:
        faults += inconsistencies(exercise)
    if faults or exercise is None:
        raise DefinitionError(faults)
    return exercise


def _statements(statements: Mapping[str, str], faults: list[Fault]) -> Mapping[str, str]:
    """Return the statements by language; one is enough."""
    for language, text in statements.items():
        name = statement_file(language)
        if not STATEMENT.fullmatch(name):
            faults.append(
                Fault(
                    code="exercise_key_unknown",
                    where=(name,),
                    params={"key": language, "known": ", ".join(LANGUAGES)},
                )
            )
        elif not text.strip():
            faults.append(Fault(code="statement_missing", where=(name,), params={"language": language}))
        else:
            faults += (fault.within(name) for fault in text_faults(text, LONGEST_STATEMENT))
    if not statements:
        first = LANGUAGES[0]
        where = (statement_file(first),)
        faults.append(Fault(code="statement_missing", where=where, params={"language": first}))
    return MappingProxyType(dict(statements))


def _titles(reader: Reader, statements: Mapping[str, str]) -> Mapping[str, str]:
    """Return the titles by language; one is needed of which there is a statement, too."""
    inner = reader.table("title", needed=True)
    titles = {language: inner.text(language) for language in inner.values}
    for language, title in titles.items():
        inner.faults.extend(
            fault.within(*inner.where, language) for fault in text_faults(title, LONGEST_TITLE)
        )
        if _LANGUAGE.fullmatch(language) is None:
            inner.fault("exercise_key_unknown", language, key=language, known=", ".join(LANGUAGES))
    if reader.given("title") and statements and not titles.keys() & statements.keys():
        reader.fault("title_missing", "title")
    return MappingProxyType(titles)


def _aliases(reader: Reader, names: Mapping[str, object]) -> Mapping[str, str]:
    """Return the other names that students may use."""
    aliases: dict[str, str] = {}
    for name, inner in reader.tables("parameters"):
        for i, text in enumerate(inner.texts("aliases", default=())):
            alias = inner.name(text, "aliases", i)
            if alias in names or alias in aliases:
                inner.fault("alias_taken", "aliases", i, name=alias)
            aliases[alias] = inner.name(name)
    return MappingProxyType(aliases)


def _remarks(reader: Reader) -> Mapping[str, Mapping[str, str]]:
    """Return the lecturer's own words on misconceptions."""
    remarks: dict[str, Mapping[str, str]] = {}
    for code, inner in reader.tables("remarks"):
        if code not in repair_codes():
            inner.fault("misconception_unknown", name=code, known=", ".join(sorted(repair_codes())))
        if not inner.values:
            inner.missing(LANGUAGES[0])
        remarks[code] = MappingProxyType({language: inner.text(language) for language in inner.values})
        for language, text in remarks[code].items():
            if _LANGUAGE.fullmatch(language) is None:
                inner.fault("exercise_key_unknown", language, key=language, known=", ".join(LANGUAGES))
            found = text_faults(text, LONGEST_STATEMENT)
            inner.faults.extend(fault.within(*inner.where, language) for fault in found)
    return MappingProxyType(remarks)


def _needs(reader: Reader, names: Mapping[str, object]) -> tuple[str, ...]:
    """Return the dimensions that an answer must contain."""
    needs = reader.texts("needs", default=())
    for i, name in enumerate(needs):
        if name not in names:
            reader.fault("need_unknown", "needs", i, name=name, known=", ".join(names))
    return needs


def _exercise(exercise_id: str, reader: Reader, statements: Mapping[str, str]) -> Exercise | None:
    robot = reader.text("robot", "") or None
    reference, values = _reference(reader, robot)
    version = reader.integer("version")
    titles = _titles(reader, statements)
    policy = read_policy(reader.table("policy"))
    access = read_access(reader)
    weights = read_weights(reader.table("weights"))
    if reference is None:
        return None
    aliases = _aliases(reader, reference.parameters)
    needs = _needs(reader, reference.parameters)
    parameters = _parameters(reader, reference, values)
    facts = _robot_facts(reference, robot)
    parts = _parts(reader, facts)
    figure = read_figure(reader.table("figure"), facts.joint_types, facts.degrees)
    remarks = _remarks(reader)
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
        titles=titles,
        statements=statements,
        robot=robot,
        reference=reference,
        angle_unit=reference.angle_unit,
        length_unit=reference.length_unit,
        parameters=parameters,
        parts=parts,
        policy=policy,
        access=access,
        figure=figure,
        misconceptions=misconceptions,
        samples=samples,
        needs=needs,
        weights=weights,
        aliases=aliases,
        remarks=remarks,
    )


def _reference(reader: Reader, robot: str | None) -> tuple[ReadTable | None, Mapping[str, Fraction]]:
    """The key and the usual values of its parameters."""
    if robot is not None and reader.given("reference"):
        reader.fault("robot_and_reference", "reference")
    if robot is not None:
        if robot not in catalogue.robot_ids():
            known = ", ".join(catalogue.robot_ids())
            reader.fault("exercise_robot_unknown", "robot", robot=robot, known=known)
            return None, {}
        found = catalogue.robot(robot)
        return found.table, {name: Fraction(repr(value)) for name, value in found.parameters.items()}
    if not reader.given("reference"):
        reader.missing("robot")
        return None, {}
    inner = reader.table("reference")
    raw = read_raw_table(inner)
    inner.finish()
    if raw is None:
        return None, {}
    return inner.guarded(lambda: replace(read_table(raw), last_places={})), {}  # a key is exact


def robot_facts(exercise: Exercise) -> RobotFacts:
    """Return what the definitions of an exercise's parts are read beside."""
    return _robot_facts(exercise.reference, exercise.robot)


def _robot_facts(reference: ReadTable, robot: str | None) -> RobotFacts:
    return RobotFacts(
        joint_types=reference.table.joint_types,
        degrees=reference.angle_unit is AngleUnit.DEG,
        limits=catalogue.robot(robot).limits if robot else None,
    )


def _parts(reader: Reader, robot: RobotFacts) -> tuple[Part, ...]:
    """Return what is asked."""
    parts: list[Part] = []
    for entry in reader.entries("parts"):
        kind = entry.text("kind")
        points = entry.exact("points")
        if points <= 0:
            entry.fault("points_not_positive", "points")
        if any(part.kind == kind for part in parts):
            entry.fault("part_twice", "kind", kind=kind)
        if kind in part_types():
            parts.append(part_type(kind).define(entry, points, robot))
        elif entry.given("kind"):
            entry.fault("exercise_value_unknown", "kind", key="kind", known=", ".join(part_types()))
        entry.finish()
    if not reader.values.get("parts"):
        reader.fault("nothing_asked", "parts")
    return tuple(parts)


def _parameters(
    reader: Reader, reference: ReadTable, values: Mapping[str, Fraction]
) -> tuple[DrawnParameter, ...]:
    given: dict[str, DrawnParameter] = {}
    for name, inner in reader.tables("parameters"):
        spelled = inner.name(name)
        if spelled not in reference.parameters:
            inner.fault("parameter_unused", name=name)
        default = values.get(spelled)
        value = inner.exact("value", *(() if default is None else (default,)))
        draw = read_draw(inner, "draw")
        inner.given("aliases")
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
