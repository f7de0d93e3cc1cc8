"""The matrices of a chain as a lecturer writes them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TypeAlias

from kinematics.expressions import ONE, ZERO, Expression
from kinematics.symbolic.chain import Chain, Run, Vector, swung, turned, twisted
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.symbolic.nested import NOTHING, UNITY, Arena, Nested
from kinematics.table import SymbolicTable

Matrix: TypeAlias = tuple[tuple[Expression, ...], ...]
Pose: TypeAlias = tuple[Vector, Vector, Vector, Vector]
"""The columns of the upper three rows of a 4×4 matrix: x, y, z and the origin."""

_AXES: Pose = (
    (UNITY, NOTHING, NOTHING),
    (NOTHING, UNITY, NOTHING),
    (NOTHING, NOTHING, UNITY),
    (NOTHING, NOTHING, NOTHING),
)


@dataclass(frozen=True, kw_only=True, slots=True)
class ClosedForm:
    """The transforms of a table in closed form, each a 4×4 matrix of expressions.

    Attributes:
        links: pose of frame i in frame i-1, one for each row.
        frames: pose of frame i in the world (frame 0 if there is no base), one for each row.
        transform: pose of the end frame, base and tool included.
    """

    links: tuple[Matrix, ...]
    frames: tuple[Matrix, ...]
    transform: Matrix


def closed_form(
    table: SymbolicTable,
    *,
    base: Sequence[Sequence[Expression]] | None = None,
    tool: Sequence[Sequence[Expression]] | None = None,
) -> ClosedForm:
    """Every matrix of a table: A_i, ⁰T_i and base · ⁰T_N · tool.

    Angles of parallel and antiparallel joints are added (c23), multiples of π/12 are exact, and entries are
    nested from the last joint to the first: c1(a2c2 + a3c23) - d3s1.

    Args:
        table: the DH table.
        base: 4×4 pose of frame 0 in the world, last row 0 0 0 1; the identity if left out.
        tool: 4×4 pose of the tool in frame N, likewise.

    Source: J. J. Craig, Introduction to Robotics, 3rd ed., section 3.7, for the form of the entries.
    """
    writer = MatrixWriter(base)
    rows = motions_of(table)
    transform = writer.matrix(chain.from_iterable(rows), tool)
    links = tuple(MatrixWriter().matrix(row) for row in rows)
    frames = [writer.matrix(chain.from_iterable(rows[: i + 1])) for i in range(len(rows) - 1)]
    frames.append(transform if tool is None else writer.matrix(chain.from_iterable(rows)))
    return ClosedForm(links=links, frames=tuple(frames), transform=transform)


class MatrixWriter:
    """Writes products of motions as matrices; what occurs in several of them is shared."""

    def __init__(self, base: Sequence[Sequence[Expression]] | None = None) -> None:
        self.arena = Arena()
        self.base = None if base is None else self.read(base)

    def read(self, matrix: Sequence[Sequence[Expression]]) -> Pose:
        """A 4×4 matrix of expressions, by columns."""
        x, y, z, p = ([self.arena.read(matrix[i][j]) for i in range(3)] for j in range(4))
        return (x[0], x[1], x[2]), (y[0], y[1], y[2]), (z[0], z[1], z[2]), (p[0], p[1], p[2])

    def runs(self, motions: Iterable[Motion]) -> tuple[Run, ...]:
        """The motions with parallel axes merged."""
        merged = Chain(self.arena)
        merged.extend(motions)
        return merged.finished()

    def matrix(self, motions: Iterable[Motion], tool: Sequence[Sequence[Expression]] | None = None) -> Matrix:
        """Base · motions · tool."""
        runs = self.runs(motions)
        columns = _AXES if tool is None else self.read(tool)
        *axes, origin = columns
        pose = [self.in_world(self.rotated(runs, axis)) for axis in axes]
        pose.append(self.in_world(self.carried(runs, origin), self.base and self.base[3]))
        return self.written(pose)

    def rotated(self, runs: Sequence[Run], vector: Vector) -> Vector:
        """A direction, given where the runs end, in the frame where they begin."""
        for run in reversed(runs):
            vector = turned(self.arena, twisted(self.arena, vector, run.twist), run.angle)
        return vector

    def carried(self, runs: Sequence[Run], point: Vector) -> Vector:
        """A point, given where the runs end, in the frame where they begin."""
        for run in reversed(runs):
            point = swung(self.arena, run, twisted(self.arena, point, run.twist))
        return point

    def in_world(self, vector: Vector, origin: Vector | None = None) -> Vector:
        """A direction, or a point if an origin is given, from frame 0 into the world."""
        if self.base is None:
            return vector
        return self.combined(self.base, vector, origin)

    def combined(self, axes: Sequence[Vector], vector: Vector, origin: Vector | None = None) -> Vector:
        """Σ_k vector_k · axes_k + origin."""
        sums: list[Nested] = []
        for i in range(3):
            products = [self.arena.product(axes[k][i], vector[k]) for k in range(3)]
            sums.append(self.arena.sum(*products, *((origin[i],) if origin else ())))
        return sums[0], sums[1], sums[2]

    def projected(self, axes: Sequence[Vector], vector: Vector) -> Vector:
        """The components of a vector along three axes."""
        columns = tuple((axes[0][i], axes[1][i], axes[2][i]) for i in range(3))
        return self.combined(columns, vector)

    def written(self, columns: Sequence[Vector]) -> Matrix:
        """The columns of a pose as a 4×4 matrix of expressions."""
        arena = self.arena
        rows = [tuple(arena.expression(arena.gathered(column[i])) for column in columns) for i in range(3)]
        return (*rows, (ZERO, ZERO, ZERO, ONE))
