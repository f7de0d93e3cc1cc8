"""Sessions: who is signed in, by a token, in which course and at which link."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses.links.course_links import allowance_of, link_of
from courses.model import Course, CourseSession, Link, Person, PlatformStatus, Role
from courses.people.secrets import hashed
from courses.refusals import SessionError, platform_inactive
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import filled, of_student
from kinematics.errors import Fault

SESSION = timedelta(hours=2)  # How long a session lives after it was last used.
LONGEST_SESSION = timedelta(days=1)
"""How long after their last launch somebody stays signed in: their role may have changed since."""
RENEWED_AFTER = timedelta(minutes=5)  # A session that was used is renewed at most so often.

_SESSION = (
    sa.select(
        records.session,
        records.person.c.platform_id,
        records.person.c.key,
        records.person.c.subject,
        records.person.c.name,
        records.person.c.seen,
        records.link.c.course_id,
        records.link.c.resource,
        records.link.c.title.label("link_title"),
        records.link.c.exercise_id,
        records.link.c.settings,
        records.link.c.line_item,
        records.link.c.line_items,
        records.link.c.released_at,
        records.course.c.title.label("course_title"),
        records.course.c.memberships_url,
        records.platform.c.issuer,
        records.platform.c.status,
        records.participation.c.extra_seconds,
        records.participation.c.extra_attempts,
        records.participation.c.made,
        records.participation.c.draft_at,
        sa.select(sa.func.max(sa.literal_column("other.extra_seconds")))
        .select_from(records.participation.alias("other"))
        .where(sa.literal_column("other.link_id") == records.link.c.id)
        .scalar_subquery()
        .label("longest"),
    )
    .join(records.person, records.person.c.id == records.session.c.person_id)
    .join(records.link, records.link.c.id == records.session.c.link_id)
    .join(records.course, records.course.c.id == records.link.c.course_id)
    .join(records.platform, records.platform.c.id == records.course.c.platform_id)
    .join(
        records.participation,
        of_student(records.participation, records.session.c.link_id, records.session.c.person_id),
    )
    .where(records.session.c.token_hash.in_(sa.bindparam("hashes", expanding=True)))
)
"""Written once: to write a statement takes longer than to carry it out."""


def session_of(store: Store, token: str, now: datetime) -> CourseSession:
    """Return who is signed in by a token; using a session keeps it alive.

    Raises:
        SessionError: nobody is: it has expired, was never given out, its last launch is too long ago, or its
            platform was switched off.
    """
    (found,) = sessions_of(store, [token], now)
    if isinstance(found, SessionError):
        raise found
    return found


def sessions_of(store: Store, tokens: Sequence[str], now: datetime) -> list[CourseSession | SessionError]:
    """Return who is signed in by each of some tokens, asked in one query; using a session keeps it alive."""
    hashes = [hashed(token) for token in tokens]
    with store.asking() as connection:
        asked = connection.execute(_SESSION, {"hashes": hashes})
        rows = {
            row.token_hash: row for row in asked if row.expires > now and row.seen > now - LONGEST_SESSION
        }
    active = {token: row for token, row in rows.items() if row.status == PlatformStatus.ACTIVE}
    old = [row.id for row in active.values() if row.expires < now + SESSION - RENEWED_AFTER]
    if old:
        _renew(store, old, now)
    links: dict[int, Link] = {}
    return [
        _session(active[each], links) if each in active else SessionError(_refusal(rows.get(each)))
        for each in hashes
    ]


def _refusal(row: Any) -> Fault:
    """Why a session is refused: its platform was switched off, or there is none."""
    return Fault.at("session_expired") if row is None else platform_inactive(row.issuer)


def _renew(store: Store, session_ids: Sequence[int], now: datetime) -> None:
    with store.writing() as connection:
        own = records.session.c.id.in_(session_ids)
        connection.execute(sa.update(records.session).where(own).values(expires=now + SESSION))


def end_session(store: Store, session_id: int) -> None:
    """Sign somebody out."""
    with store.writing() as connection:
        connection.execute(sa.delete(records.session).where(records.session.c.id == session_id))


def _session(row: Any, links: dict[int, Link]) -> CourseSession:
    """A session from its row; a class that asks at once shares a link, whose settings are read once."""
    link = links.get(row.link_id)
    if link is None:
        link = links[row.link_id] = link_of(row, row.link_id, row.link_title)
    return filled(
        CourseSession,
        row,
        role=Role(row.role),
        person=filled(Person, row, id=row.person_id),
        course=filled(Course, row, id=row.course_id, title=row.course_title),
        link=link,
        allowance=allowance_of(row),
        has_draft=row.draft_at is not None,
        longest=float(row.longest or 0),
    )
