"""Jacobians and joint forces that somebody wrote in closed form."""

from __future__ import annotations

from functools import partial
from itertools import chain
from typing import Annotated, Any

from exercises.parts.definition_keys import COMPONENTS
from kinematics.answers.form_samples import FormRobot
from kinematics.answers.jacobian_answers import JacobianMistake
from kinematics.answers.jacobian_forms import judge_force_form, judge_jacobian_form
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.cells import ParameterKind
from kinematics.symbolic import ProofStatus
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, api_router
from service.schemas import examples
from service.schemas.checks.jacobian_answers import jacobian_mistake
from service.schemas.checks.jacobian_form_answers import CheckJacobianFormAnswer, CheckJacobianFormRequest
from service.wire.checks.answer_functions import angles_of_jacobian, form_values, read_row, roundings_of
from service.wire.kinematics.prepared_robots import PreparedRobot

router = api_router("kinematics")

_EXAMPLES: dict[str, Any] = {
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


@router.post(
    "/check-jacobian-form",
    summary="Are this Jacobian and these joint forces, as functions, those of the table?",
    responses=problems(400, 413, 415, 422, 503),
)
async def check_jacobian_form(
    body: Annotated[CheckJacobianFormRequest, body_with(_EXAMPLES)],
    request: ApiRequest,
) -> CheckJacobianFormAnswer:
    """Return the Jacobian of the last frame's origin and τ = Jᵀ (f, m), as functions of q1 … qn.

    Geometric, in either axes, or analytic for one of the 24 sequences of angles; rows in either order. Equal
    functions are proved equal where entries are exact, and compared at many configurations where not.
    """
    robot = await request.in_turn(partial(request.resources.robots.prepare, body))
    work = partial(_checked, body, robot, language_of(request))
    return await request.resources.grading.run(work)


def _checked(body: CheckJacobianFormRequest, robot: PreparedRobot, language: str) -> CheckJacobianFormAnswer:
    angles = angles_of_jacobian(body)
    values, kinds = form_values(body, robot), robot.read.parameters
    named = {**{name: 7.0 + 3.0 * i for i, name in enumerate(COMPONENTS)}, **values}
    lengths = {name for name in values if kinds.get(name, ParameterKind.LENGTH) is ParameterKind.LENGTH}
    form = FormRobot(
        table=robot.read.table,
        values=named,
        lengths=frozenset(lengths) | (set(COMPONENTS[3:]) - values.keys()),
    )
    n = len(robot.joint_units)
    proofs: set[ProofStatus] = set()
    mistakes: list[tuple[str, JacobianMistake, int | None]] = []
    entries, forces, correct = None, None, True
    if body.jacobian is not None:
        rows = [read_row(row, n, robot.read, named, ("jacobian", i)) for i, row in enumerate(body.jacobian)]
        rounded = roundings_of(
            chain.from_iterable(body.jacobian), chain.from_iterable(rows), robot.read, named, COMPONENTS
        )
        if body.order is ScrewOrder.ANGULAR_FIRST:
            rows = [*rows[3:], *rows[:3]]
        found = judge_jacobian_form(form, rows, body.frame, body.tolerance, angles, rounded)
        entries, correct = found.entries.tolist(), found.right
        proofs.add(found.proof)
        mistakes += [("jacobian", mistake, joint) for mistake, joint in found.mistakes]
    if body.joint_forces is not None and body.wrench is not None:
        given = read_row(body.joint_forces, n, robot.read, named, ("joint_forces",))
        wrench = read_row(body.wrench, 6, robot.read, named, ("wrench",), variables=False)
        rounded = roundings_of(body.joint_forces, given, robot.read, named, COMPONENTS)
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
