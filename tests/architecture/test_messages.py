"""Every refusal has a sentence in every language, with the same parameters; no sentence is left over."""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from fluent.syntax import FluentParser
from fluent.syntax import ast as fluent

from kinematics import catalogue
from tests.architecture.sources import ROOT, modules, shown, tracked

LOCALES = ROOT / "service" / "locales"
LANGUAGES = ("en", "es", "fr", "pt", "ro", "uk")
ROOMS = sorted(path.name for path in (LOCALES / "en").glob("*.ftl"))
MAKERS = {"fault", "_fault", "CellRefusal", "Fault"}


@cache
def parsed(language: str, room: str) -> list[fluent.EntryType]:
    path = LOCALES / language / room
    return FluentParser().parse(path.read_text(encoding="utf-8")).body if path.exists() else []


@cache
def entries(language: str, room: str) -> dict[str, fluent.Message | fluent.Term]:
    return {
        entry.id.name: entry
        for entry in parsed(language, room)
        if isinstance(entry, fluent.Message | fluent.Term)
    }


def variables(entry: fluent.BaseNode) -> set[str]:
    found: set[str] = set()
    pending: list[object] = [entry]
    while pending:
        node = pending.pop()
        if isinstance(node, fluent.VariableReference):
            found.add(node.id.name)
        if isinstance(node, fluent.BaseNode):
            pending.extend(vars(node).values())
        elif isinstance(node, list):
            pending.extend(node)
    return found


@cache
def codes_in_source() -> dict[str, str]:
    """Codes that are given to faults by name, and where."""
    return {code: place for path, tree in modules().items() for code, place in _codes(path, tree)}


def _codes(path: Path, tree: ast.Module) -> Iterator[tuple[str, str]]:
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = _maker(node)
        if name not in MAKERS:
            continue
        given = [keyword.value for keyword in node.keywords if keyword.arg == "code"]
        if not given and name != "Fault":
            given = node.args[:1]
        for value in given:
            if isinstance(value, ast.Constant) and isinstance(value.value, str):
                yield value.value, f"{shown(path)}:{node.lineno}"


def _maker(call: ast.Call) -> str:
    """The name of what is called; `Fault.at` is given what every `fault` is."""
    if ast.unparse(call.func) == "Fault.at":
        return "fault"
    return call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")


@cache
def strings_in_source() -> frozenset[str]:
    return frozenset(
        node.value
        for tree in modules().values()
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_file_is_sound(language: str) -> None:
    for room in ROOMS:
        found = parsed(language, room)
        assert found, room
        assert not [entry.content for entry in found if isinstance(entry, fluent.Junk)]
        names = [entry.id.name for entry in found if isinstance(entry, fluent.Message | fluent.Term)]
        assert len(names) == len(set(names)), room


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_languages_have_the_same_messages_with_the_same_parameters(language: str) -> None:
    for room in ROOMS:
        english = {name: variables(entry) for name, entry in entries("en", room).items()}
        other = {name: variables(entry) for name, entry in entries(language, room).items()}
        assert other == english, room


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_language_has_a_file_of_its_own(language: str) -> None:
    catalogue_texts = set() if language == "en" else {"robots.ftl"}
    assert {path.name for path in (LOCALES / language).iterdir()} == {*ROOMS, *catalogue_texts}


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_the_catalogue_is_told_in_every_language(language: str) -> None:
    """Its English, and the names that are the same everywhere, stand in the robots' own files alone."""
    told = {name: _text(entry) for name, entry in entries(language, "robots.ftl").items()}
    robots = catalogue.robots()
    names = {f"robot-{robot.id}": robot.name for robot in robots}
    meanings = {f"configuration-{robot.id}-{name}" for robot in robots for name in robot.configurations}
    assert {name for name in told if not name.startswith("robot-")} == meanings
    assert not [name for name, text in told.items() if names.get(name, "") == text]
    assert {name for name in told if name.startswith("robot-")} <= set(names)


def test_every_refusal_has_a_message() -> None:
    known = {name for room in ROOMS for name in entries("en", room)}
    silent = {code: place for code, place in codes_in_source().items() if f"error-{code}" not in known}
    assert not silent


def test_every_refusal_gives_what_its_message_names() -> None:
    messages = {name: entry for room in ROOMS for name, entry in entries("en", room).items()}
    lacking = []
    checked = 0
    for path, tree in modules().items():
        for code, given, line in _parameters_given(tree):
            checked += 1
            missing = variables(messages[f"error-{code}"]) - given
            if missing:
                lacking.append(f"{shown(path)}:{line}: {code} without {sorted(missing)}")
    assert not lacking
    assert checked > 300


def _parameters_given(tree: ast.Module) -> Iterator[tuple[str, set[str], int]]:
    """Code, names of parameters and line of every fault whose parameters are written out where it is made."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = _maker(node)
        named = {keyword.arg: keyword.value for keyword in node.keywords}
        code = named.get("code") or (node.args[0] if node.args and name == "fault" else None)
        if name not in {"fault", "Fault"} or None in named:
            continue
        if not isinstance(code, ast.Constant) or not isinstance(code.value, str):
            continue
        if name == "fault":
            yield code.value, {key for key in named if key is not None}, node.lineno
        elif (params := named.get("params")) is None:
            yield code.value, set(), node.lineno
        elif isinstance(params, ast.Dict):
            keys = {key.value for key in params.keys if isinstance(key, ast.Constant)}
            if len(keys) == len(params.keys):
                yield code.value, {str(key) for key in keys}, node.lineno


def test_no_message_is_about_nothing() -> None:
    spoken = {name for room in ROOMS for name in entries("en", room) if name.startswith("error-")}
    unused = sorted(name for name in spoken if name.removeprefix("error-") not in strings_in_source())
    assert not unused


def test_no_message_is_defined_in_two_rooms() -> None:
    seen: dict[str, str] = {}
    twice = []
    for room in ROOMS:
        for name in entries("en", room):
            if name in seen:
                twice.append(f"{name}: {seen[name]} and {room}")
            seen[name] = room
    assert not twice


def test_translations_are_translations() -> None:
    """A sentence of some length that equals the English one was forgotten."""
    forgotten = []
    for room in ROOMS:
        english = {name: _text(entry) for name, entry in entries("en", room).items()}
        for language in LANGUAGES[1:]:
            for name, entry in entries(language, room).items():
                text = _text(entry)
                if len(text) > 40 and text == english.get(name):
                    forgotten.append(f"{language}/{room}: {name}")
    assert not forgotten


def _text(entry: fluent.BaseNode) -> str:
    found: list[str] = []
    pending: list[object] = [entry]
    while pending:
        node = pending.pop()
        if isinstance(node, fluent.TextElement):
            found.append(node.value)
        if isinstance(node, fluent.BaseNode):
            pending.extend(vars(node).values())
        elif isinstance(node, list):
            pending.extend(node)
    return "".join(sorted(found))


def test_locales_hold_nothing_else() -> None:
    strays = [shown(path) for path in tracked() if path.is_relative_to(LOCALES) and path.suffix != ".ftl"]
    assert not strays
