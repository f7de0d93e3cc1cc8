"""What staff changes of a link: its exercise and settings, extra time for a student, release of feedback."""

from collections.abc import Collection
from datetime import datetime
from typing import Any

import sqlalchemy as sa

from courses.grades.gradebook import regrade, schedule_scores
from courses.links.course_links import allowance_of, link_of
from courses.links.link_settings import stored, version_of, written
from courses.model import Link, LinkSettings, Role
from courses.people.privacy import participant
from courses.policies import Allowance
from courses.refusals import OutdatedError, unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import upsert
from kinematics.errors import Fault

_LINK, _PART = records.link, records.participation


def change_settings(
    store: Store, link_id: int, settings: LinkSettings, now: datetime, seen: str | None = None
) -> None:
    """Give a link its exercise and rules; grades follow in the same transaction.

    `seen` is the version of the settings that these were made from; None: whatever they were.

    Raises:
        OutdatedError: somebody has saved others since.
    """
    with store.writing() as connection:
        if seen is not None:
            row = connection.execute(
                sa.select(_LINK).where(_LINK.c.id == link_id).with_for_update(key_share=True)
            ).one()  # attempts refer to it meanwhile
            if seen != version_of(stored(row.exercise_id, row.settings)):
                raise OutdatedError(Fault.at("settings_changed"))
        _change(connection, link_id, now, exercise_id=settings.exercise_id, settings=written(settings))


def release_feedback(store: Store, link_id: int, now: datetime) -> None:
    """Show the students of a link what was found; scores that were held back go out."""
    with store.writing() as connection:
        _change(connection, link_id, now, released_at=now)


def _change(connection: sa.Connection, link_id: int, now: datetime, **values: Any) -> None:
    """Change a link, and derive its grades and messages anew; nobody hands in meanwhile."""
    connection.execute(sa.update(_LINK).where(_LINK.c.id == link_id).values(values))
    _lock_students(connection, link_id)
    schedule_scores(connection, regrade_people(connection, link_id, None, now), now)


def allow(
    store: Store, link: Link, person: str, allowance: Allowance, now: datetime, listed: Collection[str] = ()
) -> None:
    """Give a student extra time or attempts, instead of what they had before; they need not have come yet.

    `listed` is the pseudonyms of the class, where the platform tells who is in it.

    Raises:
        UnknownRecordError: the course has no such student.
    """
    with store.writing() as connection:
        _lock_students(connection, link.id)
        person_id = participant(connection, link.course_id, person)
        if person_id is None and person in listed:
            person_id = _listed(connection, link.course_id, person, now)
        if person_id is None:
            raise unknown_record("person")
        values = {
            "extra_seconds": int(allowance.extra_time.total_seconds()),
            "extra_attempts": allowance.extra_attempts,
        }
        own = {"link_id": link.id, "person_id": person_id}
        upsert(connection, _PART, own, values, {"role": Role.LEARNER.value})
        schedule_scores(connection, regrade_people(connection, link.id, [person_id], now), now)


def _listed(connection: sa.Connection, course_id: int, person: str, now: datetime) -> int:
    """Somebody of the class who has opened no link of the course yet; a launch says who they are."""
    course = records.course.c
    platform = sa.select(course.platform_id).where(course.id == course_id).scalar_subquery()
    first = {"platform_id": platform, "created": now, "seen": now}
    return int(upsert(connection, records.person, {"key": person}, {}, first).id)


def regrade_people(
    connection: sa.Connection, link_id: int, people: Collection[int] | None, now: datetime
) -> Link:
    """Derive the grades of some people of a link anew, of all if none are named; return the link."""
    row = connection.execute(sa.select(_LINK).where(_LINK.c.id == link_id)).one()
    link = link_of(row, row.id, row.title)
    wanted = (
        sa.select(_PART, records.person.c.subject)
        .join(records.person, records.person.c.id == _PART.c.person_id)
        .where(_PART.c.link_id == link_id, _PART.c.made > 0)
        .order_by(_PART.c.person_id)
    )
    if people is not None:
        wanted = wanted.where(_PART.c.person_id.in_(people))
    rows = connection.execute(wanted.with_for_update(of=_PART)).all()
    allowances = {row.person_id: allowance_of(row) for row in rows}
    regrade(connection, link, allowances, {row.person_id for row in rows if row.subject is None}, now)
    return link


def _lock_students(connection: sa.Connection, link_id: int) -> None:
    """Keep a link's students from handing in until the transaction ends, in the order of hand-ins."""
    people = sa.select(_PART.c.person_id).where(_PART.c.link_id == link_id).order_by(_PART.c.person_id)
    connection.execute(people.with_for_update()).all()
