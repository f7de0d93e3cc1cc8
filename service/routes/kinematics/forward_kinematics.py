"""POST /forward-kinematics: joint values to poses."""

from functools import partial
from typing import Annotated

import numpy as np
from fastapi import Response
from pydantic import Field

from kinematics.errors import Fault
from service.http.openapi import NPY_QUERY, problems, request_body
from service.http.problems import RequestError
from service.http.routing import JSON, NPY, ApiRequest, BytesResponse, DirectRoute, api_router
from service.schemas.base import LONGEST_LIST, WHOLE, Matrix4, OneOf, Vector3, Wire
from service.schemas.kinematics.orientations import Orientation
from service.schemas.kinematics.robot_question import Joints, PlacedRobotQuestion
from service.schemas.tables import Units
from service.wire.kinematics.link_points import check_points
from service.wire.kinematics.pose_answers import (
    ARRAY_PARTS,
    STANDARD_PARTS,
    PoseQuantity,
    PoseQuestion,
    check_batch,
    json_blocks,
    npy_blocks,
    npy_length,
    one_answer,
    one_array,
)
from service.wire.kinematics.pose_matrices import base_and_tool
from service.wire.kinematics.robot_questions import QuestionReader, ReadQuestion, batch_response

router = api_router("kinematics", route_class=DirectRoute)

MOST_MAPPED = 64  # Points of links in a request, as many as a table may have rows.


class LinkPoint(Wire):
    """A point of a link."""

    frame: Annotated[int, Field(ge=1), WHOLE] = Field(
        description="number of the link's frame: its row, from 1"
    )
    at: Vector3 = Field(description="its coordinates in that frame")


class ForwardKinematicsQuestion(PlacedRobotQuestion):
    """What is asked of a robot, without the joint values."""

    inverse: bool = Field(False, description="whether the inverse of the transform is wanted as well")
    parts: list[OneOf[PoseQuantity]] | None = Field(
        None,
        max_length=LONGEST_LIST,
        min_length=1,
        description="the parts of the answer that are wanted; all but the inverse if left out",
    )

    points: list[LinkPoint] | None = Field(
        None, min_length=1, max_length=MOST_MAPPED, description="points of links whose places are wanted"
    )

    def wanted(self) -> tuple[PoseQuantity, ...]:
        """Return the parts of the answer, in the order of the enumeration."""
        if self.parts is None and not self.inverse:
            return STANDARD_PARTS
        chosen = set(self.parts if self.parts is not None else STANDARD_PARTS)
        if self.inverse:
            chosen.add(PoseQuantity.INVERSE)
        return tuple(part for part in PoseQuantity if part in chosen)


class ForwardKinematicsRequest(ForwardKinematicsQuestion):
    """A robot, and one configuration or a batch of them."""

    joints: Joints


class MappedPoint(Wire):
    """Where a point of link i is."""

    previous: Vector3 | list[Vector3] = Field(description="its coordinates in frame i-1")
    world: Vector3 | list[Vector3] = Field(description="its coordinates in the world, base included")


class ForwardKinematicsAnswer(Units):
    """Poses. Of a batch, every part has one more axis in front, the configuration."""

    transform: Matrix4 | list[Matrix4] | None = Field(None, description="⁰T_N, base and tool included")
    links: list[Matrix4] | list[list[Matrix4]] | None = Field(
        None, description="for each row the pose of frame i in frame i-1"
    )
    frames: list[Matrix4] | list[list[Matrix4]] | None = Field(
        None, description="for each row the pose of frame i in the world, base included"
    )
    position: Vector3 | list[Vector3] | None = Field(None, description="origin of the end frame")
    orientation: Orientation | None = None
    inverse: Matrix4 | list[Matrix4] | None = Field(None, description="the inverse of the transform")
    points: list[MappedPoint] | None = Field(None, description="the points that were asked for, in order")


_READER = QuestionReader(ForwardKinematicsQuestion, ForwardKinematicsRequest)
_ARRAY = {"schema": {"type": "string", "format": "binary"}}


@router.post(
    "/forward-kinematics",
    summary="Joint values to poses",
    response_model=ForwardKinematicsAnswer,
    response_model_exclude_none=True,
    responses={200: {"content": {NPY: _ARRAY}}, **problems(406, 503)},
    openapi_extra={**request_body(ForwardKinematicsRequest, x_npy=_ARRAY), **NPY_QUERY},
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
        check=partial(check_batch, question),
        length=npy_length(question) if offer == NPY else None,
    )


def _question(asked: ReadQuestion[ForwardKinematicsQuestion], offer: str) -> PoseQuestion:
    wire = asked.wire
    parts = STANDARD_PARTS if wire is None else wire.wanted()
    points = [(point.frame, point.at) for point in (wire.points if wire else None) or ()]
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
    return RequestError(Fault.at("npy_one_part", field, allowed=tuple(part.value for part in ARRAY_PARTS)))
