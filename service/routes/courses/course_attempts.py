"""What students handed in, as the staff sees it."""

from collections.abc import Mapping
from datetime import date
from typing import TypeVar

from fastapi import Response

from courses.attempts.stored_attempts import attempt_in
from courses.links.course_links import MOST_DIGITS
from courses.policies import Shown
from courses.teaching.attempts_behind import AttemptFilter, Outcome, Progress, attempts_behind
from service.course_callers import course_router, json_response, record_number, refused_setting, staff_of
from service.http.languages import language_of
from service.http.routing import ApiRequest
from service.wire.courses.session_views import attempt_view

router = course_router()

_Result = TypeVar("_Result")


@router.get("/course/links/{link}/attempts")
async def list_attempts(request: ApiRequest) -> Response:
    """Return the attempts behind a number: with a code, of a cluster (`ids`), a student, a step, a state."""
    staff = await staff_of(request)
    link, asked = await staff.link(), request.query_params
    named = asked.get("ids", "").split(",")[:200]
    chosen = AttemptFilter(
        kind=asked.get("kind"),
        code=asked.get("code"),
        ids=tuple(int(text) for text in named if text.isdecimal() and len(text) <= MOST_DIGITS),
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


@router.get("/course/attempts/{attempt}")
async def show_attempt(request: ApiRequest) -> Response:
    """Return an attempt with everything that was found."""
    staff, language = await staff_of(request), language_of(request)
    number = record_number(request, "attempt")
    attempt, person = await staff.run(attempt_in, staff.store, staff.session.course.id, number)
    await staff.log("attempt", subject=person, attempt=attempt.id)
    return json_response({"person": person, **attempt_view(attempt, Shown.ALL, language)})


def _choice(asked: Mapping[str, str], name: str, known: Mapping[str, _Result]) -> _Result | None:
    """Return what a word of the query means; None if it is not there.

    Raises:
        RequestError: it is another word.
    """
    text = asked.get(name)
    if text is None:
        return None
    if text not in known:
        raise refused_setting(name, ", ".join(known))
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
        raise refused_setting("day", "2027-03-01") from None
