"""Joint values to poses."""

from __future__ import annotations

import numpy as np
from fastapi import Response

from kinematics.errors import Fault
from service.http.openapi import NPY_QUERY, problems, request_body
from service.http.problems import RequestError
from service.http.routing import JSON, NPY, ApiRequest, BytesResponse, DirectRoute, api_router
from service.schemas import examples
from service.schemas.kinematics.forward_kinematics import (
    STANDARD_PARTS,
    ForwardKinematicsAnswer,
    ForwardKinematicsQuestion,
    ForwardKinematicsRequest,
    PoseQuantity,
)
from service.wire.kinematics.pose_answers import (
    ARRAY_PARTS,
    PoseQuestion,
    check_points,
    json_blocks,
    may_overflow,
    npy_blocks,
    npy_length,
    one_answer,
    one_array,
    refuse_overflow,
)
from service.wire.kinematics.pose_matrices import base_and_tool
from service.wire.kinematics.robot_questions import QuestionReader, ReadQuestion, batch_response

router = api_router("kinematics", route_class=DirectRoute)

_READER = QuestionReader(ForwardKinematicsQuestion, ForwardKinematicsRequest)
_ARRAY = {"schema": {"type": "string", "format": "binary"}}


@router.post(
    "/forward-kinematics",
    summary="Joint values to poses",
    response_model=ForwardKinematicsAnswer,
    response_model_exclude_none=True,
    responses={200: {"content": {NPY: _ARRAY}}, **problems(406, 503)},
    openapi_extra={
        **request_body(ForwardKinematicsRequest, examples.FORWARD_KINEMATICS, x_npy=_ARRAY),
        **NPY_QUERY,
    },
)
async def forward_kinematics(request: ApiRequest) -> Response:
    """Return ⁰T_N, every link transform and every frame, of one configuration or of a batch.

    A batch may also come as `application/x-npy`: the body is the array of joint values, one row each;
    the query parameter `request` holds the rest of the request as JSON, or `robot` the id of a robot of
    the catalogue. With `Accept: application/x-npy` the answer is such a file, too: the transforms, or the one
    array named in `parts`. `points` of links are mapped into the previous frame and into the world.
    """
    offer = request.accepts(JSON, NPY)
    asked = await _READER.read(request)
    question = _question(asked, offer)
    if not isinstance(question.joints, np.ndarray):
        return BytesResponse(one_array(question) if offer == NPY else one_answer(question), offer)
    blocks = npy_blocks if offer == NPY else json_blocks
    return await batch_response(
        asked,
        request,
        offer,
        blocks=lambda: blocks(question),
        check=(lambda: refuse_overflow(question)) if may_overflow(question) else None,
        length=npy_length(question) if offer == NPY else None,
    )


def _question(asked: ReadQuestion[ForwardKinematicsQuestion], offer: str) -> PoseQuestion:
    wire = asked.wire
    parts = STANDARD_PARTS if wire is None else wire.wanted()
    points = (wire.points if wire else None) or []
    check_points(asked.robot, points)
    base, tool = (None, None) if wire is None else base_and_tool(wire, asked.robot.angle)
    if points and offer == NPY:
        raise _one_part("points")
    return PoseQuestion(
        points=points,
        robot=asked.robot,
        joints=asked.joints,
        base=base,
        tool=tool,
        parts=_one_array(parts) if offer == NPY else parts,
    )


def _one_array(parts: tuple[PoseQuantity, ...]) -> tuple[PoseQuantity, ...]:
    """The one part that an npy file can hold."""
    if parts is STANDARD_PARTS:
        return (PoseQuantity.TRANSFORM,)
    if len(parts) != 1 or parts[0] not in ARRAY_PARTS:
        raise _one_part("parts")
    return parts


def _one_part(field: str) -> RequestError:
    params = {"allowed": tuple(part.value for part in ARRAY_PARTS)}
    return RequestError(Fault.at("npy_one_part", field, **params))
