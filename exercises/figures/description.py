"""A scene in words: codes and values, from which any language makes sentences.

It says what the figure shows: where each joint's axis runs and how long the named dimensions are. How the
axes lie to one another is left to the reader, as in the figure.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from typing import TypeAlias

from exercises.figures.geometry import FigureJointAxis, Scene
from exercises.figures.specification import View
from kinematics.frames.wrong_frames import DrawnFrame
from kinematics.se3 import Vector, dot, norm, subtract
from kinematics.table import JointType

Basis: TypeAlias = tuple[Vector, Vector, Vector]
CACHED_PLACES = 1024  # Places and directions in the cache: dimensions begin and end where joints are.


class LineDirection(StrEnum):
    """How a line runs, seen by the reader."""

    VERTICAL = "vertical"
    SIDEWAYS = "sideways"
    DEPTHWAYS = "depthways"
    OBLIQUE = "oblique"


@dataclass(frozen=True, kw_only=True, slots=True)
class Sentence:
    """One sentence: the message `figure-<code>` with its parameters by name."""

    code: str
    params: Mapping[str, str | int]


def describe(scene: Scene, view: View, unit: str, frames: Mapping[int, DrawnFrame]) -> Iterator[Sentence]:
    """Yield the sentences of a scene and of prescribed frames, in the order in which they are read.

    Coordinates are those of the figure, in which frames are asked for and drawn, too.
    """
    basis = _directions(view)
    params: dict[str, str | int] = {"unit": unit, "joints": len(scene.axes)}
    yield Sentence(code="coordinates", params={**params, **coordinates_told(scene, view)})
    for axis in scene.axes:
        yield _joint(axis, basis)
    for dimension in scene.dimensions:
        along = _seen(basis, subtract(dimension.end, dimension.start))
        yield Sentence(
            code="dimension",
            params={
                "name": dimension.name,
                "length": _number(norm(along)),
                "unit": unit,
                "course": _course(along),
                "start": _triple(dimension.start),
                "end": _triple(dimension.end),
            },
        )
    for point in scene.points:
        yield Sentence(code="point", params={"name": point.name, "place": _triple(point.at)})
    for number, frame in frames.items():
        told = {"place": _triple(frame.origin), "x": _triple(frame.x), "z": _triple(frame.z)}
        yield Sentence(code="frame", params={"number": number, **told})


def coordinates_told(scene: Scene, view: View) -> dict[str, str]:
    """Return what `figure-place` says of the figure's coordinates: where X points, and a place that is drawn.

    That place is where the robot is fixed, or the body of joint 1.
    """
    right, away, _ = _directions(view)
    pointing = {(1, 0): "right", (0, 1): "back", (-1, 0): "left", (0, -1): "front"}
    at = scene.ground.at if scene.ground else scene.axes[0].point
    return {
        "x": pointing[round(right[0]), round(away[0])],
        "fixed": "ground" if scene.ground else "joint",
        "at": _triple(at),
    }


def _joint(axis: FigureJointAxis, basis: Basis) -> Sentence:
    direction = _seen(basis, axis.direction)
    turning = "revolute" if axis.type is JointType.REVOLUTE else "prismatic"
    return Sentence(
        code=f"joint-{turning}-signed" if axis.signed else f"joint-{turning}",
        params={
            "joint": axis.joint,
            "course": _course(direction),
            "place": _triple(axis.point),
            "direction": _triple(axis.direction),
        },
    )


def _directions(view: View) -> Basis:
    """Unit vectors to the right, away from the reader and up; the horizontal ones along the x and y axes."""
    quarter = round(view.azimuth / (math.pi / 2))
    cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[quarter % 4]
    return (-sine, cosine, 0.0), (-cosine, -sine, 0.0), (0.0, 0.0, 1.0)


def _seen(basis: Basis, vector: Vector) -> Vector:
    right, away, up = basis
    return dot(right, vector), dot(away, vector), dot(up, vector)


def _course(vector: Vector) -> str:
    length = norm(vector) or 1.0
    for course, component in zip(
        (LineDirection.SIDEWAYS, LineDirection.DEPTHWAYS, LineDirection.VERTICAL), vector, strict=True
    ):
        if abs(component) / length > 1 - 1e-9:
            return course.value
    return LineDirection.OBLIQUE.value


@lru_cache(maxsize=CACHED_PLACES)
def _triple(vector: Vector) -> str:
    return f"({'; '.join(map(_number, vector))})"


def _number(value: float) -> str:
    if not abs(value) > 1e-9:  # most are not: a figure's lines run along its axes
        return "0"
    return f"{float(f'{value:.4g}'):g}"
