"""POST /check-screws on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.answers.screw_answers import ScrewFrame, ScrewMistake, ScrewOrder
from service.schemas.base import Matrix4, OneOf, Real, Wire
from service.schemas.exercises.verdicts import PolicyModel
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.tables import Units

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
    mistakes: list[ScrewMistakeModel] = Field(description="the usual slips that explain a wrong answer")
