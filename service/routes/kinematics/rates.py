"""POST /rates: velocities, accelerations and forces at one configuration."""

from typing import Any

from pydantic import Field

from kinematics.chain import chain_of_table
from kinematics.ellipsoids import Ellipsoid, VelocityEllipsoids, velocity_ellipsoids
from kinematics.inverse.lengths import check_lengths, check_near
from kinematics.rates import ROLL_PITCH_YAW, analytic_jacobian, jacobian_rate, joint_forces
from kinematics.se3 import check_transform
from service.http.calls import CallRouter
from service.schemas.base import Matrix6, Real, Vector3, Vector6, Wire
from service.schemas.kinematics.orientations import RatesOfAngles
from service.schemas.kinematics.robot_question import PlacedRobotQuestion
from service.schemas.tables import Units
from service.wire.fault_pointers import traced
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.pose_matrices import base_and_tool
from service.wire.kinematics.prepared_robots import PreparedRobot


class RatesRequest(PlacedRobotQuestion):
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
        None,
        description="force that the arm exerts at the end frame's origin, then moment, in the world's axes",
    )
    angles: RatesOfAngles | None = Field(
        None, description="whose rates `analytic` has; roll, pitch, yaw (X, Y, Z, fixed axes) if left out"
    )


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


router = CallRouter("kinematics")


@router.call("/rates", "Velocities, accelerations and forces at one configuration")
def rates(body: RatesRequest, robot: PreparedRobot) -> RatesAnswer:
    """Return (v, ω) = J0 q̇, J0 q̈ + J̇0 q̇, the analytic Jacobian, τ = J0ᵀ (f, m) and ellipsoids.

    Results that need missing `rates`, `accelerations` or `wrench` are null. Lengths are in the table's unit.
    """
    with traced(body):
        check_lengths(robot.table)
    base, tool = (
        None if pose is None else check_transform(pose, where=(name,))
        for pose, name in zip(base_and_tool(body, robot.angle), ("base", "tool"), strict=True)
    )
    for pose, name in ((base, "base"), (tool, "tool")):
        if pose is not None:
            check_near(pose, name)
    chain = chain_of_table(robot.table, base, tool)
    q = values_in_radians(body.joints, robot.joint_units, "joints")
    J = chain.jacobian(q)
    angles = ROLL_PITCH_YAW if body.angles is None else body.angles.sequence()
    found: dict[str, Any] = {
        "J0": _plain(J),
        "analytic": _plain(analytic_jacobian(chain, q, angles)),
        "ellipsoids": _ellipsoids(velocity_ellipsoids(robot.table, q, base=base, tool=tool)),
    }
    if body.rates is not None:
        speeds = values_in_radians(body.rates, robot.joint_units, "rates")
        rate = jacobian_rate(chain, q, speeds)
        found |= {"velocity": _plain(J @ speeds), "J0_rate": _plain(rate)}
    if body.accelerations is not None:
        second = values_in_radians(body.accelerations, robot.joint_units, "accelerations")
        at_speed = 0.0 if body.rates is None else rate @ speeds
        found["acceleration"] = _plain(J @ second + at_speed)
    if body.wrench is not None:
        wrench = values_in_radians(body.wrench, [1.0] * len(body.wrench), "wrench")
        found["joint_forces"] = _plain(joint_forces(chain, q, wrench))
    return RatesAnswer(**robot.units, **found)


def _ellipsoids(found: VelocityEllipsoids) -> EllipsoidsModel:
    def written(ellipsoid: Ellipsoid) -> EllipsoidModel:
        return EllipsoidModel(axes=_plain(ellipsoid.axes), radii=_plain(ellipsoid.radii))

    return EllipsoidsModel(
        translation=written(found.translation),
        rotation=written(found.rotation),
        blocked=_plain(found.blocked),
        characteristic_length=found.length,
    )


def _plain(values: Any) -> Any:
    return None if values is None else plain_lists(values)
