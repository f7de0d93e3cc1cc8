"""POST /check-jacobian and POST /check-jacobian-form on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.answers.jacobian_answers import JacobianMistake
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.jacobian import JacobianFrame
from kinematics.symbolic import ProofStatus
from service.schemas.base import OneOf, Real, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.rates_request import Vector6
from service.schemas.kinematics.robot_question import NO_ROBOT, RobotQuestion
from service.schemas.kinematics.rotations import RatesOfAngles
from service.schemas.spoken import feedback_sentence
from service.schemas.tables import Cell, Units

Columns = Annotated[list[Real], Field(max_length=64)]
FormRow = Annotated[list[Cell], Field(max_length=16)]


class JacobianCheck(RobotQuestion):
    """A robot, and which Jacobian of it was meant."""

    model_config = forbidding(
        *NO_ROBOT,
        together(without=["jacobian", "joint_forces"]),
        together("joint_forces", without=["wrench"]),
    )

    order: OneOf[ScrewOrder] = Field(
        ScrewOrder.LINEAR_FIRST, description="which rows of the Jacobian stand first"
    )
    frame: OneOf[JacobianFrame] = Field(
        JacobianFrame.BASE, description="in whose axes Jacobian and wrench are: frame 0 or the last frame"
    )
    angles: RatesOfAngles | None = Field(
        None, description="of the analytic Jacobian, in frame 0; left out: the geometric one"
    )


class CheckJacobianRequest(JacobianCheck):
    """A table at one configuration, with a Jacobian or joint forces that somebody computed from it."""

    joints: list[Real] = Field(max_length=64, description="q_1 … q_n, in the table's units")
    jacobian: Annotated[list[Columns], Field(min_length=6, max_length=6)] | None = Field(
        None, description="6×n, per radian, of the last frame's origin"
    )
    wrench: Vector6 | None = Field(None, description="force and moment at the last frame's origin")
    joint_forces: Columns | None = Field(None, description="τ = Jᵀ · wrench, one for each joint")
    tolerance: Annotated[Real, Field(gt=0, le=0.1)] = Field(
        0.005, description="of an entry; of a length as a share of the robot's size"
    )


class CheckJacobianFormRequest(JacobianCheck):
    """A table, with a Jacobian or joint forces that somebody wrote as functions of q1 … qn."""

    jacobian: Annotated[list[FormRow], Field(min_length=6, max_length=6)] | None = Field(
        None, description="6×n expressions, per radian, of the last frame's origin; c12 is cos(q1 + q2)"
    )
    wrench: Annotated[list[Cell], Field(min_length=6, max_length=6)] | None = Field(
        None, description="force and moment at the last frame's origin: numbers, or fx, fy, fz, mx, my, mz"
    )
    joint_forces: FormRow | None = Field(None, description="τ = Jᵀ · wrench, one expression for each joint")
    tolerance: Annotated[Real, Field(gt=0, le=0.1)] = Field(
        0.005, description="of an entry that is not proved; of a length as a share of the robot's size"
    )


class JacobianMistakeModel(Wire):
    """What a wrong answer looks like."""

    code: JacobianMistake
    joint: int | None = Field(description="the column it is about, from 1; null: all of them")
    message: str = Field(description="the sentence, in the caller's language")


def jacobian_mistake(
    what: str, mistake: JacobianMistake, joint: int | None, language: str
) -> JacobianMistakeModel:
    """Return a mistake in a Jacobian or in joint forces (`what`), with its sentence."""
    columns = () if joint is None else (str(joint),)
    told = feedback_sentence(
        f"{what}_{mistake.value}",
        language,
        {"joint": joint or 0, "joints": columns, "count": len(columns)},
    )
    return JacobianMistakeModel(code=mistake, joint=joint, message=told)


class CheckJacobianAnswer(Units):
    """Whether a Jacobian and joint forces are those of the table."""

    correct: bool
    entries: list[list[bool]] | None = Field(
        description="which entries of the Jacobian are right, linear rows first; null if there was none"
    )
    forces: list[bool] | None = Field(description="which joint forces are right; null if there were none")
    mistakes: list[JacobianMistakeModel] = Field(description="the usual slips that explain a wrong answer")


class CheckJacobianFormAnswer(CheckJacobianAnswer):
    """Whether closed forms are those of the table."""

    proof: ProofStatus = Field(
        description="proved: the same functions; undecided: equal where compared; refuted: they differ, if "
        "only by what the tolerance allows"
    )
