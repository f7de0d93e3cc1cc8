from __future__ import annotations

import re

import pytest
from fluent.runtime import FluentBundle, FluentResource
from fluent.syntax import FluentParser, ast

from kinematics.keys import ValueKind
from service import messages
from service.http.languages import language_for
from service.messages import (
    FUNCTIONS,
    LOCALES,
    REGIONS,
    in_sentence,
    languages,
    plainly_written,
    sentence,
    template,
)


def test_six_languages_are_spoken() -> None:
    assert languages() == ("en", "es", "fr", "pt", "ro", "uk")


@pytest.mark.parametrize(
    ("header", "language"), [(None, "en"), ("", "en"), ("ro-MD", "ro"), ("x" * 5000, "en")]
)
def test_the_language_is_read_from_the_header(header: str | None, language: str) -> None:
    assert language_for(header) == language


def test_parameters_stand_in_the_sentence() -> None:
    assert "1.048.576" in (sentence("es", "error-body_too_large", {"limit": 1048576}) or "")
    assert "“tool”" in (sentence("en", "error-field_missing", {"field": "tool"}) or "")
    assert "a, b" in (sentence("en", "error-field_unknown", {"field": "c", "allowed": ("a", "b")}) or "")


@pytest.mark.parametrize(
    ("language", "told"),
    [
        ("en", "on 22 November 2026, 16:00 UTC"),
        ("fr", "22 novembre 2026, 16:00 UTC"),
        ("uk", "22 листопада 2026"),
    ],
)
@pytest.mark.parametrize(
    ("code", "parameter"), [("error-attempts_closed", "closes"), ("error-attempts_not_open", "opens")]
)
def test_a_time_is_told_as_the_language_writes_it(
    language: str, told: str, code: str, parameter: str
) -> None:
    assert told in (sentence(language, code, {parameter: "2026-11-22T18:00:00+02:00"}) or "")


@pytest.mark.parametrize("language", languages())
def test_one_attempt_is_told_as_one(language: str) -> None:
    assert "1" not in (sentence(language, "error-attempts_used_up", {"limit": 1}) or "1")
    assert "2" in (sentence(language, "error-attempts_used_up", {"limit": 2}) or "")


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize(
    ("code", "none", "some"),
    [
        ("task-orientation", {"ask": "none"}, {"ask": "every"}),
        ("task-singularities", {"lost": "no"}, {"lost": "yes"}),
    ],
)
def test_a_task_that_asks_for_nothing_more_ends_in_no_blank(
    language: str, code: str, none: dict[str, str], some: dict[str, str]
) -> None:
    given = {"given": "matrix", "asked_axes": "Z", "asked_turning": "fixed", "motion": "twist", "unit": "m"}
    alone, more = (sentence(language, code, {**given, **asked}) or "" for asked in (none, some))
    assert alone[-1] in ".?"
    assert more.startswith(f"{alone} ")


def test_portuguese_counts_as_in_portugal() -> None:
    """In Brazil none is told as one is, and thousands have a point."""
    assert sentence("pt", "author-points-total", {"points": 0}) == "No total: 0 pontos."
    assert "1\u00a0048\u00a0576" in (sentence("pt", "error-body_too_large", {"limit": 1048576}) or "")


def test_what_a_caller_sent_is_cut_short_in_a_sentence() -> None:
    assert len(sentence("en", "error-address_unknown", {"path": "/" + "x" * 10_000}) or "") < 400


@pytest.mark.parametrize(("language", "told"), [("en", "(0; −0.15; 1.5)"), ("fr", "(0; −0,15; 1,5)")])
def test_numbers_in_a_sentence_are_written_as_the_language_writes_them(language: str, told: str) -> None:
    given = {"name": "L-1", "place": "(0; -0.15; 1.5)", "joint": 2}
    assert in_sentence(given, language) == {"name": "L-1", "place": told, "joint": 2}


