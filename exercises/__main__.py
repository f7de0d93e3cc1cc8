"""The command line of exercises: `python -m exercises --help`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from importlib.resources.abc import Traversable
from pathlib import Path

from exercises.authoring.scaffold import scaffold
from exercises.authoring.sources import Source, from_axes_file, from_robot, from_table_file, from_urdf_file
from exercises.consistency import FILE
from exercises.definition import Exercise
from exercises.drawings import figure_svg
from exercises.errors import ExerciseError
from exercises.instance import generate
from exercises.loader import ROOT, load_exercise, packaged
from exercises.selftest.checks import check

SEEDS = 10
NOTE = "not to scale"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command.

    Returns:
        0, or 1 if something is wrong with an exercise, or 2 if the command cannot be carried out.
    """
    options = _parser().parse_args(arguments)
    run: Callable[[argparse.Namespace], int] = options.run
    try:
        return run(options)
    except ExerciseError as error:
        sys.stderr.write(f"{error}\n")
        return 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m exercises", description="Write, draw and test exercises."
    )
    commands = parser.add_subparsers(required=True, metavar="command")

    listed = commands.add_parser("list", help="the exercises that come with the package")
    listed.set_defaults(run=_list)

    checked = commands.add_parser("check", help="let exercises test themselves")
    checked.add_argument("exercise", nargs="*", help="ids or folders; all of the package, if none is named")
    checked.add_argument(
        "--seeds", type=int, default=SEEDS, help=f"students' values to try (usually {SEEDS})"
    )
    checked.set_defaults(run=_check)

    drawn = commands.add_parser("figure", help="draw the figure of an exercise")
    drawn.add_argument("exercise", help="id or folder")
    drawn.add_argument("--seed", help="draw it with the values of a seed")
    drawn.add_argument("--output", type=Path, help="file to write; standard output, if it is not named")
    drawn.set_defaults(run=_figure)

    new = commands.add_parser("new", help="start an exercise")
    new.add_argument("id", help="name of its folder")
    new.add_argument("--into", type=Path, default=Path(str(ROOT)), help="folder of exercises to put it into")
    source = new.add_mutually_exclusive_group(required=True)
    source.add_argument("--robot", help="a robot of the catalogue")
    source.add_argument("--table", type=Path, help="a DH table in JSON or TOML, with values under parameters")
    source.add_argument("--axes", type=Path, help="joint axes in JSON or TOML")
    source.add_argument("--urdf", type=Path, help="a URDF file with one serial chain")
    new.set_defaults(run=_new)
    return parser


def _list(options: argparse.Namespace) -> int:
    for exercise_id in packaged().ids:
        found = packaged().exercise(exercise_id)
        parts = ", ".join(part.kind for part in found.parts)
        sys.stdout.write(f"{exercise_id:12} {found.titles['en']:32} {parts}\n")
    return 0


def _check(options: argparse.Namespace) -> int:
    failed = False
    for name in options.exercise or packaged().ids:
        findings = check(_found(name), options.seeds)
        sys.stdout.write(f"{findings.exercise:12} {findings.passed.total()} checks passed")
        sys.stdout.write(f", {len(findings.failures)} failed\n" if findings.failures else "\n")
        sys.stdout.writelines(f"  {failure}\n" for failure in findings.failures)
        failed |= bool(findings.failures)
    return int(failed)


def _figure(options: argparse.Namespace) -> int:
    found = _found(options.exercise)
    svg = figure_svg(
        generate(found, options.seed), title=found.titles["en"], description="", language="en", note=NOTE
    )
    if options.output is None:
        sys.stdout.write(f"{svg}\n")
    else:
        options.output.write_text(f"{svg}\n", encoding="utf-8")
    return 0


def _new(options: argparse.Namespace) -> int:
    folder = scaffold(options.id, _source(options), options.into)
    load_exercise(folder)
    sys.stdout.write(f"{folder / FILE}\n")
    return 0


def _source(options: argparse.Namespace) -> Source:
    if options.robot:
        return from_robot(options.robot)
    if options.table:
        return from_table_file(options.table)
    return from_axes_file(options.axes) if options.axes else from_urdf_file(options.urdf)


def _found(name: str) -> Exercise:
    folder: Traversable = Path(name)
    return load_exercise(folder) if (folder / FILE).is_file() else packaged().exercise(name)


if __name__ == "__main__":
    sys.exit(main())
