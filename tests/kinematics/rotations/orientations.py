"""Orientations made by means that the package does not use, and answers about them, right and wrong.

A rotation is a turn about a vector by Rodrigues' formula; a sequence about current axes turns about the axes
that the turns before have moved, one about fixed axes about e_x, e_y, e_z. Nothing is multiplied in the order
that the package writes down.
"""

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.rotations.matrices import Matrix3, matrix3
from kinematics.rotations.orientation_answers import (
    judge_axis_angle,
    judge_family,
    judge_matrix,
    judge_quaternion,
    judge_triples,
)
from kinematics.rotations.orientation_verdicts import ComponentOrder, OrientationVerdict
from kinematics.rotations.sequences import SEQUENCES, Combination, EulerSequence, GimbalFamily, Turning

Floats = NDArray[np.float64]
TOLERANCE = 0.005
CLEAR = 0.02
"""[rad] A wrong answer is at least so far from the right orientation, a right one within a tenth of that."""


def turn(axis: Floats, angle: float) -> Floats:
    """Rodrigues: v ↦ v cos φ + k × v sin φ + k (k·v)(1 − cos φ), column by column."""
    k = axis / np.linalg.norm(axis)
    columns = [
        v * math.cos(angle) + np.cross(k, v) * math.sin(angle) + k * (k @ v) * (1 - math.cos(angle))
        for v in np.eye(3)
    ]
    return np.array(columns).T


def made_by(sequence: EulerSequence, angles: tuple[float, ...]) -> Floats:
    """The rotation of three turns, one after the other."""
    body = np.eye(3)
    for name, angle in zip(sequence.axes, angles, strict=True):
        axis = np.eye(3)["XYZ".index(name)]
        body = turn(body @ axis if sequence.turning is Turning.CURRENT else axis, angle) @ body
    return body


def apart(first: Floats, second: Floats) -> float:
    """The angle between two orientations, from the trace."""
    return float(np.linalg.norm(first - second) / math.sqrt(2))


@dataclass(frozen=True)
class Case:
    """An answer, whether it is right, and how it is judged."""

    name: str
    right: bool
    judge: Callable[[], OrientationVerdict]


def cases(rng: random.Random) -> Iterator[Case]:
    """One orientation, written rightly in every notation, and each of them spoilt."""
    axis = np.array([rng.gauss(0, 1) for _ in range(3)])
    special = rng.random()
    angle = math.pi if special < 0.1 else rng.uniform(-9, 9)
    rotation = turn(axis, angle)
    sequence = rng.choice(SEQUENCES)
    if special > 0.85:  # gimbal lock
        middle = rng.choice([0.0, math.pi]) if sequence.proper else rng.choice([0.5, -0.5]) * math.pi
        rotation = made_by(sequence, (rng.uniform(-4, 4), middle, rng.uniform(-4, 4)))
        axis, angle = axis_of(rotation)
    expected = matrix3(rotation.tolist())
    tilt = turn(np.array([rng.gauss(0, 1) for _ in range(3)]), rng.uniform(CLEAR, math.pi))
    for right, body in ((True, rotation), (False, rotation @ tilt)):
        yield Case("matrix", right, _matrix(expected, body, rng))
        k, phi = (axis, angle) if right else axis_of(body)
        yield Case("axis", right, _axis(expected, k, phi, rng))
        yield Case("quaternion", right, _quaternion(expected, k, phi, rng))
        triple = three_angles(sequence, body)
        yield Case("triple", right, _triples(expected, sequence, [triple], rng))
    yield from _sets(expected, sequence, three_angles(sequence, rotation), rng)


def _sets(
    expected: Matrix3, sequence: EulerSequence, triple: tuple[float, ...], rng: random.Random
) -> Iterator[Case]:
    first, middle, last = triple
    level = math.sin(middle) if sequence.proper else math.cos(middle)
    if abs(level) > 0.05:
        other = (first + math.pi, -middle if sequence.proper else math.pi - middle, last - math.pi)
        yield Case("both", True, _triples(expected, sequence, [triple, other], rng, every=True))
        yield Case("twice", False, _triples(expected, sequence, [triple, triple], rng, every=True))
        yield Case("one of two", False, _triples(expected, sequence, [other], rng, every=True))
    elif abs(level) < 1e-9:
        plus = (middle > 0 or abs(middle) < 1) if sequence.proper else None
        for way in Combination:
            value = first + last if way is Combination.SUM else first - last
            family = GimbalFamily(
                middle=middle, combination=way, value=value + 2 * math.pi * rng.randint(-2, 2)
            )
            shifted = made_by(sequence, (first + 1, middle, last + (-1 if way is Combination.SUM else 1)))
            right = apart(shifted, np.array(expected)) < 1e-6
            assert plus is None or right == ((abs(middle) < 1) == (way is Combination.SUM))
            yield Case(f"family {way}", right, lambda family=family: judge_family(expected, sequence, family))


