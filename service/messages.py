"""Sentences in the caller's language, from the Fluent files in `locales/<language>/*.ftl`."""

import logging
import re
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from fluent.syntax import FluentParser, ast

# What evaluates messages knows all languages and calendars, and takes long to import.
if TYPE_CHECKING:
    from fluent.runtime import FluentBundle
    from fluent.runtime.types import FluentType

LOCALES = Path(__file__).parent / "locales"
DEFAULT_LANGUAGE = "en"
REGIONS = {"en": "en_GB", "pt": "pt_PT"}
"""Where texts are written as in one of several countries: for their plurals, dates and numbers."""
SENTENCES = 4096  # Sentences in the cache: most students are told the same.
_TEXT_LIMIT = 200  # Characters of what a user typed that a sentence repeats.
_EXACT_INTEGER = 2**53  # Larger ones are told as text: Fluent counts in doubles.

_log = logging.getLogger(__name__)


@cache
def languages() -> tuple[str, ...]:
    """Return the languages that have a folder, in alphabetical order."""
    return tuple(sorted(folder.name for folder in LOCALES.iterdir() if folder.is_dir()))


@lru_cache(maxsize=32)
def _sources(language: str) -> dict[str, str]:
    """Every message of a language as it is written: each is read by Fluent when it is first told.

    To read all of a language takes a quarter of a second and some megabytes, and most of it is never told.
    """
    found: dict[str, str] = {}
    for path in sorted((LOCALES / language).glob("*.ftl")):
        text = path.read_text(encoding="utf-8")
        begins = list(_BEGIN.finditer(text))
        ends = [match.start() for match in begins[1:]] + [len(text)]
        for match, end in zip(begins, ends, strict=True):
            found.setdefault(match[1], text[match.start() : end])
    return found


_BEGIN = re.compile(r"^([a-zA-Z][\w-]*) *=", re.MULTILINE)
_REFERENCE = re.compile(r"\{\s*([a-zA-Z][\w-]*)\s*[}.]")


def _time(moment: str) -> "FluentType":
    """Print an ISO 8601 time in UTC as the language writes dates and hours."""
    from fluent.runtime.types import fluent_date

    moment_utc = datetime.fromisoformat(moment).astimezone(UTC).replace(tzinfo=None)
    told: FluentType = fluent_date(moment_utc, dateStyle="long", timeStyle="short")
    return told


FUNCTIONS: "dict[str, Callable[[Any], FluentType]]" = {"TIME": _time}  # What messages may call.


@lru_cache(maxsize=32)
def _bundle(language: str) -> "FluentBundle":
    from fluent.runtime import FluentBundle

    locales = [REGIONS.get(name, name) for name in (language, DEFAULT_LANGUAGE)]
    return FluentBundle(locales, use_isolating=False, functions=FUNCTIONS)


@lru_cache(maxsize=SENTENCES)
def _read(language: str, identifier: str) -> ast.Message | None:
    """The message of a language as Fluent reads it; None if it has none."""
    source = _sources(language).get(identifier)
    entry = None if source is None else FluentParser().parse(source).body[0]
    return entry if isinstance(entry, ast.Message) else None


def _bundle_with(language: str, identifier: str) -> "FluentBundle":
    """The language's messages with this one, and those that it refers to, among them."""
    messages, read = _bundle(language), _read(language, identifier)
    if read is not None and not messages.has_message(identifier):
        for other in _REFERENCE.findall(_sources(language)[identifier]):
            _bundle_with(language, other)
        messages.add_resource(ast.Resource([read]))
    return messages


def sentence(language: str, identifier: str, params: Mapping[str, object] | None = None) -> str | None:
    """Return the message with its parameters, in the language or else in English; None if there is none."""
    told = {name: _argument(value) for name, value in (params or {}).items()}
    if identifier.startswith("error-"):
        told = {name: _GREEK.sub(_greek, v) if isinstance(v, str) else v for name, v in told.items()}
    return _formatted(language, identifier, tuple(told.items()))


def robot_name(language: str, robot_id: str) -> str | None:
    """Return the name of a catalogue robot in a language; None if it is called there as everywhere."""
    return sentence(language, f"robot-{robot_id}")


@lru_cache(maxsize=SENTENCES)
def _formatted(language: str, identifier: str, arguments: tuple[tuple[str, str | int], ...]) -> str | None:
    for candidate in dict.fromkeys((language, DEFAULT_LANGUAGE)):
        read = _read(candidate, identifier)
        if read is None or read.value is None:
            continue
        values = dict(arguments)
        plain = plainly_written(read.value, values)
        if plain is not None:  # without what Babel knows of the language, which takes a megabyte
            return plain
        messages = _bundle_with(candidate, identifier)
        pattern = messages.get_message(identifier).value
        assert pattern is not None
        text, faults = messages.format_pattern(pattern, values)
        for fault in faults:
            _log.warning("message %s in %s: %s", identifier, candidate, fault)
        return str(text)
    return None


