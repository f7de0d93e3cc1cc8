"""Each language keeps its typography, and one term for one thing (the glossary stands in CONTRIBUTING.md)."""

from __future__ import annotations

import re

import pytest

from tests.architecture.test_messages import LANGUAGES, LOCALES

DEFINITIONS = LOCALES.parent.parent / "exercises" / "definitions"
CATALOGUE = LOCALES.parent.parent / "kinematics" / "catalogue"
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


def _told_by_exercises(language: str) -> list[tuple[str, str]]:
    """Place and text of the statements and titles in a language, formulas left out."""
    found = [
        (path.parent.name, re.sub(r"\$[^$]*\$|`[^`]*`", "", path.read_text(encoding="utf-8")))
        for path in sorted(DEFINITIONS.glob(f"*/*.{language}.md"))
    ]
    for path in sorted([*DEFINITIONS.glob("*/exercise.toml"), *CATALOGUE.glob("*.toml")]):
        titles = re.findall(rf'^{language} = "(.*)"$', path.read_text(encoding="utf-8"), re.MULTILINE)
        found.extend((f"{path.parent.name}/{path.name}", title) for title in titles)
    return found


def _broken(language: str, rules: dict[str, str]) -> list[str]:
    return [
        f"{place}: {why}: …{text[max(match.start() - 20, 0) : match.end() + 20]}…"
        for place, text in [*_sentences(language), *_told_by_exercises(language)]
        for pattern, why in rules.items()
        for match in re.finditer(pattern, text)
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_typography_is_that_of_the_language(language: str) -> None:
    assert not _broken(language, TYPOGRAPHY[language])


TERMS: dict[str, dict[str, str]] = {
    "es": {
        r"[Ff]orma literal": "forma cerrada",
        r"[Aa]rticulaci\w+ (?:de revolución|rotacional)|\brotacional": "de rotación",
        r"\bficheros?\b|\b[Rr]esguardo": "archivo; comprobante",
        r"(?:inercia|masa) M\b": "matriz de masas M",
    },
    "fr": {
        r"[Tt]ables? DH|[Ff]orme (?:fermée|close)": "tableau DH; forme littérale",
        r"\b[Tt]entatives?\b|[Rr]écépissé": "essai; reçu",
        r"\b[Jj]acobien\b": "la jacobienne",
        r"plateforme pédagogique": "plateforme d’apprentissage",
    },
    "pt": {
        r"\b[Ss]istemas? (?:\{\}|de coordenadas|fixo)": "referencial",
        r"(?:último|primeiro|outro) sistema": "referencial",
        r"[Tt]orques?": "binário",
        r"[Qq]uatérnio": "quaternião",
        r"[Cc]onvenção (?:padrão|clássica)": "convenção standard",
        r"[Ff]orma literal|[Vv]eredito": "forma fechada; veredicto",
        r"\b[Ee]m outr[oa]s?\b|\bfaltando\b|\baté o\b": "noutro, falta, até ao",
        r"\b(?:usuário|tela|arquivos? d[eo]|você|salvar|celular|registro)\b": "European Portuguese",
        r"(?<!\w)(?:Sua|Seu|Suas|Seus) \w+": "an article stands before a possessive",
    },
    "ro": {
        r"[Ff]orm\w+ (?:literal|analitic)\w+": "formă închisă",
        r"[Uu]n(?:ealt|elt)\w+": "sculă",
        r"\b[Pp]oz(?:a|ă|e|ele|ei|elor)\b": "situare",
        r"\blegătur\w+ (?:robotului|brațului)": "element",
        r"\bnavigator\w*|[Cc]hitanț\w+|[Aa]deverinț\w+": "browser, recipisă",
    },
    "uk": {
        r"[Кк]онвенц\w+": "угода",
        r"ДХ": "DH",
        r"[Уу]загальнен\w+ координат\w*": "змінні зчленувань",
        r"[Бб]уквен\w+ вигляд\w*|[Аа]налітичн\w+ (?:форм|вигляд)\w*": "замкнений вигляд",
        r"\b[Сс]хват\w*|\b[Сс]ервіс\w*": "захват; служба",
    },
}
"""What is not said, and what is said instead: one term for one thing."""


@pytest.mark.parametrize("language", TERMS)
def test_one_thing_has_one_term(language: str) -> None:
    assert not _broken(language, TERMS[language])
