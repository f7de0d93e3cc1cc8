"""A table as joint axes in frame 0 at q = 0, which is all that the decision needs to know of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.angles import cos_sin
from kinematics.equivalence.rigid import (
    IDENTITY,
    ORIGIN,
    Motion,
    Vector,
    across,
    cross,
    norm,
    plus,
    position,
    scale,
    subtract,
    to_matrix,
    z_axis,
)
from kinematics.links import MOTIONS
from kinematics.table import Convention, JointType, NumericRow, NumericTable


@dataclass(frozen=True, slots=True)
class Axis:
    """A joint axis in frame 0 at q = 0, pointing the way the joint variable counts.

    Attributes:
        prismatic: the joint slides along the axis; only its direction has a meaning then.
        direction: unit vector.
        point: some point of the axis.
    """

    prismatic: bool
    direction: Vector
    point: Vector


@dataclass(frozen=True, slots=True)
class Chain:
    """F(q) = exp(S_1 q_1) ⋯ exp(S_n q_n) M, with the joint screws S_i at q = 0.

    Attributes:
        axes: the joint axes, base first.
        end: M, the pose of frame N at q = 0.
        extent: sum of all |a| and |d| of the table.
    """

    axes: tuple[Axis, ...]
    end: Motion
    extent: float


def chain_of(table: NumericTable) -> Chain:
    """The joint axes of a table and the pose of its last frame, all at q = 0."""
    standard = table.convention is Convention.STANDARD
    here = IDENTITY
    axes: list[Axis] = []
    extent = 0.0
    for row in table.rows:
        after = past(here, row, table.convention)
        if row.joint is not JointType.FIXED:
            g = here if standard else after
            direction = z_axis(g) if row.sign > 0 else scale(z_axis(g), -1.0)
            axes.append(Axis(row.joint is JointType.PRISMATIC, direction, position(g)))
        here = after
        extent += abs(row.a) + abs(row.d)
    return Chain(tuple(axes), here, extent)


def past(here: Motion, row: NumericRow, convention: Convention) -> Motion:
    """The frame after a row, at q = 0, given the frame before it.

    The row's elementary motions are applied to the columns of the frame in the convention's order: a turn
    mixes two columns, a shift moves the origin along one.
    """
    xx, yx, zx, xy, yy, zy, xz, yz, zz, px, py, pz = here
    for cell in MOTIONS[convention]:
        value = getattr(row, cell)
        if not value:
            continue
        if cell == "d":
            px, py, pz = px + value * zx, py + value * zy, pz + value * zz
        elif cell == "a":
            px, py, pz = px + value * xx, py + value * xy, pz + value * xz
        elif cell == "theta":
            c, s = cos_sin(value)
            xx, yx = c * xx + s * yx, c * yx - s * xx
            xy, yy = c * xy + s * yy, c * yy - s * xy
            xz, yz = c * xz + s * yz, c * yz - s * xz
        else:
            c, s = cos_sin(value)
            yx, zx = c * yx + s * zx, c * zx - s * yx
            yy, zy = c * yy + s * zy, c * zy - s * yy
            yz, zz = c * yz + s * zz, c * zz - s * yz
    return (xx, yx, zx, xy, yy, zy, xz, yz, zz, px, py, pz)


def frames_of(table: NumericTable) -> list[Motion]:
    """Frames 0 … N in frame 0, at q = 0."""
    frames = [IDENTITY]
    for row in table.rows:
        frames.append(past(frames[-1], row, table.convention))
    return frames


def size_of(chain: Chain) -> float:
    """A length that is typical of the robot, whatever its frames: what relative tolerances refer to.

    Starting with the origin of frame 0, go to the nearest point of the first revolute axis, from there to the
    nearest point of the next one and so on, and at last to the origin of frame N; the same from the other
    end; add up the steps but for the first one of the forward way, and take the shorter way. These steps do
    not change with q, and neither a far-away world frame nor the huge offsets of nearly parallel axes inflate
    them. Where all are zero, the sum of all |a| and |d|.

    Returns:
        A length, in the table's unit; 0 if all its lengths are zero.
    """
    turning = [axis for axis in chain.axes if not axis.prismatic]
    if not turning:
        return chain.extent
    end = position(chain.end)
    start, _ = walk(ORIGIN, turning[:1])
    there, forward = walk(start, turning[1:])
    _, backward = walk(end, turning[::-1])
    ways = [forward + norm(subtract(end, there)), backward]
    smallest = 1e-12 * chain.extent
    return min((way for way in ways if way > smallest), default=chain.extent)


def walk(here: Vector, axes: Sequence[Axis]) -> tuple[Vector, float]:
    """From a point to the nearest point of one axis after the other: where that ends, and how long it is."""
    total = 0.0
    for axis in axes:
        step = across(subtract(axis.point, here), axis.direction)
        total += norm(step)
        here = plus(here, step)
    return here, total


def screw_bases(chain: Chain) -> NDArray[np.float64]:
    """Matrices that the joint motions are made of.

    exp(S_i q) = 1 + sin q · A_i + (1 - cos q) · B_i for a revolute joint, 1 + q · A_i for a prismatic one.

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
        p = axis.point
        velocity = cross(p, axis.direction)
        pull = cross(axis.direction, velocity)
        flat += (0, -z, y, velocity[0], z, 0, -x, velocity[1], -y, x, 0, velocity[2], 0, 0, 0, 0)
        flat += (
            x * x - 1.0, x * y, x * z, pull[0],
            x * y, y * y - 1.0, y * z, pull[1],
            x * z, y * z, z * z - 1.0, pull[2],
            0, 0, 0, 0,
        )  # fmt: skip
    return np.array(flat, dtype=np.float64).reshape(len(chain.axes), 2, 16)


def joint_motions(chain: Chain, joints: NDArray[np.float64]) -> NDArray[np.float64]:
    """exp(S_i q_i) for every joint and configuration.

    Args:
        chain: the joint axes.
        joints: (n, samples) joint variables.

    Returns:
        (n, samples, 4, 4)
    """
    n, samples = joints.shape
    weights = np.empty((n, samples, 2))
    np.sin(joints, out=weights[:, :, 0])
    np.subtract(1.0, np.cos(joints), out=weights[:, :, 1])
    for i, axis in enumerate(chain.axes):
        if axis.prismatic:
            weights[i, :, 0] = joints[i]
    motions = (weights @ screw_bases(chain)).reshape(n, samples, 4, 4)
    motions += np.eye(4)
    return motions


def poses(chain: Chain, joints: NDArray[np.float64]) -> NDArray[np.float64]:
    """F(q) for a batch of configurations.

    Args:
        chain: the joint axes.
        joints: (n, samples) joint variables [rad, or a length for a prismatic joint].

    Returns:
        (samples, 4, 4)
    """
    end = to_matrix(chain.end)
    if not chain.axes:
        return np.broadcast_to(end, (joints.shape[1], 4, 4)).copy()
    motions = joint_motions(chain, joints)
    product = motions[0]
    for motion in motions[1:]:
        product = product @ motion
    return np.asarray(product @ end, dtype=np.float64)
