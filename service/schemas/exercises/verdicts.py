"""Policies and verdicts on the wire."""

from typing import Annotated

from pydantic import Field

from exercises.grading import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    HelpLevel,
    Policy,
    Tolerance,
    ToolRule,
    Verdict,
    ZeroRule,
)
from service.schemas.base import OneOf, Share, Wire
from service.schemas.derived import model_of

Help = Annotated[
    HelpLevel,
    Field(
        strict=False,
        description="how much a verdict on a wrong answer tells; each level includes the ones before",
    ),
]
_TOLERANCE = Tolerance()


class ToleranceModel(Wire):
    """How far two tables may be apart and still count as the same."""

    length: Share = Field(_TOLERANCE.length, description="position, as a fraction of the robot's size")
    angle: Share = Field(_TOLERANCE.angle, description="rotation [rad]")


class PolicyModel(Wire):
    """What a table is held to, beyond being the same mechanism."""

    convention: OneOf[ConventionRule] = Field(ConventionRule.ANY, description="convention of the submission")
    base: OneOf[BaseRule] = Field(BaseRule.FREE, description="where frame 0 must lie")
    tool: OneOf[ToolRule] = Field(ToolRule.FREE, description="where frame N must lie")
    zero: OneOf[ZeroRule] = Field(ZeroRule.FREE, description="where the joint variables are zero")
    direction: OneOf[DirectionRule] = Field(
        DirectionRule.FREE, description="which way the joint variables count"
    )
    tolerance: ToleranceModel = ToleranceModel()

    def policy(self) -> Policy:
        """Return the policy as the grader takes it."""
        return Policy(
            convention=self.convention,
            base=self.base,
            tool=self.tool,
            zero=self.zero,
            direction=self.direction,
            tolerance=Tolerance(length=self.tolerance.length, angle=self.tolerance.angle),
        )


VerdictModel = model_of(Verdict)
