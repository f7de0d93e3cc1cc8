"""POST /trees on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.cells import AngleUnit, LengthUnit, RawRow
from kinematics.table import JointType
from kinematics.tree_structures import RawTreeRow
from service.schemas.base import LONGEST_LIST, WHOLE, Matrix4, OneOf, Real, Whole, Wire
from service.schemas.kinematics.jacobian_request import Matrix6
from service.schemas.tables import AnsweredTable, Cell, Parameters, Units

MOST_ROWS = 64
"""Frames of a tree, as many as a table may have rows."""


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
