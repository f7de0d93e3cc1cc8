"""What a class handed in: a file, a folder of files, or the archive that an LMS hands out."""

import os
import re
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from unicodedata import normalize

from kinematics.errors import Fault
from service.adapters.table_files import LARGEST_FILE, SUFFIXES, FoundTable, TableSettings, read_tables
from service.http.problems import RequestError

MOST_FILES = 50_000  # Files of a folder or archive: several for each student of the largest course.

_DAMAGE = (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, NotImplementedError, OSError)
"""What reading a member raises that is damaged, encrypted, or packed in a way that nobody reads."""

_UTF8 = 0x800  # Bit 11 of a member's flags: its name is in UTF-8 (APPNOTE.TXT 4.4.4).

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
        identifier: of the student in the LMS, where the LMS has put it into the file's name.
    """

    student: str
    source: str
    found: FoundTable | None
    faults: tuple[Fault, ...] = ()
    identifier: str | None = None


def hand_ins(path: Path, settings: TableSettings) -> Iterator[HandIn]:
    """Yield what a class handed in, file by file, so that memory does not grow with the class.

    The path is a file with one or many tables, a folder of files, or a zip archive.

    Raises:
        RequestError: nothing can be read at the path.
    """
    are_hidden = _are_hidden(path)
    for name, content in _files(path):
        identifier = identifier_of(name)
        student = identifier if are_hidden and identifier else student_of(name)
        try:
            if isinstance(content, RequestError):
                raise content
            tables = read_tables(name, content, settings)
        except RequestError as error:
            yield HandIn(student=student, source=name, found=None, faults=error.faults, identifier=identifier)
            continue
        for found in tables:
            own = found.identifier if found.student else identifier
            yield HandIn(student=found.student or student, source=name, found=found, identifier=own)


def count_files(path: Path) -> int:
    """Return how many files a path holds that get a line; 0 where nothing can be read."""
    try:
        names = _names(path)
        return int(path.is_file()) if names is None else len(_worth_a_line(names, path))
    except (zipfile.BadZipFile, OSError, RequestError):
        return 0


def left_out(path: Path) -> list[str]:
    """Return the files of a folder or archive that get no line because of their type, hidden ones aside."""
    names = _names(path) or []
    chosen = set(_worth_a_line(names, path))
    return sorted(name for name in names if name not in chosen and not _is_hidden(PurePosixPath(name)))


def _names(path: Path) -> list[str] | None:
    """Return the files of a folder or archive; None for a file that stands alone."""
    if path.is_dir():
        return list(_of_folder(path))
    if path.suffix.lower() != ".zip":
        return None
    with zipfile.ZipFile(path) as archive:
        return list(_members(archive))


def _of_folder(path: Path) -> dict[str, Path]:
    """Return the files of a folder by their names."""
    files = (file for file in path.rglob("*") if file.is_file())
    return {_readable(file.relative_to(path).as_posix()): file for file in files}


def _readable(name: str) -> str:
    """A file's name as text that can be written: archives from Windows leave names that are no UTF-8."""
    return os.fsencode(name).decode("utf-8", "backslashreplace")


def _members(archive: zipfile.ZipFile) -> dict[str, zipfile.ZipInfo]:
    """Return the files of an archive by their names."""
    return {_name_of(entry): entry for entry in archive.infolist() if not entry.is_dir()}


def _name_of(entry: zipfile.ZipInfo) -> str:
    """The name of a member: in code page 437 if no flag says UTF-8, which macOS writes without one."""
    name = entry.filename
    if not entry.flag_bits & _UTF8:
        with suppress(UnicodeError):
            name = name.encode("cp437").decode("utf-8")
    return normalize("NFC", name)


def student_of(name: str) -> str:
    """Return the student that a file's path names, by the schemes of Moodle, Canvas and Blackboard.

    Otherwise the folder that the file lies in names the student, or else the file does.
    """
    name = normalize("NFC", name)  # however an accent is encoded in a file's name, it is one person's
    if found := _scheme_of(name):
        return found["name"]
    parts = PurePosixPath(name).parts
    return parts[-2] if len(parts) > 1 else PurePosixPath(name).stem


