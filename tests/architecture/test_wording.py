"""Each language keeps its typography, and one term for one thing (the glossary stands in CONTRIBUTING.md)."""

import re
from collections.abc import Callable
from functools import cache, partial
from typing import Any

import pytest
from fluent.runtime import FluentBundle, FluentResource

from service.messages import FUNCTIONS, REGIONS, sentence
from tests.architecture.test_messages import LANGUAGES, LOCALES, ROOMS, entries, variables

DEFINITIONS = LOCALES.parent.parent / "exercises" / "definitions"
CATALOGUE = LOCALES.parent.parent / "kinematics" / "catalogue"
PLACEABLE = re.compile(r"\{[^{}]*\}")
APOSTROPHE = {r"\w'": "the apostrophe is ’"}
BEFORE_SIGNS = {
    r"(?<!DOCTYPE)(?<=[^\W\d_]) …": "… follows its word without a space",
    r" %": "a no-break space (U+00A0) goes before %",
}

TYPOGRAPHY: dict[str, dict[str, str]] = {
    "en": {**APOSTROPHE, r"[„«]": "quotation marks are “ and ”"},
    "es": {r"[„“]": "quotation marks are « and »", **BEFORE_SIGNS},
    "fr": {
        **APOSTROPHE,
        **BEFORE_SIGNS,
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
    "en": {
        r"\bcount(?:s|ed)? (?:positive|against|the \w* ?way)": "is positive, increases",
        r"\b(?:link|hand|frame) against\b": "relative to",
        r"\b(?:its|their|no|the) marks?\b": "points are earned; grades are recorded",
        r"\b[Pp]osition (?:shown )?(?:in|of) the figure": "configuration",
        r"\b[Jj]oint forces\b": "joint torques and forces",
    },
    "es": {
        r"[Ff]orma literal": "forma cerrada",
        r"[Aa]rticulaci\w+ (?:de revolución|rotacional)|\brotacional": "de rotación",
        r"\bficheros?\b|\b[Rr]esguardo": "archivo; comprobante",
        r"(?:inercia|masa) M\b": "matriz de masas M",
        r"\bórden(?:es)?\b|\besta orden\b|la orden|cadena serial": "comando; cadena en serie",
        r"[Ee]jes helicoidales|brazo superior|\b[Tt]odas las α": "tornillos; brazo; todos los α",
        r"[Mm]atriz del sistema|\bmuestras\b": "pose de un sistema en otro; ejemplos",
        r"\b[Nn]otas?\b": "puntos; calificación",
        r"cuentan? (?:en sentido|al revés)|[Ss]e cuenta (?:en|al)": "crece, se mide",
        r"posición de la figura": "configuración",
        r"[Ee]ntrenador|sistemas? de coordenadas": "práctica; sistema de referencia",
    },
    "fr": {
        r"[Tt]ables? DH|[Ff]orme (?:fermée|close)": "tableau DH; forme littérale",
        r"\b[Tt]entatives?\b|[Rr]écépissé": "essai; reçu",
        r"\b[Jj]acobien\b": "la jacobienne",
        r"plateforme pédagogique": "plateforme d’apprentissage",
        r"[Cc]inématique inverse|[Mm]atrices? des segments": "modèle géométrique inverse; matrice de passage",
        r"[Aa]xes de vissage|[Ee]fforts articulaires|[Éé]chantillon": "torseurs; couples et forces; exemple",
        r"matrice de passage du|position représentée": "pose d’un repère dans un autre; configuration",
        r"\b[Ll]iaisons?\b|bras vertical|suivant −?x0": "articulation; bras vers le haut; le long de x0",
    },
    "pt": {
        r"\b[Ss]istemas? (?:\{\}|de coordenadas|fixo)": "referencial",
        r"(?:último|primeiro|outro) sistema": "referencial",
        r"[Tt]orques?": "binário",
        r"[Qq]uatérnio": "quaternião",
        r"[Cc]onvenção (?:padrão|clássica)": "convenção standard",
        r"[Ff]orma literal|[Vv]eredito": "forma fechada; veredicto",
        r"\b[Vv]ersor|\bcruza[mr]?\b|\bcortam?-se\b|\bgira\b": "vetor unitário; interseta; roda",
        r"\b[Ee]m outr[oa]s?\b|\bfaltando\b|\baté o\b": "noutro, falta, até ao",
        r"\b(?:usuário|tela|arquivos? d[eo]|você|salvar|celular|registro)\b": "European Portuguese",
        r"(?<!\w)(?:Sua|Seu|Suas|Seus) \w+": "an article stands before a possessive",
        r"\bcontam? (?:no sentido|ao contrário)": "a variable cresce",
        r"\bnoutr[oa] \w+ que (?!não\b)": "num … diferente do …",
        r"\b[Nn]otas?\b|posição da figura": "classificação; configuração",
        r"[Bb]raço superior|\b[Aa]mostras?\b": "braço; exemplo",
        r"(?<!e )\b[Ff]orças nas juntas|[Ee]ixos helicoidais": "binários e forças nas juntas; helicoides",
        r"matriz do (?:último )?referencial|leva do referencial": "pose de um referencial noutro",
    },
    "ro": {
        r"[Ff]orm\w+ (?:literal|analitic)\w+": "formă închisă",
        r"[Uu]n(?:ealt|elt)\w+": "sculă",
        r"\b[Pp]oz(?:a|ă|e|ele|ei|elor)\b": "situare",
        r"\blegătur\w+ (?:robotului|brațului)": "element",
        r"\bnavigator\w*|[Cc]hitanț\w+|[Aa]deverinț\w+": "browser, recipisă",
        r"\blinkuri|[Gg]ripper\w*|\btaie\b": "legături; prehensor; intersectează",
        r"\b[Pp]oziția din (?:figură|desen)": "configurația din figură",
        r"\b[Cc]entrifugal\w*|\b[Rr]eper\w*|\b[Cc]ulis\w*": "centrifug; sistem de coordonate; cuplă, ax",
        r"\b[Aa]ntrenor\w*|[Bb]raț\w* superior|[Aa]xe(?:le)? elicoidale": "exersare; braț; torsori",
        r"\b[XZxz] al (?:sistemului|primului|ultimului|acestui)": "axa x a sistemului",
        r"inversa\w+ între|(?:cote|rânduri|și \S+ sunt) inversate": "schimbate între ele",
        r"(?<!și )\b[Ff]orțe(?:le)? din cuple": "momentele și forțele din cuple",
        r"\bmatricea de la|duce de la sistemul": "situarea unui sistem în altul",
    },
    "uk": {
        r"[Кк]онвенц\w+": "угода",
        r"ДХ": "DH",
        r"[Уу]загальнен\w+ координат\w*": "змінні зчленувань",
        r"[Бб]уквен\w+ вигляд\w*|[Аа]налітичн\w+ (?:форм|вигляд)\w*": "замкнений вигляд",
        r"\b[Сс]хват\w*|\b[Сс]ервіс\w*|\b[Пп]овзун(?:а|ом|ові|і)?\b": "захват; служба; шпиндель",
        r"[Оо]бернен\w+ (?:кінематик|задач\w+(?! кінематики))": "обернена задача кінематики",
        r"[Оо]бмежен\w+ зчленуван\w*|[Тт]іл(?:о|а|ом) зчленуван\w*": "межі зчленування; корпус зчленування",
        r"[Зз]наченн\w* зчленуван\w*|[Зз]аокругл\w*": "значення у зчленуваннях; округлити",
        r"\b[Зз]апит(?:ується|ува\w+|ан(?:о|і|их|ий|а))\b": "потрібно подати",
        r"[Пп]оложенн\w на рисунку": "конфігурація на рисунку",
        r"зустріча\w+ (?:вісь|осі)|[Пп]ри \d": "перетинає вісь; якщо … дорівнює",
        r"[Мм]атриц\w+ переходу|[Гг]винтов\w+ ос": "поза системи в іншій; гвинти зчленувань",
        r"[Зз]усилл\w+ [ву] |(?<!й )\b[Сс]ил\w+ [ву] зчленуван": "моменти й сили у зчленуваннях",
    },
}
"""What is not said, and what is said instead: one term for one thing."""


@pytest.mark.parametrize("language", TERMS)
def test_one_thing_has_one_term(language: str) -> None:
    assert not _broken(language, TERMS[language])


COUNTS = re.compile(
    "allowed|choices|count|deepest|depth|digits|elements|entries|expected|failed|given|joints|length|limit|most|"
    "passed|points|rows|total|values"
)
"""Parameters that count what the next word names."""
FEW = re.compile(
    "task-pose|playground-singular-choice|check-rounded|form-unit-converted-but|error-function_arity|error-vector_length|"
    "error-urdf_numbers_malformed|feedback-branch_.*|feedback-jacobian_.*"
)
"""Messages in which such a parameter is a name or a list, or counts no more than a robot's joints."""
GENITIVES = r"\w+(?:ів|їв|ей|ок|ень|вань|имен|ій)\b|(?:цифр|імен)\b"
UNINFLECTED = {
    "ro": (100, r"\b100 (?!de |din |au |sunt |unul |rad |nereușite)[a-zăâîșț]{2,}"),
    "uk": (22, rf"(?<!до )(?<![Зз] )\b22 (?:різних )?(?:{GENITIVES})"),
}
"""A number, and a noun after it that does not have the form that the number asks for."""


Sentence = Callable[[dict[str, Any]], str]


def _formatted(bundle: FluentBundle, pattern: Any, values: dict[str, Any]) -> str:
    return str(bundle.format_pattern(pattern, values)[0])


@cache
def _told(language: str) -> dict[str, tuple[set[str], Sentence]]:
    """The parameters of each message, and the sentence that it becomes with values for them."""
    bundle = FluentBundle([REGIONS.get(language, language)], use_isolating=False, functions=FUNCTIONS)
    found: dict[str, tuple[set[str], Sentence]] = {}
    for room in ROOMS:
        bundle.add_resource(FluentResource((LOCALES / language / room).read_text(encoding="utf-8")))
        for name, entry in entries(language, room).items():
            pattern = bundle.get_message(name).value
            assert pattern is not None
            found[name] = variables(entry), partial(_formatted, bundle, pattern)
    return found


@pytest.mark.parametrize("language", UNINFLECTED)
def test_counted_nouns_are_inflected(language: str) -> None:
    number, uninflected = UNINFLECTED[language]
    found = []
    for name, (parameters, formatted) in _told(language).items():
        told = formatted({each: number if COUNTS.fullmatch(each) else "…" for each in parameters})
        if not FEW.fullmatch(name) and re.search(uninflected, told):
            found.append(f"{name}: {told}")
    assert found == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_none_is_not_told_as_one(language: str) -> None:
    """French has one plural for 0 and 1: a number that is written as a word belongs to 1 alone."""
    found = []
    for name, (parameters, formatted) in _told(language).items():
        for counted in filter(COUNTS.fullmatch, parameters):
            none, one, two, three = (
                formatted({**dict.fromkeys(parameters, 5), counted: n}) for n in range(4)
            )
            if none == one and two != three:
                found.append(name)
    assert found == []


COUNTS_OF_ONE: dict[str, dict[str, object]] = {
    "check-counts": {"exercise": "a", "passed": 1, "failed": 1, "warnings": 1},
    "error-attempts_used_up": {"limit": 1},
    "error-axis_not_before": {"axis": 3, "before": 1},
    "error-frames_too_many": {"count": 1},
    "error-limits_wrong_length": {"expected": 1, "given": 1},
    "error-screw_count": {"expected": 1, "given": 1},
    "error-urdf_joint_names": {"expected": 1, "given": 1},
    "error-urdf_link_names": {"expected": 1, "given": 1},
    "grade-summary": {"right": 1, "wrong": 1, "ungraded": 1},
    "session-grade": {"points": 1, "total": 2},
    "warm-counts": {"exercise": "a", "values": 1, "figures": 1, "forms": 1, "failed": 1, "seconds": 2},
}
"""Messages that can count one of a thing."""


PLURALS_OF_ONE = {
    "en": r"\b1 (?!is\b|was\b)\w+s\b|\b(?:one|1) were\b",
    "es": r"\b1 \w+s\b|\bdieron (?:un|1)\b",
    "fr": r"\b1 \w+s\b|\b1 ont\b",
    "pt": r"\b1 \w+(?:s|m)\b|\b(?:os|as|foram dados|contam) 1\b",
    "ro": r"\b1 (?:corecte|greșite|nereușite)\b|\bs-au dat 1\b|\bcele 1\b",
}


@pytest.mark.parametrize("name", COUNTS_OF_ONE)
@pytest.mark.parametrize("language", PLURALS_OF_ONE)
def test_one_of_a_thing_is_singular(language: str, name: str) -> None:
    told = sentence(language, name, COUNTS_OF_ONE[name])
    assert told is not None
    assert not re.search(PLURALS_OF_ONE[language], told, re.IGNORECASE)
