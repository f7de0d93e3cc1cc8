"""POST /check-dynamics on the wire."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field

from kinematics.answers.dynamics_answers import TOLERANCE, DynamicsMistake
from kinematics.symbolic import ProofStatus
from service.schemas.base import Real, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.dynamics_request import DYNAMICS, WeighedRobot
from service.schemas.kinematics.robot_question import NO_ROBOT
from service.schemas.tables import Cell, Units

EquationRow = Annotated[list[Cell], Field(max_length=16)]
EquationRows = Annotated[list[EquationRow], Field(max_length=16)]


class CheckDynamicsRequest(WeighedRobot):
    """A robot with weights, and equations of motion that somebody wrote as functions of q and dq1 … dqn."""

    model_config = forbidding(*NO_ROBOT, together(without=["M", "C", "h", "g"]))

    M: EquationRows | None = Field(None, description="n×n expressions: the mass matrix")
    C: EquationRows | None = Field(None, description="n×n expressions: any C with the right C q̇")
    h: EquationRow | None = Field(None, description="C q̇; beside C, both are judged")
    g: EquationRow | None = Field(None, description="gravity terms")
    tolerance: Annotated[Real, Field(gt=0, le=0.1)] = Field(
        TOLERANCE, description="of an entry that is not proved, as a share of its size"
    )


class DynamicsMistakeModel(Wire):
    """A slip that explains a wrong answer."""

    code: DynamicsMistake
    message: str = Field(description="the same in the caller's language")


class CheckDynamicsAnswer(Units):
    """Whether equations of motion are those of the robot."""

    correct: bool = Field(description="all that was given is right, skew-symmetry aside")
    proof: ProofStatus = Field(
        description="proved: the same functions; undecided: equal where compared; refuted: some differ"
    )
    M: list[list[bool]] | None = Field(description="which entries of M are right; null if there was none")
    h: list[bool] | None = Field(description="which rows of C q̇ are right; null if there was neither C nor h")
    skew: bool | None = Field(description="whether Ṁ − 2C is skew-symmetric; null without C")
    g: list[bool] | None = Field(description="which entries of g are right; null if there was none")
    mistakes: list[DynamicsMistakeModel] = Field(description="the usual slips that explain a wrong answer")


_TWO_LINKS = DYNAMICS["two links in a vertical plane, let go"]

CHECK_DYNAMICS: dict[str, Any] = {
    "two links: a C that is right, but not of Christoffel symbols": {
        "table": _TWO_LINKS["table"],
        "links": _TWO_LINKS["links"],
        "parameters": {**_TWO_LINKS["parameters"], "g": 9.81},
        "gravity": [0, "-g", 0],
        "C": [["-2*m2*L1*r2*s2*dq2", "-m2*L1*r2*s2*dq2"], ["m2*L1*r2*s2*dq1", 0]],
        "g": ["(m1*r1 + m2*L1)*g*c1 + m2*r2*g*c12", "m2*r2*g*c12"],
    }
}
