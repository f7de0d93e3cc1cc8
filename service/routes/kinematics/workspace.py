"""How far a robot reaches."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from kinematics.inverse import ArmReach
from kinematics.inverse.limits import JointLimits
from kinematics.workspace import Radius, Workspace, check_reach, joint_spans, workspace
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, OneRobotRoute, api_router
from service.schemas import examples
from service.schemas.kinematics import workspace_request as wire
from service.schemas.kinematics.joints import domain_limits
from service.wire.fault_pointers import traced
from service.wire.kinematics.joint_values import in_request_units
from service.wire.kinematics.pose_matrices import base_and_tool, placed_matrix
from service.wire.kinematics.prepared_robots import PreparedRobot, listed_robot
from service.work.workers import Lane

router = api_router("kinematics", route_class=OneRobotRoute)

_DMRA: dict[str, Any] = {"robot": "dmra"}
_EXAMPLES: dict[str, Any] = {
    "DMRA, every joint turning fully": _DMRA,
    "a SCARA within its limits, with points": {"robot": "scara", "samples": 16},
    "DMRA in its support plane, the hand pointing down": {"robot": "dmra", "plane": {}, "axis": [0, 0, -1]},
    "two links with an elbow that bends by 30° to 120°": {
        "table": {**examples.TWO_LINKS, "angle_unit": "deg"},
        "parameters": {"L1": 0.4, "L2": 0.3},
        "limits": [None, [30, 120]],
    },
}


@router.post(
    "/workspace",
    summary="Radii, box and points of the workspace",
    response_model_exclude_none=True,
    responses=problems(503),
)
async def reach(
    body: Annotated[wire.WorkspaceRequest, body_with(_EXAMPLES)], request: ApiRequest
) -> wire.WorkspaceResponse:
    """Return the least and greatest distance of the end frame's origin, and the box that contains it.

    Radii are measured from the axis of the first joint and from the origin of frame 0. Each number belongs
    to a configuration within the limits and is exact to rounding; that nothing lies beyond is found by
    climbing from many starts, not proved. With `plane`, `quaternion` or `axis`, only configurations count
    whose origin is in the plane and whose end frame has that orientation.
    """
    resources = request.resources
    robot = await request.in_turn(partial(resources.robots.prepare, body))
    limits = _limits(body, robot)
    base, tool = base_and_tool(body, robot.angle)
    with traced(body):
        check_reach(robot.table, base, tool)
    joint_spans(robot.table, limits)
    held = None
    if body.quaternion is not None or body.axis is not None:
        held = placed_matrix([0.0, 0.0, 0.0], body.quaternion, body.axis)
    plane = None if body.plane is None else (body.plane.point, body.plane.normal)
    reach = ArmReach.POSE if body.axis is None else ArmReach.AXIS
    question = (robot.table, limits, base, tool, body.samples or 0, plane, held, reach)
    found = await resources.workers.run(Lane.SLOW, _found, *question)
    return _answer(found, robot)


def _limits(body: wire.WorkspaceRequest, robot: PreparedRobot) -> JointLimits | None:
    if body.limits is None and body.robot is not None:
        return domain_limits(listed_robot(body.robot).limits, robot.joint_units)
    return domain_limits(body.limits, robot.joint_units)


def _found(
    table: Any, limits: Any, base: Any, tool: Any, samples: int, plane: Any, held: Any, reach: ArmReach
) -> Workspace:
    return workspace(
        table, limits, base=base, tool=tool, samples=samples, plane=plane, held=held, counts=reach
    )


def _answer(found: Workspace, robot: PreparedRobot) -> wire.WorkspaceResponse:
    units: dict[str, Any] = dict(robot.units)
    return wire.WorkspaceResponse(
        **units,
        inner_radius=wire.RadiusModel(axis=found.inner.axis.value, origin=found.inner.origin.value),
        outer_radius=wire.RadiusModel(axis=found.outer.axis.value, origin=found.outer.origin.value),
        box=wire.BoundingBox(min=list(found.low), max=list(found.high)),
        reached=wire.Reached(
            inner_radius=wire.RadiusJoints(
                axis=_joints(found.inner.axis, robot), origin=_joints(found.inner.origin, robot)
            ),
            outer_radius=wire.RadiusJoints(
                axis=_joints(found.outer.axis, robot), origin=_joints(found.outer.origin, robot)
            ),
        ),
        points=found.points.tolist() if len(found.points) else None,
        section=found.section.tolist() if len(found.section) else None,
    )


def _joints(radius: Radius, robot: PreparedRobot) -> list[float]:
    return in_request_units(radius.joints, robot.joint_units)
