"""From joint axes to frames and a DH table."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from service.http.languages import language_of
from service.http.openapi import body_with
from service.http.routing import ApiRequest, api_router
from service.messages import sentence
from service.schemas.kinematics.frame_assignment_models import (
    AssignFramesAnswer,
    AssignFramesRequest,
    CheckFramesAnswer,
    CheckFramesRequest,
)
from service.wire.kinematics.frame_assignment import Say, assigned, checked

router = api_router("kinematics")

_ELBOW = [
    {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]},
    {"joint": "revolute", "point": [0, 0, 0.4], "direction": [0, -1, 0]},
    {"joint": "revolute", "point": [0.5, 0, 0.4], "direction": [0, -1, 0]},
]
_ASSIGN: dict[str, Any] = {
    "an elbow arm with a gripper": {
        "axes": _ELBOW,
        "convention": "standard",
        "angle_unit": "deg",
        "tool": {"point": [0.9, 0, 0.4], "approach": [1, 0, 0], "jaws": [0, 1, 0]},
    }
}
_CHECK: dict[str, Any] = {
    "two frames of three, one of them broken": {
        "axes": _ELBOW,
        "convention": "modified",
        "angle_unit": "deg",
        "frames": [
            {"origin": [0, 0, 0], "x": [1, 0, 0], "z": [0, 0, 1]},
            {"origin": [0, 0, 0.4], "x": [0, 1, 0], "z": [0, 0, 1]},
        ],
    }
}


@router.post("/assign-frames", summary="Joint axes in, a DH table out")
async def assign(
    request: ApiRequest, body: Annotated[AssignFramesRequest, body_with(_ASSIGN)]
) -> AssignFramesAnswer:
    """Assign frames by the procedure of the lecture documents, each with its rule and its free choices.

    Free choices make as many parameters as possible vanish: d = 0 along parallel runs, frame 0 on frame 1 at
    zero, the last x along the previous one. base · table · tool reproduces every axis and the tool.
    """
    return await request.in_turn(partial(assigned, body, _speaker(language_of(request))))


@router.post("/check-frames", summary="A student's frames, judged rule by rule")
async def check(
    request: ApiRequest, body: Annotated[CheckFramesRequest, body_with(_CHECK)]
) -> CheckFramesAnswer:
    """Return the rules that the chosen frames break, the choices there are, and the rows that follow."""
    return await request.in_turn(partial(checked, body, _speaker(language_of(request))))


def _speaker(language: str) -> Say:
    def say(identifier: str, params: dict[str, object]) -> str:
        return sentence(language, identifier, params) or identifier

    return say
