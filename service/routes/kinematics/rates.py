"""Velocities, accelerations and forces at one configuration."""

from __future__ import annotations

from typing import Annotated, Any

from kinematics.chain import chain_of_table
from kinematics.ellipsoids import Ellipsoid, VelocityEllipsoids, velocity_ellipsoids
from kinematics.inverse.lengths import check_lengths
from kinematics.rates import ROLL_PITCH_YAW, analytic_jacobian, jacobian_rate, joint_forces
from kinematics.se3 import check_transform
from service.http.openapi import body_with
from service.http.routing import api_router
from service.resources import AppResources
from service.schemas.kinematics.rates_request import RatesAnswer, RatesRequest
from service.wire.fault_pointers import traced
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.pose_matrices import base_and_tool

router = api_router("kinematics")

_EXAMPLES: dict[str, Any] = {
    "a SCARA that turns both links, and a load of 10 N at its tool": {
        "robot": "scara",
        "joints": [0.3, 0.6, 0.1, 0],
        "rates": [1, -0.5, 0, 0],
        "wrench": [0, 0, -10, 0, 0, 0],
    }
}


@router.post("/rates", summary="Velocities, accelerations and forces at one configuration")
async def rates(body: Annotated[RatesRequest, body_with(_EXAMPLES)], resources: AppResources) -> RatesAnswer:
    """Return (v, ω) = J0 q̇, J0 q̈ + J̇0 q̇, the analytic Jacobian, τ = J0ᵀ (f, m) and ellipsoids.

    Results that need missing `rates`, `accelerations` or `wrench` are null. Lengths are in the table's unit.
    """
    robot = resources.robots.prepare(body)
    with traced(body):
        check_lengths(robot.table)
    base, tool = (
        None if pose is None else check_transform(pose, where=(name,))
        for pose, name in zip(base_and_tool(body, robot.angle), ("base", "tool"), strict=True)
    )
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
        found["joint_forces"] = _plain(joint_forces(chain, q, body.wrench))
    return RatesAnswer.model_validate({**found, **robot.units})


def _ellipsoids(found: VelocityEllipsoids) -> dict[str, Any]:
    def written(ellipsoid: Ellipsoid) -> dict[str, Any]:
        return {"axes": _plain(ellipsoid.axes), "radii": _plain(ellipsoid.radii)}

    return {
        "translation": written(found.translation),
        "rotation": written(found.rotation),
        "blocked": _plain(found.blocked),
        "characteristic_length": found.length,
    }


def _plain(values: Any) -> Any:
    return None if values is None else plain_lists(values)
