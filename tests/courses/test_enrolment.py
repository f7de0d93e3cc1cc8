"""Courses and links as launches make them: who belongs together, and who does not."""

import sqlalchemy as sa

from courses.model import Role
from courses.storage import records
from courses.storage.database import Store
from courses.teaching.statistics import class_overview
from tests.courses.classroom import NOW, joined, platform

NAMELESS = {"context": "", "course_title": ""}


def test_staff_of_a_link_without_a_context_sees_that_link_alone(store: Store) -> None:
    """All such links of a deployment were one course: its staff saw the students of everybody else."""
    own = joined(store, "tina", role=Role.STAFF, resource="one", **NAMELESS)
    again = joined(store, "ann", resource="one", **NAMELESS)
    other = joined(store, "bob", resource="two", **NAMELESS)
    assert again.link == own.link
    assert other.course.id != own.course.id
    found = class_overview(store, own.course.id, None)
    assert [link["id"] for link in found["links"]] == [own.link.id]
    assert [student["key"] for student in found["students"]] == [again.person.key]


def test_a_link_that_was_stored_without_a_context_stays_where_it_is(store: Store) -> None:
    """An earlier version has stored it in the course that such links shared."""
    shared = {"platform_id": platform(store).id, "deployment": "1", "context": "", "title": ""}
    with store.writing() as connection:
        course = connection.scalar(sa.insert(records.course).values(shared).returning(records.course.c.id))
        stored = {"course_id": course, "resource": "old", "title": "", "settings": {}}
        link = connection.scalar(sa.insert(records.link).values(stored).returning(records.link.c.id))
    old, new = (joined(store, resource=name, at=NOW, **NAMELESS) for name in ("old", "new"))
    assert (old.course.id, old.link.id) == (course, link)
    assert new.course.id != course
