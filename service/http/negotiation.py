"""Content negotiation: which language and which media type a caller prefers (RFC 9110 §12, RFC 4647 §3.4)."""

from collections.abc import Sequence
from functools import lru_cache

from service.messages import DEFAULT_LANGUAGE


def weighted(header: str) -> tuple[tuple[str, float], ...]:
    """Return the items of an Accept-style header in lower case with their q-values, the most wanted first.

    Items whose weight cannot be read are ignored.
    """
    items: list[tuple[str, float]] = []
    for part in header.split(","):
        value, *parameters = (piece.strip() for piece in part.split(";"))
        quality = 1.0
        for parameter in parameters:
            name, _, number = parameter.partition("=")
            if name.strip().lower() == "q":
                quality = _quality(number.strip())
        if value and 0.0 <= quality <= 1.0:
            items.append((value.lower(), quality))
    return tuple(sorted(items, key=lambda item: -item[1]))


@lru_cache(maxsize=256)
def preferred_language(header: str, available: tuple[str, ...]) -> str:
    """Return the available language that the caller wants most; the wish for pt-BR is met by pt."""
    items = weighted(header)
    refused = {tag for tag, quality in items if quality == 0.0}
    for tag, quality in items:
        if quality == 0.0:
            continue
        if tag == "*":
            return DEFAULT_LANGUAGE
        while tag:
            if tag in available and tag not in refused:
                return tag
            tag = tag.rpartition("-")[0]
    return DEFAULT_LANGUAGE


@lru_cache(maxsize=256)
def preferred_media_type(header: str, offers: tuple[str, ...]) -> str | None:
    """Return the offered media type that the caller wants most, the first of equals; None if none will do."""
    items = weighted(header)
    if not items:
        return offers[0]
    best = max(offers, key=lambda offer: _acceptance(offer, items))
    return best if _acceptance(best, items) > 0.0 else None


def _acceptance(offer: str, items: Sequence[tuple[str, float]]) -> float:
    wanted = dict(reversed(items))
    for pattern in (offer, offer.partition("/")[0] + "/*", "*/*"):
        if pattern in wanted:
            return wanted[pattern]
    return 0.0


def _quality(number: str) -> float:
    try:
        return float(number)
    except ValueError:
        return -1.0
