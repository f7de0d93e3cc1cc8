"""POST /check-jacobian-form on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.answers.screw_answers import ScrewOrder
from kinematics.jacobian import JacobianFrame
from kinematics.symbolic import ProofStatus
from service.schemas.base import Real
from service.schemas.checks.jacobian_answers import JacobianMistakeModel
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.robot_question import NO_ROBOT, RobotQuestion
from service.schemas.kinematics.rotations import RatesOfAngles
from service.schemas.tables import Cell, Units

FormRow = Annotated[list[Cell], Field(max_length=16)]


class CheckJacobianFormRequest(RobotQuestion):
    """A table, with a Jacobian or joint forces that somebody wrote as functions of q1 … qn."""

    model_config = forbidding(
        *NO_ROBOT,
        together(without=["jacobian", "joint_forces"]),
        together("joint_forces", without=["wrench"]),
    )

    jacobian: Annotated[list[FormRow], Field(min_length=6, max_length=6)] | None = Field(
        None, description="6×n expressions, per radian, of the last frame's origin; c12 is cos(q1 + q2)"
    )
    order: Annotated[ScrewOrder, Field(strict=False)] = Field(
        ScrewOrder.LINEAR_FIRST, description="which rows of the Jacobian stand first"
    )
    frame: Annotated[JacobianFrame, Field(strict=False)] = Field(
        JacobianFrame.BASE, description="in whose axes Jacobian and wrench are: frame 0 or the last frame"
    )
    angles: RatesOfAngles | None = Field(
        None, description="of the analytic Jacobian, in frame 0; left out: the geometric one"
    )
    wrench: Annotated[list[Cell], Field(min_length=6, max_length=6)] | None = Field(
        None, description="force and moment at the last frame's origin: numbers, or fx, fy, fz, mx, my, mz"
    )
    joint_forces: FormRow | None = Field(None, description="τ = Jᵀ · wrench, one expression for each joint")
    tolerance: Annotated[Real, Field(gt=0, le=0.1)] = Field(
        0.005, description="of an entry that is not proved; of a length as a share of the robot's size"
    )


class CheckJacobianFormAnswer(Units):
    """Whether closed forms are those of the table."""

    correct: bool
    proof: ProofStatus = Field(
        description="proved: the same functions; undecided: equal where compared; refuted: they differ, if "
        "only by what the tolerance allows"
    )
    entries: list[list[bool]] | None = Field(
        description="which entries of the Jacobian are right, linear rows first; null if there was none"
    )
    forces: list[bool] | None = Field(description="which joint forces are right; null if there were none")
    mistakes: list[JacobianMistakeModel] = Field(description="the usual slips that explain a wrong answer")
