"""A tape run on arrays, block by block.

A register holds one number for each configuration of a block: structure of arrays, so that every operation is
one vector instruction after another. A block of 4096 keeps all registers in the second-level cache; whole
arrays would travel to memory and back at every operation. Registers share buffers once their content is no
longer needed.
"""

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from kinematics.angles import cos_sin_arrays
from kinematics.evaluation.tape import Operation, Operator, Tape
from kinematics.se3 import Floats
from kinematics.table import JointType

BLOCK = 4096
"""Configurations computed together: a value of all of them takes 32 KiB the size of a first-level cache."""


UFUNCS: dict[Operator, Any] = {
    Operator.ADD: np.add,
    Operator.SUBTRACT: np.subtract,
    Operator.MULTIPLY: np.multiply,
}


class _Layout(NamedTuple):
    """A tape whose registers are replaced by the buffers they share."""

    operations: list[Operation]
    results: list[int]
    outputs: list[int]
    n_buffers: int


def run_blocks(tape: Tape, joint_types: Sequence[JointType], joints: Floats, out: Floats) -> None:
    """Compute the outputs of a tape for many configurations.

    Args:
        tape: its inputs are cos q_i (of a revolute joint) or q_i (of a prismatic one) for every joint, then
            sin q_i.
        joint_types: types of joint 1 … n.
        joints: (m, n) configurations, finite.
        out: (m, k) receives the k outputs.
    """
    layout = _layout(tape)
    n, size = len(joint_types), min(BLOCK, len(joints))
    buffers, half = np.empty((layout.n_buffers, size)), np.empty((n, size))
    prismatic = [joint for joint, kind in enumerate(joint_types) if kind is JointType.PRISMATIC]
    operations: list[tuple[Any, Any, Any, Any]] = []
    with np.errstate(all="ignore"):
        for start in range(0, len(joints), size):
            block = joints[start : start + size].T
            if not operations or block.shape[1] < size:
                buffers, half = buffers[:, : block.shape[1]], half[:, : block.shape[1]]
                operations = _bind(layout, tape.constants, buffers)
            np.multiply(block, 0.5, out=half)
            cos_sin_arrays(half, buffers[:n], buffers[n : 2 * n])
            for joint in prismatic:
                buffers[joint] = block[joint]
            for ufunc, left, right, result in operations:
                ufunc(left, right, result)
            _hand_out(layout.outputs, tape.constants, buffers, out[start : start + size])


@lru_cache(maxsize=256)
def _layout(tape: Tape) -> _Layout:
    """Give every register a buffer, an old one where an operand is used for the last time."""
    last_use = {x: k for k, operation in enumerate(tape.operations) for x in operation[1:]}
    last_use.update(dict.fromkeys(tape.outputs, len(tape.operations)))
    buffer = {operand: operand for operand in range(-len(tape.constants), tape.n_inputs)}
    free: list[int] = []
    n_buffers = tape.n_inputs
    operations: list[Operation] = []
    results: list[int] = []
    for k, (operator, left, right) in enumerate(tape.operations):
        operations.append(Operation(operator, buffer[left], buffer[right]))
        free.extend(buffer[x] for x in {left, right} if x >= 0 and last_use[x] == k)
        if not free:
            free.append(n_buffers)
            n_buffers += 1
        results.append(free.pop())
        buffer[tape.n_inputs + k] = results[-1]
    return _Layout(operations, results, [buffer[x] for x in tape.outputs], n_buffers)


def _bind(layout: _Layout, constants: Sequence[float], buffers: Floats) -> list[tuple[Any, Any, Any, Any]]:
    """The operations as ufuncs with their arrays."""
    return [
        (
            UFUNCS[operator],
            buffers[left] if left >= 0 else constants[~left],
            buffers[right] if right >= 0 else constants[~right],
            buffers[result],
        )
        for (operator, left, right), result in zip(layout.operations, layout.results, strict=True)
    ]


def _hand_out(outputs: Sequence[int], constants: Sequence[float], buffers: Floats, out: Floats) -> None:
    """Copy the results from one array each to one row for each configuration; + 0 turns -0.0 into 0.0."""
    for column, x in enumerate(outputs):
        if x >= 0:
            np.add(buffers[x], 0.0, out=out[:, column])
        else:
            out[:, column] = constants[~x]
