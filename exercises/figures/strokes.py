"""Lines in space that pass behind, through or in front of bodies."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from exercises.figures.bodies import Body
from exercises.figures.camera import Camera
from kinematics.se3 import Floats

STEP = 1.5  # Distance on paper between the points at which a line is looked at.


def in_front(
    lines: Sequence[tuple[Floats, Floats]], bodies: Sequence[Body], camera: Camera
) -> list[list[tuple[Floats, Floats]]]:
    """Return the stretches of each line before a body that none hides, as pairs of points on paper.

    A figure is drawn in three passes: lines, bodies, and these stretches once more on top.
    """
    if not bodies or not lines:
        return [[] for _ in lines]
    ends = np.array(lines)
    flat = camera.project(ends)
    lengths = np.hypot(*(flat[:, 1] - flat[:, 0]).T)
    counts = np.maximum(2, lengths / STEP + 1).astype(int)
    owner = np.repeat(np.arange(len(counts)), counts)
    firsts = np.cumsum(counts) - counts
    ratio = (np.arange(len(owner)) - firsts[owner]) / (counts - 1)[owner]
    points = ends[owner, 0] + ratio[:, None] * (ends[:, 1] - ends[:, 0])[owner]
    depth = camera.depth(points)
    rays = points - depth[:, None] * camera.eye
    nearest = np.max([body.front(rays, camera.eye) for body in bodies], axis=0)
    slack = 1e-9 * max(1.0, float(np.abs(depth).max()))
    shown = np.isfinite(nearest) & (depth > nearest + slack)
    on_paper = camera.project(points)
    found: list[list[tuple[Floats, Floats]]] = [[] for _ in lines]
    for start, stop in _runs(shown, firsts):
        if stop - start > 1:
            found[owner[start]].append((on_paper[start], on_paper[stop - 1]))
    return found


def _runs(shown: NDArray[np.bool_], firsts: NDArray[np.intp]) -> list[tuple[int, int]]:
    """Where runs of samples that are shown start and stop; none goes on from one line to the next."""
    before = np.concatenate([[False], shown[:-1]])
    before[firsts] = False
    after = np.concatenate([shown[1:], [False]])
    after[firsts[1:] - 1] = False
    starts, stops = np.flatnonzero(shown & ~before), np.flatnonzero(shown & ~after) + 1
    return list(zip(starts.tolist(), stops.tolist(), strict=True))
