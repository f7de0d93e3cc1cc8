"""A figure of an exercise (SVG) on paper: the elements that `exercises.figures.svg` writes, and no others.

The style sheet is for screens and does not count on paper: what the marks have without it is black and white.
"""

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Mapping, Sequence
from math import acos, ceil, copysign, cos, hypot, pi, radians, sin, sqrt, tan

from service.receipts.paper import BLACK, Colour, Face, OutlineStep, Paper

_SPACE = "{http://www.w3.org/2000/svg}"
_WHITE: Colour = (1.0, 1.0, 1.0, 1.0)
_COLOURS = {"currentColor": BLACK, "#fff": _WHITE}
_TOKEN = re.compile(r"[MLAZ]|-?[\d.]+(?:e-?\d+)?")
_NUMBERS = {"M": 2, "L": 2, "A": 7, "Z": 0}


def draw_figure(page: Paper, figure: str, at: tuple[float, float], width: float) -> float:
    """Draw a figure as wide as told, its upper left corner at a point; returns its height.

    Lengths are in points.
    """
    root = ElementTree.fromstring(figure)  # noqa: S314 – our own file
    left, top, wide, high = map(float, root.attrib["viewBox"].split())
    scale = width / wide
    place = _Place(at[0] - scale * left, at[1] - scale * top, scale)
    for element in root:
        told = element.attrib
        match element.tag.removeprefix(_SPACE):
            case "path":
                _draw(page, place, list(outline(told["d"])), told)
            case "circle":
                _draw(page, place, list(_circle(*(float(told[name]) for name in ("cx", "cy", "r")))), told)
            case "text":
                _write(page, place, element)
    return scale * high


def outline(data: str) -> Iterator[OutlineStep]:
    """Yield the path data as steps without arcs.

    Args:
        data: of M, L, A and Z with absolute coordinates (SVG 2, 9.3).
    """
    tokens = _TOKEN.findall(data)
    name, at, i = "M", (0.0, 0.0), 0
    while i < len(tokens):
        if tokens[i] in _NUMBERS:
            name, i = tokens[i], i + 1
        numbers = [float(token) for token in tokens[i : i + _NUMBERS[name]]]
        i += _NUMBERS[name]
        if name == "A":
            yield from _arc(at, numbers)
        else:
            yield name, numbers
        if numbers:
            at = (numbers[-2], numbers[-1])


class _Place:
    """Where points of the figure are on the page."""

    def __init__(self, x: float, y: float, scale: float) -> None:
        self.x, self.y, self.scale = x, y, scale

    def of(self, numbers: Sequence[float]) -> list[float]:
        return [(self.y if i % 2 else self.x) + self.scale * value for i, value in enumerate(numbers)]


def _draw(page: Paper, place: _Place, steps: Sequence[OutlineStep], told: Mapping[str, str]) -> None:
    fill, stroke = _colour(told, "fill"), _colour(told, "stroke")
    width = place.scale * float(told.get("stroke-width", 1))
    page.outline(
        [(name, place.of(numbers)) for name, numbers in steps],
        fill=fill,
        stroke=None if stroke is None else (stroke, width),
        dashes=[place.scale * float(dash) for dash in told.get("stroke-dasharray", "").split()],
    )


def _write(page: Paper, place: _Place, element: ElementTree.Element) -> None:
    """A name with its index, centred."""
    told = element.attrib
    size = place.scale * float(told["font-size"])
    face = Face.ITALIC if "font-style" in told else Face.BOLD if "font-weight" in told else Face.UPRIGHT
    runs = [(element.text or "", size, 0.0)]
    runs += [
        (span.text or "", place.scale * float(span.get("font-size", 0)), float(span.get("dy", 0)))
        for span in element
    ]
    x, y = place.of([float(told["x"]), float(told["y"])])
    x -= sum(page.width(text, face, height) for text, height, _ in runs) / 2
    halo = _colour(told, "stroke")
    around = None if halo is None else (halo, place.scale * float(told.get("stroke-width", 1)))
    for text, height, down in runs:
        y += place.scale * down
        page.text((x, y), text, face, height, _colour(told, "fill") or BLACK, halo=around)
        x += page.width(text, face, height)


def _colour(told: Mapping[str, str], name: str) -> Colour | None:
    said = told.get(name)
    if said is None or said == "none":
        return None
    red, green, blue, _ = _COLOURS[said]
    return red, green, blue, float(told.get(f"{name}-opacity", 1))


def _circle(x: float, y: float, radius: float) -> Iterator[OutlineStep]:
    yield "M", [x + radius, y]
    for end in (x - radius, x + radius):
        begin = 2 * x - end
        yield from _arc((begin, y), [radius, radius, 0, 0, 1, end, y])
    yield "Z", []


def _arc(begin: tuple[float, float], numbers: Sequence[float]) -> Iterator[OutlineStep]:
    """An arc of an ellipse as Bézier curves, each of a quarter or less (SVG 2, B.2.4)."""
    rx, ry, turn, large, sweep, *end = numbers
    if rx == 0 or ry == 0 or tuple(end) == begin:
        yield "L", end
        return
    c, s = cos(radians(turn)), sin(radians(turn))
    dx, dy = (begin[0] - end[0]) / 2, (begin[1] - end[1]) / 2
    u, v = (c * dx + s * dy) / rx, (-s * dx + c * dy) / ry
    reach = hypot(u, v)
    if reach > 1:
        rx, ry, u, v, reach = rx * reach, ry * reach, u / reach, v / reach, 1.0
    away = sqrt(max(0.0, 1 / reach**2 - 1)) * (-1 if large == sweep else 1)
    p, q = away * v, -away * u
    x = (begin[0] + end[0]) / 2 + c * rx * p - s * ry * q
    y = (begin[1] + end[1]) / 2 + s * rx * p + c * ry * q
    first, last = _angle(u - p, v - q), _angle(-u - p, -v - q)
    span = last - first
    if sweep and span < 0:
        span += 2 * pi
    elif not sweep and span > 0:
        span -= 2 * pi
    count = max(1, ceil(abs(span) / (pi / 2) - 1e-9))
    reach = 4 / 3 * tan(span / count / 4)

    def point(a: float, b: float) -> tuple[float, float]:
        return x + c * rx * a - s * ry * b, y + s * rx * a + c * ry * b

    for k in range(count):
        f, t = first + span * k / count, first + span * (k + 1) / count
        near = point(cos(f) - reach * sin(f), sin(f) + reach * cos(f))
        far = point(cos(t) + reach * sin(t), sin(t) - reach * cos(t))
        yield "C", [*near, *far, *point(cos(t), sin(t))]


def _angle(a: float, b: float) -> float:
    return copysign(acos(max(-1.0, min(1.0, a / hypot(a, b)))), b)