_GREEK = re.compile(r"^(?:alpha$|theta(?=\d*$))")  # Columns and joint variables as the API spells them.


def _greek(match: re.Match[str]) -> str:
    return "α" if match[0] == "alpha" else "θ"


def _argument(value: object) -> str | int:
    """A parameter as Fluent should print it: counts by the language's rules, everything else as it stands."""
    if isinstance(value, int) and not isinstance(value, bool) and abs(value) < _EXACT_INTEGER:
        return value
    if isinstance(value, float):
        return format(value, ".10g")
    if isinstance(value, (tuple, list)):
        value = ", ".join(str(item) for item in value)
    text = str(value)
    return text if len(text) <= _TEXT_LIMIT else _shortened(text)


def _shortened(text: str) -> str:
    """Cut a text at the limit; a list, which has commas, after its last whole item."""
    whole = text[:_TEXT_LIMIT].rpartition(", ")[0]
    return f"{whole}, …" if len(whole) > _TEXT_LIMIT // 2 else text[: _TEXT_LIMIT - 1] + "…"


def in_sentence(params: Mapping[str, object], language: str) -> dict[str, object]:
    """Return parameters with numbers as the language writes them: its decimal sign, and a true minus sign."""
    return {name: _as_written(_argument(value), language) for name, value in params.items()}


def _as_written(value: str | int, language: str) -> str | int:
    if isinstance(value, int):
        return value
    text = _MINUS.sub("\u2212", value) if "-" in value else value
    return text if language == DEFAULT_LANGUAGE else _DECIMAL_POINT.sub(",", text)


_MINUS = re.compile(r"(?<![\w)])-(?=\d)")
_DECIMAL_POINT = re.compile(r"(?<=\d)\.(?=\d)")


@cache
def refusal_codes() -> frozenset[str]:
    """Return every code that has a message."""
    identifiers = _sources(DEFAULT_LANGUAGE)
    return frozenset(name.removeprefix("error-") for name in identifiers if name.startswith("error-"))


def template(language: str, identifier: str) -> str:
    """Return the message with the names of its parameters in braces; of a choice, the usual form."""
    (message,) = FluentParser().parse(_sources(language)[identifier]).body[:1]
    assert isinstance(message, ast.Message)
    assert message.value
    return _plain(message.value)


def _plain(pattern: ast.Pattern) -> str:
    return "".join(
        element.value if isinstance(element, ast.TextElement) else _shown(element.expression)
        for element in pattern.elements
    ).strip()


def _shown(expression: object) -> str:
    if isinstance(expression, ast.SelectExpression):
        return _plain(next(variant.value for variant in expression.variants if variant.default))
    if isinstance(expression, ast.VariableReference):
        return "{" + expression.id.name + "}"
    if isinstance(expression, ast.FunctionReference):
        return _shown(expression.arguments.positional[0])
    return str(getattr(expression, "value", ""))


UNGROUPED = 1000  # Every language writes whole numbers below it with their digits alone.


def plainly_written(pattern: ast.SyntaxNode, values: Mapping[str, str | int]) -> str | None:
    """Return what Fluent makes of a pattern that it has read; None where only Fluent can tell.

    Fluent takes a tenth of a millisecond for a message, and a verdict has twenty, most of them plain.
    """
    parts: list[str] = []
    for element in pattern.elements if isinstance(pattern, ast.Pattern) else (pattern,):
        if isinstance(element, ast.TextElement):
            parts.append(element.value)
            continue
        text = _put_in(element.expression if isinstance(element, ast.Placeable) else element, values)
        if text is None:
            return None
        parts.append(text)
    return "".join(parts)


def _put_in(expression: ast.SyntaxNode, values: Mapping[str, str | int]) -> str | None:
    if isinstance(expression, ast.VariableReference):
        value = values.get(expression.id.name)
        if isinstance(value, str):
            return value
        return str(value) if value is not None and 0 <= value < UNGROUPED else None
    return _chosen(expression, values) if isinstance(expression, ast.SelectExpression) else None


def _chosen(choice: ast.SelectExpression, values: Mapping[str, str | int]) -> str | None:
    """The variant that a text names, or else the usual one; which one a number takes is the language's."""
    if not isinstance(choice.selector, ast.VariableReference):
        return None
    value = values.get(choice.selector.id.name)
    keys = [entry.key.name if isinstance(entry.key, ast.Identifier) else None for entry in choice.variants]
    if not isinstance(value, str) or None in keys:
        return None
    place = keys.index(value) if value in keys else [entry.default for entry in choice.variants].index(True)
    return plainly_written(choice.variants[place].value, values)
