"""Equations of motion that somebody wrote."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import chain
from typing import Annotated, Any

from kinematics.answers.dynamics_answers import DynamicsQuestion, EquationsAnswer, judge_dynamics
from kinematics.answers.left_open import Rounded
from kinematics.cells import ReadTable
from kinematics.dynamics import rate_name
from kinematics.errors import Fault, JointValueError
from kinematics.expressions import Expression
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, api_router
from service.schemas.checks.dynamics_answers import (
    CHECK_DYNAMICS,
    CheckDynamicsAnswer,
    CheckDynamicsRequest,
    DynamicsMistakeModel,
)
from service.schemas.spoken import feedback_sentence
from service.settings import Settings
from service.wire.kinematics.answer_functions import read_row, roundings_of
from service.wire.kinematics.dynamics import parameter_numbers, weighed

router = api_router("kinematics")


@router.post("/check-dynamics", summary="Are these M, C and g those of the robot?", responses=problems(503))
async def check_dynamics(
    body: Annotated[CheckDynamicsRequest, body_with(CHECK_DYNAMICS)], request: ApiRequest
) -> CheckDynamicsAnswer:
    """Judge M and g entry by entry, and C by C q̇: every C with the right C q̇ is right.

    Exact entries are proved equal as functions, others are compared at many configurations. The answer says
    separately whether Ṁ − 2C is skew-symmetric. Names of lengths are in metres, as in `/dynamics`.
    """
    work = partial(_checked, body, request.settings, language_of(request))
    return await request.resources.grading.run(work)


def _checked(body: CheckDynamicsRequest, settings: Settings, language: str) -> CheckDynamicsAnswer:
    found = weighed(body, settings)
    question = DynamicsQuestion(
        table=found.metric.table,
        links=found.bodies.links,
        gravity=found.bodies.gravity,
        values=parameter_numbers(found, body.parameters),
    )
    answer = EquationsAnswer(
        mass=_matrix(body.M, found.read, question, "M"),
        coriolis=_matrix(body.C, found.read, question, "C"),
        velocity=None if body.h is None else _row(body.h, found.read, question, "h"),
        gravity=None if body.g is None else _row(body.g, found.read, question, "g"),
    )
    if body.M is body.C is body.h is body.g is None:
        raise JointValueError(Fault.at("motion_empty"))
    answer = replace(answer, rounded=_rounded(body, answer, found.read, question))
    verdict = judge_dynamics(question, answer, body.tolerance)
    told: dict[str, Any] = {
        "angle_unit": found.read.angle_unit.value,
        "length_unit": found.read.length_unit.value,
        "correct": verdict.right,
        "proof": verdict.proof,
        "M": None if verdict.mass is None else [list(row) for row in verdict.mass],
        "h": None if verdict.velocity is None else list(verdict.velocity),
        "skew": verdict.skew,
        "g": None if verdict.gravity is None else list(verdict.gravity),
        "mistakes": [
            DynamicsMistakeModel(code=mistake, message=feedback_sentence(f"motion_{mistake.value}", language))
            for mistake in verdict.mistakes
        ],
    }
    return CheckDynamicsAnswer.model_validate(told)


def _matrix(
    rows: list[list[Any]] | None, read: ReadTable, question: DynamicsQuestion, name: str
) -> tuple[tuple[Expression, ...], ...] | None:
    if rows is None:
        return None
    expected = question.table.n_joints
    if len(rows) != expected:
        params = {"expected": expected, "given": len(rows)}
        raise JointValueError(Fault.at("motion_row_count", name, **params))
    return tuple(_row(row, read, question, name, i) for i, row in enumerate(rows))


def _row(
    cells: list[Any], read: ReadTable, question: DynamicsQuestion, *where: str | int
) -> tuple[Expression, ...]:
    return read_row(cells, question.table.n_joints, read, _known(question), where)


def _known(question: DynamicsQuestion) -> set[str]:
    return {*question.values, *_rates(question)}


def _rates(question: DynamicsQuestion) -> list[str]:
    return [rate_name(joint) for joint in range(1, question.table.n_joints + 1)]


def _rounded(
    body: CheckDynamicsRequest, answer: EquationsAnswer, read: ReadTable, question: DynamicsQuestion
) -> Rounded:
    """Return what entries with names are with each of their decimals moved by half a unit of its last."""
    typed = [*(body.M or ()), *(body.C or ()), *(row for row in (body.h, body.g) if row is not None)]
    meant = [*(answer.mass or ()), *(answer.coriolis or ())]
    meant += [row for row in (answer.velocity, answer.gravity) if row is not None]
    return roundings_of(
        chain.from_iterable(typed), chain.from_iterable(meant), read, _known(question), _rates(question)
    )
