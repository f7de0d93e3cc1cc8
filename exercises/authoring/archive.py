"""An exercise's folder as a zip file: written byte for byte alike, read as made by anybody.

Nothing is unpacked to a disk. A file is taken by its name alone, out of the few names that a folder of an
exercise can hold, and no more of it is unpacked than such a file can be long, whatever the archive says of
its size.
"""

import io
import re
import stat
import zipfile
import zlib
from collections.abc import Mapping

from exercises.authoring.draft import ExerciseDraft, check_id, draft_of_files, files_of_draft
from exercises.consistency import FILE
from exercises.errors import DefinitionError
from kinematics.errors import Fault

LARGEST_ARCHIVE = 256 * 1024  # Bytes; the largest that is shipped has four thousand.
MOST_FILES = 64
"""Entries of an archive: the folder, a definition, a statement in each language, and what archivers add."""
LARGEST_FILE = 128 * 1024  # Bytes of a file as it is unpacked; a statement has at most 20,000 characters.
_LONG_AGO = (1980, 1, 1, 0, 0, 0)  # The first moment that a zip archive can tell.
_FOLDER = "folder"
_NAME = re.compile(r"(?:(?P<folder>[^/\\:\0]{1,100})/)?(?P<file>exercise\.toml|statement\.[a-z]{2}\.md)")
_BESIDE = re.compile(r"__MACOSX/.*|(?:.*/)?\.DS_Store")
"""What the archiver of one system adds to every archive; it is passed over."""
_METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_ENCRYPTED = 1  # Bit 0 of the general purpose flags (APPNOTE.TXT 4.4.4).
_END = b"PK\x05\x06"


def archive_of_draft(draft: ExerciseDraft) -> bytes:
    """Return the draft's folder as a zip file; the same draft gives the same bytes.

    Raises:
        DefinitionError: its id is no name of a folder, or a value none that TOML knows.
    """
    check_id(draft.id)
    return zipped({f"{draft.id}/{name}": content for name, content in files_of_draft(draft).items()})


def zipped(contents: Mapping[str, str | bytes]) -> bytes:
    """Return files by their names as a zip archive; the same files give the same bytes."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in contents.items():
            entry = zipfile.ZipInfo(name, _LONG_AGO)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (stat.S_IFREG | 0o644) << 16
            archive.writestr(entry, content)
    return stream.getvalue()


def draft_of_archive(data: bytes) -> ExerciseDraft:
    """Return the draft in a zip file.

    A folder with exercise.toml and statement.<language>.md, or these files alone.

    Raises:
        DefinitionError: it is too large, no zip file, or holds anything else; what is in it is not read then.
    """
    if len(data) > LARGEST_ARCHIVE:
        raise _refused("archive_too_large", limit=LARGEST_ARCHIVE)
    if data.count(_END) != 1:
        raise _refused("archive_not_zip")
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            folder, entries = _entries(archive)
            files = {name: _unpacked(archive, entry) for name, entry in entries.items()}
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, NotImplementedError) as error:
        raise _refused("archive_not_zip") from error
    return draft_of_files(folder, files)


def _entries(archive: zipfile.ZipFile) -> tuple[str, Mapping[str, zipfile.ZipInfo]]:
    """Return the folder's name and its files' entries, all of which are what they should be."""
    listed = archive.infolist()
    if len(listed) > MOST_FILES:
        raise _refused("archive_too_many_files", count=len(listed), limit=MOST_FILES)
    entries: dict[str, zipfile.ZipInfo] = {}
    folders: set[str] = set()
    for entry in listed:
        if _BESIDE.fullmatch(entry.filename):
            continue
        if entry.filename.endswith("/") and entry.file_size == 0 and entry.filename.count("/") == 1:
            continue
        named = _NAME.fullmatch(entry.filename)
        kind = stat.S_IFMT(entry.external_attr >> 16)
        if named is None or named["file"] in entries or kind not in (0, stat.S_IFREG):
            raise _refused("archive_entry", name=entry.filename[:100], known=FILE)
        if entry.flag_bits & _ENCRYPTED or entry.compress_type not in _METHODS:
            raise _refused("archive_method", name=entry.filename[:100])
        entries[named["file"]] = entry
        folders.add(named[_FOLDER] or "")
    if len(folders) != 1 or FILE not in entries:
        raise _refused("archive_no_exercise", known=FILE)
    folder = folders.pop() or "exercise"
    check_id(folder)
    return folder, entries


def _unpacked(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> bytes:
    """Return a file, or refuse it before more of it is unpacked than it may have."""
    with archive.open(entry) as file:
        content = file.read(LARGEST_FILE + 1)
    if len(content) > LARGEST_FILE:
        raise _refused("archive_file_too_large", name=entry.filename[:100], limit=LARGEST_FILE)
    return content


def _refused(code: str, **params: str | int) -> DefinitionError:
    return DefinitionError(Fault.at(code, **params))
