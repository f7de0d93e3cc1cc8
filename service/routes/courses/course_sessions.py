"""What a signed-in student does: see the exercise's rules, hand in, look back, keep a draft."""

import hashlib
from contextlib import suppress
from dataclasses import replace
from datetime import datetime, timedelta
from functools import partial
from typing import Any

from fastapi import Response

from courses.attempts.stored_attempts import attempt_numbered, by_key, shown_now, standing_of
from courses.model import Attempt, CourseSession, StudentStanding
from courses.people.secrets import redeem_code
from courses.people.sessions import end_session
from courses.policies import Shown, counts_from
from courses.refusals import AttemptError, NoExerciseError, StorageUnavailableError
from exercises.errors import UnknownExerciseError
from kinematics.errors import Fault
from service.course_callers import course_router, grader_of, in_thread, json_response, signed_in
from service.course_resources import bearer_token, now
from service.http.arrival_tickets import HEADER, arrival_ticket, told_arrival
from service.http.idempotency import REPLAYED
from service.http.languages import language_of
from service.http.metering import EXCESS
from service.http.problem_answers import REQUEST_ID
from service.http.problems import (
    RETRY_SECONDS,
    BusyError,
    RateError,
    RequestError,
    RequestPart,
    ServiceError,
    UnavailableError,
    cause,
)
from service.http.routing import ApiRequest
from service.http.shortages import shortage
from service.http.validation import validated
from service.schemas.exercises.exercises import ExerciseAnswer
from service.secret import installation_secret
from service.wire.courses.session_views import attempt_view, masked, session_view, stored_report
from service.wire.exercises.ungraded import answer_refused
from service.wire.exercises.verdicts import report_body
from service.work.fair_queue import Proven, proven
from service.work.limiters import WorkKind
from service.work.session_grading import Grader, judged_submission, tells_departure_later

router = course_router()

LONGEST_KEY = 100
"""Characters of an idempotency key that are stored as they are (a UUID has 36), or else its digest."""


@router.post("/session/open")
async def open_session(request: ApiRequest) -> Response:
    """Exchange the code of a launch for a session token, once."""
    courses = request.resources.with_courses()
    body = await request.json()
    code = body.get("code") if isinstance(body, dict) else None
    content = await in_thread(request, redeem_code, courses.store, "session", str(code), now())
    return json_response(content)


@router.get("/session")
async def show_session(request: ApiRequest) -> Response:
    """Return who is signed in, for what, by which rules, and how far they are."""
    courses, session = await signed_in(request)
    grader = grader_of(request)

    def work() -> dict[str, Any]:
        standing = StudentStanding() if is_first_visit else standing_of(courses.store, session)
        return session_view(session, standing, _version_now(grader, session))

    is_first_visit = not session.made and not session.has_draft
    at_once = is_first_visit and courses.knows_edition(session.link.settings.exercise_id)
    return json_response(work() if at_once else await in_thread(request, work))


def _version_now(grader: Grader, session: CourseSession) -> str | None:
    """What the exercise of a link is now; None where there is none, or none any more."""
    try:
        return grader.version(session.link.settings)
    except (NoExerciseError, UnknownExerciseError):
        return None


@router.post("/session/close")
async def close_session(request: ApiRequest) -> Response:
    """Sign out."""
    courses, session = await signed_in(request)
    await in_thread(request, end_session, courses.store, session.id)
    return Response(status_code=204)


@router.post("/session/attempts")
async def submit(request: ApiRequest) -> Response:
    """Judge an answer, store it, and only then answer, as far as the rules let it be shown.

    Where that can't be done just now, the refusal tells when the answer came, for it to be sent again.
    """
    begun = now()
    if (excess := request.scope.get(EXCESS)) is not None:
        raise RateError(excess.faults, headers={**excess.headers, **await _ticket(request, begun)})
    try:
        return await _judged(request, begun)
    except (BusyError, UnavailableError, StorageUnavailableError) as error:
        headers = {"Retry-After": str(RETRY_SECONDS), **await _ticket(request, begun)}
        raise BusyError(error.faults, headers=headers) from cause(error)
    except (MemoryError, OSError, RuntimeError) as error:
        refusal = shortage(error, request.scope[REQUEST_ID])
        if refusal is None:
            raise
        headers = {**refusal.headers, **await _ticket(request, begun)}
        raise BusyError(refusal.faults, headers=headers) from cause(error)


