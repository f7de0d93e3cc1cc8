"""Where the dimensions of a drawing stand, and where else they may."""

from collections.abc import Mapping
from dataclasses import dataclass

from exercises.figures.dimensioning import OFFSETS, USUAL_OFFSET, DimensionWay, dimension_ways
from exercises.figures.drawing import drawn
from exercises.figures.geometry import Scene
from exercises.figures.specification import View
from kinematics.frames.wrong_frames import DrawnFrame
from kinematics.se3 import Floats


@dataclass(frozen=True, kw_only=True, slots=True)
class DimensionPlace:
    """Where a dimension stands in a drawing, and where else it may stand.

    Attributes:
        ends: its two points on paper.
        line: the ends of its line.
        label: the middle of its name.
        ways: in which directions the line may be moved off its points.
    """

    ends: tuple[tuple[float, float], tuple[float, float]]
    line: tuple[tuple[float, float], tuple[float, float]]
    label: tuple[float, float]
    ways: tuple[DimensionWay, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class DimensionLayout:
    """The places of a drawing's dimensions.

    Attributes:
        box: left, top, width and height of the paper.
        distances: how far a line may be moved [unit of the paper].
        usual: the distance that a definition calls 1.
        places: one for each dimension, in order.
    """

    box: tuple[float, float, float, float]
    distances: tuple[float, ...]
    usual: float
    places: tuple[DimensionPlace, ...]


def dimension_layout(
    scene: Scene, view: View, width: float, note: str, frames: Mapping[int, DrawnFrame]
) -> DimensionLayout:
    """Return where dimensions stand in a drawing, and where else they may; arguments as in `draw_figure`."""
    drawing = drawn(scene, view, width, note, frames)
    places = []
    for dimension, found in zip(scene.dimensions, drawing.dimensions, strict=True):
        (start, end), ways = dimension_ways(dimension, drawing.camera)
        places.append(
            DimensionPlace(
                ends=(_pair(start), _pair(end)),
                line=(_pair(found.start), _pair(found.end)),
                label=_pair(found.label),
                ways=tuple(ways),
            )
        )
    return DimensionLayout(box=drawing.box(), distances=OFFSETS, usual=USUAL_OFFSET, places=tuple(places))


def _pair(point: Floats) -> tuple[float, float]:
    return round(float(point[0]), 2), round(float(point[1]), 2)
