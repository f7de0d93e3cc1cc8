"""The joint axes of an exercise's figure, and right frames on them, in its coordinates and unit of length."""

import math
from collections.abc import Iterable, Sequence

from exercises.drawings import true_scene
from exercises.figures.description import coordinates_told
from exercises.figures.points import Points
from exercises.instance import Instance
from exercises.parts.cells.number_cells import read_numbers_of
from exercises.parts.protocol import Reading
from kinematics.cells import Cell
from kinematics.cells.meaning import Position
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import JointAxis, read_direction, read_point
from kinematics.frames.wrong_frames import DrawnFrame, right_handed
from kinematics.se3 import Vector, triple

COSINES = 0.01  # How far from 1 a direction may be whose components were rounded.


def figure_axes(instance: Instance) -> list[JointAxis]:
    """Return the axes as the figure shows them."""
    return [
        JointAxis(joint=axis.type, direction=axis.direction, point=axis.point)
        for axis in true_scene(instance).axes
    ]


def figure_coordinates(instance: Instance) -> dict[str, str]:
    """Return the values by which a task says in which coordinates the figure counts."""
    return coordinates_told(true_scene(instance), instance.exercise.figure.view)


def key_frames(instance: Instance) -> list[DrawnFrame]:
    """Return the frames of the key where it has one for each joint, else those of the procedure."""
    reference = instance.exercise.reference.table
    if len(reference.rows) > reference.n_joints:
        assigned = assign_frames(figure_axes(instance), reference.convention)
        return [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
    points = Points(instance.exercise.figure, reference, instance.values)
    found = []
    for pose in points.frames:
        x, _, z, origin = map(tuple, pose[:3].T.tolist())
        found.append(right_handed(origin, x, z))
    return found


def lengths_in_frame(origin: Sequence[float], directions: Iterable[Sequence[float]]) -> list[float]:
    """Return the lengths in a frame: its origin, and directions whose components may be lengths of the arm.

    A direction along an axis of the figure is none, and neither is one of length 1: these are cosines.
    """
    found = [*origin]
    for direction in directions:
        sizes = {round(abs(component), 9) for component in direction if component}
        if len(sizes) > 1 and abs(math.hypot(*direction) - 1.0) > COSINES:
            found += direction
    return found


def read_vector(cells: Sequence[Cell], reading: Reading, *where: str | int) -> Vector | None:
    """Return a point or a direction that was typed as three cells, or None; faults go to the reading.

    Where the last name of their place is no origin, they are a direction.
    """
    numbers = read_numbers_of(cells, Position.LENGTH, reading, *where)
    if numbers is None:
        return None
    check = read_point if str(where[-1]).endswith("origin") else read_direction
    check(numbers, where, reading.faults)
    return triple(numbers)
