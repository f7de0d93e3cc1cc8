"""People, courses and links as a launch tells of them, and the sessions that launches open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses import records
from courses.link_settings import LinkSettingsError, read, written
from courses.links import link_of
from courses.model import Course, CourseSession, LinkSettings, Person, Platform, Role
from courses.policies import Allowance
from courses.refusals import SessionError
from courses.secrets import hashed, new_token, pseudonym
from courses.statements import insert_once, upsert
from courses.storage import Store
from kinematics.errors import Fault

SESSION = timedelta(hours=2)
"""How long a session lives after it was last used."""
RENEWED_AFTER = timedelta(minutes=5)
"""A session that was used is renewed at most so often."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Arrival:
    """What a launch says: who comes, to which link of which course.

    Attributes:
        subject: None for an anonymous launch.
        settings: those of a deep link; None where the link brings none.
        exercise_id: the exercise of a deep link.
    """

    platform: Platform
    subject: str | None
    role: Role
    deployment: str
    context: str
    resource: str
    name: str | None = None
    course_title: str = ""
    link_title: str = ""
    exercise_id: str | None = None
    settings: Mapping[str, Any] = field(default_factory=dict)
    line_item: str | None = None
    line_items: str | None = None
    memberships_url: str | None = None
    locale: str | None = None
    return_url: str | None = None


def arrive(store: Store, arrival: Arrival, now: datetime) -> tuple[str, int]:
    """Write down what a launch says and open a session; return its token and the link's id."""
    key = pseudonym(
        store, arrival.platform.issuer, arrival.platform.client_id, arrival.subject or new_token()
    )
    with store.writing() as connection:
        person_id = _person(connection, arrival, key, now)
        course_id = _course(connection, arrival)
        link_id = _link(connection, arrival, course_id)
        took_part = {"link_id": link_id, "person_id": person_id}
        upsert(connection, records.participation, took_part, {"role": arrival.role.value}, {"began": now})
        token = new_token()
        connection.execute(
            sa.insert(records.session).values(
                **took_part,
                token_hash=hashed(token),
                role=arrival.role.value,
                locale=arrival.locale,
                return_url=arrival.return_url,
                expires=now + SESSION,
            )
        )
    return token, link_id


def preview(store: Store, session: CourseSession, link_id: int, now: datetime) -> str:
    """Open a session in which staff sees a link as a student does; return its token.

    What is handed in by it is stored like a student's, by the same rules, and stands in no number: the person
    of a preview belongs to the staff. Nothing goes to the gradebook.
    """
    key = hashed(f"preview {session.person.key}")[:32]
    own = {"platform_id": session.person.platform_id, "subject": None, "created": now}
    token = new_token()
    with store.writing() as connection:
        upsert(connection, records.person, {"key": key}, {"seen": now}, own)
        took_part = {"link_id": link_id, "person_id": _id(connection, records.person, key=key)}
        attempts = records.attempt
        earlier = sa.and_(*(attempts.c[name] == value for name, value in took_part.items()))
        connection.execute(sa.delete(attempts).where(earlier))
        same = records.grade.c.link_id == link_id, records.grade.c.person_id == took_part["person_id"]
        connection.execute(sa.delete(records.grade).where(*same))
        begun = {"role": Role.STAFF.value, "made": 0, "draft": None, "began": now}
        upsert(connection, records.participation, took_part, begun)
        values = {**took_part, "token_hash": hashed(token), "role": Role.LEARNER.value}
        told = {"locale": session.locale, "return_url": None, "expires": now + SESSION}
        connection.execute(sa.insert(records.session).values(**values, **told))
    return token


def _person(connection: sa.Connection, arrival: Arrival, key: str, now: datetime) -> int:
    changed: dict[str, Any] = {"seen": now}
    if arrival.platform.names_shared and arrival.name:
        changed["name"] = arrival.name[:200]
    first = {"platform_id": arrival.platform.id, "subject": arrival.subject, "created": now}
    upsert(connection, records.person, {"key": key}, changed, first)
    return _id(connection, records.person, key=key)


def _course(connection: sa.Connection, arrival: Arrival) -> int:
    key = {
        "platform_id": arrival.platform.id,
        "deployment": arrival.deployment,
        "context": arrival.context,
    }
    changed: dict[str, Any] = {"title": arrival.course_title[:300]}
    if arrival.memberships_url:
        changed["memberships_url"] = arrival.memberships_url
    upsert(connection, records.course, key, changed)
    return _id(connection, records.course, **key)


def _link(connection: sa.Connection, arrival: Arrival, course_id: int) -> int:
    key = {"course_id": course_id, "resource": arrival.resource}
    changed: dict[str, Any] = {"title": arrival.link_title[:300]}
    changed |= {
        name: value
        for name, value in (("line_item", arrival.line_item), ("line_items", arrival.line_items))
        if value
    }
    first = {"exercise_id": arrival.exercise_id, "settings": written(_settings_of(arrival))}
    upsert(connection, records.link, key, changed, first)
    return _id(connection, records.link, **key)


def _settings_of(arrival: Arrival) -> LinkSettings:
    """Settings that the link brings; the defaults where the platform has garbled them."""
    try:
        return read(arrival.exercise_id, arrival.settings)
    except LinkSettingsError:
        return LinkSettings(exercise_id=arrival.exercise_id)


