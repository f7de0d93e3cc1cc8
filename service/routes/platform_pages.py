"""Pages about platforms: the administrator's, and what a lecturer sends to a platform's own."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from service.http.forms import own_root
from service.resources import resources_of
from service.web.responses import page_response
from service.web.shell import Page

router = APIRouter(include_in_schema=False)

PLATFORMS = Page(name="platforms", title="platforms-title", rooms=("platforms",), styles=("lecturer",))
CONNECT = Page(name="connect", title="connect-title", rooms=("platforms",), depth=1, styles=("lecturer",))


@router.get("/platforms")
async def platforms_page(request: Request) -> Response:
    """Return the administrator's page: who may launch."""
    resources_of(request).with_courses()
    return page_response(request, PLATFORMS)


@router.get("/lti/connect")
async def connect_page(request: Request) -> Response:
    """Return what a platform has to know of this tool, to be sent to its administrator."""
    resources_of(request).with_courses()
    root = own_root(request, resources_of(request).settings.public_url)
    return page_response(request, CONNECT, {"address": root})
