"""Joint axes as callers write them, and the convention of the wanted table."""

from typing import Annotated, Any, Literal, TypeAlias

from pydantic import Discriminator, Field, Tag

from kinematics.cells import AngleUnit, LengthUnit
from kinematics.frames.axes import Gripper, JointAxis
from kinematics.table import Convention, JointType
from service.http.validation import CHOICE
from service.schemas.base import Coordinates, OneOf, Wire
from service.schemas.kinematics.robot_question import PoseInput


class AxisModel(Wire):
    """The axis of one joint, with the robot at its zero position."""

    joint: Literal["revolute", "prismatic"]
    direction: Coordinates = Field(description="direction of the positive motion; any length but zero")
    point: Coordinates = Field(
        [0.0, 0.0, 0.0], description="a point of the axis; of a prismatic joint only the direction matters"
    )

    def axis(self) -> JointAxis:
        """Return the axis as the domain knows it."""
        return JointAxis(joint=JointType(self.joint), direction=self.direction, point=self.point)


class GripperTool(Wire):
    """A gripper, from which the end frame follows: z towards the object, y across the jaws."""

    point: Coordinates = Field(description="the middle between the jaws")
    approach: Coordinates = Field(description="direction towards the object")
    jaws: Coordinates = Field(description="direction in which the jaws slide")

    def gripper(self) -> Gripper:
        """Return the gripper as the domain knows it."""
        return Gripper(point=self.point, approach=self.approach, jaws=self.jaws)


GRIPPER, POSE = CHOICE + "gripper", CHOICE + "pose"


def _kind_of(tool: Any) -> str:
    if isinstance(tool, dict):
        return POSE if {"position", "quaternion"} & set(tool) else GRIPPER
    return GRIPPER if isinstance(tool, GripperTool) else POSE


Tool: TypeAlias = Annotated[
    Annotated[PoseInput, Tag(POSE)] | Annotated[GripperTool, Tag(GRIPPER)], Discriminator(_kind_of)
]


class AxesQuestion(Wire):
    """A robot by its joint axes, and the convention of the wanted table."""

    axes: list[AxisModel] = Field(min_length=1, max_length=64, description="the joint axes, base first")
    convention: OneOf[Convention]
    base: PoseInput | None = Field(
        None, description="a pose wanted as frame 0, in the coordinates of the axes"
    )
    tool: Tool | None = Field(None, description="the tool's pose at zero, or the gripper")
    angle_unit: OneOf[AngleUnit] = Field(
        AngleUnit.RAD, description="unit of the angles of the table, and of those of base and tool"
    )
    length_unit: OneOf[LengthUnit] = Field(LengthUnit.M, description="unit of all lengths")