def _id(connection: sa.Connection, table: sa.Table, **key: Any) -> int:
    condition = sa.and_(*(table.c[name] == value for name, value in key.items()))
    return int(connection.execute(sa.select(table.c.id).where(condition)).scalar_one())


_SESSION = (
    sa.select(
        records.session,
        records.person.c.platform_id,
        records.person.c.key,
        records.person.c.subject,
        records.person.c.name,
        records.link.c.course_id,
        records.link.c.resource,
        records.link.c.title.label("link_title"),
        records.link.c.exercise_id,
        records.link.c.settings,
        records.link.c.line_item,
        records.link.c.line_items,
        records.link.c.released_at,
        records.course.c.deployment,
        records.course.c.context,
        records.course.c.title.label("course_title"),
        records.course.c.memberships_url,
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
    .join(
        records.participation,
        sa.and_(
            records.participation.c.link_id == records.session.c.link_id,
            records.participation.c.person_id == records.session.c.person_id,
        ),
    )
)


def session_of(store: Store, token: str, now: datetime) -> CourseSession:
    """Who is signed in by a token; using a session keeps it alive.

    Raises:
        SessionError: nobody is: it has expired, or was never given out.
    """
    (found,) = sessions_of(store, [token], now)
    if isinstance(found, SessionError):
        raise found
    return found


def sessions_of(store: Store, tokens: Sequence[str], now: datetime) -> list[CourseSession | SessionError]:
    """Who is signed in by each of some tokens, asked in one query; using a session keeps it alive."""
    hashes = [hashed(token) for token in tokens]
    with store.asking() as connection:
        wanted = _SESSION.where(records.session.c.token_hash.in_(hashes))
        rows = {row.token_hash: row for row in connection.execute(wanted) if row.expires > now}
    old = [row.id for row in rows.values() if row.expires < now + SESSION - RENEWED_AFTER]
    if old:
        _renew(store, old, now)
    return [
        _session(rows[each]) if each in rows else SessionError(Fault(code="session_expired"))
        for each in hashes
    ]


def _renew(store: Store, session_ids: Sequence[int], now: datetime) -> None:
    with store.writing() as connection:
        own = records.session.c.id.in_(session_ids)
        connection.execute(sa.update(records.session).where(own).values(expires=now + SESSION))


def end_session(store: Store, session_id: int) -> None:
    """Sign somebody out."""
    with store.writing() as connection:
        connection.execute(sa.delete(records.session).where(records.session.c.id == session_id))


def _session(row: Any) -> CourseSession:
    return CourseSession(
        id=row.id,
        role=Role(row.role),
        person=Person(
            id=row.person_id, platform_id=row.platform_id, key=row.key, subject=row.subject, name=row.name
        ),
        course=Course(
            id=row.course_id,
            platform_id=row.platform_id,
            deployment=row.deployment,
            context=row.context,
            title=row.course_title,
            memberships_url=row.memberships_url,
        ),
        link=link_of(row, row.link_id, row.link_title),
        allowance=Allowance(
            extra_time=timedelta(seconds=row.extra_seconds), extra_attempts=row.extra_attempts
        ),
        made=row.made,
        has_draft=row.draft_at is not None,
        longest=float(row.longest or 0),
        locale=row.locale,
        return_url=row.return_url,
        expires=row.expires,
    )


def issue_code(store: Store, purpose: str, content: Mapping[str, Any], now: datetime, life: timedelta) -> str:
    """A code that brings content back once."""
    code = new_token()
    with store.writing() as connection:
        connection.execute(
            sa.insert(records.one_time_code).values(
                code_hash=hashed(code), purpose=purpose, content=dict(content), expires=now + life
            )
        )
    return code


def redeem_code(store: Store, purpose: str, code: str, now: datetime) -> dict[str, Any]:
    """What a code was issued for; it works once.

    Raises:
        SessionError: it was used, is too old, or was never issued.
    """
    table = records.one_time_code
    wanted = sa.and_(table.c.code_hash == hashed(code), table.c.purpose == purpose)
    with store.writing() as connection:
        row = connection.execute(sa.select(table).where(wanted).with_for_update()).first()
        used = connection.execute(sa.delete(table).where(wanted)).rowcount
    if row is None or used != 1 or row.expires <= now:
        raise SessionError(Fault(code="code_used"))
    content: dict[str, Any] = row.content
    return content


def check_code(store: Store, purpose: str, code: str, now: datetime) -> None:
    """Refuse a code that could not be redeemed; one that could stays good.

    Raises:
        SessionError: it was used, is too old, or was never issued.
    """
    table = records.one_time_code
    wanted = sa.and_(table.c.code_hash == hashed(code), table.c.purpose == purpose)
    with store.reading() as connection:
        expires = connection.scalar(sa.select(table.c.expires).where(wanted))
    if expires is None or expires <= now:
        raise SessionError(Fault(code="code_used"))


def remember_nonce(store: Store, platform_id: int, value: str, expires: datetime) -> bool:
    """Insert a nonce; return False if the platform has used it before."""
    with store.writing() as connection:
        values = {"platform_id": platform_id, "nonce": hashed(value), "expires": expires}
        return insert_once(connection, records.nonce, values)
