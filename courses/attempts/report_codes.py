"""What a report tells, as a path of stable codes: rows beside its attempt, for statistics."""

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from itertools import islice
from typing import Any, TypeAlias

from exercises.parts.protocol import TABLE
from exercises.parts.registry import part_types

MOST_FINDINGS = 64  # Codes of an attempt that are stored, so that none takes more than a few kilobytes.
Code: TypeAlias = tuple[str, str, int | None]  # Kind, code and row of what a report tells.


def finding_rows(attempt_id: int, link_id: int, path: Iterable[Code]) -> list[dict[str, Any]]:
    """Return the codes of a report as rows beside its attempt, for statistics."""
    return [
        {"attempt_id": attempt_id, "position": i, "link_id": link_id, "kind": kind, "code": code, "row": row}
        for i, (kind, code, row) in enumerate(islice(path, MOST_FINDINGS))
    ]


def path_of_codes(report: Mapping[str, Any]) -> Iterator[Code]:
    """Yield kind, code and row of everything that a stored report tells: its path of stable codes.

    Kinds: `feedback` of the table, `repair` for the edits of the most plausible repair, `wrong` for the facts
    of rows that do not fit and for wrong parts that nothing explains, `part:<kind>` for misconceptions found
    in a part, and `told:<kind>` for whatever else is said of it.
    """
    verdict = report.get("verdict") or {}
    for entry in verdict.get("feedback", ()):
        yield "feedback", str(entry["code"]), entry.get("row")
    for repair in list(verdict.get("repairs", ()))[:1]:
        for edit in repair.get("edits", ()):
            yield "repair", str(edit["code"]), edit.get("row")
    facts = [
        (fact, link.get("row"))
        for link in verdict.get("links", ())
        for fact in ("length", "twist", "offset", "joint")
        if link.get(fact) in ("wrong", "missing")
    ]
    for fact, row in facts:
        yield "wrong", fact, row
    for part in report.get("parts", ()):
        kind, explained = part["kind"], False
        for entry in part.get("feedback", ()):
            code = str(entry["code"])
            named = code in _misconceptions(kind)
            explained |= named
            yield f"{'part' if named else 'told'}:{kind}", code, entry.get("row")
        if part["score"] < 1.0 and not explained and not (kind == TABLE and facts):
            yield "wrong", kind, None


@cache
def _misconceptions(kind: str) -> frozenset[str]:
    """Codes of a part's misconceptions; none for a kind that there is no longer."""
    known = part_types().get(kind)
    return frozenset(known.misconceptions if known else ())
