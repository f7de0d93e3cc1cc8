"""The first lesson: what the four numbers are, and how frames are chosen."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from service.web.responses import page_response
from service.web.shell import Page

router = APIRouter(include_in_schema=False)

LESSON = Page(
    name="lesson",
    title="lesson-title",
    rooms=("lesson",),
    styles=("scene", "exercise", "playground"),
)


@router.get("/lesson")
async def lesson(request: Request) -> Response:
    """Return a page to read before the first exercise; what is drawn in it can be moved."""
    return page_response(request, LESSON)
