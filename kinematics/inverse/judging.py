"""Candidates of many targets, judged in one pass: how far off, how near a singularity, which are the same.

What is asked is recorded once for an arm, as one tape (see `kinematics.evaluation`), and replayed on all
candidates. The determinant of the Jacobian is the same whichever frame and point velocities refer to; seen
from the middle of the arm most entries of the axes' lines are constants or zero, and some fifty operations
are enough.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.dh import ElementaryMotion, JointValue, MotionKind
from kinematics.evaluation.blocks import run_blocks
from kinematics.evaluation.plan import EvaluationPlan
from kinematics.evaluation.recurrences import LinkMotions, end_pose, joint_axes
from kinematics.evaluation.tape import Recorder, Tape
from kinematics.inverse.arm import Array
from kinematics.inverse.residuals import angles_of_chords
from kinematics.se3 import Scalar, cross

_POSITION = (3, 7, 11)
_ROTATION = (0, 1, 2, 4, 5, 6, 8, 9, 10)
_ENTRIES = 12
"""Entries of a pose that are compared: its upper three rows."""

_WEIGHTS = tuple(math.sqrt(k) / 11.0 for k in range(1, 7))
"""Their sum is less than 1, so that a fingerprint differs by no more than a joint does."""


class Judgement(NamedTuple):
    """What is said about k candidates.

    Attributes:
        position_error: (k,) distance from the target [m].
        orientation_error: (k,) angle from the target [rad].
        volume: (k,) |det J| [m³].
        fingerprint: (k,) a number that differs by at most δ where all joint values differ by at most δ, full
            turns apart, and that in general differs where they do.
    """

    position_error: Array
    orientation_error: Array
    volume: Array
    fingerprint: Array


def judge(plan: EvaluationPlan, joints: Array, targets: Array, counts: NDArray[np.intp]) -> Judgement:
    """Judge candidates by the forward kinematics.

    Args:
        plan: of an arm of six revolute joints, base and tool included.
        joints: (k, 6) candidates; what is not finite is judged infinitely far off.
        targets: (m, 4, 4).
        counts: (m,) how many of the candidates belong to each target, in order of the targets.
    """
    asked = np.empty((_ENTRIES + 2, len(joints)))
    run_blocks(_tape(plan), plan.chain.joint_types, joints, asked.T)
    wanted = np.ascontiguousarray(targets[:, :3].reshape(-1, _ENTRIES).T)
    off = asked[:_ENTRIES]
    np.subtract(off, np.repeat(wanted, counts, axis=1), out=off)
    np.square(off, out=off)
    chord = np.sqrt(_sum(off, _ROTATION))
    return Judgement(
        position_error=np.sqrt(_sum(off, _POSITION)),
        orientation_error=angles_of_chords(chord),
        volume=np.abs(asked[_ENTRIES]),
        fingerprint=asked[_ENTRIES + 1],
    )


def _sum(rows: Array, which: Sequence[int]) -> Array:
    total: Array = rows[which[0]].copy()
    for i in which[1:]:
        total += rows[i]
    return total


@lru_cache(maxsize=64)
def _tape(plan: EvaluationPlan) -> Tape:
    """End pose, determinant and fingerprint of an arm of six revolute joints."""
    recorder = Recorder(12)
    values = list(zip(recorder.inputs[:6], recorder.inputs[6:], strict=True))
    rows = end_pose(plan.chain, values)
    lines = _lines(plan.chain, values)
    volume = _determinant([[line[i] for line in lines] for i in range(6)])
    fingerprint: Scalar = 0.0
    for phase, ((c, s), weight) in enumerate(zip(values, _WEIGHTS, strict=True), start=1):
        fingerprint = fingerprint + (c * (weight * math.cos(phase)) + s * (weight * math.sin(phase)))
    return recorder.tape([*rows[0], *rows[1], *rows[2], volume, fingerprint])


def _lines(chain: LinkMotions, values: Sequence[JointValue]) -> list[tuple[Scalar, ...]]:
    """Plücker coordinates (p × z, z) of the joints' axes, seen from before the fourth."""
    middle = next(i for i, motions in enumerate(chain.links) if any(m.joint == 3 for m in motions))
    before = LinkMotions(links=(_backwards(chain.links[:middle]),), joint_types=chain.joint_types)
    after = LinkMotions(links=chain.links[middle:], joint_types=chain.joint_types)
    axes = joint_axes(before, values)[::-1] + joint_axes(after, values)
    return [(*cross(point, direction), *direction) for direction, point in axes]


def _backwards(links: Sequence[Sequence[ElementaryMotion]]) -> tuple[ElementaryMotion, ...]:
    """The inverse motions in reverse order.

    Turns about z come before shifts along it: an axis through the origin then stays one, term by term.
    """
    motions: list[ElementaryMotion] = []
    for motion in (motion for link in reversed(links) for motion in reversed(link)):
        turns = motion.kind in (MotionKind.TURN_X, MotionKind.TURN_Z)
        first = motion.first if turns else -motion.first
        inverse = motion._replace(first=first, second=-motion.second, sign=-motion.sign)
        swap = motions and motion.kind is MotionKind.TURN_Z and motions[-1].kind is MotionKind.SHIFT_Z
        motions.insert(len(motions) - bool(swap), inverse)
    return tuple(motions)


def _determinant(rows: Sequence[Sequence[Scalar]]) -> Scalar:
    """Of a 6×6 matrix, by Laplace's expansion into products of 3×3 minors."""
    upper, lower = _minors(rows[:3]), _minors(rows[3:])
    total: Scalar = 0.0
    for columns, minor in upper.items():
        rest = tuple(i for i in range(6) if i not in columns)
        total = total + _signed(minor * lower[rest], sum(columns) - 3)
    return total


def _minors(rows: Sequence[Sequence[Scalar]]) -> dict[tuple[int, ...], Any]:
    """Determinants of all square matrices that rows of six have, by their columns."""
    minors: dict[tuple[int, ...], Any] = {(): 1.0}
    for k, row in enumerate(rows):
        larger: dict[tuple[int, ...], Any] = {}
        for columns in combinations(range(6), k + 1):
            total: Scalar = 0.0
            for i, column in enumerate(columns):
                minor = minors[columns[:i] + columns[i + 1 :]]
                total = total + _signed(row[column] * minor, k + i)
            larger[columns] = total
        minors = larger
    return minors


def _signed(term: Any, exponent: int) -> Scalar:
    signed: Scalar = -term if exponent % 2 else term
    return signed
