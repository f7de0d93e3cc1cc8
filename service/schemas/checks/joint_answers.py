"""POST /check-inverse-kinematics on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.answers.joint_questions import USUAL_TOLERANCE
from kinematics.answers.joint_verdicts import JointClaim
from service.schemas.base import Matrix4, OneOf, Real, Wire
from service.schemas.kinematics.joints import JointRanges
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.spoken import SpokenFeedback
from service.schemas.tables import Table, Units

Configuration = Annotated[list[Real], Field(max_length=12)]


class CheckInverseKinematicsRequest(RobotQuestion):
    """A robot, a pose, and the joint values that somebody says reach it."""

    target: PoseInput = Field(description="the pose of the last frame in frame 0")
    claim: OneOf[JointClaim] = Field(
        JointClaim.FINITE,
        description="finite or infinite (many solutions), out_of_reach or joint_limits (none)",
    )
    solutions: Annotated[list[Configuration], Field(max_length=64)] = Field(
        default_factory=list, description="rows of joint values, in the units of the table they belong to"
    )
    combinations: Annotated[list[Configuration], Field(max_length=16)] = Field(
        default_factory=list,
        description="of a family of solutions, coefficients of a combination of joint values that is fixed",
    )
    every: bool = Field(True, description="all solutions are asked; false: one")
    position_only: bool = Field(False, description="only the position of the last origin has to be reached")
    limits: JointRanges | None = None
    own: Table | None = Field(
        None, description="the answerer's own table: joint values and pose are then those of its frames"
    )
    tolerance: Annotated[Real, Field(gt=0, le=0.01)] = Field(
        USUAL_TOLERANCE, description="of positions as a share of the robot's size, and of angles [rad]"
    )


class JointRowVerdict(Wire):
    """What is said of one row."""

    correct: bool
    solution: int | None = Field(description="which solution it is, counted from 0; null if it is wrong")


class CheckInverseKinematicsAnswer(Units):
    """Whether joint values reach a pose, and whether all are there."""

    correct: bool
    score: Real = Field(ge=0, le=1)
    expected: JointClaim | None = Field(
        description="what is true of the pose; null if `own` is another robot"
    )
    complete: bool = Field(
        description="judged by a set that is known to be all; false: by what a search found"
    )
    rows: list[JointRowVerdict]
    combinations: list[bool] = Field(description="which combinations hold along a family")
    own_accepted: bool | None = Field(description="whether `own` describes this robot; null without it")
    base: Matrix4 | None = Field(description="of the certificate, B in T_own = B · T · E")
    tool: Matrix4 | None = Field(description="of the certificate, E")
    feedback: list[SpokenFeedback]
