"""What is recorded of an arm with a wrist: computations that its closed form needs for one target or many.

What is zero or one of the arm's constants leaves no operation behind (see `kinematics.evaluation.tape`).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from kinematics.evaluation.blocks import UFUNCS
from kinematics.evaluation.tape import Recorder, Tape
from kinematics.inverse.arm import Array
from kinematics.inverse.methods.wrist import WristArm
from kinematics.se3 import Scalar

Triple = list[Scalar]

ROUNDED_OFF = 1e-15
"""Entries of the arm's constant rotations this near to 0, 1 or -1 are these."""


@lru_cache(maxsize=64)
def left_over_tape(wrist: WristArm) -> Tape:
    """N = L Rot_z(-θ_3) L_2 Rot_z(-θ_2) L_1 Rot_z(-θ_1) R, what rotation is left for the wrist.

    Inputs are cosine and sine of θ_1, θ_2, θ_3 and the nine entries of R by rows, outputs those of N.
    """
    recorder = Recorder(15)
    c1, s1, c2, s2, c3, s3, *R = recorder.inputs
    h = wrist.head
    rows = _turned_back([list(R[:3]), list(R[3:6]), list(R[6:])], c1, s1)
    rows = _turned_back(_twisted_back(rows, h.ca1, h.sa1), c2, s2)
    rows = _turned_back(_twisted_back(rows, h.ca2, h.sa2), c3, s3)
    link = [[_tidy(entry) for entry in row] for row in wrist.link]
    left = [[_sum_of(row, column) for column in zip(*rows, strict=True)] for row in link]
    return recorder.tape([entry for row in left for entry in row])


def seen_tape(wrist: WristArm) -> Tape:
    """What the normal form sees of a target: first and third column of its rotation, and the wrist's centre.

    Inputs are the upper twelve entries of the target by rows, outputs nine; lengths in units of the size.
    """
    recorder = Recorder(12)
    before, after = wrist.before, wrist.after
    target = [[*recorder.inputs[4 * i : 4 * i + 4]] for i in range(3)]
    hand = {k: [_tidy(float(x)) for x in after[:, k]] for k in (0, 2, 3)}
    outputs: list[Scalar] = []
    for k, column in hand.items():
        moved = [_sum_of(column, row) for row in target]
        for i in range(3):
            there = _sum_of([_tidy(float(x)) for x in before[i, :3]], moved)
            outputs.append(there if k < 3 else (there + _tidy(float(before[i, 3]))) * (1.0 / wrist.size))
    return recorder.tape(outputs)


def plane_tape(a1: float, ca1: float, sa1: float, aside: float) -> Tape:
    """What the normal form sees, from a frame of which joint 1 turns x and y into the plane of the links.

    Inputs are cosine and sine of θ_1 and the outputs of `seen_tape`. Outputs are x, y and z of the first and
    third column of the rotation and of the wrist's centre, seen from axis 2; z are across the plane.

    Args:
        a1: a_1.
        ca1: cos α_1.
        sa1: sin α_1.
        aside: how far across the plane the wrist's centre has to be.
    """
    recorder = Recorder(11)
    c, s, *seen = recorder.inputs
    outputs: list[Scalar] = []
    for x, y, z in (seen[:3], seen[3:6], seen[6:]):
        along, side = x * c + y * s, y * c - x * s
        outputs += [along, side * ca1 + z * sa1, z * ca1 - side * sa1]
    outputs[6] = outputs[6] - a1
    outputs[8] = outputs[8] - aside
    return recorder.tape(outputs)


def run_on_arrays(tape: Tape, inputs: Sequence[Array]) -> list[Array]:
    """Return the outputs of a tape for inputs that are arrays, which broadcast against each other."""
    registers: list[Array] = list(inputs)

    def operand(x: int) -> Array | float:
        return registers[x] if x >= 0 else tape.constants[~x]

    for operator, left, right in tape.operations:
        registers.append(UFUNCS[operator](operand(left), operand(right)))
    return [np.asarray(operand(x)) for x in tape.outputs]


def _turned_back(rows: list[Triple], c: Scalar, s: Scalar) -> list[Triple]:
    """Rot_z(-θ) times rows."""
    upper = [x * c + y * s for x, y in zip(rows[0], rows[1], strict=True)]
    lower = [y * c - x * s for x, y in zip(rows[0], rows[1], strict=True)]
    return [upper, lower, rows[2]]


def _twisted_back(rows: list[Triple], c: float, s: float) -> list[Triple]:
    """Rot_x(-α) times rows."""
    upper = [y * c + z * s for y, z in zip(rows[1], rows[2], strict=True)]
    lower = [z * c - y * s for y, z in zip(rows[1], rows[2], strict=True)]
    return [rows[0], upper, lower]


def _sum_of(left: Sequence[Scalar], right: Sequence[Scalar]) -> Scalar:
    total: Scalar = 0.0
    for x, y in zip(left, right, strict=True):
        total = y * x + total
    return total


def _tidy(entry: float) -> float:
    near = round(entry)
    return float(near) if abs(entry - near) <= ROUNDED_OFF else entry
