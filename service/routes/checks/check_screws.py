"""POST /check-screws: products of exponentials that somebody says are a robot."""

from typing import Annotated

import numpy as np
from pydantic import Field

from exercises.parts.motion.screws import screw_feedback
from kinematics.answers.screw_answers import ScrewAnswer, ScrewFrame, ScrewMistake, ScrewOrder, judge_screws
from kinematics.errors import DescriptionError, Fault
from service.http.calls import CallRouter
from service.schemas.base import Matrix4, OneOf, Real, Wire
from service.schemas.exercises.verdicts import PolicyModel
from service.schemas.kinematics.robot_question import PoseInput, RobotQuestion
from service.schemas.spoken import SpokenFeedback, feedback_sentence, spoken
from service.schemas.tables import Units
from service.wire.fault_pointers import traced
from service.wire.kinematics.joint_values import in_request_units
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.prepared_robots import PreparedRobot

ScrewRowModel = Annotated[list[Real], Field(min_length=6, max_length=6)]


class CheckScrewsRequest(RobotQuestion):
    """A robot, and a product of exponentials that somebody says is the same."""

    screws: Annotated[list[ScrewRowModel], Field(max_length=64)] = Field(
        description="one row for each joint, lengths in the table's unit, per radian"
    )
    home: PoseInput = Field(
        description="M, the pose of the last frame where all joint variables are zero, in the table's units"
    )
    frame: OneOf[ScrewFrame] = Field(
        ScrewFrame.SPACE, description="screws in the fixed frame, or in the tool's at the zero position"
    )
    order: OneOf[ScrewOrder] = Field(ScrewOrder.LINEAR_FIRST, description="which half of a row stands first")
    policy: PolicyModel = PolicyModel()


class ScrewMistakeModel(Wire):
    """What a wrong answer looks like."""

    code: ScrewMistake
    joint: int | None = Field(description="the joint it is about, from 1; null: all of it")
    message: str = Field(description="the sentence, in the caller's language")


class CheckScrewsAnswer(Units):
    """Whether screws and a home pose are the robot: T(σ∘q + δ) = B · F(q) · E."""

    correct: bool
    joint_signs: list[int] | None = Field(description="σ; null for a wrong answer")
    joint_offsets: list[Real] | None = Field(description="δ, in the table's units")
    base: Matrix4 | None = Field(description="B")
    tool: Matrix4 | None = Field(description="E")
    relations: list[bool] = Field(
        description="of a wrong answer: which neighbouring axes lie to each other as the robot's"
    )
    feedback: list[SpokenFeedback] = Field(
        description="whether it is the robot and, if it is but breaks one rule of the policy, which one"
    )
    mistakes: list[ScrewMistakeModel] = Field(description="the usual slips that explain a wrong answer")


router = CallRouter("kinematics")

LARGEST = 1e6
"""Numbers beyond this are no screws of a robot in any unit: squares of them would not be told apart."""


@router.judge("/check-screws", "Are these screws and this home pose the robot?")
def check_screws(body: CheckScrewsRequest, robot: PreparedRobot, language: str) -> CheckScrewsAnswer:
    """Judge screws: either sense of an axis, any point on it, any zero, space or body, any prismatic length.

    A right answer comes with its certificate, a wrong one with the slip that explains it, if one does.
    """
    n = len(robot.table.joint_types)
    if len(body.screws) != n:
        raise DescriptionError(Fault.at("screw_count", "screws", expected=n, given=len(body.screws)))
    pose = pose_matrix(body.home, robot.angle, "home")
    if len(pose) != 4 or any(len(row) != 4 for row in pose):
        raise DescriptionError(Fault.at("matrix_not_4x4", "home"))
    screws, home = np.array([body.order.linear_first(row) for row in body.screws]), np.array(pose)
    for name, values in (("screws", screws), ("home", home)):
        if np.abs(values).max() > LARGEST:
            raise DescriptionError(Fault.at("screw_too_large", name, limit=LARGEST))
    with traced(body):
        answer = ScrewAnswer(screws=screws, home=home, frame=body.frame)
        policy = body.policy.policy()
        found = judge_screws(robot.table, answer, policy)
    certificate = found.certificate
    units = robot.joint_units
    return CheckScrewsAnswer(
        **robot.units,
        correct=found.right,
        joint_signs=None if certificate is None else list(certificate.joint_signs),
        joint_offsets=None if certificate is None else in_request_units(certificate.joint_offsets, units),
        base=None if certificate is None else certificate.base.tolist(),
        tool=None if certificate is None else certificate.tool.tolist(),
        relations=[pair.alike for pair in found.pairs if pair.second == pair.first + 1],
        feedback=spoken(screw_feedback(found, policy), language),
        mistakes=[
            ScrewMistakeModel(
                code=mistake,
                joint=joint,
                message=feedback_sentence(f"screw_{mistake.value}", language, {"joint": joint or 0}),
            )
            for mistake, joint in found.mistakes
        ],
    )
