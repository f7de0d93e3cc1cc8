"""A platform, a course, students and what they hand in."""

from datetime import UTC, datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses.attempts.stored_attempts import attempt_of
from courses.attempts.submissions import JudgedSubmission, store_submissions
from courses.model import Attempt, CourseSession, Platform, PlatformStatus, Role
from courses.people.enrolment import Arrival, arrive
from courses.people.platforms import add_platform
from courses.people.sessions import session_of
from courses.storage import records
from courses.storage.database import Store

NOW = datetime(2027, 3, 1, 12, 0, tzinfo=UTC)


def platform(store: Store) -> Platform:
    asked = Platform(
        issuer="https://lms.example.edu",
        client_id="framewise",
        authorization_endpoint="https://lms.example.edu/auth",
        token_endpoint="https://lms.example.edu/token",
        jwks_uri="https://lms.example.edu/jwks",
        status=PlatformStatus.ACTIVE,
    )
    return add_platform(store, asked, ("1",), NOW)


def arrival(store: Store, subject: str = "student-1", **changed: Any) -> Arrival:
    """What a launch says of somebody."""
    told: dict[str, Any] = {
        "platform": platform(store),
        "subject": subject,
        "role": Role.LEARNER,
        "deployment": "1",
        "context": "course-1",
        "resource": "link-1",
        "exercise_id": "puma560",
        "line_item": "https://lms.example.edu/items/1",
        **changed,
    }
    return Arrival(**told)


def joined(store: Store, subject: str = "student-1", **changed: Any) -> CourseSession:
    """A session of somebody who has just come."""
    at = changed.pop("at", NOW)
    token, _ = arrive(store, arrival(store, subject, **changed), at)
    return session_of(store, token, at)


def attempts_of(store: Store, session: CourseSession) -> list[Attempt]:
    """All that a student has handed in, oldest first."""
    table = records.attempt
    wanted = sa.select(table).where(
        table.c.link_id == session.link.id, table.c.person_id == session.person.id
    )
    with store.reading() as connection:
        return [attempt_of(row) for row in connection.execute(wanted.order_by(table.c.number))]


def handed_in(store: Store, submission: JudgedSubmission, at: datetime) -> Attempt:
    """One submission, stored by itself; its attempt, or the one that has its key."""
    (found,) = store_submissions(store, [submission], at)
    if isinstance(found, Exception):
        raise found
    return found


def submitted(
    store: Store,
    session: CourseSession,
    score: float,
    *,
    minutes: float = 0.0,
    key: str | None = None,
    **more: Any,
) -> Attempt:
    """An attempt with a score, so many minutes after the beginning."""
    at = NOW + timedelta(minutes=minutes)
    report = more.pop("report", {"verdict": None, "parts": []})
    attempt = Attempt(
        link_id=session.link.id,
        person_id=session.person.id,
        key=key or f"key-{minutes}-{score}",
        at=at,
        exercise_id="puma560",
        version="1",
        seed=None,
        language="en",
        answer=more.pop("answer", {"table": {"rows": []}}),
        report=report,
        score=score,
        correct=score == 1.0,
    )
    judged = JudgedSubmission(session=session, attempt=attempt, analysis=report)
    return handed_in(store, judged, at)
