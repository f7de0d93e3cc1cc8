"""What is recorded of an arm with a wrist: computations that its closed form needs for one target or many.

What is zero or one of the arm's constants leaves no operation behind (see `kinematics.evaluation.tape`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinematics.evaluation.blocks import UFUNCS
from kinematics.evaluation.tape import Recorder, Tape
from kinematics.inverse.arm import Array
from kinematics.inverse.methods.wrist import WristArm
from kinematics.se3 import Scalar

ROUNDED_OFF = 1e-15  # Entries of the arm's constant rotations this near to 0, 1 or -1 are these.


def seen_tape(wrist: WristArm) -> Tape:
    """Record what the normal form sees of a target: columns 1 and 3 of its rotation, and the wrist's centre.

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
    """Record what the normal form sees from a frame whose x and y joint 1 turns into the plane of the links.

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


def _sum_of(left: Sequence[Scalar], right: Sequence[Scalar]) -> Scalar:
    total: Scalar = 0.0
    for x, y in zip(left, right, strict=True):
        total = y * x + total
    return total


def _tidy(entry: float) -> float:
    near = round(entry)
    return float(near) if abs(entry - near) <= ROUNDED_OFF else entry
