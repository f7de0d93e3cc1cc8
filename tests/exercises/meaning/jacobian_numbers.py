"""Jacobians in numbers and joint forces, by differences of poses: of the key, and of tables of one's own."""

import random
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from exercises.parts.joint_draws import key_numbers
from exercises.parts.motion.jacobian_cells import JacobianAsk, JacobianCells
from exercises.parts.motion.jacobians import JacobianPart
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.jacobian import JacobianFrame
from kinematics.rotations.sequences import SEQUENCES, EulerSequence
from tests.exercises.meaning.answers_known import KnownAnswer, known, typed, typed_rows
from tests.exercises.meaning.own_tables import PlainTable, own_table, plain
from tests.exercises.meaning.posed_answers import asking, in_units, student
from tests.kinematics.rotations.orientations import made_by, three_angles

EXERCISES = ("scara-jacobian", "stanford-jacobian", "scorbot-own-jacobian")
STEP = 1e-5
LOCKED = 0.3
"""Sine or cosine of the middle angle up to which angles have rates too large to be compared."""


def jacobians(rng: random.Random) -> Iterator[KnownAnswer]:
    """The Jacobian, geometric or of angles, and the torques and forces for a wrench."""
    found = student(rng.choice(EXERCISES), rng.randrange(30))
    part = found.exercise.part("jacobian")
    assert isinstance(part, JacobianPart)
    beside = {}
    numbers = plain(key_numbers(found))
    if found.exercise.part("table") is not None:
        beside["table"], numbers = own_table(found, rng)
    joints = in_units(found, found.drawn["jacobian"])
    sequence = rng.choice([None, rng.choice(SEQUENCES)])
    frame = rng.choice(list(JacobianFrame))
    wrench = tuple(round(rng.uniform(-20, 20), 1) for _ in range(6))
    matrix = numbers.jacobian(joints)
    turn = np.kron(np.eye(2), numbers.pose(joints)[:3, :3].T)
    seen = matrix if frame is JacobianFrame.BASE else turn @ matrix
    forces = seen.T @ np.array(wrench)
    if sequence is not None:
        rates = rates_of_angles(numbers, joints, sequence)
        if rates is None:
            return
        frame, seen = JacobianFrame.BASE, np.vstack([matrix[:3], rates])
        forces = matrix.T @ np.array(wrench)
    asked = replace(
        part, ask=tuple(JacobianAsk), frame=frame, wrench=wrench, angles=sequence, tolerance=0.005
    )
    instance = asking(found, asked)
    yield known(True, instance, "jacobian", jacobian=_cells(seen, forces, rng), **beside)
    for wrong in _spoilt(seen, numbers.reach, rng):
        yield known(False, instance, "jacobian", jacobian=_cells(wrong, forces, rng), **beside)
    k = rng.randrange(len(forces))
    off = forces.copy()
    off[k] += rng.choice([-1, 1]) * (1 + np.abs(forces).max()) * rng.uniform(0.1, 1)
    yield known(False, instance, "jacobian", jacobian=_cells(seen, off, rng), **beside)


def rates_of_angles(numbers: PlainTable, joints: list[float], sequence: EulerSequence) -> np.ndarray | None:
    """(3, n): what the angles change by, by differences; None near gimbal lock."""
    middle = three_angles(sequence, numbers.pose(joints)[:3, :3])[1]
    if abs(np.sin(middle) if sequence.proper else np.cos(middle)) < LOCKED:
        return None
    columns = []
    for i in range(len(joints)):
        ahead, behind = (
            np.array(
                three_angles(sequence, numbers.pose([q + s * (k == i) for k, q in enumerate(joints)])[:3, :3])
            )
            for s in (STEP, -STEP)
        )
        columns.append((np.remainder(ahead - behind + np.pi, 2 * np.pi) - np.pi) / (2 * STEP))
    found = np.array(columns).T
    assert np.allclose(
        made_by(sequence, three_angles(sequence, numbers.pose(joints)[:3, :3])),
        numbers.pose(joints)[:3, :3],
    )
    return found


def _spoilt(matrix: np.ndarray, reach: float, rng: random.Random) -> Iterator[np.ndarray]:
    r, c = rng.randrange(6), rng.randrange(matrix.shape[1])
    wrong = matrix.copy()
    wrong[r, c] += rng.choice([-1, 1]) * rng.uniform(0.1, 1) * (reach if r < 3 else 1.0)
    yield wrong
    exchanged = np.vstack([matrix[3:], matrix[:3]])
    if np.abs(exchanged - matrix).max() > 0.1 * max(1.0, reach):
        yield exchanged
    backwards = matrix[:, ::-1]
    if np.abs(backwards - matrix)[3:].max() > 0.1:
        yield backwards


def _cells(matrix: np.ndarray, forces: np.ndarray, rng: random.Random) -> JacobianCells:
    order = rng.choice(list(ScrewOrder))
    if order is ScrewOrder.ANGULAR_FIRST:
        matrix = np.vstack([matrix[3:], matrix[:3]])
    rows = tuple(tuple(row) for row in typed_rows(matrix, rng, 5))
    return JacobianCells(order=order, jacobian=rows, forces=tuple(typed(value, rng) for value in forces))
