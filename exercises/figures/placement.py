"""Where labels and dimension lines stand: a map of what is taken, and the cheapest place on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import ceil, floor
from typing import Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from exercises.figures.camera import Array

CELL = 2.5
"""Side of a cell of the map, in units of paper."""

OUTSIDE = 1000.0
"""What it costs to leave the map."""

Choice = TypeVar("Choice")
NO_CELLS: NDArray[np.intp] = np.empty(0, dtype=np.intp)


class Rectangle(NamedTuple):
    """A rectangle on paper, by its centre."""

    x: float
    y: float
    width: float
    height: float

    @staticmethod
    def around(centre: Array, width: float, height: float) -> Rectangle:
        """The rectangle of this size about a point."""
        x, y = centre.tolist()
        return Rectangle(x, y, width, height)


@dataclass(slots=True)
class PaperMap:
    """How much would be covered at each cell of the paper.

    Attributes:
        left, top: corner of the map on paper.
        taken: weight of what stands in each cell, row by row from the top.
    """

    left: float
    top: float
    taken: NDArray[np.float64]

    @staticmethod
    def empty(left: float, top: float, width: float, height: float) -> PaperMap:
        """A map on which nothing stands yet."""
        return PaperMap(left, top, np.zeros((int(height / CELL) + 1, int(width / CELL) + 1)))

    def along(self, points: Sequence[Array], step: float = CELL) -> NDArray[np.intp]:
        """Cells under a polyline, as flat indices."""
        pieces = []
        for a, b in pairwise(points):
            count = max(2, int(np.hypot(*(b - a)) / step) + 1)
            pieces.append(a + np.linspace(0, 1, count)[:, None] * (b - a))
        return self._cells(np.concatenate(pieces)) if pieces else np.empty(0, dtype=np.intp)

    def under(self, area: Rectangle) -> NDArray[np.intp]:
        """Cells under a rectangle, as flat indices."""
        columns = _cells_from(area.x - area.width / 2 - self.left, area.width)
        rows = _cells_from(area.y - area.height / 2 - self.top, area.height)
        return self._on_map(columns, rows[:, None]).reshape(-1)

    def inside(self, hull: Array) -> NDArray[np.intp]:
        """Cells inside the convex hull of points."""
        corners = convex_hull(hull)
        low, high = hull.min(axis=0), hull.max(axis=0)
        xs, ys = np.arange(low[0], high[0] + CELL, CELL), np.arange(low[1], high[1] + CELL, CELL)
        grid = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2)
        keep = np.ones(len(grid), dtype=bool)
        for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            edge = b - a
            keep &= edge[0] * (grid[:, 1] - a[1]) - edge[1] * (grid[:, 0] - a[0]) >= -1e-9
        return self._cells(grid[keep])

    def mark(self, cells: NDArray[np.intp], weight: float) -> None:
        """Add what stands in cells (a negative weight takes it away)."""
        flat = self.taken.reshape(-1)
        flat[cells[cells >= 0]] += weight

    def cost(self, cells: NDArray[np.intp]) -> float:
        """Weight of what the cells would cover; leaving the map costs much."""
        on = cells[cells >= 0]
        weight = float(self.taken.reshape(-1)[on].sum()) if len(on) else 0.0
        return weight if len(on) == len(cells) else weight + OUTSIDE

    def _cells(self, points: Array) -> NDArray[np.intp]:
        columns = np.floor((points[:, 0] - self.left) / CELL).astype(np.intp)
        rows = np.floor((points[:, 1] - self.top) / CELL).astype(np.intp)
        return np.unique(self._on_map(columns, rows))

    def _on_map(self, columns: NDArray[np.intp], rows: NDArray[np.intp]) -> NDArray[np.intp]:
        """Flat indices of cells; -1 of those that are not on the map."""
        height, width = self.taken.shape
        on = (columns >= 0) & (columns < width) & (rows >= 0) & (rows < height)
        return np.where(on, rows * width + columns, -1)


def _cells_from(start: float, length: float) -> NDArray[np.intp]:
    """Cells of one row, or column, under a stretch of it."""
    first = floor(start / CELL)
    return np.arange(first, first + ceil(length / CELL) + 1)


@dataclass(frozen=True, kw_only=True, slots=True)
class Label(Generic[Choice]):
    """A place for a name.

    Attributes:
        choice: what is drawn then.
        area: what the name covers.
        penalty: what the place costs by itself.
    """

    choice: Choice
    area: Rectangle
    penalty: float


@dataclass(frozen=True, kw_only=True, slots=True)
class LabelCandidate(Generic[Choice]):
    """A way to draw something, and the places that its name may take then.

    Attributes:
        lines: cells under its lines.
        faint: cells under its faint lines, which may cross other things.
        labels: the places for its name.
        penalty: what it costs by itself.
    """

    lines: NDArray[np.intp] = field(default_factory=lambda: NO_CELLS)
    faint: NDArray[np.intp] = field(default_factory=lambda: NO_CELLS)
    labels: Sequence[Label[Choice]]
    penalty: float = 0.0


@dataclass(frozen=True, slots=True)
class _Placed(Generic[Choice]):
    candidate: LabelCandidate[Choice]
    label: Label[Choice]


@dataclass(slots=True)
class Placer(Generic[Choice]):
    """Places things one after the other, then each once more among all the others."""

    paper: PaperMap
    line_weight: float = 1.0
    faint_weight: float = 0.35
    label_weight: float = 9.0
    _known: dict[Rectangle, NDArray[np.intp]] = field(default_factory=dict)

    def place(self, things: Sequence[Sequence[LabelCandidate[Choice]]], sweeps: int = 3) -> list[Choice]:
        """The cheapest place for each thing, in the order of the things."""
        placed: list[_Placed[Choice] | None] = [None] * len(things)
        for _ in range(sweeps):
            for i, candidates in enumerate(things):
                before = placed[i]
                if before is not None:
                    self._mark(before, -1.0)
                best = self._best(candidates)
                self._mark(best, 1.0)
                placed[i] = best
        return [found.label.choice for found in placed if found is not None]

    def _best(self, candidates: Sequence[LabelCandidate[Choice]]) -> _Placed[Choice]:
        best: _Placed[Choice] | None = None
        least = float("inf")
        for candidate in candidates:
            cost = candidate.penalty + self.paper.cost(candidate.lines)
            cost += self.faint_weight * self.paper.cost(candidate.faint)
            if cost >= least:
                continue
            for label in candidate.labels:
                total = cost + label.penalty
                if total < least:
                    total += 3.0 * self.paper.cost(self._under(label.area))
                if total < least:
                    best, least = _Placed(candidate, label), total
        assert best is not None
        return best

    def _under(self, area: Rectangle) -> NDArray[np.intp]:
        """The cells of an area; most places are dear by themselves, and are never asked for theirs."""
        known = self._known.get(area)
        if known is None:
            known = self._known[area] = self.paper.under(area)
        return known

    def _mark(self, placed: _Placed[Choice], sign: float) -> None:
        self.paper.mark(placed.candidate.lines, sign * self.line_weight)
        self.paper.mark(placed.candidate.faint, sign * self.faint_weight)
        self.paper.mark(self._under(placed.label.area), sign * self.label_weight)


def convex_hull(points: Array) -> Array:
    """Corners of the convex hull, in the order in which edge × (point − corner) ≥ 0 inside."""
    ordered = sorted({(float(x), float(y)) for x, y in points})

    def half(run: list[tuple[float, float]]) -> list[tuple[float, float]]:
        kept: list[tuple[float, float]] = []
        for p in run:
            while len(kept) > 1 and _turn(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return np.array(half(ordered) + half(ordered[::-1]))


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