async def _ticket(request: ApiRequest, begun: datetime) -> dict[str, str]:
    """Return the field that tells when an answer came; none for one that can't be read: it has not come."""
    with suppress(ServiceError):
        token, typed, _ = await _sent(request)
        arrived = begun + timedelta(seconds=request.body_seconds)
        first = told_arrival(request.headers.get(HEADER, ""), token, typed, _secret(request), arrived)
        return {HEADER: arrival_ticket(first or arrived, token, typed, _secret(request))}
    return {}


async def _sent(request: ApiRequest) -> tuple[str, Any, tuple[Any, Any]]:
    """The session's token, the answer, and what the page adds: its form, and the version that it shows."""
    sent = await request.json()
    token = bearer_token(request.headers.get("authorization", ""))
    if not isinstance(sent, dict):
        return token, sent, (None, None)
    answer = {key: value for key, value in sent.items() if key not in ("form", "version")}
    return token, answer, (sent.get("form"), sent.get("version"))


def _secret(request: ApiRequest) -> bytes:
    return installation_secret(request.resources.settings)


async def _judged(request: ApiRequest, begun: datetime) -> Response:
    language = language_of(request)
    courses, session = await signed_in(request)
    proven(Proven("hand-in", session.person.id))
    with answer_refused():
        token, typed, (form, seen) = await _sent(request)
        arrived = begun + timedelta(seconds=request.body_seconds)
        if ticket := request.headers.get(HEADER):
            first = told_arrival(ticket, token, typed, _secret(request), arrived)
            arrived = counts_from(session.link.settings.policy, session.allowance, first, arrived)
        wire = validated(ExerciseAnswer, typed)
        key = _stored_key(request.headers.get("idempotency-key", ""))
        grader = replace(grader_of(request), is_crowded=request.resources.is_crowded)
        version = seen if isinstance(seen, str) else None
        work = partial(judged_submission, grader, session, wire, typed, key, language, arrived, form, version)
        try:
            submission, found = await request.resources.limiters[WorkKind.GRADING].run(work)
            attempt = await courses.keep(submission)
            is_new = attempt.at == submission.attempt.at
            told = report_body(found, language) if is_new else None
            request.resources.metrics.graded(correct=attempt.correct, score=attempt.score, kept=True)
        except AttemptError:  # the last attempt that there is may be sent again, with its key
            known = await in_thread(request, by_key, courses.store, session, key) if key else None
            if known is None:
                raise
            attempt, told, is_new = known, None, False
        if not is_new and attempt.answer != typed:
            raise RequestError(Fault.at("idempotency_key_reused", "Idempotency-Key"), part=RequestPart.HEADER)
    shown = Shown(attempt.shown)
    report = masked(told or stored_report(attempt.report, language), shown) or {}
    later = is_new and shown is Shown.ALL and grader.is_crowded() and tells_departure_later(found)
    told_more = {"attempt": attempt.number, "shown": shown.value}
    answer = json_response({**report, **told_more, **({"departure_later": True} if later else {})})
    if not is_new:
        answer.headers[REPLAYED] = "true"
    return answer


def _stored_key(key: str) -> str | None:
    """What names a submission in the database; None if it has no key."""
    return (key if len(key) <= LONGEST_KEY else hashlib.sha256(key.encode()).hexdigest()) or None


@router.get("/session/attempts/{number}")
async def reopen(request: ApiRequest) -> Response:
    """Return an attempt with what was found, as far as it may be shown now."""
    language = language_of(request)
    courses, session = await signed_in(request)
    text = request.path_params["number"]
    number = int(text) if text.isdecimal() and len(text) < 9 else 0
    grader, shown = grader_of(request), shown_now(session, session.made, now())

    def work() -> Attempt:
        attempt = attempt_numbered(courses.store, session, number)
        return grader.with_departure(attempt, session.link.settings) if shown is Shown.ALL else attempt

    return json_response(attempt_view(await in_thread(request, work), shown, language))


@router.put("/session/draft")
async def put_draft(request: ApiRequest) -> Response:
    """Keep what has been typed, for any device."""
    courses, session = await signed_in(request)
    state = await request.json()
    await courses.keep_draft((session, state if isinstance(state, dict) else None))
    return Response(status_code=204)
