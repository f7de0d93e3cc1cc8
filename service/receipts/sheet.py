"""A receipt as a page to print: points, robot, table, QR code (PDF, by Typst)."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cache
from importlib.resources import files

import typst

_STYLE = re.compile(r"<style>.*?</style>", re.DOTALL)
"""The figure's colours for screens, light and dark; what its marks have without them is for paper."""
_SHEET = files("service.receipts") / "sheet.typ"


@dataclass(frozen=True, kw_only=True, slots=True)
class Sheet:
    """What stands on the page, in the reader's language.

    Attributes:
        title: of the exercise.
        language: of everything on the page.
        facts: name and value, line by line.
        answer: heading of the table.
        columns: headings of the table's columns.
        rows: the table as it was typed; none where no table was handed in.
        signature: who signed.
        receipt: the compact JWS.
    """

    title: str
    language: str
    facts: Sequence[tuple[str, str]]
    answer: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    signature: str
    receipt: str


def pdf_of(sheet: Sheet, *, figure: str, code: str) -> bytes:
    """Return the page as PDF.

    What people typed goes to Typst as data (`sys.inputs`), never as part of the document's source.

    Args:
        sheet: what is written.
        figure: the robot, SVG.
        code: the QR code, SVG.
    """
    on_paper = _STYLE.sub("", figure)
    told = {"told": json.dumps(asdict(sheet)), "figure": on_paper, "code": code}
    return bytes(typst.compile(_source(), format="pdf", sys_inputs=told, ignore_system_fonts=True))


@cache
def _source() -> bytes:
    return _SHEET.read_bytes()
