"""POST /check-jacobian and POST /check-jacobian-form: Jacobians and joint forces that somebody computed."""

import itertools
from collections.abc import Sequence
from typing import Annotated, Any

import numpy as np
from pydantic import Field

from kinematics.answers.form_samples import COMPONENTS, loaded_robot
from kinematics.answers.jacobian_answers import judge_forces, judge_jacobian
from kinematics.answers.jacobian_forms import judge_force_form, judge_jacobian_form
from kinematics.answers.jacobian_verdicts import JacobianMistake, JacobianVerdict
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.chain import chain_of_table
from kinematics.errors import Fault, JointValueError
from kinematics.inverse.lengths import check_lengths
from kinematics.jacobian import JacobianFrame
from kinematics.rotations.sequences import EulerSequence
from kinematics.symbolic import ProofStatus
from service.http.calls import CallRouter
from service.http.problems import located
from service.schemas.base import OneOf, Real, Share, Vector6, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.orientations import RatesOfAngles
from service.schemas.kinematics.robot_question import NO_ROBOT, RobotQuestion
from service.schemas.spoken import feedback_sentence
from service.schemas.tables import Cell, Units
from service.wire.fault_pointers import traced
from service.wire.kinematics.answer_functions import check_count, form_values, read_row, roundings_of
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.prepared_robots import PreparedRobot

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
    wrench: Vector6 | None = Field(
        None, description="force and moment that the hand exerts at the last frame's origin"
    )
    joint_forces: Columns | None = Field(None, description="τ = Jᵀ · wrench, one for each joint")
    tolerance: Share = Field(0.005, description="of an entry; of a length as a share of the robot's size")


class CheckJacobianFormRequest(JacobianCheck):
    """A table, with a Jacobian or joint forces that somebody wrote as functions of q1 … qn."""

    jacobian: Annotated[list[FormRow], Field(min_length=6, max_length=6)] | None = Field(
        None, description="6×n expressions, per radian, of the last frame's origin; c12 is cos(q1 + q2)"
    )
    wrench: Annotated[list[Cell], Field(min_length=6, max_length=6)] | None = Field(
        None,
        description="force and moment of the hand, at the last origin: numbers, or fx, fy, fz, mx, my, mz",
    )
    joint_forces: FormRow | None = Field(None, description="τ = Jᵀ · wrench, one expression for each joint")
    tolerance: Share = Field(
        0.005, description="of an entry that is not proved; of a length as a share of the robot's size"
    )


class JacobianMistakeModel(Wire):
    """What a wrong answer looks like."""

    code: JacobianMistake
    joint: int | None = Field(description="the column it is about, from 1; null: all of them")
    message: str = Field(description="the sentence, in the caller's language")


class CheckJacobianAnswer(Units):
    """Whether a Jacobian and joint torques and forces are those of the table."""

    correct: bool
    entries: list[list[bool]] | None = Field(
        description="which entries of the Jacobian are right, linear rows first; null if there was none"
    )
    forces: list[bool] | None = Field(description="which torques and forces are right; null without any")
    mistakes: list[JacobianMistakeModel] = Field(description="the usual slips that explain a wrong answer")


class CheckJacobianFormAnswer(CheckJacobianAnswer):
    """Whether closed forms are those of the table."""

    proof: ProofStatus = Field(
        description="proved: the same functions; undecided: equal where compared; refuted: they differ, if "
        "only by what the tolerance allows"
    )


router = CallRouter("kinematics")


@router.call("/check-jacobian", "Are this Jacobian and these joint torques and forces those of the table?")
def check_jacobian(body: CheckJacobianRequest, robot: PreparedRobot, language: str) -> CheckJacobianAnswer:
    """Return the Jacobian of the last frame's origin, in either order of the rows, and τ = Jᵀ (f, m).

    Geometric, in either axes, or analytic for one of the 24 sequences of angles.
    The table is the answerer's own: whether it is the robot's is asked of `/grade`. Columns that the usual
    slips would make are named.
    """
    with traced(body):
        check_lengths(robot.table)
    n = len(robot.joint_units)
    joints = values_in_radians(body.joints, robot.joint_units, "joints")
    angles = _meant_angles(body)
    for i, row in enumerate(body.jacobian or ()):
        check_count(row, n, ("jacobian", i))
    if body.joint_forces is not None:
        check_count(body.joint_forces, n, ("joint_forces",))
    chain = chain_of_table(robot.table)
    found, forces, slip = None, None, None
    if body.jacobian is not None:
        given = np.array(body.order.linear_first(body.jacobian), dtype=np.float64)
        found = judge_jacobian(chain, joints, given, body.frame, body.tolerance, angles)
    if body.joint_forces is not None and body.wrench is not None:
        forces, slip = judge_forces(chain, joints, body.wrench, body.joint_forces, body.frame, body.tolerance)
    return CheckJacobianAnswer(**robot.units, **_findings(found, forces, slip, language))


