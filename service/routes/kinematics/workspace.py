"""POST /workspace: how far a robot reaches."""

from functools import partial
from typing import Annotated, Self

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from kinematics.inverse import ArmReach
from kinematics.inverse.limits import JointLimits
from kinematics.workspace import Radii, Workspace, check_reach, joint_spans, workspace
from service.http.calls import CallRouter
from service.http.routing import OneRobotRoute
from service.resources import Resources
from service.schemas.base import WHOLE, Real, Vector3, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.robot_question import (
    NO_ROBOT,
    JointRanges,
    PlacedRobotQuestion,
    PoseInput,
    domain_limits,
)
from service.schemas.tables import Units
from service.wire.fault_pointers import traced
from service.wire.kinematics.joint_values import in_request_units
from service.wire.kinematics.pose_matrices import base_and_tool, placed_matrix
from service.wire.kinematics.prepared_robots import PreparedRobot, listed_robot
from service.work.workers import Lane

MOST_POINTS = 20_000  # Points of a cloud: more than a plot of the page can tell apart.


class PlaneModel(Wire):
    """A plane in the world."""

    point: Vector3 = Field([0.0, 0.0, 0.0], description="one of its points; the origin if left out")
    normal: Vector3 = Field([0.0, 0.0, 1.0], description="its normal, of any length; z if left out")


class WorkspaceRequest(PlacedRobotQuestion):
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


router = CallRouter("kinematics", route_class=OneRobotRoute)


@router.call("/workspace", "Radii, box and points of the workspace", exclude_none=True)
async def reach(body: WorkspaceRequest, robot: PreparedRobot, resources: Resources) -> WorkspaceResponse:
    """Return the least and greatest distance of the end frame's origin, and the box that contains it.

    Radii are measured from the axis of the first joint and from the origin of frame 0. Each number belongs
    to a configuration within the limits and is exact to rounding; that nothing lies beyond is found by
    climbing from many starts, not proved. With `plane`, `quaternion` or `axis`, only configurations count
    whose origin is in the plane and whose end frame has that orientation.
    """
    limits = _limits(body, robot)
    base, tool = base_and_tool(body, robot.angle)
    with traced(body):
        check_reach(robot.table, base, tool)
    joint_spans(robot.table, limits)
    held = None
    if body.quaternion is not None or body.axis is not None:
        held = placed_matrix([0.0, 0.0, 0.0], body.quaternion, body.axis)
    work = partial(
        workspace,
        robot.table,
        limits,
        base=base,
        tool=tool,
        samples=body.samples or 0,
        plane=None if body.plane is None else (body.plane.point, body.plane.normal),
        held=held,
        counts=ArmReach.POSE if body.axis is None else ArmReach.AXIS,
    )
    return _answer(await resources.workers.run(Lane.SLOW, work), robot)


def _limits(body: WorkspaceRequest, robot: PreparedRobot) -> JointLimits | None:
    if body.limits is None and body.robot is not None:
        return domain_limits(listed_robot(body.robot).limits, robot.joint_units)
    return domain_limits(body.limits, robot.joint_units)


def _answer(found: Workspace, robot: PreparedRobot) -> WorkspaceResponse:
    def joints(radii: Radii) -> RadiusJoints:
        axis, origin = (in_request_units(one.joints, robot.joint_units) for one in (radii.axis, radii.origin))
        return RadiusJoints(axis=axis, origin=origin)

    return WorkspaceResponse(
        **robot.units,
        inner_radius=RadiusModel(axis=found.inner.axis.value, origin=found.inner.origin.value),
        outer_radius=RadiusModel(axis=found.outer.axis.value, origin=found.outer.origin.value),
        box=BoundingBox(min=list(found.low), max=list(found.high)),
        reached=Reached(inner_radius=joints(found.inner), outer_radius=joints(found.outer)),
        points=found.points.tolist() if len(found.points) else None,
        section=found.section.tolist() if len(found.section) else None,
    )
