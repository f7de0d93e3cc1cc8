"""Who asks something of a course: a signed-in student, or a member of its staff."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, TypeVar

from fastapi import APIRouter, Response

from courses.links.course_links import MOST_DIGITS, link_in
from courses.links.link_settings import read
from courses.model import CourseSession, Link, LinkSettings, Role
from courses.people.audit import log_access
from courses.refusals import StaffOnlyError, unknown_record
from kinematics.errors import Fault
from service.course_resources import CourseResources, bearer_token, now
from service.http.problems import RequestError
from service.http.routing import JSON, ApiRequest, DirectRoute, api_router
from service.messages import languages
from service.wire.exercises.ungraded import known_exercise
from service.wire.exercises.verdicts import encoded
from service.work.limiters import WorkKind
from service.work.session_grading import Grader, with_exercise_rules

_Result = TypeVar("_Result")


def course_router() -> APIRouter:
    """Return a router for calls of the pages of courses, which no OpenAPI describes."""
    router = api_router("courses", route_class=DirectRoute)
    router.include_in_schema = False
    return router


async def in_thread(request: ApiRequest, work: Callable[..., _Result], *arguments: Any) -> _Result:
    """Return the result of work that waits for the database."""
    return await request.resources.limiters[WorkKind.COURSES].run(partial(work, *arguments))


async def signed_in(request: ApiRequest) -> tuple[CourseResources, CourseSession]:
    """Return who is signed in by the request's bearer token.

    Raises:
        SessionError: nobody is.
    """
    courses = request.resources.with_courses()
    session = await courses.signed_in(bearer_token(request.headers.get("authorization", "")))
    return courses, with_exercise_rules(request.resources.exercises, session)


def grader_of(request: ApiRequest) -> Grader:
    """Return what judges answers by the application's exercises and limits."""
    resources = request.resources
    edition = resources.courses.edition if resources.courses else None
    return Grader(library=resources.exercises, limits=resources.settings.cell_limits, edition=edition)


def json_response(body: Any, status: int = 200) -> Response:
    """Return a body that no cache keeps."""
    return Response(encoded(body), status_code=status, media_type=JSON, headers={"Cache-Control": "no-store"})


class Staff:
    """A member of the staff who asks for something of their course."""

    def __init__(self, request: ApiRequest, courses: CourseResources, session: CourseSession) -> None:
        self.request, self.store, self.session = request, courses.store, session
        self.courses = courses

    async def run(self, work: Callable[..., _Result], *arguments: Any) -> _Result:
        """Return the result of work that waits for the database."""
        return await in_thread(self.request, work, *arguments)

    async def link(self) -> Link:
        """Return the link of the address, which is in this course."""
        return await self.run(
            link_in, self.store, self.session.course.id, record_number(self.request, "link")
        )

    async def log(self, action: str, *, subject: str | None = None, **details: Any) -> None:
        """Record what is done."""
        work = partial(log_access, self.store, self.session, action, now(), subject=subject, details=details)
        await self.run(work)


async def staff_of(request: ApiRequest) -> Staff:
    """Return the member of the staff who is signed in.

    Raises:
        SessionError: nobody is signed in.
        StaffOnlyError: a student is.
    """
    courses, session = await signed_in(request)
    if session.role is not Role.STAFF:
        raise StaffOnlyError
    return Staff(request, courses, session)


def record_number(request: ApiRequest, name: str) -> int:
    """Return the number of a record from the address.

    Raises:
        UnknownRecordError: it is no number that a record could have.
    """
    text = request.path_params[name]
    if not text.isdecimal() or len(text) > MOST_DIGITS:
        raise unknown_record(name)
    return int(text)


def refused_setting(name: str, known: str) -> RequestError:
    """Return the refusal of a value that cannot be meant, with those that can."""
    return RequestError(Fault.at("setting_invalid", name, name=name, known=known))


async def object_body(request: ApiRequest) -> Mapping[str, Any]:
    """Return the body's fields.

    Raises:
        RequestError: the body is no object.
    """
    body = await request.json()
    if not isinstance(body, dict):
        raise RequestError(Fault.at("setting_invalid", name="body", known="object"))
    return body


def settings_in(request: ApiRequest, body: Mapping[str, Any]) -> LinkSettings:
    """Return the exercise and the rules that a body gives a link.

    Raises:
        NotFoundError: there is no such exercise.
        LinkSettingsError: a rule cannot be meant.
    """
    with known_exercise():
        exercise = request.resources.exercises.exercise(str(body.get("exercise")))
    rules = {name: value for name, value in body.items() if name != "exercise"}
    return read(exercise.id, rules, parts=[part.kind for part in exercise.parts], languages=languages())
