"""POST /workspace on the wire."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from service.schemas.base import WHOLE, Real, Vector3, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.joints import JointRanges
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.kinematics.robot_question import NO_ROBOT, RobotQuestion
from service.schemas.tables import Units

MOST_POINTS = 20_000
"""Points of a cloud: more than a plot of the page can tell apart."""


class PlaneModel(Wire):
    """A plane in the world."""

    point: Vector3 = Field([0.0, 0.0, 0.0], description="one of its points; the origin if left out")
    normal: Vector3 = Field([0.0, 0.0, 1.0], description="its normal, of any length; z if left out")


class WorkspaceRequest(RobotQuestion):
    """A robot whose reach is asked for."""

    model_config = forbidding(*NO_ROBOT, together("quaternion", "axis"))

    limits: JointRanges | None = Field(
        None,
        description="[least, greatest] of each joint in the table's units, null where there is none; left "
        "out, those of the catalogue's robot, else none. A revolute joint then turns fully, a prismatic one "
        "needs both",
    )
    samples: Annotated[int, Field(ge=1, le=MOST_POINTS), WHOLE] | None = Field(
        None, description="number of points for a plot; without it none are sent"
    )
    base: PoseInput | None = Field(None, description="pose of frame 0 in the world: moves box and points")
    tool: PoseInput | None = Field(None, description="pose of the end frame in frame N")
    plane: PlaneModel | None = Field(
        None, description="only places in this plane count, such as the support plane {}: z = 0"
    )
    quaternion: Annotated[list[Real], Field(min_length=4, max_length=4)] | None = Field(
        None, description="only with the end frame oriented so, in the world: [w, x, y, z] of any length"
    )
    axis: Vector3 | None = Field(
        None, description="only with the end frame's z axis along this, in the world; turns about it are free"
    )

    @model_validator(mode="after")
    def _one_orientation(self) -> Self:
        if self.quaternion is not None and self.axis is not None:
            raise PydanticCustomError("quaternion_or_axis", "give at most one of quaternion and axis")
        return self


class RadiusModel(Wire):
    """A radius, measured in two ways."""

    axis: Real = Field(description="at right angles from the axis of the first joint")
    origin: Real = Field(description="from the origin of frame 0")


class RadiusJoints(Wire):
    """Configurations that have a radius."""

    axis: list[Real]
    origin: list[Real]


class Reached(Wire):
    """For every radius a configuration that has it, q_1 … q_n: anyone can check it."""

    inner_radius: RadiusJoints
    outer_radius: RadiusJoints


class BoundingBox(Wire):
    """The smallest box along the axes of the world that holds the workspace."""

    min: Vector3
    max: Vector3


class WorkspaceResponse(Units):
    """Where the origin of the end frame can be."""

    inner_radius: RadiusModel = Field(description="the least distances")
    outer_radius: RadiusModel = Field(description="the greatest distances")
    box: BoundingBox
    reached: Reached
    points: list[Vector3] | None = Field(
        None, description="places in the world, spread evenly over the joints' ranges"
    )
    section: list[Annotated[list[Real], Field(min_length=2, max_length=2)]] | None = Field(
        None,
        description="of each point the distance from the axis of the first joint, and its height along it, "
        "upward in the world",
    )
