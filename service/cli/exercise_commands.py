"""`framewise exercises`: list, start, draw and test exercises."""

import argparse
import sys
from pathlib import Path

from exercises.authoring.archive import draft_of_archive
from exercises.authoring.draft import exercise_of_draft
from exercises.authoring.named_tables import ExerciseSource
from exercises.authoring.scaffold import scaffold
from exercises.authoring.sources import from_axes, from_robot, from_table, from_urdf_file, keys_of
from exercises.consistency import FILE
from exercises.definition import Exercise
from exercises.instance import generate
from exercises.library import ROOT, Library
from exercises.loader import load_exercise
from exercises.selftest.checks import check
from exercises.selftest.findings import Failure, Findings
from service.cli.environment import Subparsers, count, settings_of_environment
from service.messages import robot_name, sentence
from service.wire.exercises.figure_files import figure_file

SEEDS = 10  # What a lecturer waits for; `make check-exercises` tries more.


def add(subparsers: Subparsers) -> None:
    """Declare `exercises` with what can be done with them."""
    parser = subparsers.add_parser("exercises", help="list, start, draw and test exercises")
    commands = parser.add_subparsers(required=True, metavar="what")

    listed = commands.add_parser(
        "list", help="all exercises: the package's and those of FRAMEWISE_EXERCISE_FOLDERS"
    )
    listed.set_defaults(run=_list)

    checked = commands.add_parser("check", help="let exercises test themselves")
    checked.add_argument(
        "exercise", nargs="*", help="ids, folders or zip files of folders; all exercises, if none is named"
    )
    checked.add_argument("--seeds", type=count, default=SEEDS, help="students' values to try (%(default)s)")
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


def _list(options: argparse.Namespace) -> None:
    library = _library()
    found = [library.exercise(exercise_id) for exercise_id in library.ids]
    names = max(map(len, library.ids))
    titles = max(len(exercise.title(options.lang)) for exercise in found)
    for exercise in found:
        parts = ", ".join(part.kind for part in exercise.parts)
        sys.stdout.write(f"{exercise.id:{names}} {exercise.title(options.lang):{titles}} {parts}\n")


def _check(options: argparse.Namespace) -> int:
    failed = False
    for name in options.exercise or _library().ids:
        findings = check(_found(name), options.seeds)
        sys.stdout.write(f"{_counts(findings, options.lang)}\n")
        for failure in findings.failures:
            sys.stdout.write(f"  {failure.check}: {_told(failure, options.lang)}\n")
        for warning in findings.warnings:
            sys.stdout.write(f"  {warning.check}: {_told(warning, options.lang)}\n")
        failed |= bool(findings.failures)
    return int(failed)


def _counts(findings: Findings, language: str) -> str:
    params = {
        "exercise": findings.exercise,
        "passed": findings.passed.total(),
        "failed": len(findings.failures),
        "warnings": len(findings.warnings),
    }
    return sentence(language, "check-counts", params) or findings.exercise


def _told(failure: Failure, language: str) -> str:
    return sentence(language, f"check-{failure.check}", failure.params) or failure.check


def _figure(options: argparse.Namespace) -> None:
    svg = figure_file(generate(_found(options.exercise), options.seed), options.lang).decode()
    if options.output is None:
        sys.stdout.write(f"{svg}\n")
    else:
        options.output.write_text(f"{svg}\n", encoding="utf-8")


def _new(options: argparse.Namespace) -> None:
    folder = scaffold(options.id, _source(options), options.into, robot_name)
    load_exercise(folder)
    sys.stdout.write(f"{folder / FILE}\n")


def _source(options: argparse.Namespace) -> ExerciseSource:
    if options.robot:
        return from_robot(options.robot)
    if options.table:
        return from_table(keys_of(options.table))
    return from_axes(keys_of(options.axes)) if options.axes else from_urdf_file(options.urdf)


def _library() -> Library:
    return Library(settings_of_environment().exercise_folders)


def _found(name: str) -> Exercise:
    folder = Path(name)
    if folder.suffix == ".zip" and folder.is_file():
        return exercise_of_draft(draft_of_archive(folder.read_bytes()))
    return load_exercise(folder) if (folder / FILE).is_file() else _library().exercise(name)
