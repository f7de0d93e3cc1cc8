"""The matrices of a DH table as a lecturer writes them."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from kinematics.expressions import ONE, ZERO, Expression
from kinematics.jacobian import JacobianFrame
from kinematics.symbolic.differential import MovingJoint, column_in_base, column_in_end, passed
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.symbolic.runs import Run, Runs
from kinematics.symbolic.writing import AXES, HERE, ORIGIN, Matrix, MatrixWriter
from kinematics.table import SymbolicTable


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


class Workings:
    """What all matrices of one table are derived from.

    They share what stands in the transform, and are the same whichever of them is asked for first.

    Angles of parallel and antiparallel joints are added (c23), multiples of π/12 are exact, and entries are
    nested from the last joint to the first: c1(a2c2 + a3c23) - d3s1.

    Args:
        table: the DH table.
        base: 4×4 pose of frame 0 in the world, last row 0 0 0 1; the identity if left out.
        tool: 4×4 pose of the tool in frame N, likewise.

    Source: J. J. Craig, Introduction to Robotics, 3rd ed., section 3.7, for the form of the entries.
    """

    def __init__(
        self,
        table: SymbolicTable,
        *,
        base: Sequence[Sequence[Expression]] | None = None,
        tool: Sequence[Sequence[Expression]] | None = None,
    ) -> None:
        self._writer = MatrixWriter(base)
        self._rows = motions_of(table)
        self._joints: list[MovingJoint] = []
        self._upto: list[tuple[Run, ...]] = []
        merged, left = Runs(self._writer.arena), list(chain.from_iterable(self._rows))
        for row in self._rows:
            for motion in row:
                left = left[1:]
                if motion.joint:
                    self._joints.append(MovingJoint(motion, merged.finished(), left))
                merged.extend((motion,))
            self._upto.append(merged.finished())
        self._runs = merged.finished()
        self._writer.know(self._runs)
        self._end = None if tool is None else self._writer.read(tool)

    @cached_property
    def transform(self) -> Matrix:
        """The pose of the end: base · ⁰T_N · tool."""
        return self._writer.matrix(self._runs, self._end or HERE)

    @cached_property
    def frames(self) -> tuple[Matrix, ...]:
        """The poses base · ⁰T_i, one for each row."""
        writer = self._after_transform()
        frames = [writer.matrix(runs) for runs in self._upto[:-1]]
        if self._upto:
            frames.append(self.transform if self._end is None else writer.matrix(self._runs))
        return tuple(frames)

    @cached_property
    def links(self) -> tuple[Matrix, ...]:
        """The poses A_i, one for each row."""
        return tuple(map(_link, self._rows))

    @cached_property
    def inverse(self) -> Matrix:
        """The inverse of the transform, that is Rᵀ and -Rᵀp.

        The entries of Rᵀ are those of the transform; -Rᵀp is formed from the first joint to the last, so that
        no sine squared is left beside a cosine squared.
        """
        R, writer, end = self.transform, self._after_transform(), self._end
        point = ORIGIN if writer.base is None else writer.projected(writer.base[:3], writer.base[3])
        for run in self._runs:
            point = passed(writer.arena, run, point)
        if end is not None:
            point = writer.projected(end[:3], writer.combined(AXES, point, end[3]))
        arena = writer.arena
        p = [arena.expression(arena.gathered(arena.negative(entry))) for entry in point]
        return (*[(R[0][i], R[1][i], R[2][i], p[i]) for i in range(3)], (ZERO, ZERO, ZERO, ONE))

    def jacobian(self, frame: JacobianFrame) -> Matrix:
        """Return the geometric Jacobian in the axes of the base or of the end frame."""
        column = column_in_base if frame is JacobianFrame.BASE else column_in_end
        writer = self._after_transform()
        columns = [column(writer, joint, self._runs, self._end) for joint in self._joints]
        arena = writer.arena
        return tuple(
            tuple(arena.expression(arena.gathered(vectors[part][i])) for vectors in columns)
            for part in range(2)
            for i in range(3)
        )

    def _after_transform(self) -> MatrixWriter:
        """A writer that has the transform's factors and parentheses, for the other matrices."""
        _ = self.transform
        return self._writer.branch()


def closed_form(
    table: SymbolicTable,
    *,
    base: Sequence[Sequence[Expression]] | None = None,
    tool: Sequence[Sequence[Expression]] | None = None,
) -> ClosedForm:
    """Return every transform of a table: A_i, ⁰T_i and base · ⁰T_N · tool; see `Workings`."""
    workings = Workings(table, base=base, tool=tool)
    return ClosedForm(links=workings.links, frames=workings.frames, transform=workings.transform)


def inverse(
    table: SymbolicTable,
    *,
    base: Sequence[Sequence[Expression]] | None = None,
    tool: Sequence[Sequence[Expression]] | None = None,
) -> Matrix:
    """Return the pose of the world in the end frame: the inverse of base · ⁰T_N · tool; see `Workings`."""
    return Workings(table, base=base, tool=tool).inverse


def jacobian(
    table: SymbolicTable,
    frame: JacobianFrame = JacobianFrame.BASE,
    *,
    base: Sequence[Sequence[Expression]] | None = None,
    tool: Sequence[Sequence[Expression]] | None = None,
) -> Matrix:
    """Return the geometric Jacobian.

    Column k holds the linear and angular velocity of the end frame for q̇_k = 1.

    Revolute joint: (z_k × (p - p_k), z_k); prismatic joint: (z_k, 0), z_k the direction of the joint's axis.
    Base and tool are as in `Workings`.

    Returns:
        6 × n: three rows of linear, three rows of angular velocity.

    Source: seed 001 eq. 3.22 (base) and 3.23 (end).
    """
    return Workings(table, base=base, tool=tool).jacobian(frame)


def _link(row: Sequence[Motion]) -> Matrix:
    writer = MatrixWriter()
    runs = Runs.of(writer.arena, row).finished()
    writer.know(runs)
    return writer.matrix(runs)
