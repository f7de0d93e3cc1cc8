from __future__ import annotations

import pytest

from service.http.languages import language_for
from service.messages import languages, sentence, template


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


def test_what_a_caller_sent_is_cut_short_in_a_sentence() -> None:
    assert len(sentence("en", "error-address_unknown", {"path": "/" + "x" * 10_000}) or "") < 400


def test_numbers_that_are_not_counts_keep_their_digits() -> None:
    assert "1e-09" in (sentence("fr", "error-number_too_small", {"limit": 1e-9}) or "")


def test_an_unknown_message_is_none() -> None:
    assert sentence("ro", "error-of-nobody") is None


def test_a_template_names_its_parameters() -> None:
    assert template("en", "error-body_too_large") == (
        "The body is larger than {limit} bytes, the most that this call reads."
    )
