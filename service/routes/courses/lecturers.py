"""What the staff of a course sees and changes. Every look at a student's work is in the audit log."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import date, timedelta
from functools import partial
from typing import Any, TypeVar

from fastapi import Response
from fastapi.responses import StreamingResponse

from courses.attempt_export import exported_attempts
from courses.audit import log_access
from courses.enrolment import preview
from courses.judged import AttemptFilter, Outcome, Progress, attempts_behind
from courses.link_settings import read, written
from courses.links import (
    allow,
    attempt_in,
    change_settings,
    link_in,
    release_feedback,
    reports_of,
)
from courses.model import CourseSession, Link, Role
from courses.outbox import resend
from courses.platforms import platform_by_id
from courses.policies import Allowance, Shown
from courses.privacy import erase_person, export_person, person_in
from courses.refusals import NoExerciseError, StaffOnlyError, unknown_record
from courses.regrading import Scope, apply, begin, changes, rejudge
from courses.secrets import issue_code, redeem_code
from courses.statistics import class_overview, link_statistics, misconceptions, undelivered, unexplained
from exercises.errors import ExerciseError
from kinematics.errors import Fault
from service.course_resources import CourseResources, now
from service.http.forms import own_root
from service.http.languages import language_of
from service.http.problems import RequestError
from service.http.routing import ApiRequest, DirectRoute, api_router
from service.lti.deep_links import ContentItem, response_token, takes_line_items
from service.resources import resources_of
from service.routes.courses.course_sessions import grader_of, in_thread, json_response, signed_in
from service.wire.courses.course_views import attempt_record, csv_of, with_examples
from service.wire.courses.lti_custom import custom_of
from service.wire.courses.session_views import attempt_view
from service.wire.exercises.ungraded import known_exercise
from service.work.regrading_processes import RegradingProcesses
from service.work.session_grading import asked_exercise

router = api_router("courses", route_class=DirectRoute)
router.include_in_schema = False

_Result = TypeVar("_Result")
LONGEST_EXTRA = 366 * 24 * 60
MOST_EXTRA = 1000
"""A year in minutes, and more attempts than anybody makes: larger numbers are slips of the finger."""
PREVIEW_CODE = timedelta(minutes=2)
"""How long the code of a preview can be exchanged: the new window does it at once."""


class _Staff:
    """A member of the staff who asks for something of their course."""

    def __init__(self, request: ApiRequest, courses: CourseResources, session: CourseSession) -> None:
        self.request, self.store, self.session = request, courses.store, session
        self.courses = courses

    async def run(self, work: Callable[..., _Result], *arguments: Any) -> _Result:
        """Return the result of work that waits for the database."""
        return await in_thread(self.request, work, *arguments)

    async def link(self) -> Link:
        """Return the link of the address, which is in this course."""
        return await self.run(link_in, self.store, self.session.course.id, _number(self.request, "link"))

    async def log(self, action: str, *, subject: str | None = None, **details: Any) -> None:
        """Write down what is done."""
        work = partial(log_access, self.store, self.session, action, now(), subject=subject, details=details)
        await self.run(work)


async def _staff(request: ApiRequest) -> _Staff:
    courses, session = await signed_in(request)
    if session.role is not Role.STAFF:
        raise StaffOnlyError
    return _Staff(request, courses, session)


def _number(request: ApiRequest, name: str) -> int:
    text = request.path_params[name]
    if not text.isdecimal() or len(text) > 9:
        raise unknown_record(name)
    return int(text)


async def _told(request: ApiRequest) -> Mapping[str, Any]:
    body = await request.json()
    if not isinstance(body, dict):
        raise RequestError(Fault(code="setting_invalid", params={"name": "body", "known": "object"}))
    return body


@router.get("/course")
async def overview(request: ApiRequest) -> Response:
    """Return the class: links, students, how far each is, and scores that could not be delivered."""
    staff = await _staff(request)
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
        return resources_of(request).exercises.exercise(exercise_id).title(language_of(request))
    except ExerciseError:
        return exercise_id


@router.get("/course/links/{link}/settings")
async def show_settings(request: ApiRequest) -> Response:
    """Return the exercise and the rules of a link."""
    staff = await _staff(request)
    link = await staff.link()
    return json_response({"exercise": link.settings.exercise_id, **written(link.settings)})


@router.put("/course/links/{link}/settings")
async def put_settings(request: ApiRequest) -> Response:
    """Give a link its exercise and rules."""
    staff = await _staff(request)
    link, body = await staff.link(), await _told(request)
    settings = read(_known_exercise(request, body.get("exercise")), body)
    await staff.run(change_settings, staff.store, link.id, settings, now())
    await staff.log("settings", link=link.id, exercise=settings.exercise_id)
    return json_response({"exercise": settings.exercise_id, **written(settings)})


def _known_exercise(request: ApiRequest, exercise_id: object) -> str:
    with known_exercise():
        return resources_of(request).exercises.exercise(str(exercise_id)).id


@router.get("/course/links/{link}/statistics")
async def statistics(request: ApiRequest) -> Response:
    """Return numbers of a link.

    Success, mistakes that were found, and wrong answers that nothing explains.
    """
    staff, language = await _staff(request), language_of(request)
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


@router.get("/course/links/{link}/attempts")
async def list_attempts(request: ApiRequest) -> Response:
    """Return the attempts behind a number: with a code, of a cluster (`ids`), a student, a step, a state."""
    staff = await _staff(request)
    link, asked = await staff.link(), request.query_params
    named = asked.get("ids", "").split(",")[:200]
    ids = tuple(int(text) for text in named if text.isdecimal() and len(text) < 10)
    chosen = AttemptFilter(
        kind=asked.get("kind"),
        code=asked.get("code"),
        ids=ids,
        person=asked.get("person"),
        day=_day(asked.get("day")),
        number=int(text) if (text := asked.get("number", "")).isdecimal() and len(text) < 7 else None,
        correct=_choice(asked, "correct", {"true": True, "false": False}),
        outcome=_choice(asked, "outcome", {each.value: each for each in Outcome}),
        progress=_choice(asked, "state", {each.value: each for each in Progress}),
    )
    found = await staff.run(attempts_behind, staff.store, link.id, chosen)
    await staff.log("attempts", subject=asked.get("person"), link=link.id)
    return json_response({"attempts": found})


def _choice(asked: Mapping[str, str], name: str, known: Mapping[str, _Result]) -> _Result | None:
    """Return what a word of the query means; None if it is not there.

    Raises:
        RequestError: it is another word.
    """
    text = asked.get(name)
    if text is None:
        return None
    if text not in known:
        params = {"name": name, "known": ", ".join(known)}
        raise RequestError(Fault(code="setting_invalid", where=(name,), params=params))
    return known[text]


def _day(text: str | None) -> date | None:
    """Return the day of the query.

    Raises:
        RequestError: it is none.
    """
    if text is None:
        return None
    try:
        return date.fromisoformat(text)
    except ValueError:
        params = {"name": "day", "known": "2027-03-01"}
        raise RequestError(Fault(code="setting_invalid", where=("day",), params=params)) from None


@router.post("/course/links/{link}/preview")
async def preview_link(request: ApiRequest) -> Response:
    """Return a code that opens the exercise of a link as a student would find it, by the link's rules."""
    staff = await _staff(request)
    link = await staff.link()
    if link.settings.exercise_id is None:
        raise NoExerciseError

    def work() -> str:
        token = preview(staff.store, staff.session, link.id, now())
        return issue_code(staff.store, "session", {"token": token}, now(), PREVIEW_CODE)

    code = await staff.run(work)
    await staff.log("preview", link=link.id)
    return json_response({"exercise": link.settings.exercise_id, "code": code})


