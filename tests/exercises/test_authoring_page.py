"""docs/authoring.md is executed: its files load, its commands run, its requests are graded."""

import json
import re
import shlex
import tomllib
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from exercises.definition import LANGUAGES
from exercises.loader import load_exercise
from exercises.parts.registry import part_types
from service.cli.commands import main
from service.schemas.exercises.exercises import ExerciseAnswer
from tests.exercises.answering import judged
from tests.exercises.folders import folder

PAGE = (Path(__file__).parents[2] / "docs" / "authoring.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w+)(?: (\w+)=(\S+))?\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


DOCS = Path(__file__).parents[2] / "docs"
PAGES = {
    "dynamics.md": "twolink",
    "find-the-mistake.md": "puma560",
    "jacobian-answers.md": "scorbot",
    "joint-answers.md": "puma560",
    "rotations.md": "stanford",
    "screws.md": "scara",
    "singularities.md": "stanford",
}
"""Pages of kinds with definitions of their own, each with a robot that they suit."""
DEFINITIONS = [
    (robot, block)
    for page, robot in PAGES.items()
    for block in re.findall(r"^```toml\n(.*?)^```$", (DOCS / page).read_text("utf-8"), re.M | re.S)
]
ALONE = [tomllib.loads(block) for _, block in DEFINITIONS]
BEYOND = {"frames", *(part["kind"] for found in ALONE for part in found["parts"])}
"""Kinds of part with a section or a page of their own: the crane asks for all others."""


def files() -> dict[str, str]:
    return {name: content for _, kind, name, content in BLOCKS if kind == "file"}


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the page's files in it, and the crane's statement in every language."""
    for name, content in files().items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(content, encoding="utf-8")
    statement = files()["crane/statement.en.md"]
    for language in LANGUAGES:
        (tmp_path / "crane" / f"statement.{language}.md").write_text(statement, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(("robot", "block"), DEFINITIONS)
def test_every_definition_of_a_page_loads(robot: str, block: str, tmp_path: Path) -> None:
    titles = "".join(f'{language} = "Doc"\n' for language in LANGUAGES)
    text = f'version = 1\nrobot = "{robot}"\n[title]\n{titles}{block}'
    loaded = load_exercise(folder(tmp_path, text, statement="An arm."))
    assert [found.kind for found in loaded.parts] == [part["kind"] for part in tomllib.loads(block)["parts"]]


def test_every_command_runs(desk: Path, capsys: pytest.CaptureFixture[str]) -> None:
    commands = [line for language, *_, content in BLOCKS if language == "sh" for line in content.splitlines()]
    assert len(commands) == 7
    for command in commands:
        words = shlex.split(command)
        assert words[:2] == ["framewise", "exercises"]
        arguments = ["2" if before == "--seeds" else word for before, word in pairwise(words)]
        assert main(arguments) == 0, capsys.readouterr()
    assert (desk / "my-arm.svg").read_text(encoding="utf-8").startswith("<svg")


def test_the_full_definition_says_what_its_comments_say(desk: Path) -> None:
    crane = load_exercise(desk / "crane")
    assert {part.kind for part in crane.parts} == set(part_types()) - BEYOND
    assert crane.points == 100
    assert crane.figure.marks == ("P",)
    assert len(crane.samples) == 1


NAMED = {("points",), ("lengths",), ("parameters",), ("joints",), ("title",), ("weights",)}
"""Tables with names of things for keys."""


def keys(node: Any, where: tuple[str, ...] = ()) -> Iterator[str]:
    """Keys of a definition; names that an author makes up are none."""
    if isinstance(node, list):
        for entry in node:
            yield from keys(entry, where)
    if isinstance(node, dict):
        for key, value in node.items():
            if where[-1:] not in NAMED and not re.fullmatch(r"q\d+", key):
                yield key
            yield from keys(value, (*where, key))


def test_every_key_of_the_shipped_definitions_is_explained() -> None:
    explained = {*keys(tomllib.loads(files()["crane/exercise.toml"])), *keys(ALONE)}
    root = Path(__file__).parents[2] / "exercises" / "definitions"
    used = {
        key for file in root.glob("*/exercise.toml") for key in keys(tomllib.loads(file.read_text("utf-8")))
    }
    assert used - explained == {"robot"}
    assert 'robot = "puma560"' in PAGE


def test_requests_are_graded() -> None:
    requests = [(name, json.loads(content)) for _, kind, name, content in BLOCKS if kind == "grade"]
    assert requests
    for exercise_id, body in requests:
        raw = ExerciseAnswer.model_validate(body).raw()
        report = judged(exercise_id, **raw.parts)
        assert report.correct
