"""Recurrences along a serial chain, for any kind of number.

Each function here is run in two ways: on floats, where one configuration of a table is wanted now and then,
and on the symbols of `kinematics.evaluation.tape`, which record it once so that it can be replayed for
thousands. The formulas are therefore written once, and know neither arrays nor compilation.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain as concatenated
from typing import TypeAlias

from kinematics.dh import (
    ElementaryMotion,
    JointValue,
    MotionKind,
    Row,
    link_motions,
    pose_of_motions,
    set_joints,
    turn_x,
    turn_z,
)
from kinematics.se3 import Scalar, Scalars, Transform, cross, triple
from kinematics.table import JointType, NumericTable

Rows: TypeAlias = tuple[Row, Row, Row]  # The upper three rows of a 4×4 transform.

IDENTITY: Rows = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0))


@dataclass(frozen=True, kw_only=True, slots=True)
class LinkMotions:
    """A table taken apart into elementary motions, between a base and a tool.

    Attributes:
        links: the motions of each row, base side first.
        joint_types: types of joint 1 … n.
        base: pose of frame 0 in the world, None for the identity.
        tool: pose of the tool in frame N, None for the identity.
    """

    links: tuple[tuple[ElementaryMotion, ...], ...]
    joint_types: tuple[JointType, ...]
    base: Rows | None = None
    tool: Rows | None = None


def motions_of_table(
    table: NumericTable, base: Transform | None = None, tool: Transform | None = None
) -> LinkMotions:
    """Take a table apart.

    Raises:
        TableError: an entry is NaN or infinite, at ("rows", i, cell).
    """
    joints = {row: joint for joint, row in enumerate(table.joint_rows)}
    links = tuple(
        tuple(link_motions(row, table.convention, joints.get(i, 0), ("rows", i)))
        for i, row in enumerate(table.rows)
    )
    return LinkMotions(links=links, joint_types=table.joint_types, base=_rows(base), tool=_rows(tool))


def compose(left: Rows, right: Rows) -> Rows:
    """Return the product of two poses."""
    (a, b, c) = (_times(row, right) for row in left)
    return a, b, c


def end_pose(chain: LinkMotions, values: Sequence[JointValue]) -> Rows:
    """Return T = base · A_1 ⋯ A_N · tool.

    Source: seed 000 eq. 3.3.
    """
    pose = pose_of_motions(set_joints(concatenated.from_iterable(chain.links), values))
    if chain.base is not None:
        pose = compose(chain.base, pose)
    return pose if chain.tool is None else compose(pose, chain.tool)


def link_poses(chain: LinkMotions, values: Sequence[JointValue]) -> list[Rows]:
    """Return A_1 … A_N: pose of frame i in frame i-1."""
    return [pose_of_motions(set_joints(motions, values)) for motions in chain.links]


def frame_poses(chain: LinkMotions, values: Sequence[JointValue]) -> list[Rows]:
    """Return the poses base · A_1 ⋯ A_i of frames i = 1 … N in the world."""
    cursor = _Cursor(chain.base or IDENTITY)
    frames = []
    for motions in chain.links:
        for motion in set_joints(motions, values):
            cursor.move(motion)
        frames.append(cursor.pose())
    return frames


def joint_axes(chain: LinkMotions, values: Sequence[JointValue]) -> list[tuple[Scalars, Scalars]]:
    """Return the direction of every joint's positive motion and a point of its axis, in the world's axes."""
    return [(direction, point) for direction, point, _ in _axes_and_tip(chain, values)[0]]


def base_jacobian(chain: LinkMotions, values: Sequence[JointValue]) -> list[tuple[Scalar, ...]]:
    """Return the columns of J0: (z_i × (p − p_i), z_i) of a revolute joint, (z_i, 0) of a prismatic one.

    z_i is the direction of joint i, p_i a point of its axis, p the origin of the tool, in the world's axes.
    """
    axes, (x, y, z) = _axes_and_tip(chain, values)
    return [
        (*cross(direction, (x - px, y - py, z - pz)), *direction)
        if kind is MotionKind.TURN_Z
        else (*direction, 0.0, 0.0, 0.0)
        for direction, (px, py, pz), kind in axes
    ]


def end_jacobian(chain: LinkMotions, values: Sequence[JointValue]) -> list[tuple[Scalar, ...]]:
    """Return the columns of Jn: the same velocities as in J0, in the axes of the tool.

    With the tool's pose (x, y, z, p) in the frame of joint i, the joint moves p by z_i × p = (−p_y, p_x, 0),
    and both vectors are taken to the tool's axes by their products with x, y and z.

    Source: R. P. Paul, Robot Manipulators (1981), eq. 4.29 and 4.30.
    """
    x, y, z, p = (tuple(row[j] for row in chain.tool or IDENTITY) for j in range(4))
    columns: list[tuple[Scalar, ...]] = []
    for motion in reversed(set_joints(concatenated.from_iterable(chain.links), values)):
        kind, first, second, joint, sign = motion
        if joint is not None:
            angular = (x[2], y[2], z[2]) if sign > 0 else (-x[2], -y[2], -z[2])
            if kind is MotionKind.TURN_Z:
                px, py = (p[0], p[1]) if sign > 0 else (-p[0], -p[1])
                columns.append((*(px * v[1] - py * v[0] for v in (x, y, z)), *angular))
            else:
                columns.append((*angular, 0.0, 0.0, 0.0))
        if kind is MotionKind.TURN_Z:
            x, y, z, p = (turn_z(v, first, second) for v in (x, y, z, p))
        elif kind is MotionKind.TURN_X:
            x, y, z, p = (turn_x(v, first, second) for v in (x, y, z, p))
        elif kind is MotionKind.SHIFT_Z:
            p = (p[0], p[1], p[2] + first)
        else:
            p = (p[0] + first, p[1], p[2])
    return columns[::-1]


class _Cursor:
    """A frame that travels from the base to the tip.

    It holds the rows of its rotation, because a motion on the right acts on rows as its transpose acts on
    vectors. Turns about z wait in (c, s) until something does not commute with them: between parallel axes
    nothing does but the x-axis, which a shift along it asks for.
    """

    def __init__(self, pose: Rows) -> None:
        self._rows: list[Scalars] = [triple(row[:3]) for row in pose]
        self._p: list[Scalar] = [row[3] for row in pose]
        self._c: Scalar = 1.0
        self._s: Scalar = 0.0

    def move(self, motion: ElementaryMotion) -> None:
        """Move by an elementary motion in the frame's own axes."""
        kind, first, second, _, _ = motion
        if kind is MotionKind.TURN_Z:
            self._c, self._s, _ = turn_z((self._c, self._s, 0.0), first, second)
        elif kind is MotionKind.TURN_X:
            self._rows = [turn_x(row, first, -second) for row in self._turned()]
            self._c, self._s = 1.0, 0.0
        elif kind is MotionKind.SHIFT_Z:
            self._p = [p + row[2] * first for p, row in zip(self._p, self._rows, strict=True)]
        else:
            self._p = [p + row[0] * first for p, row in zip(self._p, self._turned(), strict=True)]

    def z(self) -> Scalars:
        """Return the direction of the z-axis."""
        r0, r1, r2 = self._rows
        return r0[2], r1[2], r2[2]

    def origin(self) -> Scalars:
        """Return the origin."""
        return triple(self._p)

    def pose(self) -> Rows:
        """Return the frame's pose."""
        r0, r1, r2 = ((*row, p) for row, p in zip(self._turned(), self._p, strict=True))
        return r0, r1, r2

    def _turned(self) -> list[Scalars]:
        return [turn_z(row, self._c, -self._s) for row in self._rows]


