"""POST /workspace on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from service.schemas.base import Matrix4, Real, Vector3, Wire
from service.schemas.joint_limits import JointRanges
from service.schemas.robot_question import RobotQuestion
from service.schemas.tables import Units

MOST_POINTS = 20_000


class WorkspaceRequest(RobotQuestion):
    """A robot whose reach is asked for."""

    limits: JointRanges | None = Field(
        None,
        description="[least, greatest] of each joint in the table's units, null where there is none; left "
        "out, those of the catalogue's robot, else none. A revolute joint then turns fully, a sliding one "
        "needs both",
    )
    samples: int | None = Field(
        None, ge=1, le=MOST_POINTS, description="number of points for a plot; without it none are sent"
    )
    base: Matrix4 | None = Field(None, description="pose of frame 0 in the world: moves box and points")
    tool: Matrix4 | None = Field(None, description="pose of the end frame in frame N")


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
        description="of each point the distance from the axis of the first joint, and its height along it",
    )
