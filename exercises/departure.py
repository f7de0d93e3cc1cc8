"""Where a wrong table leaves the robot: how the robot that it describes lies on the one in the figure.

The first joints of both are the same mechanism up to some joint k, whatever the frames: there are joint
signs, joint offsets and a base motion that carry the key's first k axes onto the answer's for every
configuration (docs/checker.md, equation (1), of the tables cut off after joint k). With these the answer's
robot is laid on the figure; each joint from k on is turned so that the next axis comes as near to the
figure's as it can.

Nothing of the key's own frames is told: only where the answer's robot stands beside axes that the figure
shows.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise, takewhile

import numpy as np

from exercises.definition import Exercise
from exercises.drawings import shows_signs
from exercises.figures.geometry import shown_sense
from exercises.figures.points import posture_in_figure
from exercises.grading import Finding, Verdict
from exercises.grading.axis_directions import least_cost
from exercises.grading.verdict import Matrix4
from exercises.instance import Instance
from kinematics.cells import ReadTable, in_length_unit
from kinematics.chain import Axis, Chain, chain_of_table, size_of, table_at
from kinematics.equivalence import Certificate, Policy
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.decision import certify, mechanism_only
from kinematics.equivalence.invariants import axes_of, invariants_of
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.search import Effort
from kinematics.errors import KinematicsError
from kinematics.poses import transform_from_rpy
from kinematics.se3 import (
    IDENTITY,
    ORIGIN,
    Floats,
    Motion,
    Transform,
    Vector,
    compose,
    cross,
    dot,
    move,
    plus,
    rejection,
    rotate,
    subtract,
)
from kinematics.table import Convention, DHTable, JointType, NumericTable, bind

TURNS = np.radians(np.arange(0.0, 360.0, 1.0))
"""Angles [rad] that are tried for a joint: a degree more or less is not seen."""
_WEIGHTS = np.stack((np.ones_like(TURNS), np.cos(TURNS), np.sin(TURNS)), axis=1)
SLIDES = np.array(sorted(np.linspace(-1.0, 1.0, 201), key=abs))
"""Displacements that are tried, in robot sizes: a hundredth of the robot is not seen either. Least first."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Departure:
    """How the robot of a wrong table lies on the figure's, and where it leaves it.

    Attributes:
        row: the table's row (from 1) whose frame is the first that does not fit: the one that the verdict
            names first, if it names one.
        base: pose of the table's frame 0 in the figure [m].
        posture: joint values at which the table's robot lies on the figure as far as it can [rad or m].
        senses: per joint, +1 if it counts as the figure's axis points, else -1.
    """

    row: int
    base: Matrix4
    posture: tuple[float, ...]
    senses: tuple[int, ...]


def departure_of(instance: Instance, read: ReadTable, verdict: Verdict) -> Departure | None:
    """Return where the robot of a table leaves the figure's; None where it cannot be drawn or says nothing.

    Args:
        verdict: on this table, at a help level that tells what is wrong in a row.
    """
    exercise = instance.exercise
    if verdict.correct:
        return None
    try:
        given = instance.values
        key = bind(exercise.reference.table, given)
        answer = bind(in_length_unit(read, exercise.length_unit).table, given)
    except KinematicsError:
        return None
    shared, certificate = shared_joints(key, answer, exercise.policy)
    if certificate is None:
        return None
    row = _named(verdict) or _first_row(answer, shared)
    if row is None:
        return None
    figure = exercise.figure
    upright = transform_from_rpy(figure.upright)
    posture = posture_in_figure(figure, exercise.reference.table)
    base = upright @ np.linalg.inv(certificate.base)
    start = [
        sign * value + offset
        for sign, value, offset in zip(
            certificate.joint_signs, posture, certificate.joint_offsets, strict=False
        )
    ]
    shown = chain_of_table(table_at(key, posture), upright)
    joints, directions = _laid_on(chain_of_table(answer, base), start, shown.axes, size_of(shown) or 1.0)
    if not np.isfinite(base).all() or not np.isfinite(joints).all():
        return None  # lengths beyond what a number holds
    metres = float(exercise.length_unit.metres_per_unit)
    base[:3, 3] *= metres
    return Departure(
        row=min(row, len(answer.rows)),
        base=_rows(base),
        posture=tuple(
            float(value) * (metres if kind is JointType.PRISMATIC else 1.0)
            for value, kind in zip(joints, answer.joint_types, strict=True)
        ),
        senses=_senses(directions, shown.axes, exercise),
    )


def shared_joints(key: NumericTable, answer: NumericTable, policy: Policy) -> tuple[int, Certificate | None]:
    """Return how many first joints two tables share as a mechanism, and the certificate for these.

    The last joint's own offset is the certificate's choice: without the rest of the chain it means nothing.
    """
    free = mechanism_only(policy)
    for joints in range(joints_alike(key, answer, free), 0, -1):
        chain = chain_of_table(_first(answer, joints))
        reference = prepared(_first(key, joints)).beside(chain)
        found = certify((reference,), (chain,), free, Effort.PLAIN, measured=False)
        if found is not None:
            return joints, found
    return 0, None