def _axes_and_tip(
    chain: LinkMotions, values: Sequence[JointValue]
) -> tuple[list[tuple[Scalars, Scalars, MotionKind]], Scalars]:
    """Direction, point and kind of every joint's axis, and the origin of the tool."""
    cursor = _Cursor(chain.base or IDENTITY)
    axes: list[tuple[Scalars, Scalars, MotionKind]] = []
    for motion in set_joints(concatenated.from_iterable(chain.links), values):
        if motion.joint is not None:
            x, y, z = cursor.z()
            direction = (x, y, z) if motion.sign > 0 else (-x, -y, -z)
            axes.append((direction, cursor.origin(), motion.kind))
        cursor.move(motion)
    x, y, z = (_times(row, chain.tool or IDENTITY)[3] for row in cursor.pose())
    return axes, (x, y, z)


def _times(row: Row, right: Rows) -> Row:
    a, b, c, p = row
    (x0, y0, z0, p0), (x1, y1, z1, p1), (x2, y2, z2, p2) = right
    return (
        a * x0 + b * x1 + c * x2,
        a * y0 + b * y1 + c * y2,
        a * z0 + b * z1 + c * z2,
        a * p0 + b * p1 + c * p2 + p,
    )


def _rows(transform: Transform | None) -> Rows | None:
    if transform is None:
        return None
    r0, r1, r2, _ = (tuple(row) for row in transform.tolist())
    return r0, r1, r2
