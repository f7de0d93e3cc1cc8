"""Forward kinematics: joint values to the poses of every frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.errors import Fault, JointValueError
from kinematics.links import Transform, link_transform
from kinematics.table import NumericTable


@dataclass(frozen=True, kw_only=True, slots=True)
class ForwardKinematics:
    """Poses of a serial chain at one configuration.

    Attributes:
        transform: (4, 4) pose of the end frame, base and tool included.
        links: (rows, 4, 4) pose of frame i in frame i-1.
        frames: (rows, 4, 4) pose of frame i in the world (frame 0 if there is no base).
    """

    transform: Transform
    links: NDArray[np.float64]
    frames: NDArray[np.float64]


def forward_kinematics(
    table: NumericTable, joints: ArrayLike, *, base: Transform | None = None, tool: Transform | None = None
) -> ForwardKinematics:
    """Poses of every frame at one configuration: T = base · A_1 ⋯ A_N · tool.

    Args:
        table: the DH table.
        joints: (n,) joint variables in joint order [rad, or m for a prismatic joint].
        base: (4, 4) pose of frame 0 in the world; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.

    Raises:
        JointValueError: not n finite values.

    Source: seed 000 eq. 3.3.
    """
    q = np.asarray(joints, dtype=np.float64)
    if q.shape != (table.n_joints,):
        raise JointValueError(
            Fault(
                code="joints_wrong_length",
                message=f"the table has {table.n_joints} joints; give as many values",
                params={"expected": table.n_joints},
            )
        )
    values = dict(zip(table.joint_rows, q.tolist(), strict=True))
    links = np.empty((len(table.rows), 4, 4))
    frames = np.empty_like(links)
    pose = np.eye(4) if base is None else np.asarray(base, dtype=np.float64)
    for i, row in enumerate(table.rows):
        links[i] = link_transform(row, table.convention, values.get(i, 0.0))
        pose = pose @ links[i]
        frames[i] = pose
    return ForwardKinematics(transform=pose if tool is None else pose @ tool, links=links, frames=frames)
