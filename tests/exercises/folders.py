"""Folders of exercises made for tests."""

from importlib.resources.abc import Traversable
from pathlib import Path

from exercises.authoring.draft import ExerciseDraft, draft_of_files
from exercises.definition import LANGUAGES
from exercises.definition_files import files_of_folder

TWO_LINKS = """
version = 1

[title]
en = "Two"
ro = "Doi"
pt = "Dois"
fr = "Deux"
uk = "Два"
es = "Dos"

[reference]
convention = "standard"
angle_unit = "deg"
length_unit = "m"
rows = [
  { joint = "revolute", theta = "q1", d = 0, a = "L1", alpha = 0 },
  { joint = "revolute", theta = "q2", d = 0, a = "L2", alpha = 0 },
]

[parameters]
L1.value = 0.5
L1.draw = { from = 0.4, to = 0.6, step = 0.1 }
L2.value = 0.3

[[parts]]
kind = "table"
points = 10
"""


def folder(
    root: Path, text: str = TWO_LINKS, *, name: str = "two", statement: str = "Links *L1*, *L2*."
) -> Path:
    """A folder with a definition, and the same statement in every language."""
    made = root / name
    made.mkdir(parents=True, exist_ok=True)
    (made / "exercise.toml").write_text(text, encoding="utf-8")
    for language in LANGUAGES:
        (made / f"statement.{language}.md").write_text(statement, encoding="utf-8")
    return made


def draft_of(folder: Traversable) -> ExerciseDraft:
    """The draft that a folder holds."""
    return draft_of_files(folder.name, files_of_folder(folder))


def changed(old: str, new: str, text: str = TWO_LINKS) -> str:
    """A definition with one place changed."""
    assert text.count(old) == 1, old
    return text.replace(old, new)


def with_part(part: str, text: str = TWO_LINKS) -> str:
    """A definition that asks for one more part."""
    return f"{text}\n[[parts]]\n{part}\n"
