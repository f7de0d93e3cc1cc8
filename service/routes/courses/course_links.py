"""The links of a course, as its staff sees and changes them.

Every look at a student's work is in the audit log.
"""

from collections.abc import Callable, Iterable, Iterator
from datetime import timedelta
from typing import Any

from fastapi import Response
from fastapi.responses import StreamingResponse

from courses.attempts.stored_attempts import reports_of
from courses.grades.outbox import resend
from courses.links.link_settings import version_of, written
from courses.model import LinkSettings
from courses.people.enrolment import preview
from courses.people.secrets import issue_code
from courses.policies import Allowance
from courses.refusals import NoExerciseError
from courses.teaching.attempt_export import ExportedAttempt, exported_attempts
from courses.teaching.link_changes import allow, change_settings, release_feedback
from courses.teaching.statistics import (
    class_overview,
    link_statistics,
    misconceptions,
    undelivered,
    unexplained,
)
from exercises.errors import ExerciseError
from service.course_callers import (
    course_router,
    json_response,
    object_body,
    refused_setting,
    settings_in,
    staff_of,
)
from service.course_resources import now
from service.http.languages import language_of
from service.http.routing import JSON, ApiRequest
from service.wire.courses.course_views import csv_of, json_of, with_examples

router = course_router()

LONGEST_EXTRA = 366 * 24 * 60
MOST_EXTRA = 1000
"""A year in minutes, and more attempts than anybody makes: larger numbers are slips of the finger."""
PREVIEW_CODE = timedelta(minutes=2)
"""How long the code of a preview can be exchanged: the new window does it at once."""


@router.get("/course")
async def overview(request: ApiRequest) -> Response:
    """Return the class: links, students, how far each is, and scores that could not be delivered."""
    staff = await staff_of(request)
    course = staff.session.course
    members = await staff.run(staff.courses.class_members, course)
    found = await staff.run(class_overview, staff.store, course.id, members)
    lost = await staff.run(undelivered, staff.store, course.id)
    await staff.log("overview")
    links = [{**link, "exercise_title": _title(request, link["exercise"])} for link in found["links"]]
    return json_response(
        {
            "course": {"title": course.title, "members": members is not None},
            "link": staff.session.link.id,
            **found,
            "links": links,
            "undelivered": lost,
        }
    )


def _title(request: ApiRequest, exercise_id: str | None) -> str | None:
    """Return an exercise's title in the reader's language; its id, if it is no longer served or malformed."""
    if exercise_id is None:
        return None
    try:
        return request.resources.exercises.exercise(exercise_id).title(language_of(request))
    except ExerciseError:
        return exercise_id


@router.get("/course/links/{link}/settings")
async def show_settings(request: ApiRequest) -> Response:
    """Return the exercise and the rules of a link."""
    staff = await staff_of(request)
    link = await staff.link()
    return _settings_told(link.settings)


def _settings_told(settings: LinkSettings) -> Response:
    """Return settings with what tells them from others; it comes back with those that are made from them."""
    told = {"exercise": settings.exercise_id, **written(settings), "version": version_of(settings)}
    return json_response(told)


@router.put("/course/links/{link}/settings")
async def put_settings(request: ApiRequest) -> Response:
    """Give a link its exercise and rules; with the `version` they were made from, only if it still holds."""
    staff = await staff_of(request)
    link, body = await staff.link(), dict(await object_body(request))
    seen = body.pop("version", None)
    settings = settings_in(request, body)
    await staff.run(
        change_settings, staff.store, link.id, settings, now(), None if seen is None else str(seen)
    )
    await staff.log("settings", link=link.id, exercise=settings.exercise_id)
    return _settings_told(settings)


@router.get("/course/links/{link}/statistics")
async def statistics(request: ApiRequest) -> Response:
    """Return numbers of a link.

    Success, mistakes that were found, and wrong answers that nothing explains.
    """
    staff, language = await staff_of(request), language_of(request)
    link = await staff.link()

    def work() -> dict[str, Any]:
        mistakes = misconceptions(staff.store, link.id)
        reports = reports_of(staff.store, [entry["newest"] for entry in mistakes])
        return {
            **link_statistics(staff.store, link.id),
            "misconceptions": with_examples(mistakes, reports, language),
            "unexplained": unexplained(staff.store, link.id),
        }

    found = await staff.run(work)
    await staff.log("statistics", link=link.id)
    return json_response({"title": link.title, "exercise": link.settings.exercise_id, **found})


@router.post("/course/links/{link}/preview")
async def preview_link(request: ApiRequest) -> Response:
    """Return a code that opens the exercise of a link as a student would find it, by the link's rules."""
    staff = await staff_of(request)
    link = await staff.link()
    if link.settings.exercise_id is None:
        raise NoExerciseError

    def work() -> str:
        token = preview(staff.store, staff.session, link.id, now())
        return issue_code(staff.store, "session", {"token": token}, now(), PREVIEW_CODE)

    code = await staff.run(work)
    await staff.log("preview", link=link.id)
    return json_response({"exercise": link.settings.exercise_id, "code": code})


@router.post("/course/links/{link}/release")
async def release(request: ApiRequest) -> Response:
    """Show the students of a link what was found, and let their scores go."""
    staff = await staff_of(request)
    link = await staff.link()
    await staff.run(release_feedback, staff.store, link.id, now())
    await staff.log("release", link=link.id)
    return Response(status_code=204)


@router.post("/course/links/{link}/allowances")
async def give_allowance(request: ApiRequest) -> Response:
    """Give a student extra time or attempts."""
    staff = await staff_of(request)
    link, body = await staff.link(), await object_body(request)
    minutes, attempts = body.get("extra_minutes", 0), body.get("extra_attempts", 0)
    for name, value, most in (
        ("extra_minutes", minutes, LONGEST_EXTRA),
        ("extra_attempts", attempts, MOST_EXTRA),
    ):
        if type(value) is not int or not 0 <= value <= most:
            raise refused_setting(name, f"0 … {most}")
    allowance = Allowance(extra_time=timedelta(minutes=minutes), extra_attempts=attempts)
    person = str(body.get("person"))
    listed = await staff.run(staff.courses.class_members, staff.session.course) or {}
    await staff.run(allow, staff.store, link, person, allowance, now(), listed)
    await staff.log("allowance", subject=person, link=link.id, minutes=minutes, attempts=attempts)
    return Response(status_code=204)


@router.post("/course/links/{link}/resend")
async def resend_scores(request: ApiRequest) -> Response:
    """Send scores again that could not be delivered."""
    staff = await staff_of(request)
    link = await staff.link()
    count = await staff.run(resend, staff.store, link.id, now())
    return json_response({"scores": count})


@router.get("/course/links/{link}/export.csv")
async def export_csv(request: ApiRequest) -> Response:
    """Return every attempt of a link's students as CSV."""
    return await _export(request, csv_of, "text/csv; charset=utf-8")


@router.get("/course/links/{link}/export.json")
async def export_json(request: ApiRequest) -> Response:
    """Return every attempt of a link's students as JSON."""
    return await _export(request, json_of, JSON)


async def _export(
    request: ApiRequest, written_as: Callable[[Iterable[ExportedAttempt]], Iterator[bytes]], media: str
) -> Response:
    staff = await staff_of(request)
    link = await staff.link()
    await staff.log("export", link=link.id)
    blocks = written_as(exported_attempts(staff.store, link))
    return StreamingResponse(blocks, media_type=media, headers={"Cache-Control": "no-store"})
