"""The SVG file: elements, escaping, the style sheet.

The file holds no script and refers to nothing outside. Lines and letters have the surrounding text's colour
(`currentColor`), bodies are filled with `--figure-paper`, names of joints have `--figure-accent`; a page
may set both. As a file of its own (`<img>`) it follows the reader's light or dark scheme itself. The
attributes alone give a readable black and white figure where style sheets are not allowed.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from kinematics.se3 import Floats

STYLE = (
    ".framewise-figure{--ink:currentColor;--paper:var(--figure-paper,#fff);--accent:var(--figure-accent,#0b5cad)}"
    ":root.framewise-figure{color:#1b1b1f}"
    ".framewise-figure .body,.framewise-figure .disc{fill:var(--paper)}"
    ".framewise-figure .halo,.framewise-figure .core{stroke:var(--paper)}"
    ".framewise-figure .axis,.framewise-figure .disc,.framewise-figure .sense{stroke:var(--accent)}"
    ".framewise-figure .number,.framewise-figure .tip{fill:var(--accent)}"
    "@media (prefers-color-scheme:dark){"
    ":root.framewise-figure{color:#e9e9ee;--figure-paper:#17181c;--figure-accent:#84bdf7}}"
)

FONT = "'Liberation Sans','DejaVu Sans',Helvetica,Arial,sans-serif"


@dataclass(slots=True)
class Canvas:
    """Collects elements in the order of drawing."""

    parts: list[str] = field(default_factory=list)

    def path(self, data: str, role: str, **attributes: str | float) -> None:
        """Add a path of a role (a class of the style sheet)."""
        self.parts.append(f'<path class="{role}" d="{data}"{_attributes(attributes)}/>')

    def circle(self, centre: Floats, radius: float, role: str, **attributes: str | float) -> None:
        """Add a circle."""
        self.parts.append(
            f'<circle class="{role}" cx="{centre[0]:.1f}" cy="{centre[1]:.1f}" r="{radius:g}"'
            f"{_attributes(attributes)}/>"
        )

    def text(self, centre: Floats, name: str, role: str, size: float, **attributes: str | float) -> None:
        """Add a name, centred; digits after letters become a subscript."""
        stem, index = split_name(name)
        body = escape(stem)
        if index:
            body += (
                f'<tspan dy="{size * 0.24:.1f}" font-size="{size * SUBSCRIPT:.1f}">{escape(index)}</tspan>'
            )
        self.parts.append(
            f'<text class="{role}" x="{centre[0]:.1f}" y="{centre[1] + size * 0.34:.1f}" font-size="{size:g}"'
            f' text-anchor="middle"{_attributes(attributes)}>{body}</text>'
        )


SUBSCRIPT = 0.7  # Size of a subscript beside its letter, about that of TeX.


_INDEXED = re.compile(r"([^ ]*(?:[^\W\d_]|\w(?=_)))_*([0-9]+)")


def split_name(name: str) -> tuple[str, str]:
    """Return the letters of a name and the index behind them: ("L", "1") of L1; 0.5 and 3L/4 have none."""
    indexed = _INDEXED.fullmatch(name)
    return (indexed[1], indexed[2]) if indexed else (name, "")


def text_width(name: str, size: float) -> float:
    """Return the estimated width of a name on paper."""
    stem, index = split_name(name)
    return size * (0.62 * len(stem) + 0.6 * SUBSCRIPT * len(index))


def line(points: Sequence[Floats] | Floats) -> str:
    """Return the path data of a polyline."""
    return "M" + "L".join([f"{x:.1f} {y:.1f}" for x, y in np.asarray(points).tolist()])


@dataclass(frozen=True, kw_only=True, slots=True)
class SvgDrawing:
    """What is drawn, without a word that tells of it.

    Its box is left, top, width and height of the paper.
    """

    box: tuple[float, float, float, float]
    elements: str


def document(drawing: SvgDrawing, *, title: str, description: str, language: str) -> str:
    """Return the file."""
    return opening(drawing.box, title=title, description=description, language=language) + rest(drawing)


def opening(box: tuple[float, float, float, float], *, title: str, description: str, language: str) -> str:
    """Return how `document` begins: all words that tell of the figure, and nothing that is drawn."""
    left, top, width, height = box
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="framewise-figure" role="img"'
        f" lang={quoteattr(language)}"
        f' aria-labelledby="figure-title figure-description"'
        f' viewBox="{left:.0f} {top:.0f} {width:.0f} {height:.0f}" width="{width:.0f}" height="{height:.0f}"'
        f' fill="none" stroke-linecap="round" stroke-linejoin="round" font-family="{FONT}">'
        f'<title id="figure-title">{escape(title)}</title>'
        f'<desc id="figure-description">{escape(description)}</desc>'
    )


def rest(drawing: SvgDrawing) -> str:
    """Return what follows in `document` after the opening."""
    return f"<style>{STYLE}</style>{drawing.elements}</svg>"


def _attributes(attributes: dict[str, str | float]) -> str:
    return "".join(_attribute(key, value) for key, value in attributes.items())


@lru_cache(maxsize=256)
def _attribute(key: str, value: str | float) -> str:
    """An attribute as text; a figure repeats a few dozen."""
    return f" {key.replace('_', '-')}={quoteattr(value if isinstance(value, str) else f'{value:g}')}"
