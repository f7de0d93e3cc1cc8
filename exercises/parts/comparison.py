"""Matrices of numbers against each other, cell by cell, and what a wrong one looks like."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from exercises.parts.context import Context
from exercises.parts.matrix_cells import CellMatrix, SymbolicMatrix
from kinematics.cells import Cell
from kinematics.equivalence import Tolerance
from kinematics.table import JointType

Matrices: TypeAlias = NDArray[np.float64]
Expected: TypeAlias = Callable[[Mapping[str, float], Sequence[float]], Matrices]
"""(4, 4) that is right for parameter values and joint values."""

LAST_ROW = np.array([0.0, 0.0, 0.0, 1.0])
ALL_NAMED = 1e-6
"""Share of the robot's size: far above rounding, far below any length that could be left out."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Compared:
    """An answered matrix beside the expected one.

    Attributes:
        actual: (k, 4, 4) the answer at the samples.
        samples: the parameter values and joint values of each sample.
        cells: (4, 4) which cells agree at every sample.
    """

    actual: Matrices
    samples: tuple[tuple[Mapping[str, float], tuple[float, ...]], ...]
    cells: NDArray[np.bool_]

    @property
    def right(self) -> bool:
        """Every cell agrees."""
        return bool(self.cells.all())


def compare(context: Context, answer: SymbolicMatrix, expected: Expected) -> Compared:
    """An answered matrix beside the expected one.

    They are compared at the exercise's values and, if the answer names all lengths, at others, too. Other
    values tell apart what the exercise's values confuse, such as two dimensions of equal length.
    """
    samples = tuple(_samples(context, answer))
    actual = np.array([answer.at(values, joints) for values, joints in samples])
    wanted = np.array([expected(values, joints) for values, joints in samples])
    return Compared(
        actual=actual, samples=samples, cells=agreeing(actual, wanted, context.size, context.policy.tolerance)
    )


def agreeing(actual: Matrices, wanted: Matrices, size: float, tolerance: Tolerance) -> NDArray[np.bool_]:
    """(4, 4) which cells of (k, 4, 4) matrices agree at every sample; lengths relative to the size."""
    limit = np.full((4, 4), tolerance.angle)
    limit[:3, 3] = tolerance.length * size
    limit[3] = 1e-6
    with np.errstate(invalid="ignore"):
        close = np.abs(actual - wanted) <= limit
    return np.asarray(close.all(axis=0), dtype=np.bool_)


def _samples(
    context: Context, answer: SymbolicMatrix
) -> Iterator[tuple[dict[str, float], tuple[float, ...]]]:
    names = answer.names() | context.own_names()
    nominal = context.values(names)
    joints = [tuple(q) for q in context.configurations(context.joint_types).tolist()]
    for q in joints:
        yield nominal, q
    if context.own_scales() and _scales(context, answer, nominal, joints[0]):
        for values in context.draws(names):
            for q in joints[:2]:
                yield values, q


def _scales(
    context: Context, answer: SymbolicMatrix, values: Mapping[str, float], joints: Sequence[float]
) -> bool:
    """Whether the answer names every length: twice the lengths double its last column and nothing else."""
    types = context.joint_types
    slid = [q * 2.0 if type_ is JointType.PRISMATIC else q for q, type_ in zip(joints, types, strict=True)]
    once, twice = answer.at(values, joints), answer.at(context.scaled(values, 2.0), slid)
    wanted = once.copy()
    wanted[:3, 3] *= 2.0
    with np.errstate(invalid="ignore"):
        return bool((np.abs(twice - wanted) <= ALL_NAMED * max(1.0, context.size)).all())


def inverse(poses: Matrices) -> Matrices:
    """(…, 4, 4) inverses of rigid motions."""
    rotation = np.swapaxes(poses[..., :3, :3], -1, -2)
    result = np.zeros_like(poses)
    result[..., :3, :3] = rotation
    result[..., :3, 3] = -np.einsum("...ij,...j->...i", rotation, poses[..., :3, 3])
    result[..., 3, 3] = 1.0
    return result


def transposed_rotation(poses: Matrices) -> Matrices:
    """(…, 4, 4) the same positions with transposed rotations."""
    result = poses.copy()
    result[..., :3, :3] = np.swapaxes(poses[..., :3, :3], -1, -2)
    return result


def transposed_cells(matrix: CellMatrix) -> list[list[Cell]] | None:
    """Return 4×4 cells with the rotation transposed.

    None where that is no mistake of its own: the rotation is symmetric, or nothing is shifted, so that the
    result is the inverse.
    """
    turned = [[matrix[c][r] if r < 3 and c < 3 else matrix[r][c] for c in range(4)] for r in range(4)]
    shifted = any(str(matrix[r][3]) not in ("0", "0.0", "-0.0") for r in range(3))
    return turned if shifted and turned != [list(row) for row in matrix] else None


def is_rigid(poses: Matrices, tolerance: Tolerance) -> bool:
    """Whether (…, 4, 4) matrices are rigid motions."""
    if not np.isfinite(poses).all():
        return False
    rotation = poses[..., :3, :3]
    gram = np.swapaxes(rotation, -1, -2) @ rotation
    limit = 3 * max(tolerance.angle, 1e-9)
    return bool(
        (np.abs(gram - np.eye(3)) <= limit).all()
        and (np.linalg.det(rotation) > 0).all()
        and (np.abs(poses[..., 3, :] - LAST_ROW) <= 1e-6).all()
    )


def cell_names(cells: NDArray[np.bool_]) -> tuple[str, ...]:
    """The wrong cells as row,column counted from 1."""
    return tuple(f"{r + 1},{c + 1}" for r, c in np.argwhere(~cells).tolist())
