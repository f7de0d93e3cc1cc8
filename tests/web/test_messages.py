"""One set of messages serves API and form: nothing is missing, in any language, and nothing is left over."""

import re

import pytest
from fluent.syntax import FluentParser, ast

from service.messages import LOCALES
from tests.web.conftest import LANGUAGES, ROOT

ROOM = r"(?:form|playground|receipts|trainer)"
OTHERWISE = r"(?<!class: )(?<!id: )(?<!Event\()(?<!Listener\()(?<!add\()"
QUOTED = re.compile(rf"""{OTHERWISE}["'`]({ROOM}-[a-z0-9]+(?:-[a-z0-9]+)*)["'`]""")
STEM = re.compile(rf"""`({ROOM}-(?:[a-z0-9]+-)*)\$\{{""")
REFERENCE = re.compile(r"\{ ([a-z][a-z-]+) \}")
FIELD = re.compile(r'say\("([a-z][a-z0-9-]*)"\)')


def messages(language: str, room: str) -> dict[str, ast.Message]:
    path = LOCALES / language / f"{room}.ftl"
    body = FluentParser().parse(path.read_text(encoding="utf-8")).body
    broken = [entry.content for entry in body if isinstance(entry, ast.Junk)]
    assert broken == [], path
    return {entry.id.name: entry for entry in body if isinstance(entry, ast.Message)}


def variables(message: ast.Message) -> set[str]:
    found: set[str] = set()

    def visit(node: object) -> None:
        if isinstance(node, ast.VariableReference):
            found.add(node.id.name)
        if isinstance(node, ast.BaseNode):
            for value in vars(node).values():
                for item in value if isinstance(value, list) else [value]:
                    visit(item)

    visit(message.value)
    return found


ROOMS = [
    room
    for room in ("form", "playground", "receipts", "trainer")
    if (LOCALES / "en" / f"{room}.ftl").is_file()
]


@pytest.mark.parametrize("room", ROOMS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_no_language_lacks_a_message_or_a_parameter(language: str, room: str) -> None:
    english, other = messages("en", room), messages(language, room)
    assert sorted(english.keys() - other.keys()) == []
    assert sorted(other.keys() - english.keys()) == []
    differing = {name for name in english if variables(english[name]) != variables(other[name])}
    # A count may stand in the sentence of one language and not of another ("one row").
    assert {n for n in differing if variables(english[n]) ^ variables(other[n]) - {"rows", "count"}} == set()


@pytest.mark.parametrize("room", ROOMS)
@pytest.mark.parametrize("language", [language for language in LANGUAGES if language != "en"])
def test_messages_are_translated(language: str, room: str) -> None:
    english, other = messages("en", room), messages(language, room)

    def text(message: ast.Message) -> str:
        parts = message.value.elements if message.value else []
        return "".join(part.value for part in parts if isinstance(part, ast.TextElement))

    long = [name for name in english if len(text(english[name])) > 24]
    assert [name for name in long if text(english[name]) == text(other[name])] == []


def test_what_scripts_and_templates_say_exists_and_what_exists_is_said() -> None:
    known = set().union(*(messages("en", room).keys() for room in ROOMS))
    said: set[str] = set()
    stems: set[str] = set()
    for path in (ROOT / "static" / "js").rglob("*.js"):
        text = path.read_text(encoding="utf-8")
        said |= set(QUOTED.findall(text))
        stems |= set(STEM.findall(text))
    for path in (ROOT / "service" / "web" / "templates").glob("*.html"):
        said |= set(FIELD.findall(path.read_text(encoding="utf-8")))
    for path in (path for room in ("routes", "web") for path in (ROOT / "service" / room).rglob("*.py")):
        said |= set(QUOTED.findall(path.read_text(encoding="utf-8")))
    for room in ROOMS:
        said |= set(REFERENCE.findall((LOCALES / "en" / f"{room}.ftl").read_text(encoding="utf-8")))
    assert not {f"{room}-" for room in ROOMS} & stems, "any message would do"
    assert sorted(name for name in said - known if name.split("-")[0] in ROOMS) == []
    assert sorted(name for name in known - said if not any(name.startswith(stem) for stem in stems)) == []