def joints_alike(key: NumericTable, answer: NumericTable, policy: Policy) -> int:
    """Return how many first joints share types and invariants: no more are the same mechanism.

    The axes of those joints may point either way, so long as every invariant of theirs fits.
    """
    pairs = zip(key.joint_types, answer.joint_types, strict=False)
    joints = sum(1 for _ in takewhile(lambda pair: pair[0] is pair[1], pairs))
    if not joints:
        return 0
    chain = chain_of_table(_first(answer, joints))
    invariants = invariants_of(prepared(_first(key, joints)).beside(chain), policy)
    axes = axes_of(chain, policy)
    fits = invariants.fits(invariants.measured(axis_batch([axes])))
    concerned = invariants.spans[1] <= np.arange(1, joints + 1)  # of the first 1 … n joints
    wrong = least_cost(invariants.shapes, len(axes), np.asarray(concerned & ~fits, dtype=np.float64))
    return int((wrong == 0.0).sum())


def _first(table: NumericTable, joints: int) -> NumericTable:
    """Return the rows of a table up to that of a joint."""
    return DHTable(convention=table.convention, rows=table.rows[: table.joint_rows[joints - 1] + 1])


def _named(verdict: Verdict) -> int | None:
    """Return the first row that a verdict names."""
    told = [entry.row for entry in verdict.feedback if entry.row is not None]
    wrong = {Finding.WRONG, Finding.MISSING}
    found = [link.row for link in verdict.links if wrong & {link.length, link.twist, link.offset, link.joint}]
    return next(iter([*told, *found]), None)


def _first_row(answer: NumericTable, shared: int) -> int | None:
    """Return the row whose frame is the first off the robot, where so many joints are right."""
    at = [i for i, row in enumerate(answer.rows, 1) if row.joint is not JointType.FIXED]
    place = shared if answer.convention is Convention.MODIFIED else shared - 1
    return at[max(place, 0)] if place < len(at) else None


def _laid_on(
    chain: Chain, start: Sequence[float], shown: Sequence[Axis], size: float
) -> tuple[Floats, list[Vector]]:
    """Return joint values at which one axis after the other comes as near to the figure's as it can.

    And how the chain's axes then point.
    """
    joints = np.zeros(chain.n_joints)
    joints[: len(start)] = start
    here = IDENTITY
    directions = [axis.direction for axis in chain.axes[:1]]
    for i, (axis, following) in enumerate(pairwise(chain.axes)):
        beyond = compose(here, axis.motion(float(joints[i])))
        if len(start) - 1 <= i < len(shown) - 1:
            joints[i] += _best(_moved(axis, here), _moved(following, beyond), shown[i + 1], size)
            beyond = compose(here, axis.motion(float(joints[i])))
        here = beyond
        directions.append(rotate(here, following.direction))
    revolute = np.array([not axis.prismatic for axis in chain.axes])
    joints[revolute] = (joints[revolute] + math.pi) % math.tau - math.pi
    return joints, directions


def _moved(axis: Axis, motion: Motion) -> Axis:
    return Axis(axis.prismatic, rotate(motion, axis.direction), move(motion, axis.point))


def _best(axis: Axis, following: Axis, target: Axis, size: float) -> float:
    """Return by how much a joint moves so that the axis behind it comes nearest to the figure's."""
    if axis.prismatic:
        tried = SLIDES * size
        weights = np.stack((np.ones_like(tried), tried), axis=1)
        turned: Sequence[Vector] = (following.direction, ORIGIN)
        moved: Sequence[Vector] = (following.point, axis.direction)
    else:
        tried, weights = TURNS, _WEIGHTS
        turned = _turned(following.direction, axis.direction)
        along, *circle = _turned(subtract(following.point, axis.point), axis.direction)
        moved = (plus(axis.point, along), *circle)
    return float(tried[int(np.argmin(_off(weights, turned, moved, target, size)))])


def _turned(vector: Vector, axis: Vector) -> tuple[Vector, Vector, Vector]:
    """Return what a vector turned about an axis is made of: a part that stays, and of its cosine and sine."""
    across = rejection(vector, axis)
    return subtract(vector, across), across, cross(axis, vector)


def _off(
    weights: Floats, turned: Sequence[Vector], moved: Sequence[Vector], axis: Axis, size: float
) -> Floats:
    """Return how far lines are from an axis: the sine of the angle, and the distance in robot sizes.

    Args:
        weights: (tried, m) of the vectors that make up each line.
        turned: m vectors that make up the directions.
        moved: m that make up points.
        axis: the figure's.
    """
    target, (first, *others) = axis.direction, moved
    apart = (subtract(first, axis.point), *others)
    off = _lengths(weights @ np.array([cross(vector, target) for vector in turned]))
    if not axis.prismatic:
        off += _lengths(weights @ np.array([rejection(vector, target) for vector in apart])) / size
    return np.asarray(np.round(off, 9), dtype=np.float64)


def _lengths(vectors: Floats) -> Floats:
    return np.asarray(np.sqrt(np.einsum("kc,kc->k", vectors, vectors)), dtype=np.float64)


def _senses(directions: Sequence[Vector], shown: Sequence[Axis], exercise: Exercise) -> tuple[int, ...]:
    drawn = [(1 if shows_signs(exercise) else shown_sense(axis.direction), axis.direction) for axis in shown]
    along = [sense * dot(d, axis) for d, (sense, axis) in zip(directions, drawn, strict=False)]
    return tuple(-1 if round(value, 9) < 0 else 1 for value in along) + (1,) * (len(directions) - len(along))


def _rows(transform: Transform) -> Matrix4:
    return tuple(tuple(0.0 if entry == 0.0 else float(entry) for entry in row) for row in transform)
