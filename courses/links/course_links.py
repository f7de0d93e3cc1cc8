"""Links of courses, as they are stored; a launch makes them, and staff changes them."""

from datetime import timedelta
from typing import Any

import sqlalchemy as sa

from courses.links.link_settings import stored
from courses.model import Link, LinkSettings
from courses.policies import Allowance
from courses.refusals import unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import filled

MOST_DIGITS = 9  # Digits of the number of a record: both databases hold what has no more.
_LINK, _PART = records.link, records.participation


def link_in(store: Store, course_id: int, link_id: int) -> Link:
    """Return a link of a course.

    Raises:
        UnknownRecordError: the course has no such link.
    """
    with store.reading() as connection:
        row = connection.execute(
            sa.select(_LINK).where(_LINK.c.id == link_id, _LINK.c.course_id == course_id)
        ).first()
    if row is None:
        raise unknown_record("link")
    return link_of(row, row.id, row.title)


def link_of(row: Any, link_id: int, title: str) -> Link:
    """Return a link, from a row with the columns of one that are in no other table."""
    return filled(Link, row, id=link_id, title=title, settings=stored(row.exercise_id, row.settings))


def allowance_of(row: Any) -> Allowance:
    """Return what a student is given, from a row with the columns of a participation."""
    return Allowance(extra_time=timedelta(seconds=row.extra_seconds), extra_attempts=row.extra_attempts)


def links_of_course(store: Store, called: str) -> list[tuple[LinkSettings, tuple[str, ...]]]:
    """Return the links of courses by title, or of one by number, with the pseudonyms of who was there."""
    course = records.course
    named = course.c.title == called
    if called.isdecimal() and len(called) <= MOST_DIGITS:
        named = sa.or_(named, course.c.id == int(called))
    links = sa.select(_LINK).join(course, course.c.id == _LINK.c.course_id).where(named)
    people = sa.select(_PART.c.link_id, records.person.c.key).join(
        records.person, records.person.c.id == _PART.c.person_id
    )
    with store.reading() as connection:
        found = [link_of(row, row.id, row.title) for row in connection.execute(links.order_by(_LINK.c.id))]
        there = people.where(_PART.c.link_id.in_([link.id for link in found]))
        keys = [(row.link_id, row.key) for row in connection.execute(there.order_by(records.person.c.id))]
    return [(link.settings, tuple(key for own, key in keys if own == link.id)) for link in found]


def newest_links(store: Store, count: int) -> list[LinkSettings]:
    """Return what the newest links ask."""
    wanted = sa.select(_LINK.c.exercise_id, _LINK.c.settings).order_by(_LINK.c.id.desc()).limit(count)
    with store.reading() as connection:
        return [stored(row.exercise_id, row.settings) for row in connection.execute(wanted)]
