"""POST /inverse-kinematics on the wire."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from kinematics.inverse.results import IKStatus, Isolation, Method, UnreachableReason
from service.schemas.base import FaultEntry, Matrix4, Real, Vector3, Wire
from service.schemas.choices import forbidding, not_one_of, together
from service.schemas.kinematics.robot_question import (
    NO_ROBOT,
    JointRanges,
    NumericForm,
    PlacedRobotQuestion,
    PoseInput,
)
from service.schemas.tables import Units

MOST_TARGETS = 1000  # Targets of one request; an arm of six joints answers a thousand within a second.


class NumericInverseKinematicsRequest(PlacedRobotQuestion):
    """A robot, and a pose for its tool to reach, or many."""

    model_config = forbidding(
        *NO_ROBOT,
        *not_one_of("target", "targets", "position"),
        together("quaternion", without=["position"]),
        together("axis", without=["position"]),
        together("quaternion", "axis"),
    )

    target: PoseInput | None = Field(None, description="the wanted pose of the tool in the world")
    targets: (
        Annotated[list[PoseInput], Field(min_length=1, max_length=MOST_TARGETS, fail_fast=True)] | None
    ) = Field(None, description="or many of them; the answer then holds one answer for each, in their order")
    position: Vector3 | None = Field(
        None,
        description="or where its origin has to be; with neither quaternion nor axis its orientation is free",
    )
    quaternion: Annotated[list[Real], Field(min_length=4, max_length=4)] | None = Field(
        None, description="with a position: the wanted orientation, [w, x, y, z] of any length"
    )
    axis: Vector3 | None = Field(
        None, description="with a position: where the tool's z axis has to point; turns about it are free"
    )
    start: list[Real] | None = Field(
        None, max_length=12, description="joint values; the solution nearest to them comes first"
    )
    limits: JointRanges | None = Field(
        None,
        description="[least, greatest] of each joint in the table's units, null where there is no limit; "
        "left out, joints are free: those that the catalogue knows of a robot do not apply of themselves",
    )
    tolerance: Real | None = Field(
        None,
        json_schema_extra={"exclusiveMinimum": 0},
        description="how far the target may be off, as a distance in the table's unit and as an angle "
        "in rad: of a pose rounded to five decimals 1e-5. Above 0.01, as of a pose in mm with one decimal, "
        "it is a distance of at most 1 % of the arm's size, and the angle the same part of 1 rad. Left out, "
        "what its rotation part shows of rounding",
    )

    form: NumericForm = Field("numeric", description="numeric: joint values; symbolic is another request")

    @model_validator(mode="after")
    def _one_target(self) -> Self:
        oriented = self.quaternion is not None or self.axis is not None
        both = self.quaternion is not None and self.axis is not None
        given = sum(each is not None for each in (self.target, self.targets, self.position))
        if given != 1 or (oriented and self.position is None) or both:
            raise PydanticCustomError("target_or_position", "give one of target, targets and position")
        return self


class FamilyParameterModel(Wire):
    """A joint that may be chosen within a family."""

    joint: int = Field(description="its number, from 1")
    interval: Annotated[list[Real], Field(min_length=2, max_length=2)] = Field(
        description="least and greatest value, in the table's units"
    )
    full_turn: bool = Field(description="the joint turns fully: the family is closed to a circle")


class SolutionFamily(Wire):
    """Infinitely many solutions, joined by a path on which the target stays reached."""

    dimension: int = Field(description="number of joints that may be chosen")
    parameters: list[FamilyParameterModel] = Field(
        description="these joints; each interval holds while the others keep the values of the solution"
    )
    direction: list[Real] | None = Field(
        None, description="of a straight family: every member is joints + t·direction"
    )
    members: list[list[Real]] = Field(description="members in order along the family, its ends included")


class Solution(Wire):
    """One way to reach the target."""

    joints: list[Real] = Field(
        description="q_1 … q_n in the table's units; of several turns the one nearest 0"
    )
    residual: Real = Field(
        description="√(position_error² + angle²), the angle always in radians, by forward kinematics"
    )
    position_error: Real = Field(description="distance from the target")
    orientation_error: Real = Field(description="angle from the target, in the answer's angle unit")
    isolation: Isolation = Field(description="continuum: it can be moved while the target stays reached")
    family: SolutionFamily | None = Field(None, description="of a continuum: what it can be moved to")


class Nearest(Wire):
    """The configuration within the limits that comes nearest to an unreachable target."""

    joints: list[Real] = Field(description="q_1 … q_n, in the table's units")
    transform: Matrix4 = Field(description="the pose there")
    size: Real = Field(
        description="the sum of the offsets √(a² + d²); nearest is what makes "
        "(position_error / size)² + angle² least"
    )
    residual: Real = Field(description="√(position_error² + angle²), the angle always in radians")
    position_error: Real = Field(description="its distance from the target")
    orientation_error: Real = Field(description="its angle from the target, in the answer's angle unit")


class TargetAnswer(Wire):
    """What is to be said about one target; unreachable and singular are results."""

    status: IKStatus | Literal["unanswered"] = Field(
        description="solved; singular: families of more dimensions than the arm has joints to spare; "
        "unreachable: none within the limits; unanswered: of many targets one that the time did not reach to"
    )
    complete: bool = Field(description="whether these are all solutions within the limits")
    method: Method | None = Field(
        None, description="closed_form finds all solutions, search as many as it does; none if unanswered"
    )
    solutions: list[Solution]
    nearest: Nearest | None = Field(None, description="if unreachable: the nearest pose")
    reason: UnreachableReason | None = Field(None, description="if unreachable: why")
    outside_limits: int = Field(
        description="solutions and families that were found outside the request's `limits`; 0 without any"
    )
    tolerance: Real = Field(description="within which the target counts as reached")


class InverseKinematicsAnswer(TargetAnswer, Units):
    """The answer for one target."""


class InverseKinematicsAnswers(Units):
    """The answers for many targets."""

    answers: list[TargetAnswer] = Field(description="one for each target, in their order")
    faults: list[FaultEntry] = Field(
        description="of each target that is unanswered: the time of the request was over before its turn"
    )
