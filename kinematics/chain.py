"""The numeric serial chain: joint axes and home pose at q = 0, from any description.

    T(q) = exp([S_1] q_1) ⋯ exp([S_n] q_n) M

S_i is the screw of joint i at q = 0 and M the home pose, in the coordinates of the base. Tables of either
convention, screws, SCM chains and URDF files all reduce to this, so code that takes a `Chain` need not know
its source. A chain can carry frames that move with the links.

Source: R. W. Brockett (1984); R. M. Murray, Z. Li, S. S. Sastry (1994), section 3.2.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from math import cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinematics.dh import around_joint, frame_after
from kinematics.se3 import (
    IDENTITY,
    ORIGIN,
    Floats,
    Motion,
    Transform,
    Vector,
    compose,
    cross,
    cross_arrays,
    from_matrix,
    norm,
    plus,
    position,
    rejection,
    rotation_about,
    scale,
    subtract,
    to_matrix,
    translation,
    z_axis,
)
from kinematics.table import Convention, DHTable, JointType, NumericTable

NO_LENGTH = 1e-12
"""In any unit: an atom is a hundred times larger, and what a computation leaves of zero is smaller."""
_EYE = np.eye(4)
_REVERSED = np.diag([1.0, -1.0, -1.0, 1.0])


class Axis(NamedTuple):
    """A joint axis at q = 0, pointing the way the joint variable counts.

    Attributes:
        prismatic: whether the joint slides along the axis; then only the direction matters.
        direction: unit vector.
        point: some point of the axis [m].
    """

    prismatic: bool
    direction: Vector
    point: Vector

    def motion(self, q: float) -> Motion:
        """Return exp([S] q), the joint's motion at a value of its variable [rad or m]."""
        if self.prismatic:
            return translation(scale(self.direction, q))
        return rotation_about(self.point, self.direction, cos(q), sin(q))


@dataclass(frozen=True)
class Chain:
    """A serial chain at q = 0.

    Attributes:
        axes: the joint axes, base first.
        end: M, the home pose: that of the end frame at q = 0.
        extent: sum of all |a| and |d| of the source table [m]; for other descriptions the length of a walk
            along the axes or, if that is zero, the distances of axes and end from the origin.
        links: for each carried frame, the number of joints that move it, and its pose at q = 0.
    """

    axes: tuple[Axis, ...]
    end: Motion
    extent: float
    links: tuple[tuple[int, Motion], ...] = ()

    @property
    def n_joints(self) -> int:
        """Number of joint variables."""
        return len(self.axes)

    def poses(self, joints: ArrayLike) -> Transform:
        """Return T(q), (4, 4), or (m, 4, 4) of (m, n) joint variables [rad, or m of a prismatic joint]."""
        q = np.asarray(joints, dtype=np.float64)
        if not self.axes:
            return np.asarray(self._moved(q)[-1] @ to_matrix(self.end), dtype=np.float64)
        steps = joint_motions(self, np.atleast_2d(q).T)
        moved = reduce(np.matmul, steps if q.ndim == 2 else steps[:, 0])
        return np.asarray(moved @ to_matrix(self.end), dtype=np.float64)

    def frames(self, joints: ArrayLike) -> Transform:
        """Return the poses of the frames carried along, (links, 4, 4), or (m, links, 4, 4) of a batch."""
        moved = self._moved(joints)
        shape = (*moved[0].shape[:-2], 0, 4, 4)
        poses = [moved[before] @ to_matrix(home) for before, home in self.links]
        return np.stack(poses, axis=-3) if poses else np.empty(shape)

    def axes_at(self, joints: ArrayLike) -> tuple[Floats, Floats]:
        """Return the axes' directions and points, (n, 3) each, or (m, n, 3) of a batch."""
        moved = np.stack([*self._moved(joints)[:-1]], axis=-3) if self.axes else np.empty((0, 4, 4))
        directions, points = self._lines
        turned = (moved[..., :3, :3] @ directions[:, :, None])[..., 0]
        return turned, (moved[..., :3, :3] @ points[:, :, None])[..., 0] + moved[..., :3, 3]

    def jacobian(self, joints: ArrayLike) -> Floats:
        """Return the geometric Jacobian J0 of the end frame's origin, (6, n), or (m, 6, n) of a batch.

        Columns are (z × (p − p_i), z) of a revolute joint and (z, 0) of a prismatic one, in the base.

        Source: D. E. Whitney (1969); seed 001 eq. 3.22.
        """
        directions, points = self.axes_at(joints)
        tip = self.poses(joints)[..., None, :3, 3]
        slides = np.array([axis.prismatic for axis in self.axes], dtype=bool)[:, None]
        linear = np.where(slides, directions, cross_arrays(directions, tip - points))
        columns = np.concatenate((linear, np.where(slides, 0.0, directions)), axis=-1)
        return np.swapaxes(columns, -1, -2)

    @cached_property
    def _lines(self) -> tuple[Floats, Floats]:
        directions = np.array([axis.direction for axis in self.axes]).reshape(-1, 3)
        return directions, np.array([axis.point for axis in self.axes]).reshape(-1, 3)

    def _moved(self, joints: ArrayLike) -> list[Transform]:
        """Return the motions exp([S_1] q_1) ⋯ exp([S_i] q_i) for i = 0 … n."""
        q = np.asarray(joints, dtype=np.float64)
        steps = joint_motions(self, np.atleast_2d(q).T)
        moved = [np.broadcast_to(_EYE, (*q.shape[:-1], 4, 4))]
        for step in steps if q.ndim == 2 else steps[:, 0]:
            moved.append(moved[-1] @ step if len(moved) > 1 else step)
        return moved


