"""From one description of a robot to another."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from service.http.openapi import body_with
from service.http.routing import ApiRequest, OneRobotRoute, api_router
from service.schemas import examples
from service.schemas.kinematics.conversion import ConvertAnswer, ConvertRequest
from service.wire.kinematics.conversion import converted

router = api_router("kinematics", route_class=OneRobotRoute)


@router.post("/convert", summary="From one description of a robot to another")
async def convert(
    body: Annotated[ConvertRequest, body_with(examples.CONVERT)], request: ApiRequest
) -> ConvertAnswer:
    """Return another description of the same robot, without loss.

    For a DH table of the other convention, base · (new table) · tool equals the old table for every q.
    Entries are moved, not computed, so parameters and spellings stay. For a product of exponentials, every
    parameter needs a value.
    """
    return await request.in_turn(partial(converted, body, request.settings))