def test_a_long_list_ends_with_a_whole_item() -> None:
    names = tuple(f"exercise-{i}" for i in range(100))
    told = sentence("en", "error-exercise_unknown", {"id": "x", "known": names}) or ""
    assert told == sentence("en", "error-exercise_unknown", {"id": "x", "known": ", ".join(names)})
    assert re.search(r"exercise-1, .*exercise-\d+, …\.$", told)
    assert set(re.findall(r"[\w-]*-\d+", told)) <= set(names)


def test_numbers_that_are_not_counts_keep_their_digits() -> None:
    told = sentence("fr", "error-number_too_small", {"limit": 1e-9, "bound": "included"})
    assert "1e-09" in (told or "")


@pytest.mark.parametrize("language", ["en", "uk"])
def test_messages_are_found_as_fluent_finds_them(language: str) -> None:
    whole = FluentBundle([REGIONS.get(language, language)], use_isolating=False, functions=FUNCTIONS)
    texts = [path.read_text(encoding="utf-8") for path in sorted((LOCALES / language).glob("*.ftl"))]
    read = FluentParser().parse("\n".join(texts)).body
    whole.add_resource(ast.Resource(read))
    named: dict[str, object] = dict.fromkeys(re.findall(r"\$([\w-]+)", "".join(texts)), 3)
    named |= {"opens": "2026-11-22T18:00:00+00:00", "closes": "2026-11-22T18:00:00+00:00"}
    for entry in read:
        assert not isinstance(entry, (ast.Junk, ast.Term))
        if isinstance(entry, ast.Message) and entry.value:
            pattern = whole.get_message(entry.id.name).value
            assert pattern is not None
            assert sentence(language, entry.id.name, named) == whole.format_pattern(pattern, named)[0]


@pytest.mark.parametrize(
    ("language", "one", "many"),
    [
        ("en", "1 byte,", "1,024 bytes,"),
        ("es", "1 byte,", "1.024 bytes,"),
        ("fr", "1 octet,", "octets,"),
        ("pt", "1 byte,", "bytes,"),
        ("ro", "1 octet,", "1.024 de octeți,"),
        ("uk", "1 байт —", "байти —"),
    ],
)
def test_a_limit_is_counted_as_the_language_counts(language: str, one: str, many: str) -> None:
    assert one in (sentence(language, "error-body_too_large", {"limit": 1}) or "")
    assert many in (sentence(language, "error-body_too_large", {"limit": 1024}) or "")


@pytest.mark.parametrize("convention", ["standard", "modified"])
@pytest.mark.parametrize("language", languages())
def test_a_convention_is_named_in_the_language(language: str, convention: str) -> None:
    named = sentence(language, f"form-convention-{convention}", {})
    assert named
    assert named in (sentence(language, "error-convention_not_asked", {"asked": convention}) or "")


@pytest.mark.parametrize("reason", ["empty", "binary", "columns", "UTF-16"])
@pytest.mark.parametrize("language", languages())
def test_why_a_file_cannot_be_read_is_a_sentence(language: str, reason: str) -> None:
    told = sentence(language, "error-file_unreadable", {"file": "t.csv", "reason": reason}) or ""
    assert told
    assert not told.endswith(f": {reason}.")


def test_an_unknown_message_is_none() -> None:
    assert sentence("ro", "error-of-nobody") is None


def test_a_template_names_its_parameters() -> None:
    assert template("en", "error-body_too_large") == (
        "The body is larger than {limit} bytes, the most that this call reads."
    )


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("code", ["catalogue_value_type", "exercise_value_type"])
def test_what_a_value_has_to_be_is_told_in_every_language(language: str, code: str) -> None:
    known = {"count": 3, "width": 6, "known": "a, b", "key": "joints"}
    told = {
        kind: sentence(language, f"error-{code}", {**known, "expected": kind}) for kind in (*ValueKind, "odd")
    }
    assert len(set(told.values())) == len(told)
    assert all("joints" in str(text) and "{" not in str(text) for text in told.values())
    any_count = {**known, "count": 0, "expected": ValueKind.NUMBERS}
    assert "0" not in str(sentence(language, f"error-{code}", any_count))


