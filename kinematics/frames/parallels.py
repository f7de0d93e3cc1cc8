"""Axes that are parallel but for a tiny tilt.

A calibrated robot has axes that are parallel by design and tilted by a fraction of a degree in fact. Their
common normal exists and is useless: with a tilt of 0.0007 rad it lies hundreds of metres away, and so do the
origins and the d of the table. Denavit–Hartenberg rows have four numbers, a tilt needs a fifth (Hayati's β).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from kinematics.frames.axes import AxisLine
from kinematics.frames.normals import EXACT_ANGLE
from kinematics.se3 import (
    Vector,
    cross,
    dot,
    foot,
    norm,
    perpendicular,
    rejection,
    scale,
    subtract,
    triple,
    unit,
)
from kinematics.table import JointType

PARALLEL_TOLERANCE = 5e-3  # Axes whose directions differ by less than this [rad] are near-parallel; 0.29°.

MAX_PARALLEL_TOLERANCE = 0.1
"""Beyond 6° nobody calls axes near-parallel, and the straightened robot is another one."""

_DECIDES = 1e-4
"""Mean square of the sine to a direction above which axes decide where their middle is along it."""


class NearParallel(StrEnum):
    """What becomes of two near-parallel axes.

    PARALLEL: the second is taken as parallel to the first, turned about its point nearest to the middle of
    the robot.
    DUMMY_ROW: a fixed row between the two carries the tilt, and the table reproduces the axes exactly.
    """

    PARALLEL = "parallel"
    DUMMY_ROW = "dummy_row"


@dataclass(frozen=True, slots=True)
class Tilt:
    """A tilt that was found between axis `joint` and the one before it, both counted from 1.

    Attributes:
        joint: the later of the two joints.
        angle: the tilt [rad].
        pivot: point of its axis about which it was turned, or through which the dummy axis passes.
    """

    joint: int
    angle: float
    pivot: Vector


def straighten(lines: Sequence[AxisLine], tolerance: float) -> tuple[list[AxisLine], list[Tilt]]:
    """Return the axes with near-parallel neighbours made parallel.

    Every axis of a run is compared with the first of the run, so tilts do not add up unnoticed.

    Args:
        tolerance: largest tilt [rad] that counts as near-parallel.
    """
    straight = [lines[0]]
    tilts: list[Tilt] = []
    centre: Vector | None = None
    reference = lines[0].direction
    for k in range(1, len(lines)):
        line = lines[k]
        tilt = _tilt(reference, line.direction)
        step = _tilt(lines[k - 1].direction, line.direction)
        if tilt <= EXACT_ANGLE:
            straight.append(line)
        elif tilt <= tolerance or (step <= tolerance and tilt <= 2 * tolerance):
            centre = middle(lines) if centre is None else centre
            pivot = foot(centre, line.point, line.direction)
            sense = 1.0 if dot(reference, line.direction) > 0 else -1.0
            straight.append(AxisLine(line.joint, pivot, scale(reference, sense)))
            tilts.append(Tilt(k + 1, tilt, pivot))
        else:
            straight.append(line)
            reference = line.direction
    return straight, tilts


def with_dummies(
    lines: Sequence[AxisLine], tolerance: float, size: float
) -> tuple[list[AxisLine], list[Tilt]]:
    """Return the axes with a fixed, crossing axis between near-parallel neighbours.

    The dummy axis runs from one to the other across both, through their points nearest to the robot's middle.
    """
    chain = [lines[0]]
    tilts: list[Tilt] = []
    for k in range(1, len(lines)):
        before, line = lines[k - 1], lines[k]
        tilt = _tilt(before.direction, line.direction)
        if EXACT_ANGLE < tilt <= tolerance:
            start = foot(middle(lines), before.point, before.direction)
            end = foot(start, line.point, line.direction)
            across = rejection(subtract(end, start), before.direction)
            apart = norm(across) > 1e-6 * size
            direction = unit(subtract(end, start)) if apart else perpendicular(before.direction)
            chain.append(AxisLine(JointType.FIXED, start, direction))
            tilts.append(Tilt(k + 1, tilt, end))
        chain.append(line)
    return chain, tilts


def middle(lines: Sequence[AxisLine]) -> Vector:
    """Return the point with the least sum of squared distances to the axes.

    Prismatic axes have no place and no say.

    Along directions in which the axes alone decide nothing, or nothing sound (they are parallel, or all but
    parallel and meet far away), it is level with the mean of the points that were given.
    """
    placed = [line for line in lines if line.joint is not JointType.PRISMATIC] or list(lines)
    points = np.array([line.point for line in placed])
    directions = np.array([line.direction for line in placed])
    across = np.eye(3) - directions[:, :, None] * directions[:, None, :]
    mean = points.mean(axis=0)
    values, vectors = np.linalg.eigh(across.sum(axis=0))
    sides = vectors.T @ np.einsum("kij,kj->i", across, points - mean)
    sound = values > _DECIDES * len(placed)
    centre = mean + vectors @ np.where(sound, sides / np.where(sound, values, 1.0), 0.0)
    return triple(centre.tolist())


def _tilt(u: Vector, v: Vector) -> float:
    return norm(cross(u, v))
