"""What the API says of itself: the OpenAPI document, and what each refusal means."""

from collections.abc import Callable
from typing import Annotated, TypeVar

import orjson
from fastapi import Path, Request, Response

from kinematics.errors import Fault
from service.http.languages import language_for
from service.http.openapi import problems
from service.http.problems import NotFoundError, RequestPart
from service.http.routing import JSON, api_router
from service.messages import refusal_codes, template
from service.resources import resources_of
from service.schemas.base import Wire
from service.web.api_reference import POLICY, reference_page
from service.web.responses import text_response
from service.work.limiters import WorkKind

router = api_router("service")
_Drawn = TypeVar("_Drawn")


class Refusal(Wire):
    """What a refusal's code means."""

    code: str
    language: str
    message: str


@router.get("/openapi.json", include_in_schema=False)
async def openapi_document(request: Request) -> Response:
    """Return the OpenAPI document, with the address under which the caller reached it."""
    document = await _drawn(request, request.app.openapi)
    body = orjson.dumps({**document, "servers": [{"url": request.scope.get("root_path", "") or "/"}]})
    return text_response(request, body, JSON, {"Cache-Control": "no-cache"})


@router.get("/docs", include_in_schema=False)
async def reference(request: Request) -> Response:
    """Return the same as a page for people."""
    headers = {"Cache-Control": "no-cache", "Content-Security-Policy": POLICY}
    page = await _drawn(request, lambda: reference_page(request.app.openapi()))
    return Response(page, media_type="text/html", headers=headers)


async def _drawn(request: Request, work: Callable[[], _Drawn]) -> _Drawn:
    """Do work in a thread: the document takes most of a second to derive, once, and the page 20 ms."""
    return await resources_of(request).limiters[WorkKind.DRAWING].run(work)


@router.get("/problems/{code}", responses=problems(404), summary="What a refusal's code means")
async def problem(
    request: Request,
    response: Response,
    code: Annotated[str, Path(max_length=80, openapi_examples={"a cell": {"value": "parameter_missing"}})],
) -> Refusal:
    """Return the sentence behind a code, its parameters in braces: where the `type` of a problem leads."""
    language = language_for(request.headers.get("accept-language"))
    if code not in refusal_codes():
        raise NotFoundError(Fault.at("problem_unknown", "code", code=code[:80]), part=RequestPart.PATH)
    response.headers["Content-Language"] = language
    response.headers["Vary"] = "Accept-Language"
    return Refusal(code=code, language=language, message=template(language, f"error-{code}"))