def _rounded(values: list[float], rng: random.Random) -> list[float]:
    return [round(value, rng.choice([4, 5, 9])) for value in values]


def _matrix(expected: Matrix3, body: Floats, rng: random.Random) -> Callable[[], OrientationVerdict]:
    given = matrix3([_rounded(row, rng) for row in body.tolist()])
    return lambda: judge_matrix(expected, given, TOLERANCE)


def _axis(
    expected: Matrix3, axis: Floats, angle: float, rng: random.Random
) -> Callable[[], OrientationVerdict]:
    sign, length = rng.choice([1, -1]), rng.uniform(0.5, 3)
    k = [sign * length * float(value) for value in axis]
    phi = round(sign * angle + 2 * math.pi * rng.randint(-2, 2), 4)
    return lambda: judge_axis_angle(expected, k, phi, TOLERANCE)


def _quaternion(
    expected: Matrix3, axis: Floats, angle: float, rng: random.Random
) -> Callable[[], OrientationVerdict]:
    sign, order = rng.choice([1, -1]), rng.choice(list(ComponentOrder))
    vector = (axis / np.linalg.norm(axis) * math.sin(angle / 2)).tolist()
    w = math.cos(angle / 2)
    parts = [w, *vector] if order is ComponentOrder.SCALAR_FIRST else [*vector, w]
    given = _rounded([sign * part for part in parts], rng)
    return lambda: judge_quaternion(expected, given, order, TOLERANCE)


def _triples(
    expected: Matrix3,
    sequence: EulerSequence,
    triples: list[tuple[float, ...]],
    rng: random.Random,
    every: bool = False,
) -> Callable[[], OrientationVerdict]:
    given = [[round(angle + 2 * math.pi * rng.randint(-1, 1), 4) for angle in triple] for triple in triples]
    return lambda: judge_triples(expected, sequence, given, every=every, tolerance=TOLERANCE)


def axis_of(rotation: Floats) -> tuple[Floats, float]:
    """Axis and angle from the eigenvector of 1; of no rotation any axis."""
    values, vectors = np.linalg.eig(rotation)
    axis = np.real(vectors[:, int(np.argmin(np.abs(values - 1)))])
    across = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    turned = rotation @ across
    return axis, math.atan2(float(np.cross(across, turned) @ axis), float(across @ turned))


def three_angles(sequence: EulerSequence, rotation: Floats) -> tuple[float, ...]:
    """Three angles of a rotation, by what the turns do to single vectors, one turn after the other."""
    order = sequence.axes if sequence.turning is Turning.CURRENT else sequence.axes[::-1]
    i, j, k = (np.eye(3)["XYZ".index(name)] for name in order)
    image = rotation @ k
    # Rot_i(a) Rot_j(b) carries k to `image`: a brings Rot_j(b) k there
    across = np.cross(j, i)
    if sequence.proper:
        target, b = image - i * (i @ image), math.acos(max(-1.0, min(1.0, float(i @ image))))
        start = math.sin(b) * -np.cross(i, j)
    else:
        b = math.asin(max(-1.0, min(1.0, float(i @ image)))) * float(np.sign(np.cross(j, k) @ i))
        target, start = image - i * (i @ image), math.cos(b) * k
    if np.linalg.norm(target) < 1e-9:
        a = 0.0
    else:
        a = math.atan2(float(np.cross(start, target) @ i), float(start @ target))
    if apart(turn(i, a) @ turn(j, b) @ np.outer(k, k), np.outer(image, k)) > 1e-6:
        b, a = (-b, a) if sequence.proper else (b, a)
    rest = (turn(i, a) @ turn(j, b)).T @ rotation
    side = across if sequence.proper else i
    side = side - k * (k @ side)
    moved = rest @ side
    c = math.atan2(float(np.cross(side, moved) @ k), float(side @ moved))
    found = (a, b, c) if sequence.turning is Turning.CURRENT else (c, b, a)
    assert apart(made_by(sequence, found), rotation) < 1e-6, (sequence, found)
    return found
