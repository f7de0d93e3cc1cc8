"""Inverse transform and Jacobians in closed form."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from kinematics.expressions import ONE, ZERO, Expression
from kinematics.jacobian import JacobianFrame
from kinematics.links import Kind
from kinematics.symbolic.angles import NO_ANGLE
from kinematics.symbolic.chain import Run, Vector, swung, turned, twisted
from kinematics.symbolic.closed_form import Matrix, MatrixWriter, Pose
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.symbolic.nested import NOTHING, UNITY, Arena, Nested
from kinematics.symbolic.size import count_operations
from kinematics.table import SymbolicTable

_ORIGIN: Vector = (NOTHING, NOTHING, NOTHING)
_AXES = ((UNITY, NOTHING, NOTHING), (NOTHING, UNITY, NOTHING), (NOTHING, NOTHING, UNITY))


def inverse(
    table: SymbolicTable,
    *,
    base: Sequence[Sequence[Expression]] | None = None,
    tool: Sequence[Sequence[Expression]] | None = None,
) -> Matrix:
    """Pose of the world in the end frame: the inverse of base · ⁰T_N · tool, that is Rᵀ and -Rᵀp.

    The entries of Rᵀ are those of the transform; -Rᵀp is formed from the first joint to the last, so that no
    sine squared is left beside a cosine squared.
    """
    writer = MatrixWriter(base)
    motions = list(chain.from_iterable(motions_of(table)))
    R = writer.matrix(motions, tool)
    runs = writer.runs(motions)
    point = _ORIGIN if writer.base is None else writer.projected(writer.base[:3], writer.base[3])
    for run in runs:
        point = _passed(writer, run, point)
    if tool is not None:
        pose = writer.read(tool)
        point = writer.projected(pose[:3], writer.combined(_AXES, point, pose[3]))
    arena = writer.arena
    p = [arena.expression(arena.gathered(arena.negative(entry))) for entry in point]
    rows = [(R[0][i], R[1][i], R[2][i], p[i]) for i in range(3)]
    return (*rows, (ZERO, ZERO, ZERO, ONE))


def jacobian(
    table: SymbolicTable,
    frame: JacobianFrame = JacobianFrame.BASE,
    *,
    base: Sequence[Sequence[Expression]] | None = None,
    tool: Sequence[Sequence[Expression]] | None = None,
) -> Matrix:
    """The geometric Jacobian: column k holds the linear and angular velocity of the end frame for q̇_k = 1.

    Revolute joint: (z_k × (p - p_k), z_k); prismatic joint: (z_k, 0), z_k the direction of the joint's axis.

    Args:
        table: the DH table.
        frame: the axes in which the velocities are written.
        base: 4×4 pose of frame 0 in the world; the identity if left out.
        tool: 4×4 pose of the tool in frame N; the identity if left out.

    Returns:
        6 × n: three rows of linear, three rows of angular velocity.

    Source: seed 001 eq. 3.22 (base) and 3.23 (end).
    """
    writer = MatrixWriter(base)
    motions = list(chain.from_iterable(motions_of(table)))
    column = _base_column if frame is JacobianFrame.BASE else _end_column
    runs = writer.runs(motions)
    end = None if tool is None else writer.read(tool)
    columns = [
        column(_JointView(writer, motions, at, runs, end))
        for at, motion in enumerate(motions)
        if motion.joint
    ]
    arena = writer.arena
    return tuple(
        tuple(arena.expression(arena.gathered(vectors[part][i])) for vectors in columns)
        for part in range(2)
        for i in range(3)
    )


class _JointView:
    """A chain seen from one of its joints."""

    def __init__(
        self,
        writer: MatrixWriter,
        motions: Sequence[Motion],
        at: int,
        runs: Sequence[Run],
        end: Pose | None,
    ) -> None:
        self.writer = writer
        self.joint = motions[at]
        self.before, self.after = motions[:at], motions[at + 1 :]
        self.runs = runs
        self.end = end
        self.tip = _ORIGIN if end is None else end[3]
        z = UNITY if self.joint.sign > 0 else writer.arena.negative(UNITY)
        self.axis: Vector = (NOTHING, NOTHING, z)

    def lever(self, *, seen_from_end_of_run: bool) -> tuple[int, Vector]:
        """The joint's run, and ∂p/∂q in the frame where that run begins, or after its rotation.

        Only the arms that the joint turns count; each enters with the sum of its own angles, so a run of
        parallel joints gives a2·c2 + a3·c23 for the first and a3·c23 for the second.
        """
        arena, name = self.writer.arena, self.joint.joint
        at = next(i for i, run in enumerate(self.runs) if run.angle.weight_of(name))
        run = self.runs[at]
        tip = twisted(arena, self.writer.carried(self.runs[at + 1 :], self.tip), run.twist)
        arms = {angle: arm for angle, arm in run.arms.items() if angle.weight_of(name)}
        whole = Run(angle=run.angle, arms=arms)
        if seen_from_end_of_run:
            back = {angle.plus(run.angle, -1): arm for angle, arm in arms.items()}
            whole = Run(arms=back)
        x, y, _ = swung(arena, whole, tip)
        if run.angle.weight_of(name) > 0:
            return at, (arena.negative(y), x, NOTHING)
        return at, (y, arena.negative(x), NOTHING)


def _base_column(view: _JointView) -> tuple[Vector, Vector]:
    writer = view.writer
    axis = writer.in_world(writer.rotated(writer.runs(view.before), view.axis))
    if view.joint.kind is Kind.SHIFT_Z:
        return axis, _ORIGIN
    at, lever = view.lever(seen_from_end_of_run=False)
    return writer.in_world(writer.rotated(view.runs[:at], lever)), axis


def _end_column(view: _JointView) -> tuple[Vector, Vector]:
    writer, after = view.writer, view.writer.runs(view.after)
    axis = _direction_from_end(writer, after, view.axis, view.end)
    if view.joint.kind is Kind.SHIFT_Z:
        return axis, _ORIGIN
    at, lever = view.lever(seen_from_end_of_run=True)
    lever = twisted(writer.arena, lever, NO_ANGLE.plus(view.runs[at].twist, -1))
    lever = _direction_from_end(writer, view.runs[at + 1 :], lever, view.end)
    arm = _ORIGIN
    for run in after:
        arm = _passed(writer, run, arm)
    arm = writer.combined(_AXES, arm, view.tip)
    if view.end is not None:
        arm = writer.projected(view.end[:3], arm)
    crossed = _cross(writer.arena, axis, arm)
    return min(lever, crossed, key=lambda v: count_operations(map(writer.arena.expression, v))), axis


def _passed(writer: MatrixWriter, run: Run, point: Vector) -> Vector:
    """A vector from a fixed point to where the run begins, as one to where it ends, seen from there."""
    arms = {angle.plus(run.angle, -1): arm for angle, arm in run.arms.items()}
    point = turned(writer.arena, point, NO_ANGLE.plus(run.angle, -1))
    point = swung(writer.arena, Run(arms=arms, rise=run.rise), point)
    return twisted(writer.arena, point, NO_ANGLE.plus(run.twist, -1))


def _direction_from_end(
    writer: MatrixWriter, runs: Sequence[Run], vector: Vector, end: Pose | None
) -> Vector:
    """A direction, given where the runs begin, in the end frame."""
    for run in runs:
        vector = turned(writer.arena, vector, NO_ANGLE.plus(run.angle, -1))
        vector = twisted(writer.arena, vector, NO_ANGLE.plus(run.twist, -1))
    return vector if end is None else writer.projected(end[:3], vector)


def _cross(arena: Arena, a: Vector, b: Vector) -> Vector:
    def minor(i: int, j: int) -> Nested:
        return arena.sum(arena.product(a[i], b[j]), arena.negative(arena.product(a[j], b[i])))

    return minor(1, 2), minor(2, 0), minor(0, 1)
