"""People, courses and links as a launch tells of them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

import sqlalchemy as sa

from courses.links.link_settings import stored, written
from courses.model import CourseSession, Platform, Role
from courses.people.secrets import hashed, new_token, preview_key, pseudonym
from courses.people.sessions import SESSION
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import of_student, upsert, upsert_all


@dataclass(frozen=True, kw_only=True, slots=True)
class Arrival:
    """What a launch says: who comes, to which link of which course.

    Attributes:
        subject: None for an anonymous launch.
        context: the platform's id of the course; empty where it names none.
        is_test_user: the platform made them up to try things out; they stand in no number of the class.
        settings: those of a deep link; None where the link brings none.
        exercise_id: the exercise of a deep link.
        copied_from: links of the platform that the link is a copy of, newest first.
    """

    platform: Platform
    subject: str | None
    role: Role
    deployment: str
    context: str
    resource: str
    is_test_user: bool = False
    name: str | None = None
    course_title: str = ""
    link_title: str = ""
    exercise_id: str | None = None
    settings: Mapping[str, Any] = field(default_factory=dict)
    copied_from: Sequence[str] = ()
    line_item: str | None = None
    line_items: str | None = None
    memberships_url: str | None = None
    locale: str | None = None
    return_url: str | None = None


def arrive(store: Store, arrival: Arrival, now: datetime) -> tuple[str, int]:
    """Store what a launch says and open a session; return its token and the link's id."""
    key = pseudonym(
        store, arrival.platform.issuer, arrival.platform.client_id, arrival.subject or new_token()
    )
    with store.writing() as connection:
        person_id = _person(connection, arrival, key, now)
        link_id = _link(connection, arrival, _course(connection, arrival))
        took_part = {"link_id": link_id, "person_id": person_id}
        counted_as = Role.STAFF if arrival.is_test_user else arrival.role
        arrived = {**took_part, "role": counted_as.value, "began": now}
        upsert_all(connection, records.participation, tuple(took_part), [arrived], _begun_before)
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
    key = preview_key(session.person.key)
    own = {"platform_id": session.person.platform_id, "subject": None, "created": now}
    token = new_token()
    with store.writing() as connection:
        took_part = {
            "link_id": link_id,
            "person_id": upsert(connection, records.person, {"key": key}, {"seen": now}, own).id,
        }
        begun = {"role": Role.STAFF.value, "made": 0, "draft": None, "began": now}
        upsert(connection, records.participation, took_part, begun)  # first: whoever hands in has it locked
        for table in (records.attempt, records.grade):
            connection.execute(sa.delete(table).where(of_student(table, **took_part)))
        values = {**took_part, "token_hash": hashed(token), "role": Role.LEARNER.value}
        told = {"locale": session.locale, "return_url": None, "expires": now + SESSION}
        connection.execute(sa.insert(records.session).values(**values, **told))
    return token


def _begun_before(new: Any) -> Mapping[str, Any]:
    """When somebody came first; a lecturer may have given them extra time before."""
    return {"began": sa.func.coalesce(records.participation.c.began, new.began)}


def _person(connection: sa.Connection, arrival: Arrival, key: str, now: datetime) -> int:
    name = arrival.name[:200] if arrival.platform.names_shared and arrival.name else None
    changed = {"seen": now, "subject": arrival.subject, "name": name}
    first = {"platform_id": arrival.platform.id, "created": now}
    return int(upsert(connection, records.person, {"key": key}, changed, first).id)


def _course(connection: sa.Connection, arrival: Arrival) -> int:
    key = {
        "platform_id": arrival.platform.id,
        "deployment": arrival.deployment,
        "context": arrival.context or _own_context(connection, arrival),
    }
    changed: dict[str, Any] = {"title": arrival.course_title[:300]}
    if arrival.memberships_url:
        changed["memberships_url"] = arrival.memberships_url
    return int(upsert(connection, records.course, key, changed).id)


def _own_context(connection: sa.Connection, arrival: Arrival) -> str:
    """Return what identifies the course of a link whose platform names none: staff sees this link alone.

    A link that an earlier version has stored stays in the course that it shares with others.
    """
    link, course = records.link.c, records.course.c
    shared = (
        sa.select(link.id)
        .join(records.course, course.id == link.course_id)
        .where(course.platform_id == arrival.platform.id, course.deployment == arrival.deployment)
        .where(course.context == "", link.resource == arrival.resource)
    )
    return f"resource_link:{arrival.resource}" if connection.execute(shared).first() is None else ""


def _link(connection: sa.Connection, arrival: Arrival, course_id: int) -> int:
    key = {"course_id": course_id, "resource": arrival.resource}
    changed: dict[str, Any] = {"title": arrival.link_title[:300]}
    changed |= {
        name: value
        for name, value in (("line_item", arrival.line_item), ("line_items", arrival.line_items))
        if value
    }
    settings = stored(arrival.exercise_id, arrival.settings)
    first = {"exercise_id": arrival.exercise_id, "settings": written(settings)}
    return int(upsert(connection, records.link, key, changed, first | _copied(connection, arrival)).id)


def _copied(connection: sa.Connection, arrival: Arrival) -> dict[str, Any]:
    """Exercise and rules of the newest known link that a link is a copy of."""
    if not arrival.copied_from:
        return {}
    link, course = records.link.c, records.course.c
    wanted = (
        sa.select(link.resource, link.exercise_id, link.settings)
        .join(records.course, course.id == link.course_id)
        .where(course.platform_id == arrival.platform.id, link.resource.in_(arrival.copied_from))
        .where(link.exercise_id.is_not(None))
        .order_by(link.id)
    )
    found = {row.resource: row for row in connection.execute(wanted)}
    newest = next((found[each] for each in arrival.copied_from if each in found), None)
    return {} if newest is None else {"exercise_id": newest.exercise_id, "settings": newest.settings}
