"""Dimension lines: extension lines, arrows, and the places that they may take."""

from dataclasses import dataclass, replace

import numpy as np

from exercises.figures.camera import Camera
from exercises.figures.geometry import Dimension
from exercises.figures.placement import CELL, Cells, PaperMap, Places, places
from exercises.figures.svg import Canvas, line, text_width
from kinematics.se3 import Floats, Vector, cross_arrays, triple

FONT_SIZE = 18.0
OFFSETS = (0.0, 22.0, 36.0, 52.0, 70.0, 92.0)
_TAIL = 20.0
GAP = 4.0
BEYOND = 5.0
HEAD = (8.0, 2.7)
USUAL_OFFSET = 22.0  # Where a dimension of distance 1 prefers to stand.
ALIKE = 0.02  # Ways that differ by less on paper are one.
SHORT = 30.0  # Dimension lines shorter than this on paper have their arrows outside.


@dataclass(frozen=True, kw_only=True, slots=True)
class DimensionLine:
    """A dimension on paper: ends of its line, extension lines, arrows in- or outside, place of the name."""

    name: str
    start: Floats
    end: Floats
    extensions: tuple[tuple[Floats, Floats], ...]
    outside: bool
    label: Floats

    def drawn_line(self) -> tuple[Floats, Floats]:
        """Return the ends of the line that is drawn, with the tails of arrows that stand outside."""
        if not self.outside:
            return self.start, self.end
        along = _unit(self.end - self.start) * _TAIL
        return self.start - along, self.end + along


def dimension_places(dimension: Dimension, camera: Camera, paper: PaperMap) -> Places[DimensionLine]:
    """Return the ways in which a dimension can be drawn.

    Its line moved aside, its name beside or beyond it.
    """
    ends = np.array([dimension.start, dimension.end])
    on_paper = camera.project(ends)
    along = _unit(on_paper[1] - on_paper[0])
    units, costs = _directions(dimension, ends, along, camera)
    ways = np.repeat(units, len(OFFSETS), axis=0)
    distances = np.tile(OFFSETS, len(units))
    offsets = ways * distances[:, None]
    usual = USUAL_OFFSET * dimension.distance
    outside = float(np.linalg.norm(on_paper[1] - on_paper[0])) < SHORT
    size = np.array([text_width(dimension.name, FONT_SIZE), FONT_SIZE])
    normal = np.array([-along[1], along[0]])
    names, name_costs = _label_places(on_paper, along, normal, size / 2, outside)
    # beside a line that was not moved, the name prefers the side on which it would have been moved away
    out = np.where(distances[:, None] > 0, ways, normal)
    opposite = (out @ normal)[:, None] * _sides(len(name_costs)) < 0
    penalties = (np.repeat(costs, len(OFFSETS)) + 0.4 * np.abs(distances - usual))[:, None]
    penalties = penalties + name_costs + 4.0 * opposite
    tails = _TAIL if outside else 0.0
    drawn = on_paper + np.array([-along, along]) * tails

    def choose(way: int, place: int) -> DimensionLine:
        offset, distance = offsets[way], float(distances[way])
        start, end = on_paper + offset
        extensions = (
            tuple((p + ways[way] * GAP, p + offset + ways[way] * BEYOND) for p in on_paper)
            if distance > GAP
            else ()
        )
        return DimensionLine(
            name=dimension.name,
            start=start,
            end=end,
            extensions=extensions,
            outside=outside,
            label=names[place] + offset,
        )

    return places(
        paper,
        names + offsets[:, None],
        (float(size[0]) + 4.0, FONT_SIZE),
        penalties,
        choose,
        lines=_cells_of_lines(drawn, offsets, paper),
        faint=_cells_of_extensions(on_paper, units, paper),
    )


def _cells_of_lines(drawn: Floats, offsets: Floats, paper: PaperMap) -> Cells:
    """(n, k) cells under a line moved by each of (n, 2) offsets."""
    length = float(np.linalg.norm(drawn[1] - drawn[0]))
    count = max(2, int(length / CELL) + 1)
    run = drawn[0] + np.linspace(0.0, 1.0, count)[:, None] * (drawn[1] - drawn[0])
    return paper.cells(offsets[:, None] + run)


def _cells_of_extensions(ends: Floats, units: Floats, paper: PaperMap) -> Cells:
    """(n, k) cells under both extension lines, for each direction and each of the distances."""
    cells = paper.cells(ends[:, None, None, None] + units[:, None, None] * _EXTENSIONS[:, :, None])
    cells[:, :, 0] = paper.nowhere  # a line that was not moved has none
    return np.moveaxis(cells, 0, 2).reshape(len(units) * len(OFFSETS), -1)


@dataclass(frozen=True, kw_only=True, slots=True)
class DimensionWay:
    """A direction in which the line of a dimension may be moved off its points.

    Attributes:
        offset: the direction in the figure's space, as a definition says it.
        shift: the same on paper, a unit vector.
    """

    offset: tuple[float, float, float]
    shift: tuple[float, float]


