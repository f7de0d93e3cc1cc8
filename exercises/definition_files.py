"""The files of an exercise: exercise.toml and statement.<language>.md, as bytes and as what they hold."""

import re
import tomllib
from collections.abc import Mapping
from importlib.resources.abc import Traversable
from typing import Any

from exercises.consistency import FILE
from exercises.errors import DefinitionError
from kinematics.errors import Fault

STATEMENT = re.compile(r"statement\.([a-z]{2})\.md")
"""The name of a statement's file; its group is the language."""
ENCODING = "utf-8-sig"  # UTF-8, with the mark in front that editors on Windows write, or without.


def files_of_folder(folder: Traversable) -> Mapping[str, bytes]:
    """Return the files of a folder that say something of its exercise, by name."""
    found = folder.iterdir() if folder.is_dir() else ()
    return {
        file.name: file.read_bytes()
        for file in found
        if file.is_file() and (file.name == FILE or STATEMENT.fullmatch(file.name))
    }


def read_definition(files: Mapping[str, bytes]) -> Mapping[str, Any]:
    """Return the keys of exercise.toml, which is one of the files.

    Raises:
        DefinitionError: it is not there, or no TOML.
    """
    if FILE not in files:
        raise DefinitionError(Fault.at("exercise_file_missing", FILE))
    try:
        return tomllib.loads(files[FILE].decode(ENCODING))
    except (
        ValueError,
        RecursionError,
    ) as error:  # what is no TOML, no UTF-8, a number of endless digits, too deep
        raise DefinitionError(Fault.at("exercise_file_not_toml", FILE, reason=str(error))) from error


def read_statements(files: Mapping[str, bytes]) -> Mapping[str, str]:
    """Return the texts of the statements among the files, by language.

    Raises:
        DefinitionError: one is no UTF-8.
    """
    found: dict[str, str] = {}
    for name in sorted(files):
        if named := STATEMENT.fullmatch(name):
            try:
                found[named[1]] = files[name].decode(ENCODING).strip()
            except UnicodeDecodeError as error:
                raise DefinitionError(Fault.at("statement_not_text", name)) from error
    return found


def statement_file(language: str) -> str:
    """Return the name of the file that holds the statement in a language."""
    return f"statement.{language}.md"
