"""Products of exponentials that somebody says are a robot."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

import numpy as np

from kinematics.answers.screw_answers import ScrewAnswer, ScrewOrder, judge_screws
from kinematics.errors import DescriptionError, Fault
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, api_router
from service.schemas import examples
from service.schemas.checks.screw_answers import CheckScrewsAnswer, CheckScrewsRequest, ScrewMistakeModel
from service.schemas.spoken import feedback_sentence
from service.wire.fault_pointers import traced
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.prepared_robots import PreparedRobot

router = api_router("kinematics")

LARGEST = 1e6
"""Numbers beyond this are no screws of a robot in any unit: squares of them would not be told apart."""

_EXAMPLES: dict[str, Any] = {
    "two links, the second axis the other way round": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "screws": [[0, 0, 0, 0, 0, 1], [0, 0.5, 0, 0, 0, -1]],
        "home": [[1, 0, 0, 0.8], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
    }
}


@router.post(
    "/check-screws", summary="Are these screws and this home pose the robot?", responses=problems(503)
)
async def check_screws(
    body: Annotated[CheckScrewsRequest, body_with(_EXAMPLES)], request: ApiRequest
) -> CheckScrewsAnswer:
    """Judge screws: either sense of an axis, any point on it, any zero, space or body, any prismatic length.

    A right answer comes with its certificate, a wrong one with the slip that explains it, if one does.
    """
    resources = request.resources
    robot = await request.in_turn(partial(resources.robots.prepare, body))
    work = partial(_checked, body, robot, language_of(request))
    return await resources.grading.run(work)


def _checked(body: CheckScrewsRequest, robot: PreparedRobot, language: str) -> CheckScrewsAnswer:
    n = len(robot.table.joint_types)
    if len(body.screws) != n:
        params = {"expected": n, "given": len(body.screws)}
        raise DescriptionError(Fault.at("screw_count", "screws", **params))
    pose = pose_matrix(body.home, robot.angle, "home")
    if len(pose) != 4 or any(len(row) != 4 for row in pose):
        raise DescriptionError(Fault.at("matrix_not_4x4", "home"))
    screws, home = np.array(body.screws), np.array(pose)
    for name, values in (("screws", screws), ("home", home)):
        if np.abs(values).max() > LARGEST:
            raise DescriptionError(Fault.at("screw_too_large", name, limit=LARGEST))
    if body.order is ScrewOrder.ANGULAR_FIRST:
        screws = np.hstack([screws[:, 3:], screws[:, :3]])
    with traced(body):
        answer = ScrewAnswer(screws=screws, home=home, frame=body.frame)
        found = judge_screws(robot.table, answer, body.policy.policy())
    certificate = found.certificate
    offsets = certificate and [
        offset / unit for offset, unit in zip(certificate.joint_offsets, robot.joint_units, strict=True)
    ]
    return CheckScrewsAnswer.model_validate(
        {
            **robot.units,
            "correct": found.right,
            "joint_signs": certificate and list(certificate.joint_signs),
            "joint_offsets": offsets,
            "base": certificate and certificate.base.tolist(),
            "tool": certificate and certificate.tool.tolist(),
            "relations": [pair.alike for pair in found.pairs if pair.second == pair.first + 1],
            "mistakes": [
                ScrewMistakeModel(
                    code=mistake,
                    joint=joint,
                    message=feedback_sentence(f"screw_{mistake.value}", language, {"joint": joint or 0}),
                )
                for mistake, joint in found.mistakes
            ],
        }
    )
