"""Publishing exercises: a version is kept for good, for those who may publish here."""

from functools import partial

from fastapi import Response

from courses.links.publications import publish
from courses.model import Role
from courses.people.secrets import check_code
from courses.refusals import StaffOnlyError
from exercises.authoring.trials import trial
from kinematics.errors import Fault
from service.course_callers import in_thread, json_response, signed_in
from service.course_resources import now
from service.http.problems import ForbiddenError
from service.http.routing import ApiRequest, api_router
from service.schemas.exercises import authoring as wire
from service.settings import Publishers
from service.wire.exercises.drafts import draft_refused
from service.work.workers import Lane

router = api_router("authoring")


@router.post(
    "/author/publish",
    response_model=wire.PublishedAnswer,
    summary="Publish a draft",
    include_in_schema=False,  # like all that needs storage
)
async def publish_draft(body: wire.PublishRequest, request: ApiRequest) -> Response:
    """Keep this version of the exercise under an address of its own, for good.

    The address is made from the content. It is in no list; whoever has it can use the exercise as any
    other, in links of a course, too. Who may publish is the operator's to say (`FRAMEWISE_PUBLISHING`).
    """
    courses = request.resources.with_courses()
    await _admit(request, body.choice)
    draft = body.draft.draft()
    with draft_refused():
        await request.resources.workers.run(Lane.SLOW, trial, draft)
    found = await in_thread(request, partial(publish, courses.store, draft, now()))
    return json_response({"id": found.address, "digest": found.digest})


async def _admit(request: ApiRequest, choice: str | None) -> None:
    """Let those through who may publish here.

    A key that reaches this call has the scope for it: without, it was refused before.

    Raises:
        ForbiddenError: nobody may, or not without a key, or not without coming from a course.
        StaffOnlyError: a student is signed in.
        SessionError: nobody is signed in by the token, or the choice has been made.
    """
    allowed = request.settings.publishing
    if allowed is Publishers.ANYONE:
        return
    if allowed is not Publishers.NOBODY and request.scope.get("api_key") is not None:
        return
    if allowed is Publishers.STAFF and choice is not None:
        store = request.resources.with_courses().store
        await in_thread(request, check_code, store, "deep-link", choice, now())
        return
    if allowed is Publishers.STAFF and request.headers.get("authorization") is not None:
        _, session = await signed_in(request)
        if session.role is not Role.STAFF:
            raise StaffOnlyError
        return
    raise ForbiddenError(Fault.at("publishing_closed", who=allowed.value))
