"""The joint axes of an exercise's figure, and right frames on them, in its coordinates and unit of length."""

from __future__ import annotations

from exercises.drawings import true_scene, values
from exercises.figures.points import Points
from exercises.instance import Instance
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import JointAxis
from kinematics.frames.wrong_frames import DrawnFrame, right_handed
from kinematics.se3 import Vector


def figure_axes(instance: Instance) -> list[JointAxis]:
    """Return the axes as the figure shows them."""
    return [
        JointAxis(joint=axis.type, direction=axis.direction, point=axis.point)
        for axis in true_scene(instance).axes
    ]


def key_frames(instance: Instance) -> list[DrawnFrame]:
    """Return the frames of the key where it has one for each joint, else those of the procedure."""
    reference = instance.exercise.reference.table
    if len(reference.rows) > reference.n_joints:
        assigned = assign_frames(figure_axes(instance), reference.convention)
        return [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
    points = Points(instance.exercise.figure, reference, values(instance))
    found = []
    for pose in points.frames:
        x, _, z, origin = (_vector(column) for column in pose[:3].T.tolist())
        found.append(right_handed(origin, x, z))
    return found


def _vector(column: list[float]) -> Vector:
    x, y, z = column
    return x, y, z
