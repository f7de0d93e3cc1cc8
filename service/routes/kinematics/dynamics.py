"""How forces move a robot: numbers at one configuration, and equations of motion in closed form."""

from functools import partial
from typing import Any

import orjson
from fastapi import Response

from service.http.openapi import problems, request_body
from service.http.routing import JSON, ApiRequest, BytesResponse, DirectRoute, api_router
from service.http.validation import validated
from service.schemas.kinematics.dynamics_request import (
    DynamicsBody,
    DynamicsReply,
    NumericDynamicsRequest,
    SymbolicDynamicsRequest,
)
from service.wire.kinematics.dynamics import dynamics_task, numeric_answer, written_dynamics
from service.wire.kinematics.symbolic_tasks import closed_form

router = api_router("kinematics", route_class=DirectRoute)


@router.post(
    "/dynamics",
    summary="Torques, mass matrix, Coriolis and gravity terms, in numbers and in closed form",
    response_model=DynamicsReply,
    responses=problems(406, 503),
    openapi_extra=request_body(DynamicsBody),
)
async def dynamics(request: ApiRequest) -> Response:
    """Return the terms of M(q) q̈ + C(q, q̇) q̇ + g(q) = τ, for links with mass, centre of mass and inertia.

    In numbers at one configuration: M and g; with `rates` C, C q̇ and the kinetic energy; with
    `accelerations` the torque; with `torque` the accelerations. Answers are in SI units.

    With `"form": "symbolic"` and no joints, M, C and g are in closed form, written as in `/symbolic`;
    parameters without a value stay names.
    """
    request.accepts(JSON)
    body: Any = await request.json()
    if isinstance(body, dict) and body.get("form") == "symbolic":
        return await closed_form(request, SymbolicDynamicsRequest, dynamics_task, written_dynamics)
    asked = validated(NumericDynamicsRequest, body)
    found = await request.in_turn(partial(numeric_answer, asked, request.settings))
    return BytesResponse(orjson.dumps(found))
