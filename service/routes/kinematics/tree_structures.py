"""POST /trees: arms that branch."""

from dataclasses import replace
from typing import Annotated

from pydantic import Field

from kinematics.cells import AngleUnit, LengthUnit, Limits, RawRow
from kinematics.errors import Fault, TableError
from kinematics.inverse.lengths import check_lengths
from kinematics.table import JointType
from kinematics.tree_structures import (
    RawTreeRow,
    fault_in_tree,
    path_table,
    read_tree,
    tree_frames,
    tree_jacobian,
)
from service.http.calls import CallRouter
from service.http.problems import located, moved
from service.schemas.base import LONGEST_LIST, WHOLE, Matrix4, Matrix6, OneOf, Real, Whole, Wire
from service.schemas.tables import AnsweredTable, Cell, Parameters, Units
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.prepared_robots import robot_of
from service.wire.kinematics.written_tables import TableWriter

MOST_ROWS = 64  # Frames of a tree, as many as a table may have rows.


class TreeRowModel(Wire):
    """One frame of a tree, by the parameters of Khalil and Kleinfinger."""

    after: Annotated[int, Field(ge=0, le=MOST_ROWS), WHOLE] = Field(
        description="number of the frame that this one follows; 0 is the base"
    )
    gamma: Cell = Field(0, description="γ_j: angle from x_i to the common normal of z_i and z_j, about z_i")
    b: Cell = Field(0, description="b_j: distance along z_i to that common normal")
    joint: OneOf[JointType] | None = Field(
        None, description="what varies; left out, it follows from the cell that holds the row's variable"
    )
    alpha: Cell = Field(description="α_j: angle from z_i to z_j, about the common normal")
    a: Cell = Field(description="a_j: distance from z_i to z_j, along it (Khalil's d_j)")
    d: Cell = Field(description="d_j: offset along z_j (Khalil's r_j)")
    theta: Cell = Field(description="θ_j: angle from the common normal to x_j, about z_j")


class Tree(Wire):
    """An arm that branches."""

    rows: list[TreeRowModel] = Field(
        min_length=1, max_length=MOST_ROWS, description="frames 1 … n, each after the one that it follows"
    )
    angle_unit: OneOf[AngleUnit] = Field(
        AngleUnit.RAD, description="unit of every angle: rows, joints, parameters and answer"
    )
    length_unit: OneOf[LengthUnit] = Field(
        LengthUnit.M, description="unit of every length: rows, joints, parameters and answer"
    )

    def raw(self) -> list[RawTreeRow]:
        """Return the rows as the cell grammar reads them."""
        return [
            RawTreeRow(
                after=row.after,
                gamma=row.gamma,
                b=row.b,
                row=RawRow(joint=row.joint, alpha=row.alpha, a=row.a, d=row.d, theta=row.theta),
            )
            for row in self.rows
        ]


class TreeRequest(Wire):
    """A tree at one configuration."""

    tree: Tree = Field(description="the branching table")
    parameters: Parameters = Field(default_factory=dict)
    joints: list[Real] = Field(
        max_length=MOST_ROWS, description="q_1 … q_m in the order of the rows, in the tree's units"
    )
    ends: list[Whole] | None = Field(
        None,
        min_length=1,
        max_length=LONGEST_LIST,
        description="numbers of the frames whose Jacobian and table are wanted; the tips if left out",
    )


class TreeEnd(Wire):
    """A frame of a tree as the end of a serial arm."""

    frame: int = Field(description="its number")
    joints: list[int] = Field(description="numbers of the joints that move it, base first")
    transform: Matrix4 = Field(description="its pose in frame 0")
    J0: Matrix6 = Field(
        description="its Jacobian in the axes of frame 0, with a column for every joint of the tree"
    )
    table: AnsweredTable = Field(
        description="the modified table of the arm that leads to it; qi is its i-th joint"
    )


class TreeAnswer(Units):
    """The frames of a tree, and what leads to some of them."""

    frames: list[Matrix4] = Field(description="poses of frames 1 … n in frame 0")
    ends: list[TreeEnd] = Field(description="the tips, or the frames that were asked for")


router = CallRouter("kinematics")


@router.call("/trees", "Frames, Jacobians and tables of an arm that branches")
def trees(body: TreeRequest, limits: Limits) -> TreeAnswer:
    """Return the poses of all frames of a tree (Khalil, Kleinfinger), and each tip's Jacobian and table.

    Frame j follows frame i: iT_j = Rot_z(γ) Trans_z(b) Rot_x(α) Trans_x(a) Rot_z(θ) Trans_z(d). The path to a
    tip is a serial arm, whose modified table is returned and can be given to every other call. Closed loops
    are not treated.
    """
    with located("tree"):
        tree = read_tree(body.tree.raw(), body.tree.angle_unit, body.tree.length_unit, limits)
    with moved(_placed):
        robot = robot_of(tree.read, body.parameters)
        check_lengths(robot.table)
    joints = values_in_radians(body.joints, robot.joint_units, "joints")
    count = len(tree.after)
    unknown = [
        Fault.at("frame_unknown", "ends", i, given=end, count=count)
        for i, end in enumerate(body.ends or ())
        if not 1 <= end <= count
    ]
    if unknown:
        raise TableError(unknown)
    frames = tree_frames(tree, robot.table, joints)
    writer = TableWriter(units=tree.read)
    ends = [
        TreeEnd(
            frame=end,
            joints=list(tree.joints(end)),
            transform=plain_lists(frames[end - 1]),
            J0=plain_lists(tree_jacobian(tree, robot.table, joints, end)),
            table=AnsweredTable.model_validate(writer.table(path_table(tree, tree.read.table, end))),
        )
        for end in body.ends or tree.tips
    ]
    return TreeAnswer(**robot.units, frames=[plain_lists(frame) for frame in frames], ends=ends)


def _placed(fault: Fault) -> Fault:
    """The place of a fault in the request."""
    if fault.where[:1] == ("parameters",):
        return fault
    inside = replace(fault, where=tuple(step for step in fault.where if step != "table"))
    return fault_in_tree(inside).within("tree")
