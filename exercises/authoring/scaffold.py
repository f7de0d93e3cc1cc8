"""The folder of a new exercise: it loads and passes its own tests, and is meant to be gone on from."""

from __future__ import annotations

import math
from pathlib import Path

from exercises.authoring.sources import ExerciseSource
from exercises.consistency import FILE
from exercises.definition import LANGUAGES
from exercises.errors import DefinitionError
from kinematics.cells import AngleUnit, RawRow, read_table
from kinematics.errors import Fault
from kinematics.table import JointType

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
    "fr": "La figure montre les articulations d'un robot, numérotées depuis la base, et ses dimensions"
    "{names}.",
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


def scaffold(exercise_id: str, source: ExerciseSource, into: Path) -> Path:
    """Write the folder of a new exercise.

    Args:
        exercise_id: its id; letters, digits and hyphens.
        source: what it is about.
        into: the folder of exercises in which its own is made.

    Returns:
        The new folder.

    Raises:
        DefinitionError: the id is no name of a folder, or the folder exists.
    """
    if not exercise_id or not all(part.isalnum() for part in exercise_id.split("-")):
        raise DefinitionError(
            Fault(
                code="exercise_id_invalid",
                params={"id": exercise_id},
            )
        )
    folder = into / exercise_id
    if folder.exists():
        raise DefinitionError(Fault(code="exercise_exists", params={"id": exercise_id}))
    folder.mkdir(parents=True)
    (folder / FILE).write_text(definition_text(exercise_id, source), encoding="utf-8")
    names = ", ".join(f"*{name}*" for name in source.values)
    for language in LANGUAGES:
        text = STATEMENTS[language].format(names=f" {names}" if names else "")
        (folder / f"statement.{language}.md").write_text(f"{text}\n", encoding="utf-8")
    return folder


def definition_text(exercise_id: str, source: ExerciseSource) -> str:
    """The text of exercise.toml: everything that has to be said, with what may be said as comments."""
    types = read_table(source.table).table.joint_types
    blocks = [
        "# See docs/authoring.md for every key.\nversion = 1",
        f'robot = "{source.robot}"' if source.robot else "",
        "[title]\n" + "\n".join(f'{k} = "{v.format(id=exercise_id)}"' for k, v in TITLES.items()),
        "" if source.robot else _table(source),
        '[policy]\ntool = "axis"',
        "\n".join(_parameter(name, value, source.robot) for name, value in source.values.items()),
        *_parts(types, source),
        "# The figure follows from the table; docs/authoring.md tells how to draw it more finely.\n"
        f"[figure]\nposture = {[0] * len(types)}\nview = {{ azimuth = -60, elevation = 24 }}",
        "[tests]\nmisconceptions = [\n" + "".join(f'  "{code}",\n' for code in MISTAKES) + "]",
    ]
    return "\n\n".join(block for block in blocks if block) + "\n"


def _table(source: ExerciseSource) -> str:
    table = source.table
    rows = "".join(f"  {_row(row)},\n" for row in table.rows)
    return (
        f'[reference]\nconvention = "{table.convention}"\nangle_unit = "{table.angle_unit}"\n'
        f'length_unit = "{table.length_unit}"\nrows = [\n{rows}]'
    )


def _row(row: RawRow) -> str:
    cells = {name: getattr(row, name) for name in ("alpha", "a", "d", "theta")}
    written = ", ".join(f"{name} = {_cell(cell)}" for name, cell in cells.items())
    return f'{{ joint = "{row.joint}", {written} }}' if row.joint else f"{{ {written} }}"


def _cell(cell: object) -> str:
    text = str(cell)
    try:
        float(text)
    except ValueError:
        escaped = text.replace("\\", "\\\\").replace('"', '\\"')
        return f'"{escaped}"'
    return text


def _parameter(name: str, value: float, robot: str | None) -> str:
    start, stop, step = nice_range(value)
    own = "" if robot else f"value = {value:g}\n"
    return f"[parameters.{name}]\n{own}draw = {{ from = {start}, to = {stop}, step = {step} }}"


def nice_range(value: float) -> tuple[str, str, str]:
    """About four fifths to six fifths of a length, in round steps."""
    size = abs(value) or 1.0
    power = 10.0 ** math.floor(math.log10(size / 10))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= size / 20)
    digits = max(0, -math.floor(math.log10(step)))
    middle = round(value / step) * step
    return tuple(f"{number:.{digits}f}" for number in (middle - 3 * step, middle + 3 * step, step))  # type: ignore[return-value]


def _parts(types: tuple[JointType, ...], source: ExerciseSource) -> list[str]:
    degrees = source.table.angle_unit is AngleUnit.DEG
    size = max((abs(value) for value in source.values.values()), default=1.0)
    turns = [30, 45, -60, 90, -30, 60]
    joints = [
        f"{turns[i % len(turns)] if degrees else round(math.radians(turns[i % len(turns)]), 3)}"
        if joint_type is JointType.REVOLUTE
        else f"{size / 2:g}"
        for i, joint_type in enumerate(types)
    ]
    pose = f'[[parts]]\nkind = "pose"\npoints = 15\njoints = [{", ".join(joints)}]'
    if JointType.PRISMATIC in types:
        start, stop, step = nice_range(size / 2)
        pose += f"\nslides = {{ from = {start}, to = {stop}, step = {step} }}"
    asked = (("table", 50), ("link_matrices", 20), ("transform", 15))
    return [*(f'[[parts]]\nkind = "{kind}"\npoints = {points}' for kind, points in asked), pose]
