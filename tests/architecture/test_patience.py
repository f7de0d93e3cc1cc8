"""Tests give a busy machine time: what asks over HTTP says how long it waits for an answer."""

import re

from tests.architecture.sources import ROOT, shown

ASKS = re.compile(r"\bhttpx\.(?:get|post|put|patch|delete|request|stream|Client|AsyncClient)\(")
SAYS_HOW_LONG = re.compile(r"\b(timeout|transport)=")
"""A transport of the test's own leads to no other process."""


def call_at(text: str, start: int, end: int) -> str:
    """Return a call from its name on; its arguments begin at `end`."""
    depth = 1
    while depth:
        depth += {"(": 1, ")": -1}.get(text[end], 0)
        end += 1
    return text[start:end]


def test_every_request_says_how_long_it_waits() -> None:
    """Five seconds, which httpx waits by itself, are too few where eight processes share two processors."""
    hasty = []
    for path in sorted((ROOT / "tests").rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        calls = (call_at(text, *found.span()) for found in ASKS.finditer(text))
        hasty += [f"{shown(path)}: {call}" for call in calls if not SAYS_HOW_LONG.search(call)]
    assert hasty == []
