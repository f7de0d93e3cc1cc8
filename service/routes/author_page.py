"""The page on which exercises are made."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from service.resources import resources_of
from service.settings import Publishers
from service.web.responses import page_response
from service.web.shell import Page

router = APIRouter(include_in_schema=False)

AUTHOR = Page(
    name="author",
    title="author-title",
    rooms=("author", "exercises", "kinds"),
    styles=("scene", "editor", "exercise", "playground", "author"),
)


@router.get("/author")
async def author(request: Request) -> Response:
    """Return a page for lecturers: make an exercise from a robot, look at it, try it, take it along."""
    resources = resources_of(request)
    publishing = resources.settings.publishing if resources.courses is not None else Publishers.NOBODY
    return page_response(request, AUTHOR, {"publishing": publishing.value})
