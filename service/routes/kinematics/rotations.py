"""Orientations in every notation, and answers about them."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from service.http.languages import language_of
from service.http.openapi import body_with
from service.http.routing import ApiRequest, api_router
from service.messages import sentence
from service.schemas.kinematics.rotations import (
    CheckRotationAnswer,
    CheckRotationRequest,
    RotationsAnswer,
    RotationsRequest,
)
from service.wire.kinematics.orientations import all_notations, checked_rotation

router = api_router("kinematics")

_QUARTER = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
_ROTATIONS: dict[str, Any] = {
    "roll, pitch and yaw": {
        "angle_unit": "deg",
        "orientation": {"angles": [30, 45, -60], "axes": "XYZ", "turning": "fixed"},
    },
    "gimbal lock": {"angle_unit": "deg", "orientation": {"angles": [20, 90, 10]}},
    "a reflection": {"orientation": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}},
}
_CHECK: dict[str, Any] = {
    "the negative of a quaternion": {
        "expected": {"matrix": _QUARTER},
        "answer": {"quaternion": [-0.7071, 0, 0, -0.7071]},
    },
    "both triples": {
        "angle_unit": "deg",
        "expected": {"angles": [30, 60, -45], "axes": "ZYZ"},
        "answer": {"triples": [[30, 60, -45], [210, -60, 135]], "axes": "ZYZ"},
        "every": True,
    },
    "fixed axes for current ones": {
        "angle_unit": "deg",
        "expected": {"angles": [30, 45, -60]},
        "answer": {"angles": [30, 45, -60], "turning": "fixed"},
    },
}


@router.post("/rotations", summary="One orientation in every notation")
async def rotations(
    request: ApiRequest, body: Annotated[RotationsRequest, body_with(_ROTATIONS)]
) -> RotationsAnswer:
    """Return the matrix, quaternion, axis and angle, and both solutions for the angles of all 24 sequences.

    At gimbal lock the whole family is given: the middle angle, and the sum or difference of the others that
    is fixed. For a matrix that is not a rotation, the answer lists the properties that fail.
    """
    return await request.in_turn(partial(all_notations, body))


@router.post("/check-rotation", summary="Does an answer mean this orientation?")
async def check_rotation(
    request: ApiRequest, body: Annotated[CheckRotationRequest, body_with(_CHECK)]
) -> CheckRotationAnswer:
    """Return whether an answer in any notation means the orientation, and what a wrong one looks like.

    q and −q are the same, as are (k, θ) and (−k, −θ), angles that differ by full turns, and both triples of
    angles. With `every`, all triples are asked: both, or the family at gimbal lock.
    """
    language = language_of(request)
    return await request.in_turn(
        partial(checked_rotation, body, lambda name: sentence(language, name) or name)
    )
