"""What a course has stored about one person: told to its staff, removed by them, and of no other course."""

from collections.abc import Callable
from typing import Any

import sqlalchemy as sa

from courses.storage import records
from courses.storage.database import Store
from tests.lti.classes import TEACHER, Browser, Lms, hint
from tests.lti.test_launches import CUSTOM, RIGHT, WRONG

RELATIONS = {"participation", "attempt", "grade", "score_to_send", "session", "access"}


def test_staff_see_and_remove_what_their_own_course_has_of_a_person(
    another_browser: Callable[[], Browser], lms: Lms, store: Store
) -> None:
    courses = [{"resource": f"people-{name}", "context": f"people-{name}", "custom": CUSTOM} for name in "ab"]
    student = [another_browser() for _ in courses]
    staff = [another_browser() for _ in courses]
    for where, sits, teaches, answer in zip(courses, student, staff, (RIGHT, WRONG), strict=True):
        sits.launch("ann", hint(**where))
        assert sits.api("POST", "session/attempts", answer).status_code == 200
        teaches.launch(f"tina-{where['resource']}", hint([TEACHER], **where))
    key = students(staff[0])[0]["key"]

    told = [teacher.api("GET", f"course/people/{key}").json() for teacher in staff]
    assert all(set(found) == {"person", "finding", "regraded", *RELATIONS} for found in told)
    assert [[one["correct"] for one in found["attempt"]] for found in told] == [[True], [False]]
    assert [[line["action"] for line in found["access"]] for found in told] == [["person"], ["person"]]

    short = f"course/people/{key[:8]}"  # what the page shows of it
    assert len(staff[0].api("GET", short).json()["attempt"]) == 1
    for unknown in (key[:7], "%", f"{key[:7]}_", "00000000"):
        assert staff[0].api("GET", f"course/people/{unknown}").status_code == 404

    removed = staff[0].api("DELETE", short)
    assert removed.status_code == 200
    assert removed.json()["removed"] == {**dict.fromkeys(RELATIONS, 1), "access": 2}
    assert students(staff[0]) == []
    assert staff[0].api("GET", f"course/people/{key}").status_code == 404
    assert student[0].api("GET", "session").status_code == 401
    assert student[1].api("GET", "session").status_code == 200
    assert students(staff[1])[0]["key"] == key
    assert len(staff[1].api("GET", f"course/people/{key}").json()["attempt"]) == 1

    assert staff[1].api("DELETE", f"course/people/{key}").json()["removed"]["attempt"] == 1
    assert student[1].api("GET", "session").status_code == 401
    student[1].launch("ann", hint(**courses[1]))
    assert student[1].api("GET", "session").json()["attempts"] == []


def test_what_a_member_of_staff_did_stays_in_the_log(
    another_browser: Callable[[], Browser], lms: Lms, store: Store
) -> None:
    where = {"resource": "people-c", "context": "people-c", "custom": CUSTOM}
    tina, theo = another_browser(), another_browser()
    tina.launch("tina", hint(**where))
    theo.launch("theo", hint([TEACHER], **where))
    key = students(theo)[0]["key"]
    tina.launch("tina", hint([TEACHER], **where))
    students(tina)
    tina.api("GET", f"course/people/{key}")
    removed = theo.api("DELETE", f"course/people/{key}").json()["removed"]
    assert (removed["access"], removed["session"]) == (1, 2)
    assert tina.api("GET", "course").status_code == 401
    did = sa.select(records.access.c.action).where(records.access.c.actor == key)
    with store.reading() as connection:
        assert list(connection.scalars(did)) == ["overview"]


def students(teacher: Browser) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = teacher.api("GET", "course").json()["students"]
    return found
