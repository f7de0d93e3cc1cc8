"""Closed forms: every matrix of a table as a lecturer writes it, and as functions."""

from __future__ import annotations

from functools import partial

from fastapi import Response

from service.http.openapi import problems, request_body
from service.http.routing import JSON, ONE_ROBOT, ApiRequest, BytesResponse, DirectRoute, api_router
from service.http.validation import validated
from service.schemas.kinematics.symbolic_request import SYMBOLIC, SymbolicAnswer, SymbolicRequest
from service.wire.kinematics.symbolic_forms import written_answer
from service.wire.kinematics.symbolic_tasks import answered, matrices_task

router = api_router("kinematics", route_class=DirectRoute)


@router.post(
    "/symbolic",
    summary="Link, frame and end transforms in closed form",
    response_model=SymbolicAnswer,
    response_model_exclude_none=True,
    responses=problems(406, 503),
    openapi_extra=request_body(SymbolicRequest, SYMBOLIC),
)
async def symbolic(request: ApiRequest) -> Response:
    """Return ⁰T_N, all link transforms and frames in closed form; on request the inverse and Jacobians.

    Entries are nested from the last joint to the first, angles of parallel joints are added (c23), and
    multiples of π/12 are exact. Parameters without a value stay symbols. Matrices are in LaTeX, MathML,
    infix text, expression trees, a SymPy script, or as functions in ten programming languages, whose
    arguments are the joint variables and then the parameters. Angles are radians in all of them. What takes
    too long, or more memory than it may, is refused.
    """
    request.accepts(JSON)
    request.json_limits = ONE_ROBOT
    body = await request.json()
    question = b"symbolic" + await request.body()
    known = request.resources.symbolic_answers.get(question)
    if known is not None:
        return BytesResponse(known)
    wire = validated(SymbolicRequest, body)
    task = await request.in_turn(partial(matrices_task, wire, request.settings, wire.wanted()))
    return await answered(request, task, question, written_answer)
