"""POST /check-singularities on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.answers.singularity_answers import ConditionStatus
from kinematics.symbolic import ProofStatus
from kinematics.symbolic.determinants import MotionRows
from service.schemas.base import OneOf, Real, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.robot_question import NO_ROBOT, RobotQuestion
from service.schemas.tables import Cell, Units


class CheckSingularitiesRequest(RobotQuestion):
    """A table, with conditions for its singularities, or a motion that it is said to have lost."""

    model_config = forbidding(
        *NO_ROBOT, together(without=["conditions", "lost"]), together("lost", without=["joints"])
    )

    motion: OneOf[MotionRows] = Field(
        MotionRows.TWIST, description="which rows of the Jacobian count: all, or those of the velocity"
    )
    conditions: Annotated[list[Cell], Field(max_length=16)] | None = Field(
        None, description="functions that vanish (sin(q3)) or equations (q3 = 0, π), in any number and order"
    )
    joints: Annotated[list[Real], Field(max_length=64)] | None = Field(
        None, description="a singular configuration, for `lost`; in the table's units"
    )
    lost: Annotated[list[Real], Field(min_length=3, max_length=6)] | None = Field(
        None,
        description="λ with λ · J q̇ = 0 for all q̇, in frame 0 at the last origin: three numbers of a "
        "translation, else six",
    )


class ConditionModel(Wire):
    """What is said of a condition."""

    number: int = Field(description="which of the conditions, from 1")
    status: ConditionStatus
    example: list[float] | None = Field(
        description="of an invented one a configuration where it holds and the arm is not singular"
    )
    message: str | None = Field(description="the sentence, in the caller's language; null of a right one")


class SingularFamilyModel(Wire):
    """A family of singular configurations."""

    found: float = Field(description="share of it where the conditions hold: 1 if all of it")
    example: list[float] | None = Field(
        description="a configuration of it; where a part is missing one in which none of the conditions holds"
    )


class CheckSingularitiesAnswer(Units):
    """Whether conditions hold just where the arm is singular."""

    correct: bool
    proof: ProofStatus | None = Field(
        description="of the conditions: proved: the sets are the same; undecided: they are where compared; "
        "refuted: they are not; null if none were given"
    )
    whole: bool = Field(
        description="whether the families are all: false of an arm that may be singular elsewhere, too, "
        "where two equations hold at a time"
    )
    conditions: list[ConditionModel]
    families: list[SingularFamilyModel]
    lost: bool | None = Field(description="whether λ is a motion that is lost; null if none was given")
