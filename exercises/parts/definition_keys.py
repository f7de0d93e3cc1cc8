"""What a part's definition may say, for a page on which exercises are made: its keys, and where to begin."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any

from kinematics.rotations.sequences import Turning
from kinematics.table import JointType

if TYPE_CHECKING:
    from exercises.parts.protocol import RobotFacts

SEQUENCES = ("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX", "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ")
"""Every order of three axes that describes all orientations."""
DEGREES = (30, 45, -60, 90, -30, 60)
RADIANS = (0.5, 0.8, -1.0, 1.5, -0.5, 1.0)
SLIDE = 0.2
"""Joint values to begin with: away from the zeros at which wrong answers look right."""


class KeyShape(StrEnum):
    """What the value of a key looks like.

    NUMBER: a number. TEXT: a text. CHOICE: one of some words. CHOICES: some of them. NUMBERS: a number for
    each label. CELLS: a number or a name for each label. DRAW: from where a student's own value is drawn.
    POINT: the name of a point of the figure. FRAMES: from a frame to another. FRAME_PAIRS: several of these.
    RANGES: for each label the least and the greatest value, or none; or the word `catalogue`.
    BODIES: for each row mass, centre and moments of what moves with it. QUANTITIES: by name a value, and from
    where a student's own is drawn.
    """

    NUMBER = "number"
    TEXT = "text"
    CHOICE = "choice"
    CHOICES = "choices"
    NUMBERS = "numbers"
    CELLS = "cells"
    DRAW = "draw"
    POINT = "point"
    FRAMES = "frames"
    FRAME_PAIRS = "frame_pairs"
    RANGES = "ranges"
    BODIES = "bodies"
    QUANTITIES = "quantities"


@dataclass(frozen=True, kw_only=True, slots=True)
class DefinitionKey:
    """A key of a part's definition.

    Attributes:
        name: it; what it is called is the message `key-<name>`.
        shape: what its value looks like.
        labels: what the entries of a list are called.
        options: what may be chosen; their names are the messages `choice-<option>`.
    """

    name: str
    shape: KeyShape
    labels: tuple[str, ...] = ()
    options: tuple[str, ...] = ()


TOLERANCE = DefinitionKey(name="tolerance", shape=KeyShape.NUMBER)


def joint_names(count: int) -> tuple[str, ...]:
    """Return q1 … qn."""
    return tuple(f"q{i}" for i in range(1, count + 1))


def joint_keys(robot: RobotFacts, *, single: bool = True) -> tuple[DefinitionKey, ...]:
    """Return the keys of joint values and of the draws of students' own ones.

    Args:
        robot: whose joints.
        single: joints may have a draw of their own.
    """
    names = joint_names(len(robot.joint_types))
    keys = [DefinitionKey(name="joints", shape=KeyShape.NUMBERS, labels=names)]
    if JointType.REVOLUTE in robot.joint_types:
        keys.append(DefinitionKey(name="turns", shape=KeyShape.DRAW))
    if JointType.PRISMATIC in robot.joint_types:
        keys.append(DefinitionKey(name="slides", shape=KeyShape.DRAW))
    if single:
        keys += [DefinitionKey(name=name, shape=KeyShape.DRAW) for name in names]
    return tuple(keys)


def usual_joints(robot: RobotFacts) -> list[int | float]:
    """Return joint values to begin with [the exercise's units]."""
    turns: tuple[int | float, ...] = DEGREES if robot.degrees else RADIANS
    return [
        SLIDE if kind is JointType.PRISMATIC else turns[i % len(turns)]
        for i, kind in enumerate(robot.joint_types)
    ]


def choice(name: str, options: Iterable[str]) -> DefinitionKey:
    """Return a key whose value is one of some words."""
    return DefinitionKey(name=name, shape=KeyShape.CHOICE, options=tuple(options))


def choices(name: str, options: Iterable[str]) -> DefinitionKey:
    """Return a key whose value is a list of some words."""
    return DefinitionKey(name=name, shape=KeyShape.CHOICES, options=tuple(options))


def sequence_keys(axes: str, turning: str) -> tuple[DefinitionKey, ...]:
    """Return the two keys of an order of axes."""
    return choice(axes, SEQUENCES), choice(turning, Turning)


Start = dict[str, Any]
