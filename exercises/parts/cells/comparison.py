"""Matrices of numbers against each other, cell by cell, and what a wrong one looks like."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from exercises.parts.cells.matrix_cells import CellMatrix
from exercises.parts.cells.mixed_lengths import other_lengths
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.context import Context
from exercises.parts.report import Fact, fact
from exercises.parts.samples import Samples
from kinematics.cells import Cell
from kinematics.equivalence import Tolerance
from kinematics.se3 import Floats

Expected: TypeAlias = Callable[[Samples], Floats]  # (k, 4, 4) that are right at samples.

LAST_ROW = np.array([0.0, 0.0, 0.0, 1.0])
LAST_ROW_ERROR = 1e-6
"""Rounding, and nothing more: these four numbers are the same for every robot."""
ALL_NAMED = 1e-6
"""Share of the robot's size: far above rounding, far below any length that could be left out."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Compared:
    """An answered matrix beside the expected one.

    Attributes:
        actual: (k, 4, 4) the answer at the samples.
        samples: where it was compared.
        cells: (4, 4) which cells agree at every sample.
    """

    actual: Floats
    samples: Samples
    cells: NDArray[np.bool_]

    @property
    def right(self) -> bool:
        """Every cell agrees."""
        return bool(self.cells.all())

    @property
    def has_values(self) -> bool:
        """Every cell has a value at every sample: √(L2 − L1) has none where L1 is the longer one."""
        return bool(np.isfinite(self.actual).all())


@np.errstate(all="ignore")
def compare(context: Context, answer: SymbolicMatrix, expected: Expected) -> Compared:
    """Return an answered matrix beside the expected one.

    They are compared at the exercise's values and, if the answer names all lengths, or some and none that
    stands in numbers, at others, too. Other values tell apart what the exercise's values confuse, such as two
    dimensions of equal length.
    """
    samples = context.samples(answer.names() | context.own_names())
    actual = answer.at_points(samples)
    if len(samples.points) > 1:
        if is_doubled(actual[0], actual[-1], context.size):
            samples, actual = samples.but_last, actual[:-1]
        else:
            samples, actual = samples.first, actual[: samples.counts[0]]
    wanted = expected(samples)
    cells = agreeing(actual, wanted, context.size, context.policy.tolerance)
    if answer.rounded:
        cells &= (np.abs(actual - wanted) <= answer.as_typed(samples, context.size)).all(axis=0)
    if len(samples.points) == 1 and context.own_scales and cells.all():
        values, joints = samples.points[0]
        other = other_lengths(context, (answer,), values)
        if other is not None:
            there = Samples(((other[0], joints),))
            tolerance = replace(context.policy.tolerance, length=other[1])
            cells = agreeing(answer.at_points(there), expected(there), context.size, tolerance)
    return Compared(actual=actual, samples=samples, cells=cells)


def agreeing(actual: Floats, wanted: Floats, size: float, tolerance: Tolerance) -> NDArray[np.bool_]:
    """Return which cells of (k, 4, 4) matrices agree in every sample, (4, 4); lengths relative to size."""
    limit = np.full((4, 4), tolerance.angle)
    limit[:3, 3] = tolerance.length * size
    limit[3] = LAST_ROW_ERROR
    with np.errstate(invalid="ignore"):
        close = np.abs(actual - wanted) <= limit
    return np.asarray(close.all(axis=0), dtype=np.bool_)


def likeness(context: Context, actual: Floats) -> Callable[[Floats], bool]:
    """Return a function that tells whether an answer, (k, 4, 4), agrees with a matrix in every cell."""
    return lambda other: bool(agreeing(actual, other, context.size, context.policy.tolerance).all())


def halves_right(cells: NDArray[np.bool_], wanted: Floats, size: float, tolerance: Tolerance) -> float:
    """Return what a ⁰T_N earns by its cells: half for the rotation and half for the position.

    A half that the identity has right, too, earns nothing without the other: the position of a wrist, the
    rotation of a slide. Without a last row 0 0 0 1 nothing is earned.

    Args:
        cells: (4, 4) which are right.
        wanted: (k, 4, 4) what is right.
        size: typical length of the robot.
        tolerance: within which cells agree.
    """
    rotation, position = bool(cells[:3, :3].all()), bool(cells[:3, 3].all())
    if not cells[3].all():
        return 0.0
    if rotation and position:
        return 1.0
    for_nothing = agreeing(np.broadcast_to(np.eye(4), wanted.shape), wanted, size, tolerance)
    rotation = rotation and not for_nothing[:3, :3].all()
    position = position and not for_nothing[:3, 3].all()
    return 0.5 * (rotation + position)


def is_doubled(once: Floats, twice: Floats, size: float) -> bool:
    """Return whether a matrix names every length.

    Then twice the lengths double its last column and nothing else.
    """
    wanted = once.copy()
    wanted[..., :3, 3] *= 2.0
    with np.errstate(invalid="ignore"):
        return bool((np.abs(twice - wanted) <= ALL_NAMED * max(1.0, size)).all())


def transposed_rotation(poses: Floats) -> Floats:
    """Return the same positions with transposed rotations, (…, 4, 4)."""
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


def is_rigid(poses: Floats, tolerance: Tolerance) -> bool:
    """Return whether (…, 4, 4) matrices are rigid motions."""
    if not np.isfinite(poses).all():
        return False
    rotation = poses[..., :3, :3]
    gram = np.swapaxes(rotation, -1, -2) @ rotation
    limit = 3 * max(tolerance.angle, 1e-9)
    return bool(
        (np.abs(gram - np.eye(3)) <= limit).all()
        and (np.linalg.det(rotation) > 0).all()
        and has_last_row(poses)
    )


def has_last_row(poses: Floats) -> bool:
    """Return whether the last row of (…, 4, 4) matrices is 0 0 0 1."""
    return bool((np.abs(poses[..., 3, :] - LAST_ROW) <= LAST_ROW_ERROR).all())


def cell_facts(cells: NDArray[np.bool_]) -> list[Fact]:
    """Return what was found of each cell of a 4×4."""
    return [fact(bool(cells[r, c]), r, c) for r in range(4) for c in range(4)]


def cell_names(cells: NDArray[np.bool_]) -> tuple[str, ...]:
    """Return the wrong cells as row,column counted from 1."""
    return tuple(f"{r + 1},{c + 1}" for r, c in np.argwhere(~cells).tolist())