def chain_of_table(
    table: NumericTable, base: Transform | None = None, tool: Transform | None = None
) -> Chain:
    """Return the chain of a table, with its frames 0 … N.

    Args:
        table: the DH table; its entries are finite.
        base: (4, 4) pose of frame 0; the identity if left out.
        tool: (4, 4) pose of the end frame in frame N; the identity if left out.
    """
    here = IDENTITY if base is None else from_matrix(base)
    standard = table.convention is Convention.STANDARD
    axes: list[Axis] = []
    links = [(0, here)]
    extent = 0.0
    for row in table.rows:
        after = frame_after(here, row, table.convention)
        if row.joint is not JointType.FIXED:
            g = here if standard else after
            direction = z_axis(g) if row.sign > 0 else scale(z_axis(g), -1.0)
            axes.append(Axis(row.joint is JointType.PRISMATIC, direction, position(g)))
        here = after
        links.append((len(axes), here))
        extent += abs(row.a) + abs(row.d)
    end = here if tool is None else compose(here, from_matrix(tool))
    return Chain(tuple(axes), end, extent, tuple(links))


def chain_of_axes(axes: Sequence[Axis], end: Motion) -> Chain:
    """Return the chain of joint axes and a home pose that come from no table."""
    spread = norm(position(end)) + sum(norm(axis.point) for axis in axes)
    chain = Chain(tuple(axes), end, spread)
    return replace(chain, extent=size_of(chain))


def joint_constants(
    table: NumericTable, base: Transform | None = None, tool: Transform | None = None
) -> list[Transform]:
    """Return the constants K_0 … K_n of T(q) = K_0 J_1(q_1) K_1 ⋯ J_n(q_n) K_n.

    J_i turns about z or slides along it. A variable that enters reversed is J(-q) = Rot_x(π) J(q) Rot_x(π).

    Args:
        base: (4, 4) pose of frame 0; the identity if left out.
        tool: (4, 4) pose of the end frame in frame N; the identity if left out.

    Raises:
        TableError: an entry of the table is NaN or infinite.
    """
    constants = []
    here = np.eye(4) if base is None else base
    for row in table.rows:
        before, behind = around_joint(row, table.convention)
        if row.joint is JointType.FIXED:
            here = here @ before
            continue
        flip = _REVERSED if row.sign < 0 else np.eye(4)
        constants.append(here @ before @ flip)
        here = flip @ behind
    return [*constants, here if tool is None else here @ tool]


def frames_at_zero(table: NumericTable) -> list[Motion]:
    """Return frames 0 … N in frame 0, at q = 0."""
    return [frame for _, frame in chain_of_table(table).links]


