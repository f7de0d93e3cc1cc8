"""A verdict as a notebook shows it: the score, what was found row by row, and the codes of the feedback."""

from dataclasses import asdict
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from exercises.grading.verdict import Verdict

_MARKS = {"ok": "✓", "wrong": "✗", "missing": "∅", "unknown": "?", "hidden": "·"}
_COLUMNS = ("row", "length", "twist", "offset", "joint")


def verdict_html(verdict: "Verdict") -> str:
    """Return a verdict as HTML; its fields are the words, for sentences belong to a language."""
    sign = "✓" if verdict.correct else "✗"
    summary = f"<p><b>{sign} {verdict.score:.2f}</b> ({escape(verdict.basis.value)})</p>"
    heads = "".join(f"<th>{column}</th>" for column in _COLUMNS)
    rows = "".join(_row(asdict(link)) for link in verdict.links)
    table = f"<table><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>" if rows else ""
    told = [_told(item.code, item.row) for item in verdict.feedback]
    told += ["; ".join(_told(edit.code, edit.row) for edit in repair.edits) for repair in verdict.repairs]
    items = "".join(f"<li>{item}</li>" for item in told)
    return summary + table + (f"<ul>{items}</ul>" if items else "")


def _row(link: dict[str, object]) -> str:
    cells = [str(link["row"]), *(_MARKS[str(link[column])] for column in _COLUMNS[1:])]
    return f"<tr>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"


def _told(code: str, row: int | None) -> str:
    return f"<code>{escape(code)}</code>" + (f" ({row})" if row is not None else "")
