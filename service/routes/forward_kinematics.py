"""Joint values to poses."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from fastapi import Response
from pydantic import TypeAdapter

from kinematics.errors import Fault
from service.batches import BatchResponse, Gate
from service.configurations import plain_configuration, read_array, read_joints
from service.decoding import decode_json
from service.errors import BodyError, Place, RequestError
from service.npy import read_npy
from service.openapi import problems, request_body
from service.poses import (
    ARRAY_PARTS,
    PoseQuestion,
    json_blocks,
    npy_blocks,
    npy_length,
    one_answer,
    one_array,
    refuse_overflow,
)
from service.preparation import Preparation
from service.routing import JSON, NPY, ApiRequest, DirectRoute, Written, api_router
from service.schemas import examples
from service.schemas.forward_kinematics import (
    STANDARD_PARTS,
    ForwardKinematicsAnswer,
    ForwardKinematicsQuestion,
    ForwardKinematicsRequest,
    Part,
)
from service.validation import validated

router = api_router("kinematics", route_class=DirectRoute)

_REQUEST: TypeAdapter[ForwardKinematicsRequest] = TypeAdapter(ForwardKinematicsRequest)
_QUESTION: TypeAdapter[ForwardKinematicsQuestion] = TypeAdapter(ForwardKinematicsQuestion)
_NPY = NPY.encode()
_SMALL = 64
_USUAL = {"table", "robot", "parameters", "joints"}
_ARRAY = {"schema": {"type": "string", "format": "binary"}}


@router.post(
    "/forward-kinematics",
    summary="Joint values to poses",
    response_model=ForwardKinematicsAnswer,
    response_model_exclude_none=True,
    responses={200: {"content": {NPY: _ARRAY}}, **problems(406, 503)},
    openapi_extra=request_body(ForwardKinematicsRequest, examples.FORWARD_KINEMATICS, x_npy=_ARRAY),
)
async def forward_kinematics(request: ApiRequest) -> Response:
    """⁰T_N, every link transform and every joint frame, of one configuration or of a batch.

    A batch may also come as `application/x-npy`: the body is the array of joint values, a configuration in each
    row; the query parameter `request` holds the rest of the request as JSON, or `robot` the id of a robot of
    the catalogue. With `Accept: application/x-npy` the answer is such a file too: the transforms, or the one
    array named in `parts`.
    """
    offer = request.accepts(JSON, NPY)
    request.body_limit = request.settings.batch_body_limit
    if request.fields.get(b"content-type", b"").startswith(_NPY):
        question = await _from_npy(request)
    else:
        body = await request.json(NPY)
        question = _recalled(body, request) or _read(body, request)
    if offer == NPY:
        question = _one_array_of(question)
    if not isinstance(question.joints, np.ndarray):
        written = one_array(question) if offer == NPY else one_answer(question)
        return Written(written, offer)
    return await _batch(question, offer, request)


def _recalled(body: Any, request: ApiRequest) -> PoseQuestion | None:
    """The question of a plain body about a robot that was prepared before: nothing is left to validate."""
    if type(body) is not dict or not _USUAL.issuperset(body):
        return None
    robot = _preparation(request).recall(body)
    joints = None if robot is None else plain_configuration(body.get("joints"), robot)
    if robot is None or joints is None:
        return None
    return PoseQuestion(robot=robot, joints=joints, parts=STANDARD_PARTS)


def _read(body: Any, request: ApiRequest) -> PoseQuestion:
    wire = validated(_REQUEST, body)
    robot = _preparation(request).prepare(wire, body)
    joints = read_joints(wire.joints, robot, request.settings.batch_limit)
    return PoseQuestion(robot=robot, joints=joints, base=wire.base, tool=wire.tool, parts=wire.wanted())


async def _from_npy(request: ApiRequest) -> PoseQuestion:
    request.media_type()
    body = _question_in_query(request)
    wire = validated(_QUESTION, body)
    robot = _preparation(request).prepare(wire, body)
    joints = read_array(read_npy(await request.body()), robot, request.settings.batch_limit)
    return PoseQuestion(robot=robot, joints=joints, base=wire.base, tool=wire.tool, parts=wire.wanted())


def _question_in_query(request: ApiRequest) -> Mapping[str, Any]:
    given = request.query_params
    if set(given) == {"robot"}:
        return {"robot": given["robot"]}
    if set(given) != {"request"}:
        raise RequestError(
            Fault(
                code="query_missing",
                message="the joints came as npy; the rest of the request belongs, as JSON, in the query "
                "parameter “request”",
                where=("request",),
            ),
            place=Place.QUERY,
        )
    try:
        body: Mapping[str, Any] = decode_json(given["request"].encode())
    except BodyError as error:
        raise BodyError(error.faults, place=Place.QUERY) from None
    return body


def _one_array_of(question: PoseQuestion) -> PoseQuestion:
    """The question with the one part that an npy file can hold."""
    parts = (Part.TRANSFORM,) if tuple(question.parts) == STANDARD_PARTS else tuple(question.parts)
    if len(parts) != 1 or parts[0] not in ARRAY_PARTS:
        raise RequestError(
            Fault(
                code="npy_one_part",
                message=f"an npy file holds one array; name one part: {', '.join(ARRAY_PARTS)}",
                where=("parts",),
                params={"allowed": tuple(part.value for part in ARRAY_PARTS)},
            )
        )
    return PoseQuestion(
        robot=question.robot, joints=question.joints, base=question.base, tool=question.tool, parts=parts
    )


async def _batch(question: PoseQuestion, offer: str, request: ApiRequest) -> Response:
    """A small batch at once; a large one in a thread, sent while it is computed."""
    blocks = npy_blocks if offer == NPY else json_blocks
    if len(question.joints) <= _SMALL:
        refuse_overflow(question)
        return Written(b"".join(blocks(question)), offer)
    gate: Gate = request.scope["app"].state.gate
    place = gate.enter()
    try:
        await place.run(lambda: refuse_overflow(question))
    except BaseException:
        place.leave()
        raise
    headers = {"Content-Length": str(npy_length(question))} if offer == NPY else None
    return BatchResponse(blocks(question), place, offer, headers)


def _preparation(request: ApiRequest) -> Preparation:
    preparation: Preparation = request.scope["app"].state.preparation
    return preparation
