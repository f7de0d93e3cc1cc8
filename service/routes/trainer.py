"""The trainer: frames attached to a robot's axes, step by step."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from exercises.errors import UnknownExerciseError
from service.resources import resources_of
from service.web.responses import missing_page, page_language, page_response
from service.web.shell import Page

router = APIRouter(include_in_schema=False)

TRAINER = Page(
    name="trainer",
    title="trainer-title",
    rooms=("trainer",),
    depth=1,
    styles=("scene", "exercise", "playground"),
)


@router.get("/trainer/{exercise_id}")
async def trainer(request: Request, exercise_id: str) -> Response:
    """Attach frames to the axes of an exercise's robot, by the rules of the procedure."""
    try:
        found = resources_of(request).exercises.exercise(exercise_id)
    except UnknownExerciseError:
        return missing_page(request)
    return page_response(request, TRAINER, {"id": found.id, "title": found.title(page_language(request))})
