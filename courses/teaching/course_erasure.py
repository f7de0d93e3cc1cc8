"""Courses that have ended: what each of them holds, and its erasure."""

from collections import Counter
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime

import sqlalchemy as sa

from courses.people.privacy import erase_person
from courses.refusals import CourseError, UnknownRecordError, unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import filled
from kinematics.errors import Fault

_COURSE, _LINK, _PART = records.course, records.link, records.participation
_OUTBOX = records.score_to_send
OPERATOR = "operator"  # Whoever runs a command, in the audit log: nobody is signed in.


@dataclass(frozen=True, kw_only=True, slots=True)
class HeldCourse:
    """What is stored of a course.

    Attributes:
        platform_id: the platform that it is a course of.
        links: how many links it has; likewise people and attempts, those of staff included.
        unsent: how many scores the gradebook has not received: they wait, are withheld, or were refused.
    """

    id: int
    platform_id: int
    title: str
    links: int
    people: int
    attempts: int
    unsent: int


def held_courses(store: Store, course_id: int | None = None) -> list[HeldCourse]:
    """Return every course, in the order in which they were first opened; with an id, that one alone."""
    links = sa.select(sa.func.count()).where(_LINK.c.course_id == _COURSE.c.id).correlate(_COURSE)
    wanted = sa.select(
        _COURSE.c.id,
        _COURSE.c.platform_id,
        _COURSE.c.title,
        links.scalar_subquery().label("links"),
        _of(_PART, sa.func.count(_PART.c.person_id.distinct())).label("people"),
        _of(records.attempt, sa.func.count()).label("attempts"),
        _of(_OUTBOX, sa.func.count().filter(_OUTBOX.c.revision > _OUTBOX.c.sent_revision)).label("unsent"),
    ).order_by(_COURSE.c.id)
    if course_id is not None:
        wanted = wanted.where(_COURSE.c.id == course_id)
    with store.reading() as connection:
        return [filled(HeldCourse, row) for row in connection.execute(wanted)]


def _of(table: sa.Table, count: sa.ColumnElement[int]) -> sa.ScalarSelect[int]:
    """Return a count over the rows of a relation that belong to a course."""
    own = sa.select(count).select_from(table).join(_LINK, _LINK.c.id == table.c.link_id)
    return own.where(_LINK.c.course_id == _COURSE.c.id).correlate(_COURSE).scalar_subquery()


def erase_course(store: Store, course_id: int, now: datetime, *, with_unsent: bool = False) -> dict[str, int]:
    """Remove a course with all that it has stored, and people of whom nothing is left elsewhere.

    Person by person, each as by `erase_person`; what was interrupted is completed by another call. In the
    audit log stays what staff did, and how much was removed.

    Returns:
        How many rows of each relation were removed.

    Raises:
        UnknownRecordError: there is no such course.
        CourseError: its gradebook has not received all scores, and they are not to be lost.
    """
    course = next(iter(held_courses(store, course_id)), None)
    if course is None:
        raise unknown_record("course")
    if course.unsent and not with_unsent:
        raise CourseError(Fault.at("scores_unsent", count=course.unsent))
    removed: Counter[str] = Counter()
    for key in _people(store, course_id):
        with suppress(UnknownRecordError):  # removed with somebody whose preview they were
            removed.update(erase_person(store, key, course_id))
    removed["link"] = course.links
    line = {"at": now, "actor": OPERATOR, "action": "course erased"}
    with store.writing() as connection:
        connection.execute(sa.delete(_COURSE).where(_COURSE.c.id == course_id))
        details = {"course": course_id, **removed}
        connection.execute(sa.insert(records.access).values(**line, details=details))
    return dict(removed)


def _people(store: Store, course_id: int) -> list[str]:
    """Return the keys of all who have taken part in a course."""
    person = records.person
    wanted = (
        sa.select(person.c.key)
        .join(_PART, _PART.c.person_id == person.c.id)
        .join(_LINK, _LINK.c.id == _PART.c.link_id)
        .where(_LINK.c.course_id == course_id)
        .distinct()
    )
    with store.reading() as connection:
        return list(connection.scalars(wanted))
