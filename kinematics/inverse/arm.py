"""A serial chain as constants and joints: T(q) = K_0 J_1(q_1) K_1 J_2(q_2) ⋯ J_n(q_n) K_n.

J_i is a turn about z or a slide along z. Every DH table of either convention, with its base, tool and fixed
rows, is such a product, so nothing behind this file knows about conventions.
"""

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinematics.chain import joint_constants
from kinematics.se3 import Transform, cross_arrays
from kinematics.table import JointType, NumericTable

Array = NDArray[np.float64]

_TINY, _TINY_BESIDE_A_SLIDE = 1e-10, 1e-6
"""Offsets below this part of 1 (or of the distance of the base) say nothing about the arm's size."""

_ROUNDED_AWAY = 1e-13
"""The same of turning joints that only have to bring the origin somewhere: without offsets they cannot."""

FULL_RANK = 1e-4  # Singular values that exceed this somewhere are not zero everywhere.

RANK_SAMPLES = 8  # Configurations at which the rank is looked at; one would do but for chance.


class ArmReach(StrEnum):
    """What of the tool has to reach the target.

    POSE: position and orientation. POSITION: its origin alone. AXIS: its origin and the direction of its z
    axis, as of a drill or a torch that may turn about itself.
    """

    POSE = "pose"
    POSITION = "position"
    AXIS = "axis"


@dataclass(frozen=True, kw_only=True, eq=False)
class Arm:
    """Constants of a serial chain.

    Attributes:
        constants: (n+1, 4, 4) the K_i.
        revolute: (n,) which joints turn.
        size: sum of the arm's offsets [m], or where they are as good as none, 1 (or the distance of the base,
            if that is more). Positions are divided by it where they are weighed against angles.
        sliding: the unit of joints that slide [m]: the size, whatever distances are weighed by.
        rounding: what rounding leaves of a position [m].
        reach: what of the tool has to reach a target; errors and Jacobians leave out the rest.
    """

    constants: Array
    revolute: NDArray[np.bool_]
    size: float
    sliding: float
    rounding: float
    reach: ArmReach = ArmReach.POSE

    @property
    def n_joints(self) -> int:
        """Number of joints."""
        return len(self.revolute)

    @cached_property
    def units(self) -> Array:
        """(n,) unit of each joint variable: 1 rad of one that turns, the size of one that slides."""
        return np.where(self.revolute, 1.0, self.sliding)

    @cached_property
    def sliding_joints(self) -> tuple[int, ...]:
        """Which joints slide, from 0: in most arms none."""
        return tuple(np.flatnonzero(~self.revolute).tolist())

    @cached_property
    def link_basis(self) -> Array:
        """(n, 3, 16) matrices with J_i(q) K_i = c·B_0 + s·B_1 + B_2; (c, s) = (cos q, sin q), or (q, 0)."""
        turn_cos = np.diag([1.0, 1.0, 0.0, 0.0])
        turn_sin = np.zeros((4, 4))
        turn_sin[1, 0], turn_sin[0, 1] = 1.0, -1.0
        turn_rest = np.diag([0.0, 0.0, 1.0, 1.0])
        slide = np.zeros((4, 4))
        slide[2, 3] = 1.0
        basis = [
            (turn_cos @ K, turn_sin @ K, turn_rest @ K) if turns else (slide @ K, np.zeros((4, 4)), K)
            for K, turns in zip(self.constants[1:], self.revolute, strict=True)
        ]
        return np.array(basis).reshape(self.n_joints, 3, 16)

    def frames(self, q: Array) -> Array:
        """Return the poses before each joint and at the end, for many configurations.

        Args:
            q: (m, n) joint variables.

        Returns:
            (n+1, m, 4, 4); frame i holds the axis of joint i+1 as its z, the last is T(q).
        """
        m, n = q.shape
        weights = np.empty((n, m, 3))
        np.cos(q.T, out=weights[:, :, 0])
        np.sin(q.T, out=weights[:, :, 1])
        weights[:, :, 2] = 1.0
        for i in self.sliding_joints:
            weights[i, :, 0], weights[i, :, 1] = q[:, i], 0.0
        links = (weights @ self.link_basis).reshape(n, m, 4, 4)
        frames = np.empty((n + 1, m, 4, 4))
        frames[0] = self.constants[0]
        for i in range(n):
            np.matmul(frames[i], links[i], out=frames[i + 1])
        return frames

    def jacobians(self, frames: Array) -> Array:
        """Return geometric Jacobians in the base, positions divided by the size.

        Args:
            frames: what `frames` returned.

        Returns:
            (m, 6, n): linear over angular velocity.
        """
        axes = frames[:-1, :, :3, 2]
        arms = frames[-1, :, :3, 3] - frames[:-1, :, :3, 3]
        J = np.empty((frames.shape[1], 6, self.n_joints))
        np.divide(cross_arrays(axes, arms).transpose(1, 2, 0), self.size, out=J[:, :3])
        J[:, 3:] = axes.transpose(1, 2, 0)
        for i in self.sliding_joints:
            J[:, :3, i], J[:, 3:, i] = axes[i] / self.size, 0.0
        if self.reach is ArmReach.POSITION:
            J[:, 3:] = 0.0
        elif self.reach is ArmReach.AXIS:
            z = frames[-1, :, :3, 2]
            J[:, 3:] -= z[:, :, None] * np.einsum("mi,mij->mj", z, J[:, 3:])[:, None]
        return J

    @cached_property
    def generic_rank(self) -> int:
        """Rank of the Jacobian at almost every configuration."""
        q = 2.0 * np.pi * low_discrepancy(RANK_SAMPLES, self.n_joints)
        J = self.jacobians(self.frames(q * np.where(self.revolute, 1.0, self.size / np.pi))) * self.units
        return int((np.linalg.svd(J, compute_uv=False) > FULL_RANK).sum(axis=1).max(initial=0))

    @property
    def redundancy(self) -> int:
        """Degree of redundancy: the dimension of the solutions for almost every pose in reach."""
        return self.n_joints - self.generic_rank

    @cached_property
    def screws(self) -> tuple[Array, Array, Transform]:
        """Axes at q = 0: (n, 3) unit directions, (n, 3) points, and the (4, 4) end pose."""
        frames = self.frames(np.zeros((1, self.n_joints)))[:, 0]
        return frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1]


