"""From a folder to an exercise: exercise.toml and statement.<language>.md, every fault at once."""

from collections.abc import Mapping
from dataclasses import fields, replace
from fractions import Fraction
from importlib.resources.abc import Traversable
from types import MappingProxyType
from typing import Any

from exercises.access import read_access
from exercises.consistency import FILE, inconsistencies
from exercises.definition import DrawnParameter, Exercise, Part
from exercises.definition_files import files_of_folder, read_definition, read_statements
from exercises.draws import read_draw
from exercises.errors import DefinitionError
from exercises.figures.figure_keys import read_figure
from exercises.figures.specification import FigureSpecification, PointInFrame
from exercises.grading import BaseRule, ConventionRule, DirectionRule, Policy, Tolerance, ToolRule, ZeroRule
from exercises.grading.facts import Weights
from exercises.parts.protocol import RobotFacts
from exercises.parts.registry import part_type, part_types
from exercises.reading import LONGEST_ECHO, Reader
from exercises.sample_reading import read_raw_table, read_samples
from exercises.selftest.mistakes import MISTAKES
from exercises.text_reading import checked_statements, read_remarks, read_titles
from kinematics import catalogue
from kinematics.cells import AngleUnit, ReadTable, read_table
from kinematics.errors import Fault
from kinematics.expressions import ZERO
from kinematics.keys import is_number


def load_exercise(folder: Traversable) -> Exercise:
    """Return the exercise in a folder.

    Args:
        folder: holds exercise.toml and a statement.<language>.md in one language or more; its name is the id.

    Raises:
        DefinitionError: every fault that was found, each at (folder, file, key, …).
    """
    return exercise_of_files(folder.name, files_of_folder(folder))


def exercise_of_files(exercise_id: str, files: Mapping[str, bytes], *, is_checked: bool = False) -> Exercise:
    """Return the exercise that the files of a folder describe.

    Args:
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
    """Return the exercise that a definition and its statements describe.

    Args:
        definition: the keys of exercise.toml.
        statements: in Markdown, by language.
        is_checked: whether its pieces are known to fit together.

    Raises:
        DefinitionError: every fault that was found, each at (file, key, …).
    """
    faults: list[Fault] = []
    written = checked_statements(statements, faults)
    exercise = _exercise(exercise_id, Reader(definition, (FILE,), faults), written)
    if exercise is not None and not faults and not is_checked:
        faults += inconsistencies(exercise)
    if faults or exercise is None:
        raise DefinitionError(faults)
    return exercise


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


def _needs(reader: Reader, names: Mapping[str, object]) -> tuple[str, ...]:
    """Return the dimensions that an answer must contain."""
    needs = reader.texts("needs", default=())
    for i, name in enumerate(needs):
        if name not in names:
            reader.fault("need_unknown", "needs", i, name=name[:LONGEST_ECHO], known=", ".join(names))
    return needs


def _exercise(exercise_id: str, reader: Reader, statements: Mapping[str, str]) -> Exercise | None:
    robot = reader.text("robot", "") or None
    reference, values = _reference(reader, robot)
    version = reader.count("version")
    titles = read_titles(reader, statements)
    policy = read_policy(reader.table("policy"))
    access = read_access(reader)
    weights = read_weights(reader.table("weights"))
    if reference is None:
        return None
    aliases = _aliases(reader, reference.parameters)
    needs = _needs(reader, reference.parameters)
    parameters = _parameters(reader, reference, values)
    facts = robot_facts(reference, robot)
    parts = _parts(reader, facts)
    figure = read_figure(reader.table("figure"), facts.joint_types, facts.degrees)
    figure = with_prescribed_points(figure, policy, len(reference.table.rows))
    remarks = read_remarks(reader)
    tests = reader.table("tests")
    misconceptions = tests.texts("misconceptions", default=())
    for i, code in enumerate(misconceptions):
        if code not in MISTAKES:
            tests.fault("misconception_unknown", "misconceptions", i, name=code, known=", ".join(MISTAKES))
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


def with_prescribed_points(figure: FigureSpecification, policy: Policy, last: int) -> FigureSpecification:
    """Mark the origins that a policy prescribes: O0, and the key's last one as P if no point is marked."""
    points, marks = dict(figure.points), figure.marks
    if policy.tool is ToolRule.POINT and not marks:
        points.setdefault("P", PointInFrame(frame=last, at=(ZERO, ZERO, ZERO)))
        marks = ("P",)
    if policy.base is BaseRule.ORIGIN and "O0" not in marks:
        marks = (*marks, "O0")
    return replace(figure, points=points, marks=marks)


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


def robot_facts(reference: ReadTable, robot: str | None) -> RobotFacts:
    """Return what the definitions of an exercise's parts are read beside: its key and its robot."""
    return RobotFacts(
        row_types=tuple(row.joint for row in reference.table.rows),
        degrees=reference.angle_unit is AngleUnit.DEG,
        limits=catalogue.robot(robot).limits if robot else None,
    )


def _parts(reader: Reader, robot: RobotFacts) -> tuple[Part, ...]:
    """Return what is asked."""
    parts: list[Part] = []
    for entry in reader.entries("parts"):
        kind = entry.text("kind")
        points = entry.exact("points")
        if points <= 0 and is_number(entry.values.get("points")):
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


MOST_WEIGHT = 100.0  # A weight beyond this leaves nothing to the other facts: a slip of the pen.


def read_policy(reader: Reader) -> Policy:
    """Return what a table is held to; faults go to the reader."""
    inner = reader.table("tolerance")
    usual = Tolerance()
    tolerance = Tolerance(
        length=inner.tolerance("length", usual.length), angle=inner.tolerance("angle", usual.angle)
    )
    inner.finish()
    policy = Policy(
        convention=reader.choice("convention", ConventionRule, ConventionRule.ANY),
        base=reader.choice("base", BaseRule, BaseRule.FREE),
        tool=reader.choice("tool", ToolRule, ToolRule.AXIS),
        zero=reader.choice("zero", ZeroRule, ZeroRule.FREE),
        direction=reader.choice("direction", DirectionRule, DirectionRule.FREE),
        tolerance=tolerance,
    )
    reader.finish()
    return policy


def read_weights(reader: Reader) -> Weights:
    """Return what facts and slips are worth in a wrong table; faults go to the reader."""
    usual = Weights()
    given = {entry.name: reader.number(entry.name, getattr(usual, entry.name)) for entry in fields(usual)}
    for name, value in given.items():
        most = 1.0 if name == "sign" else MOST_WEIGHT  # sign is a share of the others
        if not 0.0 <= value <= most:
            reader.fault("weight_out_of_range", name, name=name, most=most)
    reader.finish()
    return Weights(**given)
