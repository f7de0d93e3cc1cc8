"""The table of settings in docs/operations.md is that of the code. `python … --update` writes it."""

from __future__ import annotations

import sys

from service.settings import Settings
from tests.architecture.sources import ROOT

PAGE = ROOT / "docs" / "operations.md"
BEGIN = "<!-- settings: written by tests/architecture/test_settings.py --update -->\n"
END = "<!-- end of settings -->"


def table() -> str:
    lines = ["| variable | default | meaning |", "|---|---|---|"]
    for name, field in Settings.model_fields.items():
        default = field.default
        if isinstance(default, tuple):
            default = " ".join(default)
        if isinstance(default, bool):
            default = str(default).lower()
        shown = f"`{default}`" if default not in ("", None) else "none"
        lines.append(f"| `FRAMEWISE_{name.upper()}` | {shown} | {field.description} |")
    return "\n".join(lines) + "\n"


def test_the_page_lists_every_setting() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert text[text.index(BEGIN) + len(BEGIN) : text.index(END)] == table()


def test_every_setting_is_explained() -> None:
    assert all(field.description for field in Settings.model_fields.values())


if __name__ == "__main__" and "--update" in sys.argv:
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(text[: text.index(BEGIN) + len(BEGIN)] + table() + text[text.index(END) :], encoding="utf-8")
