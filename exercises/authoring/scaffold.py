"""The folder of a new exercise: it loads and passes its own tests, and is meant to be gone on from."""

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from exercises.authoring.draft import ExerciseDraft, check_id, files_of_draft
from exercises.authoring.named_tables import ExerciseSource
from exercises.errors import DefinitionError
from kinematics import catalogue
from kinematics.cells import AngleUnit, RawRow, RawTable, read_table
from kinematics.errors import Fault
from kinematics.table import CELLS, JointType

TITLES = {
    "en": "Robot {id}",
    "ro": "Robotul {id}",
    "pt": "Robô {id}",
    "fr": "Robot {id}",
    "uk": "Робот {id}",
    "es": "Robot {id}",
}
STATEMENTS = {
    "en": "The figure shows the joints of a robot, numbered from the base, and its dimensions{names}.",
    "ro": "Figura prezintă cuplele unui robot, numerotate de la bază, și cotele lui{names}.",
    "pt": "A figura mostra as juntas de um robô, numeradas a partir da base, e as suas dimensões{names}.",
    "fr": "La figure montre les articulations d’un robot, numérotées depuis la base, et ses cotes{names}.",
    "uk": "На рисунку показано зчленування робота, пронумеровані від основи, і його розміри{names}.",
    "es": "La figura muestra las articulaciones de un robot, numeradas desde la base, y sus dimensiones"
    "{names}.",
}
MISTAKES = (
    "convention",
    "columns_late",
    "columns_early",
    "alpha_value",
    "a_d_swapped",
    "a_value",
    "d_value",
    "joint_type",
    "rows_swapped",
    "row_missing",
    "row_extra",
)


RobotName = Callable[[str, str], str | None]
"""The name of a catalogue robot in a language, by language and id; None if it is that of the catalogue."""


def name_of_catalogue(language: str, robot_id: str) -> str:
    """Return the name of a catalogue robot, the same in every language."""
    return catalogue.robot(robot_id).name


def scaffold(
    exercise_id: str, source: ExerciseSource, into: Path, robot_name: RobotName = name_of_catalogue
) -> Path:
    """Write the folder of a new exercise.

    Its folder is made in `into`, and named by the id: letters, digits and hyphens.

    Returns:
        The new folder.

    Raises:
        DefinitionError: the id is no name of a folder, or the folder exists.
    """
    draft = started(exercise_id, source, robot_name)
    folder = into / exercise_id
    if folder.exists():
        raise DefinitionError(Fault.at("exercise_exists", id=exercise_id))
    folder.mkdir(parents=True)
    for name, content in files_of_draft(draft).items():
        (folder / name).write_bytes(content)
    return folder


def started(
    exercise_id: str, source: ExerciseSource, robot_name: RobotName = name_of_catalogue
) -> ExerciseDraft:
    """Return the draft of a new exercise: everything that has to be said, in words that may stay.

    Raises:
        DefinitionError: the id is no name of a folder.
    """
    check_id(exercise_id)
    types = read_table(source.table).table.joint_types
    names = ", ".join(f"*{name}*" for name in source.values)
    definition: dict[str, Any] = {
        "version": 1,
        **({"robot": source.robot} if source.robot else {}),
        "title": {
            language: source.name or text.format(id=exercise_id)
            if source.robot is None
            else robot_name(language, source.robot) or name_of_catalogue(language, source.robot)
            for language, text in TITLES.items()
        },
        **({} if source.robot else {"reference": _reference(source.table)}),
        "policy": {"tool": "axis"},
        "parameters": {
            name: _parameter(value, own=source.robot is None) for name, value in source.values.items()
        },
        "parts": _parts(types, source),
        "figure": {"posture": [0] * len(types), "view": {"azimuth": -60, "elevation": 24}},
        "tests": {"misconceptions": list(MISTAKES)},
    }
    if not source.values:
        del definition["parameters"]
    statements = {
        language: text.format(names=f" {names}" if names else "") for language, text in STATEMENTS.items()
    }
    return ExerciseDraft(id=exercise_id, definition=definition, statements=statements)


def _reference(table: RawTable) -> dict[str, Any]:
    return {
        "convention": table.convention.value,
        "angle_unit": table.angle_unit.value,
        "length_unit": table.length_unit.value,
        "rows": [_row(row) for row in table.rows],
    }


def _row(row: RawRow) -> dict[str, Any]:
    cells = {name: _cell(getattr(row, name)) for name in CELLS}
    return {**({"joint": row.joint.value} if row.joint else {}), **cells}


def _cell(cell: object) -> int | float | str:
    """Return a cell as a number if it is one."""
    text = str(cell)
    try:
        number = float(text)
    except ValueError:
        return text
    return int(number) if number.is_integer() else number


def _parameter(value: float, *, own: bool) -> dict[str, Any]:
    draw = dict(zip(("from", "to", "step"), map(_cell, nice_range(value)), strict=True))
    return {**({"value": _cell(value)} if own else {}), "draw": draw}


_LEAST_LENGTH = 1e-9  # Of a robot's, in any unit: what is shorter is drawn as zero would be.


def nice_range(value: float) -> tuple[str, str, str]:
    """Return four fifths to six fifths of a length in round steps, or about zero if it is as good as none."""
    size = abs(value) if abs(value) >= _LEAST_LENGTH else 1.0
    power = 10.0 ** math.floor(math.log10(size / 10))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= size / 20)
    digits = max(0, -math.floor(math.log10(step)))
    middle = round(value / step) * step
    return tuple(f"{number:.{digits}f}" for number in (middle - 3 * step, middle + 3 * step, step))  # type: ignore[return-value]


def _parts(types: tuple[JointType, ...], source: ExerciseSource) -> list[dict[str, Any]]:
    degrees = source.table.angle_unit is AngleUnit.DEG
    size = max((abs(value) for value in source.values.values()), default=1.0)
    turns = [30, 45, -60, 90, -30, 60]
    joints = [
        _cell(turns[i % len(turns)] if degrees else round(math.radians(turns[i % len(turns)]), 3))
        if joint_type is JointType.REVOLUTE
        else _cell(f"{size / 2:g}")
        for i, joint_type in enumerate(types)
    ]
    pose: dict[str, Any] = {"kind": "pose", "points": 15, "joints": joints}
    if JointType.PRISMATIC in types:
        pose["slides"] = _parameter(size / 2, own=False)["draw"]
    asked = (("table", 50), ("link_matrices", 20), ("transform", 15))
    return [*({"kind": kind, "points": points} for kind, points in asked), pose]
