"""Attempts: taken if the policy allows one, stored before they are answered, and never changed."""

from collections.abc import Mapping, Sequence
from dataclasses import fields
from datetime import datetime, timedelta
from typing import Any, TypeAlias

import sqlalchemy as sa

from courses.model import Attempt, CourseSession, Draft, ListedAttempt, StudentStanding
from courses.policies import Counted, Shown, disclosed, refusal
from courses.refusals import AttemptError, unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import of_student

_TABLE = records.attempt
LISTED = 50  # Attempts that are listed: as many as a browser keeps of exercises outside of courses.


def check_open(session: CourseSession, now: datetime) -> None:
    """Make sure that another attempt is taken.

    Raises:
        AttemptError: the policy takes none.
    """
    fault = refusal(session.link.settings.policy, session.made, session.allowance, now)
    if fault:
        raise AttemptError(fault)


def shown_now(session: CourseSession, made: int, now: datetime) -> Shown:
    """Return how much of a student's judgements may be shown now."""
    return disclosed(
        session.link.settings.policy,
        made,
        now,
        released=session.link.released_at is not None,
        longest=timedelta(seconds=session.longest),
    )


def by_key(store: Store, session: CourseSession, key: str) -> Attempt | None:
    """Return the attempt that was stored with an idempotency key, or None."""
    return _attempt(store, session, _TABLE.c.key == key)


def attempt_numbered(store: Store, session: CourseSession, number: int) -> Attempt:
    """Return one attempt of whoever is signed in.

    Raises:
        UnknownRecordError: there is no such attempt.
    """
    found = _attempt(store, session, _TABLE.c.number == number)
    if found is None:
        raise unknown_record("attempt")
    return found


def _attempt(store: Store, session: CourseSession, which: sa.ColumnElement[bool]) -> Attempt | None:
    own = of_student(_TABLE, session.link.id, session.person.id)
    with store.reading() as connection:
        row = connection.execute(sa.select(_TABLE).where(own, which)).first()
    return None if row is None else attempt_of(row)


def standing_of(store: Store, session: CourseSession) -> StudentStanding:
    """Return how far a student is.

    Of many attempts the latest are listed, so that it costs the same after all.
    """
    own = session.link.id, session.person.id
    latest = _LISTED.where(of_student(_TABLE, *own)).order_by(_TABLE.c.number.desc()).limit(LISTED)
    graded = _GRADED.where(of_student(records.grade, *own))
    drafted = _DRAFTED.where(of_student(records.participation, *own))
    with store.reading() as connection:
        rows = connection.execute(latest).all() if session.made else []
        grade = connection.execute(graded).first() if session.made else None
        draft = connection.execute(drafted).first() if session.has_draft else None
    return StudentStanding(
        latest=tuple(ListedAttempt(**row._mapping) for row in reversed(rows)),
        grade=None if grade is None else Counted(number=grade.number, worth=grade.score),
        draft=None if draft is None or draft.draft is None else Draft(state=draft.draft, at=draft.draft_at),
    )


_LISTED = sa.select(*(_TABLE.c[field.name] for field in fields(ListedAttempt)))
_GRADED = sa.select(records.grade.c.number, records.grade.c.score)
_DRAFTED = sa.select(records.participation.c.draft, records.participation.c.draft_at)


def attempt_in(store: Store, course_id: int, attempt_id: int) -> tuple[Attempt, str]:
    """Return an attempt of a course by its id, and the key of its student.

    Raises:
        UnknownRecordError: the course has no such attempt.
    """
    wanted = (
        sa.select(_TABLE, records.person.c.key.label("person_key"))
        .join(records.link, records.link.c.id == _TABLE.c.link_id)
        .join(records.person, records.person.c.id == _TABLE.c.person_id)
        .where(_TABLE.c.id == attempt_id, records.link.c.course_id == course_id)
    )
    with store.reading() as connection:
        row = connection.execute(wanted).first()
    if row is None:
        raise unknown_record("attempt")
    return attempt_of(row), row.person_key


def reports_of(store: Store, attempt_ids: list[int]) -> dict[int, Any]:
    """Return reports of attempts by their ids."""
    with store.reading() as connection:
        found = connection.execute(
            sa.select(_TABLE.c.id, _TABLE.c.report).where(_TABLE.c.id.in_(attempt_ids))
        )
        return {row.id: row.report for row in found}


def attempt_of(row: Any) -> Attempt:
    """Return a row of the relation as a record."""
    return Attempt(**{name: getattr(row, name) for name in _NAMES})


_NAMES = tuple(column.name for column in _TABLE.columns)


Typed: TypeAlias = tuple[CourseSession, Mapping[str, Any] | None]
"""Who has typed something, and what; None to forget it."""


def keep_drafts(store: Store, typed: Sequence[Typed], now: datetime) -> list[None]:
    """Keep what people have typed, in one transaction; of the same person the last one stays.

    Their rows are locked in the same order as by those who hand in.
    """
    own = of_student(records.participation, sa.bindparam("link"), sa.bindparam("person"))
    values = {"draft": sa.bindparam("state"), "draft_at": now}
    last = {(session.link.id, session.person.id): state for session, state in typed}
    rows = [
        {"link": link, "person": person, "state": None if state is None else dict(state)}
        for (link, person), state in sorted(last.items(), key=lambda item: item[0])
    ]
    with store.writing() as connection:
        connection.execute(sa.update(records.participation).where(own).values(values), rows)
    return [None] * len(typed)
