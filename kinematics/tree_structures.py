"""Tree structures in the notation of Khalil and Kleinfinger: modified DH tables that branch.

Frame j follows frame i = a(j). Where j is the first to follow, x_i lies along the common normal of z_i, z_j
and four parameters are enough; the others have common normals of their own, which two more lead to:

    iT_j = Rot_z(γ_j) Trans_z(b_j) · Rot_x(α_j) Trans_x(a_j) Rot_z(θ_j) Trans_z(d_j).

The first factor is a fixed row of a modified table, so a path from the base to any frame is a serial arm, and
everything that is known of those holds of it. Closed loops are another matter: their joints depend on each
other, and they are not treated here.

Source: seed 002, comparison of the conventions on branches; W. Khalil, J. F. Kleinfinger, A new geometric
notation for open and closed-loop robots, IEEE ICRA (1986) 1174.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kinematics.cells import (
    DEFAULT,
    AngleUnit,
    Cell,
    LengthUnit,
    Limits,
    RawRow,
    RawTable,
    ReadTable,
    read_table,
)
from kinematics.chain import chain_of_table
from kinematics.dh import link_transform
from kinematics.errors import Fault, KinematicsError, TableError
from kinematics.expressions import ZERO
from kinematics.se3 import Transform
from kinematics.table import Convention, DHTable, Entry, JointType, NumericTable

_BRANCH_CELLS = {"theta": "gamma", "d": "b"}


@dataclass(frozen=True, kw_only=True, slots=True)
class RawTreeRow:
    """One row of a branching table as handed in.

    Attributes:
        after: number of the frame that it follows, 0 of the base.
        gamma: angle from x_i to the common normal of z_i and z_j, about z_i.
        b: distance along z_i to it.
        row: the four parameters of a modified table.
    """

    after: int
    gamma: Cell
    b: Cell
    row: RawRow


@dataclass(frozen=True, kw_only=True, slots=True)
class ReadTree:
    """A tree, understood.

    Attributes:
        read: two rows for each frame: the fixed one of γ and b, and that of the joint.
        after: for frame 1 … n the frame that it follows.
    """

    read: ReadTable
    after: tuple[int, ...]

    @property
    def tips(self) -> tuple[int, ...]:
        """The frames that no other follows."""
        return tuple(frame for frame in range(1, len(self.after) + 1) if frame not in self.after)

    def path(self, frame: int) -> tuple[int, ...]:
        """Return the frames from the base to one, that one included."""
        found: list[int] = []
        while frame:
            found.append(frame)
            frame = self.after[frame - 1]
        return tuple(found[::-1])

    def joints(self, frame: int) -> tuple[int, ...]:
        """Return the numbers of the joints that move a frame, from 1."""
        moving = [row.joint is not JointType.FIXED for row in self.read.table.rows[1::2]]
        return tuple(sum(moving[:k]) for k in self.path(frame) if moving[k - 1])


def read_tree(
    rows: Sequence[RawTreeRow],
    angle_unit: AngleUnit = AngleUnit.RAD,
    length_unit: LengthUnit = LengthUnit.M,
    limits: Limits = DEFAULT,
) -> ReadTree:
    """Return the tree that a branching table as handed in means.

    q_i is the variable of the i-th joint of the rows.

    Raises:
        TableError: a row that follows none before it, at ("rows", i, "after"), or no DH table.
        CellError: cells cannot be read, each fault at ("rows", i, cell).
    """
    faults = [
        Fault.at("tree_after_unknown", "rows", i, "after", row=i + 1, given=row.after)
        for i, row in enumerate(rows)
        if not 0 <= row.after <= i
    ]
    if faults:
        raise TableError(faults)
    both = [
        one
        for each in rows
        for one in (RawRow(joint=JointType.FIXED, alpha=0, a=0, d=each.b, theta=each.gamma), each.row)
    ]
    raw = RawTable(
        convention=Convention.MODIFIED, rows=tuple(both), angle_unit=angle_unit, length_unit=length_unit
    )
    try:
        # rows are not counted: they are not those handed in
        read = read_table(raw, replace(limits, rows=2 * limits.rows), by_row=False)
    except KinematicsError as error:
        raise type(error)(fault_in_tree(fault) for fault in error.faults) from None
    return ReadTree(read=read, after=tuple(row.after for row in rows))


def path_table(tree: ReadTree, table: DHTable[Entry], frame: int) -> DHTable[Entry]:
    """Return the modified table of the serial arm from the base to a frame."""
    rows = []
    for k in tree.path(frame):
        branch, row = table.rows[2 * k - 2 : 2 * k]
        if branch.theta not in (0.0, ZERO) or branch.d not in (0.0, ZERO):
            rows.append(branch)
        rows.append(row)
    return DHTable(convention=Convention.MODIFIED, rows=tuple(rows))


def tree_frames(tree: ReadTree, table: NumericTable, joints: Sequence[float]) -> list[Transform]:
    """Return the poses of frames 1 … n in frame 0.

    Args:
        joints: q_1 … q_m in the order of the rows [rad, or length units].
    """
    frames: list[Transform] = [np.eye(4)]
    values = iter(joints)
    for k, after in enumerate(tree.after):
        branch, row = table.rows[2 * k : 2 * k + 2]
        q = 0.0 if row.joint is JointType.FIXED else next(values)
        pose = frames[after] @ link_transform(branch, Convention.MODIFIED)
        frames.append(pose @ link_transform(row, Convention.MODIFIED, q))
    return frames[1:]


def tree_jacobian(
    tree: ReadTree, table: NumericTable, joints: Sequence[float], frame: int
) -> NDArray[np.float64]:
    """Return J0 of a frame, (6, m): columns of joints that do not move it are zero.

    Args:
        joints: q_1 … q_m in the order of the rows [rad, or length units].
    """
    J = np.zeros((6, table.n_joints))
    moving = [k - 1 for k in tree.joints(frame)]
    if moving:
        J[:, moving] = chain_of_table(path_table(tree, table, frame)).jacobian([joints[k] for k in moving])
    return J


def fault_in_tree(fault: Fault) -> Fault:
    """Return a fault of the table with two rows a frame at its place in the branching table."""
    match fault.where:
        case ("rows", int(k), str(cell)):
            if k % 2:
                return replace(fault, where=("rows", k // 2, cell))
            cell = _BRANCH_CELLS.get(cell, cell)
            if fault.code == "variable_in_fixed_row":  # the row is no fixed one to who wrote it
                return Fault.at("variable_in_constant_cell", "rows", k // 2, cell, cell=cell, **fault.params)
            return replace(fault, where=("rows", k // 2, cell))
        case ("rows", int(k)):
            return replace(fault, where=("rows", k // 2))
    return fault
