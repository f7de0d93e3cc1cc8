"""The page between a learning platform and the exercise: what a launch, or a registration, does next."""

import logging
from collections.abc import Callable, Mapping
from dataclasses import replace
from urllib.parse import urlencode

from fastapi import Request, Response

from courses.refusals import CourseError
from kinematics.errors import KinematicsError
from service.http.problem_answers import REQUEST_ID
from service.http.problem_documents import problem_of
from service.http.problems import ServiceError
from service.messages import sentence
from service.resources import resources_of
from service.web.responses import page_language, page_response
from service.web.shell import Page
from service.work.limiters import WorkKind

LAUNCH = Page(name="launch", title="session-launch-title", messages=("session",), depth=1)
REGISTRATION = replace(LAUNCH, title="session-registration-title", depth=2)

_log = logging.getLogger("framewise.lti")


async def answered(request: Request, work: Callable[[], Response], page: Page = LAUNCH) -> Response:
    """Return what work in a thread answers; its refusal as a page for people, as a problem for programs.

    Raises:
        ServiceError, CourseError: the work was refused, and the caller takes no HTML.
    """
    resources = resources_of(request)
    resources.with_courses()
    try:
        return await resources.limiters[WorkKind.COURSES].run(work)
    except (ServiceError, CourseError) as error:
        return refused(request, error, page)


def refused(request: Request, error: ServiceError | KinematicsError, page: Page = LAUNCH) -> Response:
    """Return a refusal as a page for people, or raise it; logged with its code and no secret."""
    problem = problem_of(error, request.scope.get(REQUEST_ID, ""))
    route = request.scope["route"].path  # an address may hold an invitation's secret
    _log.warning("refused %s: %s (%s)", route, error.faults[0].code, problem.request_id)
    if "text/html" not in request.headers.get("accept", ""):
        raise error
    fault = error.faults[0]
    again = error.members.get("again") if isinstance(error, ServiceError) else None
    text = sentence(page_language(request), f"error-{fault.code}", fault.params) or fault.code
    values = step("window" if again else "refused", text=text, again=again or {})
    return launch_page(request, values, page, status=problem.status)


def step(name: str, *, text: str = "", again: object = None, **values: str) -> dict[str, str]:
    """Return what the page does next, as its template takes it."""
    fields = {"address": "", "key": "", "value": "", "frame": "", "origin": "", "code": "", **values}
    fields["again"] = urlencode(again) if isinstance(again, Mapping) else ""
    return {"step": name, "text": text, **fields}


def launch_page(
    request: Request, values: Mapping[str, str], page: Page = LAUNCH, *, status: int = 200
) -> Response:
    """Return the page, which no cache may store.

    What a person reads may stand in any frame: who is refused, or is about to register, is no platform whose
    frames are known.
    """
    read = bool(values["text"])
    response = page_response(request, page, values, status=status, in_any_frame=read)
    response.headers["Cache-Control"] = "no-store"
    return response
