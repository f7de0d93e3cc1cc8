"""Jacobians and joint forces that somebody computed."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

import numpy as np

from kinematics.answers.jacobian_answers import JacobianMistake, judge_forces, judge_jacobian
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.chain import chain_of_table
from kinematics.inverse.lengths import check_lengths
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, api_router
from service.schemas import examples
from service.schemas.checks.jacobian_answers import (
    CheckJacobianAnswer,
    CheckJacobianRequest,
    jacobian_mistake,
)
from service.wire.checks.answer_functions import angles_of_jacobian, check_count
from service.wire.fault_pointers import traced
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.prepared_robots import PreparedRobot

router = api_router("kinematics")

_EXAMPLES: dict[str, Any] = {
    "two links: the second column with p₁ − p₂": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "joints": [0, 1.5707963267948966],
        "jacobian": [[-0.3, 0.3], [0.5, 0], [0, 0], [0, 0], [0, 0], [1, 1]],
    },
    "two links: the torques that hold 10 N": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "joints": [0, 0],
        "wrench": [0, 10, 0, 0, 0, 0],
        "joint_forces": [8, 3],
    },
}


@router.post(
    "/check-jacobian",
    summary="Are this Jacobian and these joint forces those of the table?",
    responses=problems(400, 413, 415, 422),
)
async def check_jacobian(
    body: Annotated[CheckJacobianRequest, body_with(_EXAMPLES)],
    request: ApiRequest,
) -> CheckJacobianAnswer:
    """Return the Jacobian of the last frame's origin, in either order of the rows, and τ = Jᵀ (f, m).

    Geometric, in either axes, or analytic for one of the 24 sequences of angles.
    The table is the answerer's own: whether it is the robot's is asked of `/grade`. Columns that the usual
    slips would make are named.
    """
    robot = await request.in_turn(partial(request.resources.robots.prepare, body))
    return await request.in_turn(partial(_checked, body, robot, language_of(request)))


def _checked(body: CheckJacobianRequest, robot: PreparedRobot, language: str) -> CheckJacobianAnswer:
    with traced(body):
        check_lengths(robot.table)
    n = len(robot.joint_units)
    joints = values_in_radians(body.joints, robot.joint_units, "joints")
    angles = angles_of_jacobian(body)
    for i, row in enumerate(body.jacobian or ()):
        check_count(row, n, ("jacobian", i))
    if body.joint_forces is not None:
        check_count(body.joint_forces, n, ("joint_forces",))
    chain = chain_of_table(robot.table)
    entries, forces, correct = None, None, True
    mistakes: list[tuple[str, JacobianMistake, int | None]] = []
    if body.jacobian is not None:
        given = np.array(body.jacobian, dtype=np.float64)
        if body.order is ScrewOrder.ANGULAR_FIRST:
            given = np.vstack([given[3:], given[:3]])
        found = judge_jacobian(chain, joints, given, body.frame, body.tolerance, angles)
        entries, correct = found.entries.tolist(), found.right
        mistakes += [("jacobian", mistake, joint) for mistake, joint in found.mistakes]
    if body.joint_forces is not None and body.wrench is not None:
        right, mistake = judge_forces(
            chain, joints, body.wrench, body.joint_forces, body.frame, body.tolerance
        )
        forces, correct = list(right), correct and all(right)
        mistakes += [("forces", mistake, None)] if mistake is not None else []
    return CheckJacobianAnswer.model_validate(
        {
            **robot.units,
            "correct": correct,
            "entries": entries,
            "forces": forces,
            "mistakes": [jacobian_mistake(*entry, language) for entry in mistakes],
        }
    )