def table_at(table: NumericTable, joints: Sequence[float]) -> NumericTable:
    """Return the table whose frames at q = 0 are those of a table at one configuration."""
    rows = list(table.rows)
    for i, q in zip(table.joint_rows, joints, strict=True):
        row = rows[i]
        if not q:
            continue
        if row.joint is JointType.REVOLUTE:
            rows[i] = replace(row, theta=row.theta + row.sign * q)
        else:
            rows[i] = replace(row, d=row.d + row.sign * q)
    return DHTable(convention=table.convention, rows=tuple(rows))


def frames_at(table: NumericTable, joints: Sequence[float], base: Transform | None = None) -> list[Motion]:
    """Return frames 0 … N at one configuration; for a table used once, this costs a third of a plan.

    Args:
        table: the DH table; its entries are finite.
        joints: (n,) finite joint variables [rad, or m of a prismatic joint].
        base: (4, 4) pose of frame 0; the identity if left out.
    """
    return [frame for _, frame in chain_of_table(table_at(table, joints), base).links]


def size_of(chain: Chain) -> float:
    """Return the robot's size, independent of its frames, to which relative tolerances refer.

    Walk from the origin of the base to the nearest point of the first revolute axis, from there to
    the nearest point of the next one and so on, and finally to the origin of the end frame. Walk back in the
    same way. Add up the steps, without the first one of the forward walk, and take the shorter walk. The
    steps do not change with q, and neither a distant world frame nor the huge offsets of nearly parallel
    axes increase them. If all are zero, the size is the chain's extent.

    Returns:
        A length, in the table's unit; 0 if all its lengths are zero, or what a computation leaves of zero.
    """
    turning = [axis for axis in chain.axes if not axis.prismatic]
    extent = chain.extent if chain.extent > NO_LENGTH else 0.0
    if not turning:
        return extent
    end = position(chain.end)
    start, _ = walk(ORIGIN, turning[:1])
    there, forward = walk(start, turning[1:])
    _, backward = walk(end, turning[::-1])
    ways = [forward + norm(subtract(end, there)), backward]
    smallest = max(1e-12 * extent, NO_LENGTH)
    return min((way for way in ways if way > smallest), default=extent)


def walk(here: Vector, axes: Sequence[Axis]) -> tuple[Vector, float]:
    """Walk from a point to the nearest point of each axis in turn; return the last point and the length."""
    total = 0.0
    for axis in axes:
        step = rejection(subtract(axis.point, here), axis.direction)
        total += norm(step)
        here = plus(here, step)
    return here, total


def screw_bases(chain: Chain) -> Floats:
    """Return the matrices from which the joint motions are composed.

    exp([S_i] q) = 1 + sin q · A_i + (1 - cos q) · B_i for a revolute joint, 1 + q · A_i for a prismatic one.

    Returns:
        (n, 2, 16) the A_i and B_i, each flattened by rows; B_i is zero for a prismatic joint.
    """
    flat: list[float] = []
    for axis in chain.axes:
        x, y, z = axis.direction
        if axis.prismatic:
            flat += (0, 0, 0, x, 0, 0, 0, y, 0, 0, 0, z, 0, 0, 0, 0)
            flat += (0,) * 16
            continue
        velocity = cross(axis.point, axis.direction)
        pull = cross(axis.direction, velocity)
        flat += (0, -z, y, velocity[0], z, 0, -x, velocity[1], -y, x, 0, velocity[2], 0, 0, 0, 0)
        flat += (
            x * x - 1.0, x * y, x * z, pull[0],
            x * y, y * y - 1.0, y * z, pull[1],
            x * z, y * z, z * z - 1.0, pull[2],
            0, 0, 0, 0,
        )  # fmt: skip
    return np.array(flat, dtype=np.float64).reshape(len(chain.axes), 2, 16)


def joint_motions(chain: Chain, joints: Floats) -> Transform:
    """Return exp([S_i] q_i), (n, m, 4, 4), of (n, m) joint variables, one configuration a column."""
    n, samples = joints.shape
    weights = np.empty((n, samples, 2))
    np.sin(joints, out=weights[:, :, 0])
    np.subtract(1.0, np.cos(joints), out=weights[:, :, 1])
    for i, axis in enumerate(chain.axes):
        if axis.prismatic:
            weights[i, :, 0] = joints[i]
    motions = (weights @ screw_bases(chain)).reshape(n, samples, 4, 4)
    motions += _EYE
    return motions