@router.get("/course/attempts/{attempt}")
async def show_attempt(request: ApiRequest) -> Response:
    """Return an attempt with everything that was found."""
    staff, language = await _staff(request), language_of(request)
    number = _number(request, "attempt")
    attempt, person = await staff.run(attempt_in, staff.store, staff.session.course.id, number)
    await staff.log("attempt", subject=person, attempt=attempt.id)
    return json_response({"person": person, **attempt_view(attempt, Shown.ALL, language)})


@router.post("/course/links/{link}/release")
async def release(request: ApiRequest) -> Response:
    """Show the students of a link what was found, and let their scores go."""
    staff = await _staff(request)
    link = await staff.link()
    await staff.run(release_feedback, staff.store, link.id, now())
    await staff.log("release", link=link.id)
    return Response(status_code=204)


@router.post("/course/links/{link}/allowances")
async def give_allowance(request: ApiRequest) -> Response:
    """Give a student extra time or attempts."""
    staff = await _staff(request)
    link, body = await staff.link(), await _told(request)
    minutes, attempts = body.get("extra_minutes", 0), body.get("extra_attempts", 0)
    for name, value, most in (
        ("extra_minutes", minutes, LONGEST_EXTRA),
        ("extra_attempts", attempts, MOST_EXTRA),
    ):
        if type(value) is not int or not 0 <= value <= most:
            params = {"name": name, "known": f"0 … {most}"}
            raise RequestError(Fault(code="setting_invalid", where=(name,), params=params))
    allowance = Allowance(extra_time=timedelta(minutes=minutes), extra_attempts=attempts)
    person = str(body.get("person"))
    await staff.run(allow, staff.store, link.id, person, allowance, now())
    await staff.log("allowance", subject=person, link=link.id, minutes=minutes, attempts=attempts)
    return Response(status_code=204)


