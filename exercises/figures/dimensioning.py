"""Dimension lines: extension lines, arrows, and the places that they may take."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from exercises.figures.camera import Array, Camera
from exercises.figures.geometry import Dimension
from exercises.figures.placement import NO_CELLS, Label, LabelCandidate, PaperMap, Rectangle
from exercises.figures.svg import Canvas, line, text_width
from kinematics.se3 import cross_arrays

FONT_SIZE = 18.0
OFFSETS = (0.0, 22.0, 36.0, 52.0, 70.0, 92.0)
GAP = 4.0
BEYOND = 5.0
HEAD = (8.0, 2.7)
SHORT = 30.0
"""Dimension lines shorter than this on paper have their arrows outside."""


@dataclass(frozen=True, kw_only=True, slots=True)
class DimensionLine:
    """A dimension on paper: ends of its line, extension lines, arrows in- or outside, place of the name."""

    name: str
    start: Array
    end: Array
    extensions: tuple[tuple[Array, Array], ...]
    outside: bool
    label: Array

    def drawn_line(self) -> tuple[Array, Array]:
        """Ends of the line that is drawn, with the tails of arrows that stand outside."""
        if not self.outside:
            return self.start, self.end
        along = _unit(self.end - self.start) * 20.0
        return self.start - along, self.end + along


def candidates(dimension: Dimension, camera: Camera, paper: PaperMap) -> list[LabelCandidate[DimensionLine]]:
    """The ways in which a dimension can be drawn."""
    return [
        _candidate(dimension, offset, penalty, camera, paper)
        for offset, penalty in _offsets(dimension, camera)
    ]


def draw_extensions(canvas: Canvas, dimension: DimensionLine) -> None:
    """Draw the extension lines of a dimension, below the bodies."""
    for a, b in dimension.extensions:
        canvas.path(line([a, b]), "extension", stroke="currentColor", stroke_width=1.0, stroke_opacity=0.55)


def draw(canvas: Canvas, dimension: DimensionLine) -> None:
    """Draw the line of a dimension; its name is drawn by `draw_name`, above everything else."""
    start, end = dimension.drawn_line()
    along = _unit(dimension.end - dimension.start)
    canvas.path(line([start, end]), "dimension", stroke="currentColor", stroke_width=1.0)
    sense = -1.0 if dimension.outside else 1.0
    canvas.path(_head(dimension.start, -along * sense), "arrow", fill="currentColor")
    canvas.path(_head(dimension.end, along * sense), "arrow", fill="currentColor")


def draw_name(canvas: Canvas, dimension: DimensionLine) -> None:
    """Write the name of a dimension."""
    halo(canvas, dimension.label, dimension.name, FONT_SIZE, font_style="italic")


def halo(canvas: Canvas, centre: Array, name: str, size: float, **attributes: str) -> None:
    """Write a name with a rim of the colour of the paper around its letters."""
    canvas.text(
        centre,
        name,
        "halo",
        size,
        fill="currentColor",
        stroke="#fff",
        stroke_width=4,
        paint_order="stroke",
        **attributes,
    )


def _offsets(dimension: Dimension, camera: Camera) -> Iterator[tuple[Array, float]]:
    """Vectors on paper by which the dimension line may be moved, with what each costs."""
    start, end = np.array(dimension.start), np.array(dimension.end)
    along = (end - start) / np.linalg.norm(end - start)
    on_paper = _unit(camera.project(end) - camera.project(start))
    wished = dimension.offset
    directions: list[tuple[Array, float]] = []
    if wished is not None:
        directions.append((np.array(wished), -60.0))
    for axis in np.eye(3):
        directions += [(axis, 0.0), (-axis, 0.0)]
    screen = cross_arrays(along, camera.eye)
    if np.linalg.norm(screen) > 1e-6:
        directions += [(screen, 15.0), (-screen, 15.0)]
    for direction, cost in directions:
        across = direction - along * (direction @ along)
        if np.linalg.norm(across) < 0.3:
            continue
        shift = camera.project(across) - camera.project(np.zeros(3))
        if np.linalg.norm(shift) < 0.25 * camera.scale * np.linalg.norm(across):
            continue
        unit = _unit(shift)
        slant = abs(unit[0] * on_paper[1] - unit[1] * on_paper[0])
        if slant < 0.35:
            continue
        for distance in OFFSETS:
            usual = 22.0 * dimension.distance
            yield unit * distance, cost + 12.0 * (1 - slant) + 0.4 * abs(distance - usual)


def _candidate(
    dimension: Dimension, offset: Array, penalty: float, camera: Camera, paper: PaperMap
) -> LabelCandidate[DimensionLine]:
    """The dimension line at an offset, with its name at each place that it may take."""
    a, b = camera.project(dimension.start), camera.project(dimension.end)
    start, end = a + offset, b + offset
    along = _unit(end - start)
    distance = float(np.linalg.norm(offset))
    out = offset / distance if distance else np.array([-along[1], along[0]])
    extensions = tuple((p + out * GAP, p + offset + out * BEYOND) for p in (a, b)) if distance > GAP else ()
    outside = float(np.linalg.norm(end - start)) < SHORT
    width = text_width(dimension.name, FONT_SIZE)

    def drawn(label: Array) -> DimensionLine:
        return DimensionLine(
            name=dimension.name, start=start, end=end, extensions=extensions, outside=outside, label=label
        )

    labels = [
        Label(choice=drawn(place), area=Rectangle.around(place, width + 4.0, FONT_SIZE), penalty=cost)
        for place, cost in _label_places(start, end, out, np.array([width, FONT_SIZE]) / 2, outside)
    ]
    faint = [paper.along(pair) for pair in extensions]
    return LabelCandidate(
        lines=paper.along(labels[0].choice.drawn_line()),
        faint=np.concatenate(faint) if faint else NO_CELLS,
        labels=labels,
        penalty=penalty,
    )


def _label_places(
    start: Array, end: Array, out: Array, half: Array, outside: bool
) -> Iterator[tuple[Array, float]]:
    """Places for a name beside a dimension line, beyond its ends if the arrows stand outside."""
    along = _unit(end - start)
    normal = np.array([-along[1], along[0]])
    away = float(abs(normal[0]) * half[0] + abs(normal[1]) * half[1]) + 4.0
    for side in (1.0, -1.0):
        preferred = 0.0 if normal @ out * side > 0 else 4.0
        for ratio, cost in ((0.5, 0.0), (0.35, 3.0), (0.65, 3.0), (0.2, 8.0), (0.8, 8.0)):
            yield start + ratio * (end - start) + side * normal * away, preferred + cost
    if outside:
        reach = 24.0 + float(abs(along[0]) * half[0] + abs(along[1]) * half[1])
        yield end + along * reach, 2.0
        yield start - along * reach, 2.0


def _head(tip: Array, direction: Array) -> str:
    back = tip - direction * HEAD[0]
    side = np.array([-direction[1], direction[0]]) * HEAD[1]
    return line([tip, back + side, back - side]) + "Z"


def _unit(vector: Array) -> Array:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 1e-9 else np.array([1.0, 0.0])
