"""What people may ask for by law: all about one person, and its erasure; and data that ends with time."""

from collections.abc import Collection
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses.people.secrets import delete_stale, preview_key
from courses.refusals import unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import record_of

_OF_A_PERSON = (records.participation, records.attempt, records.grade, records.score_to_send, records.session)
_OF_AN_ATTEMPT = (records.finding, records.regraded)  # What is removed with the attempt that it belongs to.


SHORTEST_KEY = 8  # Characters of a pseudonym that name somebody: as many as lecturers' pages show.


def person_named(store: Store, key: str, course_id: int | None = None) -> str:
    """Return the whole pseudonym of the one person whose pseudonym begins with these characters.

    The key has eight characters or more; without a course, any person is meant.

    Raises:
        UnknownRecordError: it is nobody's, or several people's.
    """
    part, person, link = records.participation, records.person, records.link
    wanted = sa.select(person.c.key).where(person.c.key.startswith(key, autoescape=True)).distinct().limit(2)
    if course_id is not None:
        wanted = wanted.join(part, part.c.person_id == person.c.id).join(link, link.c.id == part.c.link_id)
        wanted = wanted.where(link.c.course_id == course_id)
    with store.reading() as connection:
        found = list(connection.scalars(wanted)) if len(key) >= SHORTEST_KEY else []
    if len(found) > 1:
        raise unknown_record("several")
    if not found:
        raise unknown_record("anybody" if course_id is None else "person")
    return str(found[0])


def participant(connection: sa.Connection, course_id: int, key: str) -> int | None:
    """Return the id of somebody who has taken part in a course; None if nobody of this key has."""
    part, person, link = records.participation, records.person, records.link
    wanted = (
        sa.select(person.c.id)
        .join(part, part.c.person_id == person.c.id)
        .join(link, link.c.id == part.c.link_id)
        .where(link.c.course_id == course_id, person.c.key == key)
        .limit(1)
    )
    return connection.scalar(wanted)


def export_person(store: Store, key: str, course_id: int | None = None) -> dict[str, Any]:
    """Return everything that is stored about one person, as JSON.

    With a course, what belongs to it alone.

    Raises:
        UnknownRecordError: there is no such person.
    """
    with store.reading() as connection:
        person = _person(connection, key, course_id)
        found: dict[str, Any] = {"person": _plain(person)}
        people = _people(connection, person.id, key)
        for table in _OF_A_PERSON:
            rows = connection.execute(sa.select(table).where(*_of(table, people, course_id)))
            found[str(table.name)] = [_plain(row, hidden=("token_hash", "lease")) for row in rows]
        attempt = records.attempt
        for table in _OF_AN_ATTEMPT:
            of_attempts = sa.select(table).join(attempt, attempt.c.id == table.c.attempt_id)
            rows = connection.execute(of_attempts.where(*_of(attempt, people, course_id)))
            found[str(table.name)] = [_plain(row) for row in rows]
        lines = connection.execute(sa.select(records.access).where(*_lines_about(key, course_id)))
        found["access"] = [_plain(row) for row in lines]
    return found


def erase_person(store: Store, key: str, course_id: int | None = None) -> dict[str, int]:
    """Remove a person with attempts, drafts, grades, unsent scores, sessions and lines of the log.

    Of one course: what belongs to it, and the person only if nothing is left elsewhere. What the person did
    there as a member of staff stays in the log.

    With a course, what belongs to it alone.

    Returns:
        How many rows of each relation were removed.

    Raises:
        UnknownRecordError: there is no such person.
    """
    with store.writing() as connection:
        return _erase(connection, _person(connection, key, course_id).id, key, course_id)


def _person(connection: sa.Connection, key: str, course_id: int | None) -> sa.Row[Any]:
    """A person, who neither arrives nor is removed meanwhile: a launch writes people first, too."""
    wanted = sa.select(records.person).where(records.person.c.key == key)
    person = connection.execute(wanted.with_for_update(key_share=True)).first()
    if person is None:
        raise unknown_record("anybody" if course_id is None else "person")
    return person


def _people(connection: sa.Connection, person_id: int, key: str) -> list[int]:
    """Return a person's id, and that of whom they are in previews, if they are staff and have made one."""
    in_previews = sa.select(records.person.c.id).where(records.person.c.key == preview_key(key))
    return [person_id, *connection.scalars(in_previews)]


def _erase(connection: sa.Connection, person_id: int, key: str, course_id: int | None) -> dict[str, int]:
    """Remove the rows of a person; their participations first, for which those wait who hand in."""
    people = _people(connection, person_id, key)
    statements = {
        str(table.name): sa.delete(table).where(*_of(table, people, course_id)) for table in _OF_A_PERSON
    }
    statements["access"] = sa.delete(records.access).where(*_lines_about(key, course_id))
    counts = {name: connection.execute(statement).rowcount for name, statement in statements.items()}
    of_theirs = [sa.exists().where(table.c.person_id == records.person.c.id) for table in _OF_A_PERSON]
    nothing_left = records.person.c.id.in_(people), sa.not_(sa.or_(*of_theirs))
    connection.execute(sa.delete(records.person).where(*nothing_left))
    return counts


def _of(table: sa.Table, people: Collection[int], course_id: int | None) -> list[sa.ColumnElement[bool]]:
    """Conditions on the rows of a relation that belong to people, in one course or in all."""
    return [table.c.person_id.in_(people), *_in_course(table, course_id)]


def _lines_about(key: str, course_id: int | None) -> list[sa.ColumnElement[bool]]:
    """Conditions on the lines of the audit log: of all courses those of the person's own doing, too."""
    log = records.access
    if course_id is None:
        return [sa.or_(log.c.subject == key, log.c.actor == key)]
    return [log.c.subject == key, *_in_course(log, course_id)]


def _in_course(table: sa.Table, course_id: int | None) -> list[sa.ColumnElement[bool]]:
    if course_id is None:
        return []
    return [table.c.link_id.in_(sa.select(records.link.c.id).where(records.link.c.course_id == course_id))]


def purge(store: Store, now: datetime, *, people: timedelta, log: timedelta) -> dict[str, int]:
    """Remove people who were not seen for the time `people`, and lines of the audit log older than `log`.

    So are codes and nonces that have ended: a launch that nobody went on with says who wanted to come.

    Returns:
        How many people, sessions and lines were removed.
    """
    person, access, session = records.person, records.access, records.session
    old = person.c.seen < now - people
    with store.writing() as connection:
        for table in (records.one_time_code, records.nonce):
            delete_stale(connection, table, now)
        ended = connection.execute(sa.delete(session).where(session.c.expires < now)).rowcount
        lines = connection.execute(sa.delete(access).where(access.c.at < now - log)).rowcount
        keys = list(connection.scalars(sa.select(person.c.key).where(old)))
    count = 0
    for key in keys:
        with store.writing() as connection:
            own = sa.select(person.c.id).where(person.c.key == key, old)
            person_id = connection.scalar(own.with_for_update(key_share=True))
            if person_id is not None:  # nobody else has removed them, and they have not come back
                _erase(connection, person_id, key, None)
                count += 1
    return {"people": count, "sessions": ended, "access": lines}


def _plain(row: Any, hidden: tuple[str, ...] = ()) -> dict[str, Any]:
    return {
        name: value.isoformat() if isinstance(value, datetime) else value
        for name, value in record_of(row).items()
        if name not in hidden
    }
