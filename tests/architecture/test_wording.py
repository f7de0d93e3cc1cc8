"""Each language keeps its typography, and one term for one thing (the glossary stands in CONTRIBUTING.md)."""

from __future__ import annotations

import re

import pytest

from tests.architecture.test_messages import LANGUAGES, LOCALES

PLACEABLE = re.compile(r"\{[^{}]*\}")
APOSTROPHE = {r"\w'": "the apostrophe is ’"}

TYPOGRAPHY: dict[str, dict[str, str]] = {
    "en": {**APOSTROPHE, r"[„«]": "quotation marks are “ and ”"},
    "es": {r"[„“]": "quotation marks are « and »"},
    "fr": {
        **APOSTROPHE,
        r" [:;?!»]|[\w)][;?!»]|«(?!\u00a0)": "a no-break space (U+00A0) goes before : ; ? ! » and after «",
    },
    "pt": {r"[„«]": "quotation marks are “ and ”"},
    "ro": {r"[şţŞŢ]": "ș and ț have commas, not cedillas", r"[«“]": "quotation marks are „ and ”"},
    "uk": {**APOSTROPHE, r"[„“]": "quotation marks are « and »", r"[ыэъёЫЭЪЁ]": "this letter is Russian"},
}


def _sentences(language: str) -> list[tuple[str, str]]:
    """Place and text of each line of the language's files, without names, comments and parameters."""
    found = []
    for path in sorted((LOCALES / language).glob("*.ftl")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            if not line.startswith("#"):
                text = re.sub(r"^[a-z][\w-]* =|^ +\*?\[\w+\]", "", line)
                found.append((f"{language}/{path.name}:{number}", PLACEABLE.sub("{}", text)))
    return found


def _broken(language: str, rules: dict[str, str]) -> list[str]:
    return [
        f"{place}: {why}: …{text[max(match.start() - 20, 0) : match.end() + 20]}…"
        for place, text in _sentences(language)
        for pattern, why in rules.items()
        for match in re.finditer(pattern, text)
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_typography_is_that_of_the_language(language: str) -> None:
    assert not _broken(language, TYPOGRAPHY[language])
