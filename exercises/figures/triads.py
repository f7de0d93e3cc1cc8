"""Frames on paper: three arrows each, with their names."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from exercises.figures.camera import Array, Camera
from exercises.figures.svg import Canvas, line
from kinematics.frames.wrong_frames import DrawnFrame

COLOURS = {"x": "#d1495b", "y": "#2e8b57", "z": "#3d7edb"}
"""Seen on white and on black; the names tell the same."""
LENGTH = 0.15
"""Of an arrow, as a part of the robot's size."""
SHORTER = 0.12
"""By which part the arrows of the next frame are shorter, so that frames in one place are told apart."""
HEAD, WING = 8.0, 3.4
"""Length and half width of an arrow's head [unit of the paper]."""
WIDTH = 2.2
"""Width of an arrow's line [unit of the paper]: thinner than links, thicker than dimension lines."""


class Arrow(NamedTuple):
    """An axis of a frame on paper."""

    name: str
    axis: str
    ends: Array


def arrows(frames: Sequence[DrawnFrame], size: float, camera: Camera) -> list[Arrow]:
    """Return the arrows of frame 0 … N."""
    found = []
    for index, frame in enumerate(frames):
        origin = np.array(frame.origin)
        length = LENGTH * size * (1.0 - SHORTER * (index % 3))
        for axis in COLOURS:
            tip = origin + length * np.array(getattr(frame, axis))
            found.append(Arrow(f"{axis}{index}", axis, camera.project(np.array([origin, tip]))))
    return found


def draw_arrow(canvas: Canvas, arrow: Arrow) -> None:
    """Draw an arrow; one that points at the eye is a dot."""
    start, tip = arrow.ends
    colour = COLOURS[arrow.axis]
    length = float(np.linalg.norm(tip - start))
    if length < HEAD:
        canvas.circle(tip, WING, f"frame-{arrow.axis}", fill=colour)
        return
    along = (tip - start) / length
    across = np.array([-along[1], along[0]])
    neck = tip - HEAD * along
    canvas.path(line([start, neck]), f"frame-{arrow.axis}", stroke=colour, stroke_width=WIDTH)
    head = [tip, neck + WING * across, neck - WING * across, tip]
    canvas.path(line(head), f"frame-{arrow.axis}", fill=colour)
