"""Where labels and dimension lines stand: a map of what is taken, and the cheapest place on it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from math import ceil
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from kinematics.se3 import Floats

CELL = 2.5  # Side of a cell of the map, in units of paper.

OUTSIDE = 1000.0  # What it costs to leave the map.

UNMOVED = np.zeros((1, 2))
Choice = TypeVar("Choice")
Cells = NDArray[np.intp]


class PaperMap:
    """How much would be covered at each cell of the paper.

    Cells are flat indices, row by row from the top. Two more follow those of the map: `nowhere`, which costs
    nothing and pads lists of cells to one length, and the one that stands for everything outside.

    Attributes:
        left, top: corner of the map on paper.
        rows, columns: size of the map in cells.
        taken: (rows, columns) weight of what stands in each cell.
        nowhere: index of the cell that is none.
    """

    def __init__(self, left: float, top: float, width: float, height: float) -> None:
        self.left, self.top = left, top
        self.rows, self.columns = int(height / CELL) + 1, int(width / CELL) + 1
        self.nowhere = self.rows * self.columns
        self._flat = np.zeros(self.nowhere + 2)
        self._flat[-1] = OUTSIDE
        self.taken: Floats = self._flat[: self.nowhere].reshape(self.rows, self.columns)

    def cells(self, points: Floats) -> Cells:
        """Return (…, n) cells under runs of (…, n, 2) points.

        A cell that follows itself in a run is returned once.
        """
        columns = np.floor((points[..., 0] - self.left) / CELL)
        rows = np.floor((points[..., 1] - self.top) / CELL)
        on = (columns >= 0) & (columns < self.columns) & (rows >= 0) & (rows < self.rows)
        flat = np.where(on, rows * self.columns + columns, self.nowhere + 1).astype(np.intp)
        again = flat[..., 1:] == flat[..., :-1]
        flat[..., 1:][again] = self.nowhere
        return flat

    def along(self, points: Floats, shifts: Floats = UNMOVED) -> Cells:
        """Return (s, k) cells under a polyline of (n, 2) points, moved by each of (s, 2) shifts."""
        steps = points[1:] - points[:-1]
        counts = np.maximum(2, np.hypot(steps[:, 0], steps[:, 1]) / CELL + 1).astype(np.intp)
        pieces = [
            start + RATIOS[: count + 1, None] * (step * (1 / count))
            for start, step, count in zip(points[:-1], steps, counts.tolist(), strict=True)
        ]
        return self.cells(np.concatenate(pieces) + shifts[:, None])

    def inside(self, hull: Floats) -> Cells:
        """Return cells inside the convex hull of points."""
        corners = convex_hull(hull)
        low, high = hull.min(axis=0), hull.max(axis=0)
        xs, ys = np.arange(low[0], high[0] + CELL, CELL), np.arange(low[1], high[1] + CELL, CELL)
        edges = np.roll(corners, -1, axis=0) - corners
        across = edges[:, 0, None] * (ys - corners[:, 1, None])
        along = edges[:, 1, None] * (xs - corners[:, 0, None])
        row, column = np.nonzero((across[:, :, None] - along[:, None, :] >= -1e-9).all(axis=0))
        return self.cells(np.stack([xs[column], ys[row]], axis=-1))

    def window(self, length: float) -> int:
        """Return how many cells in a row, or in a column, a stretch covers wherever it begins."""
        return ceil(length / CELL) + 1

    def firsts(self, centres: Floats, width: float, height: float) -> tuple[Cells, Cells]:
        """Return first rows and first columns of the windows under rectangles about (…, 2) points."""
        rows = np.floor((centres[..., 1] - (self.top + height / 2)) / CELL)
        columns = np.floor((centres[..., 0] - (self.left + width / 2)) / CELL)
        return rows.astype(np.intp), columns.astype(np.intp)

    def view(self, row: int, column: int, height: int, width: int) -> Floats:
        """Return what is on the map of a window of cells."""
        return self.taken[max(row, 0) : max(row + height, 0), max(column, 0) : max(column + width, 0)]

    def window_cost(self, row: int, column: int, height: int, width: int) -> float:
        """Return the weight of what a window would cover; leaving the map costs much."""
        view = self.view(row, column, height, width)
        weight = float(_total(view, None))
        return weight if view.size == height * width else weight + OUTSIDE

    def mark_square(self, centre: Floats, side: float, weight: float) -> None:
        """Add what stands in the cells of a square about a point."""
        row, column = self.firsts(centre, side, side)
        view = self.view(int(row), int(column), self.window(side), self.window(side))
        view += weight

    def cost(self, cells: Cells) -> Floats:
        """Return (…) weight of what each run of (…, n) cells would cover."""
        return np.asarray(_total(self._flat[cells], -1))

    def mark(self, cells: Cells, weight: float) -> None:
        """Add what stands in cells, once in each (a negative weight takes it away)."""
        self._flat[cells] += weight
        self._flat[self.nowhere :] = (0.0, OUTSIDE)


_total = np.add.reduce
RATIOS = np.arange(4096.0)  # Multiples of a step: more than a line of the longest paper has.


@dataclass(frozen=True, kw_only=True, slots=True)
class Places(Generic[Choice]):
    """The ways to draw one thing, and the places that its name may take in each.

    Attributes:
        lines: (n, k) cells under its lines, for each of n ways.
        faint: (n, j) cells under its faint lines, which may cross other things.
        penalties: (n, m) what each way with each of m places of the name costs by itself.
        rows, columns: (n, m) the window's first cells at each place of the name.
        window: rows and columns of cells that the name covers.
        choose: what is drawn, by the way and the name's place.
    """

    lines: Cells | None = None
    faint: Cells | None = None
    penalties: Floats
    rows: Cells
    columns: Cells
    window: tuple[int, int]
    choose: Callable[[int, int], Choice]


def places(
    paper: PaperMap,
    centres: Floats,
    size: tuple[float, float],
    penalties: Floats,
    choose: Callable[[int, int], Choice],
    *,
    lines: Cells | None = None,
    faint: Cells | None = None,
) -> Places[Choice]:
    """Return the ways to draw a thing whose name, of a size, is centred on one of (n, m, 2) points."""
    width, height = size
    rows, columns = paper.firsts(centres, width, height)
    return Places(
        lines=lines,
        faint=faint,
        penalties=penalties,
        rows=rows,
        columns=columns,
        window=(paper.window(height), paper.window(width)),
        choose=choose,
    )


@dataclass(slots=True)
class Placer(Generic[Choice]):
    """Places things one after the other, then each once more among all the others, until none moves."""

    paper: PaperMap
    line_weight: float = 1.0
    faint_weight: float = 0.35
    label_weight: float = 9.0
    label_cost: float = 3.0
    _placed: dict[int, tuple[int, int]] = field(default_factory=dict)

    def place(self, things: Sequence[Places[Choice]], sweeps: int = 3) -> list[Choice]:
        """Return the cheapest place for each thing, in the order of the things."""
        for _ in range(sweeps):
            before = dict(self._placed)
            for i, thing in enumerate(things):
                if i in self._placed:
                    self._mark(thing, self._placed[i], -1.0)
                self._placed[i] = self._best(thing)
                self._mark(thing, self._placed[i], 1.0)
            if self._placed == before:
                break
        return [thing.choose(*self._placed[i]) for i, thing in enumerate(things)]

    def _best(self, thing: Places[Choice]) -> tuple[int, int]:
        """Way and place of least cost: in ascending order of what is known before a window is looked at."""
        bounds = thing.penalties
        if thing.lines is not None and thing.faint is not None:
            own = self.paper.cost(thing.lines) + self.faint_weight * self.paper.cost(thing.faint)
            bounds = bounds + own[:, None]
        flat = bounds.ravel()
        best, least = 0, float("inf")
        for i in flat.argsort(kind="stable").tolist():
            bound = float(flat[i])
            if bound >= least:
                break
            row, column = thing.rows.item(i), thing.columns.item(i)
            total = bound + self.label_cost * self.paper.window_cost(row, column, *thing.window)
            if total < least:
                best, least = i, total
        way, place = divmod(best, len(bounds[0]))
        return way, place

    def _mark(self, thing: Places[Choice], chosen: tuple[int, int], sign: float) -> None:
        way = chosen[0]
        if thing.lines is not None and thing.faint is not None:
            self.paper.mark(thing.lines[way], sign * self.line_weight)
            self.paper.mark(thing.faint[way], sign * self.faint_weight)
        row, column = int(thing.rows[chosen]), int(thing.columns[chosen])
        view = self.paper.view(row, column, *thing.window)
        view += sign * self.label_weight


def convex_hull(points: Floats) -> Floats:
    """Return corners of the convex hull, in the order in which edge × (point − corner) ≥ 0 inside."""
    ordered = sorted({(x, y) for x, y in points.tolist()})

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
