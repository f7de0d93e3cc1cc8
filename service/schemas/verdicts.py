"""Policies and verdicts on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from exercises.grading import (
    BaseRule,
    Basis,
    ConventionRule,
    DirectionRule,
    Finding,
    HelpLevel,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
)
from service.schemas.base import Matrix4, Real, Wire
from service.schemas.tables import Units

Help = Annotated[
    HelpLevel,
    Field(
        strict=False,
        description="how much a verdict on a wrong answer tells; each level includes the ones before",
    ),
]
Share = Annotated[float, Field(strict=True, gt=0, le=0.1, allow_inf_nan=False)]
_TOLERANCE = Tolerance()


class ToleranceModel(Wire):
    """How far two tables may be apart and still count as the same."""

    length: Share = Field(_TOLERANCE.length, description="position, as a fraction of the robot's size")
    angle: Share = Field(_TOLERANCE.angle, description="rotation [rad]")


class PolicyModel(Wire):
    """What a table is held to, beyond being the same mechanism."""

    convention: Annotated[ConventionRule, Field(strict=False)] = Field(
        ConventionRule.ANY, description="convention of the submission"
    )
    base: Annotated[BaseRule, Field(strict=False)] = Field(
        BaseRule.FREE, description="where frame 0 must lie"
    )
    tool: Annotated[ToolRule, Field(strict=False)] = Field(
        ToolRule.FREE, description="where frame N must lie"
    )
    zero: Annotated[ZeroRule, Field(strict=False)] = Field(
        ZeroRule.FREE, description="where the joint variables are zero"
    )
    direction: Annotated[DirectionRule, Field(strict=False)] = Field(
        DirectionRule.FREE, description="which way the joint variables count"
    )
    tolerance: ToleranceModel = ToleranceModel()

    def policy(self) -> Policy:
        """The policy as the grader takes it."""
        return Policy(
            convention=self.convention,
            base=self.base,
            tool=self.tool,
            zero=self.zero,
            direction=self.direction,
            tolerance=Tolerance(length=self.tolerance.length, angle=self.tolerance.angle),
        )


class FeedbackModel(Wire):
    """One thing to tell the student."""

    code: str = Field(description="stable identifier, in snake_case")
    row: int | None = Field(description="the row of the submission that it speaks of, counted from 1")
    params: dict[str, str | int | float | list[str] | list[int]] = Field(
        description="the values in the message"
    )
    message: str = Field(description="the sentence, in the caller's language")


class EditModel(FeedbackModel):
    """One misconception, and where."""

    cell: str | None = Field(description="alpha, a, d, theta or joint, if it concerns one cell")


class RepairModel(Wire):
    """Edits that together make the submission right."""

    edits: list[EditModel]


class LinkModel(Wire):
    """What was found of one row."""

    row: int = Field(description="counted from 1; a missing row has the number that it should have")
    length: Finding
    twist: Finding
    offset: Finding
    joint: Finding


class ExactModel(Wire):
    """A certificate in closed form."""

    joint_offsets: list[str]
    base: list[list[str]]
    tool: list[list[str]]


class CertificateModel(Wire):
    """(σ, δ, B, E) with F_submission(σ∘q + δ) = B · F_reference(q) · E for all q."""

    joint_signs: list[int]
    joint_offsets: list[Real] = Field(description="in the submission's units")
    base: Matrix4
    tool: Matrix4
    exact: ExactModel | None
    parameters: dict[str, Real] = Field(
        description="values of the parameters for which the numbers above hold, in the submission's units"
    )
    residual: Real = Field(
        description="largest difference of the two sides at any configuration, in rad or relative to the size"
    )
    samples: int = Field(description="configurations at which the two sides were compared")


class VerdictModel(Units):
    """What the grader says of a table."""

    correct: bool
    score: Real = Field(ge=0, le=1)
    basis: Basis
    certificate: CertificateModel | None
    links: list[LinkModel]
    feedback: list[FeedbackModel]
    repairs: list[RepairModel]
