"""Points of links: where they are in the previous frame and in the world, at one configuration or at many."""

from collections.abc import Callable, Iterator, Sequence
from typing import TypeAlias

import numpy as np

from kinematics.errors import Fault, TableError
from kinematics.forward import ForwardKinematics
from kinematics.inverse.lengths import is_long, too_long
from kinematics.se3 import Floats
from service.wire.json_chunks import blocks, member_chunks
from service.wire.kinematics.prepared_robots import PreparedRobot

LinkPoint: TypeAlias = tuple[int, Sequence[float]]  # The number of its frame, from 1, and coordinates in it.

_POSES = 256  # Configurations of which all links and frames are in memory at a time.
_POINTS = 4
"""Points whose places are in memory at a time: forty megabytes for the longest batch."""


def check_points(robot: PreparedRobot, points: Sequence[LinkPoint]) -> None:
    """Make sure that every point is one of a link that there is, and can be computed with.

    Raises:
        TableError: it is not, at ("points", i, "frame"), or cannot, at ("points", i, "at", k).
    """
    count = len(robot.table.rows)
    faults = [
        Fault.at("frame_unknown", "points", i, "frame", given=frame, count=count)
        for i, (frame, _) in enumerate(points)
        if frame > count
    ]
    faults += [
        too_long(("points", i, "at", k))
        for i, (_, at) in enumerate(points)
        for k, value in enumerate(at)
        if is_long(value)
    ]
    if faults:
        raise TableError(faults)


def places_of(points: Sequence[LinkPoint], poses: ForwardKinematics) -> list[dict[str, Floats]]:
    """Return where points of links are: seed 003 eq. 1 and 8."""
    return [
        {
            name: array[..., frame - 1, :3, :3] @ np.array(at) + array[..., frame - 1, :3, 3]
            for name, array in (("previous", poses.links), ("world", poses.frames))
        }
        for frame, at in points
    ]


def place_chunks(
    points: Sequence[LinkPoint], count: int, poses: Callable[[int, int], ForwardKinematics]
) -> Iterator[bytes]:
    """Yield where points of links are at so many configurations, as a JSON list; memory stays flat.

    Args:
        poses: returns those of a block of the batch.
    """
    yield b"["
    for first, last in blocks(len(points), _POINTS):
        some = points[first:last]
        places = [{name: np.empty((count, 3)) for name in ("previous", "world")} for _ in some]
        for start, stop in blocks(count, _POSES):
            for place, found in zip(places, places_of(some, poses(start, stop)), strict=True):
                for name, array in found.items():
                    place[name][start:stop] = array
            yield b""
        for k, place in enumerate(places, first):
            yield b",{" if k else b"{"
            yield from member_chunks(place)
            yield b"}"
    yield b"]"
