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
from kinematics.inverse.wrist import Head, WristArm
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


@lru_cache(maxsize=64)
def wrist_error_tape(twists: tuple[float, float, float, float]) -> Tape:
    """‖Rot_z(θ_4) Rot_x(α_4) Rot_z(θ_5) Rot_x(α_5) Rot_z(θ_6) - N‖².

    Inputs are cosine and sine of θ_4, θ_5, θ_6 and the nine entries of N by rows.
    """
    recorder = Recorder(15)
    c4, s4, c5, s5, c6, s6, *N = recorder.inputs
    ca4, sa4, ca5, sa5 = twists
    rows: list[Triple] = [[c6, -s6, 0.0], [s6, c6, 0.0], [0.0, 0.0, 1.0]]
    rows = _turned_back(_twisted_back(rows, ca5, -sa5), c5, -s5)
    rows = _turned_back(_twisted_back(rows, ca4, -sa4), c4, -s4)
    off = [entry - wanted for entry, wanted in zip([e for row in rows for e in row], N, strict=True)]
    return recorder.tape([_sum_of(off, off)])


@lru_cache(maxsize=64)
def centre_error_tape(head: Head) -> Tape:
    """|p - p*|² of the wrist's centre, lengths in units of the size.

    Inputs are cosine and sine of θ_1, θ_2, θ_3 and the three coordinates of p*.
    """
    recorder = Recorder(9)
    c1, s1, c2, s2, c3, s3, *wanted = recorder.inputs
    p: Triple = [c3 * head.radius, s3 * head.radius, head.height]
    for c, s, offset, ca, sa, along in (
        (c2, s2, head.a2, head.ca2, head.sa2, 0.0),
        (c1, s1, head.a1, head.ca1, head.sa1, head.d2),
    ):
        x, y, z = p[0] + offset, p[1], p[2] + along
        y, z = y * ca - z * sa, y * sa + z * ca
        p = [c * x - s * y, s * x + c * y, z]
    off = [entry - target for entry, target in zip(p, wanted, strict=True)]
    return recorder.tape([_sum_of(off, off)])


def run_on_arrays(tape: Tape, inputs: Sequence[Array]) -> list[Array]:
    """The outputs of a tape for inputs that are arrays, which broadcast against each other."""
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
