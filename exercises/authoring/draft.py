"""A draft: an exercise as its author holds it, in plain data, and as the files of a folder."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from exercises.authoring.toml_text import toml_text
from exercises.consistency import FILE
from exercises.definition import Exercise
from exercises.definition_files import read_definition, read_statements, statement_file
from exercises.errors import DefinitionError
from exercises.loader import read_exercise
from kinematics.errors import Fault

LONGEST_ID = 48
"""An address of a published version adds a part of its digest, and stays within 64 characters."""
DEEPEST = 8  # A definition's tables and lists stand at most five deep; this leaves room and stops a bomb.
MOST_ENTRIES = 128  # Of a table or a list: twice the rows of the longest table.
MOST_VALUES = 5000  # Of a whole definition; the longest that is shipped has some three hundred.
LONGEST_KEY = 100  # Characters of a key; a fault repeats it three times.
ID_PATTERN = "[A-Za-z0-9]+(-[A-Za-z0-9]+)*"
_ID = re.compile(ID_PATTERN)


@dataclass(frozen=True, kw_only=True, slots=True)
class ExerciseDraft:
    """An exercise as its author holds it; it need not be whole.

    Attributes:
        id: name of its folder.
        definition: the keys of exercise.toml.
        statements: in Markdown, by language.
    """

    id: str
    definition: Mapping[str, Any]
    statements: Mapping[str, str]


def exercise_of_draft(draft: ExerciseDraft) -> Exercise:
    """Return the exercise that a draft describes; what reads folders reads drafts.

    Raises:
        DefinitionError: every fault that was found, each at (file, key, …); an id or a size that no folder
        has.
    """
    check_id(draft.id)
    _check_size(draft.definition)
    return read_exercise(draft.id, draft.definition, draft.statements)


def draft_of_files(exercise_id: str, files: Mapping[str, bytes]) -> ExerciseDraft:
    """Return the draft that the files of a folder hold.

    Raises:
        DefinitionError: exercise.toml is missing or no TOML, or a statement no text.
    """
    return ExerciseDraft(id=exercise_id, definition=read_definition(files), statements=read_statements(files))


def files_of_draft(draft: ExerciseDraft) -> dict[str, bytes]:
    """Return the files of the folder that a draft describes; `draft_of_files` reads the same draft from them.

    Raises:
        DefinitionError: a value of the definition is none that TOML knows.
    """
    try:
        files = {FILE: toml_text(draft.definition).encode()}
    except ValueError as error:
        raise DefinitionError(Fault.at("exercise_file_not_toml", FILE, reason=str(error))) from error
    for language in sorted(draft.statements):
        files[statement_file(language)] = f"{draft.statements[language].strip()}\n".encode()
    return files


def check_id(exercise_id: str) -> None:
    """Refuse what is no name of a folder on every system.

    Raises:
        DefinitionError: it is not made of Latin letters, digits and single hyphens, or too long.
    """
    if len(exercise_id) > LONGEST_ID or not _ID.fullmatch(exercise_id):
        raise DefinitionError(Fault.at("exercise_id_invalid", "id", id=exercise_id[:80]))


def _check_size(definition: Mapping[str, Any]) -> None:
    """Refuse a definition that is deeper or larger than one about a robot can be, or has longer keys."""
    level: list[Any] = [definition]
    values = 0
    for _ in range(DEEPEST):
        inner = [entry for node in level for entry in (node.values() if isinstance(node, Mapping) else node)]
        values += len(inner)
        if values > MOST_VALUES or any(len(node) > MOST_ENTRIES for node in level):
            break
        keys = (key for node in level if isinstance(node, Mapping) for key in node)
        if any(len(key) > LONGEST_KEY for key in keys):
            raise DefinitionError(Fault.at("text_too_long", FILE, limit=LONGEST_KEY))
        level = [entry for entry in inner if isinstance(entry, Mapping | list)]
        if not level:
            return
    params = {"entries": MOST_ENTRIES, "values": MOST_VALUES, "deepest": DEEPEST}
    raise DefinitionError(Fault.at("draft_too_large", FILE, **params))
