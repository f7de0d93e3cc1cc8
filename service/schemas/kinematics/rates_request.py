"""POST /rates on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from service.schemas.base import Real, Vector3, Wire
from service.schemas.kinematics.jacobian_request import Matrix6
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.kinematics.rotations import RatesOfAngles
from service.schemas.tables import Units

Vector6 = Annotated[list[Real], Field(min_length=6, max_length=6)]


class RatesRequest(RobotQuestion):
    """A robot at one configuration, and what moves or pushes it."""

    joints: list[Real] = Field(max_length=64, description="q_1 … q_n, in the table's units")
    rates: list[Real] | None = Field(
        None, max_length=64, description="q̇_1 … q̇_n, in the table's units per second"
    )
    accelerations: list[Real] | None = Field(
        None,
        max_length=64,
        description="q̈_1 … q̈_n, in the table's units per second squared; from rest without rates",
    )
    wrench: Vector6 | None = Field(
        None, description="force at the end frame's origin, then moment, in the axes of the world"
    )
    angles: RatesOfAngles | None = Field(
        None, description="whose rates `analytic` has; roll, pitch, yaw (X, Y, Z, fixed axes) if left out"
    )
    base: PoseInput | None = Field(None, description="pose of frame 0 in the world; the identity if left out")
    tool: PoseInput | None = Field(None, description="pose of the tool in frame N; the identity if left out")


class EllipsoidModel(Wire):
    """A velocity ellipsoid about the end frame's origin."""

    axes: list[Vector3] = Field(description="unit vectors in the axes of the world, the longest radius first")
    radii: list[Real] = Field(description="along these; 0 where the tool cannot move that way")


class EllipsoidsModel(Wire):
    """What the tool does while the joint rates go through the unit ball."""

    translation: EllipsoidModel = Field(description="of v")
    rotation: EllipsoidModel = Field(description="of ω")
    blocked: list[Vector6] = Field(
        description="unit vectors (v / characteristic_length, ω) that span what the tool cannot do here"
    )
    characteristic_length: Real = Field(
        description="sum of |a| and |d|: a prismatic joint's rate counts in it, a revolute one's in radians"
    )


class RatesAnswer(Units):
    """Jacobians, velocities and forces at one configuration, in the axes of the world, per radian."""

    J0: Matrix6 = Field(description="(v, ω) = J0 q̇")
    analytic: Matrix6 | None = Field(
        description="rates of x, y, z and the three angles (roll, pitch, yaw if none were named) per rate of "
        "each joint; null where the first and the last angle turn about one line (pitch ±90°)"
    )
    velocity: Vector6 | None = Field(None, description="(v, ω), ω in radians per second")
    J0_rate: Matrix6 | None = Field(None, description="dJ0/dt at these rates")
    acceleration: Vector6 | None = Field(None, description="J0 q̈ + dJ0/dt q̇")
    joint_forces: list[Real] | None = Field(
        None, description="J0ᵀ · wrench: torques of revolute joints, forces of prismatic ones"
    )
    ellipsoids: EllipsoidsModel = Field(
        description="Yoshikawa's manipulability ellipsoids, and what is blocked"
    )
