"""`framewise grade`: what students handed in, graded without a server; or one hand-in for an autograder."""

import argparse
import json
import math
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TextIO

from exercises.grading import HelpLevel
from exercises.library import Library
from kinematics.cells import AngleUnit, LengthUnit
from kinematics.errors import Fault
from kinematics.table import Convention
from service.adapters.class_grading import ClassSettings, exercise_meant, grade_class, misconceptions
from service.adapters.gradebook import GradebookEntry, GradebookFormat, write_gradebook
from service.adapters.hand_ins import count_files, hand_ins, left_out
from service.adapters.hosts import HOSTS
from service.adapters.hosts.assignment import Assignment
from service.adapters.table_files import TableSettings
from service.cli.environment import Subparsers, count, settings_of_environment
from service.cli.whole_files import replacing
from service.http.problems import RequestError
from service.messages import sentence

_JSON = "json"
_BAR = 30
_NAMED = 10  # Files that are named as left out; the others are counted.


def add(subparsers: Subparsers) -> None:
    """Declare `grade`."""
    parser = subparsers.add_parser("grade", help="grade files of students, without a server")
    parser.add_argument(
        "path", nargs="?", type=Path, help="a file, a folder or an LMS's zip archive; - or nothing with --for"
    )
    parser.add_argument("--exercise", help="the exercise; otherwise each file names it")
    parser.add_argument("--for", dest="host", choices=tuple(HOSTS), help="speak an autograder's protocol")
    parser.add_argument("--points", type=_worth, help="what the assignment is worth, with --for")
    parser.add_argument(
        "--format", choices=(*map(str, GradebookFormat), _JSON), help=f"of the grades ({GradebookFormat.CSV})"
    )
    parser.add_argument("--output", type=Path, help="file of grades; standard output, if it is not named")
    parser.add_argument("--jobs", type=count, help="processes (all cores)")
    parser.add_argument(
        "--per-student",
        action="store_true",
        help="the student's id, or name where no column holds one, is the seed of the values",
    )
    parser.add_argument(
        "--tell", choices=tuple(map(str, HelpLevel)), help="less help than the exercise allows"
    )
    parser.add_argument("--convention", choices=tuple(map(str, Convention)), default=Convention.STANDARD)
    parser.add_argument("--angle-unit", choices=tuple(map(str, AngleUnit)), default=AngleUnit.RAD)
    parser.add_argument("--length-unit", choices=tuple(map(str, LengthUnit)), default=LengthUnit.M)
    parser.set_defaults(run=_grade)


def _grade(options: argparse.Namespace) -> None:
    _refuse_without_effect(options)
    tables = TableSettings(
        convention=options.convention, angle_unit=options.angle_unit, length_unit=options.length_unit
    )
    path = None if options.path is None or str(options.path) == "-" else options.path
    folders = settings_of_environment().exercise_folders
    library = Library(folders)
    exercise = None if options.exercise is None else exercise_meant(options.exercise, library)
    if options.host:
        assignment = Assignment(
            exercise=exercise,
            language=options.lang,
            help_level=options.tell,
            points=options.points,
            tables=tables,
            library=library,
        )
        HOSTS[options.host](assignment, path)
        return
    settings = ClassSettings(
        exercise=exercise,
        language=options.lang,
        help_level=options.tell,
        per_student=options.per_student,
        folders=folders,
    )
    _grade_class(path, tables, settings, options)


def _refuse_without_effect(options: argparse.Namespace) -> None:
    """Refuse options of autograders for a class, and those of a class for an autograder.

    Raises:
        RequestError: at least one is given.
    """
    others = ("per_student", "format", "output", "jobs") if options.host else ("points",)
    given = [f"--{name.replace('_', '-')}" for name in others if getattr(options, name)]
    if given:
        with_for = "yes" if options.host else "no"
        raise RequestError(Fault.at("options_without_effect", options=tuple(given), host=with_for))


def _grade_class(
    path: Path | None, tables: TableSettings, settings: ClassSettings, options: argparse.Namespace
) -> None:
    if path is None:
        raise RequestError(Fault.at("grade_path_needed"))
    if not path.exists():
        raise RequestError(Fault.at("file_missing", file=path.name))
    form = options.format or GradebookFormat.CSV
    found = grade_class(hand_ins(path, tables), settings, options.jobs)
    counted = _Counted(_with_progress(found, count_files(path)))
    if options.output is None:
        _write(counted, sys.stdout, form)
    else:
        with replacing(options.output) as stream:
            _write(counted, stream, form)
    _summarise(counted, left_out(path), options.lang)


def _worth(text: str) -> float:
    """Return what an assignment is worth.

    Raises:
        argparse.ArgumentTypeError: it is no number above 0.
    """
    try:
        points = float(text)
    except ValueError:
        points = math.nan
    if not 0.0 < points < math.inf:
        raise argparse.ArgumentTypeError(f"a number above 0 is needed, not {text}")
    return points


class _Counted:
    """Entries that are counted as they pass, so that no class has to fit into memory."""

    def __init__(self, entries: Iterable[GradebookEntry]) -> None:
        self._entries = entries
        self.right = self.wrong = self.ungraded = 0
        self.found = misconceptions(())

    def __iter__(self) -> Iterator[GradebookEntry]:
        for entry in self._entries:
            self.right += entry.correct
            self.ungraded += entry.points is None
            self.wrong += entry.points is not None and not entry.correct
            self.found.update(misconceptions((entry,)))
            yield entry


def _write(entries: Iterable[GradebookEntry], stream: TextIO, form: str) -> None:
    if form == _JSON:
        for entry in entries:
            stream.write(json.dumps(asdict(entry), ensure_ascii=False) + "\n")
    else:
        write_gradebook(entries, stream, GradebookFormat(form))


def _with_progress(entries: Iterable[GradebookEntry], files: int) -> Iterator[GradebookEntry]:
    """Show on a terminal how many files are done."""
    shown = sys.stderr.isatty()
    done: set[str] = set()
    for entry in entries:
        yield entry
        if shown:
            done.add(entry.source)
            filled = _BAR * len(done) // max(files, 1)
            sys.stderr.write(f"\r[{'#' * filled}{'.' * (_BAR - filled)}] {len(done)}/{files}")
            sys.stderr.flush()
    if shown:
        sys.stderr.write("\n")


def _summarise(counted: _Counted, others: Sequence[str], language: str) -> None:
    counts = {"right": counted.right, "wrong": counted.wrong, "ungraded": counted.ungraded}
    sys.stderr.write(f"{sentence(language, 'grade-summary', counts)}\n")
    for code, times in counted.found.most_common(10):
        sys.stderr.write(f"  {times:6} {code}\n")
    if others:
        files = ", ".join(others[:_NAMED]) + (" …" if len(others) > _NAMED else "")
        told = sentence(language, "grade-left-out", {"count": len(others), "files": files})
        sys.stderr.write(f"{told}\n")
