"""What a lecturer sees of a class: queries over stored attempts and their codes. Nothing is judged again."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from typing import Any

import sqlalchemy as sa

from courses.grades.judged import judged, of_students
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import of_student, record_of
from courses.teaching.attempts_behind import LISTED, STUCK_AFTER

_FINDING, _PART = records.finding, records.participation
_IS_MISTAKE = sa.or_(_FINDING.c.kind == "repair", _FINDING.c.kind.startswith("part:"))
CLUSTERS = 50  # Groups of alike answers that a page shows.


def class_overview(
    store: Store, course_id: int, members: Mapping[str, str | None] | None = None
) -> dict[str, Any]:
    """Return links of a course, its students, and how far each is: not begun, begun, stuck, or done.

    Where the platform tells who the members are, those who have opened nothing are listed, too.
    """
    link, person, grade = records.link, records.person, records.grade
    with store.reading() as connection:
        links = connection.execute(
            sa.select(link).where(link.c.course_id == course_id).order_by(link.c.id)
        ).all()
        ids = [row.id for row in links]
        tries = connection.execute(
            sa.select(
                _PART.c.link_id,
                person.c.key,
                person.c.name,
                _PART.c.began,
                _PART.c.made,
                _PART.c.extra_seconds,
                _PART.c.extra_attempts,
                grade.c.score,
            )
            .join(person, person.c.id == _PART.c.person_id)
            .outerjoin(grade, of_student(grade, _PART.c.link_id, _PART.c.person_id))
            .where(_PART.c.link_id.in_(ids), _PART.c.role == "learner")
            .order_by(person.c.key)
        ).all()
        solved = _solvers(connection, ids)
    students: dict[str, dict[str, Any]] = {
        key: {"key": key, "name": name, "links": {}} for key, name in (members or {}).items()
    }
    for row in tries:
        student = students.setdefault(row.key, {"key": row.key, "name": row.name, "links": {}})
        student["name"] = student["name"] or row.name
        student["links"][str(row.link_id)] = {
            "attempts": row.made,
            "score": row.score,
            "state": _state(row, is_solved=(row.link_id, row.key) in solved),
            "extra_seconds": row.extra_seconds,
            "extra_attempts": row.extra_attempts,
        }
    return {
        "links": [
            {
                "id": row.id,
                "title": row.title,
                "exercise": row.exercise_id,
                "released": row.released_at is not None,
                **_counts(row.id, students.values()),
            }
            for row in links
        ],
        "students": list(students.values()),
    }


def _solvers(connection: sa.Connection, link_ids: list[int]) -> set[tuple[int, str]]:
    own = judged(link_ids)
    found = connection.execute(
        sa.select(own.c.link_id, records.person.c.key)
        .join(records.person, records.person.c.id == own.c.person_id)
        .where(own.c.correct.is_(True))
        .distinct()
    )
    return {(row.link_id, row.key) for row in found}


def _state(row: Any, *, is_solved: bool) -> str:
    if is_solved:
        return "solved"
    if row.made:
        return "stuck" if row.made >= STUCK_AFTER else "begun"
    return "opened" if row.began else "absent"


def _counts(link_id: int, students: Iterable[dict[str, Any]]) -> dict[str, int]:
    states = Counter(student["links"].get(str(link_id), {}).get("state", "absent") for student in students)
    return {name: states.get(name, 0) for name in ("absent", "opened", "begun", "stuck", "solved")}


def link_statistics(store: Store, link_id: int) -> dict[str, Any]:
    """Return a link's statistics: success by day and at the first attempt, tries to success or drop-out."""
    own = judged((link_id,))
    wanted = (
        sa.select(own.c.person_id, own.c.number, own.c.at, own.c.correct, own.c.score)
        .where(of_students(own))
        .order_by(own.c.person_id, own.c.number)
    )
    with store.reading() as connection:
        rows = connection.execute(wanted).all()
    by_person: dict[int, list[Any]] = defaultdict(list)
    days: dict[str, list[int]] = defaultdict(lambda: [0, 0])
    for row in rows:
        by_person[row.person_id].append(row)
        day = days[row.at.date().isoformat()]
        day[0] += 1
        day[1] += row.correct
    first_right = sum(1 for tries in by_person.values() if tries[0].correct)
    return {
        "attempts": len(rows),
        "students": len(by_person),
        "solved": sum(1 for tries in by_person.values() if any(row.correct for row in tries)),
        "first_attempt_rate": first_right / len(by_person) if by_person else None,
        "mean_score": sum(row.score for row in rows) / len(rows) if rows else None,
        "days": [
            {"day": day, "attempts": made, "correct": right} for day, (made, right) in sorted(days.items())
        ],
        "sequence": _sequence(by_person.values()),
    }


