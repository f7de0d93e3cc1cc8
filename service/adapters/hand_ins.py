"""What a class handed in: a file, a folder of files, or the archive that an LMS hands out."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from kinematics.errors import Fault
from service.adapters.table_files import LARGEST_FILE, SUFFIXES, FoundTable, TableSettings, read_tables
from service.http.problems import RequestError

MOST_FILES = 50_000
"""Files of a folder or archive: several for each student of the largest course."""

_MOODLE = re.compile(r"^(?P<name>.+?)_(?P<id>\d+)_(?:assignsubmission_|onlinetext)")
_CANVAS = re.compile(r"^(?P<name>[^_/]+)_(?:LATE_)?(?:(?P<id>\d+)_\d+)_")
_BLACKBOARD = re.compile(r"_(?P<name>[^_/]+)_attempt_\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d")


@dataclass(frozen=True, kw_only=True, slots=True)
class HandIn:
    """One table of one student, or why there is none.

    Attributes:
        student: who handed it in.
        source: the file, and for an archive the path in it.
        found: the table; None if the file could not be read.
        faults: why it could not.
    """

    student: str
    source: str
    found: FoundTable | None
    faults: tuple[Fault, ...] = ()


def hand_ins(path: Path, settings: TableSettings) -> Iterator[HandIn]:
    """Yield what a class handed in, file by file, so that memory does not grow with the class.

    Args:
        path: a file with one or many tables, a folder of files, or a zip archive.
        settings: convention and units, where a file does not name them.

    Raises:
        RequestError: nothing can be read at the path.
    """
    for name, content in _files(path):
        student = student_of(name)
        try:
            tables = read_tables(name, content, settings)
        except RequestError as error:
            yield HandIn(student=student, source=name, found=None, faults=error.faults)
            continue
        for found in tables:
            yield HandIn(student=found.student or student, source=name, found=found)


def count_files(path: Path) -> int:
    """Return how many files with tables a path holds; 0 where nothing can be read."""
    if path.is_dir():
        return sum(1 for file in path.rglob("*") if _is_table(file.name))
    try:
        with zipfile.ZipFile(path) as archive:
            return sum(1 for entry in archive.infolist() if _is_table(entry.filename))
    except (zipfile.BadZipFile, OSError):
        return int(path.is_file())


def student_of(name: str) -> str:
    """Return the student that a file's path names, by the schemes of Moodle, Canvas and Blackboard.

    Otherwise the folder that the file lies in names the student, or else the file does.
    """
    parts = PurePosixPath(name).parts
    for part in reversed(parts):
        for scheme in (_MOODLE, _BLACKBOARD, _CANVAS):
            if found := scheme.search(part):
                return found["name"]
    if len(parts) > 1:
        return parts[-2]
    return PurePosixPath(name).stem


def _files(path: Path) -> Iterator[tuple[str, bytes]]:
    if path.is_dir():
        files = sorted(file for file in path.rglob("*") if _is_table(file.name) and file.is_file())
        if len(files) > MOST_FILES:
            raise _unreadable("files_too_many", path, limit=MOST_FILES)
        for file in files:
            with file.open("rb") as stream:
                yield file.relative_to(path).as_posix(), stream.read(LARGEST_FILE + 1)
    elif zipfile.is_zipfile(path) and path.suffix.lower() == ".zip":
        yield from _archived(path)
    else:
        try:
            with path.open("rb") as stream:
                yield path.name, stream.read(LARGEST_FILE + 1)
        except FileNotFoundError:
            raise _unreadable("file_missing", path) from None
        except OSError as error:
            raise _unreadable("file_unreadable", path, reason=error.strerror or str(error)) from None


def _archived(path: Path) -> Iterator[tuple[str, bytes]]:
    """Read the members in memory; nothing of an archive is written, and no more read than a file may hold."""
    try:
        with zipfile.ZipFile(path) as archive:
            members = [entry for entry in archive.infolist() if _is_table(entry.filename)]
            if len(members) > MOST_FILES:
                raise _unreadable("files_too_many", path, limit=MOST_FILES)
            for member in members:
                with archive.open(member) as stream:
                    yield member.filename, stream.read(LARGEST_FILE + 1)
    except (zipfile.BadZipFile, RuntimeError, OSError) as error:
        raise _unreadable("file_unreadable", path, reason=str(error)) from None


def _is_table(name: str) -> bool:
    path = PurePosixPath(name)
    hidden = path.name.startswith((".", "~$")) or "__MACOSX" in path.parts
    return path.suffix.lower() in SUFFIXES and not hidden


def _unreadable(code: str, path: Path, **params: str | int) -> RequestError:
    return RequestError(Fault(code=code, where=(path.name,), params={"file": path.name, **params}))
