"""Orientations in every notation, as cells, and what is said of matrices that may be no rotations."""

import math
import random
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from exercises.instance import Instance
from exercises.parts.rotations.orientation import OrientationPart
from exercises.parts.rotations.orientation_cells import OrientationCells, OrientationNotation
from exercises.parts.rotations.rotation_check import RotationClaim, RotationClaimCells
from kinematics.rotations.orientation_verdicts import ComponentOrder
from kinematics.rotations.sequences import SEQUENCES, Combination
from tests.exercises.meaning.answers_known import KnownAnswer, known, typed, typed_angle, typed_rows
from tests.exercises.meaning.posed_answers import asking, student
from tests.kinematics.rotations.orientations import axis_of, made_by, three_angles, turn

EXERCISES = ("kr125-orientation", "rx90-orientation", "puma560-gimbal-lock")
LOCKED = 0.05


def orientations(rng: random.Random) -> Iterator[KnownAnswer]:
    """The orientation of a student in the notations that are asked, and another one."""
    found = student(rng.choice(EXERCISES), rng.randrange(60))
    part = found.exercise.part("orientation")
    assert isinstance(part, OrientationPart)
    ask = tuple(rng.sample(list(OrientationNotation), rng.randint(1, 3)))
    if {OrientationNotation.ANGLES, OrientationNotation.EVERY_TRIPLE} <= set(ask):
        return
    part = replace(part, ask=ask, asked_sequence=rng.choice(SEQUENCES), sequence=rng.choice(SEQUENCES))
    instance = asking(found, part)
    rotation = made_by(part.sequence, found.drawn["orientation"])
    tilt = turn(np.array([rng.gauss(0, 1) for _ in range(3)]), rng.uniform(0.05, 3))
    right, other = (_written(part, body, instance, rng) for body in (rotation, rotation @ tilt))
    yield known(True, instance, "orientation", orientation=OrientationCells(**right))
    wrong = dict(right)
    notation = rng.choice(ask)
    for field in _fields(notation):
        wrong.pop(field, None)
        if field in other:
            wrong[field] = other[field]
    yield known(False, instance, "orientation", orientation=OrientationCells(**wrong))
    if right.get("angles") is not None and OrientationNotation.EVERY_TRIPLE in ask:
        one = dict(right, angles=(right["angles"][0],) * rng.randint(1, 2))
        yield known(False, instance, "orientation", orientation=OrientationCells(**one))


def _fields(notation: OrientationNotation) -> tuple[str, ...]:
    return {
        OrientationNotation.MATRIX: ("matrix",),
        OrientationNotation.QUATERNION: ("quaternion", "component_order"),
        OrientationNotation.AXIS_ANGLE: ("axis", "angle"),
    }.get(notation, ("angles", "middle", "combination", "value"))


def _written(
    part: OrientationPart, rotation: np.ndarray, instance: Instance, rng: random.Random
) -> dict[str, Any]:
    degrees = instance.exercise.angle_unit.value == "deg"
    axis, angle = axis_of(rotation)
    axis = axis / np.linalg.norm(axis)
    cells: dict[str, Any] = {}
    for notation in part.ask:
        if notation is OrientationNotation.MATRIX:
            cells["matrix"] = tuple(tuple(row) for row in typed_rows(rotation, rng))
        elif notation is OrientationNotation.QUATERNION:
            order, sign = rng.choice(list(ComponentOrder)), rng.choice([-1, 1])
            vector = [*(sign * math.sin(angle / 2) * axis)]
            w = sign * math.cos(angle / 2)
            four = [w, *vector] if order is ComponentOrder.SCALAR_FIRST else [*vector, w]
            cells.update(quaternion=tuple(typed(x, rng, 5) for x in four), component_order=order)
        elif notation is OrientationNotation.AXIS_ANGLE:
            sign, length = rng.choice([-1, 1]), rng.uniform(0.5, 3)
            cells["axis"] = tuple(typed(sign * length * x, rng, 5) for x in axis)
            cells["angle"] = typed_angle(sign * angle, degrees, rng)
        else:
            cells.update(_angles(part, rotation, notation is OrientationNotation.EVERY_TRIPLE, degrees, rng))
    return cells


def _angles(
    part: OrientationPart, rotation: np.ndarray, every: bool, degrees: bool, rng: random.Random
) -> dict[str, Any]:
    sequence = part.asked_sequence
    first, middle, last = three_angles(sequence, rotation)
    level = math.sin(middle) if sequence.proper else math.cos(middle)
    triples = [(first, middle, last)]
    if abs(level) > 1e-6:
        triples.append((first + math.pi, -middle if sequence.proper else math.pi - middle, last - math.pi))
    elif every:
        plus = made_by(sequence, (first + 1, middle, last - 1))
        way = Combination.SUM if np.allclose(plus, rotation, atol=1e-6) else Combination.DIFFERENCE
        value = first + last if way is Combination.SUM else first - last
        return {
            "middle": typed_angle(middle, degrees, rng),
            "combination": way,
            "value": typed_angle(value, degrees, rng),
        }
    rng.shuffle(triples)
    shown = triples if every else triples[:1]
    return {"angles": tuple(tuple(typed_angle(a, degrees, rng) for a in triple) for triple in shown)}


def rotation_claims(rng: random.Random) -> Iterator[KnownAnswer]:
    """Every claim about a matrix, decided from its columns."""
    instance = student("scara-rotation-check", rng.randrange(200))
    columns = np.array(instance.drawn["rotation_check"]).T
    products = columns @ columns.T
    true = {
        RotationClaim.UNIT_COLUMNS: bool(np.abs(np.diag(products) - 1).max() > 0.05),
        RotationClaim.PERPENDICULAR_COLUMNS: bool(np.abs(products - np.diag(np.diag(products))).max() > 0.05),
        RotationClaim.RIGHT_HANDED: bool(np.dot(np.cross(columns[0], columns[1]), columns[2]) < 0),
    }
    true[RotationClaim.ROTATION] = not any(true.values())
    for claim, right in true.items():
        yield known(right, instance, "rotation_check", rotation_check=RotationClaimCells(claim=claim))
