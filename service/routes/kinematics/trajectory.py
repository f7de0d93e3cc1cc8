"""POST /trajectory: from one configuration to another, over time."""

from typing import Annotated

import numpy as np
from pydantic import Field

from kinematics.forward import end_poses
from kinematics.inverse.lengths import check_lengths
from kinematics.trajectory import TimeScaling, joint_trajectory
from service.http.calls import CallRouter
from service.schemas.base import WHOLE, OneOf, Real, Vector3
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.tables import Units
from service.wire.fault_pointers import traced
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.prepared_robots import PreparedRobot

MOST_INSTANTS = 1000  # Instants of one motion: finer than a plot or an animation of some seconds shows.

JointRows = list[list[Real]]


class TrajectoryRequest(RobotQuestion):
    """A robot that goes from rest at one configuration to rest at another."""

    start: list[Real] = Field(max_length=64, description="q_1 … q_n at the beginning, in the table's units")
    end: list[Real] = Field(max_length=64, description="q_1 … q_n at the end, in the table's units")
    duration: Real = Field(1.0, ge=1e-3, le=1e6, description="how long it takes, in seconds")
    samples: Annotated[int, Field(ge=2, le=MOST_INSTANTS), WHOLE] = Field(
        101, description="number of instants, evenly spaced, both ends included"
    )
    scaling: OneOf[TimeScaling] = Field(
        TimeScaling.QUINTIC,
        description="cubic: at rest at both ends; quintic: without acceleration there, too",
    )


class TrajectoryAnswer(Units):
    """What the joints and the end frame do at every instant."""

    times: list[Real] = Field(description="in seconds")
    positions: JointRows = Field(description="q_1 … q_n at every instant, in the table's units")
    velocities: JointRows = Field(description="q̇_1 … q̇_n, in the table's units per second")
    accelerations: JointRows = Field(description="q̈_1 … q̈_n, in the table's units per second squared")
    path: list[Vector3] = Field(description="the origin of frame N in frame 0 at every instant")


router = CallRouter("kinematics")


@router.call("/trajectory", "Joint trajectory between two configurations")
def trajectory(body: TrajectoryRequest, robot: PreparedRobot) -> TrajectoryAnswer:
    """Return a motion from `start` to `end`, joints together: q(t) = start + s(t / duration) (end − start).

    s is a cubic or a quintic polynomial that begins and ends at rest, so no joint overshoots: a motion whose
    ends are within the limits stays within them.
    """
    with traced(body):
        check_lengths(robot.table)
    units = robot.joint_units
    start, end = (
        values_in_radians(values, units, field)
        for values, field in ((body.start, "start"), (body.end, "end"))
    )
    found = joint_trajectory(start, end, duration=body.duration, samples=body.samples, scaling=body.scaling)
    outward = np.array([1.0 / unit for unit in units])
    return TrajectoryAnswer(
        **robot.units,
        times=found.times.tolist(),
        positions=(found.positions * outward).tolist(),
        velocities=(found.velocities * outward).tolist(),
        accelerations=(found.accelerations * outward).tolist(),
        path=end_poses(robot.table, found.positions)[:, :3, 3].tolist(),
    )
