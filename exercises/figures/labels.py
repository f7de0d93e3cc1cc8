"""Where joints' numbers and points' names may stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from exercises.figures.bodies import Body
from exercises.figures.camera import Array, Camera
from exercises.figures.geometry import FigureJointAxis
from exercises.figures.placement import Label, LabelCandidate, Rectangle
from exercises.figures.svg import text_width
from kinematics.table import JointType

DISC = 10.5
NAME_SIZE = 18.0
"""Radius of the disc around a number and size of a name, in the drawing's units: they fit the sizes in
`drawing`."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Written:
    """A joint's number at the end of its axis, or the name of a point beside it."""

    text: str
    at: Array


def number_places(
    axis: FigureJointAxis, body: Body, ends: tuple[Array, Array], camera: Camera
) -> list[LabelCandidate[Written]]:
    """A joint's number beyond either end of its axis, or beside its body."""
    start, end = camera.project(np.array(ends))
    centre = camera.project(body.centre)
    length = float(np.linalg.norm(end - start))
    along = (end - start) / length if length > 1 else np.array([0.0, -1.0])
    across = np.array([-along[1], along[0]])
    found: list[tuple[Array, float]] = []
    for side, tip in ((1, end), (-1, start)):
        wished = 0.0 if axis.label_end in (0, side) else 40.0
        for out, aside, cost in ((11.0, 0.0, 0.0), (0.0, 13.0, 6.0), (0.0, -13.0, 6.0), (20.0, 0.0, 9.0)):
            found.append((tip + side * along * out + across * aside, wished + cost))
    radius = body.radius * camera.scale * (1.3 if axis.type is JointType.PRISMATIC else 1.0)
    half = body.half * camera.scale
    wished = 12.0 if axis.label_end == 0 else 50.0
    for aside in (1.0, -1.0):
        for slide in (0.0, 0.5, -0.5, 1.0, -1.0):
            at = centre + across * aside * (radius + DISC + 3.5) + along * slide * half
            found.append((at, wished + 2.0 * abs(slide)))
    return [_at(str(axis.joint), at, 2 * DISC, 2 * DISC, cost) for at, cost in found]


def name_places(name: str, centre: Array) -> list[LabelCandidate[Written]]:
    """A name around a point."""
    width = text_width(name, NAME_SIZE)
    found = []
    for k in range(16):
        turn = np.pi * (k / 8 - 0.25)
        unit = np.array([np.cos(turn), np.sin(turn)])
        for more in (7.0, 13.0, 20.0):
            out = abs(unit[0]) * width / 2 + abs(unit[1]) * NAME_SIZE / 2 + more
            found.append(_at(name, centre + unit * out, width + 3, NAME_SIZE, more + k % 2))
    return found


def _at(text: str, at: Array, width: float, height: float, penalty: float) -> LabelCandidate[Written]:
    area = Rectangle.around(at, width, height)
    return LabelCandidate(labels=(Label(choice=Written(text=text, at=at), area=area, penalty=penalty),))