@router.judge(
    "/check-jacobian-form", "Are this Jacobian, torques and forces, as functions, those of the table?"
)
def check_jacobian_form(
    body: CheckJacobianFormRequest, robot: PreparedRobot, language: str
) -> CheckJacobianFormAnswer:
    """Return the Jacobian of the last frame's origin and τ = Jᵀ (f, m), as functions of q1 … qn.

    Geometric, in either axes, or analytic for one of the 24 sequences of angles; rows in either order. Equal
    functions are proved equal where entries are exact, and compared at many configurations where not.
    """
    angles = _meant_angles(body)
    form = loaded_robot(robot.read.table, form_values(body, robot), robot.read.parameters)
    n = len(robot.joint_units)
    proofs: set[ProofStatus] = set()
    found, forces, slip = None, None, None
    if body.jacobian is not None:
        rows = [
            read_row(row, n, robot.read, form.values, ("jacobian", i)) for i, row in enumerate(body.jacobian)
        ]
        rounded = roundings_of(
            itertools.chain.from_iterable(body.jacobian),
            itertools.chain.from_iterable(rows),
            robot.read,
            form.values,
            COMPONENTS,
        )
        jacobian = body.order.linear_first(rows)
        found = judge_jacobian_form(form, jacobian, body.frame, body.tolerance, angles, rounded)
        proofs.add(found.proof)
    if body.joint_forces is not None and body.wrench is not None:
        given = read_row(body.joint_forces, n, robot.read, form.values, ("joint_forces",))
        wrench = read_row(body.wrench, 6, robot.read, form.values, ("wrench",), variables=False)
        rounded = roundings_of(body.joint_forces, given, robot.read, form.values, COMPONENTS)
        forces, proof, slip = judge_force_form(form, given, wrench, body.frame, body.tolerance, rounded)
        proofs.add(proof)
    order = (ProofStatus.REFUTED, ProofStatus.UNDECIDED, ProofStatus.PROVED)
    return CheckJacobianFormAnswer(
        **robot.units,
        proof=next(status for status in order if status in proofs),
        **_findings(found, forces, slip, language),
    )


def _findings(
    found: JacobianVerdict | None, forces: Sequence[bool] | None, slip: JacobianMistake | None, language: str
) -> dict[str, Any]:
    """Return what is said of a Jacobian and of joint forces, None of what was not given."""
    mistakes = [_told("jacobian", *told, language) for told in (found.mistakes if found else ())]
    return {
        "correct": (found is None or found.right) and all(forces or ()),
        "entries": None if found is None else found.entries.tolist(),
        "forces": None if forces is None else list(forces),
        "mistakes": mistakes if slip is None else [*mistakes, _told("forces", slip, None, language)],
    }


def _meant_angles(body: CheckJacobianRequest | CheckJacobianFormRequest) -> EulerSequence | None:
    """Return the angles of which the rates are meant, None for a geometric Jacobian.

    Raises:
        JointValueError: there is neither a Jacobian nor joint forces, or no wrench that they belong to.
        PoseError: there is no such sequence of angles.
    """
    if body.jacobian is None and body.joint_forces is None:
        raise JointValueError(Fault.at("jacobian_empty"))
    if body.joint_forces is not None and body.wrench is None:
        raise JointValueError(Fault.at("wrench_missing", "wrench"))
    with located("angles"):
        return None if body.angles is None else body.angles.sequence()


def _told(what: str, mistake: JacobianMistake, joint: int | None, language: str) -> JacobianMistakeModel:
    """A mistake in a Jacobian or in joint forces (`what`), with its sentence."""
    columns = () if joint is None else (str(joint),)
    values = {"joint": joint or 0, "joints": columns, "count": len(columns)}
    told = feedback_sentence(f"{what}_{mistake.value}", language, values)
    return JacobianMistakeModel(code=mistake, joint=joint, message=told)
