"""POST /check-inverse-kinematics: joint values that somebody says reach a pose."""

from contextlib import suppress
from functools import partial
from typing import Annotated, NamedTuple

import numpy as np
from pydantic import Field

from exercises.grading import Feedback, Policy, ToolRule
from exercises.parts.inverse.joint_cells import joint_feedback
from kinematics.answers.joint_answers import in_other_frames, judge_joints
from kinematics.answers.joint_questions import USUAL_TOLERANCE, joint_question
from kinematics.answers.joint_verdicts import JointAnswer, JointClaim
from kinematics.cells import Limits, bind_parameters, in_length_unit, read_table
from kinematics.chain import chain_of_table
from kinematics.equivalence import Certificate
from kinematics.equivalence.decision import certify
from kinematics.equivalence.reference import prepared
from kinematics.inverse import ArmReach, InverseKinematics
from kinematics.inverse.goals import EXACT, LARGEST_TOLERANCE, LEAST_TOLERANCE, OF_ROUNDING, rounding_of
from kinematics.se3 import check_transform, inverse_transform
from kinematics.table import JointType
from service.http.calls import CallRouter
from service.http.problems import located
from service.resources import Resources
from service.schemas.base import Matrix4, OneOf, Real, Wire
from service.schemas.kinematics.robot_question import JointRanges, PoseInput, RobotQuestion, domain_limits
from service.schemas.spoken import SpokenFeedback, spoken
from service.schemas.tables import Table, Units
from service.wire.fault_pointers import traced
from service.wire.kinematics.answer_functions import check_count
from service.wire.kinematics.inverse_solutions import TargetQuestion, answer_to
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.prepared_robots import PreparedRobot

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


router = CallRouter("kinematics")


ROUNDED = 2e-3  # How far a target may be from a rigid motion: three decimals.


class _Asked(NamedTuple):
    """A pose and an answer about it, in the robot's own frames, and the certificate of the answerer's."""

    question: TargetQuestion
    answer: JointAnswer
    own: Certificate | None


@router.call("/check-inverse-kinematics", "Do these joint values reach the pose, and are they all?")
async def check_inverse_kinematics(
    body: CheckInverseKinematicsRequest, robot: PreparedRobot, resources: Resources, language: str
) -> CheckInverseKinematicsAnswer:
    """Judge each row by forward kinematics, up to full turns, and the rows together by the complete set.

    For a singular pose, the answer must give the combination of joint values that is fixed on the family.
    With `own`, joint values and pose refer to the answerer's own table, and the certificate (σ, δ, B, E) of
    that table converts them. Missing branches and wrong quadrants are named.
    """
    asked = await resources.grading.run(partial(_asked, body, robot, resources.settings.cell_limits))
    if asked is None:
        return _refused(robot, language)
    with traced(body):
        found = await answer_to(asked.question, resources.workers)
    return await resources.grading.run(partial(_judged, body, robot, asked, found, language))


def _asked(body: CheckInverseKinematicsRequest, robot: PreparedRobot, limits: Limits) -> _Asked | None:
    """What is asked, and the answer; None if the answerer's own table is another robot."""
    units = _units(body, robot)
    target = check_transform(
        pose_matrix(body.target, robot.angle, "target"), where=("target",), tolerance=ROUNDED
    )
    off = float(np.abs(target[:3, :3].T @ target[:3, :3] - np.eye(3)).max())
    rounding = OF_ROUNDING * off if off > EXACT else rounding_of(target[:3, 3])
    exactness = min(max(rounding, LEAST_TOLERANCE), LARGEST_TOLERANCE)
    left, _, right = np.linalg.svd(target[:3, :3])
    target[:3, :3] = left @ right
    own = None if body.own is None else _certificate(body, robot, limits)
    if body.own is not None and own is None:
        return None
    answer = JointAnswer(
        claim=body.claim,
        rows=tuple(_row(row, units, "solutions", i) for i, row in enumerate(body.solutions)),
        combinations=tuple(
            _row(row, (1.0,) * len(units), "combinations", i) for i, row in enumerate(body.combinations)
        ),
    )
    if own is not None:
        answer = in_other_frames(answer, own.joint_signs, own.joint_offsets)
        target = inverse_transform(own.base) @ target @ inverse_transform(own.tool)
    reach = ArmReach.POSITION if body.position_only else ArmReach.POSE
    with traced(body):
        ranges = domain_limits(body.limits, robot.joint_units)
    question = TargetQuestion(
        table=robot.table, target=target, reach=reach, limits=ranges, tolerance=exactness
    )
    return _Asked(question, answer, own)


def _judged(
    body: CheckInverseKinematicsRequest,
    robot: PreparedRobot,
    asked: _Asked,
    solutions: InverseKinematics,
    language: str,
) -> CheckInverseKinematicsAnswer:
    """What is said of the answer, beside the solutions."""
    asking, answer, own = asked
    question = joint_question(
        asking.solver(),
        asking.target,
        every=body.every,
        tolerance=body.tolerance,
        reach=asking.reach,
        found=solutions,
    )
    found = judge_joints(question, answer)
    return CheckInverseKinematicsAnswer(
        **robot.units,
        correct=found.right,
        score=found.share,
        expected=found.expected,
        complete=found.complete,
        rows=[
            JointRowVerdict(correct=row.right, solution=row.solution if row.right else None)
            for row in found.rows
        ],
        combinations=list(found.combinations),
        own_accepted=None if own is None else True,
        base=None if own is None else own.base.tolist(),
        tool=None if own is None else own.tool.tolist(),
        feedback=spoken(joint_feedback(found, answer), language),
    )


def _certificate(
    body: CheckInverseKinematicsRequest, robot: PreparedRobot, limits: Limits
) -> Certificate | None:
    """Return how the answerer's own table agrees with the robot; None if it is another one."""
    assert body.own is not None
    with located("own"):
        read = in_length_unit(read_table(body.own.raw(), limits), robot.read.length_unit)
        known = {name: value for name, value in body.parameters.items() if name in read.parameters}
        table = bind_parameters(read, known)
    policy = Policy(tool=ToolRule.FREE)
    with np.errstate(all="ignore"), suppress(np.linalg.LinAlgError):
        return certify([prepared(robot.table)], [chain_of_table(table)], policy)
    return None


def _refused(robot: PreparedRobot, language: str) -> CheckInverseKinematicsAnswer:
    """Return what is said where the answerer's own table is another robot."""
    return CheckInverseKinematicsAnswer(
        **robot.units,
        correct=False,
        score=0.0,
        expected=None,
        complete=True,
        rows=[],
        combinations=[],
        own_accepted=False,
        base=None,
        tool=None,
        feedback=spoken((Feedback(code="joints_need_table"),), language),
    )


def _units(body: CheckInverseKinematicsRequest, robot: PreparedRobot) -> tuple[float, ...]:
    """Return what one unit of each joint value is in [rad], or in the robot's length unit."""
    if body.own is None:
        return robot.joint_units
    ratio = float(body.own.length_unit.metres_per_unit / robot.read.length_unit.metres_per_unit)
    return tuple(
        body.own.angle_unit.radians if kind is JointType.REVOLUTE else ratio
        for kind in robot.table.joint_types
    )


def _row(row: list[float], units: tuple[float, ...], field: str, i: int) -> tuple[float, ...]:
    check_count(row, len(units), (field, i))
    return tuple(value * unit for value, unit in zip(row, units, strict=True))
