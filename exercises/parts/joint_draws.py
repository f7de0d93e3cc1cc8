"""Joint values that are drawn for a student, and the key's frames at them."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from functools import lru_cache

import numpy as np

from exercises.definition import Exercise
from exercises.draws import Draw, Picker, read_draw
from exercises.instance import Instance
from exercises.parts.first_values import joint_names
from exercises.parts.protocol import RobotFacts
from exercises.reading import KeyShape, Reader
from kinematics.chain import chain_of_table, size_of
from kinematics.forward import forward_kinematics
from kinematics.se3 import Transform
from kinematics.table import JointType, NumericTable, bind


class PoseCase(StrEnum):
    """What the pose of a student is.

    REACHED: that of the drawn joint values. OUT_OF_REACH: the same orientation, too far away.
    """

    REACHED = "reached"
    OUT_OF_REACH = "out_of_reach"


@dataclass(frozen=True, kw_only=True, slots=True)
class JointDraws:
    """Joint values of a part [the exercise's units]: the usual ones, and from where others are drawn."""

    usual: tuple[Fraction, ...]
    ways: tuple[Draw | None, ...]

    def drawn(self, picker: Picker, name: str) -> tuple[Fraction, ...]:
        """Return a student's own, drawn under the name of a kind of part."""
        return tuple(
            picker.value(value, way, f"{name} q{i}")
            for i, (value, way) in enumerate(zip(self.usual, self.ways, strict=True), 1)
        )


class SolutionsAsked(StrEnum):
    """How many solutions of inverse kinematics are asked."""

    ALL = "all"
    ONE = "one"


def told_units(exercise: Exercise) -> tuple[str, ...]:
    """Return the unit in which the values of each joint are stated."""
    units = {JointType.REVOLUTE: exercise.angle_unit.sign, JointType.PRISMATIC: exercise.length_unit.value}
    return tuple(units[kind] for kind in exercise.reference.table.joint_types)


def joint_labels(exercise: Exercise) -> tuple[str, ...]:
    """Return what columns of joint values are called: their names and units."""
    return tuple(f"q{i} [{unit}]" for i, unit in enumerate(told_units(exercise), 1))


def read_joints(
    reader: Reader, robot: RobotFacts, *, single: bool = True, usual_turns: Draw | None = None
) -> JointDraws:
    """Return the usual joint values of a part, and per joint from where a student's own are drawn.

    `turns` are for revolute joints, `slides` for prismatic ones, `q1`, `q2`, … for a single joint.

    Args:
        single: joints may have a draw of their own.
        usual_turns: from where angles are drawn if nothing is said.
    """
    names, kinds = joint_names(len(robot.joint_types)), robot.joint_types
    reader.note("joints", KeyShape.NUMBERS, names)
    joints = reader.per_joint("joints", len(names))
    turns = read_draw(reader, "turns", of_use=JointType.REVOLUTE in kinds) or usual_turns
    slides = read_draw(reader, "slides", of_use=JointType.PRISMATIC in kinds)
    own = {name: read_draw(reader, name) for name in names if single}
    usual = (slides if kind is JointType.PRISMATIC else turns for kind in kinds)
    ways = tuple(
        own[name] if single and reader.given(name) else way for name, way in zip(names, usual, strict=True)
    )
    return JointDraws(usual=joints, ways=ways)


def in_radians(exercise: Exercise, joints: Sequence[Fraction]) -> list[float]:
    """Return joint values of the exercise in [rad] and in its length unit."""
    unit = exercise.angle_unit
    return [
        unit.in_radians(float(value)) if kind is JointType.REVOLUTE else float(value)
        for value, kind in zip(joints, exercise.reference.table.joint_types, strict=True)
    ]


CACHED_KEYS = 512
"""Students whose keys, in numbers, are in the cache: each hands in several parts, and again."""


@lru_cache(maxsize=CACHED_KEYS)
def key_size(instance: Instance) -> float:
    """Return a length that is typical of the key's robot [the exercise's unit]."""
    return size_of(chain_of_table(key_numbers(instance)))


@lru_cache(maxsize=CACHED_KEYS)
def key_numbers(instance: Instance) -> NumericTable:
    """Return the key with the student's values; lengths in the exercise's unit."""
    return bind(instance.exercise.reference.table, instance.values)


def key_frames(instance: Instance, joints: Sequence[Fraction]) -> list[Transform]:
    """Return the poses of frame 0 … N of the key in frame 0, at joint values of the exercise."""
    found = forward_kinematics(key_numbers(instance), in_radians(instance.exercise, joints))
    return [np.eye(4), *found.frames]