@pytest.mark.parametrize("language", languages())
def test_what_is_written_plainly_is_what_fluent_writes(language: str) -> None:
    text = "\n".join(path.read_text(encoding="utf-8") for path in (LOCALES / language).glob("*.ftl"))
    whole = FluentBundle([language], use_isolating=False, functions=FUNCTIONS)
    whole.add_resource(FluentResource(text))
    plain = tried = 0
    for source in re.split(r"^(?=[a-zA-Z][\w-]* *=)", text, flags=re.MULTILINE)[1:]:
        pattern = whole.get_message(source.partition("=")[0].strip()).value
        (read, *_) = FluentParser().parse(source).body
        assert isinstance(read, ast.Message)
        names = set(re.findall(r"\$(\w+)", source))
        for value in ("{ $x }", 7, 1000, -1, *re.findall(r"^\s*\*?\[(\w+)\]", source, re.MULTILINE)):
            given = dict.fromkeys(names, value)
            written = plainly_written(read.value, given) if read.value else None
            tried += 1
            if pattern and written is not None:
                plain += 1
                assert written == whole.format_pattern(pattern, given)[0]
    assert plain > 0.4 * tried


@pytest.mark.parametrize("language", languages())
def test_a_plain_sentence_needs_nothing_that_is_known_of_the_language(
    monkeypatch: pytest.MonkeyPatch, language: str
) -> None:
    def refuse(language: str) -> None:
        raise AssertionError(language)

    monkeypatch.setattr(messages, "_bundle", refuse)
    messages._formatted.cache_clear()
    assert sentence(language, "language-name")


@pytest.mark.parametrize("language", languages())
def test_a_dimension_too_short_is_told_without_a_number_that_nobody_chose(language: str) -> None:
    values = {"name": "L1", "length": 1e-07, "least": 3.395305583e-07}
    said = sentence(language, "error-dimension_too_short", values) or ""
    assert "L1" in said
    assert not re.search("3[.,]39", said)


INCHES = {"en": "inches", "es": "pulgadas", "fr": "pouces", "pt": "polegadas", "ro": "inci", "uk": "дюймах"}


@pytest.mark.parametrize("language", languages())
def test_a_unit_is_a_word_after_in_and_a_symbol_after_a_number(language: str) -> None:
    """“Lengths in in” is no English; “1 inches” is none, either."""
    told = {"n": 2, "start": 0, "end": 1, "point": "P", "limits": "none", "name": "L1", "length": "1"}
    told |= {"course": "vertical", "row": 1}
    for message in ["task-screws", "task-frame-chain", "task-workspace-axis", "form-frames-hint"]:
        assert f" {INCHES[language]}" in (sentence(language, message, {**told, "unit": "in"}) or "")
        millimetres = " мм" if language == "uk" else " mm"
        assert millimetres in (sentence(language, message, {**told, "unit": "mm"}) or "")
    symbols = {"figure-dimension": " 1 in", "given-link-weights": " in²", "form-cell-label": "[in]"}
    for message, symbol in symbols.items():
        assert symbol in (sentence(language, message, {**told, "unit": "in"}) or "")


@pytest.mark.parametrize(("unit", "written"), [("m", "м"), ("cm", "см"), ("mm", "мм")])
def test_ukrainian_sentences_write_units_in_cyrillic_and_fields_as_they_are_typed(
    unit: str, written: str
) -> None:
    told = {"name": "L1", "length": "90", "course": "vertical", "start": "O0", "end": "P", "row": 1}
    said = {
        name: sentence("uk", name, {**told, "unit": unit}) for name in ("figure-dimension", "form-cell-label")
    }
    assert f" 90 {written} " in (said["figure-dimension"] or "")
    assert f"[{unit}]" in (said["form-cell-label"] or "")
