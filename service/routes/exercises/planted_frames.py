"""Mistakes planted in the frames of robots."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from kinematics.frames.assignment import assign_frames
from kinematics.frames.wrong_frames import plantable_in_frames, right_handed
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, api_router
from service.schemas.exercises.exercises import FigureFrame
from service.schemas.exercises.planting import PlantFrameMistakeAnswer, PlantFrameMistakeRequest
from service.schemas.spoken import option_name
from service.wire.exercises.planted_choice import chosen_mistake

router = api_router("exercises")

_EXAMPLES: dict[str, Any] = {
    "a SCARA": {
        "axes": [
            {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]},
            {"joint": "revolute", "point": [0.4, 0, 0], "direction": [0, 0, 1]},
            {"joint": "prismatic", "point": [0.65, 0, 0], "direction": [0, 0, 1]},
        ],
        "convention": "standard",
        "seed": "ana",
    },
}


@router.post(
    "/plant-frame-mistake",
    summary="Joint axes in, frames with a mistake out",
    responses=problems(400, 413, 415, 422, 503),
)
async def plant_frame_mistake(
    body: Annotated[PlantFrameMistakeRequest, body_with(_EXAMPLES)],
    request: ApiRequest,
) -> PlantFrameMistakeAnswer:
    """Return the frames by the procedure of the lecture, one of which breaks one rule of the convention.

    The seed decides which frame it is and what is wrong with it.
    """
    work = partial(_planted, body, language_of(request))
    return await request.resources.grading.run(work)


def _planted(body: PlantFrameMistakeRequest, language: str) -> PlantFrameMistakeAnswer:
    axes = [axis.axis() for axis in body.axes]
    assigned = assign_frames(axes, body.convention)
    frames = [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
    ways = plantable_in_frames(axes, body.convention, frames)
    code, chosen = chosen_mistake("plant-frame-mistake", body.seed, ways, "axes")
    return PlantFrameMistakeAnswer(
        frame=chosen.index,
        mistake=code,
        label=option_name(code, language),
        frames=[FigureFrame.from_record(frame) for frame in chosen.shown],
        mended=FigureFrame.from_record(chosen.right),
    )