@router.post("/course/links/{link}/resend")
async def resend_scores(request: ApiRequest) -> Response:
    """Send scores again that could not be delivered."""
    staff = await _staff(request)
    link = await staff.link()
    count = await staff.run(resend, staff.store, link.id, now())
    return json_response({"scores": count})


@router.post("/course/links/{link}/regradings")
async def regrade(request: ApiRequest) -> Response:
    """Judge attempts by the exercise as it is now, and say who would change; nothing changes yet."""
    staff = await _staff(request)
    link, body = await staff.link(), await _told(request)
    scope = Scope.ALL if body.get("scope") == "all" else Scope.COUNTED
    grader = grader_of(request)

    def work() -> dict[str, Any]:
        version = grader.version(link.settings)
        run = begin(staff.store, link.id, scope, version, now())
        with RegradingProcesses(grader, link.settings, resources_of(request).settings) as judge:
            rejudge(staff.store, run, judge)
        return {"run": run, "version": version, "changes": changes(staff.store, run)}

    found = await staff.run(work)
    await staff.log("regrading", link=link.id, run=found["run"])
    return json_response(found)


@router.post("/course/links/{link}/regradings/{run}/apply")
async def apply_regrading(request: ApiRequest) -> Response:
    """Let the scores of a regrading count."""
    staff = await _staff(request)
    link, run = await staff.link(), _number(request, "run")
    await staff.run(apply, staff.store, link.id, run, now())
    await staff.log("regrading applied", link=link.id, run=run)
    return Response(status_code=204)


@router.get("/course/links/{link}/export.{form}")
async def export(request: ApiRequest) -> Response:
    """Return every attempt of a link's students, as CSV or JSON."""
    staff = await _staff(request)
    link = await staff.link()
    await staff.log("export", link=link.id)
    found = exported_attempts(staff.store, link)
    headers = {"Cache-Control": "no-store"}
    if request.path_params["form"] == "csv":
        return StreamingResponse(csv_of(found), media_type="text/csv; charset=utf-8", headers=headers)
    records = await staff.run(lambda: [attempt_record(each) for each in found])
    return json_response({"attempts": records})


@router.get("/course/people/{person}")
async def export_one(request: ApiRequest) -> Response:
    """Return everything that is stored about one person of the course."""
    staff = await _staff(request)
    key = request.path_params["person"]
    await staff.run(person_in, staff.store, staff.session.course.id, key)
    await staff.log("person", subject=key)
    return json_response(await staff.run(export_person, staff.store, key))


@router.delete("/course/people/{person}")
async def erase_one(request: ApiRequest) -> Response:
    """Remove one person of the course with everything that is stored about them."""
    staff = await _staff(request)
    key = request.path_params["person"]
    await staff.run(person_in, staff.store, staff.session.course.id, key)
    removed = await staff.run(erase_person, staff.store, key)
    await staff.log("person erased")
    return json_response({"removed": removed})


@router.post("/deep-links")
async def answer_deep_link(request: ApiRequest) -> Response:
    """Return the signed answer to a platform that asked for a link: an exercise with its rules."""
    courses = resources_of(request).with_courses()
    body = await _told(request)
    exercise_id = _known_exercise(request, body.get("exercise"))
    settings = read(exercise_id, body)
    exercise = asked_exercise(resources_of(request).exercises, settings)
    title = exercise.title(language_of(request))
    root = own_root(request, resources_of(request).settings.public_url)

    def work() -> dict[str, str]:
        asked = redeem_code(courses.store, "deep-link", str(body.get("choice")), now())
        platform = platform_by_id(courses.store, asked["platform"])
        told = {name: value for name, value in body.items() if name not in ("choice", "exercise")}
        item = ContentItem(
            address=f"{root}lti/launch",
            title=title,
            text="",
            custom=custom_of(exercise_id, told),
            points=settings.points if takes_line_items(asked["settings"]) else None,
            tag=exercise_id,
        )
        token = response_token(
            platform, asked["deployment"], asked["settings"], [item], courses.signing(), now()
        )
        return {"address": asked["settings"]["deep_link_return_url"], "jwt": token}

    return json_response(await in_thread(request, work))
