"""POST /check-singularities: where an arm is singular, as somebody wrote it."""

from collections.abc import Collection
from typing import Annotated, Any

from pydantic import Field

from exercises.parts.motion.conditions import read_conditions
from kinematics.answers.lost_motions import lost_motion_is_right, lost_motions_at
from kinematics.answers.singular_arms import SingularArm, arm_of
from kinematics.answers.singularity_answers import judge_singularities
from kinematics.answers.singularity_verdicts import ConditionStatus, SingularityVerdict
from kinematics.errors import Fault, JointValueError
from kinematics.expressions import Expression
from kinematics.inverse.lengths import check_lengths
from kinematics.symbolic import ProofStatus
from kinematics.symbolic.determinants import MotionRows
from service.http.calls import CallRouter
from service.schemas.base import OneOf, Real, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.robot_question import NO_ROBOT, RobotQuestion
from service.schemas.spoken import feedback_sentence
from service.schemas.tables import Cell, Units
from service.wire.fault_pointers import traced
from service.wire.kinematics.answer_functions import check_count, form_values, known_functions
from service.wire.kinematics.joint_values import in_request_units, values_in_radians
from service.wire.kinematics.prepared_robots import PreparedRobot


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


router = CallRouter("kinematics")


@router.judge("/check-singularities", "Is the arm singular just where these conditions hold?")
def check_singularities(
    body: CheckSingularitiesRequest, robot: PreparedRobot, language: str
) -> CheckSingularitiesAnswer:
    """Judge conditions as a set, whatever their number, order, factors and signs.

    A configuration shows each condition that also holds elsewhere, and each family that they miss. The call
    also decides whether a vector is a motion that the arm has lost in a configuration.
    """
    with traced(body):
        check_lengths(robot.table)
    if body.conditions is None and body.lost is None:
        raise JointValueError(Fault.at("conditions_empty"))
    values = form_values(body, robot)
    arm = arm_of(robot.read.table, body.motion, tuple(sorted(values.items())))
    lost = None if body.lost is None else _lost(body, robot, arm)
    found, numbers = None, list[int]()
    if body.conditions is not None:
        rounded: dict[Expression, tuple[Expression, ...]] = {}
        read = [_read(cell, robot, values.keys(), i, rounded) for i, cell in enumerate(body.conditions)]
        numbers = [i + 1 for i, row in enumerate(read) for _ in row]
        found = judge_singularities(arm, [function for row in read for function in row], rounded)
    return CheckSingularitiesAnswer(
        **robot.units,
        correct=lost is not False and (found is None or found.right),
        proof=None if found is None else found.proof,
        whole=arm.whole,
        conditions=[] if found is None else _conditions(found, numbers, robot, language),
        families=[
            SingularFamilyModel(found=entry.found, example=_typed(entry.example, robot))
            for entry in (found.families if found is not None else ())
        ],
        lost=lost,
    )


def _conditions(
    found: SingularityVerdict, numbers: list[int], robot: PreparedRobot, language: str
) -> list[ConditionModel]:
    told = []
    for number, entry in zip(numbers, found.conditions, strict=True):
        message = None
        if entry.status is not ConditionStatus.SINGULAR:
            message = feedback_sentence(f"singularity_{entry.status.value}", language, {"condition": number})
        example = _typed(entry.example, robot)
        told.append(ConditionModel(number=number, status=entry.status, example=example, message=message))
    return told


def _typed(joints: tuple[float, ...] | None, robot: PreparedRobot) -> list[float] | None:
    """Return joint values in the request's units."""
    return None if joints is None else in_request_units(joints, robot.joint_units)


def _read(
    cell: Any,
    robot: PreparedRobot,
    known: Collection[str],
    i: int,
    rounded: dict[Expression, tuple[Expression, ...]],
) -> tuple[Expression, ...]:
    where = ("conditions", i)
    read = read_conditions(cell, robot.read.table.joint_types, robot.read.angle_unit, where, known)
    functions = known_functions(read, known, [where] * len(read))
    rounded.update((entry.expression, entry.rounded) for entry in read if not isinstance(entry, Fault))
    return functions


def _lost(body: CheckSingularitiesRequest, robot: PreparedRobot, arm: SingularArm) -> bool:
    expected = 3 if body.motion is MotionRows.TRANSLATION else 6
    given = body.lost or []
    check_count(given, expected, ("lost",))
    joints = values_in_radians(body.joints or [], robot.joint_units, "joints")
    if not lost_motions_at(arm, joints):
        raise JointValueError(Fault.at("not_singular", "joints"))
    return bool(lost_motion_is_right(arm, joints, given))
