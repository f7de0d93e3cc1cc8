"""The figure of an instance: as a scene, as geometry for programs, as SVG."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from exercises.definition import Exercise
from exercises.figures.description import Sentence, describe
from exercises.figures.dimension_layout import DimensionLayout, dimension_layout
from exercises.figures.drawing import draw_figure
from exercises.figures.geometry import Scene, build_scene, close, scene_vector
from exercises.figures.points import Points, frames_in_figure, posture_in_figure
from exercises.figures.skeleton import usual_dimensions
from exercises.figures.specification import DimensionMark
from exercises.figures.svg import SvgDrawing
from exercises.grading import BaseRule, DirectionRule, ToolRule, ZeroRule
from exercises.grading.judging.exact_text import expression_text
from exercises.grading.verdict import Matrix4
from exercises.instance import Instance
from kinematics.cells import parameters_in_radians
from kinematics.expressions import Parameter
from kinematics.frames.wrong_frames import DrawnFrame, right_handed
from kinematics.poses import transform_from_rpy
from kinematics.se3 import Vector, position, scale, x_axis, z_axis
from kinematics.table import JointType

CACHED_SCENES = 2048
"""Instances whose scene and `KeyPose` are in the cache: a large class asks for numbers, words and drawings of
its figures one after the other, and hands in later."""


@dataclass(frozen=True, kw_only=True, slots=True)
class KeyPose:
    """How the key lies in the figure; told with an accepted table only.

    Attributes:
        base: pose of the key's frame 0 in the figure [m].
        posture: the key's joint values in the figure [rad or m].
        directions: unit vectors along the joint axes, in the sense of the key's variables.
    """

    base: Matrix4
    posture: tuple[float, ...]
    directions: tuple[Vector, ...]


@lru_cache(maxsize=CACHED_SCENES)
def true_scene(instance: Instance) -> Scene:
    """Return the scene with the student's own lengths."""
    return _scene(instance, drawn=False)


def _scene(instance: Instance, *, drawn: bool) -> Scene:
    exercise = instance.exercise
    return build_scene(
        exercise.figure,
        exercise.reference.table,
        instance.values,
        signed_axes=shows_signs(exercise),
        drawn=drawn,
    )


def figure_drawing(instance: Instance, note: str = "", frames: Sequence[DrawnFrame] = ()) -> SvgDrawing:
    """Return the figure without the words that tell of it.

    Args:
        note: what is written below a figure that is not to scale.
        frames: frame 0 … N, to be drawn on the robot, which is to scale then; without them, those that the
            policy prescribes.
    """
    figure = instance.exercise.figure
    scene = true_scene(instance) if frames else _drawn_scene(instance)
    numbered = dict(enumerate(frames)) or prescribed_frames(instance, drawn_values(instance))
    return draw_figure(scene, figure.view, figure.width, note="" if scene.to_scale else note, frames=numbered)


def prescribed_frames(instance: Instance, values: Mapping[str, float]) -> dict[int, DrawnFrame]:
    """Return the frames that a policy prescribes, by number: they are told, and not asked for."""
    exercise = instance.exercise
    poses = frames_in_figure(exercise.figure, exercise.reference.table, values)
    numbers = [0] if exercise.policy.base is BaseRule.FRAME else []
    if exercise.policy.tool is ToolRule.FRAME:
        numbers.append(len(poses) - 1)
    turned = {i: (position(poses[i]), x_axis(poses[i]), z_axis(poses[i])) for i in numbers}
    return {i: right_handed(*map(scene_vector, vectors)) for i, vectors in turned.items()}


def drawn_values(instance: Instance) -> dict[str, float]:
    """Return the values with which the robot is drawn: the student's, or those the figure fixes for all."""
    return {**instance.values, **instance.exercise.figure.lengths}


@dataclass(frozen=True, kw_only=True, slots=True)
class FigureDimensions:
    """The dimensions of a figure: what its definition says of them, or would say, and where they stand.

    Attributes:
        marks: as a definition has them under `figure.dimensions`, in order.
        layout: where they stand, in the same order.
    """

    marks: tuple[Mapping[str, object], ...]
    layout: DimensionLayout


def figure_dimensions(instance: Instance, note: str = "") -> FigureDimensions:
    """Return the dimensions of the figure as `figure_drawing` draws it with the same note."""
    exercise = instance.exercise
    figure = exercise.figure
    scene = _drawn_scene(instance)
    marks = figure.dimensions or tuple(usual_dimensions(exercise.reference.table))
    frames = prescribed_frames(instance, drawn_values(instance))
    shown = "" if scene.to_scale else note
    return FigureDimensions(
        marks=tuple(_mark(mark) for mark in marks),
        layout=dimension_layout(scene, figure.view, figure.width, shown, frames),
    )


