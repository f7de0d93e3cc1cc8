"""Every refusal of a cell has its sentence in every language, with every value in place."""

import re

import pytest

from service.messages import LOCALES, languages, sentence

SENTENCES = dict(
    re.findall(
        r"^error-(\w+) =((?:.*\n)(?:[ }].*\n)*)",
        (LOCALES / "en" / "cells.ftl").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
)

PARAMS = {
    "column": 3,
    "limit": 5,
    "length": 7,
    "kind": "angle",
    "other": "length",
    "character": "U+200B",
    "latin": "a",
    "command": "foo",
    "text": "L1",
    "size": "large",
    "largest": 1e15,
    "suggestion": "0.5",
    "name": "q1",
    "functions": ("sin", "cos"),
    "expected": 2,
    "given": 3,
    "symbol": "+",
    "factor": "2",
    "cell": "alpha",
    "joint": "prismatic",
    "joints": 4,
    "rows": 65,
    "number": "1e-3",
    "difference": "1*D - 3",
}


GREEK = {"alpha": "α", "theta": "θ"}


@pytest.mark.parametrize("language", ["en", "ro", "pt", "fr", "uk", "es"])
def test_every_code_has_a_sentence(language, caplog):
    assert language in languages()
    source = (LOCALES / language / "cells.ftl").read_text(encoding="utf-8")
    for code, english in SENTENCES.items():
        params = {name: value for name, value in PARAMS.items() if "$" + name in english}
        text = sentence(language, f"error-{code}", params)
        assert text, code
        assert not caplog.records, code  # a parameter that the message lacks, or one that it does not know
        assert f"error-{code} =" in source
        for name, value in params.items():
            if name not in {"kind", "other", "joint", "expected", "functions", "size"}:
                shown = format(value, ".10g") if isinstance(value, float) else str(value)
                assert GREEK.get(shown, shown) in text, (code, name)


def test_greek_letters_are_told_as_people_write_them():
    params = {"column": 1, "name": "theta1", "cell": "alpha"}
    assert "θ1 stands under α" in (sentence("en", "error-variable_in_constant_cell", params) or "")
    assert "thetas stands under alphabet" in (
        sentence("en", "error-variable_in_constant_cell", {**params, "name": "thetas", "cell": "alphabet"})
        or ""
    )


def test_functions_of_two_arguments_are_shown_with_both():
    shown = {"atan2": "atan2(y, x)", "arctan2": "arctan2(y, x)", "sin": "sin(x)"}
    for name, call in shown.items():
        for language in languages():
            text = sentence(language, "error-function_without_parentheses", {"column": 1, "name": name})
            assert (text or "").replace("\u2068", "").replace("\u2069", "").endswith(f"{call}."), (
                language,
                text,
            )
