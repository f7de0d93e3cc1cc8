from __future__ import annotations

import pytest

from service.http.negotiation import preferred_language, preferred_media_type, weighted

LANGUAGES = ("en", "es", "fr", "pt", "ro", "uk")
OFFERS = ("application/json", "application/x-npy")


@pytest.mark.parametrize(
    ("header", "language"),
    [
        ("ro", "ro"),
        ("pt-BR, en;q=0.5", "pt"),
        ("de, uk;q=0.7, en;q=0.3", "uk"),
        ("de", "en"),
        ("de-AT;q=0.9, fr-CH;q=0.8", "fr"),
        ("EN-gb", "en"),
        ("fr;q=0, es;q=0.1", "es"),
        ("fr;q=0.2, es;q=0.9", "es"),
        ("*", "en"),
        ("fr;q=abc, ro;q=0.1", "ro"),
        ("fr;q=7, ro", "ro"),
        (";;;,,,=", "en"),
        ("uk-Cyrl-UA", "uk"),
        ("pt-BR, pt;q=0", "en"),
    ],
)
def test_the_most_wanted_available_language_is_chosen(header: str, language: str) -> None:
    assert preferred_language(header, LANGUAGES) == language


@pytest.mark.parametrize(
    ("header", "media_type"),
    [
        ("*/*", "application/json"),
        ("application/*", "application/json"),
        ("application/x-npy", "application/x-npy"),
        ("application/json;q=0.2, application/x-npy", "application/x-npy"),
        ("application/x-npy;q=0, */*", "application/json"),
        ("application/json;q=0, */*;q=0.1", "application/x-npy"),
        ("text/html, application/xhtml+xml, */*;q=0.8", "application/json"),
        ("text/html", None),
        ("application/json;q=0", None),
        ("", "application/json"),
        ("nonsense", None),
        ("APPLICATION/JSON", "application/json"),
    ],
)
def test_the_most_wanted_offer_is_chosen(header: str, media_type: str | None) -> None:
    assert preferred_media_type(header, OFFERS) == media_type


def test_items_are_sorted_by_weight_and_stable() -> None:
    assert weighted("a;q=0.5, b, c;q=0.5") == (("b", 1.0), ("a", 0.5), ("c", 0.5))
