"""POST /trajectory on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.trajectory import TimeScaling
from service.schemas.base import WHOLE, OneOf, Real, Vector3
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.tables import Units

MOST_INSTANTS = 1000
"""Instants of one motion: finer than a plot or an animation of some seconds shows."""

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
