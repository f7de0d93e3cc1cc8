"""Jacobians and joint forces that somebody computed, in numbers or in closed form."""

from __future__ import annotations

import itertools
from functools import partial
from typing import Annotated, Any

import numpy as np

from kinematics.answers.form_samples import COMPONENTS, loaded_robot
from kinematics.answers.jacobian_answers import JacobianMistake, judge_forces, judge_jacobian
from kinematics.answers.jacobian_forms import judge_force_form, judge_jacobian_form
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.chain import chain_of_table
from kinematics.inverse.lengths import check_lengths
from kinematics.symbolic import ProofStatus
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, api_router
from service.schemas import examples
from service.schemas.checks.jacobian_answers import (
    CheckJacobianAnswer,
    CheckJacobianFormAnswer,
    CheckJacobianFormRequest,
    CheckJacobianRequest,
    jacobian_mistake,
)
from service.wire.fault_pointers import traced
from service.wire.kinematics.answer_functions import (
    angles_of_jacobian,
    check_count,
    form_values,
    read_row,
    roundings_of,
)
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.prepared_robots import PreparedRobot

router = api_router("kinematics")

_IN_NUMBERS: dict[str, Any] = {
    "two links: the second column with p₁ − p₂": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "joints": [0, 1.5707963267948966],
        "jacobian": [[-0.3, 0.3], [0.5, 0], [0, 0], [0, 0], [0, 0], [1, 1]],
    },
    "two links: the torques that hold 10 N": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "joints": [0, 0],
        "wrench": [0, 10, 0, 0, 0, 0],
        "joint_forces": [8, 3],
    },
}
_IN_CLOSED_FORM: dict[str, Any] = {
    "two links, the Jacobian": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "jacobian": [
            ["-L1*s1 - L2*s12", "-L2*s12"],
            ["L1*c1 + L2*c12", "L2*c12"],
            [0, 0],
            [0, 0],
            [0, 0],
            [1, 1],
        ],
    },
    "two links, the torques that hold a force": {
        "table": examples.TWO_LINKS,
        "parameters": {"L1": 0.5, "L2": 0.3},
        "wrench": ["fx", "fy", 0, 0, 0, 0],
        "joint_forces": ["-(L1*s1 + L2*s12)*fx + (L1*c1 + L2*c12)*fy", "L2*(c12*fy - s12*fx)"],
    },
}


@router.post("/check-jacobian", summary="Are this Jacobian and these joint forces those of the table?")
async def check_jacobian(
    body: Annotated[CheckJacobianRequest, body_with(_IN_NUMBERS)], request: ApiRequest
) -> CheckJacobianAnswer:
    """Return the Jacobian of the last frame's origin, in either order of the rows, and τ = Jᵀ (f, m).

    Geometric, in either axes, or analytic for one of the 24 sequences of angles.
    The table is the answerer's own: whether it is the robot's is asked of `/grade`. Columns that the usual
    slips would make are named.
    """
    robot = await request.in_turn(partial(request.resources.robots.prepare, body))
    return await request.in_turn(partial(_checked, body, robot, language_of(request)))


@router.post(
    "/check-jacobian-form",
    summary="Are this Jacobian and these joint forces, as functions, those of the table?",
    responses=problems(503),
)
async def check_jacobian_form(
    body: Annotated[CheckJacobianFormRequest, body_with(_IN_CLOSED_FORM)], request: ApiRequest
) -> CheckJacobianFormAnswer:
    """Return the Jacobian of the last frame's origin and τ = Jᵀ (f, m), as functions of q1 … qn.

    Geometric, in either axes, or analytic for one of the 24 sequences of angles; rows in either order. Equal
    functions are proved equal where entries are exact, and compared at many configurations where not.
    """
    robot = await request.in_turn(partial(request.resources.robots.prepare, body))
    work = partial(_checked_form, body, robot, language_of(request))
    return await request.resources.grading.run(work)


def _checked(body: CheckJacobianRequest, robot: PreparedRobot, language: str) -> CheckJacobianAnswer:
    with traced(body):
        check_lengths(robot.table)
    n = len(robot.joint_units)
    joints = values_in_radians(body.joints, robot.joint_units, "joints")
    angles = angles_of_jacobian(body)
    for i, row in enumerate(body.jacobian or ()):
        check_count(row, n, ("jacobian", i))
    if body.joint_forces is not None:
        check_count(body.joint_forces, n, ("joint_forces",))
    chain = chain_of_table(robot.table)
    entries, forces, correct = None, None, True
    mistakes: list[tuple[str, JacobianMistake, int | None]] = []
    if body.jacobian is not None:
        given = np.array(body.jacobian, dtype=np.float64)
        if body.order is ScrewOrder.ANGULAR_FIRST:
            given = np.vstack([given[3:], given[:3]])
        found = judge_jacobian(chain, joints, given, body.frame, body.tolerance, angles)
        entries, correct = found.entries.tolist(), found.right
        mistakes += [("jacobian", mistake, joint) for mistake, joint in found.mistakes]
    if body.joint_forces is not None and body.wrench is not None:
        right, mistake = judge_forces(
            chain, joints, body.wrench, body.joint_forces, body.frame, body.tolerance
        )
        forces, correct = list(right), correct and all(right)
        mistakes += [("forces", mistake, None)] if mistake is not None else []
    return CheckJacobianAnswer.model_validate(
        {
            **robot.units,
            "correct": correct,
            "entries": entries,
            "forces": forces,
            "mistakes": [jacobian_mistake(*entry, language) for entry in mistakes],
        }
    )


def _checked_form(
    body: CheckJacobianFormRequest, robot: PreparedRobot, language: str
) -> CheckJacobianFormAnswer:
    angles = angles_of_jacobian(body)
    form = loaded_robot(robot.read.table, form_values(body, robot), robot.read.parameters)
    n = len(robot.joint_units)
    proofs: set[ProofStatus] = set()
    mistakes: list[tuple[str, JacobianMistake, int | None]] = []
    entries, forces, correct = None, None, True
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
        if body.order is ScrewOrder.ANGULAR_FIRST:
            rows = [*rows[3:], *rows[:3]]
        found = judge_jacobian_form(form, rows, body.frame, body.tolerance, angles, rounded)
        entries, correct = found.entries.tolist(), found.right
        proofs.add(found.proof)
        mistakes += [("jacobian", mistake, joint) for mistake, joint in found.mistakes]
    if body.joint_forces is not None and body.wrench is not None:
        given = read_row(body.joint_forces, n, robot.read, form.values, ("joint_forces",))
        wrench = read_row(body.wrench, 6, robot.read, form.values, ("wrench",), variables=False)
        rounded = roundings_of(body.joint_forces, given, robot.read, form.values, COMPONENTS)
        right, proof, mistake = judge_force_form(form, given, wrench, body.frame, body.tolerance, rounded)
        forces, correct = list(right), correct and all(right)
        proofs.add(proof)
        mistakes += [("forces", mistake, None)] if mistake is not None else []
    order = (ProofStatus.REFUTED, ProofStatus.UNDECIDED, ProofStatus.PROVED)
    return CheckJacobianFormAnswer.model_validate(
        {
            **robot.units,
            "correct": correct,
            "proof": next(status for status in order if status in proofs),
            "entries": entries,
            "forces": forces,
            "mistakes": [jacobian_mistake(*entry, language) for entry in mistakes],
        }
    )
