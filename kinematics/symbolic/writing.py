"""Vectors and poses, given where a chain ends, written in the frame where it begins."""

from collections.abc import Sequence
from typing import TypeAlias

from kinematics.expressions import ONE, ZERO, Expression
from kinematics.symbolic.nested import Arena
from kinematics.symbolic.runs import Run, Vector, swung, turned, twisted
from kinematics.symbolic.terms import NOTHING, UNITY, Nested

Matrix: TypeAlias = tuple[tuple[Expression, ...], ...]
Pose: TypeAlias = tuple[Vector, Vector, Vector, Vector]
"""The columns of the upper three rows of a 4×4 matrix: x, y, z and the origin."""

ORIGIN: Vector = (NOTHING, NOTHING, NOTHING)
AXES = ((UNITY, NOTHING, NOTHING), (NOTHING, UNITY, NOTHING), (NOTHING, NOTHING, UNITY))
HERE: Pose = (*AXES, ORIGIN)  # The identity.


class MatrixWriter:
    """Writes products of motions as matrices; what occurs in several of them is shared."""

    def __init__(self, base: Sequence[Sequence[Expression]] | None = None) -> None:
        self.arena = Arena()
        self.base = None if base is None else self.read(base)

    def branch(self) -> "MatrixWriter":
        """Return an independent copy: what is added to one is not seen by the other."""
        branch = MatrixWriter()
        branch.arena, branch.base = self.arena.branch(), self.base
        return branch

    def read(self, matrix: Sequence[Sequence[Expression]]) -> Pose:
        """Return a 4×4 matrix of expressions, by columns."""
        x, y, z, p = ([self.arena.read(matrix[i][j]) for i in range(3)] for j in range(4))
        return (x[0], x[1], x[2]), (y[0], y[1], y[2]), (z[0], z[1], z[2]), (p[0], p[1], p[2])

    def know(self, runs: Sequence[Run]) -> None:
        """Have factors written in the order in which they become known: base first."""
        for run in runs:
            for angle in (*run.arms, run.angle, run.twist):
                self.arena.circle(angle)

    def matrix(self, runs: Sequence[Run], end: Pose = HERE) -> Matrix:
        """Return base · runs · end."""
        *axes, origin = end
        pose = [self.in_world(self.rotated(runs, axis)) for axis in axes]
        pose.append(self.in_world(self.carried(runs, origin), self.base and self.base[3]))
        return self.written(pose)

    def rotated(self, runs: Sequence[Run], vector: Vector) -> Vector:
        """Return a direction, given where the runs end, in the frame where they begin."""
        for run in reversed(runs):
            vector = turned(self.arena, twisted(self.arena, vector, run.twist), run.angle)
        return vector

    def carried(self, runs: Sequence[Run], point: Vector) -> Vector:
        """Return a point, given where the runs end, in the frame where they begin."""
        for run in reversed(runs):
            point = swung(self.arena, run, twisted(self.arena, point, run.twist))
        return point

    def in_world(self, vector: Vector, origin: Vector | None = None) -> Vector:
        """Return a direction, or a point if an origin is given, from frame 0 into the world."""
        return vector if self.base is None else self.combined(self.base, vector, origin)

    def combined(self, axes: Sequence[Vector], vector: Vector, origin: Vector | None = None) -> Vector:
        """Return Σ_k vector_k · axes_k + origin."""
        sums: list[Nested] = []
        for i in range(3):
            products = [self.arena.product(axes[k][i], vector[k]) for k in range(3)]
            sums.append(self.arena.sum(*products, *((origin[i],) if origin else ())))
        return sums[0], sums[1], sums[2]

    def projected(self, axes: Sequence[Vector], vector: Vector) -> Vector:
        """Return the components of a vector along three axes."""
        return self.combined(tuple((axes[0][i], axes[1][i], axes[2][i]) for i in range(3)), vector)

    def written(self, columns: Sequence[Vector]) -> Matrix:
        """Return the columns of a pose as a 4×4 matrix of expressions."""
        arena = self.arena
        rows = [tuple(arena.expression(arena.gathered(column[i])) for column in columns) for i in range(3)]
        return (*rows, (ZERO, ZERO, ZERO, ONE))