def _mark(mark: DimensionMark) -> dict[str, object]:
    """Return a dimension as a definition has it."""
    found: dict[str, object] = {"name": mark.name, "from": mark.start, "to": mark.end}
    if mark.value != Parameter(mark.name):
        found["value"] = expression_text(mark.value)
    if mark.offset is not None:
        found["offset"] = mark.offset
    if mark.distance != 1.0:
        found["distance"] = mark.distance
    return found


@lru_cache(maxsize=CACHED_SCENES)
def end_marks(exercise: Exercise) -> tuple[str, ...]:
    """Return the marked points that are the key's last origin, or slid from it where zeros are free."""
    table = exercise.reference.table
    values = parameters_in_radians(exercise.usual_values, exercise.reference.parameters, exercise.angle_unit)
    points = Points(exercise.figure, table, values)
    free = exercise.policy.zero is ZeroRule.FREE
    slides = np.array(
        [
            z_axis(points.motions[frame])
            for frame, joint in zip(table.axis_frames, table.joint_types, strict=True)
            if free and joint is JointType.PRISMATIC
        ]
    ).reshape(-1, 3)

    def is_end(name: str) -> bool:
        apart = np.array(points.point(name, "marks")) - position(points.motions[-1])
        along = np.linalg.lstsq(slides.T, apart, rcond=None)[0] @ slides
        return close(apart.tolist(), along.tolist())

    return tuple(filter(is_end, exercise.figure.marks))


def figure_sentences(instance: Instance) -> tuple[Sentence, ...]:
    """Return the figure in words."""
    exercise = instance.exercise
    prescribed = prescribed_frames(instance, instance.values)
    scene = true_scene(instance)
    sentences = list(describe(scene, exercise.figure.view, exercise.length_unit.value, prescribed))
    if exercise.figure.lengths:
        names = tuple(exercise.figure.lengths)
        params: dict[str, str | int] = {"names": ", ".join(names), "count": len(names)}
        sentences.append(Sentence(code="not-to-scale", params=params))
    return tuple(sentences)


def figure_geometry(instance: Instance, frames: Sequence[DrawnFrame] = ()) -> dict[str, object]:
    """Return the figure as plain data, lengths in [m].

    Axes, links, dimensions, points, size, signs, drawn frames.

    Directions of axes have a sense only where the policy fixes it (`signed`); otherwise the sense tells
    nothing.
    """
    scene = true_scene(instance)
    numbered = dict(enumerate(frames)) or prescribed_frames(instance, instance.values)
    metres = float(instance.exercise.length_unit.metres_per_unit)

    def place(point: Vector) -> list[float]:
        return [value * metres for value in point]

    return {
        "axes": [
            {
                "joint": axis.joint,
                "type": axis.type.value,
                "point": place(axis.point),
                "direction": list(axis.direction),
                "signed": axis.signed,
            }
            for axis in scene.axes
        ],
        "links": [[place(point) for point in chain] for chain in scene.links],
        "dimensions": [
            {"name": dimension.name, "from": place(dimension.start), "to": place(dimension.end)}
            for dimension in scene.dimensions
        ],
        "points": [{"name": point.name, "at": place(point.at)} for point in scene.points],
        "ground": {"at": place(scene.ground.at), "normal": list(scene.ground.normal)}
        if scene.ground
        else None,
        "size": scene.size * metres,
        "frames": [
            {"number": i, "origin": place(frame.origin)}
            | {axis: list(getattr(frame, axis)) for axis in ("x", "y", "z")}
            for i, frame in numbered.items()
        ],
    }


@lru_cache(maxsize=CACHED_SCENES)
def key_pose(instance: Instance) -> KeyPose:
    """Return how the key lies in the figure; every accepted answer to the instance is shown it."""
    exercise = instance.exercise
    figure, table = exercise.figure, exercise.reference.table
    frames = frames_in_figure(figure, table, instance.values)
    metres = float(exercise.length_unit.metres_per_unit)
    return KeyPose(
        base=tuple(tuple(row) for row in transform_from_rpy(figure.upright).tolist()),
        posture=tuple(
            value * metres if joint_type is JointType.PRISMATIC else value
            for value, joint_type in zip(posture_in_figure(figure, table), table.joint_types, strict=True)
        ),
        directions=tuple(
            scene_vector(scale(z_axis(frames[frame]), table.rows[row].sign))
            for frame, row in zip(table.axis_frames, table.joint_rows, strict=True)
        ),
    )


def shows_signs(exercise: Exercise) -> bool:
    """Return whether the policy fixes what the figure then shows: the positive sense of joint variables."""
    return exercise.policy.direction is DirectionRule.FIGURE or exercise.policy.zero is ZeroRule.FIGURE


def _drawn_scene(instance: Instance) -> Scene:
    if not instance.exercise.figure.lengths:
        return true_scene(instance)
    return _scene(instance, drawn=True)
