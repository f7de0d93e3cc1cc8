"""Joint values that somebody says reach a pose."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, api_router
from service.schemas import examples
from service.schemas.checks.joint_answers import CheckInverseKinematicsAnswer, CheckInverseKinematicsRequest
from service.wire.checks.joint_checks import checked_joints

router = api_router("kinematics")

_EXAMPLES: dict[str, Any] = {
    "two links, one of the two elbows": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "target": [[1, 0, 0, 0.5], [0, 1, 0, 0.3], [0, 0, 1, 0], [0, 0, 0, 1]],
        "position_only": True,
        "solutions": [[0, 1.5707963]],
    },
    "out of reach": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "target": [[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
        "claim": "out_of_reach",
    },
}


@router.post(
    "/check-inverse-kinematics",
    summary="Do these joint values reach the pose, and are they all?",
    responses=problems(400, 413, 415, 422, 503),
)
async def check_inverse_kinematics(
    body: Annotated[CheckInverseKinematicsRequest, body_with(_EXAMPLES)],
    request: ApiRequest,
) -> CheckInverseKinematicsAnswer:
    """Judge each row by forward kinematics, up to full turns, and the rows together by the complete set.

    For a singular pose, the answer must give the combination of joint values that is fixed on the family.
    With `own`, joint values and pose refer to the answerer's own table, and the certificate (σ, δ, B, E) of
    that table converts them. Missing branches and wrong quadrants are named.
    """
    robot = await request.in_turn(partial(request.resources.robots.prepare, body))
    return await checked_joints(body, robot, request)