def dimension_ways(dimension: Dimension, camera: Camera) -> tuple[tuple[Floats, Floats], list[DimensionWay]]:
    """Return the ends of a dimension on paper, and the ways in which its line may be moved: one of a kind."""
    ends = np.array([dimension.start, dimension.end])
    on_paper = camera.project(ends)
    along = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    screen = cross_arrays(along, camera.eye)
    ways: list[DimensionWay] = []
    for offset in (*_AXES, screen, -screen):
        free = replace(dimension, offset=_rounded(offset))
        units, costs = _directions(free, ends, _unit(on_paper[1] - on_paper[0]), camera)
        wished = units[costs < _WISHED]
        if len(wished) and all(np.abs(wished[0] - way.shift).max() > ALIKE for way in ways):
            shift = float(wished[0][0]), float(wished[0][1])
            ways.append(DimensionWay(offset=_rounded(offset), shift=shift))
    return (on_paper[0], on_paper[1]), ways


def _rounded(vector: Floats) -> Vector:
    return triple(round(float(value), 4) + 0.0 for value in vector)


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


def halo(canvas: Canvas, centre: Floats, name: str, size: float, **attributes: str) -> None:
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


def _directions(
    dimension: Dimension, ends: Floats, on_paper: Floats, camera: Camera
) -> tuple[Floats, Floats]:
    """(n, 2) unit vectors on paper in which the dimension line may be moved, with what each costs."""
    along = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    screen = cross_arrays(along, camera.eye)
    wished = np.zeros(3) if dimension.offset is None else np.array(dimension.offset)
    directions = np.array([wished, *_AXES, screen, -screen])
    across = directions - (directions @ along)[:, None] * along
    lengths = np.sqrt((across * across).sum(axis=1))
    shifts = np.stack([across @ camera.right, -(across @ camera.up)], axis=-1) * camera.scale
    seen = np.sqrt((shifts * shifts).sum(axis=1))
    units = shifts / np.maximum(seen, 1e-9)[:, None]
    slants = np.abs(units[:, 0] * on_paper[1] - units[:, 1] * on_paper[0])
    kept = (lengths >= 0.3) & (seen >= 0.25 * camera.scale * lengths) & (slants >= 0.35)
    kept[7:] &= bool(np.linalg.norm(screen) > 1e-6)
    return units[kept], (_DIRECTION_COSTS + 12.0 * (1 - slants))[kept]


_AXES = np.concatenate([[axis, -axis] for axis in np.eye(3)])
_DIRECTION_COSTS = np.array([-60.0, *[0.0] * 6, 15.0, 15.0])
_WISHED = -30.0  # What the direction that was wished for costs, those of the axes, and those along the paper.


def _longest_extension() -> Floats:
    """(distances, samples) how far from the point the samples of an extension line lie."""
    lengths = [distance + BEYOND - GAP for distance in OFFSETS]
    counts = [max(2, int(length / CELL) + 1) for length in lengths]
    rows = [
        GAP + np.minimum(np.arange(max(counts)) / (count - 1), 1.0) * length
        for length, count in zip(lengths, counts, strict=True)
    ]
    return np.array(rows)


_EXTENSIONS = _longest_extension()


def _label_places(
    ends: Floats, along: Floats, normal: Floats, half: Floats, outside: bool
) -> tuple[Floats, Floats]:
    """(m, 2) places for a name beside a line, beyond its ends if the arrows stand outside; their costs."""
    away = float(abs(normal[0]) * half[0] + abs(normal[1]) * half[1]) + 4.0
    beside = ends[0] + _BESIDE[:, :1] * (ends[1] - ends[0]) + _BESIDE[:, 1:2] * normal * away
    if not outside:
        return beside, _BESIDE[:, 2]
    reach = 24.0 + float(abs(along[0]) * half[0] + abs(along[1]) * half[1])
    return np.concatenate([beside, [ends[1] + along * reach, ends[0] - along * reach]]), _BESIDE_AND_BEYOND


_BESIDE = np.array(
    [
        (ratio, side, cost)
        for side in (1.0, -1.0)
        for ratio, cost in ((0.5, 0.0), (0.35, 3.0), (0.65, 3.0), (0.2, 8.0), (0.8, 8.0))
    ]
)
"""Places beside a line: how far along it, on which side, and what they cost."""
_BESIDE_AND_BEYOND = np.array([*_BESIDE[:, 2], 2.0, 2.0])


def _sides(count: int) -> Floats:
    """On which side each of the places stands: 0 beyond the ends."""
    return np.array([*_BESIDE[:, 1], 0.0, 0.0])[:count]


def _head(tip: Floats, direction: Floats) -> str:
    back = tip - direction * HEAD[0]
    side = np.array([-direction[1], direction[0]]) * HEAD[1]
    return line([tip, back + side, back - side]) + "Z"


def _unit(vector: Floats) -> Floats:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 1e-9 else np.array([1.0, 0.0])
