"""The playground: any table, and everything that the service can say of it."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from service.web.responses import page_response
from service.web.shell import Page

router = APIRouter(include_in_schema=False)

PLAYGROUND = Page(
    name="playground",
    title="playground-title",
    rooms=("playground",),
    styles=("editor", "scene", "exercise", "playground"),
)


@router.get("/playground")
async def playground(request: Request) -> Response:
    """Return a page to project in class: type any table, or take a robot of the catalogue."""
    return page_response(request, PLAYGROUND)