def _sequence(people: Iterable[list[Any]]) -> list[dict[str, int]]:
    """For attempt 1, 2, …: who made it, who succeeded at it, and who gave up after it."""
    reached, solved, left = Counter[int](), Counter[int](), Counter[int]()
    for tries in people:
        success = next((row.number for row in tries if row.correct), None)
        last = success if success is not None else tries[-1].number
        reached.update(range(1, last + 1))
        if success is not None:
            solved[success] += 1
        else:
            left[last] += 1
    return [
        {"attempt": n, "reached": reached[n], "solved": solved[n], "dropped_out": left[n]}
        for n in sorted(reached)
    ]


def misconceptions(store: Store, link_id: int) -> list[dict[str, Any]]:
    """Return how often each mistake was found, most frequent first, with the newest attempt that has it."""
    own = judged((link_id,))
    attempts = sa.func.count(sa.distinct(own.c.id))
    students = sa.func.count(sa.distinct(own.c.person_id))
    wanted = (
        sa.select(
            _FINDING.c.kind,
            _FINDING.c.code,
            attempts.label("attempts"),
            students.label("students"),
            sa.func.max(own.c.id).label("newest"),
        )
        .join(own, own.c.id == _FINDING.c.attempt_id)
        .where(_FINDING.c.link_id == link_id, own.c.correct.is_(False), of_students(own), _IS_MISTAKE)
        .group_by(_FINDING.c.kind, _FINDING.c.code)
        .order_by(attempts.desc(), _FINDING.c.code)
    )
    with store.reading() as connection:
        return [record_of(row) for row in connection.execute(wanted)]


def unexplained(store: Store, link_id: int) -> list[dict[str, Any]]:
    """Return wrong answers that no misconception explains, clustered by what does not fit, largest first.

    What does not fit is a fact of a row (`2:length`) or a part (`:pose`). An answer that is right as far as
    it goes, with parts that were not handed in, has neither.
    """
    own = judged((link_id,))
    explained = sa.select(_FINDING.c.attempt_id).where(_FINDING.c.link_id == link_id, _IS_MISTAKE)
    wanted = (
        sa.select(own.c.id, _FINDING.c.code, _FINDING.c.row)
        .join(_FINDING, sa.and_(_FINDING.c.attempt_id == own.c.id, _FINDING.c.kind == "wrong"))
        .where(own.c.correct.is_(False), of_students(own), own.c.id.not_in(explained))
        .order_by(own.c.id, _FINDING.c.position)
    )
    facts: dict[int, list[str]] = defaultdict(list)
    with store.reading() as connection:
        for row in connection.execute(wanted):
            facts[row.id].append(f"{row.row or ''}:{row.code}")
    clusters: dict[tuple[str, ...], list[int]] = defaultdict(list)
    for attempt_id, found in facts.items():
        clusters[tuple(found)].append(attempt_id)
    largest = sorted(clusters.items(), key=lambda item: (-len(item[1]), item[0]))[:CLUSTERS]
    return [{"facts": list(found), "attempts": ids} for found, ids in largest]


def undelivered(store: Store, course_id: int) -> list[dict[str, Any]]:
    """Return scores of a course that could not be delivered, or wait for another try, with the reason."""
    outbox, person, link = records.score_to_send, records.person, records.link
    wanted = (
        sa.select(
            link.c.id.label("link"),
            link.c.title,
            person.c.key,
            person.c.name,
            outbox.c.score,
            outbox.c.problem,
            outbox.c.dead,
            outbox.c.tries,
        )
        .join(person, person.c.id == outbox.c.person_id)
        .join(link, link.c.id == outbox.c.link_id)
        .where(link.c.course_id == course_id, outbox.c.problem.is_not(None))
        .order_by(outbox.c.dead.desc(), link.c.id, person.c.key)
        .limit(LISTED)
    )
    with store.reading() as connection:
        return [record_of(row) for row in connection.execute(wanted)]