def arm_of(
    table: NumericTable,
    base: Transform | None = None,
    tool: Transform | None = None,
    reach: ArmReach = ArmReach.POSE,
) -> Arm:
    """Return the chain of a DH table.

    Args:
        table: the table.
        base: (4, 4) pose of frame 0; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.
        reach: what of the tool has to reach a target.
    """
    revolute = [kind is JointType.REVOLUTE for kind in table.joint_types]
    K = np.array(joint_constants(table, base, tool))
    offsets = float(np.linalg.norm(K[1:, :3, 3], axis=1).sum())
    away = max(1.0, float(np.linalg.norm(K[0, :3, 3])))
    least = _TINY if all(revolute) else _TINY_BESIDE_A_SLIDE
    if reach is ArmReach.POSITION and all(revolute):
        least = _ROUNDED_AWAY
    size = offsets if offsets > least * away else away
    return Arm(
        constants=K,
        revolute=np.array(revolute, dtype=bool),
        size=size,
        sliding=size,
        rounding=1e-13 * (size + float(np.linalg.norm(K[0, :3, 3]))),
        reach=reach,
    )


def low_discrepancy(count: int, dimension: int, skip: int = 0) -> Array:
    """Return the points of the additive recurrence x_k = frac(½ + k·α), α from the generalised golden ratio.

    The first `skip` points of the sequence are left out.

    Source: M. Roberts, The unreasonable effectiveness of quasirandom sequences (2018).
    """
    root = 1.5
    for _ in range(60):
        root = (1.0 + root) ** (1.0 / (dimension + 1))
    alpha = root ** -np.arange(1.0, dimension + 1.0)
    return np.asarray((0.5 + np.arange(skip + 1, skip + count + 1)[:, None] * alpha) % 1.0)
