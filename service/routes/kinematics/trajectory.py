"""From one configuration to another, over time."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np

from kinematics.forward import end_poses
from kinematics.inverse.lengths import check_lengths
from kinematics.trajectory import joint_trajectory
from service.http.openapi import body_with
from service.http.routing import api_router
from service.resources import AppResources
from service.schemas.kinematics.trajectory_request import TrajectoryAnswer, TrajectoryRequest
from service.wire.fault_pointers import traced
from service.wire.kinematics.joint_values import values_in_radians

router = api_router("kinematics")

_EXAMPLES: dict[str, Any] = {
    "a PUMA 560 that stretches in two seconds": {
        "robot": "puma560",
        "start": [0, 45, -180, 0, 45, 0],
        "end": [0, 90, -90, 0, 0, 0],
        "duration": 2,
        "samples": 5,
    }
}


@router.post("/trajectory", summary="Joint trajectory between two configurations")
async def trajectory(
    body: Annotated[TrajectoryRequest, body_with(_EXAMPLES)], resources: AppResources
) -> TrajectoryAnswer:
    """Return a motion from `start` to `end`, joints together: q(t) = start + s(t / duration) (end − start).

    s is a cubic or a quintic polynomial that begins and ends at rest, so no joint overshoots: a motion whose
    ends are within the limits stays within them.
    """
    robot = resources.robots.prepare(body)
    with traced(body):
        check_lengths(robot.table)
    units = robot.joint_units
    start, end = (
        values_in_radians(values, units, field)
        for values, field in ((body.start, "start"), (body.end, "end"))
    )
    found = joint_trajectory(start, end, duration=body.duration, samples=body.samples, scaling=body.scaling)
    outward = np.array([1.0 / unit for unit in units])
    return TrajectoryAnswer.model_validate(
        {
            **robot.units,
            "times": found.times.tolist(),
            "positions": (found.positions * outward).tolist(),
            "velocities": (found.velocities * outward).tolist(),
            "accelerations": (found.accelerations * outward).tolist(),
            "path": end_poses(robot.table, found.positions)[:, :3, 3].tolist(),
        }
    )
