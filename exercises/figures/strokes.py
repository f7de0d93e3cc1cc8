"""Lines in space that pass behind, through or in front of bodies."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from exercises.figures.bodies import Body
from exercises.figures.camera import Array, Camera

STEP = 1.5
"""Distance on paper between the points at which a line is looked at."""


def in_front(start: Array, end: Array, bodies: Sequence[Body], camera: Camera) -> list[tuple[Array, Array]]:
    """The stretches of a line that lie before a body and are hidden by none, as pairs of points on paper.

    A figure is drawn in three passes: lines, bodies, and these stretches once more on top.
    """
    a, b = camera.project(start), camera.project(end)
    count = max(2, int(np.linalg.norm(b - a) / STEP) + 1)
    ratio = np.linspace(0.0, 1.0, count)[:, None]
    points = start + ratio * (end - start)
    depth = camera.depth(points)
    rays = points - depth[:, None] * camera.eye
    fronts = [body.front(rays, camera.eye) for body in bodies]
    if not fronts:
        return []
    nearest = np.max(fronts, axis=0)
    slack = 1e-9 * max(1.0, float(np.abs(depth).max()))
    shown = np.isfinite(nearest) & (depth > nearest + slack)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], shown, [False]]).astype(int)))
    return [
        (camera.project(points[first]), camera.project(points[last - 1]))
        for first, last in zip(edges[::2], edges[1::2], strict=True)
        if last - first > 1
    ]