def identifier_of(name: str) -> str | None:
    """Return what Moodle or Canvas call a student, and import by: `Participant 12`, a user's number."""
    found = _scheme_of(name)
    if found is None or found.re is _BLACKBOARD:
        return None
    return f"Participant {found['id']}" if found.re is _MOODLE else found["id"]


def _scheme_of(name: str) -> re.Match[str] | None:
    """Where an LMS has named a student: in a folder of Moodle the files bear names that students chose."""
    parts = PurePosixPath(name).parts
    for step in parts:
        if found := _MOODLE.search(step):
            return found
    matches = (scheme.search(step) for step in reversed(parts) for scheme in (_BLACKBOARD, _CANVAS))
    return next(filter(None, matches), None)


def _are_hidden(path: Path) -> bool:
    """Whether Moodle hides who its students are: all bear one name, in its language, and their numbers."""
    people: set[tuple[str, str | None]] = set()
    with suppress(zipfile.BadZipFile, OSError):  # told where it is read
        people = {_person(name) for name in _names(path) or () if _is_moodle(name)}
    return len(people) > 1 and len({student for student, _ in people}) == 1


def _is_moodle(name: str) -> bool:
    found = _scheme_of(name)
    return found is not None and found.re is _MOODLE


def _person(name: str) -> tuple[str, str | None]:
    """Whose a file is: two students of one name are two where the LMS tells them apart."""
    return student_of(name), identifier_of(name)


def _files(path: Path) -> Iterator[tuple[str, bytes | RequestError]]:
    """Yield names with contents, or why there is none: a damaged file is one student's."""
    if path.is_dir():
        found = _of_folder(path)
        for name in _worth_a_line(sorted(found), path):
            try:
                with found[name].open("rb") as stream:
                    yield name, stream.read(LARGEST_FILE + 1)
            except OSError as error:
                yield name, _unreadable("file_unreadable", name, reason=error.strerror or str(error))
    elif path.suffix.lower() == ".zip" and path.is_file():
        yield from _archived(path)
    else:
        try:
            with path.open("rb") as stream:
                yield _readable(path.name), stream.read(LARGEST_FILE + 1)
        except FileNotFoundError:
            raise _unreadable("file_missing", path.name) from None
        except OSError as error:
            raise _unreadable("file_unreadable", path.name, reason=error.strerror or str(error)) from None


def _archived(path: Path) -> Iterator[tuple[str, bytes | RequestError]]:
    """Read the members in memory; nothing of an archive is written, and no more read than a file may hold."""
    try:
        archive = zipfile.ZipFile(path)
    except (zipfile.BadZipFile, OSError) as error:
        raise _unreadable("file_unreadable", path.name, reason=str(error)) from None
    with archive:
        members = _members(archive)
        for name in _worth_a_line(list(members), path):
            try:
                with archive.open(members[name]) as stream:
                    yield name, stream.read(LARGEST_FILE + 1)
            except _DAMAGE as error:
                yield name, _unreadable("file_unreadable", name, reason=str(error))


def _worth_a_line(names: Sequence[str], path: Path) -> list[str]:
    """Return the files with tables, and the others of students who have handed in no table.

    Raises:
        RequestError: they are too many.
    """
    tables = {name for name in names if _is_table(name)}
    heard = {_person(name) for name in tables}
    chosen = [
        name for name in names if name in tables or (_is_handed_in(name) and _person(name) not in heard)
    ]
    if len(chosen) > MOST_FILES:
        raise _unreadable("files_too_many", path.name, limit=MOST_FILES)
    return chosen


def _is_handed_in(name: str) -> bool:
    """Whether a file of any type is a student's: it lies in a folder of theirs, or an LMS has named it."""
    path = PurePosixPath(name)
    named = any(scheme.search(path.name) for scheme in (_MOODLE, _BLACKBOARD, _CANVAS))
    return not _is_hidden(path) and (len(path.parts) > 1 or named)


def _is_hidden(path: PurePosixPath) -> bool:
    return any(part.strip(".") and part.startswith((".", "~$", "__MACOSX")) for part in path.parts)


def _is_table(name: str) -> bool:
    path = PurePosixPath(name)
    return path.suffix.lower() in SUFFIXES and not _is_hidden(path)


def _unreadable(code: str, name: str, **params: str | int) -> RequestError:
    return RequestError(Fault.at(code, file=PurePosixPath(name).name, **params))
