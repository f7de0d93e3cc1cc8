"""The trainer: frames attached to a robot's axes, step by step."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from service.web.responses import page_response
from service.web.shell import Page

router = APIRouter(include_in_schema=False)

TRAINER = Page(
    name="trainer",
    title="trainer-title",
    rooms=("trainer",),
    depth=1,
    styles=("scene", "exercise", "playground"),
)


@router.get("/trainer/{exercise}")
async def trainer(request: Request, exercise: str) -> Response:
    """Attach frames to the axes of an exercise's robot, by the rules of the procedure."""
    return page_response(request, TRAINER, {"id": exercise, "title": exercise})
