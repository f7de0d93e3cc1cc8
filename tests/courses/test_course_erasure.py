"""A course that has ended is removed with all that it stored, and no other course loses anything."""

from dataclasses import astuple

import pytest
import sqlalchemy as sa

from courses.grades.outbox import delivered, lease_scores
from courses.model import Role
from courses.people.audit import log_access
from courses.people.enrolment import preview
from courses.people.sessions import session_of
from courses.refusals import CourseError, UnknownRecordError
from courses.storage import records
from courses.storage.database import Store
from courses.teaching.course_erasure import OPERATOR, erase_course, held_courses
from tests.courses.classroom import NOW, joined, submitted

OTHER = {"context": "course-2", "resource": "link-2"}


def fill(store: Store) -> None:
    """Two courses, each with an unsent score: Ann is in both, Bob in the first, Tina teaches it."""
    for subject, where in (("ann", {}), ("bob", {}), ("ann", OTHER)):
        session = joined(store, subject, **where)
        if where or subject == "ann":
            submitted(store, session, 0.5)
    tina = joined(store, "tina", role=Role.STAFF, course_title="Robotics 1")
    log_access(store, tina, "person", NOW, subject=session.person.key)
    log_access(store, tina, "overview", NOW)
    submitted(store, session_of(store, preview(store, tina, tina.link.id, NOW), NOW), 1.0)


def rows(store: Store) -> dict[str, int]:
    with store.reading() as connection:
        return {
            table.name: connection.scalar(sa.select(sa.func.count()).select_from(table)) or 0
            for table in records.metadata.sorted_tables
        }


def test_a_course_is_removed_with_its_people_and_no_other_one(store: Store) -> None:
    """Only a whole platform could be forgotten, or one person after another."""
    fill(store)
    first, second = held_courses(store)
    assert astuple(first)[2:] == ("Robotics 1", 1, 4, 2, 1)
    assert astuple(second)[2:] == ("", 1, 1, 1, 1)

    removed = erase_course(store, first.id, NOW, with_unsent=True)
    once, twice = ("score_to_send", "access", "link"), ("attempt", "grade")
    for_all = ("participation", "session")
    assert removed == dict.fromkeys(once, 1) | dict.fromkeys(twice, 2) | dict.fromkeys(for_all, 4)
    assert held_courses(store) == [second]
    left = rows(store)
    names = ("course", "link", "person", "participation", "attempt", "grade", "score_to_send", "session")
    assert [left[name] for name in names] == [1] * len(names)


def test_what_staff_did_and_the_erasure_stay_in_the_log(store: Store) -> None:
    fill(store)
    course = held_courses(store)[0].id
    erase_course(store, course, NOW, with_unsent=True)
    log = records.access.c
    with store.reading() as connection:
        lines = connection.execute(sa.select(log.actor, log.action, log.subject, log.details)).all()
    assert [(line.action, line.subject) for line in lines] == [("overview", None), ("course erased", None)]
    assert lines[1].actor == OPERATOR
    assert (lines[1].details["course"], lines[1].details["attempt"]) == (course, 2)


def test_scores_that_the_gradebook_has_not_received_are_not_lost_unasked(store: Store) -> None:
    fill(store)
    before, course = rows(store), held_courses(store)[0].id
    with pytest.raises(CourseError) as refused:
        erase_course(store, course, NOW)
    assert [(fault.code, fault.params) for fault in refused.value.faults] == [("scores_unsent", {"count": 1})]
    assert rows(store) == before
    for score in lease_scores(store, NOW):
        delivered(store, score, NOW)
    assert erase_course(store, course, NOW)["score_to_send"] == 1


def test_who_comes_again_finds_a_new_course(store: Store) -> None:
    session = joined(store)
    erase_course(store, session.course.id, NOW)
    with pytest.raises(UnknownRecordError):
        erase_course(store, session.course.id, NOW)
    assert joined(store).made == 0
    assert [course.people for course in held_courses(store)] == [1]
