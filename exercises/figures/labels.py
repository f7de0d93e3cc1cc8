"""Where joints' numbers and points' names may stand."""

from dataclasses import dataclass

import numpy as np

from exercises.figures.bodies import Body
from exercises.figures.camera import Camera
from exercises.figures.geometry import FigureJointAxis
from exercises.figures.placement import PaperMap, Places, places
from exercises.figures.svg import text_width
from kinematics.se3 import Floats
from kinematics.table import JointType

DISC = 10.5
NAME_SIZE = 18.0
"""Radius of the disc around a number and size of a name, in the drawing's units: they fit the sizes in
`drawing`."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Written:
    """A joint's number at the end of its axis, or the name of a point beside it."""

    text: str
    at: Floats


def number_places(
    axis: FigureJointAxis, body: Body, ends: Floats, camera: Camera, paper: PaperMap
) -> Places[Written]:
    """Return a joint's number beyond either of the (2, 2) ends of its axis, or beside its body."""
    start, end = ends
    centre = camera.project(body.centre)
    length = float(np.linalg.norm(end - start))
    along = (end - start) / length if length > 1 else np.array([0.0, -1.0])
    across = np.array([-along[1], along[0]])
    radius = body.radius * camera.scale * (1.3 if axis.type is JointType.PRISMATIC else 1.0)
    half = body.half * camera.scale
    beyond = [
        point + side * _BEYOND[:, :1] * along + _BEYOND[:, 1:2] * across
        for side, point in ((1, end), (-1, start))
    ]
    beside = centre + _BESIDE[:, :1] * (radius + DISC + 3.5) * across + _BESIDE[:, 1:2] * half * along
    costs = np.concatenate(
        [
            _BEYOND[:, 2] + (0.0 if axis.label_end in (0, 1) else 40.0),
            _BEYOND[:, 2] + (0.0 if axis.label_end in (0, -1) else 40.0),
            2.0 * np.abs(_BESIDE[:, 1]) + (12.0 if axis.label_end == 0 else 50.0),
        ]
    )
    return _written(str(axis.joint), np.concatenate([*beyond, beside]), (2 * DISC, 2 * DISC), costs, paper)


def name_places(name: str, centre: Floats, paper: PaperMap) -> Places[Written]:
    """Return a name around a point."""
    width = text_width(name, NAME_SIZE)
    turned = np.abs(_TURNS) @ np.array([width / 2, NAME_SIZE / 2])
    centres = centre + _TURNS * (turned + _AWAY)[:, None]
    return _written(name, centres, (width + 3, NAME_SIZE), _AWAY + _ODD, paper)


_BEYOND = np.array([(11.0, 0.0, 0.0), (0.0, 13.0, 6.0), (0.0, -13.0, 6.0), (20.0, 0.0, 9.0)])
"""Places at an end of an axis: along it, across it, and what they cost."""
_BESIDE = np.array([(aside, slide) for aside in (1.0, -1.0) for slide in (0.0, 0.5, -0.5, 1.0, -1.0)])
"""Places at a body: the side, and how far along the axis, in half lengths."""
_AROUND = np.array([(np.pi * (k / 8 - 0.25), k % 2, more) for k in range(16) for more in (7.0, 13.0, 20.0)])
_TURNS = np.stack([np.cos(_AROUND[:, 0]), np.sin(_AROUND[:, 0])], axis=-1)
_ODD, _AWAY = _AROUND[:, 1], _AROUND[:, 2]
"""Places around a point: directions, whether they are oblique ones, and distances."""


def _written(
    text: str, centres: Floats, size: tuple[float, float], costs: Floats, paper: PaperMap
) -> Places[Written]:
    def choose(_: int, place: int) -> Written:
        return Written(text=text, at=centres[place])

    return places(paper, centres[None], size, costs[None], choose)
